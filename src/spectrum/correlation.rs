//! The correlation function of a recording, and the fit of (3.3) to it.

use super::even::high_pass;
use super::{LeastSquares, Roll, least_squares};
use crate::{Error, Result};

/// K(kΔt) for k = 0 … `lags` of values with their mean removed; pairs with a gap are left
/// out, and each lag is divided by the number of all samples (the biased estimate, which is
/// a correlation function itself).
///
/// ```
/// let k = gyrospec::spectrum::autocovariance(&[1.0, -1.0, 1.0, -1.0], 2);
/// assert_eq!(k, [1.0, -0.75, 0.5]);                 // 4, 3 and 2 products of ±1, each over 4
/// ```
pub fn autocovariance(values: &[f64], lags: usize) -> Vec<f64> {
    let known: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let x: Vec<f64> = values.iter().map(|v| if v.is_finite() { v - mean } else { 0.0 }).collect();
    let count = known.len().max(1) as f64;
    (0..=lags.min(x.len().saturating_sub(1)))
        .map(|k| x.iter().zip(&x[k..]).map(|(a, b)| a * b).sum::<f64>() / count)
        .collect()
}

/// The correlation function (3.3) fitted to a measured one.
#[derive(Debug, Clone)]
pub struct CorrelationFit {
    /// A, μ, ε.
    pub roll: Roll,
    /// Part of the measured correlation's sum of squares that the fit explains, at most 1.
    pub r_squared: f64,
    /// Root-mean-square misfit over the lags, as a part of K(0).
    pub misfit: f64,
    /// The measured correlation function at 0, Δt, 2Δt, …; unit².
    pub measured: Vec<f64>,
    /// The fitted one at the same lags, without what is slower than the corner.
    pub fitted: Vec<f64>,
    /// The corner, rad/s.
    pub(super) slow: f64,
    /// Δt, s.
    pub step: f64,
}

/// Fits A, μ, ε of (3.3) to `measured`, K(kΔt), by least squares over its lags.
/// `frequency` is a first guess of ε, rad/s. Of motion that went through
/// [`without_slow`](super::without_slow) with the corner `slow` (rad/s; 0 for none) the same part
/// of (3.3) is left out in the comparison, so that A, μ, ε are those of the whole roll.
///
/// ```
/// use gyrospec::spectrum::{Roll, fit_correlation};
/// let truth = Roll::new(0.02, 0.1, 0.8)?;
/// let k: Vec<f64> = (0..100).map(|i| truth.correlation(0.5 * f64::from(i))).collect();
/// let found = fit_correlation(&k, 0.5, 1.0, 0.0)?.roll;
/// assert!((found.frequency - 0.8).abs() < 1e-6 && (found.decay - 0.1).abs() < 1e-6);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` for fewer than 6 lags or no variance, `NotComputed` when no start converges.
pub fn fit_correlation(measured: &[f64], step: f64, frequency: f64, slow: f64) -> Result<CorrelationFit> {
    let starts = [0.02, 0.1, 0.4]
        .into_iter()
        .flat_map(|share| [0.8, 1.0, 1.25].map(|shift| (share * frequency * shift, frequency * shift)));
    fit_from(measured, (step, slow), starts)
}

/// The same from given first guesses of (μ, ε).
pub(super) fn fit_from(
    measured: &[f64],
    (step, slow): (f64, f64),
    starts: impl Iterator<Item = (f64, f64)>,
) -> Result<CorrelationFit> {
    let variance = measured.first().copied().unwrap_or(0.0);
    if measured.len() < 6 || !(variance.is_finite() && variance > 0.0) {
        return Err(Error::bad_input("the motion does not move, or the recording is too short to fit"));
    }
    let left = LeftOut::new(slow, step, measured.len());
    // μ and ε stay below the Nyquist frequency, above which nothing was seen
    let limit = std::f64::consts::PI / step;
    let bounded = |q: f64| limit / (1.0 + (-q).exp());
    let unbounded = |x: f64| -(limit / x.clamp(1e-9 * limit, 0.999 * limit) - 1.0).ln();
    let shaped =
        |p: &[f64]| Roll { variance: p[0].exp() * variance, decay: bounded(p[1]), frequency: bounded(p[2]) };
    let residuals = |p: &[f64]| -> Vec<f64> {
        let fitted = left.correlation(&shaped(p), step, measured.len());
        measured.iter().zip(fitted).map(|(m, f)| (m - f) / variance).collect()
    };
    let mut best: Option<LeastSquares> = None;
    for (decay, eps) in starts {
        let found = least_squares(&[0.0, unbounded(decay), unbounded(eps)], residuals);
        if let Ok(f) = found
            && best.as_ref().is_none_or(|b| f.sum_of_squares < b.sum_of_squares)
        {
            best = Some(f);
        }
    }
    let best = best.ok_or_else(|| {
        Error::not_computed("no roll spectrum of the form (3.3) of Potemkin 1978 fits this motion")
    })?;
    let Roll { variance: a, decay, frequency } = shaped(&best.parameters);
    let roll = Roll::new(a, decay, frequency)?;
    let total: f64 = measured.iter().map(|m| (m / variance).powi(2)).sum();
    Ok(CorrelationFit {
        roll,
        r_squared: 1.0 - best.sum_of_squares / total,
        misfit: (best.sum_of_squares / measured.len() as f64).sqrt(),
        measured: measured.to_vec(),
        fitted: left.correlation(&roll, step, measured.len()),
        slow,
        step,
    })
}

/// The slow part of a spectrum that a high-pass has taken away: a midpoint rule on 0 … 2ω_c.
struct LeftOut {
    /// ω, and the cosines of ω at each lag.
    nodes: Vec<(f64, Vec<f64>)>,
    /// (1 − |W|⁴) Δω/π at each.
    weights: Vec<f64>,
}

impl LeftOut {
    fn new(corner: f64, step: f64, lags: usize) -> Self {
        let count = if corner > 0.0 { 96 } else { 0 };
        let width = 2.0 * corner / 96.0;
        let omega = |j: usize| (j as f64 + 0.5) * width;
        let cosines = |w: f64| (0..lags).map(|k| (w * k as f64 * step).cos()).collect();
        Self {
            nodes: (0..count).map(|j| (omega(j), cosines(omega(j)))).collect(),
            weights: (0..count)
                .map(|j| (1.0 - high_pass(omega(j), corner).powi(2)) * width / std::f64::consts::PI)
                .collect(),
        }
    }

    /// K(kΔt) − (1/π)∫ (1 − |W|⁴) S(ω) cos ωkΔt dω
    fn correlation(&self, roll: &Roll, step: f64, lags: usize) -> Vec<f64> {
        let mut k: Vec<f64> = (0..lags).map(|k| roll.correlation(k as f64 * step)).collect();
        for ((omega, cosines), weight) in self.nodes.iter().zip(&self.weights) {
            let power = weight * roll.density(*omega);
            k.iter_mut().zip(cosines).for_each(|(k, c)| *k -= power * c);
        }
        k
    }
}
