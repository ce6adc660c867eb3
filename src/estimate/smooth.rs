//! Smoothed values and derivatives of a measured signal.
//!
//! # Purpose
//! Values, slopes and curvatures of a noisy signal, for first guesses of states and their rates.
//!
//! # Method
//! A local cubic through the samples within a half-width of each wanted time; the half-width is the
//! largest that leaves no more than the noise behind.
//!
//! # References
//! A. Savitzky, M. J. E. Golay, Analytical Chemistry 36 (1964) 1627-1639; W. S. Cleveland, JASA 74
//! (1979) 829-836.
//!
//! # Numerical aspects
//! Times are scaled to the window; uneven times are allowed.

use super::triangle::Triangle;

/// Value and first three derivatives at each wanted sample.
pub type Jet = [f64; 4];

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
        let from = i.saturating_sub(self.half_width);
        let to = (i + self.half_width + 1).min(self.time.len());
        let scale = (self.time[to - 1] - self.time[from]).max(f64::MIN_POSITIVE);
        let u: Vec<f64> = self.time[from..to].iter().map(|t| (t - self.time[i]) / scale).collect();
        let powers: Vec<Vec<f64>> = (0..4).map(|k| u.iter().map(|u| u.powi(k)).collect()).collect();
        let views: Vec<&[f64]> = powers.iter().map(Vec::as_slice).collect();
        let minus: Vec<f64> = self.values[from..to].iter().map(|y| -y).collect();
        let mut triangle = Triangle::new(4);
        triangle.push(&views, &minus);
        let c = triangle.solve(&[]);
        [c[0], c[1] / scale, 2.0 * c[2] / scale.powi(2), 6.0 * c[3] / scale.powi(3)]
    }
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
