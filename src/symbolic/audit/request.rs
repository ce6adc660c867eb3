//! An audit as it is asked for.

use crate::symbolic::FormulaRequest;
use crate::{Error, Result};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Printed formulas and what to hold them against; the form is shown at the head of this room's audit.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AuditRequest {
    /// Where the formulas are printed.
    #[serde(default)]
    pub title: String,
    /// Relations that hold throughout.
    #[serde(default)]
    pub relations: Vec<String>,
    /// The unit of every symbol.
    #[serde(default)]
    pub units: BTreeMap<String, String>,
    /// The printed formulas, in the order of the source.
    pub formulas: Vec<FormulaEntry>,
}

/// One printed formula.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FormulaEntry {
    /// Its number or name.
    pub name: String,
    /// What it is about.
    #[serde(default)]
    #[serde(rename = "says")]
    pub message: String,
    /// An expression, or an equation `left = right`.
    pub printed: String,
    /// The unit that the expression has.
    pub unit: Option<String>,
    /// What it should be.
    pub right: Option<String>,
    /// What it is derived from.
    pub derive: Option<FormulaRequest>,
    /// Units that are printed otherwise for this formula.
    #[serde(default)]
    pub units: BTreeMap<String, String>,
    /// Limits in which it must turn into another formula.
    #[serde(default)]
    pub limits: Vec<LimitEntry>,
    /// Expressions of it that must vanish.
    #[serde(default)]
    pub identities: Vec<IdentityEntry>,
    /// Worked examples.
    #[serde(default)]
    pub examples: Vec<ExampleEntry>,
}

/// A limit in which the formula must turn into another one.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LimitEntry {
    /// What the limit means.
    #[serde(default)]
    #[serde(rename = "says")]
    pub message: String,
    /// The symbol that goes to the limit.
    pub symbol: String,
    /// Where it goes.
    pub to: f64,
    /// What the formula must turn into.
    pub becomes: String,
    /// Relations that hold in the limit.
    #[serde(default)]
    pub given: Vec<String>,
}

/// An expression that must vanish.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct IdentityEntry {
    /// Why it must.
    #[serde(default)]
    #[serde(rename = "says")]
    pub message: String,
    /// The expression; `printed` stands for the formula.
    pub zero: String,
}

/// A worked example.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExampleEntry {
    /// Where the example stands in the source.
    #[serde(default)]
    #[serde(rename = "says")]
    pub message: String,
    /// The numbers put in, in the units of the symbols.
    pub values: BTreeMap<String, f64>,
    /// The printed result.
    pub result: String,
    /// The unit in which `result` is printed.
    pub unit: String,
}

impl AuditRequest {
    /// Reads the TOML form.
    ///
    /// # Errors
    /// Bad input, with the place in the text.
    pub fn parse(text: &str) -> Result<Self> {
        toml::from_str(text).map_err(|e| Error::bad_input(e.to_string().trim_end().to_owned()))
    }
}

/// The audit of the two papers of 1978, as a file: an example of the form.
pub fn seed_audit_text() -> &'static str {
    include_str!("seed.toml")
}

/// The audit of the two papers of 1978.
///
/// # Errors
/// None in practice; those of reading its own text.
pub fn seed_audit() -> Result<AuditRequest> {
    AuditRequest::parse(seed_audit_text())
}
