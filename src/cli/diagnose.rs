//! `gyrospec diagnose`: what a model leaves out.

use super::output::{Sink, print};
use super::progress::Meter;
use super::{Outcome, warn};
use crate::diagnose::answer::Verdict;
use crate::diagnose::{Request, diagnose};
use crate::model::Model;
use crate::record::Recording;
use crate::report;
use crate::{Error, ErrorKind, Result};
use std::path::{Path, PathBuf};

/// Finds what a model leaves out of the physics of its recordings, and proves it on what is held out.
#[derive(clap::Args)]
pub struct Call {
    /// The model file.
    model: PathBuf,
    /// Recordings: CSV or TOML files.
    #[arg(required = true)]
    recordings: Vec<PathBuf>,
    /// Recordings that serve the proof alone.
    #[arg(long, num_args = 1.., value_name = "RECORDING")]
    holdout: Vec<PathBuf>,
    /// Writes the diagnosis as JSON; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Writes a report with pictures.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Writes the model with what was found in it.
    #[arg(long, value_name = "FILE")]
    model_out: Option<PathBuf>,
    /// Seed of all that is drawn at random.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

pub fn run(call: &Call) -> Result<Outcome> {
    let open = |path: &Option<PathBuf>| path.as_deref().map(Sink::open).transpose();
    let (json, html, model_out) = (open(&call.json)?, open(&call.html)?, open(&call.model_out)?);
    let model = Model::read(&call.model)?;
    let read = |files: &[PathBuf]| files.iter().map(Recording::read).collect::<Result<Vec<_>>>();
    let (recordings, separate) = (read(&call.recordings)?, read(&call.holdout)?);
    super::record::tell_notes(recordings.iter().chain(&separate));
    let meter = Meter::new();
    let request = Request {
        model: &model,
        recordings: &recordings,
        separate: &separate,
        seed: call.seed,
        progress: &meter,
    };
    let diagnosis = diagnose(&request)?;
    drop(meter);
    for warning in &diagnosis.after.warnings {
        warn(&warning.says);
    }
    let taken = [&call.json, &call.html, &call.model_out];
    let to_stdout = taken.iter().any(|p| p.as_deref() == Some(Path::new("-")));
    if !to_stdout {
        print(report::diagnosis::text(&diagnosis).as_bytes())?;
    }
    if let Some(sink) = model_out {
        sink.finish(diagnosis.after.model.to_toml().as_bytes())?;
    }
    if let Some(sink) = html {
        sink.finish(report::diagnosis::html(&diagnosis).as_bytes())?;
    }
    if let Some(sink) = json {
        let text = serde_json::to_string_pretty(&diagnosis.answer)
            .map_err(|e| Error::new(ErrorKind::NotComputed, e.to_string()))?;
        sink.finish((text + "\n").as_bytes())?;
    }
    Ok(if diagnosis.answer.verdict == Verdict::NothingMissing { Outcome::Done } else { Outcome::Found })
}
