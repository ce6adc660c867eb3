//! The rolling error on a recorded roll: by I_n on the fit of (3.3), with the mean by quadrature over the measured
//! spectrum beside it.

use super::case::Case;
use super::table::{Beyond, MeasuredRoll, Table};
use super::{Against, Analysis, Compass, Days, Excitation, Obstacle, Source};
use crate::Result;
use crate::estimate::fit::Progress;

/// A compass on a ship whose roll was recorded.
#[derive(Debug, Clone)]
pub struct Recorded {
    /// The compass.
    pub compass: Compass,
    /// The roll.
    pub analysis: Analysis,
    /// Two first-order low-passes on the roll at this frequency, rad/s.
    pub band: Option<f64>,
    /// rad.
    pub headings: Vec<f64>,
    /// Days of simulation beside the formula.
    pub days: Option<Days>,
}

impl Recorded {
    /// What stands against any recorded roll with this compass: a part that is not linear, since the fit of (3.3) has
    /// no finite acceleration to drive it.
    ///
    /// # Errors
    /// `BadInput` for numbers that describe no elastic part.
    pub fn obstacle(compass: &Compass) -> Result<Option<Obstacle>> {
        let instrument = compass.instrument();
        let name = instrument.elastic.name().to_owned();
        Ok((!instrument.is_linear()?).then_some(Obstacle::RecordedTail(name)))
    }

    /// Computes the rows.
    ///
    /// # Errors
    /// That of its [`Obstacle`]; as [`Request::table`](super::Request::table).
    pub fn table(&self, progress: &dyn Progress) -> Result<Table> {
        if let Some(obstacle) = Self::obstacle(&self.compass)? {
            return Err(obstacle.error());
        }
        let (roll, spectrum) = (self.analysis.fit.roll, &self.analysis.spectrum);
        let mean = self.compass.instrument().mean_by_spectrum(&roll, self.band, spectrum)?;
        let excitation = Excitation { source: Source::Irregular(roll), band: self.band };
        let case = |heading: &f64| -> Result<Case> {
            let (instrument, heading) = (self.compass.instrument(), *heading);
            let motion = excitation.motion()?;
            let rectified = instrument.rectified_error(&motion.motion, heading)?;
            let measured = Some(instrument.sailing_error(heading) + mean.ratio() * rectified);
            let value = heading.to_degrees();
            Ok(Case { instrument, motion, sea: None, heading, value, height: None, measured })
        };
        let cases = self.headings.iter().map(case).collect::<Result<Vec<_>>>()?;
        let empty = Table {
            compass: self.compass.clone(),
            excitation: None,
            sea: None,
            off_by: None,
            by_rectangle: None,
            recorded: Some(MeasuredRoll { analysis: self.analysis.clone(), band: self.band, mean }),
            against: Against::Heading(self.headings.clone()),
            rows: Vec::new(),
            left_out: Vec::new(),
            smallness: Vec::new(),
            tail: None,
        };
        empty.filled(&cases, self.days, Beyond::Refused, progress)
    }
}
