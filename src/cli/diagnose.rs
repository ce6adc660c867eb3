//! `gyrospec diagnose`: what a model leaves out.

use super::colour::paint;
use super::output::print;
use super::progress::Meter;
use super::task::Task;
use super::{Outcome, warn};
use crate::diagnose::answer::Verdict;
use crate::diagnose::{Request, diagnose};
use crate::report::diagnosis;
use crate::text::shown;
use crate::{Error, Result};

const HELP: &str = "\
The last 40 % of a recording is held out, unless its spans or --holdout say otherwise.
Exit code: 0 where nothing is missing, 1 where something was found, 2 where the input is wrong, 3 where
it could not be computed.
Examples:
  gyrospec diagnose model.toml log.toml
  gyrospec diagnose model.toml log.toml --html report.html --model-out better.toml
  gyrospec diagnose model.toml day1.toml --holdout day2.toml --json - --seed 7";

/// Finds what a model leaves out of the physics of its recordings, and proves it on what is held out.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    #[command(flatten)]
    task: Task,
}

pub fn run(call: &Call) -> Result<Outcome> {
    let outputs = call.task.open()?;
    let inputs = call.task.read(&outputs)?;
    let request = Request {
        model: &inputs.model,
        source: Some(&inputs.source),
        recordings: &inputs.recordings,
        separate: &inputs.separate,
        seed: call.task.seed,
        time_limit: call.task.time_limit,
        progress: &Meter,
    };
    let found = diagnose(&request)?;
    if outputs.take_stdout() {
        found.answer.notes.iter().for_each(|note| warn(note));
    } else {
        let text = diagnosis::text(&found);
        let (verdict, rest) = text.split_once('\n').unwrap_or((&text, ""));
        let style = if found.answer.verdict == Verdict::NothingMissing { "1;32" } else { "1;33" };
        print(format!("{}\n{}", paint(verdict, style, &std::io::stdout()), shown(rest)).as_bytes())?;
    }
    let json = || match serde_json::to_string_pretty(&found.answer) {
        Ok(text) => Ok(text + "\n"),
        Err(e) => Err(Error::not_computed(e.to_string())),
    };
    outputs.finish(&inputs, &found.after.model, || diagnosis::html(&found), json)?;
    Ok(if found.answer.verdict == Verdict::NothingMissing { Outcome::Done } else { Outcome::Found })
}
