//! Tests whether innovations are white.
//!
//! # References
//! G. M. Ljung, G. E. P. Box, Biometrika 65 (1978) 297-303; A. Wald, J. Wolfowitz, Annals of
//! Mathematical Statistics 11 (1940) 147-162 (runs).

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

/// The outcome of a portmanteau test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Portmanteau {
    /// Q = N(N + 2) Σ r_k²/(N − k).
    pub statistic: f64,
    /// Lags less the coefficients that were estimated.
    pub degrees: usize,
    /// Chance of a larger Q in white noise.
    pub p_value: f64,
}

/// Ljung and Box's test of innovations over lags 1 … `lags`, `estimated` coefficients having been fitted.
///
/// ```
/// use gyrospec::estimate::noise::portmanteau;
/// let wave: Vec<f64> = (0..400).map(|i| (0.1 * f64::from(i)).sin()).collect();
/// assert!(portmanteau(&[&wave], 10, 0).p_value < 1e-9);
/// ```
pub fn portmanteau(stretches: &[&[f64]], lags: usize, estimated: usize) -> Portmanteau {
    let count: usize = stretches.iter().map(|s| s.len()).sum();
    let n = count as f64;
    let energy: f64 = stretches.iter().flat_map(|s| s.iter()).map(|y| y * y).sum();
    let lags = lags.min(count.saturating_sub(1));
    let mut statistic = 0.0;
    for k in 1..=lags {
        let product: f64 = stretches
            .iter()
            .filter(|s| s.len() > k)
            .map(|s| s.iter().zip(&s[k..]).map(|(a, b)| a * b).sum::<f64>())
            .sum();
        statistic += n * (n + 2.0) * (product / energy).powi(2) / (n - k as f64);
    }
    let degrees = lags.saturating_sub(estimated).max(1);
    let p_value = if statistic.is_finite() {
        ChiSquared::new(degrees as f64).map_or(1.0, |d| d.sf(statistic))
    } else {
        1.0
    };
    Portmanteau { statistic, degrees, p_value }
}

/// The runs test of Wald and Wolfowitz: chance of so uneven a number of sign changes in white noise.
pub fn runs(stretch: &[f64]) -> f64 {
    let signs: Vec<bool> = stretch.iter().filter(|y| **y != 0.0).map(|y| *y > 0.0).collect();
    let (n, up) = (signs.len() as f64, signs.iter().filter(|s| **s).count() as f64);
    let down = n - up;
    if up < 2.0 || down < 2.0 {
        return 1.0;
    }
    let changes = 1.0 + signs.windows(2).filter(|w| w[0] != w[1]).count() as f64;
    let expected = 1.0 + 2.0 * up * down / n;
    let variance = (expected - 1.0) * (expected - 2.0) / (n - 1.0);
    let z = (changes - expected) / variance.sqrt();
    Normal::standard().cdf(-z.abs()) * 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    #[test]
    fn white_noise_fails_as_often_as_promised() {
        let (mut by_lags, mut by_runs) = (0, 0);
        for seed in 0..400 {
            let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
            let e: Vec<f64> = (0..500).map(|_| StandardNormal.sample(&mut rng)).collect();
            by_lags += usize::from(portmanteau(&[&e[..200], &e[200..]], 20, 0).p_value < 0.05);
            by_runs += usize::from(runs(&e) < 0.05);
        }
        // 5 % of 400 is 20 with a deviation of 4.4.
        assert!((6..=34).contains(&by_lags) && (6..=34).contains(&by_runs), "{by_lags} {by_runs}");
    }

    #[test]
    fn a_slow_wave_has_too_few_runs() {
        let wave: Vec<f64> = (0..200).map(|i| (0.1 * f64::from(i)).sin()).collect();
        assert!(runs(&wave) < 1e-9);
    }
}
