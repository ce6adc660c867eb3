//! Wind seas and a ship's roll in them.

use crate::lti::TransferFunction;
use crate::{Error, Result};
use std::f64::consts::PI;

const GRAVITY: f64 = 9.81;

/// The spectrum of a wind sea's surface.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `height` | H_s, significant wave height | m |
/// | `peak` | ω_p, frequency of the peak | rad/s |
/// | `gamma` | γ, peakedness | 1 |
///
/// References: W. J. Pierson, L. Moskowitz, J. Geophys. Res. 69 (1964) 5181; C. L.
/// Bretschneider, Beach Erosion Board TM 118 (1959); K. Hasselmann et al., Dtsch. Hydrogr. Z.
/// A8(12) (1973); the normalisation of JONSWAP to H_s after DNV-RP-C205.
///
/// ```
/// use gyrospec::spectrum::Sea;
/// let sea = Sea::PiersonMoskowitz { height: 3.0 };
/// assert!((sea.peak() - 0.401 * (9.81f64 / 3.0).sqrt()).abs() < 2e-3);   // fully grown
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sea {
    /// The fully grown sea, by its height alone.
    PiersonMoskowitz {
        /// H_s, m.
        height: f64,
    },
    /// Two parameters: height and peak.
    Bretschneider {
        /// H_s, m.
        height: f64,
        /// ω_p, rad/s.
        peak: f64,
    },
    /// The young, peaked sea of the North Sea.
    Jonswap {
        /// H_s, m.
        height: f64,
        /// ω_p, rad/s.
        peak: f64,
        /// γ.
        gamma: f64,
    },
}

impl Sea {
    /// H_s, m.
    pub fn height(&self) -> f64 {
        match *self {
            Self::PiersonMoskowitz { height }
            | Self::Bretschneider { height, .. }
            | Self::Jonswap { height, .. } => height,
        }
    }

    /// ω_p, rad/s.
    pub fn peak(&self) -> f64 {
        match *self {
            // S = αg²ω⁻⁵ exp(−5/4 (ω_p/ω)⁴), α = 0.0081, H_s²/16 = αg²/(5ω_p⁴)
            Self::PiersonMoskowitz { height } => {
                (16.0 * 0.0081 * GRAVITY * GRAVITY / (5.0 * height * height)).powf(0.25)
            }
            Self::Bretschneider { peak, .. } | Self::Jonswap { peak, .. } => peak,
        }
    }

    /// Checks that the numbers describe a sea.
    ///
    /// # Errors
    /// `BadInput` for a height or peak that is not positive, or γ outside 1 … 20.
    pub fn check(&self) -> Result<()> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        if !positive(self.height()) || !positive(self.peak()) {
            return Err(Error::bad_input("a sea needs a positive height and a positive period"));
        }
        match *self {
            Self::Jonswap { gamma, .. } if !(1.0..=20.0).contains(&gamma) => {
                Err(Error::bad_input(format!("gamma of JONSWAP is {gamma}; it lies between 1 and 20")))
            }
            _ => Ok(()),
        }
    }

    /// The two-sided density of the surface elevation, m²·s, K(0) = H_s²/16.
    pub fn density(&self, omega: f64) -> f64 {
        let w = omega.abs();
        if w == 0.0 {
            return 0.0;
        }
        let (height, peak) = (self.height(), self.peak());
        // S₁(ω) = (5/16) H_s² ω_p⁴ ω⁻⁵ exp(−5/4 (ω_p/ω)⁴), one-sided; two-sided in our form: π S₁
        let ratio = (peak / w).powi(4);
        let bretschneider = 0.3125 * height * height * ratio / w * (-1.25 * ratio).exp();
        let enhanced = match *self {
            Self::Jonswap { gamma, .. } => {
                let sigma = if w <= peak { 0.07 } else { 0.09 };
                let bump = (-0.5 * ((w - peak) / (sigma * peak)).powi(2)).exp();
                // 1 − 0.287 ln γ keeps H_s
                (1.0 - 0.287 * gamma.ln()) * gamma.powf(bump)
            }
            _ => 1.0,
        };
        PI * bretschneider * enhanced
    }
}

/// How a ship rolls in a beam sea: one damped resonance, driven by the wave's slope, with
/// waves shorter than the ship is wide averaged out.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `frequency` | ω_φ, natural roll frequency | rad/s |
/// | `damping` | ζ_φ, ratio of critical damping | 1 |
/// | `slope` | χ, effective part of the wave slope | 1 |
/// | `beam` | B | m |
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hull {
    /// ω_φ, rad/s.
    pub frequency: f64,
    /// ζ_φ.
    pub damping: f64,
    /// χ.
    pub slope: f64,
    /// B, m.
    pub beam: f64,
}

impl Default for Hull {
    /// A freighter of 15 m beam that rolls with a period of 9 s.
    fn default() -> Self {
        Self { frequency: 0.7, damping: 0.08, slope: 0.7, beam: 15.0 }
    }
}

impl Hull {
    /// θ/ζ: φ̈ + 2ζ_φω_φφ̇ + ω_φ²φ = ω_φ² χ (−s²/g) ζ/(1 + s/ω_B)², ω_B² = 2g/B; rad/m.
    ///
    /// # Errors
    /// `BadInput` when a number is not positive.
    pub fn roll_response(&self) -> Result<TransferFunction> {
        let values = [self.frequency, self.damping, self.slope, self.beam];
        if values.iter().any(|v| !(v.is_finite() && *v > 0.0)) {
            return Err(Error::bad_input("frequency, damping, slope and beam of a ship must be positive"));
        }
        let w2 = self.frequency * self.frequency;
        let short = (2.0 * GRAVITY / self.beam).sqrt();
        let resonance = TransferFunction::new(
            &[-w2 * self.slope / GRAVITY, 0.0, 0.0],
            &[1.0, 2.0 * self.damping * self.frequency, w2],
        )?;
        let averaged = TransferFunction::new(&[1.0], &[1.0 / (short * short), 2.0 / short, 1.0])?;
        Ok(resonance.then(&averaged))
    }

    /// Pitch/ζ = (−s²/g)/(1 + s/ω_L)²: the wave's slope along the ship, rad/m.
    ///
    /// # Errors
    /// `BadInput` when the beam is not positive.
    pub fn pitch_response(&self) -> Result<TransferFunction> {
        TransferFunction::new(&[-1.0 / GRAVITY, 0.0, 0.0], self.along_ship()?.denominator())
    }

    /// Heave/ζ = 1/(1 + s/ω_L)²: the wave's height, m/m.
    ///
    /// # Errors
    /// `BadInput` when the beam is not positive.
    pub fn heave_response(&self) -> Result<TransferFunction> {
        self.along_ship()
    }

    /// 1/(1 + s/ω_L)², ω_L² = 2g/(6B): waves shorter than a ship of six beams averaged out.
    fn along_ship(&self) -> Result<TransferFunction> {
        let corner = (2.0 * GRAVITY / (6.0 * self.beam)).sqrt();
        TransferFunction::new(&[1.0], &[1.0 / (corner * corner), 2.0 / corner, 1.0])
    }
}
