//! `gyrospec fit`: a model fitted to recordings.

use super::output::words;
use super::progress::Meter;
use super::task::Task;
use super::{Outcome, warn};
use crate::Result;
use crate::estimate::fit::{self, FitOptions};
use crate::report::fit::{FitReport, json, page, text};
use crate::simulate::Budget;

const HELP: &str = "\
The last 40 % of a recording is held out, unless its spans or --holdout say otherwise.
Exit code: 0, or 1 where the data do not tell all free parameters, or 2 where the input is wrong.
Examples:
  gyrospec fit model.toml log.toml
  gyrospec fit model.toml log.toml --html fit.html --model-out fitted.toml
  gyrospec fit model.toml day1.toml day2.toml --holdout day3.toml --json -";

/// Fits the free parameters and initial states of a model to recordings, by simulation.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    #[command(flatten)]
    task: Task,
}

pub fn run(call: &Call) -> Result<Outcome> {
    let outputs = call.task.open()?;
    let inputs = call.task.read(&outputs)?;
    let (recordings, separate) = (&inputs.recordings, &inputs.separate);
    fit::setup::keep_apart(&inputs.model, recordings, separate)?;
    let options = FitOptions {
        seed: call.task.seed,
        separate_holdout: !separate.is_empty(),
        budget: Budget::new(u64::MAX, call.task.time_limit),
        progress: &Meter,
        ..FitOptions::default()
    };
    let mut fitted = fit::fit(&inputs.model, recordings, &options)?;
    if fitted.ended_early.is_none() {
        fit::ascertain(&mut fitted, recordings, &options.without_limit())?;
    }
    let held_out = fit::holdout(&fitted, recordings, separate, &options.without_limit())?;
    for warning in &fitted.warnings {
        warn(&warning.says);
    }
    let report = FitReport {
        fit: &fitted,
        source: &inputs.source,
        held_out: &held_out,
        recordings,
        separate,
        spectra: &fit::residual_spectra(&fitted),
        seed: call.task.seed,
    };
    if !outputs.take_stdout() {
        words(&text(&report))?;
    }
    outputs.finish(&inputs, &fitted.model, || page(&report), || json(&report))?;
    Ok(if fitted.unseen.is_empty() { Outcome::Done } else { Outcome::Found })
}
