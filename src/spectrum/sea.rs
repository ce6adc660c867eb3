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

    /// The same sea of another H_s, m; the peak of a fully grown one goes with it.
    #[must_use]
    pub fn of_height(self, height: f64) -> Self {
        match self {
            Self::PiersonMoskowitz { .. } => Self::PiersonMoskowitz { height },
            Self::Bretschneider { peak, .. } => Self::Bretschneider { height, peak },
            Self::Jonswap { peak, gamma, .. } => Self::Jonswap { height, peak, gamma },
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

    /// H_s/λ with λ = 2πg/ω_p², the length in deep water of the waves at the peak.
    ///
    /// ```
    /// use gyrospec::spectrum::Sea;
    /// // 8 s: waves of 100 m
    /// let sea = Sea::Bretschneider { height: 3.0, peak: std::f64::consts::TAU / 8.0 };
    /// assert!((sea.steepness() - 0.03).abs() < 1e-4);
    /// ```
    pub fn steepness(&self) -> f64 {
        self.height() * self.peak().powi(2) / (2.0 * PI * GRAVITY)
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

/// How a ship moves in a long-crested sea: its slope athwart drives a damped resonance of roll, its slope along the
/// ship drives pitch, and waves shorter than the ship is long or wide along their travel are averaged out.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `frequency` | ω_φ, natural roll frequency | rad/s |
/// | `damping` | ζ_φ, ratio of critical damping | 1 |
/// | `slope` | χ, effective part of the wave slope | 1 |
/// | `beam` | B | m |
///
/// A sea from the bearing ν off the bow (clockwise: 0 ahead, π/2 from abeam to starboard) has the slope
/// σ = (−s²/g)ζ along its travel, of which −σ sin ν acts athwart and +σ cos ν along the ship; positive turns carry the
/// mast to port and forward. Heave is given the phase of the slope. Waves come at their own frequency: the speed of the
/// ship through them is not counted.
///
/// References: M. St. Denis, W. J. Pierson, Trans. SNAME 61 (1953) 280–357; E. V. Lewis (ed.), Principles of Naval
/// Architecture III (SNAME 1989), ch. VIII.
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
    /// The parts of a wave's slope athwart and along the ship, (−sin ν, cos ν); no part is a rounding error of 0.
    pub fn slopes(from: f64) -> (f64, f64) {
        let clean = |x: f64| if x.abs() < 1e-9 { 0.0 } else { x };
        (clean(-from.sin()), clean(from.cos()))
    }

    /// θ/ζ: φ̈ + 2ζ_φω_φφ̇ + ω_φ²φ = ω_φ² χ (−sin ν)(−s²/g) ζ/(1 + s/ω_L)², rad/m, in a sea from the bearing ν
    /// (rad, clockwise off the bow).
    ///
    /// # Errors
    /// `BadInput` when a number is not positive, or nothing of the slope lies athwart.
    pub fn roll_response(&self, from: f64) -> Result<TransferFunction> {
        let values = [self.frequency, self.damping, self.slope];
        if values.iter().any(|v| !(v.is_finite() && *v > 0.0)) {
            return Err(Error::bad_input("frequency, damping, slope and beam of a ship must be positive"));
        }
        let w2 = self.frequency * self.frequency;
        let resonance = TransferFunction::new(
            &[-excited(Self::slopes(from).0, "roll")? * w2 * self.slope / GRAVITY, 0.0, 0.0],
            &[1.0, 2.0 * self.damping * self.frequency, w2],
        )?;
        Ok(resonance.then(&self.averaged(from)?))
    }

    /// Pitch/ζ = cos ν (−s²/g)/(1 + s/ω_L)²: the wave's slope along the ship, rad/m.
    ///
    /// # Errors
    /// `BadInput` when the beam is not positive, or nothing of the slope lies along the ship.
    pub fn pitch_response(&self, from: f64) -> Result<TransferFunction> {
        let along = excited(Self::slopes(from).1, "pitch")?;
        TransferFunction::new(&[-along / GRAVITY, 0.0, 0.0], self.averaged(from)?.denominator())
    }

    /// Heave/ζ = 1/(1 + s/ω_L)²: the wave's height, m/m.
    ///
    /// # Errors
    /// `BadInput` when the beam is not positive.
    pub fn heave_response(&self, from: f64) -> Result<TransferFunction> {
        self.averaged(from)
    }

    /// 1/(1 + s/ω_L)², ω_L² = 2g/L: waves shorter than the ship's extent L = B|sin ν| + 6B|cos ν| along their travel
    /// averaged out, of a ship of six beams.
    fn averaged(&self, from: f64) -> Result<TransferFunction> {
        if !(self.beam.is_finite() && self.beam > 0.0) {
            return Err(Error::bad_input("frequency, damping, slope and beam of a ship must be positive"));
        }
        let (athwart, along) = Self::slopes(from);
        let extent = self.beam * (athwart.abs() + 6.0 * along.abs());
        let corner = (2.0 * GRAVITY / extent).sqrt();
        TransferFunction::new(&[1.0], &[1.0 / (corner * corner), 2.0 / corner, 1.0])
    }
}

/// A part of the slope that is there.
fn excited(part: f64, what: &str) -> Result<f64> {
    if part != 0.0 {
        return Ok(part);
    }
    Err(Error::bad_input(format!("a sea from there has no slope that excites {what}")))
}
