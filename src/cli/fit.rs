//! `gyrospec fit`: a model fitted to recordings.

use super::output::words;
use super::task::Task;
use super::{Outcome, warn};
use crate::Result;

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
    let asked = crate::fit(&inputs.model, &inputs.recordings);
    let fitted = call.task.said(asked, &inputs).run()?;
    fitted.warnings().for_each(warn);
    if !outputs.take_stdout() {
        words(&fitted.text())?;
    }
    outputs.finish(&inputs, fitted.model(), || fitted.html(), || fitted.json())?;
    Ok(if fitted.is_determined() { Outcome::Done } else { Outcome::Found })
}
