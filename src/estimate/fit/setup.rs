//! From a model and recordings to the records of a fit.

use super::options::FitOptions;
use super::rig::{Record, Track};
use super::seen::initials;
use super::simulated::rig;
use crate::estimate::coordinates::Range;
use crate::model::Model;
use crate::record::{Recording, Span, Spans};
use crate::{Error, Result};

/// Names of the inputs and of the outputs that a recording has.
pub fn used_names<'a>(model: &'a Model, recording: &Recording) -> Vec<&'a str> {
    let inputs = model.inputs.iter().map(|i| i.name.as_str());
    let outputs = model.outputs.iter().map(|o| o.name.as_str());
    inputs.chain(outputs.filter(|o| recording.find(o).is_some())).collect()
}

/// What of a recording is fitted and held out.
pub fn spans(model: &Model, recording: &Recording, options: &FitOptions<'_>) -> Spans {
    recording.spans_for(&used_names(model, recording), options.separate_holdout)
}

/// The time in which all inputs are known.
fn input_range(model: &Model, recording: &Recording) -> Option<Span> {
    let names = used_names(model, recording);
    let inputs: Vec<&str> = names.into_iter().take(model.inputs.len()).collect();
    recording.common_range(if inputs.is_empty() { &[] } else { &inputs })
}

/// A record over given spans of a recording, simulated from the first of them to the last.
///
/// # Errors
/// Where a channel is missing or no sample is left.
pub fn record(
    model: &Model,
    recording: &Recording,
    number: usize,
    spans: &[Span],
    options: &FitOptions<'_>,
) -> Result<Record> {
    for input in &model.inputs {
        recording.channel(&input.name)?;
    }
    let empty = || {
        Error::bad_input(format!(
            "recording '{}' has no sample to compare in the wanted spans",
            recording.name
        ))
        .with_hint("look at its times and spans with `gyrospec record`")
    };
    let range = input_range(model, recording).ok_or_else(empty)?;
    let used = |t: f64| range.contains(t) && spans.iter().any(|s| s.contains(t));
    let mut tracks = Vec::new();
    for (k, output) in model.outputs.iter().enumerate() {
        if recording.find(&output.name).is_some() {
            tracks.push(Track::new(recording, &output.name, k, &used)?);
        }
    }
    if tracks.is_empty() {
        recording.channel(&model.outputs.first().map_or("", |o| o.name.as_str()))?;
    }
    tracks.retain(|t| !t.time.is_empty());
    let first = tracks.iter().filter_map(|t| t.time.first().copied()).reduce(f64::min).ok_or_else(empty)?;
    let last = tracks.iter().filter_map(|t| t.time.last().copied()).reduce(f64::max).ok_or_else(empty)?;
    let start = spans.first().map_or(first, |s| s.from.max(range.from)).min(first);
    let (mut values, free) = initials(model, &tracks, start);
    if let Some(given) = options.initials.get(number).filter(|g| g.len() == values.len()) {
        for k in &free {
            values[*k] = given[*k];
        }
    }
    Ok(Record {
        name: recording.name.clone(),
        recording: number,
        start,
        rig: rig(model, recording, &tracks, Span::new(start, last), options)?,
        tracks,
        constants: constants(model, recording),
        initials: values,
        free_initials: free,
    })
}

/// The recording's constants that are parameters of the model.
fn constants(model: &Model, recording: &Recording) -> Vec<(usize, f64)> {
    model.parameters.iter().enumerate().filter_map(|(k, p)| Some((k, recording.constant(&p.name)?))).collect()
}

/// Numbers of the parameters that the fit moves: free in the model and not known to every record.
pub fn free_parameters(model: &Model, records: &[Record]) -> Vec<usize> {
    (0..model.parameters.len())
        .filter(|k| model.parameters[*k].fit && !records.iter().all(|r| r.knows(*k)))
        .collect()
}

/// The ranges of all unknowns: those of the free parameters, then the initial states without bounds.
pub fn ranges(model: &Model, free: &[usize], records: &[Record]) -> Vec<Range> {
    let initial_states: usize = records.iter().map(|r| r.free_initials.len()).sum();
    free.iter()
        .map(|k| {
            let p = &model.parameters[*k];
            Range { min: p.min.unwrap_or(f64::NEG_INFINITY), max: p.max.unwrap_or(f64::INFINITY) }
        })
        .chain(std::iter::repeat_n(Range::FREE, initial_states))
        .collect()
}

/// One over the mean square of each output's measured signal about its mean.
pub fn signal_weights(model: &Model, records: &[Record]) -> Vec<f64> {
    (0..model.outputs.len())
        .map(|o| {
            let values: Vec<f64> = records
                .iter()
                .flat_map(|r| &r.tracks)
                .filter(|t| t.output == o)
                .flat_map(|t| t.measured.iter().copied())
                .collect();
            let n = values.len().max(1) as f64;
            let mean = values.iter().sum::<f64>() / n;
            let square = values.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / n;
            if square > 0.0 { 1.0 / square } else { 1.0 }
        })
        .collect()
}
