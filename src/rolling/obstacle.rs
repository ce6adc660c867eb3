//! What stands against a request, before anything long is computed.

use super::Excitation;
use super::case::{Case, distinct};
use crate::gyro::{Effort, FEWEST, Instrument};
use crate::{Error, Result};

/// Why there will be no figures.
#[derive(Debug, Clone, PartialEq)]
pub enum Obstacle {
    /// The part, whose name this is, is not linear, and the motion's acceleration has a white tail.
    WhiteTail(String),
    /// The mean comes from frequencies that no simulation follows.
    BeyondSimulation,
    /// The part would take too many steps to be followed.
    TooLong {
        /// Its name.
        part: String,
        /// What it takes.
        effort: Effort,
        /// A band, rad/s, with which it would not, and what it takes then.
        band: Option<(f64, Effort)>,
    },
}

/// Bands that a ship may have, rad/s.
const BANDS: [f64; 9] = [1000.0, 500.0, 200.0, 100.0, 50.0, 20.0, 10.0, 5.0, 2.5];

impl Obstacle {
    /// It as an error, with what would help.
    pub fn error(&self) -> Error {
        const BAND: &str =
            "limit the band of the motion to the frequency above which this ship does not move";
        match self {
            Self::WhiteTail(part) => Error::usage(format!(
                "with {part} the answer depends on the white tail of this motion's acceleration, which no ship has"
            ))
            .with_hint(BAND),
            Self::BeyondSimulation => {
                Error::usage("the mean comes from frequencies that no simulation follows").with_hint(BAND)
            }
            Self::TooLong { part, effort, .. } => {
                effort.check(part).err().unwrap_or_else(|| Error::not_computed(part.clone()))
            }
        }
    }
}

/// The first case whose part cannot be followed in a reasonable time, with a band that would help.
pub(super) fn too_long(cases: &[Case], excitation: &Excitation) -> Result<Option<Obstacle>> {
    for case in distinct(cases)? {
        let effort = case.instrument.effort(&case.motion.motion)?;
        if effort.replicates() < FEWEST {
            let excitation = case.height.map_or_else(|| excitation.clone(), |h| excitation.of_size(h));
            let band = shorter(&case.instrument, excitation, &effort)?;
            return Ok(Some(Obstacle::TooLong {
                part: case.instrument.elastic.name().to_owned(),
                effort,
                band,
            }));
        }
    }
    Ok(None)
}

/// The widest of the usual bands with which a moment takes some seconds.
fn shorter(
    instrument: &Instrument,
    mut excitation: Excitation,
    effort: &Effort,
) -> Result<Option<(f64, Effort)>> {
    for band in BANDS {
        excitation.band = Some(band);
        let narrower = instrument.effort(&excitation.motion()?.motion)?;
        if narrower.step > 1.1 * effort.step && narrower.replicates() >= 2 * FEWEST {
            return Ok(Some((band, narrower)));
        }
    }
    Ok(None)
}
