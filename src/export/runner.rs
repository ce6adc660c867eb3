//! The fixed text of the runners: blocks of which a model takes what it needs.

use super::lowered::Lowered;
use super::{Language, refused};
use crate::Result;
use crate::expression::{Expr, Function};
use crate::model::{Initial, Model};

/// The blocks of a text whose conditions hold. A line `@ word …` begins a block that is taken where each word
/// holds; `!word` holds where the word does not.
pub(super) fn blocks(text: &str, holds: &dyn Fn(&str) -> bool) -> String {
    let mut out = String::new();
    let mut is_taken = true;
    for line in text.lines() {
        if let Some(words) = line.strip_prefix("@ ") {
            is_taken = words.split(' ').all(|w| match w.strip_prefix('!') {
                Some(word) => !holds(word),
                None => holds(w),
            });
        } else if is_taken {
            out.push_str(line);
            out.push('\n');
        }
    }
    out
}

/// Whether a word of the runners' conditions holds for a model.
pub(super) fn holds(own: &Lowered<'_>, word: &str) -> bool {
    let c = own.counts;
    let uses = |f: Function| calls(own.model, &|other| other == f);
    match word {
        "always" => true,
        "steps" => own.steps(),
        "states" => own.states() > 0,
        "remembers" => own.remembers(),
        "signs" => c.signs > 0,
        "plays" => c.plays > 0,
        "relays" => c.relays > 0,
        "limits" => c.limits > 0,
        "pasts" => c.pasts > 0,
        "late" => !own.columns.is_empty(),
        "steady" => own.model.states.iter().any(|s| s.initial == Initial::Steady),
        "curve" => uses(Function::Curve),
        "surface" => calls(own.model, &|f| matches!(f, Function::Surface(..))),
        "sign" => c.signs > 0 || uses(Function::Sign) || uses(Function::Step),
        "step" => uses(Function::Step) && c.signs == 0,
        _ => false,
    }
}

/// Whether the model calls such a function.
pub(super) fn calls(model: &Model, is_such: &dyn Fn(Function) -> bool) -> bool {
    refused::expressions(model).any(|e| refused::first_call(e, is_such).is_some())
}

/// Refuses what has no words.
pub(super) fn spoken(own: &Lowered<'_>, language: Language) -> Result<()> {
    let wrong =
        all(own).into_iter().find_map(|e| refused::first_call(e, &|f| matches!(f, Function::Foreign(_))));
    wrong.map_or(Ok(()), |f| Err(refused::function(f, language)))
}

/// Every expression of the functions.
pub(super) fn all<'a>(own: &'a Lowered<'_>) -> Vec<&'a Expr> {
    let locals = own.locals.iter().flat_map(|l| l.value.parts());
    locals.chain(&own.rates).chain(&own.outputs).chain(own.columns.iter().map(|c| &c.ago)).collect()
}
