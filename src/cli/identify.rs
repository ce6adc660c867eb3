//! `gyrospec identify`: T and C₀ of a compass from errors measured on regular roll.

use super::compass::named;
use super::input::Held;
use super::quantity::{latitude as latitude_of, quantity};
use super::{Outcome, note, output};
use crate::gyro::range;
use crate::record::{Input, Recording};
use crate::report::identified::{json, page, text};
use crate::rolling::{Compass, Identification, identification};
use crate::units::{Unit, significant};
use crate::{Error, Result};
use clap::Parser;
use std::path::PathBuf;

/// T and C0 of a compass from a table of errors measured on regular roll.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    /// The trials: CSV with units in its header, or a TOML recording of kind "trials"; - is standard input.
    trials: PathBuf,
    /// Parameters of the compass: a file with [parameters], or a built-in model; without it the paper's gyrocompass.
    #[arg(long, value_name = "FILE")]
    compass: Option<PathBuf>,
    /// Latitude of trials without a column of it, in degrees or as 60°12'N.
    #[arg(long, allow_hyphen_values = true)]
    latitude: Option<String>,
    /// Height of the compass above the roll axis, for amplitudes that are angles.
    #[arg(long, allow_hyphen_values = true)]
    lever: Option<String>,
    /// A report with pictures, one page that opens offline; - is standard output.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
}

const HELP: &str = "\
One row a steady trial: heading, amplitude (of the compass's path, as 23.5 cm, or of the roll, as 5 deg, which --lever
multiplies), period or frequency, error (+ is west), and latitude where it differs. Rows with gaps are left out.
Examples:
  gyrospec identify trials.csv --latitude 46.5
  gyrospec identify trials.csv --compass compass.toml --json";

/// Runs the subcommand.
pub fn run(call: &Call) -> Result<Outcome> {
    let read: Vec<PathBuf> = [&call.trials].into_iter().chain(&call.compass).cloned().collect();
    let [html] = output::open([call.html.as_deref()])?;
    output::spare(html.iter(), &read)?;
    let to_stdout = html.as_ref().is_some_and(output::Place::is_standard_output);
    if to_stdout && call.json {
        return Err(Error::usage("standard output takes one result: a page or JSON")
            .with_hint("name a file for the page"));
    }
    let told = found(call)?;
    let page = html.map(|place| place.data(page(&told)));
    output::put(&page.into_iter().collect::<Vec<_>>(), &read)?;
    if to_stdout {
        return Ok(Outcome::Done);
    }
    if call.json { output::quoted(&json(&told)?) } else { output::words(&text(&told)) }?;
    Ok(Outcome::Done)
}

/// The JSON for words said elsewhere: the file of the trials, and options such as `--latitude=60`.
///
/// # Errors
/// `Usage` for options that are none, and what the command refuses.
pub fn answer(words: &[String]) -> Result<String> {
    let said = Said::try_parse_from(words).map_err(|e| Error::usage(e.to_string()))?;
    json(&found(&said.call)?)
}

#[derive(Parser)]
#[command(name = "identify", no_binary_name = true)]
struct Said {
    #[command(flatten)]
    call: Call,
}

/// T and C₀, as it is asked for.
fn found(call: &Call) -> Result<Identification> {
    crate::record::read_once([&call.trials].into_iter().chain(&call.compass).map(PathBuf::as_path))?;
    let held = Held::of(&call.trials)?;
    let table = table(&held).map_err(|e| held.place(e))?;
    let compass = compass(call)?;
    if call.latitude.is_some() && table.find("latitude").is_some() {
        return Err(Error::usage("--latitude is of no use here: the table has a column of it"));
    }
    let is_a = |unit: &str| -> Result<bool> {
        let dimension = Unit::parse(unit)?.dimension();
        Ok(table.find("amplitude").is_some_and(|c| c.unit.dimension() == dimension))
    };
    if call.lever.is_some() && is_a("m")? {
        return Err(Error::usage(
            "--lever is of no use here: the amplitudes are lengths, of the compass's own path",
        ));
    }
    if call.lever.is_none() && call.compass.is_none() && is_a("rad")? {
        return Err(Error::usage(
            "the amplitudes are angles, and nothing says how high above the roll axis the compass stood",
        )
        .with_hint("say --lever, or name the compass with --compass"));
    }
    if call.latitude.is_none() && call.compass.is_none() && table.find("latitude").is_none() {
        let degrees = significant(compass.sphere.latitude.to_degrees(), 4);
        note(&format!(
            "no latitude is given: {degrees} deg is taken, that of the paper's gyrocompass; say --latitude"
        ));
    }
    let told = identification(&table, &compass)
        .map_err(|e| if e.file().is_some() { e } else { e.with_file(held.given()) })?;
    if !told.unused.is_empty() {
        note(&format!("of no use here: {}", told.unused.join(", ")));
    }
    Ok(told)
}

fn compass(call: &Call) -> Result<Compass> {
    let mut compass = named(call.compass.as_deref())?;
    if let Some(text) = &call.latitude {
        compass.sphere.latitude = latitude_of("latitude", text, &range::LATITUDE)?;
    }
    if let Some(text) = &call.lever {
        compass.sphere.lever = quantity("lever", text, &range::LEVER)?;
    }
    Ok(compass)
}

/// The table: a TOML recording as it is, or a file of rows whose header has their units.
fn table(held: &Held) -> Result<Recording> {
    if Input::open(held.path())?.is_toml() {
        return held.recording();
    }
    let quoted = toml::Value::String(held.path().to_string_lossy().into_owned());
    let mut table = Recording::parse(&format!("kind = \"trials\"\n[[tables]]\nfile = {quoted}\n"), "")?;
    // the first source is the text above, which is no file
    table.sources.remove(0);
    Ok(held.named(table))
}
