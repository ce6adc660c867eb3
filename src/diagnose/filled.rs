//! Inputs that were recorded more slowly than their table, and repeated in between.
//!
//! # Purpose
//! A table that joins a quick and a slow instrument repeats the last value of the slow one. As it stands such an input is late by
//! half of its own step, and what would make it earlier is no physics.
//!
//! # Method
//! Where an input changes on a grid of several samples, the direction in which straight lines between its changes move the
//! predictions is held against the residual, as that of a held input is (`hold`). Where the weight may be 1 and is not 0, it is
//! read so, if the refitted model is likelier.

use super::bench::Bench;
use super::choose::TIE;
use super::compared::anew;
use super::hold::{Weight, measured, weighed};
use super::measure::{Measure, Scale};
use super::repeated::grid;
use crate::estimate::Fit;
use crate::record::{Channel, Hold, Recording};
use crate::simulate::GAP_STEPS;
use crate::units::figure;
use std::collections::BTreeMap;

/// Reads inputs as straight lines between their changes where the recordings show it: the model fitted so, with what a reader
/// should know.
pub fn settle(bench: &mut Bench, separate: &mut [Recording], base: Fit) -> (Fit, Vec<String>) {
    let steps: BTreeMap<String, f64> = measured(&base.model)
        .filter_map(|name| Some((name.clone(), common_step(&bench.recordings, name)?)))
        .collect();
    let read = |recordings: &mut [Recording], names: &[String]| read(recordings, names, &steps);
    let weights = if steps.is_empty() { None } else { weighed(bench, &base, steps.keys().collect(), read) };
    let shown = weights.into_iter().flatten().filter(Weight::is_rather);
    let names: Vec<String> = shown.map(|w| w.name).collect();
    if names.is_empty() {
        return (base, Vec::new());
    }
    let as_given = bench.recordings.clone();
    read(&mut bench.recordings, &names);
    let scale = Scale::of(&base, false);
    let likelihood = |fit: &Fit| Measure::of(fit, &scale).likelihood;
    match anew(bench, &base) {
        Ok(fit) if likelihood(&fit) > likelihood(&base) + TIE => {
            read(separate, &names);
            (fit, names.iter().map(|name| note(name, steps[name])).collect())
        }
        _ => {
            bench.recordings = as_given;
            (base, Vec::new())
        }
    }
}

/// The step of an input that was repeated in between in all recordings, s.
fn common_step(recordings: &[Recording], name: &str) -> Option<f64> {
    let step = |r: &Recording| {
        let channel = r.find(name).filter(|c| c.hold == Hold::Linear)?;
        Some(grid(channel)? as f64 * channel.median_step()?)
    };
    let steps: Option<Vec<f64>> = recordings.iter().map(step).collect();
    steps?.first().copied()
}

/// Reads inputs as straight lines between their changes, each with its step in s.
fn read(recordings: &mut [Recording], names: &[String], steps: &BTreeMap<String, f64>) {
    for c in recordings.iter_mut().flat_map(|r| &mut r.channels).filter(|c| names.contains(&c.name)) {
        let samples = c.median_step().map(|usual| (steps[&c.name] / usual).round() as usize);
        if let Some(samples) = samples.filter(|n| *n > 1) {
            straighten(c, samples);
        }
    }
}

/// Straight lines between the changes of a channel, at the times that it has; what stays longer is repeated on the grid, and no
/// line runs over a gap.
fn straighten(c: &mut Channel, step: usize) {
    let longest = c.longest_step(GAP_STEPS);
    let is_lost = |i: usize| c.values[i].is_nan();
    let is_open = |i: usize| is_lost(i) || is_lost(i - 1) || c.time[i] - c.time[i - 1] > longest;
    let mut straight = c.values.clone();
    let mut last = 0;
    for i in 1..c.len() {
        let is_kept = c.values[i] != c.values[i - 1] || i - last >= step || i + 1 == c.len();
        let is_end = i + 1 < c.len() && is_open(i + 1);
        if is_open(i) || is_kept || is_end {
            let (from, to) = (c.time[last], c.time[i]);
            let lines = if is_open(i) { i..i } else { last + 1..i };
            for k in lines {
                straight[k] =
                    c.values[last] + (c.values[i] - c.values[last]) * ((c.time[k] - from) / (to - from));
            }
            last = i;
        }
    }
    c.values = straight;
}

/// What a reader should know.
fn note(name: &str, step: f64) -> String {
    format!(
        "{name} was recorded every {} s and repeated in between: it is read as straight lines between its changes, which fits better",
        figure(step)
    )
}
