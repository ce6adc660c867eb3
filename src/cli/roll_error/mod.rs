//! `gyrospec roll-error`: mean and spread of the rolling error.

mod examples;
mod formulas;
mod free;
mod json;
mod measured;
mod options;
mod page;
mod parameters;
mod recording;
mod table;

use super::output::Sink;
use super::{Outcome, output};
use crate::report::polar;
use crate::{Error, Result};
use std::path::{Path, PathBuf};

/// Mean and spread of a gyrocompass's heading error on a rolling ship.
///
/// Without arguments: the two examples of the rolling-error paper, as derived and as printed.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Arguments {
    /// Parameters of the compass: a model file, a file with [parameters], or a built-in model's
    /// name; without it the gyrocompass of the rolling-error paper.
    model_or_parameters: Option<PathBuf>,
    /// A recording of the ship's roll (CSV, or TOML).
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
    #[arg(long)]
    free: bool,
    /// Closed form of the mean error.
    #[arg(long)]
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

/// Step of the headings in the picture, degrees; a divisor of the table's.
const PICTURE_STEP: usize = 3;

const HELP: &str = "\
Quantities are written with their unit, as 3m, 12kn, 5deg, 1.35e5N/m; without one they are in SI (latitude, heading: in degrees).
Examples:
  gyrospec roll-error
  gyrospec roll-error examples/roll.csv --html roll.html
  gyrospec roll-error --irregular 4deg,0.06,0.65 --latitude 60deg --svg error.svg
  gyrospec roll-error --sea jonswap --height 3m --period 8s --also pitch,heave --against latitude
  gyrospec roll-error compass.toml ship.csv --roll roll_deg:deg --json
  gyrospec roll-error --free
  gyrospec roll-error --inertia --irregular 10deg,0.1,0.8 --heading 45deg --simulate 4";

pub fn run(a: &Arguments) -> Result<Outcome> {
    let read = a.model_or_parameters.iter().chain(&a.recording);
    output::keep_apart([&a.svg, &a.html].map(Option::as_ref), read)?;
    let picture = a.svg.as_deref().map(Sink::open).transpose()?;
    let html = a.html.as_deref().map(Sink::open).transpose()?;
    let drawn_too = picture.is_some() || html.is_some();
    let (parameters, file) = files(a);
    let bare = parameters.is_none() && file.is_none() && !a.motion.given() && !a.rows.given();
    if bare && !a.formula && !a.json && !a.free && !drawn_too && a.instrument.plain() {
        output::print(examples::text()?.as_bytes())?;
        return Ok(Outcome::Done);
    }
    let compass = parameters::read(parameters, &a.instrument)?;
    if a.formula {
        output::print(formulas::text(compass.part(&a.instrument)?, &a.motion, a.json)?.as_bytes())?;
        return Ok(Outcome::Done);
    }
    if a.free {
        output::print(free::text(&compass)?.as_bytes())?;
        return Ok(Outcome::Done);
    }
    let mut rows = a.rows.clone();
    if drawn_too && !rows.has_headings() && rows.days()?.is_none() {
        rows.step = PICTURE_STEP;
    }
    let plan = match file {
        Some(path) => measured::plan(&compass, &recording::read(path, a.roll.as_deref())?, a, &rows)?,
        None => table::Plan::of_options(compass, a, &rows)?,
    };
    let drawn = plan.evaluate(rows.days()?, rows.seed)?;
    let every = if rows.step == a.rows.step || rows.has_headings() { 1 } else { a.rows.step / rows.step };
    let result: Vec<&table::Row> = drawn.iter().step_by(every).collect();
    let text = if a.json { json::text(&plan, &result)? } else { table::text(&plan, &result) };
    if let Some(sink) = html {
        sink.finish(page::html(&plan, (&drawn, &result), plan.compass.part(&a.instrument)?, a)?.as_bytes())?;
    }
    if let Some(sink) = picture {
        sink.finish(polar::svg(&plan.polar(&drawn)?).as_bytes())?;
    }
    if ![&a.svg, &a.html].iter().any(|p| p.as_deref() == Some(Path::new("-"))) {
        output::print(text.as_bytes())?;
    }
    Ok(Outcome::Done)
}

/// A compass and a recording that lie in memory, or the path of a compass.
#[cfg(feature = "python")]
pub struct Given<'a> {
    pub path: Option<&'a Path>,
    pub text: Option<&'a str>,
    pub recording: Option<&'a crate::record::Recording>,
}

/// The same three ways.
#[cfg(feature = "python")]
pub struct Answer {
    pub json: String,
    pub text: String,
    /// The polar picture; empty where the rows do not run over headings.
    pub svg: String,
    /// The page.
    pub html: String,
}

/// What the options of the command line ask for, of what lies in memory.
#[cfg(feature = "python")]
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
    let plan = match given.recording {
        Some(recording) => measured::plan(&compass, recording, &a, &a.rows)?,
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
#[cfg(feature = "python")]
fn usage(e: &clap::Error) -> Error {
    let text = e.to_string();
    let says = text.split("\n\n").next().unwrap_or_default();
    Error::usage(says.trim_start_matches("error: ").trim_end())
}

/// A lone file is the compass if it has parameters, else the recording.
fn files(a: &Arguments) -> (Option<&Path>, Option<&Path>) {
    match (a.model_or_parameters.as_deref(), a.recording.as_deref()) {
        (Some(only), None) if !parameters::has_parameters(only) => (None, Some(only)),
        (first, second) => (first, second),
    }
}

/// `3m`, `3 m` or `3`: a number with a unit of the dimension of `si`, or in SI without one.
fn quantity(option: &str, text: &str, si: &str) -> Result<f64> {
    let text = text.trim();
    // the longest head that is a number
    let cut = (1..=text.len())
        .rev()
        .filter(|i| text.is_char_boundary(*i))
        .find(|i| text[..*i].trim().parse::<f64>().is_ok());
    let wrong = || Error::usage(format!("--{option}: `{text}` is no quantity, such as 3{si}"));
    let (number, unit) = text.split_at(cut.ok_or_else(wrong)?);
    let value: f64 = number.trim().parse().map_err(|_| wrong())?;
    if !value.is_finite() {
        return Err(wrong());
    }
    if unit.trim().is_empty() {
        return Ok(value);
    }
    let unit = crate::units::Unit::parse(unit.trim())?;
    if unit.dimension() != crate::units::Unit::parse(si)?.dimension() {
        return Err(Error::new(crate::ErrorKind::Units, format!("--{option}: {unit} where {si} is meant")));
    }
    Ok(unit.to_si(value))
}

/// An angle on the compass card: a bare number is in degrees; rad.
fn angle(option: &str, text: &str) -> Result<f64> {
    match text.trim().parse::<f64>() {
        Ok(v) if v.is_finite() => Ok(v.to_radians()),
        _ => quantity(option, text, "rad"),
    }
}

/// A list of quantities of given units.
fn quantities(option: &str, text: &str, si: &[&str]) -> Result<Vec<f64>> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() != si.len() {
        return Err(Error::usage(format!("--{option} takes {} numbers with commas between", si.len())));
    }
    parts.iter().zip(si).map(|(p, u)| quantity(option, p, u)).collect()
}
