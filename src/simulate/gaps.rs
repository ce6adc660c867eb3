//! # Purpose
//! What of the outputs cannot be predicted because an input has a gap.
//!
//! # Method
//! Over a gap the run goes on with a straight input, which nobody measured. Nothing in the gap is
//! compared, nor what follows until the model has forgotten what the gap did to it. What it did is measured on the rest
//! of that input: how far a straight line over as long a stretch is from the input's own integral there, beside what
//! the input does to a lag of the model's memory. So a gap over which an input is nearly straight costs nothing, and one
//! of a lively input as many time constants as its effect needs to fade. Where that would cost too many samples the gaps
//! alone are left out, and it is told.
//!
//! # Numerical aspects
//! The memory is that at the start of the run, at the model's own parameters.

use super::mesh::Samples;
use crate::model::Model;

/// What a gap did counts as forgotten when this share of what the input does is left: five time constants for a gap that
/// says nothing of the input.
const FORGOTTEN: f64 = 0.007;
/// The share of the samples that may be given up to wait.
const WORTH: f64 = 0.5;
/// Stretches of the input on which a straight line is tried.
const TRIALS: usize = 64;

/// A gap of an input, s, and what it does to the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gap {
    /// Number of the input in the model.
    pub input: usize,
    pub from: f64,
    pub to: f64,
    /// Effect of the straight line's error beside that of the input, for a lag of the model's memory.
    pub effect: f64,
}

/// The gaps of all inputs of a model that remembers for so long, s.
pub(super) fn gaps(inputs: &[Samples], memory: f64) -> Vec<Gap> {
    let of = |(input, s): (usize, &Samples)| {
        let seen: f64 = s.range().map_or(0.0, |(a, b)| b - a);
        let size = effect_of_input(s, memory.min(seen));
        s.gaps
            .iter()
            .map(|(from, to)| {
                let missed = missed_by_a_line(s, to - from);
                let effect = if missed == 0.0 { 0.0 } else { missed / size };
                Gap { input, from: *from, to: *to, effect }
            })
            .collect::<Vec<_>>()
    };
    inputs.iter().enumerate().flat_map(of).collect()
}

/// Root mean square of ∫ (u − line) dt over stretches so long, the line between their ends.
fn missed_by_a_line(s: &Samples, length: f64) -> f64 {
    let Some((first, last)) = s.range() else { return 0.0 };
    let clear = |from: f64| s.gaps.iter().all(|g| from + length <= g.0 || from >= g.1);
    let (mut sum, mut count) = (0.0, 0.0);
    for k in 0..TRIALS {
        let from = first + (last - first - length) * (k as f64 + 0.5) / TRIALS as f64;
        if last - first > length && clear(from) {
            let i = s.time.partition_point(|t| *t < from);
            let j = s.time.partition_point(|t| *t <= from + length).max(i + 1) - 1;
            let line = 0.5 * (s.values[i] + s.values[j]) * (s.time[j] - s.time[i]);
            let own: f64 =
                (i..j).map(|m| 0.5 * (s.values[m] + s.values[m + 1]) * (s.time[m + 1] - s.time[m])).sum();
            sum += (own - line) * (own - line);
            count += 1.0;
        }
    }
    // nothing as long as the gap is there to tell: what follows is waited for as long as it takes
    if count == 0.0 { f64::INFINITY } else { (sum / count).sqrt() }
}

/// Root mean square of what the input, less its mean, makes of ẏ = u − y/T.
fn effect_of_input(s: &Samples, memory: f64) -> f64 {
    let mean = s.values.iter().sum::<f64>() / s.values.len() as f64;
    let (mut y, mut sum) = (0.0, 0.0);
    for w in 1..s.time.len() {
        let step = s.time[w] - s.time[w - 1];
        let u = 0.5 * (s.values[w] + s.values[w - 1]) - mean;
        let decay = (-step / memory).exp();
        y = decay * y + memory * (1.0 - decay) * u;
        sum += y * y;
    }
    (sum / s.time.len() as f64).sqrt()
}

/// The gaps of all inputs, as stretches.
pub(super) fn stretches(inputs: &[Samples]) -> Vec<(f64, f64)> {
    inputs.iter().flat_map(|s| s.gaps.iter().copied()).collect()
}

/// The gaps with the wait after each, if that leaves enough of the times that are compared now.
pub(super) fn with_waits(
    gaps: &[Gap],
    compared: impl Iterator<Item = f64>,
    memory: f64,
) -> Option<Vec<(f64, f64)>> {
    let wait = |g: &Gap| if g.effect > FORGOTTEN { memory * (g.effect / FORGOTTEN).ln() } else { 0.0 };
    let longer: Vec<(f64, f64)> = gaps.iter().map(|g| (g.from, g.to + wait(g))).collect();
    let (mut all, mut lost) = (0_usize, 0_usize);
    for t in compared {
        all += 1;
        lost += usize::from(inside(&longer, t));
    }
    (lost as f64 <= WORTH * all as f64).then_some(longer)
}

/// What is said where there is no waiting.
pub(super) fn lasting(gaps: &[Gap], model: &Model) -> Option<String> {
    let worst = gaps.iter().max_by(|a, b| a.effect.total_cmp(&b.effect))?;
    Some(format!(
        "{} has a gap from {:.6} to {:.6} s, and the model remembers what it was there through most of what follows: \
         that is guessed by a straight line, and may spoil everything after it. Cut the recording there into two files \
         and give both: each then has a start of its own",
        model.inputs[worst.input].name, worst.from, worst.to
    ))
}

/// Whether a time lies in one of some stretches.
pub(super) fn inside(stretches: &[(f64, f64)], t: f64) -> bool {
    stretches.iter().any(|g| t > g.0 && t < g.1)
}
