//! Laws from a moment on, in a recording that was held out apart.
//!
//! # Purpose
//! A part that broke at noon stays broken in the recording of the evening, whose clock begins anew; in that of the morning it
//! was whole. The moment itself has no place in either.
//!
//! # Method
//! What was held out is run three times: after all such moments, before them, and with the moments at the same times in it,
//! as of what is switched so long after each start. What leaves least is taken, and told.

use super::bench::Bench;
use crate::estimate::Fit;
use crate::estimate::fit::{Effort, HeldOut, holdout};
use crate::model::Model;
use crate::record::Recording;
use std::borrow::Cow;

/// A time far from all of a recording, s.
const FAR: f64 = 1e12;

/// Where the moments may be put in a recording that begins anew, and what that means.
const PLACES: [(Option<f64>, &str); 3] =
    [(None, "with the same"), (Some(-FAR), "as after"), (Some(FAR), "as before")];

/// Numbers of the parameters beyond the given ones that are moments from which on something acts.
fn moments(bench: &Bench, model: &Model) -> Vec<usize> {
    let definitions = model.definitions.iter().map(|d| &d.equals);
    let rates = model.states.iter().map(|s| &s.rate);
    let all = definitions.chain(rates).chain(model.outputs.iter().map(|o| &o.equals));
    let text: Vec<String> = all.map(ToString::to_string).collect();
    let is_moment = |k: &usize| {
        let from_then_on = format!("step(t - {})", model.parameters[*k].name);
        text.iter().any(|e| e.contains(&from_then_on))
    };
    (bench.own_parameters..model.parameters.len()).filter(is_moment).collect()
}

/// Whether a model has such moments.
pub fn has_any(bench: &Bench, model: &Model) -> bool {
    !moments(bench, model).is_empty()
}

/// A fit with its moments where they leave least of recordings that were held out apart.
pub fn placed<'f>(bench: &Bench, fit: &'f Fit, separate: &[Recording]) -> Cow<'f, Fit> {
    nearest(bench, fit, separate).map_or(Cow::Borrowed(fit), |(_, moved)| Cow::Owned(moved))
}

/// The fit with its moments at the nearest place, and what that means; none where it has no moments or nothing is apart.
fn nearest(bench: &Bench, fit: &Fit, separate: &[Recording]) -> Option<(&'static str, Fit)> {
    let numbers = moments(bench, &fit.model);
    if numbers.is_empty() || separate.is_empty() {
        return None;
    }
    let options = bench.options(Effort::Near, 40);
    let of = |(place, words): (Option<f64>, &'static str)| {
        let mut moved = fit.clone();
        for k in &numbers {
            let value = &mut moved.model.parameters[*k].value;
            *value = place.unwrap_or(*value);
        }
        let left = holdout(&moved, &[], separate, &options).map_or(f64::INFINITY, |left| size(&left));
        (left, words, moved)
    };
    let best = PLACES.map(of).into_iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((best.1, best.2))
}

/// Σ ln of the errors of the outputs; endless where a run has not stayed finite.
fn size(left: &[HeldOut]) -> f64 {
    let all = left.iter().map(|h| h.rmse.ln()).sum::<f64>();
    if all.is_nan() { f64::INFINITY } else { all }
}

/// How what was held out apart lies to the moments of a fit, where it has such.
pub fn note(bench: &Bench, fit: &Fit, separate: &[Recording]) -> Option<String> {
    let (words, _) = nearest(bench, fit, separate)?;
    let numbers = moments(bench, &fit.model);
    let names: Vec<&str> = numbers.iter().map(|k| fit.model.parameters[*k].name.as_str()).collect();
    Some(format!("what was held out begins anew and is run {words} {}: so it fits best", names.join(" and ")))
}
