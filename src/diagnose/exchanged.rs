//! Fit and proof in each other's place, once, where the later part shows what the earlier does not.

use super::answer::Verdict;
use super::{Diagnosis, Request, locate};
use crate::estimate::fit::{FitOptions, setup};
use crate::model::Model;
use crate::record::{Kind, Recording, Spans};

/// The recordings with what was held out to be fitted and what was fitted to be held out, where a diagnosis asks
/// for that: its fitted part is explained with nothing added, what was held out is not, and nobody chose the spans.
pub fn asked(request: &Request<'_>, first: &Diagnosis) -> Option<Vec<Recording>> {
    let answer = &first.answer;
    let is_blind = answer.verdict == Verdict::NotIdentifiable && answer.findings.is_empty();
    let of_default = |r: &Recording| !r.spans.given && r.kind != Kind::Trials;
    let ours = request.separate.is_empty() && request.recordings.iter().all(of_default);
    let is_asked = is_blind && ours && answer.made.ended_early.is_none();
    let is_asked = is_asked && locate::astray(&first.before, &first.held.1).is_some();
    is_asked.then(|| request.recordings.iter().map(|r| exchanged(request.model, r)).collect())
}

/// A recording whose default spans have changed places.
fn exchanged(model: &Model, recording: &Recording) -> Recording {
    let Spans { fit, holdout, .. } = setup::spans(model, recording, &FitOptions::default());
    Recording { spans: Spans { fit: holdout, holdout: fit, given: true }, ..recording.clone() }
}

/// What the later part names, where the earlier proves it.
pub fn proven(mut second: Diagnosis) -> Option<Diagnosis> {
    let is_named = matches!(second.answer.verdict, Verdict::Named | Verdict::Tie);
    is_named.then(|| {
        second.answer.notes.insert(0, EXCHANGED.into());
        second
    })
}

/// That the parts have changed places.
const EXCHANGED: &str = "fit and proof have changed places: the earlier part alone is explained without anything added, so that the later part was fitted and the earlier one held out for the proof";
