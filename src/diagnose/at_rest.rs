//! Whether a recording begins at rest where the model says so.
//!
//! # Purpose
//! A state that the model starts `"steady"` while the recording begins in motion leaves a transient that no law explains:
//! parameters bend to it, and whatever moves the beginning is named. So does a number that holds where a recording begins,
//! where what is fitted of it begins later.
//!
//! # Method
//! Such states are fitted at their beginning instead. That is kept where it is surely likelier, the price of the
//! beginnings paid, and told.
//!
//! # References
//! G. Schwarz, Ann. Statist. 6 (1978) 461 (the price).

use super::bench::Bench;
use super::measure::{Measure, SURELY, Scale};
use crate::estimate::fit::{Effort, setup};
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
    let is_late = begins_later(&model, &bench.recordings);
    let steady: Vec<usize> = fixed(&model, is_late).collect();
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
    let says = says(&bench.recordings, (&steady, is_late), &other);
    Some(Moving { model, fit: other, says })
}

/// The same for a fit alone: what a reader should know.
pub fn begins_in_motion(
    fit: &Fit,
    recordings: &[Recording],
    separate_holdout: bool,
    seed: u64,
) -> Option<String> {
    fixed(&fit.model, begins_later(&fit.model, recordings)).next()?;
    let bench = Bench::new(&fit.model, recordings.to_vec(), separate_holdout, seed);
    moving(&bench, fit).map(|other| other.says)
}

/// Numbers of the states that a model starts where it rests, and of those that it starts at a number, where what is fitted
/// begins later than the recording.
fn fixed(model: &Model, is_late: bool) -> impl Iterator<Item = usize> {
    let is_fixed = move |initial: &Initial| match initial {
        Initial::Steady => true,
        Initial::Number(_) => is_late,
        Initial::Fit => false,
    };
    (0..model.states.len()).filter(move |k| is_fixed(&model.states[*k].initial))
}

/// Whether what is fitted of a recording begins later than it, as its file says.
fn begins_later(model: &Model, recordings: &[Recording]) -> bool {
    let names = setup::channels(model);
    recordings.iter().filter(|r| r.spans.given).any(|r| {
        let (first, whole) = (r.spans_for(&names, false).fit.first().copied(), r.common_range(&names));
        first.zip(whole).is_some_and(|(first, whole)| first.from > whole.from)
    })
}

fn says(recordings: &[Recording], (steady, is_late): (&[usize], bool), fit: &Fit) -> String {
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
    let begins = begins.collect::<Vec<String>>().join(", ");
    if is_late {
        return format!(
            "what is fitted begins later than the recording, where the model's own starts hold: there it begins with {begins}; \
             write `initial = \"fit\"`"
        );
    }
    let whose = if several { "not every recording begins" } else { "the recording does not begin" };
    format!(
        "{whose} at rest, as `initial = \"steady\"` says: it begins with {begins}; write `initial = \"fit\"`"
    )
}
