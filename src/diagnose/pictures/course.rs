//! Outputs over time: measured, and both models running freely.

use super::{Assembly, Close, Course, Point, closer, thinned};
use crate::Result;
use crate::diagnose::answer::Stretch;
use crate::diagnose::bench::Stand;
use crate::diagnose::moments;
use crate::estimate::fit::{Effort, Series, holdout, setup};
use crate::estimate::{Fit, fit_percent};
use crate::record::{Recording, Span};

/// Pictures at most.
const MOST: usize = 8;

/// The courses of all outputs on the first recordings and the first separate records.
pub fn courses(assembly: &Assembly<'_>) -> Vec<Course> {
    let mut all = Vec::new();
    for k in 0..assembly.bench.recordings.len().min(2) {
        all.extend(fitted(assembly, k).unwrap_or_default());
    }
    for recording in assembly.separate.iter().take(2) {
        all.extend(separate(assembly, recording).unwrap_or_default());
    }
    all.truncate(MOST);
    all
}

/// A fitted recording with the held-out spans that follow.
fn fitted(assembly: &Assembly<'_>, number: usize) -> Result<Vec<Course>> {
    let (bench, found) = (&assembly.bench, &assembly.found);
    let recording = &bench.recordings[number];
    let options = bench.options(Effort::Near, 0);
    let spans = setup::spans(&found.base.model, recording, &options);
    let first = spans.fit.first().map_or(f64::INFINITY, |s| s.from);
    let follows = || spans.holdout.iter().filter(|s| s.from >= first);
    let mut together: Vec<Span> = spans.fit.iter().chain(follows()).copied().collect();
    together.sort_by(|a, b| a.from.total_cmp(&b.from));
    let run = |fit: &Fit| -> Result<Vec<Series>> {
        let stand = Stand::of(fit);
        let record = setup::record(&fit.model, recording, number, &together, &options)?;
        let initials = stand.initials.get(number).unwrap_or(&record.initials);
        let run = record.run(&stand.parameters, initials, &[])?;
        let tracks = record.tracks.iter().zip(&run.predictions);
        let series = tracks.map(|(t, predicted)| Series {
            output: t.output,
            time: t.time.clone(),
            residual: t.residual(predicted),
            sensitivities: Vec::new(),
            stretches: t.stretches.clone(),
        });
        Ok(series.collect())
    };
    let held: Vec<Stretch> = follows().map(|s| Stretch { from: s.from, to: s.to }).collect();
    let (before, after) = rayon::join(|| run(&found.base), || run(&found.last));
    Ok(pair(assembly, recording, &held, (&before?, &after?)))
}

/// A record that is held out whole.
fn separate(assembly: &Assembly<'_>, recording: &Recording) -> Result<Vec<Course>> {
    let options = assembly.bench.options(Effort::Full, 40);
    let run = |fit: &Fit| -> Result<Vec<Series>> {
        let recording = std::slice::from_ref(recording);
        let held = holdout(&moments::placed(&assembly.bench, fit, recording), &[], recording, &options)?;
        Ok(held.into_iter().flat_map(|h| h.series).collect())
    };
    let (before, after) = rayon::join(|| run(&assembly.found.base), || run(&assembly.found.last));
    let (before, after) = (before?, after?);
    let range = recording.range().map(|s| Stretch { from: s.from, to: s.to });
    Ok(pair(assembly, recording, &range.into_iter().collect::<Vec<_>>(), (&before, &after)))
}

fn pair(
    assembly: &Assembly<'_>,
    recording: &Recording,
    held: &[Stretch],
    runs: (&[Series], &[Series]),
) -> Vec<Course> {
    let outputs = assembly.found.base.model.outputs.iter().enumerate();
    outputs
        .filter_map(|(k, o)| {
            let channel = recording.find(&o.name)?;
            let of = |runs: &[Series]| -> Vec<(f64, f64)> {
                runs.iter().filter(|s| s.output == k).flat_map(parted).collect()
            };
            let (before, after) = (of(runs.0), of(runs.1));
            let unit = o.unit.of_differences();
            let residual = |v: &[(f64, f64)]| -> Vec<Point> {
                v.iter().map(|(t, e)| [*t, unit.difference_from_si(*e)]).collect()
            };
            let predicted = |v: &[(f64, f64)]| -> Vec<Point> {
                v.iter().map(|(t, e)| [*t, o.unit.from_si(measured(channel, *t) - e)]).collect()
            };
            // a gap of the residual is one of the measurement
            let level: Vec<Point> =
                before.iter().map(|(t, e)| [*t, o.unit.from_si(measured(channel, *t)) + 0.0 * e]).collect();
            let percent = |v: &[(f64, f64)]| percent(v, held, channel);
            let (percent_before, percent_after) = (percent(&before), percent(&after));
            let (left, with) = (residual(&before), residual(&after));
            let (before, after) = (predicted(&before), predicted(&after));
            let close = closer::span(&left).map(|span| {
                let of = |points: &[Point]| thinned(closer::within(points, span).into_iter());
                Close { measured: of(&level), before: of(&before), after: of(&after) }
            });
            let whole = |points: Vec<Point>| thinned(points.into_iter());
            (!level.is_empty()).then(|| Course {
                output: o.name.clone(),
                unit: o.unit.text().to_string(),
                difference_unit: unit.text().to_string(),
                recording: recording.name.clone(),
                held: held.to_vec(),
                percent_before,
                percent_after,
                measured: whole(level),
                before: whole(before),
                after: whole(after),
                residual_before: whole(left),
                residual_after: whole(with),
                close,
            })
        })
        .collect()
}

/// How much of the measured movement is followed, %: on what was fitted and on what was held out.
fn percent(residual: &[(f64, f64)], held: &[Stretch], channel: &crate::record::Channel) -> [f64; 2] {
    let is_held = |t: f64| held.iter().any(|h| (h.from..=h.to).contains(&t));
    [false, true].map(|wanted| {
        let own = residual.iter().filter(|(t, _)| is_held(*t) == wanted);
        fit_percent(own.map(|(t, e)| [measured(channel, *t), *e]))
    })
}

/// Times and residuals, a NaN after each stretch.
fn parted(s: &Series) -> Vec<(f64, f64)> {
    let mut all = Vec::with_capacity(s.time.len() + s.stretches.len());
    for r in &s.stretches {
        all.extend(r.clone().map(|i| (s.time[i], s.residual[i])));
        all.extend(r.clone().next_back().map(|i| (s.time[i], f64::NAN)));
    }
    all
}

/// The sample that a channel has at one of its own times.
fn measured(channel: &crate::record::Channel, time: f64) -> f64 {
    let at = channel.time.partition_point(|t| *t < time);
    channel.values.get(at).copied().unwrap_or(f64::NAN)
}
