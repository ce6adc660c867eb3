//! # Purpose
//! A rational spectrum |F(jω)|² near a given one, so that exact integrals apply.
//!
//! # Method
//! F(s) = k s^p / Π (s² + 2ζᵢωᵢ s + ωᵢ²): the logarithms of k, ζᵢ, ωᵢ by least squares on the
//! weighted amplitude √S, from several starts; sections are added one at a time.
//!
//! # References
//! The idea of a shaping filter: H. W. Bode, C. E. Shannon, Proc. IRE 38 (1950) 417–425.
//!
//! # Numerical aspects
//! Every F so made is stable and of minimum phase by construction. No section is narrower than a step of the grid,
//! between whose points it would hide, nor beyond its end. The error is stated as found on the given grid, never
//! assumed.

use super::least_squares::least;
use crate::lti::TransferFunction;
use crate::{Error, Result};

/// A rational fit with its error.
#[derive(Debug, Clone)]
pub struct RationalFit {
    /// F(s): unit white noise in, the motion out.
    pub shaping: TransferFunction,
    /// ∫|S_fit − S| w dω / ∫ S w dω on the grid, w the weight.
    pub error: f64,
    /// ∫ S_fit w dω / ∫ S w dω − 1: the error of the weighted power.
    pub power_error: f64,
}

/// Sections, and zeros at s = 0.
pub(crate) type Shape = (usize, usize);

/// Fits |F(jω)|² to `density` at `omega` (rad/s, increasing), with `weight` (same length),
/// by second-order sections in series: of `zeros[i]` it tries i + 1 sections with s^`zeros[i]` above, and keeps the best.
///
/// ```
/// use gyrospec::spectrum::{Roll, fit_rational};
/// let roll = Roll::new(0.02, 0.1, 0.8)?;               // its own spectrum is rational
/// let omega: Vec<f64> = (1..=200).map(|k| 0.02 * f64::from(k)).collect();
/// let density: Vec<f64> = omega.iter().map(|w| roll.density(*w)).collect();
/// let fit = fit_rational(&omega, &density, &vec![1.0; 200], &[0])?;
/// assert!(fit.error < 1e-3);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` for lists that do not fit together, `NotComputed` when nothing converges.
pub fn fit_rational(omega: &[f64], density: &[f64], weight: &[f64], zeros: &[usize]) -> Result<RationalFit> {
    let shapes: Vec<Shape> = zeros.iter().enumerate().map(|(i, zero)| (i + 1, *zero)).collect();
    let search = Search { shapes: &shapes, starts: &[(0.15, 0.3), (0.4, 0.3)], enough: 0.0 };
    fit_shapes((omega, density, weight), &search)
}

/// What is tried in a rational fit.
pub(crate) struct Search<'a> {
    /// The forms.
    pub shapes: &'a [Shape],
    /// How far apart the sections start, ln ω, and with which damping ratio.
    pub starts: &'a [(f64, f64)],
    /// Squared error of the amplitude, a part of the weighted power, that ends the search.
    pub enough: f64,
}

/// The same by a search of one's own.
pub(crate) fn fit_shapes(
    (omega, density, weight): (&[f64], &[f64], &[f64]),
    search: &Search<'_>,
) -> Result<RationalFit> {
    let n = omega.len();
    let power: f64 = (0..n.min(density.len())).map(|k| density[k] * weight[k.min(weight.len() - 1)]).sum();
    if n < 8 || density.len() != n || weight.len() != n || !(power.is_finite() && power > 0.0) {
        return Err(Error::bad_input("a rational fit needs at least 8 frequencies and some power on them"));
    }
    let peak = (0..n).max_by(|a, b| (density[*a] * weight[*a]).total_cmp(&(density[*b] * weight[*b])));
    let centre = omega[peak.unwrap_or(0)].max(1e-6);
    let gap = omega.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let reach = [gap / centre, omega[n - 1] / centre];
    let size: Vec<f64> = weight.iter().map(|w| w.sqrt()).collect();
    let target: Vec<f64> = (0..n).map(|k| (density[k] * weight[k] / power).sqrt()).collect();
    let mut best: Option<(f64, Vec<f64>, usize)> = None;
    for (sections, zero) in search.shapes {
        if best.as_ref().is_some_and(|b| b.0 < search.enough) {
            break;
        }
        let residuals = |p: &[f64]| -> Vec<f64> {
            let amplitude = modelled(p, *zero, reach);
            (0..n).map(|k| amplitude(omega[k] / centre) * size[k] - target[k]).collect()
        };
        for begin in search.starts {
            let start = started(*sections, *begin, |p| residuals(p), &target);
            let Ok((p, squares)) = least(&start, &residuals) else { continue };
            if best.as_ref().is_none_or(|b| squares < 0.9 * b.0) {
                best = Some((squares, p, *zero));
            }
        }
    }
    let (_, p, zero) = best.ok_or_else(|| Error::not_computed("no rational spectrum fits"))?;
    stated(&p, zero, (centre, reach), power, (omega, density, weight))
}

/// Sections spread about the centre, the gain set so that the sizes agree.
fn started(
    sections: usize,
    (spread, damping): (f64, f64),
    r: impl Fn(&[f64]) -> Vec<f64>,
    target: &[f64],
) -> Vec<f64> {
    let mut p = vec![0.0];
    for i in 0..sections {
        let place = (i as f64 - (sections as f64 - 1.0) / 2.0) * spread;
        p.extend([place, damping.ln()]);
    }
    let made: f64 = r(&p).iter().zip(target).map(|(r, t)| (r + t).powi(2)).sum();
    let wanted: f64 = target.iter().map(|t| t * t).sum();
    p[0] = 0.5 * (wanted / made.max(f64::MIN_POSITIVE)).ln();
    p
}

/// ωᵢ and ζᵢ, frequencies in parts of the centre, of which the grid has a step and an end: ωᵢ up to four times the end,
/// no half width ζᵢωᵢ below the step, and none beyond the end that does not reach back to it.
fn section(p: &[f64], [step, end]: [f64; 2]) -> (f64, f64) {
    let w = step + 1.0 / ((-p[0]).exp() + 0.25 / end);
    (w, p[1].exp() + (step + (w - end).max(0.0)) / w)
}

/// |F(jω)| over x, a part of the centre; p = [ln k, …] with two numbers a [`section`].
fn modelled(p: &[f64], zeros: usize, reach: [f64; 2]) -> impl Fn(f64) -> f64 {
    let gain = p[0].exp();
    let sections: Vec<(f64, f64)> = p[1..].chunks_exact(2).map(|two| section(two, reach)).collect();
    move |x| {
        let power = |(w, z): &(f64, f64)| (w * w - x * x).powi(2) + (2.0 * z * w * x).powi(2);
        gain * x.powi(zeros as i32) / sections.iter().map(power).product::<f64>().sqrt()
    }
}

fn stated(
    p: &[f64],
    zeros: usize,
    (centre, reach): (f64, [f64; 2]),
    power: f64,
    (omega, density, weight): (&[f64], &[f64], &[f64]),
) -> Result<RationalFit> {
    let gain = power.sqrt() * p[0].exp() * centre.powi(-(zeros as i32));
    let mut shaping = TransferFunction::constant(gain);
    let mut remaining = zeros;
    for two in p[1..].chunks_exact(2) {
        let (w, z) = section(two, reach);
        let w = w * centre;
        let taken = remaining.min(2);
        remaining -= taken;
        let mut top = vec![0.0; taken + 1];
        top[0] = centre * centre;
        shaping = shaping.then(&TransferFunction::new(&top, &[1.0, 2.0 * z * w, w * w])?);
    }
    let (mut off, mut made, mut all) = (0.0, 0.0, 0.0);
    for k in 0..omega.len() {
        let fitted = shaping.power(omega[k]);
        let gap = if k + 1 < omega.len() { omega[k + 1] - omega[k] } else { omega[k] - omega[k - 1] };
        off += (fitted - density[k]).abs() * weight[k] * gap;
        made += fitted * weight[k] * gap;
        all += density[k] * weight[k] * gap;
    }
    Ok(RationalFit { shaping, error: off / all, power_error: made / all - 1.0 })
}
