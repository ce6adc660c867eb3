//! `gyrospec completions` and `gyrospec man`: what a shell and `man` want to know.

use super::output::print;
use super::{Cli, Outcome};
use crate::error::nearest;
use crate::{Error, ErrorKind, Result};
use clap::CommandFactory;
use std::path::Path;

/// Prints completions for a shell.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  gyrospec completions bash > gyrospec.bash\n  gyrospec completions fish > gyrospec.fish"
)]
pub struct Completions {
    /// The shell.
    shell: clap_complete::Shell,
}

/// Prints the manual page; `gyrospec man | man -l -` shows it.
#[derive(clap::Args)]
#[command(
    after_help = "Examples:\n  gyrospec man > gyrospec.1\n  gyrospec man diagnose > gyrospec-diagnose.1"
)]
pub struct Man {
    /// Subcommand whose page is wanted; without it, that of the whole program.
    command: Option<String>,
}

pub fn completions(call: &Completions) -> Result<Outcome> {
    let mut text = Vec::new();
    clap_complete::generate(call.shell, &mut Cli::command(), "gyrospec", &mut text);
    print(&text)?;
    Ok(Outcome::Done)
}

pub fn man(call: &Man) -> Result<Outcome> {
    let mut program = Cli::command();
    program.build();
    let page = match &call.command {
        None => program,
        Some(name) => program.find_subcommand(name).cloned().ok_or_else(|| {
            let near = nearest(name, program.get_subcommands().map(clap::Command::get_name));
            let meant = near.map(|n| format!("did you mean `{n}`? ")).unwrap_or_default();
            Error::new(ErrorKind::BadInput, format!("there is no subcommand `{name}`"))
                .with_hint(format!("{meant}`gyrospec help` lists them all"))
        })?,
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page).render(&mut text).map_err(|e| Error::io(Path::new("standard output"), &e))?;
    print(&text)?;
    Ok(Outcome::Done)
}
