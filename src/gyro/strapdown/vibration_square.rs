//! # Purpose
//! The bias of accelerometers whose output has a square term (vibration rectification).
//!
//! # Method
//! An accelerometer that reads a + k₂a² reads k₂⟨a²⟩ of a vibration in the mean: ½ k₂ p² of a sine of amplitude p.
//!
//! # References
//! IEEE Std 1293, Specification format guide and test procedure for linear single-axis, nongyroscopic accelerometers:
//! K₂ of the model equation and the vibration rectification error.

use super::{Shaken, Vector};
use crate::Result;

/// k₂⟨a²⟩ along each axis, m/s², for k₂ in s²/m.
///
/// # Errors
/// As [`Shaken::mean_squares`].
pub fn square_term(k2: f64, shaken: &Shaken) -> Result<Vector> {
    Ok(shaken.mean_squares()?.map(|square| k2 * square))
}
