//! What it takes to follow a part that is not linear, and how much of that is affordable.

use super::path::Drive;
use super::{Instrument, Motion};
use crate::units::{figure, significant};
use crate::{Error, ErrorKind, Result};

/// Steps that the estimate of one [`Moment`](super::Moment) takes at most, over all replicates: some seconds.
pub const BUDGET: f64 = 2.4e7;
/// Replicates below which the scatter of their means is not known well enough to be told.
pub const FEWEST: usize = 96;
/// Replicates beyond which nobody needs more.
pub const MOST: usize = 768;

/// The steps that the estimate of one [`Moment`](super::Moment) takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Time between two samples of the motion, s.
    pub step: f64,
    /// In how many parts each step of the elastic part is solved: more than one where it rings.
    pub parts: usize,
    /// The memory of the motion, s: the time in which it falls to 1/e.
    pub memory: f64,
    /// T of the elastic part, s.
    pub lag: f64,
}

impl Effort {
    /// How long a replicate is kept, s: a hundred of its longest memories.
    pub fn length(&self) -> f64 {
        100.0 * self.memory.max(10.0 * self.lag).max(10.0)
    }

    /// Samples of the motion in what is kept of a replicate, an even number.
    pub(super) fn samples(&self) -> usize {
        2 * (0.5 * self.length() / self.step).ceil() as usize
    }

    /// Steps of a replicate, with the quarter in which it settles.
    pub fn steps(&self) -> f64 {
        1.25 * self.length() / self.step * self.parts as f64
    }

    /// How many replicates [`BUDGET`] holds, up to `MOST`.
    ///
    /// ```
    /// let effort = gyrospec::gyro::Effort { step: 0.05, parts: 1, memory: 10.0, lag: 0.4 };
    /// // 25 000 steps each
    /// assert_eq!(effort.replicates(), 768);
    /// assert_eq!(gyrospec::gyro::Effort { step: 0.01, ..effort }.replicates(), 192);
    /// ```
    pub fn replicates(&self) -> usize {
        ((BUDGET / self.steps()) as usize).min(MOST)
    }

    /// Refuses what would not leave [`FEWEST`] replicates.
    ///
    /// # Errors
    /// `OutOfRange`, with what makes it long.
    pub fn check(&self, part: &str) -> Result<()> {
        if self.replicates() >= FEWEST {
            return Ok(());
        }
        Err(Error::new(
            ErrorKind::OutOfRange,
            format!(
                "{part} would take {FEWEST} replicates of {} steps, {} in all, to be followed on this motion; {} are the most",
                figure(self.steps()),
                figure(FEWEST as f64 * self.steps()),
                figure(BUDGET)
            ),
        )
        .with_hint(self.why()))
    }

    /// What makes it long.
    fn why(&self) -> String {
        let lasts = if self.memory > (10.0 * self.lag).max(10.0) {
            format!(
                "a hundred memories of the motion, {} s each: give it more decay, or take it as regular roll",
                significant(self.memory, 3)
            )
        } else {
            "a thousand lags T, or 10 s where T is shorter than 1 s".to_owned()
        };
        format!(
            "a step lasts {} s, in {} parts: limit the band of the motion; a replicate lasts {lasts}",
            significant(self.step, 3),
            self.parts
        )
    }
}

impl Instrument {
    /// What the estimate of the moment of a part that is not linear takes on a random motion.
    ///
    /// # Errors
    /// As the covariance of the motion.
    pub fn effort(&self, motion: &Motion) -> Result<Effort> {
        let drive = Drive::irregular(motion);
        // the mean of samples of W₂ x needs no rule for an integral, and so half as many steps
        let step = 2.0 * drive.step()?;
        let part = self.elastic.in_time(&self.sphere, step)?;
        let parts = part.map_or(1, |p| p.parts());
        Ok(Effort { step, parts, memory: drive.memory()?, lag: self.sphere.lag })
    }
}
