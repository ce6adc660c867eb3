//! Autoregressive noise.
//!
//! # Purpose
//! A model of coloured noise that whitens (innovations), colours, and gives the covariance that
//! correct standard errors need.
//!
//! # Method
//! Burg's lattice over all contiguous stretches at once, so that gaps cost nothing; order by the
//! corrected information criterion. The first samples of a stretch are whitened by the lower orders
//! of the lattice, which makes the whitening exact: L⁻¹ of the covariance L Lᵀ of the stretch.
//!
//! # References
//! J. P. Burg, Maximum entropy spectral analysis, thesis, Stanford 1975; P. J. Brockwell,
//! R. A. Davis, Time Series: Theory and Methods, 2nd ed. 1991, §5.2, §8.2 (prediction by
//! Levinson's recursion), §9.3 (AICC).
//!
//! # Numerical aspects
//! Reflection coefficients of magnitude below one by construction: the model is stable.

/// An autoregressive model y_t = Σ a_k y_(t−k) + σ e_t with all lower orders kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Autoregression {
    /// a_1 … a_k for every order k = 0 … p.
    predictors: Vec<Vec<f64>>,
    /// Prediction-error variance for every order k = 0 … p.
    variances: Vec<f64>,
    samples: usize,
}

impl Autoregression {
    /// White noise of a given variance.
    pub fn white(variance: f64) -> Self {
        Self { predictors: vec![Vec::new()], variances: vec![variance], samples: 0 }
    }

    /// The model from known coefficients a_1 … a_p and innovation variance σ² (its lower orders by the
    /// backward Levinson recursion). None if the coefficients are not stable.
    ///
    /// ```
    /// use gyrospec::estimate::noise::Autoregression;
    /// let ar = Autoregression::from_coefficients(&[0.9], 0.19).unwrap();
    /// assert!((ar.variance() - 1.0).abs() < 1e-12);
    /// ```
    pub fn from_coefficients(coefficients: &[f64], innovation_variance: f64) -> Option<Self> {
        let p = coefficients.len();
        let mut predictors = vec![coefficients.to_vec()];
        let mut variances = vec![innovation_variance];
        for order in (1..=p).rev() {
            let a = predictors.last()?.clone();
            let k = a[order - 1];
            if k.abs() >= 1.0 {
                return None;
            }
            // a_j^(p−1) = (a_j + k a_(p−j)) / (1 − k²)
            let lower = (0..order - 1).map(|j| (a[j] + k * a[order - 2 - j]) / (1.0 - k * k)).collect();
            variances.push(variances.last()? / (1.0 - k * k));
            predictors.push(lower);
        }
        predictors.reverse();
        variances.reverse();
        Some(Self { predictors, variances, samples: 0 })
    }

    /// Fits the order in 0 … `max_order` that the corrected information criterion prefers.
    ///
    /// The stretches are contiguous, evenly sampled and free of gaps; the mean is taken as zero.
    pub fn fit(stretches: &[&[f64]], max_order: usize) -> Self {
        let full = Self::burg(stretches, max_order);
        let n = full.samples as f64;
        // AICC(k) = N ln σ_k² + 2 (k + 1) N / (N − k − 2)
        let criterion = |k: usize| {
            let spare = n - k as f64 - 2.0;
            let fit = n * full.variances[k].max(f64::MIN_POSITIVE).ln();
            if spare > 0.0 { fit + 2.0 * (k as f64 + 1.0) * n / spare } else { f64::INFINITY }
        };
        let best =
            (0..full.variances.len()).min_by(|a, b| criterion(*a).total_cmp(&criterion(*b))).unwrap_or(0);
        full.truncated(best)
    }

    /// Burg's estimate of all orders up to `max_order` (fewer where the data are too short or run out).
    pub fn burg(stretches: &[&[f64]], max_order: usize) -> Self {
        let samples: usize = stretches.iter().map(|s| s.len()).sum();
        let energy: f64 = stretches.iter().flat_map(|s| s.iter()).map(|y| y * y).sum();
        let mut model = Self::white(energy / samples.max(1) as f64);
        model.samples = samples;
        let mut forward: Vec<Vec<f64>> = stretches.iter().map(|s| s.to_vec()).collect();
        let mut backward = forward.clone();
        for order in 1..=max_order {
            let Some(k) = reflection(&forward, &backward, order) else { break };
            lattice_step(&mut forward, &mut backward, order, k);
            model.extend(k);
        }
        model
    }

    fn extend(&mut self, k: f64) {
        let last = &self.predictors[self.predictors.len() - 1];
        let n = last.len();
        // a_j^(p+1) = a_j − k a_(p+1−j),  a_(p+1) = k
        let mut next: Vec<f64> = (0..n).map(|j| last[j] - k * last[n - 1 - j]).collect();
        next.push(k);
        self.variances.push(self.variances[n] * (1.0 - k * k));
        self.predictors.push(next);
    }

    /// The same model cut to a lower order.
    #[must_use]
    pub fn truncated(&self, order: usize) -> Self {
        let keep = order.min(self.order()) + 1;
        Self {
            predictors: self.predictors[..keep].to_vec(),
            variances: self.variances[..keep].to_vec(),
            samples: self.samples,
        }
    }

    /// The order p.
    pub fn order(&self) -> usize {
        self.predictors.len() - 1
    }

    /// a_1 … a_p.
    pub fn coefficients(&self) -> &[f64] {
        &self.predictors[self.order()]
    }

    /// σ², the variance of the innovations.
    pub fn innovation_variance(&self) -> f64 {
        self.variances[self.order()]
    }

    /// The variance of the noise itself.
    pub fn variance(&self) -> f64 {
        self.variances[0]
    }

    /// How many samples it was estimated from.
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// The same correlation at another level: every variance times `factor`.
    #[must_use]
    pub fn rescaled(mut self, factor: f64) -> Self {
        for variance in &mut self.variances {
            *variance *= factor;
        }
        self
    }

    /// Spectral density at `frequency` in cycles a sample, variance per cycle a sample, two-sided.
    pub fn density(&self, frequency: f64) -> f64 {
        let (mut re, mut im) = (1.0, 0.0);
        for (k, a) in self.coefficients().iter().enumerate() {
            let phase = std::f64::consts::TAU * frequency * (k as f64 + 1.0);
            re -= a * phase.cos();
            im += a * phase.sin();
        }
        self.innovation_variance() / (re * re + im * im)
    }

    /// Unit-variance innovations of one contiguous stretch: L⁻¹ y.
    pub fn whiten(&self, stretch: &[f64]) -> Vec<f64> {
        let p = self.order();
        (0..stretch.len())
            .map(|t| {
                let k = t.min(p);
                let predicted: f64 =
                    self.predictors[k].iter().enumerate().map(|(j, a)| a * stretch[t - 1 - j]).sum();
                (stretch[t] - predicted) / self.variances[k].sqrt()
            })
            .collect()
    }

    /// L⁻ᵀ e, the adjoint of [`Autoregression::whiten`].
    pub fn whiten_adjoint(&self, innovations: &[f64]) -> Vec<f64> {
        let p = self.order();
        let mut out = vec![0.0; innovations.len()];
        for (t, e) in innovations.iter().enumerate() {
            let k = t.min(p);
            let e = e / self.variances[k].sqrt();
            out[t] += e;
            for (j, a) in self.predictors[k].iter().enumerate() {
                out[t - 1 - j] -= a * e;
            }
        }
        out
    }

    /// Coloured noise from unit-variance innovations: L e.
    pub fn colour(&self, innovations: &[f64]) -> Vec<f64> {
        let p = self.order();
        let mut y: Vec<f64> = Vec::with_capacity(innovations.len());
        for (t, e) in innovations.iter().enumerate() {
            let k = t.min(p);
            let predicted: f64 = self.predictors[k].iter().enumerate().map(|(j, a)| a * y[t - 1 - j]).sum();
            y.push(predicted + e * self.variances[k].sqrt());
        }
        y
    }

    /// Lᵀ v, the adjoint of [`Autoregression::colour`]: ‖Lᵀ v‖² is the variance of v·noise.
    pub fn colour_adjoint(&self, v: &[f64]) -> Vec<f64> {
        let p = self.order();
        let mut rest = v.to_vec();
        // W u' = …: solve Wᵀ u = v backwards, W the whitening matrix.
        for t in (0..v.len()).rev() {
            let k = t.min(p);
            let deviation = self.variances[k].sqrt();
            let seen = rest[t];
            for (j, a) in self.predictors[k].iter().enumerate() {
                rest[t - 1 - j] += a * seen;
            }
            rest[t] = seen * deviation;
        }
        rest
    }
}

/// k = 2 Σ f_t b_(t−1) / Σ (f_t² + b_(t−1)²)
fn reflection(forward: &[Vec<f64>], backward: &[Vec<f64>], order: usize) -> Option<f64> {
    let (mut cross, mut energy, mut pairs) = (0.0, 0.0, 0_usize);
    for (f, b) in forward.iter().zip(backward) {
        for t in order..f.len() {
            cross += f[t] * b[t - 1];
            energy += f[t] * f[t] + b[t - 1] * b[t - 1];
            pairs += 1;
        }
    }
    (pairs > order && energy > 0.0).then(|| (2.0 * cross / energy).clamp(-1.0 + 1e-12, 1.0 - 1e-12))
}

fn lattice_step(forward: &mut [Vec<f64>], backward: &mut [Vec<f64>], order: usize, k: f64) {
    for (f, b) in forward.iter_mut().zip(backward) {
        for t in (order..f.len()).rev() {
            let (ft, bt) = (f[t], b[t - 1]);
            f[t] = ft - k * bt;
            b[t] = bt - k * ft;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    fn normal(n: usize, seed: u64) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        (0..n).map(|_| StandardNormal.sample(&mut rng)).collect()
    }

    #[test]
    fn burg_finds_the_coefficients_across_gaps() {
        let truth = Autoregression::from_coefficients(&[1.4, -0.6], 0.3).unwrap();
        let stretches: Vec<Vec<f64>> = (0..8).map(|s| truth.colour(&normal(2000, s))).collect();
        let views: Vec<&[f64]> = stretches.iter().map(Vec::as_slice).collect();
        let found = Autoregression::fit(&views, 8);
        assert!((2..=5).contains(&found.order()));
        let two = found.truncated(2);
        assert!((two.coefficients()[0] - 1.4).abs() < 0.03 && (two.coefficients()[1] + 0.6).abs() < 0.03);
        assert!((two.innovation_variance() - 0.3).abs() < 0.02);
    }

    #[test]
    fn whitening_undoes_colouring_and_the_adjoint_is_one() {
        let ar = Autoregression::from_coefficients(&[0.5, 0.2, -0.3], 2.0).unwrap();
        let (e, v) = (normal(50, 1), normal(50, 2));
        let y = ar.colour(&e);
        for (a, b) in ar.whiten(&y).iter().zip(&e) {
            assert!((a - b).abs() < 1e-12);
        }
        // v·(L e) = (Lᵀ v)·e
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        assert!((dot(&v, &y) - dot(&ar.colour_adjoint(&v), &e)).abs() < 1e-10);
    }

    #[test]
    fn the_adjoint_gives_the_known_covariance_of_an_ar1_mean() {
        // Var Σ y_t for AR(1): Σ_ij φ^|i−j| / (1 − φ²)
        let (phi, n) = (0.9_f64, 40);
        let ar = Autoregression::from_coefficients(&[phi], 1.0).unwrap();
        let ours: f64 = ar.colour_adjoint(&vec![1.0; n]).iter().map(|u| u * u).sum();
        let mut direct = 0.0;
        for i in 0..n as i32 {
            for j in 0..n as i32 {
                direct += phi.powi((i - j).abs()) / (1.0 - phi * phi);
            }
        }
        assert!((ours / direct - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_density_integrates_to_the_variance() {
        let ar = Autoregression::from_coefficients(&[0.8, -0.2], 1.5).unwrap();
        let n = 4000;
        let mean: f64 = (0..n).map(|i| ar.density((f64::from(i) + 0.5) / f64::from(n))).sum::<f64>();
        assert!((mean / f64::from(n) / ar.variance() - 1.0).abs() < 1e-9);
    }
}
