//! `gyrospec export`: a model as code that runs without this program.

use super::{Outcome, output};
use crate::export::{Language, export, export_fmu};
use crate::model::Model;
use crate::{Error, Result};
use clap::builder::PossibleValuesParser;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
const HELP: &str = "\
Examples:
  gyrospec export model.toml --to python --out model.py
  gyrospec export gyrosphere --to modelica
  gyrospec export model.toml --to c --out model.c
  gyrospec export model.toml --to fmu --out model.fmu      # needs a C compiler: cc, or what CC names";

/// The name of the form that is no text.
const FMU: &str = "fmu";

/// Write a model, what a diagnosis found included, as code that runs without gyrospec.
#[derive(clap::Args)]
#[command(after_help = HELP)]
pub struct Call {
    /// The model file, or the name of a built-in model; - is standard input.
    model: PathBuf,
    /// The language, or a Functional Mock-up Unit.
    #[arg(long, value_name = "LANGUAGE", value_parser = languages())]
    to: String,
    /// Where the code goes; - is standard output.
    #[arg(long, default_value = "-")]
    out: PathBuf,
}

fn languages() -> PossibleValuesParser {
    PossibleValuesParser::new(Language::all().map(Language::name).into_iter().chain([FMU]))
}

/// The bytes in the form that was asked for.
fn written(model: &Model, form: &str) -> Result<Vec<u8>> {
    if form == FMU { export_fmu(model) } else { Ok(export(model, form.parse()?)?.into_bytes()) }
}

/// Runs the subcommand.
pub fn run(call: &Call) -> Result<Outcome> {
    let place = output::Place::open(&call.out)?;
    output::spare([&place], [&call.model])?;
    if call.to == FMU && call.out == Path::new("-") && std::io::stdout().is_terminal() {
        return Err(Error::usage("an FMU is an archive with machine code, and no terminal can show it")
            .with_hint("say where it goes: --out model.fmu"));
    }
    let model = Model::read(&call.model)?;
    let read = model.simulated.iter().map(|s| s.source.file.clone()).chain([call.model.clone()]);
    let code = written(&model, &call.to).map_err(|e| match e.file() {
        None => e.with_file(&call.model),
        Some(_) => e,
    })?;
    output::put(&[place.data(code)], read.collect::<Vec<_>>())?;
    Ok(Outcome::Done)
}
