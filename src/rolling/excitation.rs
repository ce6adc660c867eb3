//! What moves the ship.

use crate::gyro::seed::Regular;
use crate::gyro::{Axis, Motion, range};
use crate::lti::TransferFunction;
use crate::spectrum::{Hull, RationalFit, Roll, Sea, fit_rational};
use crate::{Error, Result};

/// What moves the ship, and where its band ends.
#[derive(Debug, Clone)]
pub struct Excitation {
    /// The roll or the sea.
    pub source: Source,
    /// Two first-order low-passes on the motion at this frequency, rad/s.
    pub band: Option<f64>,
}

/// A roll, or a sea with the ship in it.
#[derive(Debug, Clone)]
pub enum Source {
    /// Of the paper's form (3.3).
    Irregular(Roll),
    /// A sine.
    Regular(Regular),
    /// Motions that answer one sea.
    Sea(Waves),
}

/// A sea and the ship in it.
#[derive(Debug, Clone)]
pub struct Waves {
    /// The sea.
    pub sea: Sea,
    /// The bearing from which it comes, rad, clockwise off the bow: 0 ahead, π/2 from abeam to starboard.
    pub from: f64,
    /// The ship.
    pub hull: Hull,
    /// Motions beside roll: pitch, heave, sway, surge, yaw.
    pub also: Vec<Axis>,
}

/// The motion that an excitation makes.
#[derive(Debug, Clone)]
pub struct ShipMotion {
    /// The motion behind its low-passes.
    pub motion: Motion,
    /// Regular roll, behind the low-passes where there are any; `motion` is then the narrow irregular roll that stands
    /// for it.
    pub regular: Option<Regular>,
    /// How far the rational spectrum of a sea's surface is off.
    pub fit: Option<RationalFit>,
}

impl Excitation {
    /// Irregular roll of the form (3.3), without a band.
    pub fn irregular(roll: Roll) -> Self {
        Self { source: Source::Irregular(roll), band: None }
    }

    /// The sea, where there is one.
    pub fn waves(&self) -> Option<&Waves> {
        match &self.source {
            Source::Sea(waves) => Some(waves),
            _ => None,
        }
    }

    /// The roll of the form (3.3), where it is one.
    pub fn roll(&self) -> Option<Roll> {
        match self.source {
            Source::Irregular(roll) => Some(roll),
            _ => None,
        }
    }

    /// The same in a sea of another significant height, m; anything else stays as it is.
    #[must_use]
    pub fn of_height(&self, height: f64) -> Self {
        let mut other = self.clone();
        if let Source::Sea(waves) = &mut other.source {
            waves.sea = waves.sea.of_height(height);
        }
        other
    }

    /// The motion.
    ///
    /// # Errors
    /// `BadInput` for numbers that are no roll, sea or ship, and for a sea that excites nothing; `NotComputed` where
    /// no rational spectrum fits the sea.
    pub fn motion(&self) -> Result<ShipMotion> {
        let mut motion = match &self.source {
            Source::Irregular(roll) => {
                of(Motion::roll(&Roll::new(roll.variance, roll.decay, roll.frequency)?))
            }
            Source::Regular(roll) if !(roll.amplitude > 0.0 && roll.frequency > 0.0) => {
                return Err(Error::bad_input(format!(
                    "regular roll has an amplitude and a frequency above 0, not {} rad and {} rad/s",
                    roll.amplitude, roll.frequency
                )));
            }
            Source::Regular(roll) => ShipMotion { regular: Some(*roll), ..of(narrow(roll)?) },
            Source::Sea(waves) => {
                range::SEA_FROM.check(waves.from)?;
                let fit = rational(&waves.sea)?;
                let motion = Motion::in_sea(&fit.shaping, &waves.responses()?)?;
                ShipMotion { fit: Some(fit), ..of(motion) }
            }
        };
        if let Some(corner) = self.band {
            range::BAND.check(corner)?;
            motion.motion = motion.motion.band_limited(corner, 2)?;
            if let Some(roll) = &mut motion.regular {
                roll.amplitude /= 1.0 + (roll.frequency / corner).powi(2);
            }
        }
        Ok(motion)
    }
}

fn of(motion: Motion) -> ShipMotion {
    ShipMotion { motion, regular: None, fit: None }
}

/// Regular roll as the limit of ever narrower irregular roll: θ₀² = 2A, p = ε, μ → 0.
fn narrow(roll: &Regular) -> Result<Motion> {
    let p = roll.frequency;
    Ok(Motion::roll(&Roll::new(0.5 * roll.amplitude * roll.amplitude, 1e-7 * p, p)?))
}

/// The sea's surface by a rational spectrum, weighted with ω⁴ as slopes are.
fn rational(sea: &Sea) -> Result<RationalFit> {
    sea.check()?;
    let omega: Vec<f64> = (1..=240).map(|k| f64::from(k) * 0.02 * sea.peak()).collect();
    let density: Vec<f64> = omega.iter().map(|w| sea.density(*w)).collect();
    let weight: Vec<f64> = omega.iter().map(|w| w.powi(4)).collect();
    fit_rational(&omega, &density, &weight, &[0, 1, 3, 5])
}

impl Waves {
    /// The parts of its slope athwart and along the ship.
    pub fn slopes(&self) -> (f64, f64) {
        Hull::slopes(self.from)
    }

    fn responses(&self) -> Result<Vec<(Axis, TransferFunction)>> {
        let mut all = Vec::new();
        if self.slopes().0 != 0.0 {
            all.push((Axis::Roll, self.hull.roll_response(self.from)?));
        }
        for axis in &self.also {
            all.push((
                *axis,
                match axis {
                    Axis::Pitch => self.hull.pitch_response(self.from)?,
                    Axis::Heave => self.hull.heave_response(self.from)?,
                    Axis::Sway => self.hull.sway_response(self.from)?,
                    Axis::Surge => self.hull.surge_response(self.from)?,
                    Axis::Yaw => self.hull.yaw_response(self.from)?,
                    Axis::Roll => {
                        return Err(Error::bad_input("roll is in every sea; the others stand beside it"));
                    }
                },
            ));
        }
        Ok(all)
    }
}
