//! What `fit` and `diagnose` take and give: a model, recordings, and files for the results.

use super::output::{self, Place};
use super::progress::Meter;
use crate::model::Model;
use crate::record::{Recording, Source, read_once};
use crate::{Asking, Error, Result};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The arguments.
#[derive(clap::Args)]
pub struct Task {
    /// The model file, or the name of a built-in model; `-` is standard input.
    model: PathBuf,
    /// Recordings: CSV or TOML files, `-` is standard input; parameters are shared, initial states are each one's own.
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
    /// Writes the model with the fitted values in place; `diagnose` also writes what it found into it.
    #[arg(long, value_name = "FILE")]
    model_out: Option<PathBuf>,
    /// Seed of all that is drawn at random.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Wall time after which the search ends with the best so far; the same inputs then no longer give the
    /// same bytes.
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    time_limit: Option<Duration>,
}

/// A wall time.
fn seconds(text: &str) -> std::result::Result<Duration, String> {
    let wanted = text.trim().parse::<f64>().ok().filter(|s| *s > 0.0);
    wanted
        .and_then(|s| Duration::try_from_secs_f64(s).ok())
        .ok_or_else(|| "give a number of seconds above 0, such as 60".to_string())
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
    json: Option<Place>,
    html: Option<Place>,
    model: Option<Place>,
}

impl Task {
    /// What is asked, with all that the options say of it.
    pub fn said<'a, R>(&self, asked: Asking<'a, R>, inputs: &'a Inputs) -> Asking<'a, R> {
        let asked = asked.holdout(&inputs.separate).source(&inputs.source);
        asked.seed(self.seed).time_limit(self.time_limit).progress(&Meter)
    }

    /// Opens the places for the results.
    pub fn open(&self) -> Result<Outputs> {
        let [json, html, model] =
            output::open([&self.json, &self.html, &self.model_out].map(Option::as_deref))?;
        // A model may be written over itself, with the fitted values in place.
        let outputs = Outputs { json, html, model: model.map(|place| place.in_place_of(&self.model)) };
        output::spare(outputs.places(), self.recordings.iter().chain(&self.holdout).chain([&self.model]))?;
        Ok(outputs)
    }

    /// Reads model and recordings, and sees that no result would destroy a file that they name.
    pub fn read(&self, outputs: &Outputs) -> Result<Inputs> {
        read_once(
            [&self.model].into_iter().chain(&self.recordings).chain(&self.holdout).map(PathBuf::as_path),
        )?;
        if outputs.model.as_ref().is_some_and(Place::is_in_place) {
            spare_comments(&self.model)?;
            super::warn(
                "--model-out names the model itself: the fitted values take the place of those in it",
            );
        }
        let (model, source) = Model::read_with_source(&self.model)?;
        let read =
            |files: &[PathBuf]| files.iter().map(|f| model.read_recording(f)).collect::<Result<Vec<_>>>();
        let (recordings, separate) = (read(&self.recordings)?, read(&self.holdout)?);
        super::record::tell_notes(recordings.iter().chain(&separate));
        let inputs = Inputs { model, source, recordings, separate };
        output::spare(outputs.places(), inputs.files())?;
        Ok(inputs)
    }
}

/// Refuses to write a model over itself where it has comments: what is written has none.
fn spare_comments(model: &Path) -> Result<()> {
    let text = std::fs::read_to_string(model).unwrap_or_default();
    match text.lines().position(has_comment) {
        Some(at) => Err(Error::usage("this model has comments, and a model that is written has none")
            .with_file(model)
            .with_line(at + 1)
            .with_hint("name another file for --model-out, or say it by meaning = \"…\", which is kept")),
        None => Ok(()),
    }
}

/// Whether a line of TOML has a comment: a # outside quotes.
fn has_comment(line: &str) -> bool {
    let mut quote = None;
    line.chars().any(|c| {
        match quote {
            Some(q) if q == c => quote = None,
            None if c == '"' || c == '\'' => quote = Some(c),
            _ => {}
        }
        quote.is_none() && c == '#'
    })
}

impl Inputs {
    /// Every file that was read.
    fn files(&self) -> impl Iterator<Item = &PathBuf> {
        let recordings = self.recordings.iter().chain(&self.separate);
        let simulated = self.model.begun_with();
        recordings.flat_map(|r| &r.sources).chain([&self.source]).chain(simulated).map(|s| &s.file)
    }
}

impl Outputs {
    fn places(&self) -> impl Iterator<Item = &Place> {
        [&self.json, &self.html, &self.model].into_iter().flatten()
    }

    /// Whether one of the results goes to standard output, so that nothing else may.
    pub fn take_stdout(&self) -> bool {
        self.places().any(Place::is_standard_output)
    }

    /// Writes what was asked for: all of it, or nothing.
    pub fn finish(
        self,
        inputs: &Inputs,
        model: &Model,
        html: impl FnOnce() -> String,
        json: impl FnOnce() -> Result<String>,
    ) -> Result<()> {
        let mut results = Vec::new();
        if let Some(place) = self.model {
            let text = place.folder().map_or_else(|| model.to_toml(), |f| model.to_toml_in(f));
            results.push(place.quoted(&text));
        }
        if let Some(place) = self.html {
            results.push(place.data(html()));
        }
        if let Some(place) = self.json {
            results.push(place.quoted(&json()?));
        }
        output::put(&results, inputs.files())
    }
}
