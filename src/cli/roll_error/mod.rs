//! `gyrospec roll-error`: mean and spread of the rolling error.

mod compass;
mod examples;
mod hints;
mod options;
mod part;
mod recording;

use super::input::Held;
use super::progress::Meter;
use super::{Outcome, output};
use crate::estimate::fit::Progress;
use crate::gyro::SIGN;
use crate::record::read_once;
use crate::report::polar;
use crate::report::rolling::{Sheet, card, formula_json, formula_text, free_text, json, page, text};
use crate::report::rolling::{approval_json, approval_text};
use crate::rolling::{Compass, Recorded, Request, Scorsby, Table, closed_form, closed_values, left_alone};
use crate::{Error, Result};
use hints::worded;
use options::RowOptions;
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
    #[command(flatten)]
    instead: Instead,
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

/// What may be told in place of a table of errors.
#[derive(clap::Args)]
struct Instead {
    /// Free motion instead: periods, damping and settling against latitude.
    #[arg(long, conflicts_with_all = FREE_OF)]
    free: bool,
    /// The largest errors on a Scorsby table instead, beside what type approval allows.
    #[arg(long, conflicts_with_all = SCORSBY_SETS)]
    scorsby: bool,
    /// Closed form of the mean error, with its value on each --heading.
    #[arg(long, conflicts_with_all = LETTERS_HAVE_NO)]
    formula: bool,
}

impl Instead {
    /// Whether it is asked for.
    fn is_given(&self) -> bool {
        self.free || self.scorsby || self.formula
    }
}

/// What says nothing of the free motion.
const FREE_OF: [&str; 15] = [
    "recording",
    "roll",
    "part",
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

/// What the table sets itself, or what is not told of it.
const SCORSBY_SETS: [&str; 14] = [
    "free",
    "formula",
    "recording",
    "roll",
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
];

/// What the closed form cannot show.
const LETTERS_HAVE_NO: [&str; 8] =
    ["free", "recording", "speed", "against", "simulate", "seed", "svg", "html"];

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
  gyrospec roll-error --scorsby --lever 1m
  gyrospec roll-error --inertia --irregular 10deg,0.1,0.8 --band 2.5rad/s --heading 45deg --simulate 4
  gyrospec roll-error --inertia --flow 4s,0.1 --friction 2N --band 2.5rad/s --heading 45deg
Parts go together: each option of a part adds it to the suspension.";

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
    let compass = compass::read(parameters.map(Held::path), &a.instrument).map_err(named)?;
    if a.instead.is_given() {
        if file.is_some() {
            return Err(Error::usage(
                "a recording says nothing of the closed form, of the free motion or of a Scorsby table",
            ));
        }
        let text = match (a.instead.free, a.instead.scorsby) {
            (true, _) => free(&compass)?,
            (_, true) => scorsby(&compass, a.json)?,
            _ => formula(&compass, a)?,
        };
        told(&text, a.json)?;
        return Ok(Outcome::Done);
    }
    computed(a, (compass, file), (picture, html), read)
}

/// The compass left alone, and a sudden change of 10 kn.
fn free(compass: &Compass) -> Result<String> {
    Ok(free_text(compass, &left_alone(&compass.sphere, 10.0 * 1852.0 / 3600.0)?))
}

/// The largest errors on a Scorsby table.
fn scorsby(compass: &Compass, as_json: bool) -> Result<String> {
    let approval = Scorsby::default().test(compass)?;
    if as_json { approval_json(compass, &approval) } else { Ok(approval_text(compass, &approval)) }
}

/// The closed form, with its value on each heading.
fn formula(compass: &Compass, a: &Arguments) -> Result<String> {
    if a.motion.is_sea() {
        return Err(Error::usage("a sea's fitted spectrum has no short formula")
            .with_hint("leave --sea away: the formula is for irregular roll of the form (3.3)"));
    }
    if a.motion.is_regular() {
        return Err(Error::usage("the closed form is for irregular roll; on regular roll the lag has (2.4)").with_hint(
            "−P²θ₀²h²p⁴ sin 2K/(4 g² H U C₀ cos φ (1 + p²T²)) = mean α; --regular without --formula gives its value",
        ));
    }
    let excitation = a.motion.excitation(compass.roll)?;
    let closed = closed_form(compass.part.as_ref(), excitation.band)?;
    let headings = if a.rows.has_headings() { a.rows.headings()? } else { vec![45f64.to_radians()] };
    let values = closed_values(compass, &excitation, &headings)?;
    Ok(if a.json {
        formula_json(compass, &excitation, &closed, &values)
    } else {
        formula_text(compass, &excitation, &closed, &values)
    })
}

/// What is asked for.
pub enum Asked {
    /// Of what the options describe.
    Options(Box<Request>),
    /// Of a recorded roll.
    Recorded(Box<Recorded>),
}

impl Asked {
    fn options(compass: Compass, a: &Arguments, rows: &RowOptions) -> Result<Self> {
        let excitation = a.motion.excitation(compass.roll)?;
        let against = rows.rows(&a.instrument, &a.motion)?;
        Ok(Self::Options(Box::new(Request { compass, excitation, against, days: rows.days()? })))
    }

    /// The table, or what stands against it in the words of the options.
    pub fn table(&self, progress: &dyn Progress) -> Result<Table> {
        match self {
            Self::Recorded(recorded) => recorded.table(progress),
            Self::Options(request) => {
                let prepared = request.prepare()?;
                match prepared.obstacle()? {
                    Some(obstacle) => Err(worded(&obstacle)),
                    None => prepared.table(progress),
                }
            }
        }
    }
}

/// The rows of a motion, put where they were asked for.
fn computed(
    a: &Arguments,
    (compass, file): (Compass, Option<&Held>),
    (picture, html): (Option<output::Place>, Option<output::Place>),
    mut read: Vec<PathBuf>,
) -> Result<Outcome> {
    let to_stdout = picture.iter().chain(&html).any(output::Place::is_standard_output);
    let mut rows = a.rows.clone();
    if (picture.is_some() || html.is_some()) && !rows.has_headings() && rows.days()?.is_none() {
        rows.step = PICTURE_STEP;
    }
    let asked = match file {
        Some(held) => {
            let recording = recording::read(held, a.roll.as_deref())?;
            super::record::tell_notes([&recording]);
            read.extend(recording.sources.iter().map(|s| s.file.clone()));
            output::spare(picture.iter().chain(&html), &read)?;
            Asked::Recorded(Box::new(recording::asked(&compass, &recording, a, &rows)?))
        }
        None => Asked::options(compass, a, &rows)?,
    };
    let table = asked.table(&Meter)?;
    let every = if rows.step == a.rows.step || rows.has_headings() { 1 } else { a.rows.step / rows.step };
    let shown = table.every(every);
    let text = if a.json { json(&shown)? } else { text(&shown) };
    let mut results = Vec::new();
    if let Some(place) = html {
        let formula = table.closed_form().map(|f| f.text());
        let sheet = Sheet { table: &table, every, formula: formula.as_deref(), seed: a.rows.seed };
        results.push(place.data(page(&sheet)));
    }
    if let Some(place) = picture {
        let card = card(&table)
            .ok_or_else(|| Error::usage("the polar picture runs over headings; leave --against away"))?;
        results.push(place.data(polar::svg(&card)));
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
    let wants = a.instead.is_given() || a.json || a.svg.is_some() || a.html.is_some();
    !wants && a.model_or_parameters.is_none() && !a.motion.given() && !a.rows.given() && a.instrument.plain()
}

/// A compass and a recording that lie in memory, or the path of a compass.
pub struct Given<'a> {
    pub path: Option<&'a std::path::Path>,
    pub text: Option<&'a str>,
    pub recording: Option<&'a crate::record::Recording>,
}

/// What the words of the options ask for, of what lies in memory, and the seed.
pub fn asked(options: &[String], given: &Given<'_>) -> Result<(Asked, u64)> {
    #[derive(clap::Parser)]
    struct Alone {
        #[command(flatten)]
        arguments: Arguments,
    }
    let words = std::iter::once("roll-error").chain(options.iter().map(String::as_str));
    let a = <Alone as clap::Parser>::try_parse_from(words).map_err(|e| usage(&e))?.arguments;
    let compass = match given.text {
        Some(text) => compass::with(Compass::parse(text)?, &a.instrument)?,
        None => compass::read(given.path, &a.instrument)?,
    };
    let asked = match given.recording {
        Some(recording) => Asked::Recorded(Box::new(recording::asked(&compass, recording, &a, &a.rows)?)),
        None if a.roll.is_some() => {
            return Err(Error::usage("roll names the channel of a recording, and there is none"));
        }
        None => Asked::options(compass, &a, &a.rows)?,
    };
    Ok((asked, a.rows.seed))
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
        [Some(only), None] if !compass::has_parameters(only.path()) => (None, Some(only)),
        [first, second] => (first, second),
    }
}
