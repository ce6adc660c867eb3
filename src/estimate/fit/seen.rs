//! Which states a recording shows, directly or by differentiation.

use super::harness::{Harness, Track};
use crate::estimate::coordinates::Range;
use crate::estimate::smooth::Smoother;
use crate::expression::Expr;
use crate::model::{Initial, Input, Model};
use crate::record::{Channel, Recording, principal};
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
/// unseen one like a seen state of the same dimension, else like an input of it, else zero.
fn guess(model: &Model, recording: &Recording, tracks: &[Track], start: f64) -> Vec<f64> {
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
    for (k, s) in seen.iter().enumerate().filter_map(|(k, s)| Some((k, s.filter(|s| s.order == 0)?))) {
        let Some(track) = tracks.iter().find(|t| t.output == s.output) else { continue };
        let time = track.time.iter().copied().find(|t| *t >= start).unwrap_or(start);
        let own = |y: f64| shifted(model, recording, (k, s.output), (y, track.wraps), time).unwrap_or(y);
        values[k] = values[k].map(own);
    }
    for i in 0..values.len() {
        let alike = |k: &usize| {
            values[*k].is_some()
                && seen[*k].is_some()
                && model.states[*k].unit.dimension() == model.states[i].unit.dimension()
        };
        if values[i].is_none() {
            let seen = (0..values.len()).find(alike).and_then(|k| values[k]);
            values[i] = seen.or_else(|| driven(model, recording, &model.states[i].unit, start));
        }
    }
    values.into_iter().map(|v| v.filter(|v| v.is_finite()).unwrap_or(0.0)).collect()
}

/// The state x of which an output y = e₀ + s x shows a value at a time, where all else in it is known.
fn shifted(
    model: &Model,
    recording: &Recording,
    (state, output): (usize, usize),
    (y, wraps): (f64, bool),
    start: f64,
) -> Option<f64> {
    let own = &model.states[state].name;
    let shown =
        |x: f64| Known { model, recording, start, own: (own, x) }.value(&model.outputs[output].equals);
    let (none, slope) = (shown(0.0)?, shown(1.0)? - shown(0.0)?);
    let is_straight = slope != 0.0 && (shown(2.0)? - none - 2.0 * slope).abs() <= 1e-9 * slope.abs();
    // the turn is that of the input; without one, that of the output
    let is_beside = model.inputs.iter().any(|i| model.reaches(&model.outputs[output].equals, &i.name));
    let above = if wraps && is_beside { principal(y - none) } else { y - none };
    Some(above / slope).filter(|x| is_straight && x.is_finite())
}

/// What names stand for where a recording starts, with a value of one state.
struct Known<'a> {
    model: &'a Model,
    recording: &'a Recording,
    start: f64,
    own: (&'a str, f64),
}

impl Known<'_> {
    fn value(&self, e: &Expr) -> Option<f64> {
        e.value(&|name| self.of(name))
    }

    fn of(&self, name: &str) -> Option<f64> {
        if name == self.own.0 {
            return Some(self.own.1);
        }
        let defined = || self.value(&self.model.definitions.iter().find(|d| d.name == name)?.equals);
        let parameter = || Some(self.model.parameters.iter().find(|p| p.name == name)?.value);
        let is_input = self.model.inputs.iter().any(|i| i.name == name);
        let input = || at(self.recording.find(name).filter(|_| is_input)?, self.start);
        self.recording.constant(name).or_else(parameter).or_else(input).or_else(defined)
    }
}

/// What a channel holds at a time.
fn at(channel: &Channel, time: f64) -> Option<f64> {
    channel.samples().take_while(|s| s.0 <= time).last().map(|s| s.1)
}

/// What the first input of a dimension is at a time: a lag begins near what it follows, a temperature near another.
fn driven(model: &Model, recording: &Recording, unit: &Unit, start: f64) -> Option<f64> {
    let alike = |i: &&Input| i.unit.dimension() == unit.dimension() && !unit.dimension().is_none();
    at(recording.find(&model.inputs.iter().find(alike)?.name)?, start)
}

/// How many times as far as what is seen a hidden state may start from it.
const FAR: f64 = 10.0;

/// Between what the start of each free state may lie. What an output shows needs no bounds. A hidden state
/// of little effect would run away: it stays within so many times the extent of all signals of its dimension
/// and of its own first guess, or, where there are none, of its course from there; and no temperature in degC
/// starts below absolute zero.
pub fn reach(
    model: &Model,
    recording: &Recording,
    harness: &dyn Harness,
    (starts, free): (&[f64], &[usize]),
) -> Vec<Range> {
    let seen = seen_states(model);
    let parameters: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let mut course = None;
    let mut one = |k: &usize| {
        if seen[*k].or_else(|| nearly_seen(model, *k)).is_some() {
            return Range::FREE;
        }
        let around = |extent: (f64, f64)| {
            let (low, high) = (extent.0.min(starts[*k]), extent.1.max(starts[*k]));
            let far = FAR * (high - low);
            (far > 0.0 && far.is_finite()).then_some(Range { min: low - far, max: high + far })
        };
        let mut own = || {
            let swings = course.get_or_insert_with(|| harness.swings(&parameters, starts));
            swings.as_ref().and_then(|s| s.get(*k).copied())
        };
        let unit = &model.states[*k].unit;
        let alike = signals(model, recording, unit);
        let range = alike.and_then(around).or_else(|| own().and_then(around)).unwrap_or(Range::FREE);
        Range { min: range.min.max(unit.lowest()), ..range }
    };
    free.iter().map(&mut one).collect()
}

/// The lowest and the highest value of all inputs and outputs of a dimension.
fn signals(model: &Model, recording: &Recording, unit: &Unit) -> Option<(f64, f64)> {
    let names = model.inputs.iter().map(|i| &i.name).chain(model.outputs.iter().map(|o| &o.name));
    let alike = names.filter_map(|n| recording.find(n)).filter(|c| c.unit.dimension() == unit.dimension());
    let values = alike.flat_map(|c| c.samples().map(|s| s.1));
    values.map(|v| (v, v)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// The initial states that a record starts from, and which of them are free: these where given, else where guessed.
pub fn initials(
    model: &Model,
    recording: &Recording,
    tracks: &[Track],
    (start, given): (f64, Option<&Vec<f64>>),
) -> (Vec<f64>, Vec<usize>) {
    let free: Vec<usize> =
        (0..model.states.len()).filter(|k| model.states[*k].initial == Initial::Fit).collect();
    let given = given.filter(|g| g.len() == model.states.len()).cloned();
    let starts = match given {
        Some(given) => given,
        None if free.is_empty() => vec![f64::NAN; model.states.len()],
        None => guess(model, recording, tracks, start),
    };
    let value = |(s, start): (&crate::model::State, f64)| match s.initial {
        Initial::Number(x) => x,
        Initial::Fit => start,
        Initial::Steady => f64::NAN,
    };
    (model.states.iter().zip(starts).map(value).collect(), free)
}
