//! What cannot be exported, and what to do then.

use super::Language;
use crate::expression::{Expr, Function};
use crate::model::Model;
use crate::{Error, Result};

/// Refuses a model that is not computed by its own expressions.
pub(super) fn whole(model: &Model) -> Result<()> {
    if model.simulated.is_some() {
        return Err(Error::bad_input(
            "what another simulation computed has no equations that could be exported",
        )
        .with_hint("export a model with states in the place of `simulated`"));
    }
    if is_foreign(model) {
        return Err(Error::bad_input(
            "the model is a Functional Mock-up Unit: its equations are machine code that nothing is known of",
        )
        .with_hint("export a model file that is written with expressions, or use the unit itself"));
    }
    Ok(())
}

#[cfg(feature = "fmu")]
fn has_unit(model: &Model) -> bool {
    model.fmu.is_some()
}

#[cfg(not(feature = "fmu"))]
fn has_unit(_: &Model) -> bool {
    false
}

fn is_foreign(model: &Model) -> bool {
    let is_foreign = |f: Function| matches!(f, Function::Foreign(_));
    has_unit(model) || expressions(model).any(|e| first_call(e, &is_foreign).is_some())
}

/// The first such function that an expression calls.
pub(super) fn first_call(e: &Expr, is_such: &dyn Fn(Function) -> bool) -> Option<Function> {
    let mut found = None;
    e.visit(&mut |part| {
        if let Expr::Call(f, _) = part
            && found.is_none()
            && is_such(*f)
        {
            found = Some(*f);
        }
    });
    found
}

/// Every expression of a model.
pub(super) fn expressions(model: &Model) -> impl Iterator<Item = &Expr> {
    let definitions = model.definitions.iter().map(|d| &d.equals);
    let rates = model.states.iter().map(|s| &s.rate);
    definitions.chain(rates).chain(model.outputs.iter().map(|o| &o.equals))
}

/// That a function has no words in a language.
pub(super) fn function(f: Function, language: Language) -> Error {
    Error::bad_input(format!("{} cannot be written in {}", f.usage(), language.name())).with_hint(
        "export to python, c or rust, whose runner keeps such a memory, or leave that term out of the model",
    )
}
