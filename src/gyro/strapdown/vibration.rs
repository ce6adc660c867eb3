//! # Purpose
//! The vibration of the body that carries the instruments, along and about its axes.
//!
//! # Method
//! Each is a mount's resonance that one broadband shaking excites, turned by a phase:
//! F(s) = P(s)·σ√(4ζω₀³)/(s² + 2ζω₀s + ω₀²), ⟨y²⟩ = σ².
//! P turns by ψ at ω₀ and lets all amplitudes pass: (c − s)/(c + s) with c = ω₀/tan(|ψ|/2) for a lag, and
//! (s − c)/(s + c) with c = ω₀ tan(ψ/2) for a lead.
//!
//! # References
//! The resonance: W. T. Thomson, Theory of Vibration with Applications, chapter 13 (random vibration); its variance is
//! I₂ = b₁/(2a₁a₂) of (3.10).

use super::Vector;
use crate::lti::{TransferFunction, cross_moment};
use crate::{Error, Result};
use std::f64::consts::{PI, TAU};

/// A vibration along one axis (m/s², an acceleration) or about it (rad, an angle).
///
/// ```
/// use gyrospec::gyro::strapdown::Vibration;
/// let shaking = Vibration { deviation: 1e-3, phase: -1.5, frequency: 188.0, damping: 0.05 };
/// assert!((shaking.shaping()?.variance()?.value / 1e-6 - 1.0).abs() < 1e-13);
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vibration {
    /// σ, rad or m/s².
    pub deviation: f64,
    /// ψ at ω₀ against the common cause, rad; positive leads.
    pub phase: f64,
    /// ω₀, rad/s.
    pub frequency: f64,
    /// ζ.
    pub damping: f64,
}

impl Vibration {
    /// F: white noise of unit intensity in, the vibration out.
    ///
    /// # Errors
    /// `BadInput` for a frequency or a damping that is not positive, or a number that is not finite.
    pub fn shaping(&self) -> Result<TransferFunction> {
        let (w, zeta) = (self.frequency, self.damping);
        let finite = w.is_finite() && zeta.is_finite() && self.phase.is_finite();
        if !(finite && w > 0.0 && zeta > 0.0 && self.deviation >= 0.0) {
            return Err(Error::bad_input(
                "a vibration needs a frequency and a damping ratio above 0, and a standard deviation",
            ));
        }
        // σ√(4ζω₀³)/(s² + 2ζω₀s + ω₀²)
        let gain = self.deviation * (4.0 * zeta * w.powi(3)).sqrt();
        let resonance = TransferFunction::new(&[gain], &[1.0, 2.0 * zeta * w, w * w])?;
        let phase = (self.phase + PI).rem_euclid(TAU) - PI;
        if phase.abs() < 1e-12 {
            return Ok(resonance);
        }
        if PI - phase.abs() < 1e-12 {
            return Ok(resonance.scaled(-1.0));
        }
        let half = (0.5 * phase.abs()).tan();
        // (c − s)/(c + s), c = ω₀/tan(|ψ|/2);  (s − c)/(s + c), c = ω₀ tan(ψ/2)
        let turn = if phase < 0.0 {
            TransferFunction::new(&[-half, w], &[half, w])?
        } else {
            TransferFunction::new(&[1.0, -w * half], &[1.0, w * half])?
        };
        Ok(resonance.then(&turn))
    }
}

/// A body that vibrates: at most one angle and one acceleration an axis, all of one cause.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaken {
    /// φ_x, φ_y, φ_z: angles about the axes.
    pub angular: [Option<Vibration>; 3],
    /// a_x, a_y, a_z: accelerations along the axes.
    pub linear: [Option<Vibration>; 3],
    /// The part of each two that goes together, 0 to 1: the mean products of different vibrations are in proportion.
    pub coherence: f64,
}

impl Shaken {
    /// The filters of three axes; zero where nothing moves.
    pub(super) fn shapings(axes: &[Option<Vibration>; 3]) -> Result<[TransferFunction; 3]> {
        let one = |v: Option<Vibration>| v.map_or(Ok(TransferFunction::constant(0.0)), |v| v.shaping());
        Ok([one(axes[0])?, one(axes[1])?, one(axes[2])?])
    }

    /// The mean squares ⟨a²⟩ of the accelerations, m²/s⁴.
    ///
    /// # Errors
    /// As [`Vibration::shaping`].
    pub fn mean_squares(&self) -> Result<Vector> {
        let one = |w: &TransferFunction| w.variance().map(|i| i.value);
        let [x, y, z] = Self::shapings(&self.linear)?;
        Ok([one(&x)?, one(&y)?, one(&z)?])
    }

    /// ⟨y₁ y₂⟩ of two different vibrations, by their coherence.
    pub(super) fn product(&self, first: &TransferFunction, second: &TransferFunction) -> Result<f64> {
        let whole = cross_moment(&TransferFunction::constant(1.0), first, second)?;
        Ok(self.coherence * whole.value)
    }
}
