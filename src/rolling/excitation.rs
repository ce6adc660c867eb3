//! What moves the ship.

use super::waves::{SeaMotion, Waves};
use crate::gyro::seed::Regular;
use crate::gyro::{Motion, range};
use crate::spectrum::Roll;
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

/// The motion that an excitation makes.
#[derive(Debug, Clone)]
pub struct ShipMotion {
    /// The motion behind its low-passes.
    pub motion: Motion,
    /// Regular roll, behind the low-passes where there are any; `motion` is then the narrow irregular roll that stands
    /// for it.
    pub regular: Option<Regular>,
    /// What became of a sea.
    pub sea: Option<SeaMotion>,
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

    /// The same where the ship goes through the waves at a speed, m/s; anything but a sea stays as it is.
    #[must_use]
    pub fn under_way(mut self, speed: f64) -> Self {
        if let Source::Sea(waves) = &mut self.source {
            waves.speed = speed;
        }
        self
    }

    /// What makes it large or small: the significant height of a sea, m; the amplitude of regular roll, or the standard
    /// deviation of irregular roll, rad.
    pub fn size(&self) -> f64 {
        match &self.source {
            Source::Irregular(roll) => roll.variance.sqrt(),
            Source::Regular(roll) => roll.amplitude,
            Source::Sea(waves) => waves.sea.height(),
        }
    }

    /// The same of another [`size`](Self::size).
    ///
    /// ```
    /// use gyrospec::{Roll, rolling::Excitation};
    /// let wide = Excitation::irregular(Roll::new(0.01, 0.1, 0.8)?).of_size(0.2);
    /// assert!((wide.roll().unwrap().variance - 0.04).abs() < 1e-15);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    #[must_use]
    pub fn of_size(&self, size: f64) -> Self {
        let mut other = self.clone();
        match &mut other.source {
            Source::Irregular(roll) => roll.variance = size * size,
            Source::Regular(roll) => roll.amplitude = size,
            Source::Sea(waves) => waves.sea = waves.sea.of_height(size),
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
                let (motion, sea) = waves.motion()?;
                ShipMotion { sea: Some(sea), ..of(motion) }
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
    ShipMotion { motion, regular: None, sea: None }
}

/// Regular roll as the limit of ever narrower irregular roll: θ₀² = 2A, p = ε, μ → 0.
fn narrow(roll: &Regular) -> Result<Motion> {
    let p = roll.frequency;
    Ok(Motion::roll(&Roll::new(0.5 * roll.amplitude * roll.amplitude, 1e-7 * p, p)?))
}
