//! # Purpose
//! How far a result leaves what the linear theory is linear in.
//!
//! # Method
//! (2.1)–(2.3) are of first order in the roll's angle, in W/g (the apparent vertical's tilt), in x/l (the lean of the
//! sphere by its own shift, l = lP/P the arm of the pendulum), in α and in the swing of α. What is left out is of
//! second order: at 0.3 it is a tenth. A mean error α turns the axes along which W₁ and W₂ are taken, so that sin 2K
//! becomes sin 2(K + α): at 10° a third of the error between the intercardinal headings.
//!
//! A sea is no longer one of linear waves where they break: no wave in deep water is steeper than H/λ = 0.142.
//!
//! # References
//! J. H. Michell, The highest waves in water, Philosophical Magazine (5) 36 (1893) 430–437.
//!
//! # Numerical aspects
//! Where an acceleration has a white tail, its variance is infinite and not judged; on a regular roll, the limit of
//! ever narrower irregular roll, it is σ(θ̇)²/σ(θ).

use super::motion::deviation;
use super::{Axis, HeadingError, Instrument, Motion};
use crate::lti::stationary_covariance;
use crate::spectrum::Sea;
use crate::units::{figure, significant};
use crate::{Error, ErrorKind, Result};

/// A mean error from which on the linear theory gives no number at all, rad: 45°.
pub const LARGEST_MEAN: f64 = std::f64::consts::FRAC_PI_4;

/// One figure that the linear theory takes for small.
#[derive(Debug, Clone, PartialEq)]
pub struct Smallness {
    /// Its name in a report: `mean`, `spread`, `roll`, `acceleration`, `shift`, `latitude` or `steepness`.
    pub figure: &'static str,
    /// What it is, in words.
    pub message: &'static str,
    /// Its size, in `unit`; infinite where the motion gives it no end.
    pub value: f64,
    /// Up to where the theory holds.
    pub limit: f64,
    /// `deg`, or `1` for a ratio.
    pub unit: &'static str,
}

impl Smallness {
    /// Whether it can be judged: no infinite figure can, since it says nothing of the ship.
    pub fn is_judged(&self) -> bool {
        self.value.is_finite()
    }

    /// Whether the theory holds.
    pub fn holds(&self) -> bool {
        self.value.abs() <= self.limit
    }

    /// The figure in words: `mean error −14.9° (it holds to 10°)`.
    pub fn told(&self) -> String {
        let unit = if self.unit == "deg" { "°" } else { "" };
        let (value, limit) = (significant(self.value, 3), figure(self.limit));
        format!("{} {value}{unit} (it holds to {limit}{unit})", self.message)
    }
}

/// −10° … 10°, and the like.
const MEAN: f64 = 10.0;
/// Of ratios, and of angles in rad: the square is a tenth.
const RATIO: f64 = 0.3;
/// Above it the Earth's rate has less than a sixth of its horizontal part, degrees.
const NORTH: f64 = 80.0;

/// Michell's limit, H/λ of the highest wave in deep water.
const HIGHEST: f64 = 0.142;

/// Whether the waves of a sea can be as steep as they would have to be, by significant height and length at the peak.
///
/// ```
/// use gyrospec::{gyro::validity::steepness, spectrum::Sea};
/// assert!(steepness(&Sea::PiersonMoskowitz { height: 9.0 }).holds());
/// // 8 m of height on 25 m of length
/// assert!(!steepness(&Sea::Bretschneider { height: 8.0, peak: std::f64::consts::TAU / 4.0 }).holds());
/// ```
pub fn steepness(sea: &Sea) -> Smallness {
    Smallness {
        figure: "steepness",
        message: "height of the waves against their length, which break beyond Michell's limit,",
        value: sea.steepness(),
        limit: HIGHEST,
        unit: "1",
    }
}

/// Refuses a mean error that no linear theory gives.
///
/// # Errors
/// `OutOfRange` beyond [`LARGEST_MEAN`].
pub fn bounded(mean: f64) -> Result<()> {
    if mean.abs() <= LARGEST_MEAN {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::OutOfRange,
        format!(
            "the linear theory would give a mean error of {:.1}°, but it holds to about 10°: there is no number for it",
            mean.to_degrees()
        ),
    )
    .with_hint("no gyrocompass shows north on such a motion; look at the roll, the lever and the units"))
}

impl Instrument {
    /// What the theory takes for small, and how small it is on this motion and heading, where the error is as told.
    ///
    /// # Errors
    /// As [`Instrument::error`].
    pub fn smallness(&self, motion: &Motion, heading: f64, error: &HeadingError) -> Result<Vec<Smallness>> {
        self.figures(motion, heading, error, false)
    }

    /// The same on a regular roll, `motion` being the narrow irregular roll that stands for it.
    ///
    /// # Errors
    /// As [`Instrument::error`].
    pub fn regular_smallness(
        &self,
        motion: &Motion,
        heading: f64,
        error: &HeadingError,
    ) -> Result<Vec<Smallness>> {
        self.figures(motion, heading, error, true)
    }

    fn figures(
        &self,
        motion: &Motion,
        heading: f64,
        error: &HeadingError,
        regular: bool,
    ) -> Result<Vec<Smallness>> {
        let (roll, acceleration) = swing(motion, self.sphere.lever, regular)?;
        let s = &self.sphere;
        let arm = s.pendulous / s.weight;
        let degrees =
            |figure, message, value: f64, limit| Smallness { figure, message, value, limit, unit: "deg" };
        let ratio = |figure, message, value| Smallness { figure, message, value, limit: RATIO, unit: "1" };
        Ok(vec![
            degrees("mean", "mean error", error.mean().to_degrees(), MEAN),
            degrees("spread", "swing of the error", error.deviation.to_degrees(), MEAN),
            degrees("roll", "standard deviation of roll or pitch", roll.to_degrees(), RATIO.to_degrees()),
            ratio(
                "acceleration",
                "horizontal acceleration at the compass against gravity",
                acceleration / s.gravity,
            ),
            ratio(
                "shift",
                "shift of the centre of mass against the pendulum's arm lP/P",
                self.shift(motion, heading)? / arm,
            ),
            degrees("latitude", "latitude", s.latitude.to_degrees(), NORTH),
        ])
    }

    /// The standard deviation of the larger horizontal shift of the centre of mass, m.
    fn shift(&self, motion: &Motion, heading: f64) -> Result<f64> {
        let signals = self.signals(motion, heading)?;
        let q = &signals.noise * signals.noise.transpose();
        let sigma = stationary_covariance(&signals.fast, &q)?.matrix;
        let horizontal = signals.shift.iter().take(2).flatten();
        Ok(horizontal.map(|x| deviation(&sigma, &x.state)).fold(0.0, f64::max))
    }
}

/// The larger standard deviation of roll and pitch, rad, and that of the horizontal acceleration at a lever, m/s².
fn swing(motion: &Motion, lever: f64, regular: bool) -> Result<(f64, f64)> {
    let sigma = motion.system().state_covariance()?.matrix;
    let (mut largest, mut square) = (0.0f64, 0.0);
    for (axis, arm) in [(Axis::Roll, lever), (Axis::Pitch, lever), (Axis::Sway, 1.0), (Axis::Surge, 1.0)] {
        let of = |order| motion.derivative(axis, order);
        let size = deviation(&sigma, &of(0)?.state);
        if matches!(axis, Axis::Roll | Axis::Pitch) {
            largest = largest.max(size);
        }
        let second = of(2)?;
        let acceleration = match second.is_white() {
            true if regular && size > 0.0 => deviation(&sigma, &of(1)?.state).powi(2) / size,
            true => f64::INFINITY,
            false => deviation(&sigma, &second.state),
        };
        square += if arm == 0.0 { 0.0 } else { (arm * acceleration).powi(2) };
    }
    Ok((largest, square.sqrt()))
}
