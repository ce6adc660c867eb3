//! `gyrospec pendulous`: errors of a compass of Sperry's kind, and what its corrector leaves.

mod options;

use super::{Outcome, output};
use crate::gyro::pendulous::{SettledVoyage, Voyage};
use crate::report::pendulous::{json, page, text};
use crate::{Error, Result};
use clap::Parser;
use options::Options;
use std::path::PathBuf;

/// A compass with a liquid ballistic: settled error, what its corrector leaves, spread under manoeuvres.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    #[command(flatten)]
    options: Options,
    /// A report with pictures, one page that opens offline; - is standard output.
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
}

const HELP: &str = "\
Settled error: v_N/(R nu) by the ship's speed and -eps (U sin(lat) + v_E tan(lat)/R)/nu by the damping, with
nu = U cos(lat) + v_E/R; at rest -eps tan(lat). A corrector takes off what it would be at the latitude and the speed
that are set on it. Units stand behind the numbers; latitude and heading are in degrees without one.
H = 15 N*m*s, eps = 0.03 rad and a flow of 60 s, where none is given, are round numbers of the size of such compasses
and of no maker's; take yours from the maker's data sheet.
Examples:
  gyrospec pendulous --latitude 60
  gyrospec pendulous --latitude 60 --speed 15kn --corrector 55,12kn
  gyrospec pendulous --latitude 60 --tuned-at 45 --manoeuvres 8kn,15min --html pendulous.html
  gyrospec pendulous --latitude 50 --offset 2deg --flow 90s --speed 12kn --heading 30 --heading 210 --json";

/// Runs the subcommand.
pub fn run(call: &Call) -> Result<Outcome> {
    let [html] = output::open([call.html.as_deref()])?;
    let to_stdout = html.as_ref().is_some_and(output::Place::is_standard_output);
    if to_stdout && call.json {
        return Err(Error::usage("standard output takes one result: a page or JSON")
            .with_hint("name a file for the page"));
    }
    let (voyage, told) = answered(&call.options)?;
    if let Some(place) = html {
        output::put(&[place.data(page(&voyage, &told))], std::iter::empty::<PathBuf>())?;
    }
    match (to_stdout, call.json) {
        (true, _) => Ok(()),
        (_, true) => output::quoted(&json(&voyage, &told)?),
        _ => output::words(&text(&voyage, &told)),
    }?;
    Ok(Outcome::Done)
}

fn answered(options: &Options) -> Result<(Voyage, SettledVoyage)> {
    let voyage = options.voyage()?;
    let told = voyage.settled()?;
    Ok((voyage, told))
}

#[derive(Parser)]
#[command(name = "pendulous", no_binary_name = true)]
struct Said {
    #[command(flatten)]
    options: Options,
}

/// The JSON for options said elsewhere, such as `--latitude=60`.
///
/// # Errors
/// `Usage` for options that are none, and what the command refuses.
pub fn answer(options: &[String]) -> Result<String> {
    let said = Said::try_parse_from(options).map_err(|e| Error::usage(e.to_string()))?;
    let (voyage, told) = answered(&said.options)?;
    json(&voyage, &told)
}
