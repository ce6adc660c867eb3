//! Fit and proof in each other's place, once, where the later part shows what the earlier does not.

use super::answer::{Answer, Finding, Verdict};
use super::at_rest::starting_anywhere;
use super::prove::Held;
use super::{Diagnosis, Request, locate};
use crate::estimate::Fit;
use crate::estimate::fit::{FitOptions, setup};
use crate::estimate::noise::NoiseModel;
use crate::model::Model;
use crate::record::{Kind, Recording, Spans};

/// The recordings with what was held out to be fitted and what was fitted to be held out, and the model that starts anywhere,
/// where a diagnosis asks for that: its fitted part is explained, by what was found or with nothing added, what was held out
/// is not, and nobody chose the spans.
pub fn asked(request: &Request<'_>, first: &Diagnosis) -> Option<(Model, Vec<Recording>)> {
    let answer = &first.answer;
    let is_bare = answer.findings.is_empty();
    let fails = match answer.verdict {
        Verdict::NotIdentifiable => is_bare && locate::astray(&first.before, &first.held.1).is_some(),
        Verdict::NothingMissing => is_bare && is_more(&first.before, &first.held.1),
        Verdict::Named | Verdict::Tie | Verdict::Unknown => {
            answer.unexplained.is_none() && locate::astray(&first.after, &first.held.1).is_some()
        }
        Verdict::DataFault => false,
    };
    let of_default = |r: &Recording| !r.spans.given && r.kind != Kind::Trials;
    let ours = request.separate.is_empty() && request.recordings.iter().all(of_default);
    let is_asked = fails && ours && answer.made.ended_early.is_none();
    let recordings = || request.recordings.iter().map(|r| exchanged(request.model, r)).collect();
    is_asked.then(|| (starting_anywhere(request.model), recordings()))
}

/// Times the innovations of the fit from which on what is held out holds more than noise.
const MORE: f64 = 1.3;
/// Samples held out that tell.
const ENOUGH: usize = 50;

/// Whether an output leaves more than noise where it was held out: a step of the noise foretold by its past is none.
fn is_more(fit: &Fit, held: &[Held]) -> bool {
    let exceeds = |(h, n): (&Held, &NoiseModel)| {
        let innovations = h.whitened(n);
        innovations.samples() >= ENOUGH && innovations.rmse() > MORE
    };
    held.iter().zip(&fit.noise).any(exceeds)
}

/// A recording whose default spans have changed places.
fn exchanged(model: &Model, recording: &Recording) -> Recording {
    let Spans { fit, holdout, .. } = setup::spans(model, recording, &FitOptions::default());
    Recording { spans: Spans { fit: holdout, holdout: fit, given: true }, ..recording.clone() }
}

/// What the later part names, where the earlier proves it, and all that was named before is among it.
pub fn proven(first: &Answer, mut second: Diagnosis) -> Option<Diagnosis> {
    let codes = |f: &Finding| [&[f.code.clone()][..], &f.ties].concat();
    let found: Vec<String> = second.answer.findings.iter().flat_map(codes).collect();
    let is_kept = |f: &Finding| codes(f).iter().any(|c| found.contains(c));
    let keeps = !first.verdict.has_names() || first.findings.iter().all(is_kept);
    (second.answer.verdict.has_names() && keeps).then(|| {
        second.answer.notes.insert(0, EXCHANGED.into());
        second
    })
}

/// That the parts have changed places.
const EXCHANGED: &str = "fit and proof have changed places: the earlier part alone is explained while the later one is not, so that the later part was fitted and the earlier one held out for the proof; states start where the parts show them, whatever `initial` says";
