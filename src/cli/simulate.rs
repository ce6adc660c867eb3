//! `gyrospec simulate`: a model on a recording.

use super::Outcome;
use super::output;
use crate::Result;
use crate::model::Model;
use crate::record::read_once;
use crate::simulate::Options;
use std::path::PathBuf;
const HELP: &str = "\
Examples:
  gyrospec simulate model.toml log.toml
  gyrospec simulate model.toml log.toml --out predicted.csv
  gyrospec simulate model.toml examples/roll.csv --out -       # an output that nobody measured is predicted";

/// Arguments of `gyrospec simulate`.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    /// The model file, or the name of a built-in model; - is standard input.
    model: PathBuf,
    /// The recording: a CSV file or a TOML file; - is standard input.
    recording: PathBuf,
    /// Where the predictions go as CSV: time, then measured and predicted for every output.
    #[arg(long, value_name = "CSV")]
    out: Option<PathBuf>,
    /// How far halving the step may move an output, as a share of its spread.
    #[arg(long, default_value_t = Options::default().tolerance, value_parser = share)]
    tolerance: f64,
}

/// A tolerance.
fn share(text: &str) -> std::result::Result<f64, String> {
    let share: f64 =
        text.trim().parse().map_err(|_| "give a number between 0 and 1, such as 1e-5".to_string())?;
    Options::default().with_tolerance(share).map(|o| o.tolerance).map_err(|e| e.to_string())
}

pub fn run(call: &Call) -> Result<Outcome> {
    read_once([call.model.as_path(), &call.recording])?;
    let [place] = output::open([call.out.as_deref()])?;
    output::spare(&place, [&call.model, &call.recording])?;
    let model = Model::read(&call.model)?;
    if call.tolerance != Options::default().tolerance && !model.stepped_as().is_empty() {
        super::warn("--tolerance has no effect here: the FMU steps itself, by its own solver");
    }
    let mut recording = model.read_recording(&call.recording)?;
    let sources = recording.sources.iter().chain(model.begun_with());
    let read: Vec<PathBuf> = sources.map(|s| s.file.clone()).chain([call.model.clone()]).collect();
    output::spare(&place, &read)?;
    for note in model.foresee(&mut recording) {
        super::warn(&note);
    }
    let ran =
        crate::simulate(&model, &recording).tolerance(call.tolerance).run().map_err(|e| match e.file() {
            None => e.with_file(&call.model),
            Some(_) => e,
        })?;
    super::record::tell_notes([&recording]);
    for warning in ran.warnings() {
        super::warn(&warning);
    }
    let to_stdout = place.as_ref().is_some_and(output::Place::is_standard_output);
    if let Some(place) = place {
        output::put(&[place.data(ran.csv())], read)?;
    }
    if !to_stdout {
        output::words(&ran.text())?;
    }
    Ok(Outcome::Done)
}
