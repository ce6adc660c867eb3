//! Which states a model's outputs show, and which state an output's value stands for.

use super::{Definition, Initial, Model, State};
use crate::expression::Expr;
use crate::record::principal;
use crate::units::Unit;

/// How a state is seen: as so many derivatives of an output's signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seen {
    /// Number of the output.
    pub output: usize,
    /// Derivatives taken: 0, 1 or 2.
    pub order: usize,
}

/// For each state how it is seen, if it is: an output equals it, or it is the rate of one that is.
pub fn seen_states(model: &Model) -> Vec<Option<Seen>> {
    let is = |e: &Expr, name: &str| resolved(model, e) == Expr::name(name);
    let mut seen: Vec<Option<Seen>> = model
        .states
        .iter()
        .map(|s| {
            let output = model.outputs.iter().position(|o| is(&o.equals, &s.name))?;
            Some(Seen { output, order: 0 })
        })
        .collect();
    for _ in 0..2 {
        for i in 0..model.states.len() {
            let Some(above) = seen[i].filter(|s| s.order < 2) else { continue };
            let rate = &model.states[i].rate;
            if let Some(k) = model.states.iter().position(|s| is(rate, &s.name)) {
                seen[k] = seen[k].or(Some(Seen { output: above.output, order: above.order + 1 }));
            }
        }
    }
    seen
}

/// An expression that is only a definition's name replaced by what that equals.
fn resolved(model: &Model, e: &Expr) -> Expr {
    let mut e = e.clone();
    for _ in 0..model.definitions.len() {
        let Expr::Name(name) = &e else { break };
        match model.definitions.iter().find(|d| d.name == *name) {
            Some(d) => e = d.equals.clone(),
            None => break,
        }
    }
    e
}

/// For a state that is not seen: the output of its dimension that mentions it alone among the states, such as a clipped or
/// late one, or else alone among those of its dimension, such as one that feels a speed beside a position.
pub fn nearly_seen(model: &Model, state: usize) -> Option<Seen> {
    let own = &model.states[state];
    let is_alike = |unit: &Unit| unit.dimension() == own.unit.dimension();
    let alone = |e: &Expr, among: &dyn Fn(&State) -> bool| {
        let e = resolved(model, e);
        model.states.iter().filter(|s| among(s)).all(|s| e.mentions(&s.name) == (s.name == own.name))
    };
    let shows = |among: &dyn Fn(&State) -> bool| {
        model.outputs.iter().position(|o| is_alike(&o.unit) && alone(&o.equals, among))
    };
    let output = shows(&|_| true).or_else(|| shows(&|s| is_alike(&s.unit)))?;
    Some(Seen { output, order: 0 })
}

/// The state x of which an output y = e₀ + s x shows a value, where all else in it is known.
pub fn shifted(
    model: &Model,
    (state, output): (usize, usize),
    (y, wraps): (f64, bool),
    known: &dyn Fn(&str) -> Option<f64>,
) -> Option<f64> {
    let own = &model.states[state].name;
    let shown = |x: f64| Names { model, others: known, own: (own, x) }.value(&model.outputs[output].equals);
    let (none, slope) = (shown(0.0)?, shown(1.0)? - shown(0.0)?);
    let is_straight = slope != 0.0 && (shown(2.0)? - none - 2.0 * slope).abs() <= 1e-9 * slope.abs();
    // the turn is that of the input; without one, that of the output
    let is_beside = model.inputs.iter().any(|i| model.reaches(&model.outputs[output].equals, &i.name));
    let above = if wraps && is_beside { principal(y - none) } else { y - none };
    Some(above / slope).filter(|x| is_straight && x.is_finite())
}

/// What names stand for, with a value of one state.
struct Names<'a> {
    model: &'a Model,
    others: &'a dyn Fn(&str) -> Option<f64>,
    own: (&'a str, f64),
}

impl Names<'_> {
    fn value(&self, e: &Expr) -> Option<f64> {
        e.value(&|name| self.of(name))
    }

    fn of(&self, name: &str) -> Option<f64> {
        if name == self.own.0 {
            return Some(self.own.1);
        }
        let is_own = |d: &&Definition| d.name == name;
        (self.others)(name).or_else(|| self.value(&self.model.definitions.iter().find(is_own)?.equals))
    }
}

/// First guesses of all states from what outputs show first, in SI: `shows` gives the value of a state that is seen so,
/// `input` that of an input by its number. A state that is not seen begins like a seen state of its dimension, else like an
/// input of it, else at zero.
pub fn first_guesses(
    model: &Model,
    shows: impl Fn(usize, Seen) -> Option<f64>,
    input: impl Fn(usize) -> Option<f64>,
) -> Vec<f64> {
    let direct = seen_states(model);
    let seen: Vec<Option<Seen>> =
        direct.into_iter().enumerate().map(|(k, s)| s.or_else(|| nearly_seen(model, k))).collect();
    let mut values: Vec<Option<f64>> = seen.iter().enumerate().map(|(k, s)| shows(k, (*s)?)).collect();
    // a lag begins near what it follows, a temperature near another
    let driven = |unit: &Unit| {
        let alike = |u: &Unit| u.dimension() == unit.dimension() && !unit.dimension().is_none();
        input(model.inputs.iter().position(|i| alike(&i.unit))?)
    };
    for i in 0..values.len() {
        let unit = &model.states[i].unit;
        let is_like = |k: &usize| {
            values[*k].is_some()
                && seen[*k].is_some()
                && model.states[*k].unit.dimension() == unit.dimension()
        };
        if values[i].is_none() {
            let like = (0..values.len()).find(is_like).and_then(|k| values[k]);
            values[i] = like.or_else(|| driven(unit));
        }
    }
    values.into_iter().map(|v| v.filter(|v| v.is_finite()).unwrap_or(0.0)).collect()
}

/// What a state begins at: its number, what is guessed of one to be fitted, or NaN for a steady one.
pub fn begins_at(state: &State, guess: f64) -> f64 {
    match state.initial {
        Initial::Number(x) => x,
        Initial::Fit => guess,
        Initial::Steady => f64::NAN,
    }
}
