//! # Purpose
//! T and C₀ from a table of trials, as the rolling-error paper found them.
//!
//! # Method
//! (2.4) says α = −(1/C₀)·k·p⁴/(1 + p²T²) with known k. For given T it is linear in 1/C₀; the
//! least squares over both run on (ln C₀, T) from several T, with 95 % intervals by Student's t
//! on the linearised covariance.
//!
//! # References
//! The rolling-error paper, section 2: M[(α₊ − α₋)²] = min over more than 6000 trials.
//!
//! # Numerical aspects
//! T enters as T²; near T = 0 its interval is cut at zero. One pass over the trials an
//! iteration: milliseconds for thousands of trials.

use super::Gyrosphere;
use super::seed::{Regular, regular_error};
use crate::spectrum::{Interval, LeastSquares, least_squares};
use crate::{Error, Result};
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Relative difference up to which two frequencies are one, and share of the largest error below which there is none.
const SAME: f64 = 1e-9;

/// One steady trial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// K, rad.
    pub heading: f64,
    /// θ₀h, m.
    pub amplitude: f64,
    /// p, rad/s.
    pub frequency: f64,
    /// φ, rad.
    pub latitude: f64,
    /// The measured error, rad.
    pub error: f64,
}

/// What the trials say.
#[derive(Debug, Clone, Copy)]
pub struct Identified {
    /// T, s.
    pub lag: Interval,
    /// C₀, N/m.
    pub stiffness: Interval,
    /// Standard deviation of the residuals, rad.
    pub residual: f64,
}

/// Least squares for T and C₀; `sphere` gives everything else.
///
/// ```
/// use gyrospec::gyro::{Gyrosphere, Trial, identify, seed};
/// let truth = Gyrosphere::seed();
/// let trials: Vec<Trial> = (0..60)
///     .map(|k| {
///         let (heading, frequency) = (0.3 * f64::from(k), 0.6 + 0.02 * f64::from(k));
///         let sphere = Gyrosphere { lever: 0.25, ..truth };
///         let roll = seed::Regular { amplitude: 1.0, frequency };
///         let error = seed::regular_error(&sphere, &roll, heading);
///         Trial { heading, amplitude: 0.25, frequency, latitude: truth.latitude, error }
///     })
///     .collect();
/// let found = identify(&trials, &truth).unwrap();
/// assert!((found.lag.value - 0.44).abs() < 1e-6 && (found.stiffness.value / 1.35e5 - 1.0).abs() < 1e-6);
/// ```
///
/// # Errors
/// `BadInput` for fewer than three trials or numbers that are not finite, `NotComputed` when the
/// trials do not tell T from C₀ (one frequency alone).
pub fn identify(trials: &[Trial], sphere: &Gyrosphere) -> Result<Identified> {
    let finite =
        |t: &Trial| [t.heading, t.amplitude, t.frequency, t.latitude, t.error].iter().all(|v| v.is_finite());
    if trials.len() < 3 || !trials.iter().all(finite) {
        return Err(Error::bad_input("at least three trials, all of finite numbers, are needed"));
    }
    // a unit error of each trial: C₀ = 1 and T = 0
    let units: Vec<f64> = trials.iter().map(|t| unit_error(t, sphere)).collect();
    if !has_two_frequencies(trials, &units) {
        return Err(not_apart());
    }
    let residuals = |p: &[f64]| -> Vec<f64> {
        let (c0, t2) = (p[0].exp(), p[1] * p[1]);
        trials
            .iter()
            .zip(&units)
            .map(|(t, u)| u / (c0 * (1.0 + t.frequency.powi(2) * t2)) - t.error)
            .collect()
    };
    let mut best: Option<LeastSquares> = None;
    for lag in [0.1, 0.5, 2.0] {
        let c0 = stiffness_at(lag, trials, &units)?;
        if let Ok(found) = least_squares(&[c0.ln(), lag], residuals)
            && best.as_ref().is_none_or(|b| found.sum_of_squares < b.sum_of_squares)
        {
            best = Some(found);
        }
    }
    let best = best.ok_or_else(not_apart)?;
    told(&best, trials.len())
}

fn not_apart() -> Error {
    Error::not_computed("the trials do not tell T from C0").with_hint("trials at more than one frequency do")
}

/// Whether the trials that have an error at all are of more than one frequency: at one, C₀(1 + p²T²) is all that
/// (2.4) holds, however well it fits.
fn has_two_frequencies(trials: &[Trial], units: &[f64]) -> bool {
    let least = SAME * units.iter().fold(0.0, |most: f64, u| most.max(u.abs()));
    let mut told = trials.iter().zip(units).filter(|(_, u)| u.abs() > least).map(|(t, _)| t.frequency.abs());
    let Some(first) = told.next() else { return false };
    told.any(|p| (p - first).abs() > SAME * first)
}

/// α(C₀ = 1, T = 0), by (2.4).
fn unit_error(t: &Trial, sphere: &Gyrosphere) -> f64 {
    let unit = Gyrosphere { stiffness: 1.0, lag: 0.0, lever: t.amplitude, latitude: t.latitude, ..*sphere };
    regular_error(&unit, &Regular { amplitude: 1.0, frequency: t.frequency }, t.heading)
}

/// The best C₀ for a given T: linear least squares for 1/C₀.
fn stiffness_at(lag: f64, trials: &[Trial], units: &[f64]) -> Result<f64> {
    let (mut up, mut down) = (0.0, 0.0);
    for (t, u) in trials.iter().zip(units) {
        let x = u / (1.0 + (t.frequency * lag).powi(2));
        up += x * t.error;
        down += x * x;
    }
    let give = up / down;
    if give.is_finite() && give > 0.0 {
        return Ok(1.0 / give);
    }
    Err(Error::not_computed("the trials show no error of the sign that an elastic lag causes"))
}

fn told(found: &LeastSquares, count: usize) -> Result<Identified> {
    let freedom = (count - 2) as f64;
    let variance = found.sum_of_squares / freedom;
    let t =
        StudentsT::new(0.0, 1.0, freedom).map_err(|e| Error::not_computed(e.to_string()))?.inverse_cdf(0.975);
    let margin = |i: usize| t * (variance * found.inverse_normal[(i, i)]).sqrt();
    let (log_c0, lag) = (found.parameters[0], found.parameters[1].abs());
    if !margin(0).is_finite() || margin(0) > 20.0 {
        return Err(not_apart());
    }
    Ok(Identified {
        lag: Interval { value: lag, low: (lag - margin(1)).max(0.0), high: lag + margin(1) },
        stiffness: Interval {
            value: log_c0.exp(),
            low: (log_c0 - margin(0)).exp(),
            high: (log_c0 + margin(0)).exp(),
        },
        residual: variance.sqrt(),
    })
}
