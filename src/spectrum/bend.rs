//! # Purpose
//! The second derivative of a recorded motion, at steps finer than its samples.
//!
//! # Method
//! The samples of each stretch without a gap, less their mean and faded out at both ends, are multiplied by −ω² on their
//! Fourier transform, which a longer transform takes back to time: between the samples stands the one motion that
//! holds no frequency above theirs. What faded is cut off.
//!
//! # References
//! C. E. Shannon, Proc. IRE 37 (1949) 10–21, for samples and the motion between them.
//!
//! # Numerical aspects
//! ω² lifts the rounding of the samples up to their Nyquist frequency; `band` takes it away.

use super::even::{EvenSamples, high_pass};
use crate::{Error, Result};
use num_complex::Complex64;
use realfft::RealFftPlanner;
use std::f64::consts::{PI, TAU};

/// How long each end of a stretch fades, s.
const FADE: f64 = 40.0;

/// The second derivative of each stretch of samples without a gap and longer than four fades of 40 s, less a fade at
/// either end, at `1/times` of their step; without what is slower than `corner` (rad/s), and behind two low-passes of first
/// order at `band` (rad/s), without their phase.
///
/// ```
/// use gyrospec::spectrum::{EvenSamples, bent};
/// let values = (0..4000).map(|k| 3.0 * (0.1 * f64::from(k)).sin()).collect();        // 1 rad/s
/// let stretch = bent(&EvenSamples { step: 0.1, values }, 0.2, None, 2)?.remove(0);
/// assert_eq!(stretch.len(), 2 * (4000 - 2 * 400));
/// // −3 sin t from t = 40 s on
/// assert!((stretch[100] + 3.0 * 45f64.sin()).abs() < 0.01);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `NotComputed` when a transform fails.
pub fn bent(samples: &EvenSamples, corner: f64, band: Option<f64>, times: usize) -> Result<Vec<Vec<f64>>> {
    let fade = (FADE / samples.step).ceil() as usize;
    let stretches = samples.values.split(|v| !v.is_finite()).filter(|s| s.len() > 4 * fade);
    let gain = |omega: f64| {
        let pass = band.map_or(1.0, |b| 1.0 / (1.0 + (omega / b).powi(2)));
        -omega * omega * high_pass(omega, corner) * pass
    };
    let one = |stretch: &[f64]| {
        let all = filtered(&faded(stretch, fade), samples.step, times, &gain)?;
        Ok(all[times * fade..times * (stretch.len() - fade)].to_vec())
    };
    stretches.map(one).collect()
}

/// Less the mean, and faded by half a cosine at both ends.
fn faded(stretch: &[f64], fade: usize) -> Vec<f64> {
    let n = stretch.len();
    let mean = stretch.iter().sum::<f64>() / n as f64;
    let weight = |k: usize| {
        let edge = (k.min(n - 1 - k) as f64 + 0.5) / fade as f64;
        if edge < 1.0 { 0.5 - 0.5 * (PI * edge).cos() } else { 1.0 }
    };
    stretch.iter().enumerate().map(|(k, v)| weight(k) * (v - mean)).collect()
}

/// The signal with each frequency multiplied by its gain, at `times` as many points.
fn filtered(signal: &[f64], step: f64, times: usize, gain: &dyn Fn(f64) -> f64) -> Result<Vec<f64>> {
    let n = signal.len();
    let mut planner = RealFftPlanner::<f64>::new();
    let (forward, back) = (planner.plan_fft_forward(n), planner.plan_fft_inverse(n * times));
    let failed = |e: realfft::FftError| Error::not_computed(e.to_string());
    let (mut signal, mut transform) = (signal.to_vec(), forward.make_output_vec());
    forward.process(&mut signal, &mut transform).map_err(failed)?;
    let mut wide = back.make_input_vec();
    // what stands at the Nyquist frequency itself has no sine
    for (k, z) in transform.iter().enumerate().take(n.div_ceil(2)).skip(1) {
        wide[k] = z * gain(TAU * k as f64 / (n as f64 * step)) / n as f64;
    }
    wide[0] = Complex64::ZERO;
    let mut out = back.make_output_vec();
    back.process(&mut wide, &mut out).map_err(failed)?;
    Ok(out)
}
