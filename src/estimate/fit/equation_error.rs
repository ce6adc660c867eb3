//! Starts by equation error.
//!
//! # Purpose
//! Where the states are measured, or are derivatives of what is measured, the rates can be compared
//! directly: no simulation, hardly any side minima.
//!
//! # Method
//! A second model is made in which the known states are inputs and their rates are outputs; its
//! recording holds the smoothed signals and their derivatives. Fitting that is the equation-error
//! estimate; states that are not seen stay states of it.
//!
//! # References
//! E. A. Morelli, V. Klein, Aircraft System Identification, 2nd ed. 2016, ch. 5.
//!
//! # Numerical aspects
//! Noise in the derivatives biases the estimate: it is a start, never a result.

use super::options::{Effort, FitOptions, Weighting};
use super::setup;
use crate::estimate::smooth::{Jet, Smoother};
use crate::expression::Expr;
use crate::model::shown::{Seen, seen_states};
use crate::model::{Input, Model, Output};
use crate::record::{Channel, Recording};
use crate::units::Unit;

/// Most samples that are compared.
const SAMPLES: usize = 4000;

/// All parameters of the model by equation error; None where no state's rate is seen.
pub fn equation_error(model: &Model, recordings: &[Recording], options: &FitOptions<'_>) -> Option<Vec<f64>> {
    let seen = seen_states(model);
    let rates: Vec<usize> = (0..model.states.len())
        .filter(|k| seen[*k].is_some_and(|s| s.order < 3) && !is_seen(model, &seen, &model.states[*k].rate))
        .collect();
    if rates.is_empty() {
        return None;
    }
    let regression = regression_model(model, &seen, &rates);
    let made: Vec<Recording> = recordings
        .iter()
        .map(|r| regression_recording(model, r, &seen, &rates, options))
        .collect::<Option<_>>()?;
    let near = FitOptions {
        effort: Effort::Near,
        weighting: Weighting::FreeRun,
        initials: Vec::new(),
        separate_holdout: true,
        ..options.clone()
    };
    let fitted = super::fit(&regression, &made, &near).ok()?;
    let values: Vec<f64> = fitted.parameters.iter().map(|p| p.value).collect();
    values.iter().all(|v| v.is_finite()).then_some(values)
}

fn is_seen(model: &Model, seen: &[Option<Seen>], rate: &Expr) -> bool {
    let named = |k: usize| *rate == Expr::name(model.states[k].name.clone());
    (0..model.states.len()).any(|k| seen[k].is_some_and(|s| s.order > 0) && named(k))
}

fn rate_name(state: &str) -> String {
    format!("rate_of_{state}")
}

fn rate_unit(unit: &Unit) -> Unit {
    let second = Unit::parse("s").unwrap_or_else(|_| Unit::one());
    Unit::of(unit.dimension().over(second.dimension()))
}

/// Known states become inputs, their rates outputs.
fn regression_model(model: &Model, seen: &[Option<Seen>], rates: &[usize]) -> Model {
    let mut made = model.clone();
    made.outputs = rates
        .iter()
        .map(|k| Output {
            name: rate_name(&model.states[*k].name),
            equals: model.states[*k].rate.clone(),
            unit: rate_unit(&model.states[*k].unit),
            meaning: None,
        })
        .collect();
    made.states.clear();
    for (state, seen) in model.states.iter().zip(seen) {
        if seen.is_some() {
            made.inputs.push(Input { name: state.name.clone(), unit: state.unit.clone(), meaning: None });
        } else {
            made.states.push(state.clone());
        }
    }
    made
}

/// The smoothed signals and their derivatives over the fitted spans.
fn regression_recording(
    model: &Model,
    recording: &Recording,
    seen: &[Option<Seen>],
    rates: &[usize],
    options: &FitOptions<'_>,
) -> Option<Recording> {
    let spans = setup::spans(model, recording, options);
    let mut made = recording.clone();
    made.channels.retain(|c| model.inputs.iter().any(|i| i.name == c.name));
    for output in 0..model.outputs.len() {
        let Some(channel) = recording.find(&model.outputs[output].name) else { continue };
        let kept: Vec<(f64, f64)> = channel.samples().filter(|(t, _)| spans.fits(*t)).collect();
        let (time, values): (Vec<f64>, Vec<f64>) = kept.into_iter().unzip();
        let smoother = Smoother::new(&time, &values)?;
        let step = time.len().div_ceil(SAMPLES);
        let at: Vec<usize> = (0..time.len()).step_by(step).collect();
        let times: Vec<f64> = at.iter().map(|i| time[*i]).collect();
        let jets: Vec<Jet> = at.iter().map(|i| smoother.jet(*i)).collect();
        let mut add = |name: String, unit: Unit, order: usize| {
            let values = jets.iter().map(|j| j[order]).collect();
            made.channels.push(Channel::new(name, unit, times.clone(), values));
        };
        for (k, state) in model.states.iter().enumerate() {
            let Some(s) = seen[k].filter(|s| s.output == output) else { continue };
            add(state.name.clone(), state.unit.clone(), s.order);
            if rates.contains(&k) {
                add(rate_name(&state.name), rate_unit(&state.unit), s.order + 1);
            }
        }
    }
    made.spans = spans;
    made.spans.holdout.clear();
    Some(made)
}
