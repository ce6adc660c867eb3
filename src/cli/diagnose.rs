//! `gyrospec diagnose`: what a model leaves out.

use super::colour::paint;
use super::output::print;
use super::task::Task;
use super::{Outcome, warn};
use crate::Result;
use crate::diagnose::answer::Verdict;
use crate::text::shown;

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
    let asked = crate::diagnose(&inputs.model, &inputs.recordings);
    let found = call.task.said(asked, &inputs).run()?;
    if outputs.take_stdout() {
        found.notes().iter().for_each(|note| warn(note));
    } else {
        let text = found.text();
        let (verdict, rest) = text.split_once('\n').unwrap_or((&text, ""));
        let style = if found.verdict() == Verdict::NothingMissing { "1;32" } else { "1;33" };
        print(format!("{}\n{}", paint(verdict, style, &std::io::stdout()), shown(rest)).as_bytes())?;
    }
    let json = || Ok(found.json()? + "\n");
    outputs.finish(&inputs, found.model(), || found.html(), json)?;
    Ok(if found.verdict() == Verdict::NothingMissing { Outcome::Done } else { Outcome::Found })
}
