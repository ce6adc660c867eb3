//! # Purpose
//! The coning rate of an angular vibration: the rate about the third axis that rotations about two axes in quadrature
//! make, and that a system without a coning correction leaves out.
//!
//! # Method
//! The rotation vector φ obeys φ̇ = ω + ½φ × ω + …, so that the mean rate that the gyros read of a φ that comes back is
//! ⟨ω⟩ = −½⟨φ × φ̇⟩ to second order. For a stationary φ the two terms of the product are equal:
//! ½⟨φ_x φ̇_y − φ_y φ̇_x⟩ = ⟨φ_x φ̇_y⟩, the mean that the quadrature part of the cross-spectrum leaves.
//! Two sines of amplitudes a and b in quadrature: ½ a b ω.
//!
//! # References
//! J. E. Bortz, A new mathematical formulation for strapdown inertial navigation, IEEE Trans. AES-7 (1971) 61–66, the
//! equation of φ; R. B. Miller, A new strapdown attitude algorithm, J. Guidance 6 (1983) 287–291, and M. B. Ignagni,
//! Optimal strapdown attitude integration algorithms, J. Guidance 13 (1990) 363–369, coning and its correction.
//!
//! # Numerical aspects
//! What is left out is of fourth order in the angle: of a cone of half angle a the rate is ω(1 − cos a), by a²/12 of
//! itself less.

use super::{Shaken, Vector};
use crate::Result;
use crate::lti::{TransferFunction, cross_rate_moment};

/// ½⟨φ × φ̇⟩, rad/s: what a coning correction adds. Without one the gyros read its opposite in the mean.
///
/// ```
/// use gyrospec::gyro::strapdown::{Shaken, Vibration, coning};
/// let about = |phase: f64| Some(Vibration { deviation: 1e-3, phase, frequency: 200.0, damping: 1e-6 });
/// let quadrature = [about(0.0), about(-std::f64::consts::FRAC_PI_2), None];
/// let rate = coning(&Shaken { angular: quadrature, linear: [None; 3], coherence: 1.0 })?;
/// // ½ a b ω with a = b = √2 σ
/// assert!((rate[2] / (1e-6 * 200.0) - 1.0).abs() < 1e-5 && rate[0] == 0.0);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// As [`Vibration::shaping`](super::Vibration::shaping) and [`cross_rate_moment`].
pub fn coning(shaken: &Shaken) -> Result<Vector> {
    let [x, y, z] = Shaken::shapings(&shaken.angular)?;
    // ⟨φ_y φ̇_z⟩, ⟨φ_z φ̇_x⟩, ⟨φ_x φ̇_y⟩
    let about = |first: &TransferFunction, second: &TransferFunction| -> Result<f64> {
        let rate = cross_rate_moment(&TransferFunction::constant(1.0), first, second)?;
        Ok(shaken.coherence * rate.value)
    };
    Ok([about(&y, &z)?, about(&z, &x)?, about(&x, &y)?])
}
