//! The tables of I_n in print: JSON, Markdown, LaTeX, and as code.

mod code;
mod folder;
mod json;
mod matlab;
mod orders;
mod prose;
mod recursion;
pub(in crate::symbolic) mod sum;

pub use folder::{FolderFile, folder};
pub use orders::read_orders;

use super::minors::Program;
use crate::{Error, Result};
use std::ops::RangeInclusive;

/// The highest order that Markdown and LaTeX show expanded; above it they show the shared minors.
pub const HIGHEST_EXPANDED: usize = 8;

/// A form of the tables: a new one is its own file and one line in [`EXPORTERS`].
trait Exporter: Sync {
    /// Its name on the command line.
    fn name(&self) -> &'static str;

    /// The tables of the given orders.
    fn print(&self, orders: RangeInclusive<usize>) -> Result<String>;
}

/// Every form.
static EXPORTERS: [&dyn Exporter; 7] = [
    &json::Json,
    &prose::Style::Markdown,
    &prose::Style::Latex,
    &code::Language::Rust,
    &code::Language::Python,
    &code::Language::C,
    &matlab::Matlab,
];

/// A form of the printed tables, by its name: `json` (every term of numerator and denominator, schema
/// `gyrospec.table/1`), `markdown`, `latex`, or one function an order in `rust`, `python`, `c` or `matlab`.
///
/// ```
/// use gyrospec::symbolic::TableFormat;
/// let form: TableFormat = "latex".parse()?;
/// assert_eq!(form.name(), "latex");
/// assert!(TableFormat::all().any(|f| f.name() == "c"));
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct TableFormat(&'static dyn Exporter);

impl TableFormat {
    /// Every form, in the order of the help.
    pub fn all() -> impl Iterator<Item = Self> {
        EXPORTERS.iter().map(|e| Self(*e))
    }

    /// Its name on the command line, such as `latex`.
    pub fn name(self) -> &'static str {
        self.0.name()
    }
}

impl std::fmt::Debug for TableFormat {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("TableFormat").field(&self.name()).finish()
    }
}

impl std::str::FromStr for TableFormat {
    type Err = Error;

    /// # Errors
    /// Usage, for a name that is none of them.
    fn from_str(name: &str) -> Result<Self> {
        Self::all().find(|f| f.name().eq_ignore_ascii_case(name)).ok_or_else(|| {
            let names: Vec<&str> = Self::all().map(Self::name).collect();
            let says = format!("there is no form '{}'", crate::text::in_line(name));
            Error::usage(says).with_hint(format!("forms: {}", names.join(", ")))
        })
    }
}

/// The tables of the given orders in one form.
///
/// # Errors
/// Usage, where an order lies outside 1 … [`HIGHEST_ORDER`](super::HIGHEST_ORDER).
///
/// ```
/// use gyrospec::symbolic::print_tables;
/// let text = print_tables(2..=2, "c".parse()?)?;
/// assert!(text.contains("double gyrospec_i2("));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn print_tables(orders: RangeInclusive<usize>, format: TableFormat) -> Result<String> {
    format.0.print(orders)
}

/// The straight-line programs of orders.
fn programs(orders: RangeInclusive<usize>) -> Result<Vec<Program>> {
    orders.map(Program::new).collect()
}
