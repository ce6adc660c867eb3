//! `gyrospec explain`: the pages of the catalogue.

use super::{Outcome, output};
use crate::Result;
use crate::diagnose::catalogue;
use crate::units;

const HELP: &str = "\
Examples:
  gyrospec explain
  gyrospec explain dry-friction
  gyrospec explain units";

/// What can be missing: one mechanism's page, or the list of all; or the units that are read.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Explain {
    /// Code of a mechanism, as reports give it, or `units`; without it, all codes are listed
    code: Option<String>,
}

pub fn run(call: &Explain) -> Result<Outcome> {
    let text = match &call.code {
        Some(code) if code.eq_ignore_ascii_case("units") => units::list(),
        Some(code) => catalogue::find(code)?.page(),
        None => catalogue::list(),
    };
    output::words(&text)?;
    Ok(Outcome::Done)
}
