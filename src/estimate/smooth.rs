//! Smoothed values and derivatives of a measured signal.
//!
//! # Purpose
//! Values, slopes and curvatures of a noisy signal, for first guesses of states and their rates.
//!
//! # Method
//! A local cubic through the samples within a half-width of each wanted time, as a sum of polynomials that are
//! orthogonal over these samples; the half-width is the largest that leaves no more than the noise behind.
//!
//! # References
//! A. Savitzky, M. J. E. Golay, Analytical Chemistry 36 (1964) 1627-1639; W. S. Cleveland, JASA 74
//! (1979) 829-836; G. E. Forsythe, J. Soc. Indust. Appl. Math. 5 (1957) 74-88 (the recurrence).
//!
//! # Numerical aspects
//! Times are scaled to the window; uneven times are allowed. No matrix is formed, nothing is allocated.

/// Value and first three derivatives at each wanted sample.
pub type Jet = [f64; 4];

/// A cubic goes through no fewer samples.
const FEWEST: usize = 5;

/// A signal and the half-width over which it is smoothed.
#[derive(Debug, Clone, Copy)]
pub struct Smoother<'a> {
    time: &'a [f64],
    values: &'a [f64],
    half_width: usize,
}

impl<'a> Smoother<'a> {
    /// Chooses the half-width from the data; None with fewer than eight samples.
    pub fn new(time: &'a [f64], values: &'a [f64]) -> Option<Self> {
        if time.len() < 8 {
            return None;
        }
        let noise = high_frequency_deviation(values);
        let at = |half_width| Self { time, values, half_width };
        let mut best = at(2);
        for half_width in [3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128] {
            if 4 * half_width > time.len() || at(half_width).misfit() > 1.1 * noise {
                break;
            }
            best = at(half_width);
        }
        Some(best)
    }

    /// Root mean square of what the smoothing leaves, over some hundred samples.
    fn misfit(&self) -> f64 {
        let step = (self.time.len() / 300).max(1);
        let left: Vec<f64> =
            (0..self.time.len()).step_by(step).map(|i| (self.values[i] - self.jet(i)[0]).powi(2)).collect();
        (left.iter().sum::<f64>() / left.len() as f64).sqrt()
    }

    /// Value and derivatives at sample i.
    pub fn jet(&self, i: usize) -> Jet {
        let last = self.time.len();
        let from = i.saturating_sub(self.half_width).min(last.saturating_sub(FEWEST));
        let to = (i + self.half_width + 1).max(FEWEST).min(last);
        let scale = (self.time[to - 1] - self.time[from]).max(f64::MIN_POSITIVE);
        let samples = || {
            let u = self.time[from..to].iter().map(|t| (t - self.time[i]) / scale);
            u.zip(self.values[from..to].iter().copied())
        };
        let [c0, c1, c2, c3] = cubic(samples);
        [c0, c1 / scale, 2.0 * c2 / scale.powi(2), 6.0 * c3 / scale.powi(3)]
    }
}

/// Coefficients of 1, u, u² and u³ of the least-squares cubic through samples (u, y). With
///
///   p_(k+1) = (u − a_k) p_k − b_k p_(k−1),  a_k = Σ u p_k²/Σ p_k²,  b_k = Σ p_k²/Σ p_(k−1)²
///
/// it is Σ_k p_k Σ y p_k/Σ p_k² (Forsythe 1957).
fn cubic<S: Iterator<Item = (f64, f64)>>(samples: impl Fn() -> S) -> [f64; 4] {
    let value = |p: &[f64; 4], u: f64| p.iter().rev().fold(0.0, |sum, c| sum * u + c);
    let mut sum = [0.0; 4];
    let (mut p, mut before, mut size_before) = ([1.0, 0.0, 0.0, 0.0], [0.0; 4], 0.0);
    for _ in 0..4 {
        let (mut size, mut moment, mut product) = (0.0, 0.0, 0.0);
        for (u, y) in samples() {
            let at = value(&p, u);
            size += at * at;
            moment += u * at * at;
            product += y * at;
        }
        if size <= 0.0 {
            break;
        }
        let (a, b) = (moment / size, if size_before > 0.0 { size / size_before } else { 0.0 });
        let next: [f64; 4] = std::array::from_fn(|k| {
            sum[k] += p[k] * product / size;
            k.checked_sub(1).map_or(0.0, |below| p[below]) - a * p[k] - b * before[k]
        });
        (before, p, size_before) = (p, next, size);
    }
    sum
}

/// Deviation of the noise from third differences, whose variance is 20 σ².
fn high_frequency_deviation(values: &[f64]) -> f64 {
    let thirds: Vec<f64> =
        values.windows(4).map(|w| (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]).powi(2) / 20.0).collect();
    (thirds.iter().sum::<f64>() / thirds.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    #[test]
    fn a_cubic_is_kept_to_the_ends_at_uneven_times() {
        let time: Vec<f64> =
            (0..40).map(|i| 3.0 + 0.1 * f64::from(i) + 0.03 * f64::from(i * i % 7)).collect();
        let values: Vec<f64> = time.iter().map(|t| 2.0 - t + 0.5 * t * t - 0.25 * t * t * t).collect();
        for half_width in [2, 9] {
            let smoother = Smoother { time: &time, values: &values, half_width };
            for i in [0, 1, 20, 39] {
                let (t, got) = (time[i], smoother.jet(i));
                let wanted = [values[i], -1.0 + t - 0.75 * t * t, 1.0 - 1.5 * t, -1.5];
                for (k, (got, wanted)) in got.iter().zip(wanted).enumerate() {
                    assert!((got - wanted).abs() < 1e-9, "{half_width} {i} {k}: {got} {wanted}");
                }
            }
        }
    }

    #[test]
    fn a_noisy_sine_keeps_its_slope() {
        let time: Vec<f64> = (0..2000).map(|i| f64::from(i) * 0.005).collect();
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let mut noise = || -> f64 { StandardNormal.sample(&mut rng) };
        let values: Vec<f64> = time.iter().map(|t| t.sin() + 0.003 * noise()).collect();
        let smoother = Smoother::new(&time, &values).unwrap();
        for i in (100..1900).step_by(100) {
            let jet = smoother.jet(i);
            assert!((jet[1] - time[i].cos()).abs() < 0.05, "{jet:?}");
        }
    }
}
