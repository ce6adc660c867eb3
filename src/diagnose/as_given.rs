//! The search from the values as given, where a fit that something large is missing from has run away from them.
//!
//! # Purpose
//! What acts as strongly as the input itself draws a free fit to where the model hardly answers anything: a ship whose
//! wind is not in the model becomes one of no rudder and hours of inertia. From there no law is near.
//!
//! # Method
//! Where a law is found or something surely left, and a fitted parameter is many times what was given even then, the search
//! begins once more with the model as given, not fitted. What it finds is taken where it is surely worth more.

use super::backward::{self, fitted_from};
use super::bench::Bench;
use super::choose::CHANCE;
use super::measure::Measure;
use super::search::{Found, is_over};
use super::walk::Bounds;
use super::{beside, walk};
use crate::estimate::fit::Progress;
use crate::model::Model;
use crate::record::Recording;

/// Times of what was given from which on a parameter has run away.
const FAR: f64 = 30.0;

/// What was found, or what is found from the values as given, where that is surely worth more.
pub fn instead(
    bench: &Bench,
    separate: &[Recording],
    first: Found,
    model: &Model,
    progress: &dyn Progress,
) -> Found {
    let is_missing = !first.taken.is_empty() || first.rest.p_value < CHANCE;
    if bench.is_trials() || !is_missing || !has_run_away(model, &first.last.model) {
        return first;
    }
    // steps that were spent far astray are no reason to stay there; time that is up is one
    let spent = bench.budget.cut();
    bench.budget.renew();
    let other = if is_over(bench) { None } else { beginning(bench, separate, &first, model, progress) };
    let other = other.filter(|o| o.is_surely_better(bench, &first));
    other.unwrap_or_else(|| {
        bench.budget.tell(spent);
        first
    })
}

/// What the search finds from the values as given, held against the fitted model.
fn beginning(
    bench: &Bench,
    separate: &[Recording],
    first: &Found,
    model: &Model,
    progress: &dyn Progress,
) -> Option<Found> {
    let given: Vec<f64> = model.parameters.iter().map(|p| p.value).collect();
    let bounds = Bounds { given: &given, avoids: None, is_over: &|_| false, may_begin_anew: false };
    let begun = fitted_from(bench, model, &first.base, 0)?;
    let mut found = walk::search(bench, separate, begun, &bounds, progress).ok()?;
    // what it is held against is the fitted model
    found.measures = (first.measures.0, Measure::of(&found.last, &first.scale));
    (found.base, found.scale) = (first.base.clone(), first.scale.clone());
    backward::stand(bench, separate, &mut found);
    beside::settle(bench, separate, &mut found, progress);
    (!found.taken.is_empty()).then_some(found)
}

/// Whether a fitted parameter is many times what was given.
fn has_run_away(given: &Model, fitted: &Model) -> bool {
    let is_far = |(given, fitted): (f64, f64)| given != 0.0 && fitted.abs() > FAR * given.abs();
    let both = given.parameters.iter().zip(&fitted.parameters).filter(|(p, _)| p.fit);
    both.map(|(g, f)| (g.value, f.value)).any(is_far)
}
