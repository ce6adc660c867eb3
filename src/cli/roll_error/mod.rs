//! `gyrospec roll-error`: mean and spread of the rolling error.

mod answer;
mod card;
mod examples;
mod hints;
mod options;
mod part;
mod recording;
mod spectrum;

use super::compass;
use super::input::Held;
use super::progress::Meter;
use super::{Outcome, output};
use crate::estimate::fit::Progress;
use crate::gyro::SIGN;
use crate::record::read_once;
use crate::report::rolling::{
    Sheet, formula_json, formula_text, free_text, instruments_text, json, page, text,
};
use crate::report::rolling::{approval_json, approval_page, approval_text};
use crate::report::rolling::{deviation_csv, deviation_json, deviation_sheet, deviation_text};
use crate::report::{polar, rolling};
use crate::rolling::{Compass, Recorded, Request, Scorsby, Table, closed_form_on, closed_values, left_alone};
use crate::{Error, Result};
use answer::Instead;
use hints::worded;
use options::RowOptions;
use std::path::{Path, PathBuf};

/// Mean and spread of a gyrocompass's heading error on a rolling ship.
///
/// Without arguments: the two examples of the rolling-error paper (A. E. Potemkin 1978), as derived and as printed.
#[derive(clap::Args)]
#[command(after_help = help())]
pub struct Arguments {
    /// Parameters of the compass: a model file, a file with [parameters], or a built-in model's
    /// name; - is standard input; without it the gyrocompass of the rolling-error paper (Potemkin 1978).
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
    /// A report with pictures, one page that opens offline; of --card one sheet of A4; - is standard output.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// The card as CSV; - is standard output.
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
}

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
  gyrospec roll-error --list
  gyrospec roll-error --scorsby --lever 1m
  gyrospec roll-error --sea jonswap --period 9s --card 1m,2m,4m,6m --html card.html --csv card.csv
  gyrospec roll-error --regular 5deg,10s --card 2deg,10deg,15deg
  gyrospec roll-error --inertia --irregular 10deg,0.1,0.8 --band 2.5rad/s --heading 45deg --simulate 4
  gyrospec roll-error --inertia --flow 4s,0.1 --friction 2N --band 2.5rad/s --heading 45deg
Parts go together: each option of a part adds it to the suspension.";

pub fn run(a: &Arguments) -> Result<Outcome> {
    let read = a.model_or_parameters.iter().chain(&a.recording);
    let read: Vec<PathBuf> = read.cloned().collect();
    // the parser does not ask for what conflicts with another option, as --card does with --against
    if a.csv.is_some() && a.instead.card.is_none() {
        return Err(
            Error::usage("--csv writes the deviation card, and there is none").with_hint("say --card")
        );
    }
    if a.instead.list {
        output::words(&instruments_text())?;
        return Ok(Outcome::Done);
    }
    let places = Places::open(a)?;
    output::spare(places.all(), &read)?;
    if places.take_standard_output() && a.json {
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
    let compass = a.compass(parameters.map(Held::path)).map_err(named)?;
    if let Some(sizes) = &a.instead.card {
        return carded(a, sizes, (compass, file), places, read);
    }
    if a.instead.is_given() {
        if file.is_some() {
            return Err(Error::usage(
                "a recording says nothing of the closed form, the spectrum, the free motion or a Scorsby table",
            ));
        }
        if a.instead.spectrum {
            return spectrum::told(&compass, a, places.html, &read).map(|()| Outcome::Done);
        }
        if a.instead.scorsby {
            return scorsby(&compass, a.json, places.html, &read);
        }
        let text = if a.instead.free { free(&compass)? } else { formula(&compass, a)? };
        told(&text, a.json)?;
        return Ok(Outcome::Done);
    }
    computed(a, (compass, file), places, read)
}

/// The compass left alone, and a sudden change of 10 kn.
fn free(compass: &Compass) -> Result<String> {
    Ok(free_text(compass, &left_alone(&compass.sphere, 10.0 * 1852.0 / 3600.0)?))
}

/// The largest errors on a Scorsby table.
fn scorsby(
    compass: &Compass,
    as_json: bool,
    html: Option<output::Place>,
    read: &[PathBuf],
) -> Result<Outcome> {
    let approval = Scorsby::default().test(compass)?;
    let to_stdout = html.as_ref().is_some_and(output::Place::is_standard_output);
    let page = html.map(|place| place.data(approval_page(compass, &approval)));
    output::put(&page.into_iter().collect::<Vec<_>>(), read)?;
    if !to_stdout {
        let text =
            if as_json { approval_json(compass, &approval)? } else { approval_text(compass, &approval) };
        told(&text, as_json)?;
    }
    Ok(Outcome::Done)
}

/// The closed form, with its value on each heading.
fn formula(compass: &Compass, a: &Arguments) -> Result<String> {
    let excitation = a.motion.excitation(compass.roll)?.under_way(compass.speed);
    let closed = closed_form_on(compass.part.as_ref(), &excitation)?;
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

impl Arguments {
    /// The compass of a file, a built-in model or the paper, with what the options say of it.
    fn compass(&self, path: Option<&Path>) -> Result<Compass> {
        let put = self.instrument.put(compass::named(path)?);
        put.map_err(|e| path.map_or(e.clone(), |path| e.with_file(path)))
    }

    /// What the options ask for of a compass.
    fn request(&self, compass: Compass, rows: &RowOptions) -> Result<Request> {
        let excitation = self.motion.excitation(compass.roll)?.under_way(compass.speed);
        let against = rows.rows(&self.instrument, &self.motion)?;
        Ok(Request { compass, excitation, against, days: rows.days()? })
    }
}

impl Asked {
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

/// Where the results go.
struct Places {
    picture: Option<output::Place>,
    html: Option<output::Place>,
    csv: Option<output::Place>,
}

impl Places {
    fn open(a: &Arguments) -> Result<Self> {
        let [picture, html, csv] = output::open([&a.svg, &a.html, &a.csv].map(Option::as_deref))?;
        Ok(Self { picture, html, csv })
    }

    fn all(&self) -> impl Iterator<Item = &output::Place> {
        self.picture.iter().chain(&self.html).chain(&self.csv)
    }

    fn take_standard_output(&self) -> bool {
        self.all().any(output::Place::is_standard_output)
    }
}

/// The recording's question, whose files are read from here on.
fn of_recording(
    a: &Arguments,
    compass: &Compass,
    held: &Held,
    rows: &RowOptions,
    places: &Places,
    read: &mut Vec<PathBuf>,
) -> Result<Recorded> {
    let recording = recording::read(held, a.roll.as_deref())?;
    super::record::tell_notes([&recording]);
    read.extend(recording.sources.iter().map(|s| s.file.clone()));
    output::spare(places.all(), &*read)?;
    recording::asked(compass, &recording, a, rows)
}

/// The deviation card, put where it was asked for.
fn carded(
    a: &Arguments,
    sizes: &str,
    (compass, file): (Compass, Option<&Held>),
    places: Places,
    mut read: Vec<PathBuf>,
) -> Result<Outcome> {
    let card = match file {
        Some(held) => {
            card::of_recorded(sizes, &of_recording(a, &compass, held, &a.rows, &places, &mut read)?)?
        }
        None => card::of_options(a, sizes, &a.request(compass, &a.rows)?)?,
    };
    let to_stdout = places.take_standard_output();
    let html = places.html.map(|place| place.data(deviation_sheet(&card)));
    let csv = places.csv.map(|place| place.data(deviation_csv(&card)));
    output::put(&html.into_iter().chain(csv).collect::<Vec<_>>(), &read)?;
    if !to_stdout {
        told(&if a.json { deviation_json(&card)? } else { deviation_text(&card) }, a.json)?;
    }
    Ok(Outcome::Done)
}

/// The rows of a motion, put where they were asked for.
fn computed(
    a: &Arguments,
    (compass, file): (Compass, Option<&Held>),
    places: Places,
    mut read: Vec<PathBuf>,
) -> Result<Outcome> {
    let mut rows = a.rows.clone();
    if (places.picture.is_some() || places.html.is_some()) && !rows.has_headings() && rows.days()?.is_none() {
        rows.step = PICTURE_STEP;
    }
    let asked = match file {
        Some(held) => Asked::Recorded(Box::new(of_recording(a, &compass, held, &rows, &places, &mut read)?)),
        None => Asked::Options(Box::new(a.request(compass, &rows)?)),
    };
    let table = asked.table(&Meter)?;
    let every = if rows.step == a.rows.step || rows.has_headings() { 1 } else { a.rows.step / rows.step };
    let shown = table.every(every);
    let text = if a.json { json(&shown)? } else { text(&shown) };
    let to_stdout = places.take_standard_output();
    let mut results = Vec::new();
    if let Some(place) = places.html {
        let formula = table.closed_form().map(|f| f.text());
        let sheet = Sheet { table: &table, every, formula: formula.as_deref(), seed: a.rows.seed };
        results.push(place.data(page(&sheet)));
    }
    if let Some(place) = places.picture {
        let card = rolling::card(&table)
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
    if a.instead.is_given() {
        return Err(Error::usage(
            "only the table of errors is told here: ask for free, scorsby, formula or card on the command line",
        ));
    }
    let compass = match given.text {
        Some(text) => a.instrument.put(Compass::parse(text)?)?,
        None => a.compass(given.path)?,
    };
    let asked = match given.recording {
        Some(recording) => Asked::Recorded(Box::new(recording::asked(&compass, recording, &a, &a.rows)?)),
        None if a.roll.is_some() => {
            return Err(Error::usage("roll names the channel of a recording, and there is none"));
        }
        None => Asked::Options(Box::new(a.request(compass, &a.rows)?)),
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
