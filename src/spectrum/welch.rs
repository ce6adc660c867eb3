//! # Purpose
//! The spectrum of a recorded motion.
//!
//! # Method
//! Welch: overlapping segments, each freed of its straight line, under a Hann window.
//!
//! # References
//! P. D. Welch, IEEE Trans. Audio Electroacoust. AU-15 (1967) 70–73.
//!
//! # Numerical aspects
//! Stretches with gaps are left out whole; no value is made up. The density is two-sided
//! over ω in rad/s with K(0) = (1/2π)∫ S dω.

use crate::{Error, Result};
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

/// A measured two-sided density on the frequencies 0 … Nyquist.
#[derive(Debug, Clone)]
pub struct MeasuredSpectrum {
    /// ω, rad/s, equally spaced from 0.
    pub omega: Vec<f64>,
    /// S(ω), unit²·s.
    pub density: Vec<f64>,
    /// How many segments were averaged.
    pub segments: usize,
    /// Sampling step, s.
    pub step: f64,
}

impl MeasuredSpectrum {
    /// (1/2π)∫ S(ω) weight(ω) dω over the measured band, both signs of ω, by trapezoids.
    pub fn integral(&self, weight: impl Fn(f64) -> f64) -> f64 {
        let points: Vec<f64> = self.omega.iter().zip(&self.density).map(|(w, s)| s * weight(*w)).collect();
        let step = self.omega.get(1).copied().unwrap_or(0.0);
        let sum: f64 = points.windows(2).map(|p| 0.5 * (p[0] + p[1])).sum();
        2.0 * sum * step / TAU
    }

    /// The frequency of the highest point, the zero left out, rad/s.
    pub fn peak(&self) -> f64 {
        let best = (1..self.omega.len()).max_by(|a, b| self.density[*a].total_cmp(&self.density[*b]));
        best.map_or(0.0, |k| self.omega[k])
    }
}

/// The density of samples `values` at equal steps (s), NaN = gap, by segments of `length`
/// samples that overlap by half.
///
/// ```
/// // a sine of amplitude 2 and frequency 1 rad/s: its variance is 2
/// let values: Vec<f64> = (0..4000).map(|k| 2.0 * (0.1 * f64::from(k)).sin()).collect();
/// let spectrum = gyrospec::spectrum::welch(&values, 0.1, 1000)?;
/// assert!((spectrum.peak() - 1.0).abs() < 0.05);
/// assert!((spectrum.integral(|_| 1.0) - 2.0).abs() < 0.02);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` when no stretch without a gap is as long as a segment, or the step is not
/// positive.
pub fn welch(values: &[f64], step: f64, length: usize) -> Result<MeasuredSpectrum> {
    if !(step.is_finite() && step > 0.0) || length < 8 {
        return Err(Error::bad_input(format!(
            "a spectrum needs a positive step and segments of at least 8 samples, not {step} s and {length}"
        )));
    }
    let window: Vec<f64> =
        (0..length).map(|k| 0.5 - 0.5 * (TAU * (k as f64 + 0.5) / length as f64).cos()).collect();
    let power: f64 = window.iter().map(|w| w * w).sum();
    let plan = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let (mut input, mut output) = (plan.make_input_vec(), plan.make_output_vec());
    let mut density = vec![0.0; length / 2 + 1];
    let mut segments = 0;
    let mut start = 0;
    while start + length <= values.len() {
        let part = &values[start..start + length];
        if let Some(gap) = part.iter().rposition(|v| !v.is_finite()) {
            start += gap + 1;
            continue;
        }
        let line = straight_line(part);
        for (k, slot) in input.iter_mut().enumerate() {
            *slot = window[k] * (part[k] - line.0 - line.1 * k as f64);
        }
        plan.process(&mut input, &mut output).map_err(|e| Error::not_computed(e.to_string()))?;
        // S(ω) = Δt |Σ wₖ xₖ e^{−jωkΔt}|² / Σ wₖ²
        for (sum, z) in density.iter_mut().zip(&output) {
            *sum += step * z.norm_sqr() / power;
        }
        segments += 1;
        start += length / 2;
    }
    if segments == 0 {
        return Err(Error::bad_input(format!("no stretch of {length} samples without a gap"))
            .with_hint("give a longer recording, or one with fewer gaps"));
    }
    for s in &mut density {
        *s /= segments as f64;
    }
    let omega = (0..density.len()).map(|k| TAU * k as f64 / (length as f64 * step)).collect();
    Ok(MeasuredSpectrum { omega, density, segments, step })
}

/// Level and slope a sample of the least-squares line.
fn straight_line(part: &[f64]) -> (f64, f64) {
    let n = part.len() as f64;
    let middle = (n - 1.0) / 2.0;
    let mean = part.iter().sum::<f64>() / n;
    let (mut up, mut down) = (0.0, 0.0);
    for (k, v) in part.iter().enumerate() {
        let x = k as f64 - middle;
        up += x * (v - mean);
        down += x * x;
    }
    let slope = up / down;
    (mean - slope * middle, slope)
}
