//! The audit of printed formulas: dimensions, value, limits, identities, worked examples.
//!
//! Purpose: to say whether a formula from a book is right, and if not, where, and by which constant it is off.
//! Method: the dimensions come from the units of the symbols; the value is compared with a right formula, given or
//! derived from transfer functions; what differs is sought down both trees; limits and identities are tried at
//! random points, worked examples at their own numbers.
//! References: none needed.
//! Numerical aspects: equality of values is decided exactly where both sides are ratios of polynomials in symbols
//! and functions of them; what is not equal so, for functions have identities of their own, is tried at random points
//! to 1e-12 beside rounding; limits to 1e-4.
//!
//! The form of an audit file:
//!
//! ```toml
//! title = "Potemkin 1978"
//! relations = ["b^2 = mu^2 + eps^2"]      # hold throughout; solved for a product of powers
//! [units]                                 # of every symbol; numbers of examples are in these units
//! T = "s"
//! mu = "1/s"
//! [[formulas]]
//! name = "(3.4)"
//! says = "density of the roll acceleration"          # optional words
//! printed = "2*A*mu/pi*b^2*w^4/(w^4 + 2*a*w^2 + b^2)" # an expression, or an equation  left = right
//! unit = "rad^2/s^3"                                 # optional: of the printed expression
//! right = "2*A*mu/pi*b^2*w^4/(w^4 + 2*a*w^2 + b^4)"   # optional: what it should be …
//! [formulas.derive]                                  # … or what it is derived from, as for `gyrospec formula`
//! h = "T*s + 1"
//! [formulas.units]                                   # optional: units printed otherwise for this formula
//! H = "g/s"
//! [[formulas.limits]]
//! says = "slow decay: a sine"                        # what the limit means
//! symbol = "mu"
//! to = 0.0                                           # a number; inf, or 1e9 and more, for infinity
//! becomes = "…"
//! given = ["theta0^2 = 2*A"]                         # optional relations that hold in the limit
//! [[formulas.identities]]
//! says = "such forces do no work"
//! zero = "printed + other"                           # `printed` stands for the printed formula
//! [[formulas.examples]]
//! says = "Example 3.1"
//! values = { T = 0.44 }                              # as printed, in the units above
//! result = "-0.0131"                                 # as printed; half its last digit is the tolerance
//! unit = "rad"
//! ```

mod compare;
mod examine;
mod limit;
mod request;

pub use request::{
    AuditRequest, ExampleEntry, FormulaEntry, IdentityEntry, LimitEntry, seed_audit, seed_audit_text,
};

use crate::{Error, Result};

/// What a formula can be held against.
pub const TO_GIVE: &str =
    "give [units] of the symbols, or for a formula: right, derive, limits, identities or examples";

/// What a check looks at.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CheckKind {
    /// Terms that are added must have one dimension.
    Dimensions,
    /// The printed formula against the right one.
    Value,
    /// A limit in which it must turn into another formula.
    Limit,
    /// An expression that must vanish.
    Identity,
    /// A worked example.
    Example,
}

impl CheckKind {
    /// One word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Dimensions => "dimensions",
            Self::Value => "value",
            Self::Limit => "limit",
            Self::Identity => "identity",
            Self::Example => "example",
        }
    }
}

/// One check of one formula.
#[derive(Clone, Debug)]
pub struct Check {
    /// What was looked at.
    pub kind: CheckKind,
    /// Whether it holds.
    pub holds: bool,
    /// In words: what was found, and where.
    pub message: String,
    /// What the printed formula must be multiplied by, where that is one number.
    pub ratio: Option<f64>,
}

/// One formula with all its checks.
#[derive(Clone, Debug)]
pub struct Examined {
    /// Its number or name in the source.
    pub name: String,
    /// What it is about.
    pub message: String,
    /// The printed formula, set as text.
    pub printed: String,
    /// The right formula, set as text, where there is one.
    pub right: Option<String>,
    /// What was looked at, in order.
    pub checks: Vec<Check>,
}

impl Examined {
    /// Whether there was anything to check.
    pub fn checked(&self) -> bool {
        !self.checks.is_empty()
    }

    /// Whether every check holds.
    pub fn holds(&self) -> bool {
        self.checks.iter().all(|check| check.holds)
    }
}

/// Examines every formula of an audit.
///
/// # Errors
/// Bad input, where the request itself cannot be read, does not fit together, or gives nothing to check.
///
/// ```
/// use gyrospec::symbolic::{AuditRequest, audit};
/// let request = AuditRequest::parse(r#"
/// title = "a slip"
/// [units]
/// m = "kg"
/// v = "m/s"
/// [[formulas]]
/// name = "energy"
/// printed = "m*v^2"
/// right = "m*v^2/2"
/// "#)?;
/// let examined = audit(&request)?;
/// assert_eq!(examined[0].checks[1].ratio, Some(0.5));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn audit(request: &AuditRequest) -> Result<Vec<Examined>> {
    let examined: Vec<Examined> =
        request.formulas.iter().map(|formula| examine::examine(request, formula)).collect::<Result<_>>()?;
    if examined.iter().any(Examined::checked) {
        return Ok(examined);
    }
    let what = if examined.is_empty() { "there is no formula" } else { "nothing was checked" };
    Err(Error::bad_input(format!(
        "{what}: the file gives no printed formula with something to hold it against"
    ))
    .with_hint(TO_GIVE))
}
