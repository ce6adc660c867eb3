//! What is asked for, and the rows that follow from it.

use super::case::Case;
use super::obstacle::too_long;
use super::table::{Beyond, MeasuredRoll, Table};
use super::{Against, Compass, Days, Excitation, Obstacle, ShipMotion};
use crate::estimate::fit::Progress;
use crate::gyro::Tail;
use crate::{Error, Result};

/// A compass, what moves the ship, and the rows wanted.
#[derive(Debug, Clone)]
pub struct Request {
    /// The compass.
    pub compass: Compass,
    /// What moves the ship.
    pub excitation: Excitation,
    /// What the rows run over.
    pub against: Against,
    /// Days of simulation beside the formula.
    pub days: Option<Days>,
}

/// A request with its motions made, ready to be computed.
#[derive(Debug)]
pub struct Prepared<'a> {
    request: &'a Request,
    /// The motion that the request describes.
    motion: ShipMotion,
    cases: Vec<Case>,
    tail: Option<Tail>,
}

impl Request {
    /// Makes the motions.
    ///
    /// # Errors
    /// As [`Excitation::motion`]; `BadInput` for heights where there is no sea.
    pub fn prepare(&self) -> Result<Prepared<'_>> {
        let motion = self.excitation.motion()?;
        let cases = self.cases(&motion)?;
        let instrument = self.compass.instrument();
        let tail = if motion.regular.is_some() { None } else { instrument.tail(&motion.motion)? };
        Ok(Prepared { request: self, motion, cases, tail })
    }

    /// Computes the rows.
    ///
    /// # Errors
    /// As [`Request::prepare`], then as [`Prepared::table`].
    pub fn table(&self, progress: &dyn Progress) -> Result<Table> {
        self.prepare()?.table(progress)
    }

    fn cases(&self, own: &ShipMotion) -> Result<Vec<Case>> {
        let case = |heading: f64, height: Option<f64>, value: f64| -> Result<Case> {
            let excitation = height.map_or_else(|| self.excitation.clone(), |h| self.excitation.of_size(h));
            let motion = if height.is_some() { excitation.motion()? } else { own.clone() };
            let instrument = self.compass.instrument();
            let sea = excitation.waves().map(|w| w.sea);
            Ok(Case { instrument, motion, sea, heading, value, height, measured: None, replay: None })
        };
        match &self.against {
            Against::Heading(headings) if headings.is_empty() => {
                Err(Error::bad_input("no heading is asked for"))
            }
            Against::Heading(headings) => headings.iter().map(|k| case(*k, None, k.to_degrees())).collect(),
            Against::Latitude { heading } => (0..=16)
                .map(|k| {
                    let degrees = 5.0 * f64::from(k);
                    let mut case = case(*heading, None, degrees)?;
                    case.instrument.sphere.latitude = degrees.to_radians();
                    Ok(case)
                })
                .collect(),
            Against::Height { .. } if self.excitation.waves().is_none() => {
                Err(Error::bad_input("heights of waves are those of a sea, and there is none"))
            }
            Against::Height { heading } => (1..=16)
                .map(|k| {
                    let height = 0.5 * f64::from(k);
                    case(*heading, Some(height), height)
                })
                .collect(),
        }
    }
}

impl Prepared<'_> {
    /// What stands against it.
    ///
    /// # Errors
    /// As the covariance of the motion.
    pub fn obstacle(&self) -> Result<Option<Obstacle>> {
        let instrument = self.request.compass.instrument();
        let white = self.motion.regular.is_none() && self.motion.motion.has_white_acceleration();
        if white && !instrument.is_linear()? {
            return Ok(Some(Obstacle::WhiteTail(instrument.elastic.name().to_owned())));
        }
        if self.request.days.is_some() && self.tail.as_ref().is_some_and(Tail::is_beyond_simulation) {
            return Ok(Some(Obstacle::BeyondSimulation));
        }
        too_long(&self.cases, &self.request.excitation)
    }

    /// Computes the rows.
    ///
    /// # Errors
    /// That of its [`Obstacle`]; as [`Instrument::error`](crate::gyro::Instrument::error); `OutOfRange` where no row
    /// has an error that the linear theory gives, or one of the headings has none.
    pub fn table(self, progress: &dyn Progress) -> Result<Table> {
        let over_headings = matches!(self.request.against, Against::Heading(_));
        self.filled(if over_headings { Beyond::Refused } else { Beyond::LeftOut }, progress)
    }

    /// The same where rows beyond the linear theory are left out, be it all of them.
    ///
    /// # Errors
    /// As [`Prepared::table`], but for these rows.
    pub fn reached(self, progress: &dyn Progress) -> Result<Table> {
        self.filled(Beyond::AllLeftOut, progress)
    }

    fn filled(self, beyond: Beyond, progress: &dyn Progress) -> Result<Table> {
        if let Some(obstacle) = self.obstacle()? {
            return Err(obstacle.error());
        }
        let r = self.request;
        let empty = Table {
            compass: r.compass.clone(),
            excitation: Some(r.excitation.clone()),
            sea: self.motion.sea.filter(|_| !matches!(r.against, Against::Height { .. })),
            off_by: None,
            by_rectangle: None,
            recorded: None::<MeasuredRoll>,
            against: r.against.clone(),
            rows: Vec::new(),
            left_out: Vec::new(),
            smallness: Vec::new(),
            tail: self.tail,
        };
        empty.filled(&self.cases, r.days, beyond, progress)
    }
}
