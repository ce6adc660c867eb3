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
use crate::estimate::Fit;
use crate::record::{Channel, Hold, Recording};
use crate::units::figure;

/// Changes that show a grid.
const FEWEST: usize = 20;
/// Share of the times between changes that are one step of the grid, and that are whole ones.
const ON_GRID: (f64, f64) = (0.5, 0.9);

/// Reads inputs as straight lines between their changes where the recordings show it: the model fitted so, with what a reader
/// should know.
pub fn settle(bench: &mut Bench, separate: &mut [Recording], base: Fit) -> (Fit, Vec<String>) {
    let is_filled = |name: &&String| {
        let mut channels = bench.recordings.iter().map(|r| r.find(name));
        channels.all(|c| c.is_some_and(|c| c.hold == Hold::Linear && grid(c).is_some()))
    };
    let names: Vec<&String> = measured(&base.model).filter(is_filled).collect();
    let weights = if names.is_empty() { None } else { weighed(bench, &base, names, read) };
    let shown = weights.into_iter().flatten().filter(Weight::is_rather);
    let names: Vec<String> = shown.map(|w| w.name).collect();
    if names.is_empty() {
        return (base, Vec::new());
    }
    let as_given = bench.recordings.clone();
    let notes = names.iter().filter_map(|name| note(as_given[0].find(name)?)).collect();
    read(&mut bench.recordings, &names);
    let scale = Scale::of(&base, false);
    let likelihood = |fit: &Fit| Measure::of(fit, &scale).likelihood;
    match anew(bench, &base) {
        Ok(fit) if likelihood(&fit) > likelihood(&base) + TIE => {
            read(separate, &names);
            (fit, notes)
        }
        _ => {
            bench.recordings = as_given;
            (base, Vec::new())
        }
    }
}

/// Samples between changes of a channel that was repeated in between.
fn grid(channel: &Channel) -> Option<usize> {
    let changes = (1..channel.len()).filter(|i| channel.values[*i] != channel.values[i - 1]);
    let changes: Vec<usize> = changes.collect();
    let mut between: Vec<usize> = changes.windows(2).map(|w| w[1] - w[0]).collect();
    if between.len() < FEWEST {
        return None;
    }
    between.sort_unstable();
    let step = between[between.len() / 2];
    let share =
        |is: &dyn Fn(usize) -> bool| between.iter().filter(|n| is(**n)).count() as f64 / between.len() as f64;
    // a step that is no whole number of samples is one sooner or later
    let one = share(&|n| n.abs_diff(step) <= 1);
    let whole = share(&|n| (n + 1) % step <= 2);
    (step > 2 && one >= ON_GRID.0 && whole >= ON_GRID.1).then_some(step)
}

/// Reads inputs as straight lines between their changes; what stays longer is repeated on the grid.
fn read(recordings: &mut [Recording], names: &[String]) {
    for c in recordings.iter_mut().flat_map(|r| &mut r.channels).filter(|c| names.contains(&c.name)) {
        let Some(step) = grid(c) else { continue };
        let (mut kept, mut last) = (Vec::new(), 0);
        for i in 0..c.len() {
            let is_new = i == 0 || c.values[i] != c.values[i - 1];
            if is_new || i - last >= step || i + 1 == c.len() {
                kept.push(i);
                last = i;
            }
        }
        c.values = kept.iter().map(|i| c.values[*i]).collect();
        c.time = kept.iter().map(|i| c.time[*i]).collect();
    }
}

/// What a reader should know.
fn note(channel: &Channel) -> Option<String> {
    let step = grid(channel)? as f64 * channel.median_step()?;
    Some(format!(
        "{} was recorded every {} s and repeated in between: it is read as straight lines between its changes, which fits better",
        channel.name,
        figure(step)
    ))
}
