//! Purpose: spans in which a channel repeats one value while it should move.
//!
//! Method: the runs of equal samples that are far longer than all others are frozen where
//! 1. stretches half as long, elsewhere in the channel, (almost) never stand still: this leaves
//!    out signals that are switched between levels, and slow ones of coarse resolution;
//! 2. stretches as long usually move by several quanta;
//! 3. right before and after the run the channel moves about as much as usual: this leaves out a
//!    motion that dies away, and one that has not begun.
//!
//! Or where the channel has noise above its resolution wherever it is looked at, at rest too: such a
//! channel never repeats its values, whatever moves or rests beside it.
//!
//! It is sure where besides the value is neither zero (a thing switched off) nor an end of the
//! range (a sensor at its limit), and where a real rest would look otherwise: the channel has
//! noise above its resolution, which never stands still, or it leaps when each run ends. A leap alone
//! could be that of a command, which holds what it was given ([`Fault::may_be_held`]).
//!
//! References: the plateau test of oceanographic quality control, IOC Manuals and Guides 26
//! (1993), made relative to the channel's own motion.

use super::{Fault, FaultKind, Samples, ends, quantile, quantum};
use crate::record::{Channel, Span};

/// Samples that must be alike for a channel to be still.
const FEWEST: usize = 3;
const SHORTEST: usize = 12;
/// Runs below a third of that are no match for a candidate.
const SHORTEST_KEPT: usize = 4;
const WINDOWS: usize = 400;
const FEWEST_WINDOWS: usize = 12;
/// Share of windows elsewhere that may stand still.
const STILL: f64 = 0.005;
const QUANTA: f64 = 4.0;
const LIVELY: f64 = 0.3;
const FAR_LONGER: f64 = 3.0;
const MOST_RUNS: usize = 20;
/// Differences of noise grow with their order (1.87 from third to fourth for white noise); those
/// of smooth motion shrink.
const NOISE_GROWS: f64 = 1.2;
/// Rounding alone gives fourth differences of about two quanta.
const QUANTA_OF_NOISE: f64 = 10.0;
/// Against the 99th percentile of all other steps.
const LEAP: f64 = 2.0;
/// Samples of a block in which noise is measured.
const BLOCK: usize = 32;
/// Share of its usual size below which noise goes with the motion, and may rest with it.
const STEADY: f64 = 0.2;

/// A run of equal samples, ends included.
#[derive(Clone, Copy)]
struct Run {
    first: usize,
    last: usize,
}

impl Run {
    fn length(self) -> usize {
        self.last - self.first + 1
    }
}

/// Frozen spans; `size` is the held value of the longest, SI.
pub fn frozen(channel: &Channel) -> Option<Fault> {
    let Samples { time, values } = Samples::of(channel);
    let long = far_longer(runs(&values));
    let step = quantum(channel).unwrap_or(0.0);
    let noise = Noise::of(&values, &long, step);
    let stands = |r: &Run| noise.never_rests || is_frozen(&values, *r, &long, step);
    let found: Vec<Run> = long.iter().copied().filter(stands).collect();
    let (low, high) = ends(&values);
    let odd: Vec<Run> =
        found.iter().copied().filter(|r| ![0.0, low, high].contains(&values[r.first])).collect();
    let sure = !odd.is_empty() && (noise.is_there || odd.iter().all(|r| leaps(&values, &long, *r)));
    let kept = if sure { odd } else { found };
    let size = values[kept.first()?.first];
    let mut spans: Vec<Span> = kept.iter().map(|r| Span::new(time[r.first], time[r.last])).collect();
    spans.sort_by(|a, b| a.from.total_cmp(&b.from));
    let samples = kept.iter().map(|r| r.length()).sum();
    let may_be_held = !noise.is_there;
    Some(Fault { samples, size, sure, may_be_held, ..Fault::of(FaultKind::Frozen, channel, spans) })
}

/// A channel of three samples and more that never changes, gaps or not; `size` is its value, SI.
///
/// Sure for a measured one alone: an input may be held throughout.
pub fn still(channel: &Channel) -> Option<Fault> {
    let Samples { time, values } = Samples::of(channel);
    let (low, high) = ends(&values);
    if values.len() < FEWEST || low != high {
        return None;
    }
    let spans = vec![Span::new(time[0], time[time.len() - 1])];
    Some(Fault { samples: values.len(), size: low, ..Fault::of(FaultKind::Frozen, channel, spans) })
}

/// The few runs that are set apart from all others by their length, longest first.
fn far_longer(mut runs: Vec<Run>) -> Vec<Run> {
    runs.sort_by_key(|r| std::cmp::Reverse(r.length()));
    let length = |i: usize| runs.get(i).map_or(SHORTEST_KEPT - 1, |r| r.length());
    let ratio = |k: usize| length(k - 1) as f64 / length(k) as f64;
    let most = MOST_RUNS.min(runs.len());
    let Some(count) = (1..=most).max_by(|a, b| ratio(*a).total_cmp(&ratio(*b))) else { return runs };
    if ratio(count) < FAR_LONGER || length(count - 1) < SHORTEST {
        return Vec::new();
    }
    runs.truncate(count);
    runs
}

/// Places away from long runs, with four samples before each.
fn free<'a>(values: &'a [f64], long: &'a [Run]) -> impl Iterator<Item = usize> + 'a {
    let inside = |i: &usize| long.iter().any(|r| r.first < *i && *i <= r.last + 5);
    (4..values.len()).filter(move |i| !inside(i))
}

/// Noise of a channel away from its long runs.
struct Noise {
    /// It stands above the resolution, and does not go with the motion.
    is_there: bool,
    /// It does so everywhere, at rest as in motion.
    never_rests: bool,
}

impl Noise {
    fn of(values: &[f64], long: &[Run], quantum: f64) -> Self {
        let at: Vec<usize> = free(values, long).collect();
        let third =
            |i: &usize| (values[*i] - 3.0 * values[i - 1] + 3.0 * values[i - 2] - values[i - 3]).abs();
        let fourth = |i: &usize| {
            let x = &values[i - 4..=*i];
            (x[4] - 4.0 * x[3] + 6.0 * x[2] - 4.0 * x[1] + x[0]).abs()
        };
        let (thirds, fourths): (Vec<f64>, Vec<f64>) = at.iter().map(|i| (third(i), fourth(i))).unzip();
        let middle = |d: &[f64]| quantile(d.iter().copied(), 0.5).unwrap_or(0.0);
        let (small, usual) = (middle(&thirds), middle(&fourths));
        let resolution = (QUANTA_OF_NOISE * quantum).max(1e-9 * range(values));
        let blocks = fourths.chunks_exact(BLOCK).map(middle);
        let least = blocks.clone().fold(f64::INFINITY, f64::min);
        let is_there = usual > resolution && usual >= NOISE_GROWS * small && least > STEADY * usual;
        Self { is_there, never_rests: is_there && blocks.len() >= FEWEST_WINDOWS && least > resolution }
    }
}

/// Whether a channel leaps when a run ends.
fn leaps(values: &[f64], long: &[Run], run: Run) -> bool {
    let steps: Vec<f64> = free(values, long).map(|i| (values[i] - values[i - 1]).abs()).collect();
    let large = quantile(steps.iter().copied(), 0.99).unwrap_or(0.0);
    values.get(run.last + 1).is_some_and(|v| (v - values[run.first]).abs() >= LEAP * large)
}

/// The runs of some length.
fn runs(values: &[f64]) -> Vec<Run> {
    let mut runs = Vec::new();
    let mut run = Run { first: 0, last: 0 };
    for (i, pair) in values.windows(2).enumerate() {
        if pair[0] == pair[1] {
            run.last = i + 1;
            continue;
        }
        if run.length() >= SHORTEST_KEPT {
            runs.push(run);
        }
        run = Run { first: i + 1, last: i + 1 };
    }
    if run.length() >= SHORTEST_KEPT {
        runs.push(run);
    }
    runs
}

fn is_frozen(values: &[f64], run: Run, long: &[Run], quantum: f64) -> bool {
    let apart =
        |first: usize, length: usize| long.iter().all(|r| first > r.last || first + length <= r.first);
    let short = ranges(values, run.length() / 2, apart);
    let still = short.iter().filter(|r| **r == 0.0).count();
    if short.len() < FEWEST_WINDOWS || still as f64 > STILL * short.len() as f64 {
        return false;
    }
    let as_long = ranges(values, run.length(), apart);
    let (usual, window) =
        if as_long.len() < FEWEST_WINDOWS { (short, run.length() / 2) } else { (as_long, run.length()) };
    let Some(usual) = quantile(usual.iter().copied(), 0.5) else { return false };
    let before = &values[run.first.saturating_sub(window)..run.first];
    let after = &values[run.last + 1..(run.last + 1 + window).min(values.len())];
    // Too short a rest at an end of the channel tells nothing.
    let mut beside = [before, after].into_iter().filter(|v| 4 * v.len() >= window).peekable();
    usual > QUANTA * quantum && beside.peek().is_some() && beside.all(|v| range(v) >= LIVELY * usual)
}

fn ranges(values: &[f64], length: usize, apart: impl Fn(usize, usize) -> bool) -> Vec<f64> {
    let every = ((values.len().saturating_sub(length)) / WINDOWS).max(1);
    let starts = (0..values.len().saturating_sub(length)).step_by(every);
    starts.filter(|s| apart(*s, length)).map(|s| range(&values[s..s + length])).collect()
}

fn range(values: &[f64]) -> f64 {
    let (low, high) = ends(values);
    high - low
}
