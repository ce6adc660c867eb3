//! The compass left alone, as a navigator knows it.

use crate::Result;
use crate::gyro::{FreeMotion, Gyrosphere};

/// Periods and settling by latitude, and what a sudden change of speed does.
#[derive(Debug, Clone)]
pub struct LeftAlone {
    /// Latitude, rad, and the free motion there: 0 to 80°.
    pub by_latitude: Vec<(f64, FreeMotion)>,
    /// At the compass's own latitude.
    pub here: FreeMotion,
    /// The sudden change of northward speed, m/s.
    pub change: f64,
    /// By how much it throws the compass at once, rad.
    pub thrown: f64,
    /// Time, s, and size, rad, of the largest deviation from the new steady error.
    pub largest: (f64, f64),
    /// The time after which it stays within 0.1°, s.
    pub settled: f64,
}

/// A day of the compass left alone after a sudden change of northward speed, m/s.
///
/// ```
/// use gyrospec::{Gyrosphere, rolling::left_alone};
/// let day = left_alone(&Gyrosphere::seed(), 5.0)?;
/// assert!(day.thrown.abs() > 0.0 && day.settled < 86400.0);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// As [`Gyrosphere::free_motion`].
pub fn left_alone(sphere: &Gyrosphere, change: f64) -> Result<LeftAlone> {
    let at = |latitude: f64| Gyrosphere { latitude, ..*sphere }.free_motion();
    let by_latitude = (0..=80)
        .step_by(10)
        .map(|degrees| {
            let latitude = f64::from(degrees).to_radians();
            Ok((latitude, at(latitude)?))
        })
        .collect::<Result<_>>()?;
    let deviations = sphere.ballistic(change, 60.0, 24 * 60)?;
    let largest = deviations.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let late = deviations.iter().rev().find(|p| p.1.abs() > 0.1f64.to_radians());
    Ok(LeftAlone {
        by_latitude,
        here: at(sphere.latitude)?,
        change,
        thrown: sphere.pendulous * change / (sphere.momentum * sphere.gravity),
        largest: largest.copied().unwrap_or((0.0, 0.0)),
        settled: late.map_or(0.0, |p| p.0),
    })
}
