//! `gyrospec table`: the tables of I_n.

use super::{Outcome, output};
use crate::symbolic::{HIGHEST_ORDER, TableFormat, folder, print_tables};
use crate::{Error, Result};
use clap::{Args, ValueEnum};
use std::ops::RangeInclusive;
use std::path::PathBuf;
const HELP: &str = "\
Examples:
  gyrospec table --orders 1..4 --format markdown
  gyrospec table --orders 7 --format rust --out i7.rs";

/// Print I_n with letters: numerator and denominator for H = a0 s^n + … + an, G = b0 s^(2n-2) + … + b(n-1).
#[derive(Args)]
#[command(after_help = HELP)]
pub struct Table {
    /// Orders to print: one (7) or a range with both ends (1..10); from 1 to 14.
    #[arg(long, required_unless_present = "folder")]
    orders: Option<String>,
    /// The form; Markdown and LaTeX show orders above 8 as shared minors, code goes by Routh's rows.
    #[arg(long, value_enum, default_value = "json")]
    format: Format,
    /// Where the text goes; - is standard output.
    #[arg(long, default_value = "-")]
    out: PathBuf,
    /// Instead of printing, write the whole set of tables into this existing folder.
    #[arg(long, conflicts_with_all = ["orders", "out", "format"])]
    folder: Option<PathBuf>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Json,
    Markdown,
    Latex,
    Rust,
    Python,
    C,
}

impl From<Format> for TableFormat {
    fn from(format: Format) -> Self {
        match format {
            Format::Json => Self::Json,
            Format::Markdown => Self::Markdown,
            Format::Latex => Self::Latex,
            Format::Rust => Self::Rust,
            Format::Python => Self::Python,
            Format::C => Self::C,
        }
    }
}

const NOTHING_READ: [&str; 0] = [];

/// Runs the subcommand.
pub fn run(call: &Table) -> Result<Outcome> {
    if let Some(place) = &call.folder {
        let files = folder()?.into_iter().map(|f| Ok(output::Place::open(&place.join(f.name))?.data(f.text)));
        let all = files.collect::<Result<Vec<_>>>()?;
        output::put(&all, NOTHING_READ)?;
        return Ok(Outcome::Done);
    }
    let orders = orders(call.orders.as_deref().unwrap_or_default())?;
    let place = output::Place::open(&call.out)?;
    output::put(&[place.data(print_tables(orders, call.format.into())?)], NOTHING_READ)?;
    Ok(Outcome::Done)
}

/// The tables as text: orders as `7` or `1..10`, and the name of a form.
#[cfg(feature = "python")]
pub fn text(range: &str, format: &str) -> Result<String> {
    let format = Format::from_str(format, true).map_err(|_| {
        let all: Vec<_> = Format::value_variants().iter().filter_map(ValueEnum::to_possible_value).collect();
        let names: Vec<&str> = all.iter().map(clap::builder::PossibleValue::get_name).collect();
        Error::usage(format!("there is no form '{format}'")).with_hint(format!("forms: {}", names.join(", ")))
    })?;
    print_tables(orders(range)?, format.into())
}

/// `7` or `1..10`, both ends included.
fn orders(text: &str) -> Result<RangeInclusive<usize>> {
    let wrong = |why: String| {
        Error::usage(format!("--orders {text}: {why}")).with_hint(format!(
            "write one order (7) or a range with both ends (1..10), from 1 to {HIGHEST_ORDER}"
        ))
    };
    let number = |part: &str| {
        let part = part.trim();
        part.parse::<usize>().map_err(|_| wrong(format!("'{part}' is no order")))
    };
    let (first, last) = match text.split_once("..") {
        Some((first, last)) => (number(first)?, number(last.strip_prefix('=').unwrap_or(last))?),
        None => (number(text)?, number(text)?),
    };
    if first > last {
        return Err(wrong("the first order is above the last".into()));
    }
    if let Some(outside) = [first, last].into_iter().find(|n| !(1..=HIGHEST_ORDER).contains(n)) {
        return Err(wrong(format!("there is no table of order {outside}")));
    }
    Ok(first..=last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_both_ends_and_bad_ones_say_why() {
        assert_eq!(orders("1..10").unwrap(), 1..=10);
        assert_eq!(orders("7").unwrap(), 7..=7);
        assert_eq!(orders("3..=5").unwrap(), 3..=5);
        for (text, says) in [
            ("0..3", "order 0"),
            ("3..99", "order 99"),
            ("5..2", "above the last"),
            ("a..b", "'a' is no order"),
            ("1..", "'' is no order"),
            ("-1..3", "'-1'"),
            ("", "'' is no order"),
        ] {
            let error = orders(text).unwrap_err();
            assert_eq!(error.kind(), crate::ErrorKind::Usage);
            assert!(error.message().contains(says), "{text}: {error}");
        }
    }
}
