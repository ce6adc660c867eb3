//! Wind seas.

use crate::{Error, Result};
use std::f64::consts::PI;
use std::sync::OnceLock;

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
/// A8(12) (1973); JONSWAP is scaled by quadrature so that its
/// height is H_s: the usual 1 − 0.287 ln γ is 0.2 % off at γ = 3.3 and 39 % at 20.
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
                gamma.powf(bump) / enhancement(gamma)
            }
            _ => 1.0,
        };
        PI * bretschneider * enhanced
    }
}

/// Pieces of the range of u, between which the enhancement is smooth.
const PIECES: [f64; 7] = [0.0, 0.4, 0.7, 1.0, 1.5, 3.0, 30.0];
/// Chebyshev nodes in ln γ.
const COUNT: usize = 24;

/// By how much the enhancement raises H_s²: (5/4)∫ e^(−5u/4) γ^b du with u = (ω_p/ω)⁴ and the bump b, read from the
/// polynomial through Chebyshev's nodes over γ = 1 … 20.
fn enhancement(gamma: f64) -> f64 {
    static NODES: OnceLock<[[f64; 3]; COUNT]> = OnceLock::new();
    let half = 0.5 * 20f64.ln();
    // node x_k = cos θ_k, its weight (−1)^k sin θ_k in the barycentric formula, and the value there
    let node = |k: usize| {
        let angle = PI * (k as f64 + 0.5) / COUNT as f64;
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        [angle.cos(), sign * angle.sin(), raised((half * (1.0 + angle.cos())).exp())]
    };
    let x = gamma.ln() / half - 1.0;
    let (mut up, mut down) = (0.0, 0.0);
    for [at, weight, value] in NODES.get_or_init(|| std::array::from_fn(node)) {
        if x == *at {
            return *value;
        }
        up += weight / (x - at) * value;
        down += weight / (x - at);
    }
    up / down
}

fn raised(gamma: f64) -> f64 {
    let at = |u: f64| {
        let x = u.max(f64::MIN_POSITIVE).powf(-0.25);
        let sigma = if x <= 1.0 { 0.07 } else { 0.09 };
        1.25 * (-1.25 * u).exp() * gamma.powf((-0.5 * ((x - 1.0) / sigma).powi(2)).exp())
    };
    PIECES.windows(2).map(|p| quadrature::double_exponential::integrate(at, p[0], p[1], 1e-13).integral).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// K(0) = H_s²/16 of what the density holds: sums over a fine grid of ω.
    #[test]
    fn every_sea_has_its_height() {
        for gamma in [1.0, 1.7, 3.3, 7.0, 12.3, 20.0] {
            let sea = Sea::Jonswap { height: 3.0, peak: 0.7, gamma };
            let step = 1e-4;
            let sum: f64 = (0..400_000).map(|k| sea.density((f64::from(k) + 0.5) * step)).sum();
            let wanted = PI * 9.0 / 16.0;
            assert!((sum * step / wanted - 1.0).abs() < 1e-6, "{gamma} {}", sum * step / wanted);
        }
    }
}
