//! Which states a recording shows, directly or by differentiation.

use super::rig::Track;
use crate::estimate::smooth::Smoother;
use crate::expression::Expr;
use crate::model::{Initial, Model};

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

/// For a state that is not seen: the output that mentions it alone among the states and has its
/// dimension, such as a clipped or shifted one.
fn nearly_seen(model: &Model, state: usize) -> Option<Seen> {
    let own = &model.states[state];
    let alone = |e: &Expr| {
        let e = resolved(model, e);
        model.states.iter().all(|s| e.mentions(&s.name) == (s.name == own.name))
    };
    let alike = |unit: &crate::units::Unit| unit.dimension() == own.unit.dimension();
    let output = model.outputs.iter().position(|o| alike(&o.unit) && alone(&o.equals))?;
    Some(Seen { output, order: 0 })
}

/// First guesses of all states at the start of their tracks: seen ones from the smoothed signal, an
/// unseen one like a seen state of the same dimension, else zero.
pub fn guess(model: &Model, tracks: &[Track], start: f64) -> Vec<f64> {
    let seen: Vec<Option<Seen>> = seen_states(model)
        .into_iter()
        .enumerate()
        .map(|(k, s)| s.or_else(|| nearly_seen(model, k)))
        .collect();
    let mut values: Vec<Option<f64>> = seen
        .iter()
        .map(|s| {
            let s = (*s)?;
            let track = tracks.iter().find(|t| t.output == s.output)?;
            let at = track.time.partition_point(|t| *t < start).min(track.time.len().checked_sub(1)?);
            match Smoother::new(&track.time, &track.measured) {
                Some(smoother) => Some(smoother.jet(at)[s.order]),
                None => (s.order == 0).then(|| track.measured[at]),
            }
        })
        .collect();
    for i in 0..values.len() {
        let alike = |k: &usize| {
            values[*k].is_some()
                && seen[*k].is_some()
                && model.states[*k].unit.dimension() == model.states[i].unit.dimension()
        };
        if values[i].is_none() {
            values[i] = (0..values.len()).find(alike).and_then(|k| values[k]);
        }
    }
    values.into_iter().map(|v| v.filter(|v| v.is_finite()).unwrap_or(0.0)).collect()
}

/// The initial states that a record starts from, and which of them are free.
pub fn initials(model: &Model, tracks: &[Track], start: f64) -> (Vec<f64>, Vec<usize>) {
    let guessed = guess(model, tracks, start);
    let values = model
        .states
        .iter()
        .zip(guessed)
        .map(|(s, guess)| match s.initial {
            Initial::Number(x) => x,
            Initial::Fit => guess,
            Initial::Steady => f64::NAN,
        })
        .collect();
    let free = (0..model.states.len()).filter(|k| model.states[*k].initial == Initial::Fit).collect();
    (values, free)
}
