//! A model fitted to recordings by simulation.
//!
//! [`fit`] moves the free parameters, shared by all recordings, and each recording's free initial
//! states until the free run of the model lies nearest to the measurements. [`holdout`] runs the
//! fitted model over what was held out.

mod options;
mod outcome;

pub use options::{Effort, FitOptions, Progress, Silent, Weighting};
pub use outcome::{Estimate, Fit, HeldOut, InitialEstimate, RecordFit, Series, Status, Warning};

use crate::model::Model;
use crate::record::Recording;
use crate::{Error, Result};

/// Fits a model to the fitted parts of recordings.
///
/// # Errors
/// Where a channel is missing, no sample is left to fit, or no start can be simulated.
pub fn fit(_model: &Model, _recordings: &[Recording], _options: &FitOptions) -> Result<Fit> {
    Err(Error::not_computed("fitting needs the simulator"))
}

/// Runs a fitted model over the held-out parts: spans of the fitted `recordings` that follow a fitted
/// span are simulated on from it; for `separate` records only their free initial states are fitted.
/// One entry an output, in the model's order, all records pooled.
///
/// # Errors
/// Where a channel is missing or the fitted model cannot be run.
pub fn holdout(
    _fit: &Fit,
    _recordings: &[Recording],
    _separate: &[Recording],
    _options: &FitOptions,
) -> Result<Vec<HeldOut>> {
    Err(Error::not_computed("fitting needs the simulator"))
}
