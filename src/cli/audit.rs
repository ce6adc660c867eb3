//! `gyrospec audit`: is a printed formula right?

use super::{Outcome, input, output};
use crate::symbolic::{AuditRequest, Examined, TO_GIVE, audit, seed_audit, seed_audit_text};
use crate::{Error, Result};
use clap::{Args, ValueEnum};
use std::fmt::Write;
use std::path::PathBuf;

/// Examine printed formulas: dimensions, value, limits, identities and worked examples.
#[derive(Args)]
#[command(after_help = HELP)]
pub struct Audit {
    /// A TOML file of printed formulas; - is standard input.
    #[arg(required_unless_present_any = ["seed", "example"])]
    file: Option<PathBuf>,
    /// Examine the formulas of the two papers of 1978.
    #[arg(long, conflicts_with = "file")]
    seed: bool,
    /// Print the file behind --seed, as an example of the form.
    #[arg(long, conflicts_with_all = ["file", "seed", "wrong", "format"])]
    example: bool,
    /// Show only what is wrong.
    #[arg(long)]
    wrong: bool,
    /// The form of the result.
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    /// Where the result goes; - is standard output.
    #[arg(long, default_value = "-")]
    out: PathBuf,
}

const HELP: &str = "\
The file:
  title = \"…\"
  relations = [\"b^2 = mu^2 + eps^2\"]       hold throughout, solved for a product of powers
  [units]                                   of every symbol; without it dimensions are not examined
  mu = \"1/s\"
  [[formulas]]
  name = \"(3.4)\"
  printed = \"…\"                             an expression, or an equation  left = right
  unit = \"rad^2/s^3\"                        optional: of the printed expression
  right = \"…\"                               optional: what it should be, or
  [formulas.derive]                         what it is derived from, as in a file of `gyrospec formula`
  [[formulas.limits]]                       says, symbol, to, becomes, given = [relations]
  [[formulas.identities]]                   says, zero (in which `printed` stands for the formula)
  [[formulas.examples]]                     says, values = { … } in the units above, result = \"…\", unit
`gyrospec audit --example` prints a whole file. Exit code 1: something is wrong.
Examples:
  gyrospec audit --seed --wrong
  gyrospec audit --example > formulas.toml";

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Text,
    Json,
}

/// Runs the subcommand.
pub fn run(call: &Audit) -> Result<Outcome> {
    let place = output::Place::open(&call.out)?;
    output::spare([&place], &call.file)?;
    if call.example {
        output::put(&[place.words(seed_audit_text())], &call.file)?;
        return Ok(Outcome::Done);
    }
    let about = |e: Error| call.file.iter().fold(e, |e, path| e.with_file(path));
    let request = match &call.file {
        Some(path) => AuditRequest::parse(&input::text(path)?).map_err(about)?,
        None => seed_audit()?,
    };
    let mut examined = audit(&request).map_err(about)?;
    let wrong = examined.iter().filter(|one| !one.holds()).count();
    let unchecked = examined.iter().filter(|one| !one.checked()).count();
    let all = examined.len();
    if call.wrong {
        examined.retain(|one| !one.holds());
    }
    let mut last = format!("{wrong} of {all} formulas are wrong");
    if unchecked > 0 {
        last = format!("{last}; {unchecked} could not be checked: {TO_GIVE}");
    }
    let ready = match call.format {
        Format::Text => place.words(&format!("{}{last}\n", text(&request.title, &examined))),
        Format::Json => place.quoted(&json(&request.title, &examined)),
    };
    output::put(&[ready], &call.file)?;
    Ok(if wrong > 0 { Outcome::Found } else { Outcome::Done })
}

fn text(title: &str, examined: &[Examined]) -> String {
    let mut text = if title.is_empty() { String::new() } else { format!("{title}\n\n") };
    for one in examined {
        let message = if one.message.is_empty() { String::new() } else { format!(": {}", one.message) };
        let _ = writeln!(text, "{}{message}", one.name);
        let _ = writeln!(text, "  printed     {}", one.printed);
        if let Some(right) = &one.right {
            let _ = writeln!(text, "  right       {right}");
        }
        if !one.checked() {
            text.push_str("  not checked\n");
        }
        for check in &one.checks {
            let mark = if check.holds { "ok" } else { "WRONG" };
            let message = check.message.replace('\n', "\n                    ");
            let _ = writeln!(text, "  {:<11} {mark:<5} {message}", check.kind.name());
        }
        text.push('\n');
    }
    text
}

fn json(title: &str, examined: &[Examined]) -> String {
    let formulas: Vec<_> = examined
        .iter()
        .map(|one| {
            let checks: Vec<_> = one
                .checks
                .iter()
                .map(|check| {
                    serde_json::json!({
                        "kind": check.kind.name(),
                        "holds": check.holds,
                        "says": check.message,
                        "ratio": check.ratio.filter(|ratio| ratio.is_finite()),
                    })
                })
                .collect();
            serde_json::json!({
                "name": one.name,
                "says": one.message,
                "printed": one.printed,
                "right": one.right,
                "holds": one.checked().then(|| one.holds()),
                "checks": checks,
            })
        })
        .collect();
    format!("{:#}\n", serde_json::json!({"schema": "gyrospec.audit/1", "title": title, "formulas": formulas}))
}
