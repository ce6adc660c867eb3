//! The rolling error on a recorded roll: by I_n on the fit of (3.3), with the mean by quadrature over the measured
//! spectrum beside it; a part that is not linear is followed through the recording itself.

use super::case::Case;
use super::table::{Beyond, MeasuredRoll, Table};
use super::{Against, Analysis, Compass, Days, Excitation, SLOW, Source};
use crate::Result;
use crate::estimate::fit::Progress;
use crate::gyro::{BySpectrum, Replay};
use crate::spectrum::MeasuredSpectrum;
use std::sync::Arc;

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
    /// Computes the rows.
    ///
    /// # Errors
    /// `BadInput` for a recording too short for a part that is not linear; as
    /// [`Request::table`](super::Request::table).
    pub fn table(&self, progress: &dyn Progress) -> Result<Table> {
        let (roll, analysis) = (self.analysis.fit.roll, &self.analysis);
        let by = |s: &MeasuredSpectrum| self.compass.instrument().mean_by_spectrum(&roll, self.band, s);
        let mut rounding = 0.0;
        let (mean, replay) = if self.compass.instrument().is_linear()? {
            let mean = by(&analysis.spectrum)?;
            if let Some(s) = analysis.rounding().filter(|_| mean.fitted != 0.0) {
                rounding = by(&s)?.measured / mean.fitted;
            }
            (Some(mean), None)
        } else {
            let replay = Replay::of(&analysis.samples, SLOW, self.band, analysis.peak)?;
            (None, Some(Arc::new(replay)))
        };
        let excitation = Excitation { source: Source::Irregular(roll), band: self.band };
        let case = |heading: &f64| -> Result<Case> {
            let (instrument, heading) = (self.compass.instrument(), *heading);
            let motion = excitation.motion()?;
            let by_spectrum = |m: &BySpectrum| -> Result<f64> {
                let rectified = instrument.rectified_error(&motion.motion, heading)?;
                Ok(instrument.sailing_error(heading) + m.ratio() * rectified)
            };
            let measured = mean.as_ref().map(by_spectrum).transpose()?;
            let (value, replay) = (heading.to_degrees(), replay.clone());
            Ok(Case { instrument, motion, sea: None, heading, value, height: None, measured, replay })
        };
        let cases = self.headings.iter().map(case).collect::<Result<Vec<_>>>()?;
        let empty = Table {
            compass: self.compass.clone(),
            excitation: None,
            sea: None,
            off_by: None,
            by_rectangle: None,
            recorded: Some(MeasuredRoll { analysis: self.analysis.clone(), band: self.band, mean, rounding }),
            against: Against::Heading(self.headings.clone()),
            rows: Vec::new(),
            left_out: Vec::new(),
            smallness: Vec::new(),
            tail: None,
        };
        empty.filled(&cases, self.days, Beyond::Refused, progress)
    }
}
