//! What parameters multiply: in each term of a model the part that is made of signals, such as the slip of a tyre or the
//! difference of two temperatures.

use super::edit;
use super::terms::{factors, rewritten};
use crate::expression::{BinaryOp, Expr};
use crate::model::Model;
use std::cell::RefCell;

/// The products in all rates and definitions, and what they are made of.
pub(super) fn terms(model: &Model) -> Vec<Expr> {
    let terms = RefCell::new(Vec::new());
    edit::for_each(&mut model.clone(), |place, e| {
        if !matches!(place, edit::Place::Output(_)) {
            rewritten(e, &|term| {
                terms.borrow_mut().push(term.clone());
                None
            });
        }
    });
    terms.into_inner()
}

/// The arguments of a model's terms that are no plain inputs, states or numbers, each once.
pub fn arguments(model: &Model) -> Vec<Expr> {
    each(model, terms(model).iter())
}

/// The same of some of its terms.
pub(super) fn each<'t>(model: &Model, terms: impl Iterator<Item = &'t Expr>) -> Vec<Expr> {
    let mut found: Vec<Expr> = Vec::new();
    for argument in terms.filter_map(|t| of(model, t)) {
        if !found.contains(&argument) {
            found.push(argument);
        }
    }
    found
}

/// A term without the numbers and parameters that it is multiplied or divided by, where a parameter multiplies it and a
/// definition or more than one signal is left.
pub(super) fn of(model: &Model, term: &Expr) -> Option<Expr> {
    let is_parameter = |n: &str| model.parameters.iter().any(|p| p.name == n);
    factors(term).into_iter().find(|f| matches!(f, Expr::Name(n) if is_parameter(n)))?;
    let left = without_constants(term, &is_parameter)?;
    let is_law = |e: &Expr| matches!(e, Expr::Call(f, _) if f.has_memory());
    let names = left.names();
    let signals = names.iter().filter(|n| !is_parameter(n)).count();
    let is_defined = matches!(&left, Expr::Name(n) if model.definitions.iter().any(|d| d.name == *n));
    let stands = is_defined || signals > 1 && edit::find(&left, &is_law).is_none();
    stands.then_some(left)
}

/// A product without its sign, its numbers and its parameters; none where nothing is left.
fn without_constants(e: &Expr, is_parameter: &dyn Fn(&str) -> bool) -> Option<Expr> {
    let boxed = |op, a: Expr, b: Expr| Expr::Binary(op, Box::new(a), Box::new(b));
    let constant = |e: &Expr| e.names().iter().all(|n| is_parameter(n));
    match e {
        e if constant(e) => None,
        Expr::Neg(a) => without_constants(a, is_parameter),
        Expr::Binary(BinaryOp::Mul, a, b) => {
            match (without_constants(a, is_parameter), without_constants(b, is_parameter)) {
                (Some(a), Some(b)) => Some(boxed(BinaryOp::Mul, a, b)),
                (one, other) => one.or(other),
            }
        }
        Expr::Binary(BinaryOp::Div, a, b) if constant(b) => without_constants(a, is_parameter),
        Expr::Binary(BinaryOp::Div, a, b) => {
            let above = without_constants(a, is_parameter).unwrap_or(Expr::Number(1.0));
            Some(boxed(BinaryOp::Div, above, (**b).clone()))
        }
        other => Some(other.clone()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_argument_is_what_is_left_of_the_signals() {
        let model = Model::parse(
            r#"
            name = "axle"
            [inputs]
            steer = { unit = "rad" }
            speed = { unit = "m/s" }
            wind = { unit = "m/s" }
            [parameters]
            C = { value = 1, unit = "N" }
            d = { value = 1, unit = "N*s/m" }
            m = { value = 1, unit = "kg" }
            [definitions]
            slip = { equals = "steer - v/speed", unit = "1" }
            [states]
            v = { rate = "(C*slip - 2*C*v/speed - d*(v - wind) - d*v)/m", unit = "m/s", initial = 0 }
            [outputs]
            y = { equals = "v", unit = "m/s" }
            "#,
        )
        .unwrap();
        let all: Vec<String> = arguments(&model).iter().map(ToString::to_string).collect();
        assert_eq!(all, ["slip", "v/speed", "v - wind"]);
    }
}
