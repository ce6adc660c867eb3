//! The rolling error of a compass.

use crate::Result;
use crate::estimate::fit::{Progress, Silent};
use crate::gyro::seed::Regular;
use crate::report::polar;
use crate::report::rolling::{Sheet, card, json, page, text};
use crate::rolling::{Against, Compass, Days, Excitation, Request, Row, Source, Table, Waves};
use crate::spectrum::Roll;

/// Asks for the mean and the spread of a compass's heading error on a rolling ship, on headings all around unless
/// told otherwise.
///
/// The motion is irregular roll of the form (3.3) as the compass's file describes it, or that of the paper's
/// Example 3.1, unless told otherwise.
///
/// ```
/// use gyrospec::{Compass, Roll, roll_error};
/// let roll = Roll::new(0.0305, 0.1, 0.8)?; // variance in rad², decay and frequency in rad/s
/// let errors = roll_error(&Compass::paper()).roll(roll).headings(&[45f64.to_radians()]).run()?;
/// let row = &errors.rows()[0];
/// assert!(errors.mean(row) < 0.0 && row.error.deviation > 0.0); // rad, + where the compass reads high
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn roll_error(compass: &Compass) -> Rolling<'_> {
    let roll = compass.roll.unwrap_or_else(|| crate::gyro::seed::example_3_1().1);
    let (excitation, against) = (Excitation::irregular(roll), Against::card(15));
    Rolling {
        request: Request { compass: compass.clone(), excitation, against, days: None },
        progress: &Silent,
    }
}

/// A rolling error that is asked for; see [`roll_error`].
pub struct Rolling<'a> {
    request: Request,
    progress: &'a dyn Progress,
}

impl<'a> Rolling<'a> {
    /// Irregular roll of the form (3.3).
    #[must_use]
    pub fn roll(self, roll: Roll) -> Self {
        self.moved_by(Source::Irregular(roll))
    }

    /// Regular roll θ = θ₀ sin pt: its amplitude θ₀, rad, and its frequency p, rad/s.
    #[must_use]
    pub fn regular(self, amplitude: f64, frequency: f64) -> Self {
        self.moved_by(Source::Regular(Regular { amplitude, frequency }))
    }

    /// The motions of a ship in a sea.
    ///
    /// ```
    /// use gyrospec::{Axis, Compass, Hull, Sea, Waves, roll_error};
    /// let waves = Waves {
    ///     sea: Sea::Jonswap { height: 3.0, peak: 0.8, gamma: 3.3 }, // m, rad/s
    ///     from: 60f64.to_radians(),                                 // off the bow
    ///     speed: 6.0,                                               // through the waves, m/s
    ///     spread: None,                                             // long crests
    ///     hull: Hull::default(),
    ///     also: vec![Axis::Pitch],
    /// };
    /// let errors = roll_error(&Compass::paper()).sea(waves).headings(&[0.0, 0.8]).run()?;
    /// assert_eq!(errors.rows().len(), 2);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    #[must_use]
    pub fn sea(self, waves: Waves) -> Self {
        self.moved_by(Source::Sea(waves))
    }

    /// Two first-order low-passes on the motion, corner in rad/s.
    #[must_use]
    pub fn band(mut self, corner: f64) -> Self {
        self.request.excitation.band = Some(corner);
        self
    }

    /// These headings, rad.
    #[must_use]
    pub fn headings(self, headings: &[f64]) -> Self {
        self.against(Against::Heading(headings.to_vec()))
    }

    /// What the rows run over.
    #[must_use]
    pub fn against(mut self, against: Against) -> Self {
        self.request.against = against;
        self
    }

    /// So many days of simulation beside the formula, two at least, and their seed.
    #[must_use]
    pub fn simulated(mut self, days: usize, seed: u64) -> Self {
        self.request.days = Some(Days { count: days, seed });
        self
    }

    /// Who hears how far it has come.
    #[must_use]
    pub fn progress(mut self, progress: &'a dyn Progress) -> Self {
        self.progress = progress;
        self
    }

    /// Computes the errors.
    ///
    /// # Errors
    /// `BadInput` for numbers that are no roll, sea or ship; `OutOfRange` where the linear theory gives no error;
    /// what stands against a part that is not linear, with what to do.
    pub fn run(self) -> Result<Rolled> {
        let seed = self.request.days.map_or(1, |d| d.seed);
        Ok(Rolled { table: self.request.table(self.progress)?, seed })
    }

    fn moved_by(mut self, source: Source) -> Self {
        self.request.excitation.source = source;
        self
    }
}

/// Rolling errors, row by row; see [`roll_error`].
#[derive(Debug, Clone)]
pub struct Rolled {
    table: Table,
    seed: u64,
}

impl Rolled {
    /// One row a heading and question, in the order asked.
    pub fn rows(&self) -> &[Row] {
        &self.table.rows
    }

    /// The mean error of a row to trust, rad; + where the compass reads high. It is that of `row.error`, but where a
    /// measured spectrum gives a surer one.
    pub fn mean(&self, row: &Row) -> f64 {
        self.table.mean(row)
    }

    /// The errors in words and a table.
    pub fn text(&self) -> String {
        text(&self.table)
    }

    /// The errors as JSON.
    ///
    /// # Errors
    /// `NotComputed`, should a number not be writable.
    pub fn json(&self) -> Result<String> {
        json(&self.table)
    }

    /// The errors as one HTML page with pictures.
    pub fn html(&self) -> String {
        page(&Sheet { table: &self.table, every: 1, formula: None, seed: self.seed })
    }

    /// A polar picture of the error against heading as SVG, where the rows run over headings.
    pub fn svg(&self) -> Option<String> {
        card(&self.table).map(|c| polar::svg(&c))
    }
}
