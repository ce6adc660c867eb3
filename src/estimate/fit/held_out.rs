//! The fitted model on what was held out.

use super::assemble::root_mean_square;
use super::begins::begins;
use super::harness::{Record, Track};
use super::options::FitOptions;
use super::outcome::{Fit, HeldOut, Series};
use super::setup;
use crate::Result;
use crate::model::Model;
use crate::record::{Recording, Span};
use crate::simulate::Unknown;

/// All held-out series of a fit: spans that follow a fitted span run on from it, the others have their
/// free initial states fitted. What runs on has its sensitivities to the fit's unknowns, where they are wanted.
pub fn held_out(
    fit: &Fit,
    recordings: &[Recording],
    separate: &[Recording],
    (options, sensitive): (&FitOptions<'_>, bool),
) -> Result<Vec<HeldOut>> {
    let options = &FitOptions { tolerance: fit.tolerance.min(options.tolerance), ..options.clone() };
    let mut series = Vec::new();
    for (number, recording) in recordings.iter().enumerate() {
        let spans = setup::spans(&fit.model, recording, options);
        let first = spans.fit.first().map_or(f64::INFINITY, |s| s.from);
        let (follows, apart): (Vec<Span>, Vec<Span>) = spans.holdout.iter().partition(|s| s.from >= first);
        if !follows.is_empty() {
            let mut together: Vec<Span> = spans.fit.iter().chain(&follows).copied().collect();
            together.sort_by(|a, b| a.from.total_cmp(&b.from));
            let Some(record) = setup::record_if_any(&fit.model, recording, number, &together, options)?
            else {
                continue;
            };
            let initials = fit.records.get(number).map_or(record.initials.clone(), |r| r.initials.clone());
            let unknowns = if sensitive { unknowns(fit, &record, number) } else { Vec::new() };
            let wanted = (&unknowns[..], fit.unknowns.len());
            series.extend(of(number, run(&fit.model, &record, &initials, wanted, &|t| spans.holds_out(t))?));
        }
        for span in apart {
            series.extend(of(number, alone(&fit.model, recording, number, &[span], options)?));
        }
    }
    for (k, recording) in separate.iter().enumerate() {
        let whole =
            setup::spans(&fit.model, recording, &FitOptions { separate_holdout: true, ..options.clone() });
        let spans = if whole.holdout.is_empty() { whole.fit } else { whole.holdout };
        let own = alone(&fit.model, recording, recordings.len(), &spans, options)?;
        series.extend(of(recordings.len() + k, own));
    }
    Ok(pooled(&fit.model, &series))
}

/// Series with the number of their recording.
fn of(recording: usize, series: Vec<Series>) -> impl Iterator<Item = (usize, Series)> {
    series.into_iter().map(move |s| (recording, s))
}

/// A record of its own: its free initial states are fitted, nothing else. No series where no sample is left.
fn alone(
    model: &Model,
    recording: &Recording,
    number: usize,
    spans: &[Span],
    options: &FitOptions<'_>,
) -> Result<Vec<Series>> {
    let Some((model, record, initials)) = begins(model, recording, (number, spans), options)? else {
        return Ok(Vec::new());
    };
    run(&model, &record, &initials, (&[], 0), &|_| true)
}

/// The unknowns of a fit that the run of a recording depends on, with their places among all.
fn unknowns(fit: &Fit, record: &Record, number: usize) -> Vec<(Unknown, usize)> {
    let shared =
        setup::free_parameters(&fit.model, std::slice::from_ref(record)).into_iter().filter_map(|k| {
            let place = fit.unknowns.iter().position(|n| *n == fit.model.parameters[k].name)?;
            Some((Unknown::Parameter(k), place))
        });
    let first = fit.unknowns.len() - fit.initials.len();
    let own = fit.initials.iter().enumerate().filter(|(_, i)| i.recording == number).filter_map(|(at, i)| {
        let state = fit.model.states.iter().position(|s| s.name == i.state)?;
        Some((Unknown::Initial(state), first + at))
    });
    shared.chain(own).collect()
}

/// The residual series of one run at the times wanted, with its sensitivities to some unknowns at their places
/// among so many.
fn run(
    model: &Model,
    record: &Record,
    initials: &[f64],
    (unknowns, among): (&[(Unknown, usize)], usize),
    wanted: &dyn Fn(f64) -> bool,
) -> Result<Vec<Series>> {
    let parameters: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let each: Vec<Unknown> = unknowns.iter().map(|u| u.0).collect();
    let run = record.run(&parameters, initials, &each)?;
    let of = |(k, track): (usize, &Track)| {
        let mut columns = vec![Vec::new(); if each.is_empty() { 0 } else { among }];
        for ((_, place), column) in unknowns.iter().zip(run.sensitivities.get(k).into_iter().flatten()) {
            columns[*place].clone_from(column);
        }
        part(track, &run.predictions[k], &columns, wanted)
    };
    Ok(record.tracks.iter().enumerate().map(of).collect())
}

/// The part of a track at the times wanted; an empty column is one of zeros.
fn part(track: &Track, predicted: &[f64], columns: &[Vec<f64>], wanted: &dyn Fn(f64) -> bool) -> Series {
    let residual = track.residual(predicted);
    let mut kept: Vec<usize> = Vec::new();
    let mut stretches = Vec::new();
    for stretch in &track.stretches {
        let mut from = kept.len();
        for i in stretch.clone() {
            if wanted(track.time[i]) {
                kept.push(i);
            } else if kept.len() > from {
                stretches.push(from..kept.len());
                from = kept.len();
            }
        }
        if kept.len() > from {
            stretches.push(from..kept.len());
        }
    }
    let of = |v: &[f64]| kept.iter().map(|i| v.get(*i).copied().unwrap_or(0.0)).collect();
    Series {
        output: track.output,
        time: of(&track.time),
        residual: of(&residual),
        sensitivities: columns.iter().map(|c| of(c)).collect(),
        stretches,
    }
}

fn pooled(model: &Model, series: &[(usize, Series)]) -> Vec<HeldOut> {
    (0..model.outputs.len())
        .map(|output| {
            let own = series.iter().filter(|s| s.1.output == output).cloned();
            let (recordings, series): (Vec<usize>, Vec<Series>) = own.unzip();
            HeldOut { output, rmse: root_mean_square(series.iter()), series, recordings }
        })
        .collect()
}
