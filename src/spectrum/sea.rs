//! Wind seas.

use crate::{Error, Result};
use std::f64::consts::PI;

/// g, m/s².
pub(crate) const GRAVITY: f64 = 9.81;

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
        /// Peak enhancement γ over the Pierson-Moskowitz form, 1 to 20.
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
            let (height, peak) = (self.height(), self.peak());
            return Err(Error::bad_input(format!(
                "a sea needs a positive height and a positive peak, not {height} m and {peak} rad/s"
            )));
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
