//! # Purpose
//! The spread of the heading of a loop that seeks north, by the angle random walk of its gyros and by the sea, and of a
//! heading found by averaging on a base at rest.
//!
//! # Method
//! The tilt β about the east axis shows what the east gyro reads of the Earth's rate, and turns the loop:
//! β̇ = −U cos φ·α − k₁(β + W₂/g) + ε_E,  α̇ = k₂(β + W₂/g) + ε_D,  k₁ = 2ζω_n, k₂ = ω_n²/(U cos φ),
//! with ε_E and ε_D white of intensity N². Over H(s) = s² + k₁s + ω_n²
//!   α = (k₂ ε_E + (s + k₁) ε_D + k₂ s W₂/g)/H, so that
//!   ⟨α²⟩ = N²ω_n/(4ζ(U cos φ)²) + N²(1 + 4ζ²)/(4ζω_n) + the integral I₄ of W₂ = h θ̈ sin K by the roll's spectrum.
//! The mean of an east rate over a time t has the variance N²/t: σ = N/(U cos φ √t).
//!
//! # References
//! K. R. Britting, Inertial Navigation Systems Analysis (1971), chapter 9 (self-alignment); D. H. Titterton,
//! J. L. Weston, Strapdown Inertial Navigation Technology, 2nd edition (2004), section 10.3; IEEE Std 952, angle random walk.

use crate::Result;
use crate::lti::TransferFunction;
use crate::spectrum::Roll;

/// A loop that seeks north.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NorthSeeking {
    /// ω_n, rad/s.
    pub frequency: f64,
    /// ζ.
    pub damping: f64,
    /// U cos φ, rad/s.
    pub north_rate: f64,
}

/// What the sea does to an instrument that rolls with its ship.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seaway {
    /// θ.
    pub roll: Roll,
    /// h, height above the roll axis, m.
    pub lever: f64,
    /// K, rad.
    pub heading: f64,
    /// g, m/s².
    pub gravity: f64,
}

impl NorthSeeking {
    /// H(s) = s² + k₁s + ω_n², descending.
    fn denominator(&self) -> [f64; 3] {
        [1.0, 2.0 * self.damping * self.frequency, self.frequency * self.frequency]
    }

    /// k₂ = ω_n²/(U cos φ), 1/s.
    fn gain(&self) -> f64 {
        self.frequency * self.frequency / self.north_rate
    }

    /// σ of the heading by angle random walk N (rad/√s) of the east and the vertical gyro, rad.
    ///
    /// ```
    /// use gyrospec::gyro::strapdown::NorthSeeking;
    /// let (w, zeta, north) = (0.02, 0.7, 5e-5);
    /// let spread = NorthSeeking { frequency: w, damping: zeta, north_rate: north }.by_walk(1e-6)?;
    /// let closed = w / (4.0 * zeta * north * north) + (1.0 + 4.0 * zeta * zeta) / (4.0 * zeta * w);
    /// assert!((spread / (1e-6 * closed.sqrt()) - 1.0).abs() < 1e-14);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`TransferFunction::variance`], where the loop does not settle.
    pub fn by_walk(&self, walk: f64) -> Result<f64> {
        let h = self.denominator();
        // k₂/H and (s + k₁)/H
        let east = TransferFunction::new(&[self.gain()], &h)?.variance()?.value;
        let vertical = TransferFunction::new(&[1.0, h[1]], &h)?.variance()?.value;
        Ok(walk * (east + vertical).sqrt())
    }

    /// σ of the heading by the acceleration along the meridian W₂ = h θ̈ sin K, rad.
    ///
    /// # Errors
    /// As [`TransferFunction::variance`], where the loop does not settle.
    pub fn by_sea(&self, sea: &Seaway) -> Result<f64> {
        let shaping = sea.roll.shaping();
        // k₂ (h sin K/g) s³ F/H
        let gain = self.gain() * sea.lever * sea.heading.sin() / sea.gravity * shaping.numerator()[0];
        let h = crate::poly::product(&self.denominator(), shaping.denominator());
        Ok(TransferFunction::new(&[gain, 0.0, 0.0, 0.0], &h)?.variance()?.value.sqrt())
    }
}

/// σ of a heading found on a base at rest from rates averaged over `time` (s) with angle random walk N (rad/√s), rad.
pub fn aligned(walk: f64, time: f64, north_rate: f64) -> f64 {
    // N/(U cos φ √t)
    walk / (north_rate * time.sqrt())
}
