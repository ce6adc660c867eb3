//! `gyrospec fit`: a model fitted to recordings.

use super::output::{Sink, print};
use super::progress::Meter;
use super::{Outcome, warn};
use crate::Result;
use crate::estimate::fit::{self, Fit, FitOptions, HeldOut};
use crate::model::Model;
use crate::record::Recording;
use std::path::PathBuf;

mod json;
mod text;

/// Fits the free parameters and initial states of a model to recordings, by simulation.
#[derive(clap::Args)]
pub struct Call {
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
    /// Writes the model with the fitted values in place.
    #[arg(long, value_name = "FILE")]
    model_out: Option<PathBuf>,
    /// Seed of the starts that are drawn at random.
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// A fit with all that a report of it says.
pub struct Told<'a> {
    pub fit: &'a Fit,
    pub held_out: &'a [HeldOut],
    pub recordings: &'a [Recording],
    pub separate: &'a [Recording],
    pub seed: u64,
}

#[cfg(feature = "python")]
impl Told<'_> {
    /// As JSON.
    pub fn json(&self) -> Result<String> {
        json::render(self)
    }

    /// As words.
    pub fn text(&self) -> String {
        text::render(self)
    }
}

pub fn run(call: &Call) -> Result<Outcome> {
    let json = call.json.as_deref().map(Sink::open).transpose()?;
    let model_out = call.model_out.as_deref().map(Sink::open).transpose()?;
    let model = Model::read(&call.model)?;
    let read =
        |files: &[PathBuf]| files.iter().map(|f| Recording::read(f.as_path())).collect::<Result<Vec<_>>>();
    let (recordings, separate) = (read(&call.recordings)?, read(&call.holdout)?);
    super::record::tell_notes(recordings.iter().chain(&separate));
    tell_twins(&recordings, &separate);
    let meter = Meter::new();
    let options = FitOptions {
        seed: call.seed,
        separate_holdout: !separate.is_empty(),
        progress: &meter,
        ..FitOptions::default()
    };
    let fitted = fit::fit(&model, &recordings, &options)?;
    let held_out = fit::holdout(&fitted, &recordings, &separate, &options)?;
    drop(meter);
    for warning in &fitted.warnings {
        warn(&warning.says);
    }
    let told = Told {
        fit: &fitted,
        held_out: &held_out,
        recordings: &recordings,
        separate: &separate,
        seed: call.seed,
    };
    if let Some(sink) = model_out {
        sink.finish(fitted.model.to_toml().as_bytes())?;
    }
    match json {
        Some(sink) => {
            if call.json.as_deref() != Some(std::path::Path::new("-")) {
                print(text::render(&told).as_bytes())?;
            }
            sink.finish(json::render(&told)?.as_bytes())?;
        }
        None => print(text::render(&told).as_bytes())?,
    }
    Ok(if fitted.unseen.is_empty() { Outcome::Done } else { Outcome::Found })
}

/// Warns of recordings that are given twice.
fn tell_twins(recordings: &[Recording], separate: &[Recording]) {
    let same = |a: &Recording, b: &Recording| {
        a.sources.iter().map(|s| &s.sha256).eq(b.sources.iter().map(|s| &s.sha256))
    };
    for (i, recording) in recordings.iter().enumerate() {
        if recordings[..i].iter().any(|earlier| same(earlier, recording)) {
            warn(&format!(
                "'{}' is given twice: the intervals come out too narrow, since it tells nothing new",
                recording.name
            ));
        }
        if separate.iter().any(|s| same(s, recording)) {
            warn(&format!(
                "'{}' is fitted and held out: what is held out proves nothing then",
                recording.name
            ));
        }
    }
}
