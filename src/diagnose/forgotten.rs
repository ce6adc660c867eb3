//! How long what a gap of an input did to a run is seen in its outputs.
//!
//! # Method
//! The run is made twice over: with a straight line over the gap, and with the input moved there by twice
//! its own spread over the whole of the gap or its last part. A sample can be predicted whatever the input
//! was once the two runs agree, there and from there on, to a share of the noise. So a damped model waits
//! for its slowest motion that an output shows, and one that never forgets waits to the end.
//!
//! # Numerical aspects
//! Parts of the gap in the golden ratio: an undamped motion that one of them leaves as it was, because the
//! part lasts a whole number of periods, is moved by the next.

use super::bench::Bench;
use super::watch::spread;
use crate::Result;
use crate::model::Model;
use crate::record::{Channel, Recording};
use crate::simulate::{GAP_STEPS, Options, Simulator};

/// Shares of the gap, up to its end, over which the input is moved.
const PARTS: [f64; 3] = [1.0, 0.618, 0.382];
/// Spreads of the input that it is moved by.
const MOVED: f64 = 2.0;
/// Tolerances of the simulator that two runs may differ by: a quarter of the noise.
const SEEN: f64 = 5.0;
/// Part of the usual tolerance to which these runs are made.
const FINER: f64 = 0.1;

/// What the gaps of a recording's inputs leave in the outputs of a model: (number of the output, start of the
/// gap, last time at which it is seen), s; none where the model has no memory.
///
/// # Errors
/// Where the model cannot be run.
pub fn traces(
    bench: &Bench,
    model: &Model,
    recording: &Recording,
    initials: &[f64],
    from: f64,
) -> Result<Vec<(usize, f64, f64)>> {
    let mut found = Vec::new();
    for input in model.inputs.iter().filter_map(|i| recording.find(&i.name)) {
        for gap in input.gaps(GAP_STEPS) {
            let run = |size: f64, part: f64| -> Result<(Simulator, Vec<Vec<f64>>)> {
                let mut moved = recording.clone();
                if let Some(c) = moved.channels.iter_mut().find(|c| c.name == input.name) {
                    *c = bridged(input, gap, (size, part));
                }
                let tolerance = FINER * bench.tolerance;
                let window = Some((from, f64::INFINITY));
                let budget = bench.budget.clone();
                let how = Options { tolerance, window, waits: false, budget, ..Options::default() };
                let simulator = Simulator::new(model, &moved, &how)?;
                let ran = simulator.run(&simulator.parameters(), initials)?;
                Ok((simulator, ran.outputs))
            };
            let (simulator, straight) = run(0.0, 1.0)?;
            if !simulator.is_dynamic() {
                return Ok(Vec::new());
            }
            for part in PARTS {
                let (_, moved) = run(MOVED * spread_of(input), part)?;
                for (o, (a, b)) in simulator.outputs().iter().zip(straight.iter().zip(&moved)) {
                    let most = SEEN * bench.tolerance * bench.spread(&o.name);
                    let agree = |i: usize| (a[i] - b[i]).abs() <= most;
                    let differs = |i: &usize| o.time[*i] >= gap.0 && o.covered[*i] && !agree(*i);
                    if let Some(last) = (0..o.time.len()).rev().find(differs) {
                        found.push((o.output, gap.0, o.time[last]));
                    }
                }
            }
        }
    }
    Ok(found)
}

fn spread_of(c: &Channel) -> f64 {
    spread(&c.samples().map(|s| s.1).collect::<Vec<_>>())
}

/// Whether an input of a model has a gap.
pub fn has_gaps(model: &Model, recording: &Recording) -> bool {
    model.inputs.iter().filter_map(|i| recording.find(&i.name)).any(|c| !c.gaps(GAP_STEPS).is_empty())
}

/// A channel with samples in a gap: a straight line, moved by a size over the last part of the gap.
fn bridged(c: &Channel, (from, to): (f64, f64), (size, part): (f64, f64)) -> Channel {
    let step = c.median_step().unwrap_or(to - from);
    let before: Vec<(f64, f64)> = c.samples().filter(|s| s.0 <= from).collect();
    let after: Vec<(f64, f64)> = c.samples().filter(|s| s.0 >= to).collect();
    let (a, b) = (before[before.len() - 1].1, after[0].1);
    let count = ((to - from) / step).round().max(2.0);
    let between = (1..count as usize).map(|k| {
        let share = k as f64 / count;
        let moved = if share >= 1.0 - part { size } else { 0.0 };
        (from + share * (to - from), a + share * (b - a) + moved)
    });
    let (time, values): (Vec<f64>, Vec<f64>) = before.iter().copied().chain(between).chain(after).unzip();
    let mut bridged = Channel::new(c.name.clone(), c.unit.clone(), time, values);
    (bridged.hold, bridged.table, bridged.wraps) = (c.hold, c.table, c.wraps);
    bridged
}
