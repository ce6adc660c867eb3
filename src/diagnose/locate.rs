//! Where the mismatch sits: in time, in frequency, and with which signals it goes.

use super::answer::{Band, Spell};
use super::bench::Bench;
use super::prove::Held;
use crate::estimate::Fit;
use crate::estimate::fit::{Combination, RecordFit, Series};
use crate::model::Model;
use crate::record::{Recording, Span};
use realfft::RealFftPlanner;

/// Windows of time that are compared.
const WINDOWS: usize = 24;
/// Times the usual square of a window from which on its mismatch is large.
const LARGE: f64 = 4.0;
/// Bands of frequency.
const BANDS: usize = 8;

/// Angular frequencies of the lines of the residual's spectrum, rad/s, strongest first.
pub fn peaks(fit: &Fit) -> Vec<f64> {
    let mut found: Vec<(f64, f64)> = Vec::new();
    for series in fit.records.iter().take(1).flat_map(|r| &r.series) {
        let Some(longest) = series.stretches.iter().max_by_key(|r| r.len()) else { continue };
        if longest.len() < 64 {
            continue;
        }
        let step = (series.time[longest.end - 1] - series.time[longest.start]) / (longest.len() - 1) as f64;
        let power = spectrum(&series.residual[longest.clone()]);
        let width = (power.len() / 50).max(8);
        // the level about a line hardly changes over an eighth of the window that it is taken from
        let stride = (width / 8).max(1);
        let mut level = (usize::MAX, 0.0);
        for k in 2..power.len().saturating_sub(2) {
            if k / stride != level.0 {
                let middle = k / stride * stride + stride / 2;
                let window = middle.saturating_sub(width)..(middle + width).min(power.len());
                level = (k / stride, median(power[window].to_vec()));
            }
            let top = power[k] >= power[k - 1] && power[k] >= power[k + 1];
            if top && power[k] > 12.0 * level.1 {
                let w = std::f64::consts::TAU * k as f64 / (2.0 * power.len() as f64 * step);
                found.push((power[k] / level.1, w));
            }
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found.into_iter().take(4).map(|f| f.1).collect()
}

/// Periodogram with a Hann window, padded to a power of two.
pub fn spectrum(values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let mean = values.iter().sum::<f64>() / n.max(1) as f64;
    let size = n.next_power_of_two().max(4);
    let mut padded = vec![0.0; size];
    for (i, v) in values.iter().enumerate() {
        let hann = 0.5 - 0.5 * (std::f64::consts::TAU * (i as f64 + 0.5) / n as f64).cos();
        padded[i] = hann * (v - mean);
    }
    powers(padded)
}

/// Squares of a Fourier transform at the first half of its frequencies.
pub fn powers(mut values: Vec<f64>) -> Vec<f64> {
    let size = values.len();
    let fft = RealFftPlanner::<f64>::new().plan_fft_forward(size);
    let mut out = fft.make_output_vec();
    if fft.process(&mut values, &mut out).is_err() {
        return Vec::new();
    }
    out.iter().take(size / 2).map(num_complex::Complex::norm_sqr).collect()
}

/// Windows of each fitted record in which the mismatch of an output is large against the rest, those of
/// all outputs together.
pub fn times(fit: &Fit) -> Vec<Spell> {
    let several = fit.records.len() > 1;
    let of = |r: &RecordFit| {
        let recording = several.then(|| r.name.clone());
        let spans = merged(r.series.iter().flat_map(large).collect());
        spans.into_iter().map(move |s| Spell { from: s.from, to: s.to, recording: recording.clone() })
    };
    fit.records.iter().flat_map(of).collect()
}

/// Windows in which the residual of a series is large, each up to where the next begins.
fn large(series: &Series) -> Vec<Span> {
    let n = series.residual.len();
    let size = n.div_ceil(WINDOWS).max(1);
    let squares: Vec<f64> = series.residual.chunks(size).map(|e| e.iter().map(|e| e * e).sum()).collect();
    let usual = median(squares.clone());
    let steps: Vec<f64> = series.time.windows(2).map(|w| w[1] - w[0]).collect();
    let step = 2.0 * median(steps);
    let window = |k: usize| {
        let next = series.time.get((k + 1) * size).copied();
        let last = series.time[((k + 1) * size).min(n) - 1];
        // Over a gap nothing is known.
        let to = next.filter(|t| t - last <= step).unwrap_or(last);
        long_enough(Span::new(series.time[k * size], to), &series.time)
    };
    (0..squares.len()).filter(|k| squares[*k] > LARGE * usual).filter_map(window).collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    let middle = values.len() / 2;
    if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// A span of some samples; that of a single one reaches half-way to its neighbours, as far as the next step
/// on its other side at most, and there is none where it has no neighbour.
pub fn long_enough(span: Span, time: &[f64]) -> Option<Span> {
    if span.from < span.to {
        return Some(span);
    }
    let at = time.partition_point(|t| *t < span.from);
    let before = at.checked_sub(1).map(|k| span.from - time[k]);
    let after = time.get(at + 1).map(|t| t - span.from);
    let reach = 0.5 * before.into_iter().chain(after).filter(|d| *d > 0.0).reduce(f64::min)?;
    let reaches = |side: Option<f64>| if side.is_some() { reach } else { 0.0 };
    Some(Span::new(span.from - reaches(before), span.from + reaches(after)))
}

/// Spans in order, those that touch made one.
pub fn merged(mut spans: Vec<Span>) -> Vec<Span> {
    spans.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut all: Vec<Span> = Vec::new();
    for s in spans {
        match all.last_mut() {
            Some(last) if s.from <= last.to => last.to = last.to.max(s.to),
            _ => all.push(s),
        }
    }
    all
}

/// The output whose mismatch stands out most: by what the findings take away, or else by how much more
/// than its innovations the model leaves.
pub fn plainest(before: &Fit, after: &Fit) -> usize {
    let fallen = before.rmse != after.rmse;
    let of = |k: &usize| {
        let left = if fallen {
            after.rmse[*k]
        } else {
            before.noise[*k].autoregression.innovation_variance().sqrt()
        };
        before.rmse[*k] / left
    };
    let best = |a: usize, b: usize| if of(&b) > of(&a) { b } else { a };
    (0..before.rmse.len()).reduce(best).unwrap_or(0)
}

/// Bands that hold most of the mismatch of an output: of what the findings take out of the residual of the
/// first recording, or, where there are none, of all that the model leaves.
pub fn bands(before: &Fit, after: &Fit, output: usize) -> Vec<Band> {
    let series = |fit: &'_ Fit| fit.records.first()?.series.iter().find(|s| s.output == output).cloned();
    let (Some(series), Some(later)) = (series(before), series(after)) else { return Vec::new() };
    let Some(longest) = series.stretches.iter().max_by_key(|r| r.len()).filter(|r| r.len() > 64) else {
        return Vec::new();
    };
    let step = (series.time[longest.end - 1] - series.time[longest.start]) / (longest.len() - 1) as f64;
    let mut power = spectrum(&series.residual[longest.clone()]);
    if later.residual.len() == series.residual.len() && later.residual != series.residual {
        let left = spectrum(&later.residual[longest.clone()]);
        power.iter_mut().zip(left).for_each(|(p, l)| *p = (*p - l).max(0.0));
    }
    let total: f64 = power.iter().sum();
    let unit = std::f64::consts::PI / (power.len() as f64 * step);
    let edge = |i: usize| ((power.len() as f64).powf(i as f64 / BANDS as f64)) as usize;
    let mut found = Vec::new();
    for i in 0..BANDS {
        let (from, to) = (if i == 0 { 0 } else { edge(i) }, edge(i + 1).min(power.len()));
        let share = power[from.min(to)..to].iter().sum::<f64>() / total;
        if share > 0.1 {
            found.push(Band { from: from as f64 * unit, to: to as f64 * unit, share });
        }
    }
    found
}

/// Parameters of the model that the fitted part does not show apart, if any.
pub fn unseen(model: &Model, base: &Fit) -> Option<String> {
    let is_parameter = |name: &str| model.parameters.iter().any(|p| p.name == *name);
    let hidden =
        base.unseen.iter().find(|d| d.weights.iter().all(|w| is_parameter(&w.0)) && !d.deviation.is_finite());
    let names: Vec<&str> = hidden?.weights.iter().map(|w| w.0.as_str()).collect();
    let told: Vec<String> = base.determined.iter().map(Combination::words).collect();
    let instead = if told.is_empty() { String::new() } else { format!(", only {}", told.join(" and ")) };
    Some(format!("the recording does not show {} apart{instead}", names.join(" and ")))
}

/// Share of an output's spread that a model must leave for it to say nothing of the output.
const NOTHING: f64 = 0.99;

/// What makes a recording too poor to tell anything: an output that never moves.
pub fn poor(model: &Model, bench: &Bench) -> Option<String> {
    let still = model.outputs.iter().find(|o| {
        let sizes = bench.recordings.iter().filter_map(|r| r.find(&o.name)).flat_map(|c| c.values.iter());
        let size = sizes.filter(|v| v.is_finite()).fold(0.0, |a: f64, v| a.max(v.abs()));
        bench.spread(&o.name) <= 1e-12 * size
    });
    still.map(|o| format!("{} never moves in it", o.name))
}

/// An output of which the fitted model says nothing at all.
pub fn mute(model: &Model, bench: &Bench, base: &Fit) -> Option<String> {
    let mut pairs = model.outputs.iter().zip(&base.rmse);
    let (o, _) = pairs.find(|(o, r)| **r > NOTHING * bench.spread(&o.name))?;
    Some(format!(
        "the fitted model says nothing of {}: start its parameters nearer to the instrument's",
        o.name
    ))
}

/// Held-out error over the fitted one from which on a fit does not carry over.
const ASTRAY: f64 = 5.0;

/// A fit that nothing was added to and that fails on what was held out.
pub fn astray(base: &Fit, held: &[Held]) -> Option<String> {
    if held.iter().any(|h| !h.is_finite()) {
        return Some("the fitted model does not stay finite over what was held out".to_string());
    }
    let fails = held.iter().zip(&base.rmse).any(|(h, r)| h.rmse() > ASTRAY * r);
    fails.then(|| {
        "the fitted part is explained, but what was held out is not: it is too short, or something acts that it does not show".to_string()
    })
}

/// An input with no more than two levels in the fitted part and others in the held-out part, where the
/// model with all that was found fails: any law of that input fits alike.
pub fn starved(
    model: &Model,
    bench: &Bench,
    last: &Fit,
    separate: &[Recording],
    held: &[Held],
) -> Option<String> {
    let fails = held.iter().zip(&last.rmse).any(|(h, r)| h.rmse() > 2.0 * r);
    let input = model.inputs.iter().find(|i| few_levels(&i.name, model, bench, separate))?;
    fails.then(|| {
        format!(
            "{} has only two levels in the fitted part, so that any law of it fits alike there, while the model fails at the levels held out",
            input.meaning.as_ref().unwrap_or(&input.name)
        )
    })
}

/// Whether an input has at most two levels where it is fitted, and others where it is held out.
fn few_levels(name: &str, model: &Model, bench: &Bench, separate: &[Recording]) -> bool {
    let mut fitted: Vec<f64> = Vec::new();
    let mut held: Vec<f64> =
        separate.iter().filter_map(|r| r.find(name)).flat_map(|c| c.values.clone()).collect();
    for (k, r) in bench.recordings.iter().enumerate() {
        let spans = bench.spans(model, k);
        let Some(c) = r.find(name) else { continue };
        for (t, v) in c.samples() {
            if spans.iter().any(|s| s.contains(t)) { fitted.push(v) } else { held.push(v) }
        }
    }
    let (fitted, held) = (levels(fitted), levels(held));
    let (low, high) = (fitted.first().copied().unwrap_or(0.0), fitted.last().copied().unwrap_or(0.0));
    let reach = 0.02 * (high - low);
    let new = held.iter().any(|v| fitted.iter().all(|f| (f - v).abs() > reach));
    fitted.len() == 2 && new
}

/// The values that a signal rests at: those of more than a few samples, in rising order.
fn levels(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_unstable_by(f64::total_cmp);
    let few = (values.len() / 100).max(1);
    let alike = |a: &f64, b: &f64| (a - b).abs() <= 1e-6 * b.abs().max(1e-12);
    values.chunk_by(alike).filter(|level| level.len() > few).map(|level| level[0]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretch_of_one_sample_has_a_length_where_it_has_a_neighbour() {
        let time = [0.0, 1.0, 2.0, 5.0];
        let of = |t: f64| long_enough(Span::new(t, t), &time);
        assert_eq!(of(1.0), Some(Span::new(0.5, 1.5)));
        assert_eq!(of(2.0), Some(Span::new(1.5, 2.5)));
        assert_eq!(of(0.0), Some(Span::new(0.0, 0.5)));
        assert_eq!(of(5.0), Some(Span::new(3.5, 5.0)));
        assert_eq!(long_enough(Span::new(0.0, 0.0), &[0.0]), None);
        assert_eq!(long_enough(Span::new(1.0, 3.0), &time), Some(Span::new(1.0, 3.0)));
    }

    /// Of ten samples the last is far off: its window is as long as from the middle before it.
    #[test]
    fn the_last_window_has_a_length() {
        let time: Vec<f64> = (0..10).map(f64::from).collect();
        let mut residual = vec![0.1; 10];
        residual[9] = 3.0;
        let series = Series { output: 0, time, residual, sensitivities: Vec::new(), stretches: Vec::new() };
        assert_eq!(large(&series), [Span::new(8.5, 9.0)]);
    }
}
