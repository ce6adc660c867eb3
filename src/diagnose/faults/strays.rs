//! Samples of outputs far off that only a fitted model shows.
//!
//! # Purpose
//! Where a channel moves fast, or two bad samples lie side by side, a channel by itself does not show that they are
//! bad; what a fitted model leaves over does.
//!
//! # Method
//! The distance of a residual from the median of its three neighbours on each side, over the robust deviation of
//! all such distances. A stray is one of at most two samples in a row that is far, and those before and after agree.
//! Strays are taken out where so many stand apart as no noise of heavy tails has, and one or two where the rest has none.
//! Strays that go with the edges of an input are none: what a thing does there is physics.
//!
//! # References
//! P. J. Huber, E. M. Ronchetti, Robust Statistics, 2nd ed. (2009).

use super::Spoiled;
use crate::diagnose::bench::Bench;
use crate::diagnose::choose::{CHANCE, SURE};
use crate::diagnose::prove;
use crate::diagnose::stray::{Stray, apart, lone};
use crate::estimate::Fit;
use crate::estimate::noise::robust_deviation;
use crate::model::Model;
use crate::record::quality::{Fault, FaultKind};
use crate::record::{Channel, Recording, Span};
use statrs::distribution::{Binomial, DiscreteCDF};

/// Neighbours on each side.
const BESIDE: usize = 3;
/// Strays in a row at most.
const IN_A_ROW: usize = 2;
/// Share of a distance that counts as far beside it.
const AS_FAR: f64 = 0.5;
/// Share of a distance, and robust deviations, by which those before and after may differ.
const AGREE: (f64, f64) = (0.3, 3.0);
/// Robust deviations from which on strays are asked whether they go with edges.
const CLEAR: f64 = 6.0;
/// More than one sample in so many are the output's nature.
const MOST: usize = 20;
/// Times the usual change of an input from which on a change is an edge.
const EDGE: f64 = 6.0;
/// Samples before and after an edge that go with it.
const ABOUT: (f64, f64) = (1.5, 3.5);

/// The residual of an output in a recording.
struct Line {
    recording: usize,
    time: Vec<f64>,
    distance: Vec<f64>,
    alone: Vec<bool>,
}

impl Line {
    fn new(recording: usize, time: Vec<f64>, residual: &[f64]) -> Self {
        let distance: Vec<f64> = (0..residual.len()).map(|i| distance(residual, i)).collect();
        let noise = AGREE.1 * robust_deviation(&distance);
        let alone = (0..residual.len()).map(|i| is_alone(residual, (&distance, noise), i)).collect();
        Self { recording, time, distance, alone }
    }
}

/// Strays of each output, recording by recording (the fitted ones, then the separate ones), beside faults that are
/// known.
pub fn strays(bench: &Bench, fit: &Fit, separate: &[Recording], known: &[Spoiled]) -> Vec<Spoiled> {
    if bench.is_trials() {
        return Vec::new();
    }
    let recordings: Vec<&Recording> = bench.recordings.iter().chain(separate).collect();
    let outputs = 0..fit.model.outputs.len();
    let of = |k: usize| of_output(bench, (fit, &recordings), k, &lines(bench, fit, separate, k), known);
    outputs.flat_map(of).filter(|s| recordings.len() > s.recording).collect()
}

/// What a fit leaves of an output, and what it leaves of it where that is held out and it is known in which recording.
fn lines(bench: &Bench, fit: &Fit, separate: &[Recording], output: usize) -> Vec<Line> {
    let fitted = fit.records.iter().enumerate().flat_map(|(n, r)| r.series.iter().map(move |s| (n, s)));
    let own = fitted.filter(|(_, s)| s.output == output);
    let mut all: Vec<Line> = own.map(|(n, s)| Line::new(n, s.time.clone(), &s.residual)).collect();
    let apart: Vec<(usize, &[Recording])> = match (bench.recordings.len(), separate) {
        (1, []) => vec![(0, separate)],
        (_, []) => Vec::new(),
        (n, _) => separate.chunks(1).enumerate().map(|(k, one)| (n + k, one)).collect(),
    };
    for (number, one) in apart {
        let held = prove::held_out(bench, fit, one).unwrap_or_default();
        if let Some(h) = held.get(output).filter(|h| h.is_finite()) {
            all.push(Line::new(number, h.time.concat(), &h.residual.concat()));
        }
    }
    all
}

/// The strays of an output, a fault for each recording that has some.
fn of_output(
    bench: &Bench,
    (fit, recordings): (&Fit, &[&Recording]),
    output: usize,
    lines: &[Line],
    known: &[Spoiled],
) -> Vec<Spoiled> {
    let name = &fit.model.outputs[output].name;
    let far = |s: &&Spoiled| s.fault.channel == *name && s.fault.kind == FaultKind::Outliers;
    let known: usize = known.iter().filter(far).map(|s| s.fault.samples).sum();
    let all: Vec<f64> = lines.iter().flat_map(|l| l.distance.iter().copied()).collect();
    let scale = robust_deviation(&all).max(bench.tolerance * bench.spread(name));
    if scale.is_nan() || scale <= 0.0 {
        return Vec::new();
    }
    let free = free_of_edges(recordings, &fit.model, lines, CLEAR * scale);
    let marks = lines.iter().zip(&free).flat_map(|(l, free)| l.alone.iter().zip(free).map(|(a, f)| *a && *f));
    let sizes: Vec<(f64, bool)> = all.iter().map(|d| d.abs() / scale).zip(marks).collect();
    let outputs = fit.model.outputs.len() as f64;
    let is_sure = |s: &Stray| outputs * s.p_value < SURE && s.count > 0;
    let Some(stray) = apart(&sizes, known).filter(is_sure).or_else(|| lone(&sizes).filter(is_sure)) else {
        return Vec::new();
    };
    if stray.count > all.len() / MOST {
        return Vec::new();
    }
    let wild = |l: &Line, i: usize| l.alone[i] && l.distance[i].abs() > stray.beyond * scale;
    let fault = |(l, free): (&Line, &Vec<bool>)| {
        let own: Vec<usize> = (0..l.time.len()).filter(|i| free[*i] && wild(l, *i)).collect();
        let size = own.iter().map(|i| l.distance[*i].abs()).fold(0.0, f64::max);
        let spans: Vec<Span> = own.iter().map(|i| Span::new(l.time[*i], l.time[*i])).collect();
        let (channel, samples) = (name.clone(), own.len());
        let kind = FaultKind::Outliers;
        let fault = Fault { kind, channel, spans, samples, size, sure: true, may_be_held: false };
        (samples > 0).then_some(Spoiled { recording: l.recording, fault })
    };
    lines.iter().zip(&free).filter_map(fault).collect()
}

/// Which samples may be strays: all, or those away from the edges of inputs where far ones go with edges.
fn free_of_edges(recordings: &[&Recording], model: &Model, lines: &[Line], far: f64) -> Vec<Vec<bool>> {
    let at_edge: Vec<Vec<bool>> = lines.iter().map(|l| beside_edges(recordings, model, l)).collect();
    let pairs = || lines.iter().zip(&at_edge).flat_map(|(l, e)| (0..l.time.len()).map(move |i| (l, i, e[i])));
    let (all, beside) = pairs().fold((0.0, 0.0), |(n, k), p| (n + 1.0, k + f64::from(p.2)));
    let clear: Vec<bool> = pairs().filter(|(l, i, _)| l.distance[*i].abs() > far).map(|p| p.2).collect();
    let hits = clear.iter().filter(|e| **e).count() as u64;
    let by_luck = Binomial::new(beside / f64::max(all, 1.0), clear.len() as u64);
    // P(at least so many at edges)
    let goes_with = hits > 0 && by_luck.is_ok_and(|b| b.sf(hits - 1) < CHANCE);
    at_edge.into_iter().map(|e| e.into_iter().map(|e| !(goes_with && e)).collect()).collect()
}

/// Which samples of a line lie beside an edge of an input.
fn beside_edges(recordings: &[&Recording], model: &Model, line: &Line) -> Vec<bool> {
    let Some(recording) = recordings.get(line.recording) else { return vec![false; line.time.len()] };
    let inputs = model.inputs.iter().filter_map(|i| recording.find(&i.name));
    let edges: Vec<(f64, f64)> = inputs.flat_map(edges).collect();
    let steps: Vec<f64> = line.time.windows(2).map(|w| w[1] - w[0]).collect();
    let step = quantile(steps, 0.5);
    let is_beside =
        |t: &f64| edges.iter().any(|(from, to)| *t >= from - ABOUT.0 * step && *t <= to + ABOUT.1 * step);
    line.time.iter().map(is_beside).collect()
}

/// The edges of an input: from the sample before to the one after.
fn edges(input: &Channel) -> Vec<(f64, f64)> {
    let known: Vec<(f64, f64)> = input.samples().collect();
    let sizes: Vec<f64> = known.windows(2).map(|w| (w[1].1 - w[0].1).abs()).collect();
    let usual = quantile(sizes, 0.8);
    let is_edge = |w: &&[(f64, f64)]| (w[1].1 - w[0].1).abs() > EDGE * usual;
    known.windows(2).filter(is_edge).map(|w| (w[0].0, w[1].0)).collect()
}

fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let at = values.len().saturating_sub(1) as f64 * share;
    values.get(at.round() as usize).copied().unwrap_or(0.0)
}

/// e_i less the median of its neighbours; 0 where it has too few.
fn distance(e: &[f64], i: usize) -> f64 {
    let around = i.saturating_sub(BESIDE)..(i + BESIDE + 1).min(e.len());
    let mut beside: Vec<f64> = around.filter(|j| *j != i).map(|j| e[j]).collect();
    beside.sort_unstable_by(f64::total_cmp);
    let n = beside.len();
    let is_last = i + 1 == e.len() && n == BESIDE;
    if n <= BESIDE && !is_last { 0.0 } else { e[i] - 0.5 * (beside[(n - 1) / 2] + beside[n / 2]) }
}

/// Whether few in a row about a sample are as far off, and those before and after agree but for noise.
fn is_alone(e: &[f64], (distance, noise): (&[f64], f64), i: usize) -> bool {
    let far = |j: usize| distance[j].abs() > AS_FAR * distance[i].abs();
    let from = (0..i).rev().take_while(|j| far(*j)).count();
    let to = (i + 1..e.len()).take_while(|j| far(*j)).count();
    let Some(before) = (i - from).checked_sub(1) else { return false };
    let after = match e.get(i + to + 1) {
        Some(after) => *after,
        None if from + to == 0 && before > 0 => e[before - 1],
        None => return false,
    };
    from + to < IN_A_ROW && (e[before] - after).abs() < noise.max(AGREE.0 * distance[i].abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// White noise of unit deviation from a small generator.
    fn noise(n: usize) -> Vec<f64> {
        let mut seed = 7_u64;
        let mut uniform = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        (0..n).map(|_| (0..12).map(|_| uniform()).sum()).collect()
    }

    #[test]
    fn edges_of_inputs_are_known_where_a_recording_is_held_out_whole() {
        let model = Model::parse(
            "name = \"m\"\n[inputs]\nu = { unit = \"1\" }\n[outputs]\ny = { equals = \"u\", unit = \"1\" }\n",
        );
        let stepping = |at: i32| {
            let time: Vec<f64> = (0..100).map(f64::from).collect();
            let u = (0..100).map(|i| f64::from(u8::from(i >= at))).collect();
            let channel = Channel::new("u", crate::units::Unit::one(), time, u);
            Recording::from_channels("r", vec![channel]).unwrap()
        };
        let (fitted, separate) = (stepping(20), stepping(70));
        let line = Line::new(1, (0..100).map(f64::from).collect(), &noise(100));
        let beside = beside_edges(&[&fitted, &separate], &model.unwrap(), &line);
        assert!(beside[70] && beside[71] && !beside[20] && !beside[80]);
    }

    #[test]
    fn single_samples_and_pairs_stand_alone_and_a_step_or_a_hump_does_not() {
        let mut e = noise(400);
        e[100] += 15.0;
        e[200] -= 15.0;
        e[201] += 14.0;
        (300..).zip(&mut e[300..]).for_each(|(_, e)| *e += 15.0);
        (340..346).for_each(|i| e[i] += 15.0);
        e[399] += 20.0;
        let line = Line::new(0, (0..400).map(f64::from).collect(), &e);
        let seen: Vec<usize> = (0..400).filter(|i| line.alone[*i] && line.distance[*i].abs() > 8.0).collect();
        assert_eq!(seen, [100, 200, 201, 399]);
    }
}
