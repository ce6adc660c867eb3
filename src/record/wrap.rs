//! Angles that wrap at a turn.

use std::f64::consts::TAU;

/// Adds whole turns so that no two neighbours differ by more than half a turn; gaps (NaN) are
/// stepped over. Radians.
///
/// ```
/// use std::f64::consts::TAU;
/// let mut heading = [6.2, f64::NAN, 0.1, 6.2];
/// gyrospec::record::unwrap(&mut heading);
/// assert_eq!(heading[2], 0.1 + TAU);
/// assert_eq!(heading[3], 6.2);
/// ```
pub fn unwrap(angles: &mut [f64]) {
    let mut turns = 0.0;
    let mut previous = f64::NAN;
    for angle in angles.iter_mut().filter(|a| !a.is_nan()) {
        let raw = *angle;
        if !previous.is_nan() {
            turns -= ((raw - previous) / TAU).round();
        }
        previous = raw;
        *angle = raw + turns * TAU;
    }
}

/// The angle less whole turns, from −π to π, rad: how far two headings lie apart, say.
///
/// ```
/// use std::f64::consts::TAU;
/// assert!((gyrospec::record::principal(0.1 - 6.2) - (0.1 - 6.2 + TAU)).abs() < 1e-15);
/// assert_eq!(gyrospec::record::principal(3.0), 3.0);
/// ```
pub fn principal(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
