//! `gyrospec roll-error`: mean and spread of the rolling error.

mod examples;
mod measured;
mod parameters;
mod recording;

use super::{Outcome, output};
use crate::Result;
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Arguments {
    /// Parameters of the compass: a model file or a file with [parameters]; without it the
    /// gyrocompass of the rolling-error paper.
    model_or_parameters: Option<PathBuf>,
    /// A recording of the ship's roll (CSV, or TOML).
    recording: Option<PathBuf>,
    /// Channel that is the roll angle, with its unit if the header has none: NAME or NAME:UNIT.
    #[arg(long, value_name = "NAME[:UNIT]")]
    roll: Option<String>,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: &Arguments) -> Result<Outcome> {
    let text = match files(arguments) {
        (None, None) => examples::text()?,
        (parameters, recording) => {
            let compass = parameters::read(parameters)?;
            match recording {
                Some(path) => measured::text(&compass, path, arguments.roll.as_deref())?,
                None => examples::text()?,
            }
        }
    };
    output::print(text.as_bytes())?;
    Ok(Outcome::Done)
}

/// A lone file is the compass if it has parameters, else the recording.
fn files(a: &Arguments) -> (Option<&PathBuf>, Option<&PathBuf>) {
    match (&a.model_or_parameters, &a.recording) {
        (Some(only), None) if !parameters::has_parameters(only) => (None, Some(only)),
        (first, second) => (first.as_ref(), second.as_ref()),
    }
}
