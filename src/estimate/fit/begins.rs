//! How the states of a known model begin on a recording.
//!
//! # Method
//! Numbers stay as they are; what is marked to be fitted begins where the free run lies nearest to what was measured, by
//! least squares, every output weighed by its spread. No parameter moves.

use super::harness::Record;
use super::options::{FitOptions, Weighting};
use super::problem::{given, problem};
use super::setup;
use crate::Result;
use crate::estimate::least_squares::minimise;
use crate::model::{Initial, Model};
use crate::record::{Recording, Span};

/// The model with its parameters held, the record over some spans, and all its initial states, SI: the fitted ones as
/// they fit, NaN for a steady one. None where no sample is left to compare.
///
/// # Errors
/// Where a channel is missing, or the model cannot be run from where it begins.
pub fn begins(
    model: &Model,
    recording: &Recording,
    (number, spans): (usize, &[Span]),
    options: &FitOptions<'_>,
) -> Result<Option<(Model, Record, Vec<f64>)>> {
    let mut held = model.clone();
    held.parameters.iter_mut().for_each(|p| p.fit = false);
    let options = FitOptions { initials: Vec::new(), weighting: Weighting::FreeRun, ..options.clone() };
    let Some(record) = setup::record_if_any(&held, recording, number, spans, &options)? else {
        return Ok(None);
    };
    let records = [record];
    let parameters = held.parameters.iter().map(|p| p.value).collect();
    let p = problem(&held, &records, parameters, &options);
    let start = given(&p);
    let initials = if start.is_empty() {
        records[0].initials.clone()
    } else {
        p.spread(&minimise(&p, &start, &records[0].reach, options.stopping)?.x).1.swap_remove(0)
    };
    let [record] = records;
    Ok(Some((held, record, initials)))
}

/// The same over a whole recording: where the run starts, s, and the initial states. None where no state is to be fitted or
/// nothing is measured.
///
/// # Errors
/// Where a channel is missing, or the model cannot be run from where it begins.
pub fn begun_on(
    model: &Model,
    recording: &Recording,
    options: &FitOptions<'_>,
) -> Result<Option<(f64, Vec<f64>)>> {
    if !model.states.iter().any(|s| matches!(s.initial, Initial::Fit)) {
        return Ok(None);
    }
    let whole = [Span::new(f64::NEG_INFINITY, f64::INFINITY)];
    let found = begins(model, recording, (0, &whole), options)?;
    Ok(found.map(|(_, record, initials)| (record.start, initials)))
}
