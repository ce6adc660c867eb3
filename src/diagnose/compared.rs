//! What is compared: cut once, for every model that is tried.
//!
//! # Purpose
//! Models are told apart by what they leave of the same samples. Which samples a model can predict depends
//! on the channels that it uses, on their gaps, and on how long it remembers a gap; none of this may differ
//! between a model and its rival, or the one that is asked less wins.
//!
//! # Method
//! The spans are those of the model as given. Samples of outputs that not every channel on offer covers are
//! made gaps; a channel that would cost more than a share of them is not on offer. What follows a gap of an
//! input is left out until the fitted model has forgotten the gap.

use super::bench::{Bench, Track};
use super::forgotten::{has_gaps, traces};
use crate::Result;
use crate::estimate::fit::{Effort, setup};
use crate::estimate::{Fit, fit};
use crate::model::{Input, Model};
use crate::record::{Channel, Kind, Recording, Span};
use crate::simulate::{Early, OutputSignal, coverage};

/// Share of the samples that all channels on offer together may cost.
const WORTH: f64 = 0.25;

/// Recordings of which every model on offer can predict the same samples.
pub struct Cut {
    /// Those that are fitted.
    pub fitted: Vec<Recording>,
    /// Those that are held out whole.
    pub separate: Vec<Recording>,
    /// What a reader should know.
    pub notes: Vec<String>,
}

/// Cuts recordings to what a model and every channel on offer cover; with whether separate ones are held out.
pub fn cut(model: &Model, fitted: &[Recording], (separate, separate_holdout): (&[Recording], bool)) -> Cut {
    let all: Vec<&Recording> = fitted.iter().chain(separate).collect();
    let (offered, refused) = offered(model, &all);
    let bare = |r: &Recording| {
        let mut r = r.clone();
        r.channels.retain(|c| !refused.contains(&c.name));
        r
    };
    let wider = with_inputs(model, &offered, &all);
    let cut = |r: &Recording, separate_holdout: bool| {
        let spanned = spanned(model, &offered, bare(r), separate_holdout);
        match coverage(&wider, &spanned) {
            Ok(outputs) => masked(spanned, &outputs).0,
            Err(_) => spanned,
        }
    };
    let name = |c: &String| {
        format!(
            "{c} is offered to no mechanism: it is missing in too much of what the model can be compared with"
        )
    };
    Cut {
        fitted: fitted.iter().map(|r| cut(r, separate_holdout)).collect(),
        separate: separate.iter().map(|r| cut(r, true)).collect(),
        notes: refused.iter().map(name).collect(),
    }
}

/// Names of channels beyond the model's own: those on offer, and those that would cost too much.
fn offered(model: &Model, all: &[&Recording]) -> (Vec<String>, Vec<String>) {
    let own = |c: &&Channel| {
        model.inputs.iter().any(|i| i.name == c.name) || model.outputs.iter().any(|o| o.name == c.name)
    };
    let first = all.first().map_or(&[][..], |r| &r.channels);
    let others: Vec<String> = first.iter().filter(|c| !own(c)).map(|c| c.name.clone()).collect();
    let whole = covered(model, &[], all).unwrap_or(0) as f64;
    let share = |names: &[String]| covered(model, names, all).map_or(0.0, |n| n as f64 / whole);
    let mut alone: Vec<(f64, String)> =
        others.into_iter().map(|c| (share(std::slice::from_ref(&c)), c)).collect();
    alone.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (mut kept, mut refused) = (Vec::new(), Vec::new());
    for (_, name) in alone {
        kept.push(name);
        if share(&kept) < 1.0 - WORTH {
            refused.extend(kept.pop());
        }
    }
    (kept, refused)
}

/// Samples of the outputs that are covered with further channels as inputs; none where one is missing.
fn covered(model: &Model, names: &[String], all: &[&Recording]) -> Option<usize> {
    let wider = with_inputs(model, names, all);
    let count = |o: &OutputSignal| {
        o.measured.iter().zip(&o.covered).filter(|(y, covered)| y.is_finite() && **covered).count()
    };
    all.iter().map(|r| Some(coverage(&wider, r).ok()?.iter().map(count).sum::<usize>())).sum()
}

/// The model with further channels as inputs, which nothing in it uses.
fn with_inputs(model: &Model, names: &[String], all: &[&Recording]) -> Model {
    let mut wider = model.clone();
    let found = names.iter().filter_map(|n| all.iter().find_map(|r| r.find(n)));
    let input = |c: &Channel| Input { name: c.name.clone(), unit: c.unit.clone(), meaning: None };
    wider.inputs.extend(found.map(input));
    wider
}

/// A recording with the spans of a model as given, inside the time of all channels on offer.
fn spanned(model: &Model, offered: &[String], recording: Recording, separate_holdout: bool) -> Recording {
    if recording.kind == Kind::Trials {
        return recording;
    }
    let options = crate::estimate::FitOptions { separate_holdout, ..Default::default() };
    let spans = setup::spans(model, &recording, &options);
    if spans.fit.is_empty() && spans.holdout.is_empty() {
        return recording;
    }
    let known = |c: &Channel| {
        let mut times = c.samples().map(|s| s.0);
        let first = times.next()?;
        Some(Span::new(first, times.last().unwrap_or(first)))
    };
    let channels = offered.iter().filter_map(|n| recording.find(n)).filter_map(known);
    let shared = channels.fold(Span::new(f64::NEG_INFINITY, f64::INFINITY), |a, b| {
        Span::new(a.from.max(b.from), a.to.min(b.to))
    });
    let inside = |all: &[Span]| all.iter().filter_map(|s| s.overlap(&shared)).collect::<Vec<Span>>();
    let (fit, holdout) = (inside(&spans.fit), inside(&spans.holdout));
    if fit.is_empty() {
        recording.with_spans(spans.fit, spans.holdout)
    } else {
        recording.with_spans(fit, holdout)
    }
}

/// A recording with the samples that are not covered made gaps, and how many they are.
fn masked(mut recording: Recording, outputs: &[OutputSignal]) -> (Recording, usize) {
    let mut lost = 0;
    for o in outputs {
        for c in recording.channels.iter_mut().filter(|c| c.name == o.name) {
            for (y, _) in c.values.iter_mut().zip(&o.covered).filter(|(y, known)| y.is_finite() && !**known) {
                *y = f64::NAN;
                lost += 1;
            }
        }
    }
    (recording, lost)
}

/// Rounds in which a fit and what it forgets are settled.
const ROUNDS: usize = 3;

/// Leaves out for good what follows a gap of an input until a fitted model has forgotten it, and fits the
/// model anew where that changes what is compared. The first fit was led astray by what follows the gap, so
/// that what is left out is found again from the next. Also gives notes, and whether so much is left out
/// that the question stays open.
///
/// # Errors
/// Where the model cannot be fitted to what is left.
pub fn settle(bench: &mut Bench, separate: &mut [Recording], base: Fit) -> Result<(Fit, Vec<String>, bool)> {
    let (fitted, apart) = (bench.recordings.clone(), separate.to_vec());
    bench.waits = false;
    let mut all = fitted.iter().chain(&apart);
    if !all.any(|r| r.kind != Kind::Trials && has_gaps(&base.model, r)) {
        return Ok((base, Vec::new(), false));
    }
    let (mut base, mut before) = (base, Vec::new());
    for _ in 0..ROUNDS {
        let starts = base.starts();
        let cut = |(k, r): (usize, &Recording)| settled(bench, &base.model, r, starts.get(k));
        let own: Vec<(Recording, usize)> = fitted.iter().enumerate().map(cut).collect();
        let far = |r: &Recording| settled(bench, &base.model, r, None);
        let others: Vec<(Recording, usize)> = apart.iter().map(far).collect();
        let lost: Vec<usize> = own.iter().chain(&others).map(|c| c.1).collect();
        bench.recordings = own.into_iter().map(|c| c.0).collect();
        separate.iter_mut().zip(others).for_each(|(r, c)| *r = c.0);
        base = anew(bench, &base)?;
        if lost == before {
            break;
        }
        before = lost;
    }
    let names = fitted.iter().chain(&apart).map(|r| &r.name);
    let notes = names.zip(&before).filter(|(_, lost)| **lost > 0).map(|(name, lost)| {
        format!(
            "{lost} samples of '{name}' are not compared: what an input was in its gap before them still shows there. Give the parts before and after the gap as two files: each then has a start of its own"
        )
    });
    let samples = |all: &[Recording]| {
        let outputs = all.iter().flat_map(|r| base.model.outputs.iter().filter_map(|o| r.find(&o.name)));
        outputs.map(|c| c.samples().count()).sum::<usize>()
    };
    let is_open = before.iter().sum::<usize>() as f64 > LITTLE * (samples(&fitted) + samples(&apart)) as f64;
    Ok((base, notes.collect(), is_open))
}

/// Share of the samples without which the question stays open.
const LITTLE: f64 = 0.5;

/// A recording without the samples at which a fitted model has not forgotten a gap of an input, and how many
/// they are.
fn settled(
    bench: &Bench,
    model: &Model,
    recording: &Recording,
    starts: Option<&Vec<f64>>,
) -> (Recording, usize) {
    let options = crate::estimate::FitOptions {
        separate_holdout: bench.separate || starts.is_none(),
        ..Default::default()
    };
    let spans = setup::spans(model, recording, &options);
    let from = |spans: &[Span]| spans.first().map_or(f64::INFINITY, |s| s.from);
    let first = from(&spans.fit).min(from(&spans.holdout));
    let first = if first.is_finite() { first } else { f64::NEG_INFINITY };
    let starts = starts.filter(|s| s.len() == model.states.len() && first == from(&spans.fit));
    let initials = starts.cloned().unwrap_or_else(|| vec![f64::NAN; model.states.len()]);
    let mut recording = recording.clone();
    let mut lost = 0;
    if recording.kind == Kind::Trials {
        return (recording, 0);
    }
    let traces = traces(bench, model, &recording, &initials, first);
    for (output, from, to) in traces.unwrap_or_default() {
        let name = &model.outputs[output].name;
        for c in recording.channels.iter_mut().filter(|c| c.name == *name) {
            let after =
                c.time.iter().zip(&mut c.values).filter(|(t, y)| **t > from && **t <= to && y.is_finite());
            for (_, y) in after {
                *y = f64::NAN;
                lost += 1;
            }
        }
    }
    (recording, lost)
}

/// A fit from where another ended; ended early where the other was, which may have led elsewhere.
///
/// # Errors
/// Where the model cannot be fitted at all.
pub fn anew(bench: &Bench, from: &Fit) -> Result<Fit> {
    let fitted = patiently(bench, || {
        let steps = if bench.budget.cut() == Some(Early::Time) { 0 } else { 30 };
        let mut options = bench.options(Effort::Near, steps);
        options.initials = from.starts();
        fit(&from.model, &bench.recordings, &options)
    })?;
    Ok(Fit { ended_early: fitted.ended_early.or(from.ended_early), ..fitted })
}

/// What an answer cannot do without, once more without a limit where the time was up.
///
/// # Errors
/// Where it cannot be computed for another reason.
pub fn patiently<T>(bench: &Bench, compute: impl Fn() -> Result<T>) -> Result<T> {
    compute().or_else(|e| {
        if bench.budget.over() != Some(Early::Time) {
            return Err(e);
        }
        bench.budget.lift_time();
        compute()
    })
}

/// Whether two fits compare the same samples.
pub fn same_samples(a: &Fit, b: &Fit) -> bool {
    let times = |f: &Fit| f.records.iter().flat_map(|r| &r.series).map(|s| s.time.len()).collect::<Vec<_>>();
    times(a) == times(b)
}

/// Whether something runs sample by sample beside other tracks, stretch by stretch.
pub fn same_tracks(a: &[Track], b: &[Track]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.output == b.output && a.stretches == b.stretches)
}
