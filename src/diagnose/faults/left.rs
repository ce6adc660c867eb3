//! What faults leave to compare: a recording or an output whose every sample is masked drops out.

use crate::diagnose::answer::Proof;
use crate::diagnose::{Diagnosis, Request};
use crate::model::{Model, Output};
use crate::record::{Recording, Span};

/// What is left to compare.
pub struct Left {
    /// The model with the outputs that are left; where none is, the model as given with nothing to fit.
    pub model: Model,
    /// Outputs that were taken out of the model, with their places.
    lost: Vec<(usize, Output)>,
    /// Whether there is anything to compare.
    pub is_any: bool,
}

impl Left {
    /// What masking leaves of a request, with the recordings, fitted and separate; those given where none
    /// is left.
    pub fn of(
        request: &Request<'_>,
        recordings: Vec<Recording>,
        separate: Vec<Recording>,
    ) -> (Self, Vec<Recording>, Vec<Recording>) {
        let model = request.model;
        let fitted = |r: &Recording| fitted(model, r, !request.separate.is_empty());
        let held = |r: &Recording| held(model, r);
        let (recordings, lost) = kept(model, request.recordings.iter().zip(recordings), &fitted);
        let (separate, _) = kept(model, request.separate.iter().zip(separate), &held);
        if recordings.is_empty() {
            return (Self::nothing(model), request.recordings.to_vec(), request.separate.to_vec());
        }
        let absent = |o: &Output| recordings.iter().all(|r| !has(r, &o.name, &fitted(r)));
        let mut left = Self { model: model.clone(), lost: Vec::new(), is_any: true };
        for (k, o) in model.outputs.iter().enumerate().filter(|(k, o)| lost[*k] && absent(o)) {
            left.lost.push((k, o.clone()));
        }
        left.model.outputs.retain(|o| left.lost.iter().all(|l| l.1.name != o.name));
        (left, recordings, separate)
    }

    fn nothing(model: &Model) -> Self {
        let mut model = model.clone();
        model.parameters.iter_mut().for_each(|p| p.fit = false);
        Self { model, lost: Vec::new(), is_any: false }
    }

    /// Puts outputs and free parameters back into what was found without them; there is no proof for what
    /// was not compared.
    pub fn restore(self, given: &Model, diagnosis: &mut Diagnosis) {
        let proof = &mut diagnosis.answer.proof;
        if !self.is_any {
            proof.clear();
            diagnosis.after.model = given.clone();
            proof.extend(given.outputs.iter().map(unproved));
        }
        for (place, output) in self.lost {
            proof.insert(place, unproved(&output));
            diagnosis.after.model.outputs.insert(place, output);
        }
    }
}

/// Recordings that have a sample left of some output, or never had one; and the outputs that lost all
/// their samples in some recording.
fn kept<'a>(
    model: &Model,
    pairs: impl Iterator<Item = (&'a Recording, Recording)>,
    spans: &dyn Fn(&Recording) -> Vec<Span>,
) -> (Vec<Recording>, Vec<bool>) {
    let mut lost = vec![false; model.outputs.len()];
    let mut all = Vec::new();
    for (given, masked) in pairs {
        let spans = spans(given);
        let emptied = |o: &Output| has(given, &o.name, &spans) && !has(&masked, &o.name, &spans);
        let own: Vec<bool> = model.outputs.iter().map(emptied).collect();
        lost.iter_mut().zip(&own).for_each(|(l, o)| *l |= o);
        let rest = model.outputs.iter().any(|o| has(&masked, &o.name, &spans));
        if rest || !own.contains(&true) {
            all.push(masked);
        }
    }
    (all, lost)
}

/// Whether a channel has a sample inside the spans.
fn has(recording: &Recording, name: &str, spans: &[Span]) -> bool {
    let inside = |t: f64| spans.iter().any(|s| s.contains(t));
    recording.find(name).is_some_and(|c| c.samples().any(|(t, _)| inside(t)))
}

/// What is fitted of a recording.
fn fitted(model: &Model, recording: &Recording, apart: bool) -> Vec<Span> {
    recording.spans_for(&names(model), apart).fit
}

/// What is held out of a separate recording.
fn held(model: &Model, recording: &Recording) -> Vec<Span> {
    let spans = recording.spans_for(&names(model), true);
    if spans.holdout.is_empty() { spans.fit } else { spans.holdout }
}

/// Channels that a model uses.
fn names(model: &Model) -> Vec<&str> {
    let inputs = model.inputs.iter().map(|i| i.name.as_str());
    inputs.chain(model.outputs.iter().map(|o| o.name.as_str())).collect()
}

fn unproved(output: &Output) -> Proof {
    Proof {
        output: output.name.clone(),
        unit: output.unit.of_differences().text().to_string(),
        metric: "rmse",
        mode: "free-run",
        fit_before: f64::NAN,
        fit_after: f64::NAN,
        holdout_before: f64::NAN,
        holdout_after: f64::NAN,
        improvement_low: f64::NAN,
        improvement_high: f64::NAN,
        noise_floor: f64::NAN,
    }
}
