//! Where the states of a model begin on a recording, and between what they may.

use super::harness::{Harness, Track};
use crate::estimate::coordinates::Range;
use crate::estimate::smooth::Smoother;
use crate::model::shown::{Seen, begins_at, first_guesses, nearly_seen, seen_states, shifted};
use crate::model::{Initial, Model, State};
use crate::record::{Channel, Recording};
use crate::units::Unit;

/// First guesses of all states at the start of their tracks: seen ones from the smoothed signal.
fn guess(model: &Model, recording: &Recording, tracks: &[Track], start: f64) -> Vec<f64> {
    let shows = |k: usize, seen: Seen| {
        let track = tracks.iter().find(|t| t.output == seen.output)?;
        let at = track.time.partition_point(|t| *t < start).min(track.time.len().checked_sub(1)?);
        let value = match Smoother::new(&track.time, &track.measured) {
            Some(smoother) => smoother.jet(at)[seen.order],
            None => (seen.order == 0).then(|| track.measured[at])?,
        };
        let time = track.time.iter().copied().find(|t| *t >= start).unwrap_or(start);
        let known = |name: &str| known(model, recording, time, name);
        let own = || shifted(model, (k, seen.output), (value, track.wraps), &known);
        if seen.order == 0 { own().or(Some(value)) } else { Some(value) }
    };
    first_guesses(model, shows, |i| at(recording.find(&model.inputs[i].name)?, start))
}

/// What a name stands for at a time of a recording: a constant, a parameter or an input.
fn known(model: &Model, recording: &Recording, time: f64, name: &str) -> Option<f64> {
    let parameter = || Some(model.parameters.iter().find(|p| p.name == name)?.value);
    let is_input = model.inputs.iter().any(|i| i.name == name);
    let input = || at(recording.find(name).filter(|_| is_input)?, time);
    recording.constant(name).or_else(parameter).or_else(input)
}

/// What a channel holds at a time.
fn at(channel: &Channel, time: f64) -> Option<f64> {
    channel.samples().take_while(|s| s.0 <= time).last().map(|s| s.1)
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
    let value = |(s, start): (&State, f64)| begins_at(s, start);
    (model.states.iter().zip(starts).map(value).collect(), free)
}
