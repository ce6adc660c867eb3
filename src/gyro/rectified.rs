//! # Purpose
//! Mean, covariance and spectrum of slow states that products of fast Gaussian signals push:
//! the one mechanism behind every rolling error.
//!
//! # Method
//! Fast: dz = A z dt + B dW. Slow: dy = (A_s y + k) dt + Σ linear + Σ g·(left)∘(right) dt.
//! The pairs v = zᵢzⱼ − Σᵢⱼ obey a linear equation themselves, v̇ = (A ⊕ A) v + noise, and by
//! Isserlis' theorem all second moments of v and of that noise are products of those of z. So
//! the covariance and the spectrum of y follow exactly from a linear system of twice the kind:
//! A_s Y + Y A_sᵀ + G M + MᵀGᵀ + Q_yy = 0,  (A ⊕ A) M + M A_sᵀ + C_v Gᵀ + Q_vy = 0.
//! Linear and quadratic pushes are uncorrelated, since odd moments of Gaussian signals vanish.
//!
//! # References
//! L. Isserlis, Biometrika 12 (1918) 134–139; R. L. Stratonovich, SIAM J. Control 4 (1966)
//! 362–371 for products with a white part.
//!
//! # Numerical aspects
//! Where one signal of a product holds white noise the product is taken as the mean of both
//! sides (Stratonovich); where both do, its mean is infinite and is refused. The system for M
//! has k·n(n+1)/2 unknowns and is solved by elimination; its residual is checked.

use super::LinearSignal;
use crate::lti::stationary_covariance;
use crate::{Error, ErrorKind, Result};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

/// A push in proportion to one fast signal.
#[derive(Debug, Clone)]
pub struct LinearPush {
    /// The slow state whose rate it changes.
    pub row: usize,
    /// Rate a unit of the signal.
    pub gain: f64,
    /// The fast signal.
    pub signal: LinearSignal,
}

/// A push in proportion to the product of two fast signals.
#[derive(Debug, Clone)]
pub struct ProductPush {
    /// The slow state whose rate it changes.
    pub row: usize,
    /// Rate a unit of the product.
    pub gain: f64,
    /// One signal; the only one that may hold white noise.
    pub left: LinearSignal,
    /// The other.
    pub right: LinearSignal,
}

/// Fast Gaussian states z (n of them, m white noises) that push slow states y (k of them).
#[derive(Debug, Clone)]
pub struct SlowFast {
    /// A, n × n.
    pub fast: Mat<f64>,
    /// B, n × m.
    pub noise: Mat<f64>,
    /// A_s, k × k.
    pub slow: Mat<f64>,
    /// k, the constant rates.
    pub constant: Vec<f64>,
    /// Pushes by one signal.
    pub linear: Vec<LinearPush>,
    /// Pushes by two.
    pub products: Vec<ProductPush>,
}

/// Stationary mean and covariance of the slow states.
#[derive(Debug, Clone)]
pub struct Moments {
    /// Mean by the constant rates alone.
    pub steady: Vec<f64>,
    /// Mean that the products add.
    pub rectified: Vec<f64>,
    /// Covariance by the linear pushes, k × k.
    pub linear: Mat<f64>,
    /// Covariance by the products, k × k.
    pub quadratic: Mat<f64>,
}

/// What the pairs of fast states need: Σ, G, and the noise of y by products.
struct Lifted {
    sigma: Mat<f64>,
    pairs: Vec<(usize, usize)>,
    g: Mat<f64>,
    q_yy: Mat<f64>,
    q_vy: Mat<f64>,
}

impl SlowFast {
    /// Mean and covariance of y.
    ///
    /// # Errors
    /// `OutOfRange` when both signals of a product hold white noise; `Unstable`,
    /// `ImaginaryAxis` or `NotComputed` as the covariances say.
    pub fn moments(&self) -> Result<Moments> {
        let lifted = self.lift()?;
        let steady = self.resting(&self.constant);
        let rectified = self.resting(&self.mean_pushes(&lifted.sigma));
        let linear = self.linear_covariance()?;
        let quadratic = self.quadratic_covariance(&lifted)?;
        Ok(Moments { steady, rectified, linear, quadratic })
    }

    /// The mean of y that the products add, alone; much cheaper than all moments.
    ///
    /// # Errors
    /// As [`SlowFast::moments`].
    pub fn rectified_mean(&self) -> Result<Vec<f64>> {
        self.check_white()?;
        let q = &self.noise * self.noise.transpose();
        Ok(self.resting(&self.mean_pushes(&stationary_covariance(&self.fast, &q)?.matrix)))
    }

    /// Two-sided density of slow state `row` at ω (rad/s): linear and quadratic part.
    ///
    /// # Errors
    /// As [`SlowFast::moments`].
    pub fn densities(&self, row: usize, omega: &[f64]) -> Result<Vec<(f64, f64)>> {
        let lifted = self.lift()?;
        let (n, k, m) = (self.fast.nrows(), self.slow.nrows(), lifted.pairs.len());
        let (fl, ql) = self.linear_system();
        let drift = lifted_drift(&self.fast, &lifted.pairs);
        let fq = Mat::from_fn(k + m, k + m, |i, j| match (i < k, j < k) {
            (true, true) => self.slow[(i, j)],
            (true, false) => lifted.g[(i, j - k)],
            (false, true) => 0.0,
            (false, false) => drift[(i - k, j - k)],
        });
        let q = &self.noise * self.noise.transpose();
        let qq = Mat::from_fn(k + m, k + m, |i, j| match (i < k, j < k) {
            (true, true) => lifted.q_yy[(i, j)],
            (true, false) => lifted.q_vy[(j - k, i)],
            (false, true) => lifted.q_vy[(i - k, j)],
            (false, false) => pair_noise(&q, &lifted.sigma, lifted.pairs[i - k], lifted.pairs[j - k]),
        });
        debug_assert_eq!(fl.nrows(), n + k);
        Ok(omega.iter().map(|w| (density(&fl, &ql, row, *w), density(&fq, &qq, row, *w))).collect())
    }

    /// −A_s⁻¹ u.
    pub(super) fn resting(&self, u: &[f64]) -> Vec<f64> {
        let right = Mat::from_fn(u.len(), 1, |i, _| -u[i]);
        let y = self.slow.partial_piv_lu().solve(&right);
        (0..u.len()).map(|i| y[(i, 0)]).collect()
    }

    fn check_white(&self) -> Result<()> {
        if self.products.iter().any(|p| p.right.is_white()) {
            return Err(Error::new(
                ErrorKind::OutOfRange,
                "both signals of a product hold white noise, so its mean is infinite",
            )
            .with_hint("limit the band of the motion"));
        }
        Ok(())
    }

    /// g(c₁ Σ c₂ᵀ + ½ c₂ B d₁ᵀ), summed by rows.
    fn mean_pushes(&self, sigma: &Mat<f64>) -> Vec<f64> {
        let mut out = vec![0.0; self.slow.nrows()];
        for p in &self.products {
            let sides = 0.5 * dot(&p.right.state, &times(&self.noise, &p.left.noise));
            out[p.row] += p.gain * (dot(&p.left.state, &times(sigma, &p.right.state)) + sides);
        }
        out
    }

    fn lift(&self) -> Result<Lifted> {
        self.check_white()?;
        let (n, k) = (self.fast.nrows(), self.slow.nrows());
        let q = &self.noise * self.noise.transpose();
        let sigma = stationary_covariance(&self.fast, &q)?.matrix;
        let pairs: Vec<(usize, usize)> = (0..n).flat_map(|i| (i..n).map(move |j| (i, j))).collect();
        let mut g = Mat::zeros(k, pairs.len());
        let (mut q_yy, mut q_vy) = (Mat::zeros(k, k), Mat::zeros(pairs.len(), k));
        for p in &self.products {
            let (c1, c2) = (&p.left.state, &p.right.state);
            let spread = times(&sigma, c2);
            let kick = times(&self.noise, &p.left.noise);
            for (at, &(i, j)) in pairs.iter().enumerate() {
                let both = if i == j { c1[i] * c2[i] } else { c1[i] * c2[j] + c1[j] * c2[i] };
                g[(p.row, at)] += p.gain * both;
                q_vy[(at, p.row)] += p.gain * (kick[i] * spread[j] + spread[i] * kick[j]);
            }
            for o in &self.products {
                let white = dot(&p.left.noise, &o.left.noise) * dot(&o.right.state, &spread);
                q_yy[(p.row, o.row)] += p.gain * o.gain * white;
            }
        }
        Ok(Lifted { sigma, pairs, g, q_yy, q_vy })
    }

    /// The joint system of y and z for linear pushes alone: its matrix and noise intensity.
    fn linear_system(&self) -> (Mat<f64>, Mat<f64>) {
        let (n, k, m) = (self.fast.nrows(), self.slow.nrows(), self.noise.ncols());
        let mut a = Mat::zeros(k + n, k + n);
        let mut b = Mat::zeros(k + n, m);
        for i in 0..k {
            (0..k).for_each(|j| a[(i, j)] = self.slow[(i, j)]);
        }
        for i in 0..n {
            (0..n).for_each(|j| a[(k + i, k + j)] = self.fast[(i, j)]);
            (0..m).for_each(|j| b[(k + i, j)] = self.noise[(i, j)]);
        }
        for p in &self.linear {
            (0..n).for_each(|j| a[(p.row, k + j)] += p.gain * p.signal.state[j]);
            (0..m).for_each(|j| b[(p.row, j)] += p.gain * p.signal.noise[j]);
        }
        let q = &b * b.transpose();
        (a, q)
    }

    fn linear_covariance(&self) -> Result<Mat<f64>> {
        let k = self.slow.nrows();
        let (a, q) = self.linear_system();
        let x = stationary_covariance(&a, &q)?.matrix;
        Ok(Mat::from_fn(k, k, |i, j| x[(i, j)]))
    }

    fn quadratic_covariance(&self, l: &Lifted) -> Result<Mat<f64>> {
        let (k, m) = (self.slow.nrows(), l.pairs.len());
        let drift = lifted_drift(&self.fast, &l.pairs);
        // C_v by Isserlis: E[vᵢⱼ vₖₗ] = Σᵢₖ Σⱼₗ + Σᵢₗ Σⱼₖ
        let s = &l.sigma;
        let cv = Mat::from_fn(m, m, |p, q| {
            let ((i, j), (a, b)) = (l.pairs[p], l.pairs[q]);
            s[(i, a)] * s[(j, b)] + s[(i, b)] * s[(j, a)]
        });
        let right = &cv * l.g.transpose() + &l.q_vy;
        // (A ⊕ A) M + M A_sᵀ = −right, column by column stacked
        let big = Mat::from_fn(k * m, k * m, |r, c| {
            let ((rb, ri), (cb, ci)) = ((r / m, r % m), (c / m, c % m));
            let own = if rb == cb { drift[(ri, ci)] } else { 0.0 };
            own + if ri == ci { self.slow[(rb, cb)] } else { 0.0 }
        });
        let stacked = Mat::from_fn(k * m, 1, |r, _| -right[(r % m, r / m)]);
        let solution = big.partial_piv_lu().solve(&stacked);
        let residual = (&big * &solution - &stacked).norm_max();
        let size = stacked.norm_max();
        if !residual.is_finite() || residual > 1e-6 * size {
            return Err(Error::not_computed("the covariance of the products is too badly conditioned"));
        }
        let gm =
            Mat::from_fn(k, k, |i, j| (0..m).map(|p| l.g[(i, p)] * solution[(j * m + p, 0)]).sum::<f64>());
        let q = Mat::from_fn(k, k, |i, j| gm[(i, j)] + gm[(j, i)] + l.q_yy[(i, j)]);
        Ok(stationary_covariance(&self.slow, &q)?.matrix)
    }
}

/// A ⊕ A on the pairs i ≤ j: (zᵢzⱼ)˙ = Σ Aᵢₖ zₖzⱼ + Σ Aⱼₖ zᵢzₖ.
fn lifted_drift(a: &Mat<f64>, pairs: &[(usize, usize)]) -> Mat<f64> {
    let n = a.nrows();
    let place = |i: usize, j: usize| {
        let (i, j) = if i <= j { (i, j) } else { (j, i) };
        i * n - i * (i + 1) / 2 + j
    };
    let mut out = Mat::zeros(pairs.len(), pairs.len());
    for (row, &(i, j)) in pairs.iter().enumerate() {
        for k in 0..n {
            out[(row, place(k, j))] += a[(i, k)];
            out[(row, place(i, k))] += a[(j, k)];
        }
    }
    out
}

/// E[(bᵢzⱼ + zᵢbⱼ)(bₖzₗ + zₖbₗ)] with Q = BBᵀ.
fn pair_noise(q: &Mat<f64>, s: &Mat<f64>, (i, j): (usize, usize), (k, l): (usize, usize)) -> f64 {
    q[(i, k)] * s[(j, l)] + q[(i, l)] * s[(j, k)] + q[(j, k)] * s[(i, l)] + q[(j, l)] * s[(i, k)]
}

/// S(ω) of state `row` of ẋ = F x + noise of intensity Q: [(jω − F)⁻¹ Q (jω − F)⁻ᴴ]ᵣᵣ.
fn density(f: &Mat<f64>, q: &Mat<f64>, row: usize, omega: f64) -> f64 {
    let n = f.nrows();
    // the row r of (jω − F)⁻¹ is the solution of (jω − F)ᵀ r = e
    let shifted = Mat::from_fn(n, n, |i, j| c64::new(-f[(j, i)], if i == j { omega } else { 0.0 }));
    let unit = Mat::from_fn(n, 1, |i, _| c64::new(f64::from(u8::from(i == row)), 0.0));
    let r = shifted.partial_piv_lu().solve(&unit);
    let mut sum = 0.0;
    for i in 0..n {
        for j in 0..n {
            sum += q[(i, j)] * (r[(i, 0)].re * r[(j, 0)].re + r[(i, 0)].im * r[(j, 0)].im);
        }
    }
    sum
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// M x.
fn times(m: &Mat<f64>, x: &[f64]) -> Vec<f64> {
    (0..m.nrows()).map(|i| (0..m.ncols()).map(|j| m[(i, j)] * x[j]).sum()).collect()
}
