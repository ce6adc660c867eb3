//! Probing runs of a response: models with the states' own courses as inputs.

use crate::diagnose::bench::Bench;
use crate::diagnose::catalogue::{Proposal, edit};
use crate::estimate::FitOptions;
use crate::estimate::fit::Effort;
use crate::estimate::fit::harness::{Record, Run, Unknown};
use crate::estimate::fit::setup;
use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Input, Model, Output, Parameter};
use crate::record::{Channel, Recording};
use faer::Mat;
use std::sync::Arc;

/// Points of a mesh that short recordings are refined to, and the finest refinement.
const POINTS: usize = 20_000;
const FINEST: usize = 8;
/// A longer stretch than so many usual steps is divided.
const USUAL: f64 = 1.5;

/// The samples of the finest output, and points between them where they are few or far apart.
pub(super) fn mesh(record: &Record) -> Option<Vec<f64>> {
    let finest = record.tracks.iter().max_by_key(|t| t.time.len())?;
    let mut knots = vec![record.start];
    knots.extend(finest.time.iter().copied().filter(|t| *t > record.start));
    let last = record.tracks.iter().filter_map(|t| t.time.last()).fold(f64::NEG_INFINITY, |a, b| a.max(*b));
    if last > *knots.last()? {
        knots.push(last);
    }
    if knots.len() < 3 {
        return None;
    }
    let mut steps: Vec<f64> = knots.windows(2).map(|w| w[1] - w[0]).collect();
    let middle = steps.len() / 2;
    let usual = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
    let refined = (POINTS / knots.len()).clamp(1, FINEST);
    let mut mesh = vec![knots[0]];
    for w in knots.windows(2) {
        let times = (w[1] - w[0]) / usual;
        let pieces = refined * if times > USUAL { times.round() as usize } else { 1 };
        let h = (w[1] - w[0]) / pieces as f64;
        mesh.extend((1..pieces).map(|k| w[0] + k as f64 * h));
        mesh.push(w[1]);
    }
    (mesh.len() < 4 * POINTS.max(finest.time.len())).then_some(mesh)
}

/// A model ready to run over a mesh.
pub(super) fn ready(
    bench: &Bench,
    (model, recording, number): (&Model, &Recording, usize),
    time: &Arc<[f64]>,
    tolerance: f64,
) -> Option<Record> {
    let mut wider = recording.clone();
    for o in &model.outputs {
        wider.channels.push(Channel::new(
            o.name.clone(),
            o.unit.clone(),
            time.clone(),
            vec![0.0; time.len()],
        ));
    }
    let span = crate::record::Span::new(time[0], *time.last()?);
    let options = FitOptions { tolerance, ..bench.options(Effort::Near, 0) };
    setup::record(model, &wider, number, &[span], &options).ok()
}

/// Runs what is ready; `None` where a point of the mesh cannot be predicted.
pub(super) fn look(
    record: &Record,
    points: usize,
    (parameters, initials): (&[f64], &[f64]),
    wanted: &[usize],
) -> Option<Run> {
    let wanted: Vec<Unknown> = wanted.iter().map(|k| Unknown::Parameter(*k)).collect();
    let run = record.run(parameters, initials, &wanted).ok()?;
    let whole = run.predictions.iter().all(|p| p.len() == points)
        && run.sensitivities.iter().flatten().flatten().all(|x| x.is_finite());
    whole.then_some(run)
}

/// An output of a probing model.
pub(super) fn output(model: &Model, number: usize, equals: &Expr) -> Output {
    Output {
        name: format!("seen__{number}"),
        unit: edit::unit_of(equals, &|n| edit::unit_of_name(model, n)),
        equals: equals.clone(),
        meaning: None,
    }
}

/// A model with its first states as inputs.
pub(super) fn frozen(model: &Model, states: usize) -> Model {
    let mut frozen = model.clone();
    let own = frozen.states.drain(..states);
    frozen.inputs.extend(own.map(|s| Input { name: s.name, unit: s.unit, meaning: None }));
    frozen
}

/// The rates and outputs with the states as inputs, each nudged by a parameter; with those parameters.
pub(super) fn nudged(model: &Model) -> (Model, Vec<usize>) {
    let mut nudged = frozen(model, model.states.len());
    let rates = model.states.iter().map(|s| &s.rate);
    let seen = rates.chain(model.outputs.iter().map(|o| &o.equals));
    nudged.outputs = seen.enumerate().map(|(i, e)| output(model, i, e)).collect();
    let first = nudged.parameters.len();
    for (i, s) in model.states.iter().enumerate() {
        let name = format!("nudge__{i}");
        let plus = Expr::Binary(BinaryOp::Add, Box::new(Expr::name(&s.name)), Box::new(Expr::name(&name)));
        edit::for_each(&mut nudged, |_, e| *e = e.substitute(&s.name, &plus));
        nudged.parameters.push(Parameter {
            name,
            value: 0.0,
            unit: s.unit.of_differences(),
            fit: false,
            min: None,
            max: None,
            meaning: None,
        });
    }
    (nudged, (first..first + model.states.len()).collect())
}

/// Whether an amplitude of a proposal moves the times at which an input jumps or bends: of a jump no look at single moments
/// shows anything, and of slopes it shows those beside each bend.
pub(super) fn moves_bends(proposal: &Proposal) -> bool {
    let model = &proposal.model;
    let inputs: Vec<&str> = model.inputs.iter().map(|i| i.name.as_str()).collect();
    let amplitudes: Vec<&str> =
        proposal.amplitudes.iter().map(|k| proposal.added[*k].name.as_str()).collect();
    let reaches = |e: &Expr, names: &[&str]| names.iter().any(|name| edit::reaches(model, e, name));
    let delays = |e: &Expr| match e {
        Expr::Call(Function::Delay, args) => reaches(&args[0], &inputs) && reaches(&args[1], &amplitudes),
        _ => false,
    };
    parts(model).any(|e| edit::find(e, &delays).is_some())
}

/// Whether the past of a state, or of time itself, is remembered anywhere in a model.
pub(super) fn remembers_states(model: &Model) -> bool {
    let touches = |e: &Expr| model.states.iter().any(|s| edit::reaches(model, e, &s.name));
    let memory = |e: &Expr| matches!(e, Expr::Call(f, args) if f.has_memory() && args.iter().any(touches));
    parts(model).any(|e| edit::find(e, &memory).is_some())
}

/// All definitions, rates and outputs.
fn parts(model: &Model) -> impl Iterator<Item = &Expr> {
    let definitions = model.definitions.iter().map(|d| &d.equals);
    definitions.chain(model.states.iter().map(|s| &s.rate)).chain(model.outputs.iter().map(|o| &o.equals))
}

pub(super) fn rows(m: &Mat<f64>) -> Vec<f64> {
    (0..m.nrows()).flat_map(|i| (0..m.ncols()).map(move |j| m[(i, j)])).collect()
}
