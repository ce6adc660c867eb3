//! Whether a model's equations are those that the closed theory solves.

use crate::expression::Expr;
use crate::model::Model;
use crate::{Error, Result};

/// The built-in models that the theory covers.
const COVERED: [&str; 4] = ["gyrosphere", "gyrosphere-inertia", "gyrosphere-flow", "gyrosphere-under-way"];

/// Refuses a model whose states or heading error follow other equations than those of a built-in gyrosphere.
pub fn known(model: &Model) -> Result<()> {
    let mut nearest: Option<Vec<String>> = None;
    for name in COVERED {
        let other = differences(model, &Model::builtin(name)?);
        if other.is_empty() {
            return Ok(());
        }
        if nearest.as_ref().is_none_or(|n| other.len() < n.len()) {
            nearest = Some(other);
        }
    }
    let other = nearest.unwrap_or_default().join(", ");
    Err(Error::bad_input(format!(
        "this model has equations of its own, which roll-error does not solve: {other}"
    ))
    .with_hint(
        "roll-error knows the equations of the built-in gyrospheres alone, with your parameters; for these, \
             simulate the model: gyrospec simulate MODEL RECORDING",
    ))
}

/// What differs, by name: the built-in's definitions that mean something else, then states and outputs.
fn differences(model: &Model, builtin: &Model) -> Vec<String> {
    let both =
        |name: &str, own: &Expr, theirs: &Expr| (!same(model, own, builtin, theirs)).then(|| name.to_owned());
    let mut out = Vec::new();
    for d in &builtin.definitions {
        let own = model.definitions.iter().find(|o| o.name == d.name);
        out.extend(own.and_then(|o| both(&d.name, &o.equals, &d.equals)));
    }
    for s in &builtin.states {
        match model.states.iter().find(|o| o.name == s.name) {
            Some(o) => out.extend(both(&s.name, &o.rate, &s.rate)),
            None => out.push(format!("no state {}", s.name)),
        }
    }
    let others = model.states.iter().filter(|o| builtin.states.iter().all(|s| s.name != o.name));
    out.extend(others.map(|o| format!("state {}", o.name)));
    for s in &builtin.outputs {
        let own = model.outputs.iter().find(|o| o.name == s.name);
        out.extend(own.and_then(|o| both(&s.name, &o.equals, &s.equals)));
    }
    out
}

/// Whether two expressions agree at points without meaning.
fn same(model: &Model, own: &Expr, builtin: &Model, theirs: &Expr) -> bool {
    (1..=4).all(|point| match (value(model, own, point, 0), value(builtin, theirs, point, 0)) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * (a.abs() + b.abs()),
        _ => false,
    })
}

/// The value where each input, state and parameter has a number of its own between 1 and 2.
fn value(model: &Model, e: &Expr, point: u32, depth: usize) -> Option<f64> {
    if depth > model.definitions.len() {
        return None;
    }
    e.value(&|name| {
        if let Some(d) = model.definitions.iter().find(|d| d.name == name) {
            return value(model, &d.equals, point, depth + 1);
        }
        let sum = name.bytes().fold(0.0, |sum, b| 0.37 * sum + f64::from(b));
        Some(1.5 + 0.5 * (sum * f64::from(point)).sin())
    })
}
