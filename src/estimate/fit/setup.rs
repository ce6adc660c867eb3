//! From a model and recordings to the records of a fit.

use super::harness::Record;
use super::options::FitOptions;
use super::seen::{initials, reach};
use super::simulated::{Ready, ready};
use crate::estimate::coordinates::Range;
use crate::model::Model;
use crate::record::{self, Channel, Recording, Span, Spans};
use crate::{Error, Result, simulate};

/// What of a recording is fitted and held out.
pub fn spans(model: &Model, recording: &Recording, options: &FitOptions<'_>) -> Spans {
    recording.spans_for(&channels(model), options.separate_holdout)
}

/// Names of the channels that a model uses.
pub fn channels(model: &Model) -> Vec<&str> {
    let inputs = model.inputs.iter().map(|i| i.name.as_str());
    inputs.chain(model.outputs.iter().map(|o| o.name.as_str())).collect()
}

/// Refuses recordings that lack a channel, and those that share data which a model compares, fitted or held out.
///
/// # Errors
/// `BadInput` that says what is absent, or which rows or times are the same.
pub fn keep_apart(model: &Model, recordings: &[Recording], separate: &[Recording]) -> Result<()> {
    recordings.iter().chain(separate).try_for_each(|r| simulate::present(model, r))?;
    let inputs: Vec<&str> = model.inputs.iter().map(|i| i.name.as_str()).collect();
    let outputs: Vec<&str> = model.outputs.iter().map(|o| o.name.as_str()).collect();
    record::keep_apart(&inputs, &outputs, recordings, separate)
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
    record_if_any(model, recording, number, spans, options)?.ok_or_else(|| no_sample(model, recording))
}

/// Why nothing can be compared.
fn no_sample(model: &Model, recording: &Recording) -> Error {
    let name = &recording.name;
    let is_empty = |c: &Channel| c.samples().next().is_none();
    let outputs: Vec<&Channel> = model.outputs.iter().filter_map(|o| recording.find(&o.name)).collect();
    let message = match outputs.as_slice() {
        [one] if is_empty(one) => format!("output {} of recording '{name}' holds no number at all", one.name),
        all if all.iter().all(|c| is_empty(c)) => format!("no output of recording '{name}' holds a number"),
        _ => format!("recording '{name}' has no sample to compare in the wanted spans"),
    };
    Error::bad_input(message).with_hint("look at its times and spans with `gyrospec record`")
}

/// The same, or none where no sample is left.
///
/// # Errors
/// Where a channel is missing.
pub fn record_if_any(
    model: &Model,
    recording: &Recording,
    number: usize,
    spans: &[Span],
    options: &FitOptions<'_>,
) -> Result<Option<Record>> {
    let inputs = model.inputs.iter().map(|i| ("input", &i.name));
    for (what, name) in inputs.chain(model.outputs.iter().map(|o| ("output", &o.name))) {
        recording.channel(name).map_err(|e| e.about(&format!("{what} {name}")))?;
    }
    let (Some(first), Some(last)) = (spans.first(), spans.last()) else { return Ok(None) };
    let window = Span::new(first.from, last.to);
    let used = |t: f64| spans.iter().any(|s| s.contains(t));
    let Ready { harness, tracks, start, constants, lost, lie, cautions } =
        ready(model, (recording, number), window, &used, options)?;
    if tracks.iter().all(|t| t.time.is_empty()) {
        return Ok(None);
    }
    let (mut values, free) = initials(model, recording, &tracks, (start, options.initials.get(number)));
    let reach = reach(model, recording, harness.as_ref(), (&values, &free));
    for (k, range) in free.iter().zip(&reach) {
        values[*k] = range.clamp(values[*k]);
    }
    Ok(Some(Record {
        name: recording.name.clone(),
        recording: number,
        start,
        harness,
        tracks,
        constants,
        initials: values,
        lost,
        lie,
        cautions,
        free_initials: free,
        reach,
    }))
}

/// Numbers of the parameters that the fit moves: free in the model and not known to every record.
pub fn free_parameters(model: &Model, records: &[Record]) -> Vec<usize> {
    (0..model.parameters.len())
        .filter(|k| model.parameters[*k].fit && !records.iter().all(|r| r.knows(*k)))
        .collect()
}

/// The ranges of all unknowns: those of the free parameters, then those of the initial states.
pub fn ranges(model: &Model, free: &[usize], records: &[Record]) -> Vec<Range> {
    free.iter()
        .map(|k| Range::of(&model.parameters[*k]))
        .chain(records.iter().flat_map(|r| r.reach.iter().copied()))
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
