//! The table of errors.

use super::case::{Case, Moments};
use super::{Against, Analysis, Compass, Days, Excitation, Row, SeaMotion};
use crate::Result;
use crate::estimate::fit::Progress;
use crate::gyro::validity::{Smallness, bounded, steepness};
use crate::gyro::{BySpectrum, HeadingError, OffBy, Tail};
use crate::spectrum::Roll;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Mean and spread of the heading error, row by row, with what is to be known of them.
#[derive(Debug, Clone)]
pub struct Table {
    /// The compass.
    pub compass: Compass,
    /// What moves the ship; `None` where its roll was recorded.
    pub excitation: Option<Excitation>,
    /// What became of a sea, where it is of one height.
    pub sea: Option<SeaMotion>,
    /// How far its rational spectrum is off, where the mean is largest.
    pub off_by: Option<OffBy>,
    /// The mean by the motion there where the waves are averaged over a rectangle as long and as wide as the ship, rad.
    pub by_rectangle: Option<f64>,
    /// The recorded roll.
    pub recorded: Option<MeasuredRoll>,
    /// What the rows run over.
    pub against: Against,
    /// The errors.
    pub rows: Vec<Row>,
    /// Values of rows that no linear theory reaches.
    pub left_out: Vec<f64>,
    /// What the linear theory takes for small, where the mean is largest.
    pub smallness: Vec<Smallness>,
    /// The mean by frequencies far above the motion's own, where it depends on them.
    pub tail: Option<Tail>,
}

/// What becomes of rows beyond the linear theory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Beyond {
    /// One of them and there is no table.
    Refused,
    /// The table is that of the others, where there are some.
    LeftOut,
    /// The table is that of the others, or has no rows.
    AllLeftOut,
}

/// A recorded roll with the mean error by it.
#[derive(Debug, Clone)]
pub struct MeasuredRoll {
    /// The roll.
    pub analysis: Analysis,
    /// Two first-order low-passes on it at this frequency, rad/s.
    pub band: Option<f64>,
    /// The mean by its fit and by its spectrum; `None` for a part that is not linear, which is followed through the
    /// recording itself.
    pub mean: Option<BySpectrum>,
    /// What the rounding of the samples alone makes of the mean by the measured spectrum, for one of 1 by the fit: it grows with
    /// the fourth power of the frequency, as acceleration does.
    pub rounding: f64,
}

impl MeasuredRoll {
    /// Part of the mean by the fit from which on its form, or its tail, counts.
    pub const MUCH: f64 = 0.1;
    /// Misfit of the correlation function from which on the fit is no longer good.
    pub const FAIR: f64 = 0.05;

    /// Whether the mean by the measured spectrum is the one to trust.
    pub fn is_surer(&self) -> bool {
        let (Some(m), fit) = (&self.mean, &self.analysis.fit) else { return false };
        let differs = m.above().abs() >= Self::MUCH || m.form().abs() >= Self::MUCH;
        !self.is_rounded() && (differs || fit.misfit >= Self::FAIR)
    }

    /// Whether the rounding of the samples makes much of the mean by the measured spectrum.
    pub fn is_rounded(&self) -> bool {
        self.rounding.abs() >= Self::MUCH
    }
}

impl Table {
    /// Whether the mean to trust is that by the measured spectrum.
    pub fn is_by_spectrum(&self) -> bool {
        self.recorded.as_ref().is_some_and(MeasuredRoll::is_surer)
    }

    /// Whether the mean to trust is that by sums over the sea's own spectrum.
    pub fn is_by_sums(&self) -> bool {
        self.rows.iter().any(|r| r.summed.is_some())
    }

    /// The mean of a row to trust, rad.
    pub fn mean(&self, row: &Row) -> f64 {
        row.measured.filter(|_| self.is_by_spectrum()).or(row.summed).unwrap_or_else(|| row.error.mean())
    }

    /// Irregular roll of the form (3.3), where the motion is one or was fitted by one.
    pub fn roll(&self) -> Option<Roll> {
        let fitted = self.recorded.as_ref().map(|r| r.analysis.fit.roll);
        fitted.or_else(|| self.excitation.as_ref().and_then(Excitation::roll))
    }

    /// The mean in symbols (feature `symbolic`), where the motion is irregular roll or was fitted by one, and the
    /// part is linear.
    #[cfg(feature = "symbolic")]
    pub fn closed_form(&self) -> Option<super::ClosedForm> {
        self.roll()?;
        let recorded = self.recorded.as_ref().and_then(|r| r.band);
        let band = self.excitation.as_ref().map_or(recorded, |e| e.band);
        super::closed_form(self.compass.part.as_ref(), band).ok()
    }

    /// The same with each `step`-th row alone.
    #[must_use]
    pub fn every(&self, step: usize) -> Self {
        let rows = self.rows.iter().step_by(step.max(1)).copied().collect();
        Self { rows, ..self.clone() }
    }

    /// The rows of the cases, judged.
    pub(super) fn filled(
        mut self,
        cases: &[Case],
        days: Option<Days>,
        beyond: Beyond,
        progress: &dyn Progress,
    ) -> Result<Self> {
        let judged: Vec<(&Case, Row, Result<()>)> = cases
            .iter()
            .zip(rows(cases, days, progress)?)
            .map(|(case, row)| (case, row, bounded(self.mean(&row))))
            .collect();
        let reached = judged.iter().filter(|j| j.2.is_ok());
        let worst = reached.max_by(|a, b| self.mean(&a.1).abs().total_cmp(&self.mean(&b.1).abs()));
        let left_out: Vec<f64> = judged.iter().filter(|j| j.2.is_err()).map(|j| j.1.value).collect();
        let told = left_out.is_empty() || beyond != Beyond::Refused;
        let Some((case, row, _)) = worst.filter(|_| told) else {
            if beyond == Beyond::AllLeftOut {
                return Ok(Self { left_out, ..self });
            }
            self.rows =
                judged.into_iter().map(|(_, row, reached)| reached.map(|()| row)).collect::<Result<_>>()?;
            return Ok(self);
        };
        let (motion, instrument) = (&case.motion.motion, &case.instrument);
        // judged is the mean to trust
        let rectified = row.error.rectified + self.mean(row) - row.error.mean();
        let error = HeadingError { rectified, ..row.error };
        self.smallness = match case.motion.regular {
            Some(_) => instrument.regular_smallness(motion, case.heading, &error)?,
            None => instrument.smallness(motion, case.heading, &error)?,
        };
        if let Some(sea) = &case.motion.sea {
            self.off_by = instrument.off_by(motion, case.heading, &sea.noise)?;
            self.by_rectangle = instrument.off_by(motion, case.heading, &sea.rectangle)?.map(|o| o.exact);
        }
        self.smallness.extend(case.sea.as_ref().map(steepness));
        let summed = self.off_by.is_some_and(|off| off.is_much());
        let told = judged.into_par_iter().filter(|j| j.2.is_ok());
        self.rows = told
            .map(|(case, row, _)| if summed { by_sums(case, &row) } else { Ok(row) })
            .collect::<Result<_>>()?;
        self.left_out = left_out;
        Ok(self)
    }
}

/// The row with its mean by sums over the sea's own spectrum.
fn by_sums(case: &Case, row: &Row) -> Result<Row> {
    let Some(sea) = &case.motion.sea else { return Ok(*row) };
    let off = case.instrument.off_by(&case.motion.motion, case.heading, &sea.noise)?;
    let summed = off.map(|off| row.error.mean() - row.error.rectified + off.exact);
    Ok(Row { summed, ..*row })
}

/// The rows, whatever the theory reaches.
fn rows(cases: &[Case], days: Option<Days>, progress: &dyn Progress) -> Result<Vec<Row>> {
    let (moments, done) = (Moments::of(cases, progress)?, AtomicUsize::new(0));
    let row = |case: &Case| {
        let row = case.row(days, &moments)?;
        let share = (1 + done.fetch_add(1, Ordering::Relaxed)) as f64 / cases.len() as f64;
        progress.report("rows of the table", Some(share));
        Ok(row)
    };
    cases.par_iter().map(row).collect()
}
