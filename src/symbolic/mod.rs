//! Integrals with letters: tables, formulas, rendering, audit.

mod integer;
mod minors;
mod polynomial;
mod print;
mod ring;
mod table;

pub use integer::Integer;
pub use minors::{HIGHEST_ORDER, Letter, Product, Program};
pub use polynomial::Polynomial;
pub use print::{FolderFile, HIGHEST_EXPANDED, TableFormat, folder, print_tables};
pub use ring::{Monomial, Ring};
pub use table::Table;
