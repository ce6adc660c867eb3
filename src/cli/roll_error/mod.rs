//! `gyrospec roll-error`: mean and spread of the rolling error.

mod described;
mod equations;
mod examples;
mod formulas;
mod free;
mod json;
mod measured;
mod nonlinear;
mod options;
mod page;
mod parameters;
mod recording;
mod table;
mod tail;

use super::input::Held;
use super::{Outcome, output};
use crate::gyro::SIGN;
use crate::record::read_once;
use crate::report::polar;
use crate::{Error, Result};
use std::path::PathBuf;

/// Mean and spread of a gyrocompass's heading error on a rolling ship.
///
/// Without arguments: the two examples of the rolling-error paper, as derived and as printed.
#[derive(clap::Args)]
#[command(after_help = help())]
pub struct Arguments {
    /// Parameters of the compass: a model file, a file with [parameters], or a built-in model's
    /// name; - is standard input; without it the gyrocompass of the rolling-error paper.
    model_or_parameters: Option<PathBuf>,
    /// A recording of the ship's roll (CSV, or TOML); - is standard input.
    recording: Option<PathBuf>,
    /// Channel that is the roll angle, with its unit if the header has none: NAME or NAME:UNIT.
    #[arg(long, value_name = "NAME[:UNIT]")]
    roll: Option<String>,
    #[command(flatten)]
    instrument: options::InstrumentOptions,
    #[command(flatten)]
    motion: options::MotionOptions,
    #[command(flatten)]
    rows: options::RowOptions,
    /// Free motion instead: periods, damping and settling against latitude.
    #[arg(long, conflicts_with_all = FREE_OF)]
    free: bool,
    /// Closed form of the mean error, with its value on each --heading.
    #[arg(long, conflicts_with_all = LETTERS_HAVE_NO)]
    formula: bool,
    /// Polar picture of the error against heading, as SVG; - is standard output.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// A report with pictures, one page that opens offline; - is standard output.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
}

/// What says nothing of the free motion.
const FREE_OF: [&str; 16] = [
    "recording",
    "roll",
    "part",
    "vertical",
    "lever",
    "speed",
    "motion",
    "waves",
    "band",
    "against",
    "headings",
    "simulate",
    "seed",
    "svg",
    "html",
    "json",
];

/// What the closed form cannot show.
const LETTERS_HAVE_NO: [&str; 9] =
    ["free", "recording", "speed", "band", "against", "simulate", "seed", "svg", "html"];

/// Step of the headings in the picture, degrees; a divisor of the table's.
const PICTURE_STEP: usize = 3;

fn help() -> String {
    format!("The sign of the error: {SIGN}.\n\n{HELP}")
}

const HELP: &str = "\
Quantities are written with their unit, as 3m, 12kn, 5deg, 1.35e5N/m; without one they are in SI (latitude, heading: in degrees).
Examples:
  gyrospec roll-error
  gyrospec roll-error examples/roll.csv --html roll.html
  gyrospec roll-error --irregular 4deg,0.06,0.65 --latitude 60deg --svg error.svg
  gyrospec roll-error --sea jonswap --height 3m --period 8s --sea-from 60deg --also pitch,heave --against latitude
  gyrospec roll-error compass.toml ship.csv --roll roll_deg:deg --json
  gyrospec roll-error --free
  gyrospec roll-error --inertia --irregular 10deg,0.1,0.8 --band 2.5rad/s --heading 45deg --simulate 4";

pub fn run(a: &Arguments) -> Result<Outcome> {
    let read = a.model_or_parameters.iter().chain(&a.recording);
    let read: Vec<PathBuf> = read.cloned().collect();
    let [picture, html] = output::open([&a.svg, &a.html].map(Option::as_deref))?;
    output::spare(picture.iter().chain(&html), &read)?;
    let to_stdout = picture.iter().chain(&html).any(output::Place::is_standard_output);
    if to_stdout && a.json {
        return Err(Error::usage("standard output takes one result: a page, a picture or JSON")
            .with_hint("name a file for the picture or the page"));
    }
    read_once(a.model_or_parameters.iter().chain(&a.recording).map(PathBuf::as_path))?;
    let hold = |path: &Option<PathBuf>| path.as_deref().map(Held::of).transpose();
    let held = [hold(&a.model_or_parameters)?, hold(&a.recording)?];
    let (parameters, file) = files(&held);
    if let (Some(_), None) = (&a.roll, file) {
        return Err(Error::usage("--roll names the channel of a recording, and there is no recording"));
    }
    if is_bare(a) {
        output::words(&examples::text()?)?;
        return Ok(Outcome::Done);
    }
    let named = |e: Error| parameters.map_or(e.clone(), |held| held.place(e));
    let compass = parameters::read(parameters.map(Held::path), &a.instrument).map_err(named)?;
    if a.formula || a.free {
        if file.is_some() {
            return Err(Error::usage("a recording says nothing of the closed form or of the free motion"));
        }
        let text = if a.free { free::text(&compass)? } else { formulas::text(&compass, a)? };
        told(&text, a.json)?;
        return Ok(Outcome::Done);
    }
    computed(a, (compass, file), (picture, html), read)
}

/// The rows of a motion, put where they were asked for.
fn computed(
    a: &Arguments,
    (compass, file): (parameters::Compass, Option<&Held>),
    (picture, html): (Option<output::Place>, Option<output::Place>),
    mut read: Vec<PathBuf>,
) -> Result<Outcome> {
    let to_stdout = picture.iter().chain(&html).any(output::Place::is_standard_output);
    let mut rows = a.rows.clone();
    if (picture.is_some() || html.is_some()) && !rows.has_headings() && rows.days()?.is_none() {
        rows.step = PICTURE_STEP;
    }
    let mut plan = match file {
        Some(held) => {
            let recording = recording::read(held, a.roll.as_deref())?;
            super::record::tell_notes([&recording]);
            read.extend(recording.sources.iter().map(|s| s.file.clone()));
            output::spare(picture.iter().chain(&html), &read)?;
            measured::plan(&compass, &recording, a, &rows)?
        }
        None => table::Plan::of_options(compass, a, &rows)?,
    };
    let drawn = plan.evaluate(rows.days()?, rows.seed)?;
    let every = if rows.step == a.rows.step || rows.has_headings() { 1 } else { a.rows.step / rows.step };
    let result: Vec<&table::Row> = drawn.iter().step_by(every).collect();
    let text = if a.json { json::text(&plan, &result)? } else { table::text(&plan, &result) };
    let mut results = Vec::new();
    if let Some(place) = html {
        let page = page::html(&plan, (&drawn, &result), plan.compass.part(&a.instrument)?, a)?;
        results.push(place.data(page));
    }
    if let Some(place) = picture {
        results.push(place.data(polar::svg(&plan.polar(&drawn)?)));
    }
    output::put(&results, &read)?;
    if !to_stdout {
        told(&text, a.json)?;
    }
    Ok(Outcome::Done)
}

fn told(text: &str, json: bool) -> Result<()> {
    if json { output::quoted(text) } else { output::words(text) }
}

/// Whether nothing is asked for but the paper's examples.
fn is_bare(a: &Arguments) -> bool {
    let wants = a.formula || a.json || a.free || a.svg.is_some() || a.html.is_some();
    !wants && a.model_or_parameters.is_none() && !a.motion.given() && !a.rows.given() && a.instrument.plain()
}

/// A compass and a recording that lie in memory, or the path of a compass.
pub struct Given<'a> {
    pub path: Option<&'a std::path::Path>,
    pub text: Option<&'a str>,
    pub recording: Option<&'a crate::record::Recording>,
}

/// The same three ways.
pub struct Answer {
    pub json: String,
    pub text: String,
    /// The polar picture; empty where the rows do not run over headings.
    pub svg: String,
    /// The page.
    pub html: String,
}

/// What the options of the command line ask for, of what lies in memory.
pub fn answer(options: &[String], given: &Given<'_>) -> Result<Answer> {
    #[derive(clap::Parser)]
    struct Alone {
        #[command(flatten)]
        arguments: Arguments,
    }
    let words = std::iter::once("roll-error").chain(options.iter().map(String::as_str));
    let a = <Alone as clap::Parser>::try_parse_from(words).map_err(|e| usage(&e))?.arguments;
    let compass = match given.text {
        Some(text) => parameters::of_text(text, &a.instrument)?,
        None => parameters::read(given.path, &a.instrument)?,
    };
    let mut plan = match given.recording {
        Some(recording) => measured::plan(&compass, recording, &a, &a.rows)?,
        None if a.roll.is_some() => {
            return Err(Error::usage("roll names the channel of a recording, and there is none"));
        }
        None => table::Plan::of_options(compass, &a, &a.rows)?,
    };
    let drawn = plan.evaluate(a.rows.days()?, a.rows.seed)?;
    let rows: Vec<&table::Row> = drawn.iter().collect();
    let svg = if plan.against == options::Against::Heading && drawn.len() > 2 {
        polar::svg(&plan.polar(&drawn)?)
    } else {
        String::new()
    };
    let html = page::html(&plan, (&drawn, &rows), plan.compass.part(&a.instrument)?, &a)?;
    Ok(Answer { json: json::text(&plan, &rows)?, text: table::text(&plan, &rows), svg, html })
}

/// A parser's refusal without its advice on calling the program.
fn usage(e: &clap::Error) -> Error {
    let text = e.to_string();
    let says = text.split("\n\n").next().unwrap_or_default();
    Error::usage(says.trim_start_matches("error: ").trim_end())
}

/// A lone file is the compass if it has parameters, else the recording.
fn files(held: &[Option<Held>; 2]) -> (Option<&Held>, Option<&Held>) {
    match [held[0].as_ref(), held[1].as_ref()] {
        [Some(only), None] if !parameters::has_parameters(only.path()) => (None, Some(only)),
        [first, second] => (first, second),
    }
}
