//! `gyrospec explain`: the pages of the catalogue.

use super::{Outcome, output};
use crate::Result;
use crate::diagnose::catalogue;
const HELP: &str = "\
Examples:
  gyrospec explain
  gyrospec explain dry-friction";

/// What can be missing: one mechanism's page, or the list of all.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Explain {
    /// Code of a mechanism, as reports give it; without it, all codes are listed
    code: Option<String>,
}

pub fn run(call: &Explain) -> Result<Outcome> {
    let text = match &call.code {
        Some(code) => catalogue::find(code)?.page(),
        None => catalogue::list(),
    };
    output::words(&text)?;
    Ok(Outcome::Done)
}
