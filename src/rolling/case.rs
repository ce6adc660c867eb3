//! One row: what it is computed from, and what comes out.

use super::ShipMotion;
use crate::Result;
use crate::estimate::fit::Progress;
use crate::gyro::{
    Drive, HeadingError, Instrument, Moment, MonteCarlo, Replay, Shape, SimulatedError, folded,
};
use crate::spectrum::Sea;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Days of simulation beside the formula; each is a replicate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Days {
    /// How many: two at least, since the interval comes from their scatter.
    pub count: usize,
    /// Seed of the simulation.
    pub seed: u64,
}

/// One row computed.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Heading, rad.
    pub heading: f64,
    /// What the rows run over: heading or latitude in degrees, or significant height in m.
    pub value: f64,
    /// The error.
    pub error: HeadingError,
    /// The shape of its distribution, where a slow compass on a random motion gives it.
    pub shape: Option<Shape>,
    /// The mean by quadrature over a measured spectrum, rad.
    pub measured: Option<f64>,
    /// The mean by sums over a sea's own spectrum, rad, where the rational one is off by so much that it is the one to trust.
    pub summed: Option<f64>,
    /// The simulation beside it.
    pub simulated: Option<SimulatedError>,
}

impl Row {
    /// Whether its figures are exact, and not those of a simulation.
    pub fn is_exact(&self) -> bool {
        self.error.rectified_margin == 0.0 && self.error.linearised.is_none()
    }
}

/// One row to compute.
#[derive(Debug)]
pub(super) struct Case {
    pub instrument: Instrument,
    pub motion: ShipMotion,
    pub sea: Option<Sea>,
    /// rad.
    pub heading: f64,
    /// As in [`Row`].
    pub value: f64,
    /// Significant height of its sea, m, where the rows run over it.
    pub height: Option<f64>,
    /// As in [`Row`].
    pub measured: Option<f64>,
    /// The recorded roll that drives a part that is not linear.
    pub replay: Option<Arc<Replay>>,
}

impl Case {
    /// The row, with what parts that are not linear make of the motions.
    pub fn row(&self, days: Option<Days>, moments: &Moments) -> Result<Row> {
        let motion = &self.motion.motion;
        let error = match (&self.motion.regular, moments.get(self)) {
            (Some(roll), _) => self.instrument.regular_error(roll, self.heading)?,
            (None, Some(moment)) => {
                let error = self.instrument.error_by(moment, motion, self.heading)?;
                // the linear stand-in is that of a random motion
                let linearised = error.linearised.filter(|_| self.replay.is_none());
                HeadingError { linearised, ..error }
            }
            (None, None) => self.instrument.error(motion, self.heading)?,
        };
        let simulated = days.map(|days| self.simulated(days)).transpose()?;
        let Self { heading, value, measured, .. } = *self;
        let shape = match (self.motion.regular, &self.replay) {
            (Some(_), _) | (_, Some(_)) => None,
            _ => self.instrument.shape(motion, heading, &error)?,
        };
        Ok(Row { heading, value, error, shape, measured, summed: None, simulated })
    }

    fn simulated(&self, days: Days) -> Result<SimulatedError> {
        let irregular = || Ok(Drive::irregular(&self.motion.motion));
        let drive = self.motion.regular.as_ref().map_or_else(irregular, Drive::regular)?;
        let (step, settle) = (drive.step()?, 6.0 * 3600.0);
        let plan = MonteCarlo { step, duration: 86400.0, settle, runs: days.count, seed: days.seed };
        plan.run(&self.instrument, &drive, self.heading)
    }

    /// What rows share that have the same moment: the folded heading and the height of the sea.
    pub fn key(&self) -> [u64; 2] {
        let (heading, _) = folded(&self.motion.motion, self.heading);
        [(heading * 1e12).round() as u64, self.height.unwrap_or(0.0).to_bits()]
    }
}

/// What parts that are not linear make of the motions, each computed once for all rows that share it.
pub(super) struct Moments(BTreeMap<[u64; 2], Moment>);

impl Moments {
    pub fn of(cases: &[Case], progress: &dyn Progress) -> Result<Self> {
        let distinct = distinct(cases)?;
        let count = distinct.len() as f64;
        let moment = |(i, case): (usize, &&Case)| {
            let told =
                |share: f64| progress.report("following the part in time", Some((i as f64 + share) / count));
            told(0.0);
            let moment = match &case.replay {
                Some(replay) => case.instrument.replayed(replay, case.heading),
                None => case.instrument.moment_with(&case.motion.motion, case.heading, &told),
            };
            Ok((case.key(), moment?))
        };
        distinct.iter().enumerate().map(moment).collect::<Result<_>>().map(Self)
    }

    fn get(&self, case: &Case) -> Option<&Moment> {
        self.0.get(&case.key())
    }
}

/// Of all cases that share a moment, one each.
pub(super) fn distinct(cases: &[Case]) -> Result<Vec<&Case>> {
    let mut distinct: BTreeMap<[u64; 2], &Case> = BTreeMap::new();
    for case in cases.iter().filter(|c| c.motion.regular.is_none()) {
        if !case.instrument.is_linear()? {
            distinct.entry(case.key()).or_insert(case);
        }
    }
    Ok(distinct.into_values().collect())
}
