//! The values that `gyrospec formula` is given.

use crate::symbolic::{Derivation, Formula, LAPLACE, Simplifier, Values, completed, known_letter, symbols};
use crate::text::is_lost;
use crate::{Error, ErrorKind, Result};
use std::collections::BTreeSet;

/// Every letter of a derivation, its relations and a printed formula beside it.
pub fn letters(
    derivation: &Derivation,
    simplifier: &Simplifier,
    printed: Option<&Formula>,
) -> BTreeSet<String> {
    let sides = simplifier.relations.iter().flat_map(|relation| [&relation.left, &relation.right]);
    let all = derivation.source.expressions().into_iter().chain([&derivation.times]).chain(sides);
    let names = all.chain(printed.map(|formula| &formula.expression)).flat_map(symbols);
    names.filter(|name| *name != LAPLACE).map(String::from).collect()
}

/// `T=0.44, mu=0.1` as values of known letters.
pub fn read(text: &str, known: &BTreeSet<String>) -> Result<Values> {
    let mut values = Values::new();
    for part in text.split(',').map(str::trim).filter(|part| !part.is_empty()) {
        let wrong =
            || Error::usage(format!("--values: '{part}' is no value")).with_hint("write T=0.44, mu=0.1");
        let (name, number) = part.split_once('=').ok_or_else(wrong)?;
        let (name, written) = (name.trim(), number.trim());
        let number: f64 = written.parse().map_err(|_| wrong())?;
        if is_lost(written) {
            return Err(Error::usage(format!("--values: {part} is smaller than any number here")));
        }
        if !number.is_finite() {
            return Err(Error::usage(format!("--values: {part} is not finite")));
        }
        known_letter(name, known)?;
        if values.insert(name.to_owned(), number).is_some() {
            return Err(Error::usage(format!("--values: {name} is given twice")));
        }
    }
    Ok(values)
}

/// The values with those that relations add, where H is stable at them.
pub fn usable(given: &Values, derivation: &Derivation, simplifier: &Simplifier) -> Result<Values> {
    let values = completed(given, &simplifier.relations)?;
    derivation.mean(&values).map_err(|e| match e.kind() {
        ErrorKind::BadInput => e,
        kind => Error::new(kind, format!("no value: {e}")),
    })?;
    Ok(values)
}
