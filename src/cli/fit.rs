//! `gyrospec fit`: a model fitted to recordings.

use super::output::words;
use super::progress::Meter;
use super::task::Task;
use super::{Outcome, warn};
use crate::Result;
use crate::estimate::fit::{self, Fit, FitOptions};
use crate::report::fit::{FitReport, ResidualSpectrum, page};
use crate::simulate::Budget;
use crate::spectrum::welch;

mod json;
mod text;

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

/// A fit as JSON.
#[cfg(feature = "python")]
pub fn json(report: &FitReport<'_>) -> Result<String> {
    json::render(report)
}

/// A fit as words.
#[cfg(feature = "python")]
pub fn text(report: &FitReport<'_>) -> String {
    text::render(report)
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
        spectra: &spectra(&fitted),
        seed: call.task.seed,
    };
    if !outputs.take_stdout() {
        words(&text::render(&report))?;
    }
    outputs.finish(&inputs, &fitted.model, || page(&report), || json::render(&report))?;
    Ok(if fitted.unseen.is_empty() { Outcome::Done } else { Outcome::Found })
}

/// Spectra of the residuals over their longest stretches.
pub fn spectra(fit: &Fit) -> Vec<ResidualSpectrum> {
    let of = |(k, output): (usize, &crate::model::Output)| {
        let own = fit.records.iter().flat_map(|r| &r.series).filter(|s| s.output == k);
        let stretches = own.flat_map(|s| s.stretches.iter().map(move |r| (s, r.clone())));
        let (series, range) = stretches.max_by_key(|(_, r)| r.len()).filter(|(_, r)| r.len() >= 64)?;
        let (from, to) = (series.time[range.start], series.time[range.end - 1]);
        let step = (to - from) / (range.len() - 1) as f64;
        let unit = output.unit.of_differences();
        let values: Vec<f64> =
            series.residual[range.clone()].iter().map(|e| unit.difference_from_si(*e)).collect();
        let measured = welch(&values, step, (range.len() / 6).clamp(32, 4096)).ok()?;
        let points = measured.omega.iter().zip(&measured.density).skip(1);
        Some(ResidualSpectrum {
            output: output.name.clone(),
            unit: if unit.text() == "1" { "s".into() } else { format!("({})²·s", unit.text()) },
            points: points.map(|(w, s)| [*w, *s]).collect(),
        })
    };
    if fit.model.states.is_empty() && fit.records.iter().all(|r| r.series.iter().all(|s| s.time.len() < 64)) {
        return Vec::new();
    }
    fit.model.outputs.iter().enumerate().filter_map(of).collect()
}
