//! Whether a recording begins at rest where the model says so.
//!
//! # Purpose
//! A state that the model starts `"steady"` while the recording begins in motion leaves a transient that no law explains:
//! parameters bend to it, and whatever moves the beginning is named.
//!
//! # Method
//! Such states are fitted at their beginning instead. That is kept where it is surely likelier, the price of the
//! beginnings paid, and told.
//!
//! # References
//! G. Schwarz, Ann. Statist. 6 (1978) 461 (the price).

use super::bench::Bench;
use super::measure::{Measure, SURELY, Scale};
use crate::estimate::fit::Effort;
use crate::estimate::{Fit, fit};
use crate::model::{Initial, Model};
use crate::record::Recording;
use crate::units::significant;

/// Steps of the fit.
const STEPS: usize = 60;

/// A model whose recordings do not begin at rest.
pub struct Moving {
    /// The model with its beginnings to be fitted.
    pub model: Model,
    /// The same, fitted.
    pub fit: Fit,
    /// What a reader should know.
    pub says: String,
}

/// A model whose states are fitted where a recording begins.
pub fn starting_anywhere(model: &Model) -> Model {
    let mut model = model.clone();
    model.states.iter_mut().for_each(|s| s.initial = Initial::Fit);
    model
}

/// The model with the beginnings fitted that it says to be steady, where the recordings surely begin otherwise.
pub fn moving(bench: &Bench, base: &Fit) -> Option<Moving> {
    let mut model = base.model.clone();
    let steady: Vec<usize> = steady(&model).collect();
    if steady.is_empty() || bench.is_trials() {
        return None;
    }
    for k in &steady {
        model.states[*k].initial = Initial::Fit;
    }
    let other = fit(&model, &bench.recordings, &bench.options(Effort::Near, STEPS)).ok()?;
    let scale = Scale::of(base, false);
    let [before, after] = [base, &other].map(|fit| Measure::of(fit, &scale));
    // ½ ln n for each beginning
    let price = 0.5 * (steady.len() * bench.recordings.len()) as f64 * after.samples.max(1.0).ln();
    if after.likelihood - before.likelihood < price + SURELY {
        return None;
    }
    let says = says(&bench.recordings, &steady, &other);
    Some(Moving { model, fit: other, says })
}

/// The same for a fit alone: what a reader should know.
pub fn begins_in_motion(
    fit: &Fit,
    recordings: &[Recording],
    separate_holdout: bool,
    seed: u64,
) -> Option<String> {
    steady(&fit.model).next()?;
    let bench = Bench::new(&fit.model, recordings.to_vec(), separate_holdout, seed);
    moving(&bench, fit).map(|other| other.says)
}

/// Numbers of the states that a model starts where it rests.
fn steady(model: &Model) -> impl Iterator<Item = usize> {
    (0..model.states.len()).filter(|k| model.states[*k].initial == Initial::Steady)
}

fn says(recordings: &[Recording], steady: &[usize], fit: &Fit) -> String {
    let several = recordings.len() > 1;
    let states = steady.iter().map(|k| &fit.model.states[*k]);
    let begins = states.flat_map(|state| {
        fit.initials.iter().filter(|i| i.state == state.name).map(move |i| {
            let start = significant(state.unit.from_si(i.value), 4);
            let of = recordings.get(i.recording).filter(|_| several);
            let of = of.map_or_else(String::new, |r| format!(" in '{}'", r.name));
            format!("{} at {start} {}{of}", state.name, state.unit)
        })
    });
    let begins: Vec<String> = begins.collect();
    let whose = if several { "not every recording begins" } else { "the recording does not begin" };
    format!(
        "{whose} at rest, as `initial = \"steady\"` says: it begins with {}; write `initial = \"fit\"`",
        begins.join(", ")
    )
}
