//! `gyrospec laboratory`: how often the diagnosis finds what was concealed.

use super::output::{self, Place, words};
use super::progress::Meter;
use super::{Outcome, warn};
use crate::diagnose::laboratory::{self, Case, Draw, Kind, Said, Scenario, plants};
use crate::error::nearest;
use crate::estimate::fit::Progress;
use crate::model::Model;
use crate::record::{Recording, read_once};
use crate::{Error, ErrorKind, Result};
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

const HELP: &str = "\
Examples:
  gyrospec laboratory --cases 20 --seed 1                # minutes
  gyrospec laboratory --plant ship --keep runs           # one plant; what is kept can be gone on with
  gyrospec laboratory model.toml log.toml --cases 50     # your own model and inputs";

/// Conceals effects in made recordings, diagnoses them from their files, and says how often it was right.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    /// A model file; without it, one of the laboratory's own plants for each recording, drawn.
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
    /// Only this plant: axis, pendulum, motor, tanks, room, ship, gyrosphere, battery or reactor.
    #[arg(long, conflicts_with = "model", value_parser = plant)]
    plant: Option<String>,
    /// Keep recordings, models, answers and the truth in this folder; the same call with it goes on where it was ended.
    #[arg(long)]
    keep: Option<PathBuf>,
}

pub fn run(call: &Call) -> Result<Outcome> {
    if call.cases == 0 {
        return Err(Error::usage("no recording is asked for: give --cases 1 or more"));
    }
    let own = tempfile::tempdir().map_err(|e| Error::io(&std::env::temp_dir(), &e))?;
    let folder = call.keep.as_deref().unwrap_or(own.path());
    let truth = folder.join("truth.json");
    let seal = made(call, folder, &truth)?;
    let count =
        if call.cases == 1 { "1 recording".to_string() } else { format!("{} recordings", call.cases) };
    words(&format!("{count} made; the truth is sealed, SHA-256 {seal}\n\n"))?;
    let cases: Vec<Case> = read(&truth)?;
    let said = examined(call, folder);
    let kept: Vec<(Case, Said)> = cases.into_iter().zip(said).filter_map(|(c, s)| Some((c, s?))).collect();
    let failed = call.cases - kept.len();
    if kept.is_empty() {
        return Err(Error::not_computed("no recording could be diagnosed: each says why above"));
    }
    let outcomes: Vec<laboratory::Outcome> = kept.iter().map(|(c, s)| laboratory::judge(c, s)).collect();
    let lines: String = kept.iter().map(|(c, s)| line(c, s)).collect();
    let cases: Vec<Case> = kept.into_iter().map(|(c, _)| c).collect();
    let table = laboratory::tabulate(&cases, &outcomes);
    let lost =
        if failed == 0 { String::new() } else { format!("not diagnosed: {failed} of {}\n", call.cases) };
    words(&format!("{lines}\n{lost}{table}"))?;
    Ok(Outcome::Done)
}

/// Makes the recordings, where the folder does not hold them already, and returns the seal of the truth.
fn made(call: &Call, folder: &Path, truth: &Path) -> Result<String> {
    if !begun(call, folder)? || !truth.exists() {
        let draw = Draw { cases: call.cases, seed: call.seed, only: call.only };
        let user = user(call)?;
        write(&folder.join(NOTED), &noted(call)?)?;
        let scenario = |rng: &mut ChaCha8Rng| match &user {
            Some(own) => Ok(own.clone()),
            None => Scenario::drawn(drawn(call, rng)?, rng),
        };
        write(truth, &laboratory::make(&scenario, folder, &draw, &Meter)?)?;
    }
    std::fs::read(truth).map(|text| sealed(&text)).map_err(|e| Error::io(truth, &e))
}

fn sealed(text: &[u8]) -> String {
    Sha256::digest(text).iter().map(|b| format!("{b:02x}")).collect()
}

/// The user's model, fitted, and recording; none where none is given.
fn user(call: &Call) -> Result<Option<Scenario>> {
    let (Some(model), Some(recording)) = (&call.model, &call.recording) else {
        let alone = call.model.is_some();
        let lacking = Error::usage("give the recording whose inputs drive the model");
        return if alone { Err(lacking) } else { Ok(None) };
    };
    read_once([model.as_path(), recording])?;
    let (model, recording) = (Model::read(model)?, Recording::read(recording)?);
    super::record::tell_notes([&recording]);
    Scenario::of(&model, &recording, call.seed).map(Some)
}

fn drawn(call: &Call, rng: &mut ChaCha8Rng) -> Result<&'static plants::Plant> {
    let is_asked = |p: &&plants::Plant| call.plant.as_ref().is_none_or(|name| p.name == name);
    let asked: Vec<&plants::Plant> = plants::ALL.iter().filter(is_asked).collect();
    asked.choose(rng).copied().ok_or_else(|| Error::not_computed("the laboratory has no plant"))
}

/// What was said of each case; what the folder already holds is not asked anew.
fn examined(call: &Call, folder: &Path) -> Vec<Option<Said>> {
    Meter.report("diagnosing", Some(0.0));
    let ended = AtomicUsize::new(0);
    let examine = |number: usize| {
        let path = folder.join(format!("answer-{number}.json"));
        let keep = |said: &Said| {
            let kept = write(&path, said);
            kept.unwrap_or_else(|e| warn(&format!("the answer to case {number} is not kept: {e}")));
        };
        let said = read(&path).or_else(|_| laboratory::examine(folder, number, call.seed).inspect(keep));
        let ended = 1 + ended.fetch_add(1, Ordering::Relaxed);
        Meter.report("diagnosing", Some(ended as f64 / call.cases as f64));
        said.map_err(|e| warn(&format!("case {number}: {e}"))).ok()
    };
    (0..call.cases).into_par_iter().with_max_len(1).map(examine).collect()
}

fn line(case: &Case, said: &Said) -> String {
    let name = |f: &laboratory::Named| match f.ties.len() {
        0 => f.code.clone(),
        n => format!("{} (or {n} more)", f.code),
    };
    let named: Vec<String> = said.findings.iter().map(name).collect();
    let hidden: Vec<&str> = case.hidden.iter().map(|h| h.code.as_str()).collect();
    let size = if case.size > 0.0 { format!("size {}", case.size) } else { String::new() };
    format!(
        "{:>4}  {:<10} {:<8} {size:<8} noise {:<5} {:<34} {:?}: {}\n",
        case.number,
        case.plant,
        case.kind.word(),
        case.correlation,
        hidden.join(" + "),
        said.verdict,
        named.join(" + ")
    )
}

fn broken(e: &serde_json::Error) -> Error {
    Error::new(ErrorKind::NotComputed, e.to_string())
}

fn read<T: DeserializeOwned>(path: &Path) -> Result<T> {
    let text = std::fs::read(path).map_err(|e| Error::io(path, &e))?;
    serde_json::from_slice(&text).map_err(|e| Error::bad_input(e.to_string()).with_file(path))
}

fn write(path: &Path, value: &impl Serialize) -> Result<()> {
    let text = serde_json::to_vec_pretty(value).map_err(|e| broken(&e))?;
    output::put(&[Place::open(path)?.data(text)], std::iter::empty::<&Path>())
}

/// The file that says which call a folder is of.
const NOTED: &str = "call.json";

fn noted(call: &Call) -> Result<serde_json::Value> {
    let held = |path: &Option<PathBuf>| -> Result<Option<String>> {
        let read =
            |path: &PathBuf| std::fs::read(path).map(|text| sealed(&text)).map_err(|e| Error::io(path, &e));
        path.as_ref().map(read).transpose()
    };
    let files = [held(&call.model)?, held(&call.recording)?];
    let this = (env!("CARGO_PKG_VERSION"), call.cases, call.seed, call.only, &call.plant, files);
    serde_json::to_value(this).map_err(|e| broken(&e))
}

/// Whether the folder holds this very call, ended before its time; else it is a new or an empty one.
fn begun(call: &Call, folder: &Path) -> Result<bool> {
    let io = |e: std::io::Error| Error::io(folder, &e);
    if folder.is_file() {
        return Err(Error::usage(format!("--keep takes a folder, and {} is a file", folder.display())));
    }
    std::fs::create_dir_all(folder).map_err(io)?;
    if std::fs::read_dir(folder).map_err(io)?.next().is_none() {
        return Ok(false);
    }
    let (this, path) = (noted(call)?, folder.join(NOTED));
    if read::<serde_json::Value>(&path).is_ok_and(|held| held == this) {
        return Ok(true);
    }
    let shown = folder.display().to_string();
    let shown = crate::text::in_line(&shown);
    let other = if path.exists() { "holds the recordings of another call" } else { "is not empty" };
    Err(Error::usage(format!("{shown} {other}: name a new folder")))
}

fn plant(word: &str) -> std::result::Result<String, String> {
    let names = || plants::ALL.iter().map(|p| p.name);
    if names().any(|n| n == word) {
        return Ok(word.to_string());
    }
    let near = nearest(word, names()).map(|n| format!(", the nearest is {n}")).unwrap_or_default();
    Err(format!("the laboratory has no plant {word:?}{near}"))
}

fn kind(word: &str) -> std::result::Result<Kind, String> {
    let all = [Kind::None, Kind::One, Kind::Two, Kind::Outside];
    let found = all.into_iter().find(|k| k.word() == word);
    found.ok_or_else(|| format!("{word:?} is none of none, one, two, outside"))
}
