//! `gyrospec models`: the built-in models.

use super::Outcome;
use super::output::words;
use crate::Result;
use crate::model::{BUILTIN, Model};
use clap::Subcommand;
use std::fmt::Write;
const HELP: &str = "\
Examples:
  gyrospec models
  gyrospec models show gyrosphere";

/// Arguments of `gyrospec models`.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    #[command(subcommand)]
    what: Option<What>,
}

#[derive(Subcommand)]
enum What {
    /// Print the file of one model.
    Show {
        /// Its name.
        name: String,
    },
}

pub fn run(call: &Call) -> Result<Outcome> {
    match &call.what {
        Some(What::Show { name }) => words(Model::builtin_text(name)?)?,
        None => {
            let mut out = String::new();
            for (name, text) in BUILTIN {
                let title = Model::parse(text)?.name;
                let _ = writeln!(out, "{name:<28} {title}");
            }
            out.push_str("\n`gyrospec models show NAME` prints one; `extends = \"NAME\"` in a model file starts from it.\n");
            words(&out)?;
        }
    }
    Ok(Outcome::Done)
}
