//! The rolling errors of the paper: regular (2.4), irregular as derived, and as printed.
//!
//! Reference: A. E. Potemkin, "Application of identification methods to the errors of
//! two-rotor gyrocompasses on a rolling base" (1978), equations (2.1)–(3.13). Errata:
//!
//! - The printed irregular formula is too small by exactly 2π: (3.4) is a density for
//!   K = ∫ S e^{jωτ} dω, yet (3.7), (3.9), (3.12) divide by 2π. The factor must be
//!   P²/(2HUC₀g²), not P²/(4πHUC₀g²). For μ → 0 the right one turns into (2.4).
//! - Example 3.1 does not follow from its own formula, which gives −0.716°, not −0.75°.
//! - The last term of the denominator of (3.4), (3.6) is b⁴; 9.81² in Example 3.1 is 981².

use super::Gyrosphere;
use crate::Result;
use crate::integral::Integral;
use crate::lti::{TransferFunction, cross_moment};
use crate::spectrum::Roll;
use std::f64::consts::PI;

/// Regular roll: θ = θ₀ sin pt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regular {
    /// θ₀, rad.
    pub amplitude: f64,
    /// p, rad/s.
    pub frequency: f64,
}

/// The constant error on regular roll, rad, (2.4); heading K in rad.
///
/// ```
/// use gyrospec::gyro::{Gyrosphere, seed};
/// let sphere = Gyrosphere { lever: 0.235, ..Gyrosphere::seed() };     // θ₀h = 23.5 cm
/// let roll = seed::Regular { amplitude: 1.0, frequency: 0.98 };
/// let error = seed::regular_error(&sphere, &roll, 200f64.to_radians());
/// assert!((error.to_degrees() + 0.2824).abs() < 5e-5);                 // Example 2.1
/// ```
pub fn regular_error(sphere: &Gyrosphere, roll: &Regular, heading: f64) -> f64 {
    let (p, t) = (roll.frequency, sphere.lag);
    // α = −P²θ₀²h²p⁴ sin 2K/(4 C₀ (1 + p²T²) H U g² cos φ)
    let squared = 0.5 * (roll.amplitude * p * p).powi(2) / (1.0 + (p * t).powi(2));
    -sphere.rectifier() * squared * (2.0 * heading).sin()
}

/// ⟨θ̈ · θ̈/(1 + T s)⟩, rad²/s⁴, of irregular roll through the elastic lag, by I₃.
///
/// # Errors
/// `OutOfRange` for T = 0 on this roll, whose acceleration has infinite variance.
pub fn rectified_moment(roll: &Roll, lag: f64) -> Result<Integral> {
    let acceleration = roll.shaping().differentiated()?.differentiated()?;
    let yielding = TransferFunction::new(&[1.0], &[lag, 1.0])?;
    cross_moment(&acceleration, &TransferFunction::constant(1.0), &yielding)
}

/// The mean error on irregular roll, rad, as derived; heading K in rad.
///
/// ```
/// use gyrospec::gyro::{Gyrosphere, seed};
/// use gyrospec::spectrum::Roll;
/// let sphere = Gyrosphere { latitude: 60f64.to_radians(), ..Gyrosphere::seed() };
/// let roll = Roll::new(3.0e-2, 0.1, 0.8).unwrap();
/// let error = seed::irregular_error(&sphere, &roll, 45f64.to_radians()).unwrap();
/// assert!((error.to_degrees() + 4.497).abs() < 5e-4);                  // Example 3.1
/// ```
///
/// # Errors
/// As [`rectified_moment`].
pub fn irregular_error(sphere: &Gyrosphere, roll: &Roll, heading: f64) -> Result<f64> {
    Ok(error_of_moment(sphere, rectified_moment(roll, sphere.lag)?.value, heading))
}

/// The mean error, rad, that a rectified moment ⟨θ̈ · θ̈/(1 + T s)⟩ (rad²/s⁴) causes.
pub fn error_of_moment(sphere: &Gyrosphere, moment: f64, heading: f64) -> f64 {
    // α = −P²h² ⟨θ̈·lagged θ̈⟩ sin 2K/(2 g² H U C₀ cos φ)
    -sphere.rectifier() * moment * (2.0 * heading).sin()
}

/// The same by the closed form, with the factor put right.
pub fn irregular_error_closed(sphere: &Gyrosphere, roll: &Roll, heading: f64) -> f64 {
    let (t, mu, eps, b2) = (sphere.lag, roll.decay, roll.frequency, roll.b2());
    // A b²(2μ + b²T)/(T [T²ε² + (1 + μT)²])
    let moment =
        roll.variance * b2 * (2.0 * mu + b2 * t) / (t * ((t * eps).powi(2) + (1.0 + mu * t).powi(2)));
    -sphere.rectifier() * moment * (2.0 * heading).sin()
}

/// The formula as the paper prints it: 2π too small.
pub fn irregular_error_as_printed(sphere: &Gyrosphere, roll: &Roll, heading: f64) -> f64 {
    irregular_error_closed(sphere, roll, heading) / (2.0 * PI)
}

/// The number that Example 3.1 prints, degrees; its own formula gives −0.716°.
pub const EXAMPLE_3_1_IN_PRINT: f64 = -0.75;

/// Example 2.1: the compass, its roll and the heading (rad).
pub fn example_2_1() -> (Gyrosphere, Regular, f64) {
    let sphere = Gyrosphere { lever: 0.235, ..Gyrosphere::seed() };
    (sphere, Regular { amplitude: 1.0, frequency: 0.98 }, 200f64.to_radians())
}

/// Example 3.1: the compass, its roll and the heading (rad).
pub fn example_3_1() -> (Gyrosphere, Roll, f64) {
    let sphere = Gyrosphere { latitude: 60f64.to_radians(), ..Gyrosphere::seed() };
    let roll = Roll { variance: 3.0e-2, decay: 0.1, frequency: 0.8 };
    (sphere, roll, 45f64.to_radians())
}
