//! # Purpose
//! The sculling acceleration: what an angle about one axis and an acceleration along another, in phase, make along the
//! third.
//!
//! # Method
//! v̇ = a + φ × a along axes at rest, to first order in φ, so that a system that does not follow φ within its step leaves
//! out ⟨φ × a⟩. With ν̇ = a this is ½⟨φ × ν̇ + ν × φ̇⟩, the usual form, for in what is stationary ⟨ν × φ̇⟩ = ⟨φ × ν̇⟩.
//! Sines of amplitudes φ₀ and a₀ in phase: ½ φ₀ a₀.
//!
//! # References
//! P. G. Savage, Strapdown inertial navigation integration algorithm design, part 2: velocity and position, J. Guidance
//! 21 (1998) 208–221; D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd edition (2004),
//! section 11.3.

use super::{Shaken, Vector};
use crate::Result;

/// ⟨φ × a⟩, m/s²: what a sculling correction adds. Without one the accelerometers read its opposite in the mean.
///
/// # Errors
/// As [`Vibration::shaping`](super::Vibration::shaping).
pub fn sculling(shaken: &Shaken) -> Result<Vector> {
    let (phi, a) = (Shaken::shapings(&shaken.angular)?, Shaken::shapings(&shaken.linear)?);
    // ⟨φ_y a_z⟩ − ⟨φ_z a_y⟩ and so on round
    let along = |first: usize, second: usize| -> Result<f64> {
        Ok(shaken.product(&phi[first], &a[second])? - shaken.product(&phi[second], &a[first])?)
    };
    Ok([along(1, 2)?, along(2, 0)?, along(0, 1)?])
}
