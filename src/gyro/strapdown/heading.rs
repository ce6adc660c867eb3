//! # Purpose
//! The heading that a system finds by gyrocompassing: north is where the Earth's rate has its horizontal part.
//!
//! # Method
//! The system takes its specific force for the vertical and its rate for the Earth's. With a drift ε and a bias ∇ its
//! north lies west of true north by α = −ε_E/(U cos φ) + (∇_E/g) tan φ, and its vertical is off by ∇/g.
//! East is x sin K + y cos K of a level body on heading K.
//!
//! # References
//! D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd edition (2004), section 10.3
//! (gyrocompassing); the sign as in `gyro::SIGN`.

use super::Vector;

/// U, rad/s (WGS 84).
pub const EARTH_RATE: f64 = 7.292_115e-5;
/// g, m/s², the standard.
pub const GRAVITY: f64 = 9.806_65;

/// A heading found by gyrocompassing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// α, rad, west positive as of every compass here.
    pub error: f64,
    /// ε_E, rad/s.
    pub east_drift: f64,
    /// ∇_E, m/s².
    pub east_bias: f64,
}

/// The error of a heading found with a mean drift (rad/s) and a mean bias (m/s²) along the body's axes, on heading K
/// (rad) at latitude φ (rad), with the Earth's rate U (rad/s) and gravity g (m/s²).
///
/// ```
/// use gyrospec::gyro::strapdown::by_gyrocompassing;
/// // 0.01 °/h of east gyro drift at 60°: 0.076°
/// let drift = [0.0, 0.01f64.to_radians() / 3600.0, 0.0];
/// let found = by_gyrocompassing(drift, [0.0; 3], [0.0, 60f64.to_radians()], [7.292e-5, 9.81]);
/// assert!((found.error.to_degrees() + 0.0762).abs() < 1e-4);
/// ```
pub fn by_gyrocompassing(
    drift: Vector,
    bias: Vector,
    [heading, latitude]: [f64; 2],
    earth: [f64; 2],
) -> Found {
    let (sin, cos) = heading.sin_cos();
    let east = |v: Vector| v[0] * sin + v[1] * cos;
    let ([rate, gravity], east_drift, east_bias) = (earth, east(drift), east(bias));
    // α = −ε_E/(U cos φ) + (∇_E/g) tan φ
    let error = -east_drift / (rate * latitude.cos()) + east_bias / gravity * latitude.tan();
    Found { error, east_drift, east_bias }
}
