//! The command line: one file a subcommand.
#![allow(clippy::print_stdout, clippy::print_stderr, missing_docs)]

mod audit;
mod colour;
mod compass;
mod completions;
mod diagnose;
mod explain;
mod export;
mod fit;
mod formula;
mod gimbal;
mod host;
pub mod identify;
mod input;
mod integral;
mod laboratory;
mod models;
mod new;
mod output;
pub mod pendulous;
mod progress;
mod quantity;
mod record;
pub mod roll_error;
mod signals;
mod simulate;
pub mod strapdown;
mod table;
mod task;
mod threads;

use crate::text::{in_line, shown};
use crate::{Error, ErrorKind, Result};
use clap::{Parser, Subcommand};
use colour::paint;
use std::ffi::OsString;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// How a subcommand that did its work ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Done; nothing to report beyond the result.
    Done,
    /// Done, and something was found.
    Found,
}

const HELP: &str = "\
`gyrospec COMMAND --help` says more, with examples. To begin:
  gyrospec new model > model.toml                            a model to edit
  gyrospec new recording log.csv > log.toml                  say what the columns are
  gyrospec diagnose model.toml log.toml --html report.html   what does the model leave out?";

#[derive(Parser)]
#[command(name = "gyrospec", version, about, arg_required_else_help = true, after_help = HELP)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

/// The subcommands; one line each, the work is in the file of that name.
#[derive(Subcommand)]
enum Command {
    /// A model or recording file to start from.
    New(new::Call),
    /// What is in a recording.
    Record(record::Record),
    /// Simulate a model on a recording.
    Simulate(simulate::Call),
    /// Fit a model to recordings.
    Fit(fit::Call),
    /// Find what a model leaves out, and check it on held-out data.
    Diagnose(diagnose::Call),
    /// Write a model as code (Python, C, Rust, Modelica), as LaTeX, or as a Functional Mock-up Unit.
    Export(export::Call),
    /// What can be missing: the pages of the catalogue.
    Explain(explain::Explain),
    /// How often the diagnosis finds what was concealed.
    Laboratory(laboratory::Call),
    /// The built-in models.
    Models(models::Call),
    /// Mean and spread of the rolling error of a gyrocompass.
    RollError(Box<roll_error::Arguments>),
    /// A gyroscope in a rotating gimbal as a sensor of slow rates.
    Gimbal(gimbal::GimbalCall),
    /// Strapdown systems and gyros that vibrate, and the heading found with them.
    Strapdown(Box<strapdown::Call>),
    /// T and C0 of a compass from errors measured on regular roll.
    Identify(identify::Call),
    /// A compass with a liquid ballistic: settled error, corrector, manoeuvres.
    Pendulous(Box<pendulous::Call>),
    /// The spectral integral I_n, within two units in the last place.
    Integral(integral::Arguments),
    /// A mean value as a formula in your own symbols.
    Formula(Box<formula::FormulaCall>),
    /// Is a printed formula right: dimensions, value, limits.
    Audit(audit::Audit),
    /// Tables of I_n in symbols.
    Table(table::Table),
    /// Completions for a shell.
    Completions(completions::Completions),
    /// The manual page.
    Man(completions::Man),
    /// Version and licence.
    About,
}

impl Command {
    /// What is being done, for who waits.
    fn doing(&self) -> &'static str {
        match self {
            Self::Integral(_) => "integrating",
            Self::Formula(_) => "deriving the formula",
            Self::Audit(_) => "examining the formulas",
            Self::Table(_) => "making tables",
            Self::Simulate(_) => "simulating",
            Self::RollError(_) => "computing the rolling error",
            Self::Gimbal(_) => "simulating the gimbal",
            Self::Strapdown(_) => "integrating spectra",
            Self::Laboratory(_) => "making recordings",
            Self::Fit(_) | Self::Diagnose(_) | Self::Record(_) | Self::New(_) => "reading",
            _ => "working",
        }
    }
}

const ABOUT: &str = concat!(
    "gyrospec ",
    env!("CARGO_PKG_VERSION"),
    "\n",
    env!("CARGO_PKG_DESCRIPTION"),
    "\nLicence: ",
    env!("CARGO_PKG_LICENSE"),
    ", as you prefer\n"
);

fn run(cli: Cli) -> Result<Outcome> {
    match cli.command {
        Command::Integral(call) => return integral::run(&call),
        Command::Formula(call) => return formula::run(&call),
        Command::Audit(call) => return audit::run(&call),
        Command::Table(call) => return table::run(&call),
        Command::Diagnose(call) => return diagnose::run(&call),
        Command::Export(call) => return export::run(&call),
        Command::Explain(call) => return explain::run(&call),
        Command::Laboratory(call) => return laboratory::run(&call),
        Command::Fit(call) => return fit::run(&call),
        Command::Record(call) => return record::run(&call),
        Command::Simulate(call) => return simulate::run(&call),
        Command::Models(call) => return models::run(&call),
        Command::Gimbal(call) => return gimbal::run(&call),
        Command::Identify(call) => return identify::run(&call),
        Command::Pendulous(call) => return pendulous::run(&call),
        Command::Strapdown(call) => return strapdown::run(&call),
        Command::RollError(a) => return roll_error::run(&a),
        Command::New(call) => return new::run(&call),
        Command::Completions(call) => return completions::completions(&call),
        Command::Man(call) => return completions::man(&call),
        Command::About => output::words(ABOUT)?,
    }
    Ok(Outcome::Done)
}

/// Runs the program on the process's own arguments.
pub fn main() -> ExitCode {
    if !host::is_host() {
        signals::handle();
    }
    let cli = match parsed() {
        Ok(cli) => cli,
        Err(e) => return told(&e),
    };
    if let Some(code) = host::hosted(&std::env::args_os().collect::<Vec<_>>()) {
        return code;
    }
    let _watch = progress::watch(cli.command.doing());
    match threads::start().and_then(|()| run(cli)) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Found) => ExitCode::from(1),
        Err(e) => fail(&e.with_line_of_file()),
    }
}

/// Prints help, the version, or a refusal. What a reader who went away does not want is no failure; what a full disk
/// does not take is one.
fn told(e: &clap::Error) -> ExitCode {
    match e.print().and_then(|()| std::io::stdout().flush()) {
        Err(lost) if !e.use_stderr() => fail(&Error::io(Path::new("standard output"), &lost)),
        _ => ExitCode::from(if e.use_stderr() { 2 } else { 0 }),
    }
}

/// The call; a refusal shows its words as they may be shown.
fn parsed() -> std::result::Result<Cli, clap::Error> {
    let words: Vec<OsString> = std::env::args_os().collect();
    Cli::try_parse_from(&words).map_err(|refused| {
        let harmless = words.iter().map(|w| in_line(&w.to_string_lossy()).into_owned());
        match Cli::try_parse_from(harmless) {
            Err(same) if same.kind() == refused.kind() => same,
            _ => clap::Error::raw(refused.kind(), shown(&refused.to_string()).trim_start_matches("error: ")),
        }
    })
}

/// Says something that a user should know, on standard error.
pub fn warn(says: &str) {
    tell("warning", "1;33", says);
}

/// Says something that a reader noticed, on standard error.
pub fn note(says: &str) {
    tell("note", "1", says);
}

fn tell(sort: &str, style: &str, says: &str) {
    let sort = paint(sort, style, &std::io::stderr());
    progress::aside(|| eprintln!("{sort}: {}", shown(says)));
}

fn fail(e: &Error) -> ExitCode {
    let code = match e.kind() {
        ErrorKind::ClosedPipe => return ExitCode::SUCCESS,
        ErrorKind::NotComputed | ErrorKind::Unstable | ErrorKind::ImaginaryAxis | ErrorKind::OutOfRange => 3,
        _ => 2,
    };
    tell("error", "1;31", &e.to_string());
    ExitCode::from(code)
}
