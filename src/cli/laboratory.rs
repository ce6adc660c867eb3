//! `gyrospec laboratory`: how often the diagnosis finds what was concealed.

use super::output::words;
use super::progress::Meter;
use super::{Outcome, warn};
use crate::diagnose::answer::Answer;
use crate::diagnose::laboratory::{self, Case, Draw, Kind, Scenario};
use crate::estimate::fit::Progress;
use crate::model::Model;
use crate::record::{Recording, read_once};
use crate::{Error, ErrorKind, Result};
use rayon::prelude::*;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
const HELP: &str = "\
Examples:
  gyrospec laboratory --cases 20 --seed 1                # minutes
  gyrospec laboratory model.toml log.toml --cases 50     # your own model, inputs and noise";

/// Conceals effects in made recordings, diagnoses them from their files, and says how often it was right.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    /// A model file; without it, the laboratory's own axis.
    model: Option<PathBuf>,
    /// The recording whose inputs drive it.
    #[arg(requires = "model")]
    recording: Option<PathBuf>,
    /// How many recordings are made.
    #[arg(long, default_value_t = 20)]
    cases: usize,
    /// Seed of all that is drawn.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Conceal only this: none, one, two or outside.
    #[arg(long, value_parser = kind)]
    only: Option<Kind>,
    /// Keep recordings, models and the truth in this folder, which must be new or empty.
    #[arg(long)]
    keep: Option<PathBuf>,
}

pub fn run(call: &Call) -> Result<Outcome> {
    if call.cases == 0 {
        return Err(Error::usage("no recording is asked for: give --cases 1 or more"));
    }
    let scenario = match (&call.model, &call.recording) {
        (Some(model), Some(recording)) => {
            read_once([model.as_path(), recording])?;
            let (model, recording) = (Model::read(model)?, Recording::read(recording)?);
            super::record::tell_notes([&recording]);
            Scenario::of(&model, &recording, call.seed)?
        }
        (Some(_), None) => return Err(Error::usage("give the recording whose inputs drive the model")),
        _ => Scenario::axis(call.seed)?,
    };
    let own = tempfile::tempdir().map_err(|e| Error::io(&std::env::temp_dir(), &e))?;
    let folder = call.keep.as_deref().unwrap_or(own.path());
    fresh(folder)?;
    let draw = Draw { cases: call.cases, seed: call.seed, only: call.only };
    let cases = laboratory::make(&scenario, folder, &draw)?;
    let broken = |e: serde_json::Error| Error::new(ErrorKind::NotComputed, e.to_string());
    let sealed = folder.join("truth.json");
    let text = serde_json::to_vec_pretty(&cases).map_err(broken)?;
    std::fs::write(&sealed, &text).map_err(|e| Error::io(&sealed, &e))?;
    let seal: String = Sha256::digest(&text).iter().map(|b| format!("{b:02x}")).collect();
    let made = if call.cases == 1 { "1 recording".to_string() } else { format!("{} recordings", call.cases) };
    words(&format!("{made} made; the truth is sealed, SHA-256 {seal}\n\n"))?;
    drop(cases);
    Meter.report("diagnosing", Some(0.0));
    let ended = AtomicUsize::new(0);
    let examine = |number: usize| {
        let answer = laboratory::examine(folder, number, call.seed);
        let ended = 1 + ended.fetch_add(1, Ordering::Relaxed);
        Meter.report("diagnosing", Some(ended as f64 / call.cases as f64));
        answer.map_err(|e| warn(&format!("case {number}: {e}"))).ok()
    };
    let answers: Vec<Option<Answer>> = (0..call.cases).into_par_iter().with_max_len(1).map(examine).collect();
    let opened = std::fs::read(&sealed).map_err(|e| Error::io(&sealed, &e))?;
    let cases: Vec<Case> = serde_json::from_slice(&opened).map_err(broken)?;
    let kept: Vec<(Case, laboratory::Outcome)> = cases
        .into_iter()
        .zip(&answers)
        .filter_map(|(c, a)| a.as_ref().map(|a| (laboratory::judge(&c, a), c)).map(|(o, c)| (c, o)))
        .collect();
    let (cases, outcomes): (Vec<_>, Vec<_>) = kept.into_iter().unzip();
    let mut lines = String::new();
    for ((case, outcome), answer) in cases.iter().zip(&outcomes).zip(answers.iter().flatten()) {
        let named: Vec<&str> = answer.findings.iter().map(|f| f.code.as_str()).collect();
        lines += &format!(
            "{:>4}  {:<8} size {:<4} noise {:<5} {:<34} {:?}: {}\n",
            case.number,
            case.kind,
            case.size,
            case.correlation,
            case.codes.join(" + "),
            outcome.verdict,
            named.join(" + ")
        );
    }
    words(&format!("{lines}\n{}", laboratory::tabulate(&cases, &outcomes)))?;
    Ok(Outcome::Done)
}

/// A folder that is there and empty.
fn fresh(folder: &Path) -> Result<()> {
    let broken = |e: std::io::Error| Error::io(folder, &e);
    std::fs::create_dir_all(folder).map_err(broken)?;
    let is_empty = std::fs::read_dir(folder).map_err(broken)?.next().is_none();
    let full = || {
        Error::usage(format!(
            "{} is not empty: name a new folder",
            crate::text::in_line(&folder.display().to_string())
        ))
    };
    if is_empty { Ok(()) } else { Err(full()) }
}

fn kind(word: &str) -> std::result::Result<Kind, String> {
    let all = [Kind::None, Kind::One, Kind::Two, Kind::Outside];
    let found = all.into_iter().find(|k| k.word() == word);
    found.ok_or_else(|| format!("{word:?} is none of none, one, two, outside"))
}
