//! Integrals in symbols: tables, formulas, rendering, audit.
//!
//! - [`Program`] and [`Table`]: I_n as shared minors and as a ratio of expanded polynomials; [`print_tables`].
//! - [`formula`]: a mean value derived from transfer functions in the user's own symbols, simplified, checked against
//!   the numeric engine, as a [`Formula`] that evaluates, differentiates and prints.
//! - [`audit`]: is a printed formula right, and if not, where.
//!
//! What simplification does not attempt: a factorisation in full (it finds the factors that H was given in, their
//! Hurwitz determinants and resultants, factors free of some symbol, repeated factors, and those that are named);
//! relations that are not solved for a product of powers; identities of functions that are not given as a relation;
//! powers that are neither whole nor half; formulas with sums of more than 2000 terms (letters for all coefficients
//! above order 10, where [`print_tables`] has the answer).

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
    AuditRequest, Check, CheckKind, Examined, ExampleEntry, FormulaEntry, IdentityEntry, LimitEntry, TO_GIVE,
    audit, seed_audit, seed_audit_text,
};
pub use formula::{
    CodeLanguage, Derivation, Derived, Formula, FormulaRequest, LAPLACE, Mean, Relation, Sampler, Simplifier,
    SineMean, Source, Values, completed, derivative, formula, irregular_roll, known_letter, numeric, symbols,
    value,
};
#[doc(hidden)]
pub use fraction::Fraction;
#[doc(hidden)]
pub use integer::Integer;
pub use minors::HIGHEST_ORDER;
#[doc(hidden)]
pub use minors::{Letter, Product, Program};
pub use polynomial::Polynomial;
pub use print::{FolderFile, HIGHEST_EXPANDED, TableFormat, folder, print_tables, read_orders};
#[doc(hidden)]
pub use ring::{Monomial, Ring};
pub use table::Table;
