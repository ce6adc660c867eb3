//! Integrals with letters: tables, formulas, rendering, audit.

mod audit;
mod formula;
mod fraction;
mod gcd;
mod integer;
mod minors;
mod modular;
mod polynomial;
mod print;
mod ring;
mod table;

pub use audit::{
    AuditRequest, Check, CheckKind, Examined, ExampleEntry, FormulaEntry, IdentityEntry, LimitEntry, audit,
    seed_audit, seed_audit_text,
};
pub use formula::{
    CodeLanguage, Derivation, Derived, Formula, FormulaRequest, Mean, Relation, Sampler, Simplifier, Source,
    Values, completed, derivative, formula, irregular_roll, numeric, value,
};
pub use fraction::Fraction;
pub use integer::Integer;
pub use minors::{HIGHEST_ORDER, Letter, Product, Program};
pub use polynomial::Polynomial;
pub use print::{FolderFile, HIGHEST_EXPANDED, TableFormat, folder, print_tables};
pub use ring::{Monomial, Ring};
pub use table::Table;
