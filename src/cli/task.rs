//! What `fit` and `diagnose` take and give: a model, recordings, and files for the results.

use super::output::{Sink, keep_apart};
use crate::Result;
use crate::model::Model;
use crate::record::{Recording, Source};
use std::path::{Path, PathBuf};

/// The arguments.
#[derive(clap::Args)]
pub struct Task {
    /// The model file.
    model: PathBuf,
    /// Recordings: CSV or TOML files; parameters are shared, initial states are each one's own.
    #[arg(required = true)]
    recordings: Vec<PathBuf>,
    /// Recordings that are kept out of the fit and only compared afterwards.
    #[arg(long, num_args = 1.., value_name = "RECORDING")]
    holdout: Vec<PathBuf>,
    /// Writes the result as JSON; `-` is standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Writes a report with pictures, one page that opens offline.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Writes the model with the fitted values in place, and with what was found.
    #[arg(long, value_name = "FILE")]
    model_out: Option<PathBuf>,
    /// Seed of all that is drawn at random.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
}

/// What was read.
pub struct Inputs {
    pub model: Model,
    /// The model's file.
    pub source: Source,
    pub recordings: Vec<Recording>,
    /// Held out whole.
    pub separate: Vec<Recording>,
}

/// Where the results go.
pub struct Outputs {
    json: Option<Sink>,
    html: Option<Sink>,
    model: Option<Sink>,
}

impl Task {
    /// Opens the places for the results.
    pub fn open(&self) -> Result<Outputs> {
        let [json, html, model] = [&self.json, &self.html, &self.model_out].map(Option::as_ref);
        keep_apart([json, html, model], self.recordings.iter().chain(&self.holdout))?;
        // A model may be written over itself, with the fitted values in place.
        keep_apart([json, html], [&self.model])?;
        let open = |path: &Option<PathBuf>| path.as_deref().map(Sink::open).transpose();
        Ok(Outputs { json: open(&self.json)?, html: open(&self.html)?, model: open(&self.model_out)? })
    }

    /// Reads model and recordings.
    pub fn read(&self) -> Result<Inputs> {
        let (model, source) = Model::read_with_source(&self.model)?;
        let read = |files: &[PathBuf]| files.iter().map(Recording::read).collect::<Result<Vec<_>>>();
        let (recordings, separate) = (read(&self.recordings)?, read(&self.holdout)?);
        super::record::tell_notes(recordings.iter().chain(&separate));
        Ok(Inputs { model, source, recordings, separate })
    }

    /// Whether one of the results goes to standard output, so that nothing else may.
    pub fn takes_stdout(&self) -> bool {
        [&self.json, &self.html, &self.model_out].iter().any(|p| p.as_deref() == Some(Path::new("-")))
    }
}

impl Outputs {
    /// Writes what was asked for.
    pub fn finish(
        self,
        model: &Model,
        html: impl FnOnce() -> String,
        json: impl FnOnce() -> Result<String>,
    ) -> Result<()> {
        if let Some(sink) = self.model {
            sink.finish(model.to_toml().as_bytes())?;
        }
        if let Some(sink) = self.html {
            sink.finish(html().as_bytes())?;
        }
        if let Some(sink) = self.json {
            sink.finish(json()?.as_bytes())?;
        }
        Ok(())
    }
}
