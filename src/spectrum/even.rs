//! Samples at equal steps from a recording's own times.

use crate::{Error, Result};
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

/// Samples at equal steps; NaN = gap.
#[derive(Debug, Clone)]
pub struct EvenSamples {
    /// The step, s.
    pub step: f64,
    /// The samples, NaN where the recording has a gap.
    pub values: Vec<f64>,
}

/// Puts samples on the even grid of their median step: a sample within a twentieth of a step
/// of its place is taken as it is, between neighbours at most two and a half steps apart the
/// straight line counts, and all else is a gap.
///
/// ```
/// // 1 Hz with one sample missing
/// let time: Vec<f64> = (0..20).filter(|k| *k != 7).map(f64::from).collect();
/// let values: Vec<f64> = time.iter().map(|t| 2.0 * t).collect();
/// let even = gyrospec::spectrum::even_samples(&time, &values)?;
/// assert_eq!((even.step, even.values.len(), even.values[7]), (1.0, 20, 14.0));
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` for fewer than 16 samples or times that do not rise.
pub fn even_samples(time: &[f64], values: &[f64]) -> Result<EvenSamples> {
    let known: Vec<(f64, f64)> =
        time.iter().copied().zip(values.iter().copied()).filter(|(_, v)| v.is_finite()).collect();
    if known.len() < 16 {
        return Err(Error::bad_input(format!("{} samples are too few for a spectrum", known.len())));
    }
    let mut gaps: Vec<f64> = known.windows(2).map(|p| p[1].0 - p[0].0).collect();
    if !gaps.iter().all(|g| *g > 0.0) {
        return Err(Error::bad_input("the times of the recording do not rise"));
    }
    gaps.sort_by(f64::total_cmp);
    let first = known[0].0;
    // the mean of the ordinary steps: the median alone drifts when time stamps are rounded
    let median = gaps[gaps.len() / 2];
    let ordinary: Vec<f64> = gaps.iter().copied().filter(|g| (g / median - 1.0).abs() < 0.5).collect();
    let step = ordinary.iter().sum::<f64>() / ordinary.len() as f64;
    let count = ((known[known.len() - 1].0 - first) / step).round() as usize + 1;
    if count > 100 * known.len() {
        return Err(Error::bad_input("the recording is mostly gaps"));
    }
    let mut at = 0;
    let values = (0..count)
        .map(|k| {
            let t = first + k as f64 * step;
            while at + 2 < known.len() && known[at + 1].0 <= t {
                at += 1;
            }
            let (a, b) = (known[at], known[at + 1]);
            match () {
                () if (t - a.0).abs() < 0.05 * step => a.1,
                () if (t - b.0).abs() < 0.05 * step => b.1,
                () if b.0 - a.0 > 2.5 * step => f64::NAN,
                () => a.1 + (b.1 - a.1) * (t - a.0) / (b.0 - a.0),
            }
        })
        .collect();
    Ok(EvenSamples { step, values })
}

/// The samples without what is slower than `corner`, rad/s: by a zero-phase eighth-order
/// high-pass on their Fourier transform, gaps bridged by zero and put back after.
///
/// # Errors
/// `NotComputed` when the transform fails.
pub fn without_slow(samples: &EvenSamples, corner: f64) -> Result<EvenSamples> {
    let n = samples.values.len();
    let known: Vec<f64> = samples.values.iter().copied().filter(|v| v.is_finite()).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let mut planner = RealFftPlanner::<f64>::new();
    let (forward, back) = (planner.plan_fft_forward(2 * n), planner.plan_fft_inverse(2 * n));
    // mirrored at the end, so that the ends meet
    let level = |v: f64| if v.is_finite() { v - mean } else { 0.0 };
    let mut signal: Vec<f64> =
        samples.values.iter().chain(samples.values.iter().rev()).map(|v| level(*v)).collect();
    let mut transform = forward.make_output_vec();
    let failed = |e: realfft::FftError| Error::not_computed(e.to_string());
    forward.process(&mut signal, &mut transform).map_err(failed)?;
    for (k, z) in transform.iter_mut().enumerate() {
        let omega = TAU * k as f64 / (2 * n) as f64 / samples.step;
        *z *= high_pass(omega, corner) / (2 * n) as f64;
    }
    back.process(&mut transform, &mut signal).map_err(failed)?;
    let values = signal.iter().zip(&samples.values).map(|(x, v)| if v.is_finite() { *x } else { f64::NAN });
    Ok(EvenSamples { step: samples.step, values: values.collect() })
}

/// What [`without_slow`] leaves of an amplitude at ω: |W|² = r/(1 + r), r = (ω/ω_c)⁸, of a
/// Butterworth high-pass, without its phase.
pub(super) fn high_pass(omega: f64, corner: f64) -> f64 {
    let ratio = (omega / corner).powi(8);
    ratio / (1.0 + ratio)
}
