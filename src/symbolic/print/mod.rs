//! The tables of I_n in print: JSON, Markdown, LaTeX, and as code.

mod code;
mod folder;
mod json;
mod prose;
mod recursion;
pub(in crate::symbolic) mod sum;

pub use folder::{FolderFile, folder};

use super::minors::Program;
use crate::Result;
use std::ops::RangeInclusive;

/// The highest order that Markdown and LaTeX show expanded; above it they show the shared minors.
pub const HIGHEST_EXPANDED: usize = 8;

/// A form of the printed tables.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TableFormat {
    /// Every term of numerator and denominator, schema `gyrospec.table/1`.
    Json,
    /// Markdown for people.
    Markdown,
    /// A LaTeX document.
    Latex,
    /// One Rust function an order.
    Rust,
    /// One Python function an order.
    Python,
    /// One C function an order.
    C,
}

/// The tables of the given orders in one form.
///
/// # Errors
/// Usage, where an order lies outside 1 … [`HIGHEST_ORDER`](super::HIGHEST_ORDER).
///
/// ```
/// use gyrospec::symbolic::{TableFormat, print_tables};
/// let text = print_tables(2..=2, TableFormat::C)?;
/// assert!(text.contains("double gyrospec_i2("));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn print_tables(orders: RangeInclusive<usize>, format: TableFormat) -> Result<String> {
    let programs = orders.clone().map(Program::new).collect::<Result<Vec<_>>>()?;
    match format {
        TableFormat::Json => json::tables(&programs),
        TableFormat::Markdown => prose::tables(&programs, prose::Style::Markdown),
        TableFormat::Latex => prose::tables(&programs, prose::Style::Latex),
        TableFormat::Rust => Ok(code::tables(orders, code::Language::Rust)),
        TableFormat::Python => Ok(code::tables(orders, code::Language::Python)),
        TableFormat::C => Ok(code::tables(orders, code::Language::C)),
    }
}
