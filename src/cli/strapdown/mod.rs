//! `gyrospec strapdown`: what vibration and noise do to a strapdown system and to a heading found with it.

mod options;

use super::{Outcome, output};
use crate::report::strapdown::{json, text};
use crate::{Error, Result};
use clap::Parser;
use options::Options;

/// Coning, sculling, vibrating gyros and accelerometers, and the heading found with them.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    #[command(flatten)]
    options: Options,
    /// One JSON object instead of text.
    #[arg(long)]
    json: bool,
}

const HELP: &str = "\
A vibration is a mount's resonance that broadband shaking excites, all of one cause: AXIS=DEVIATION, then PHASE at its
frequency against the cause (0 if absent; positive leads), then FREQUENCY and DAMPING where they are not those of
--resonance. A phase is that of an all-pass, which leaves every amplitude: (c - s)/(c + s) for a lag, (s - c)/(s + c)
for a lead, with c so that it is PHASE at FREQUENCY; beside the resonance it is another. Body axes: x forward, y to starboard, z down. Units stand behind the numbers.
Examples:
  gyrospec strapdown --resonance 30Hz,0.05 --angular y=0.01mrad --angular z=0.01mrad,-90deg --latitude 60 --heading 45
  gyrospec strapdown --resonance 40Hz,0.1 --angular x=0.2mrad --linear y=2m/s^2,20deg --square 1e-6s^2/m --json
  gyrospec strapdown --walk 0.005deg/h^0.5 --latitude 60 --heading 30 --loop 10min,0.7 --align 300s --irregular 4deg,0.06,0.65 --lever 3m
  gyrospec strapdown --tuned-rotor z,6000rpm,60g*cm^2,1g*cm^2,0.1arcsec --latitude 45";

/// Runs the subcommand.
pub fn run(call: &Call) -> Result<Outcome> {
    let system = call.options.system()?;
    let found = system.findings()?;
    if call.json { output::quoted(&json(&system, &found)?) } else { output::words(&text(&system, &found)) }?;
    Ok(Outcome::Done)
}

#[derive(Parser)]
#[command(name = "strapdown", no_binary_name = true)]
struct Said {
    #[command(flatten)]
    options: Options,
}

/// The JSON for options said elsewhere, such as `--walk=1e-6`.
///
/// # Errors
/// `Usage` for options that are none, and what the command refuses.
pub fn answer(options: &[String]) -> Result<String> {
    let said = Said::try_parse_from(options).map_err(|e| Error::usage(e.to_string()))?;
    let system = said.options.system()?;
    json(&system, &system.findings()?)
}
