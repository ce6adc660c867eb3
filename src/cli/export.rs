//! `gyrospec export`: a model as code that runs without this program.

use super::{Outcome, output};
use crate::Result;
use crate::export::{Language, export};
use crate::model::Model;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
const HELP: &str = "\
Examples:
  gyrospec export model.toml --to python --out model.py
  gyrospec export gyrosphere --to modelica
  gyrospec export model.toml --to c --out model.c";

/// Write a model, what a diagnosis found included, as code that runs without gyrospec.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    /// The model file, or the name of a built-in model; - is standard input.
    model: PathBuf,
    /// The language.
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    to: Language,
    /// Where the code goes; - is standard output.
    #[arg(long, default_value = "-")]
    out: PathBuf,
}

/// The names of the languages, each read as the language.
fn language() -> impl TypedValueParser<Value = Language> {
    PossibleValuesParser::new(Language::all().map(Language::name)).try_map(|name| name.parse::<Language>())
}

/// Runs the subcommand.
pub fn run(call: &Call) -> Result<Outcome> {
    let place = output::Place::open(&call.out)?;
    output::spare([&place], [&call.model])?;
    let model = Model::read(&call.model)?;
    let read = model.simulated.iter().map(|s| s.source.file.clone()).chain([call.model.clone()]);
    let code = export(&model, call.to).map_err(|e| match e.file() {
        None => e.with_file(&call.model),
        Some(_) => e,
    })?;
    output::put(&[place.data(code)], read.collect::<Vec<_>>())?;
    Ok(Outcome::Done)
}
