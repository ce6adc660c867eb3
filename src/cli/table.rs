//! `gyrospec table`: the tables of I_n.

use super::{Outcome, output};
use crate::Result;
use crate::symbolic::{TableFormat, folder, print_tables, read_orders};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
const HELP: &str = "\
Examples:
  gyrospec table --orders 1..4 --format markdown
  gyrospec table --orders 7 --format rust --out i7.rs";

/// Print I_n in symbols: numerator and denominator for H = a0 s^n + … + an, G = b0 s^(2n-2) + … + b(n-1).
#[derive(Args)]
#[command(after_help = HELP)]
pub struct Table {
    /// Orders to print: one (7) or a range with both ends (1..10); from 1 to 14.
    #[arg(long, required_unless_present = "folder")]
    orders: Option<String>,
    /// The form; Markdown and LaTeX show orders above 8 as shared minors, code goes by Routh's rows.
    #[arg(long, value_parser = form(), default_value = "json")]
    format: TableFormat,
    /// Where the text goes; - is standard output.
    #[arg(long, default_value = "-")]
    out: PathBuf,
    /// Instead of printing, write the whole set of tables into this existing folder.
    #[arg(long, conflicts_with_all = ["orders", "out", "format"])]
    folder: Option<PathBuf>,
}

/// The names of the forms, each read as the form.
fn form() -> impl TypedValueParser<Value = TableFormat> {
    PossibleValuesParser::new(TableFormat::all().map(TableFormat::name))
        .try_map(|name| name.parse::<TableFormat>())
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
    let orders = read_orders(call.orders.as_deref().unwrap_or_default())?;
    let place = output::Place::open(&call.out)?;
    output::put(&[place.data(print_tables(orders, call.format)?)], NOTHING_READ)?;
    Ok(Outcome::Done)
}
