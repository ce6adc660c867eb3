//! What wanders in what is left: by a force that nobody recorded, or in the sensor itself.
//!
//! # Purpose
//! Where no law is seen in what a model leaves, it may yet be many times the noise between samples. That is no law, and it
//! has no name here; but a reader wants to know whether to look at the machine or at the sensor.
//!
//! # Method
//! What is left of one output is taken for white noise beside a process of some size and memory (Ornstein, Uhlenbeck), which
//! drives a state through the linearised model, or adds to the output. Both have three unknowns, so that their likelihoods
//! compare as they are; a grid of memory and size is halved around its best point.
//!
//! # References
//! A. C. Harvey, Forecasting, Structural Time Series Models and the Kalman Filter (1989), 3.4.

use super::bench::Bench;
use super::catalogue::edit;
use super::response::{Driven, Response};
use super::view::View;
use super::words::quantity;
use crate::estimate::Fit;
use crate::expression::Expr;
use crate::model::Model;
use crate::units::{Unit, figure};
use rayon::prelude::*;

/// Times the white noise from which on what wanders is told.
const MUCH: f64 = 2.0;
/// Steps that it must last: noise of a shorter memory is but coloured.
const LASTS: f64 = 5.0;
/// Gain in log-likelihood from which on one is surely likelier.
const SURELY: f64 = 5.0;
/// Memories and sizes of the first grid, and times that it is halved.
const GRID: (usize, usize, usize) = (9, 7, 4);
/// Ratios of what wanders to white noise.
const RATIOS: (f64, f64) = (0.5, 300.0);

/// One explanation.
#[derive(Clone, Copy)]
struct Best {
    driven: Driven,
    tau: f64,
    ratio: f64,
}

/// What to know of what is left of a fitted model in which no law is seen; none where nothing wanders.
pub fn told(bench: &Bench, fit: &Fit) -> Option<String> {
    let view = View::of(bench, fit).ok()?;
    let response = view.response()?;
    let sensor = |o: usize| {
        let best = best(response, &view, o, None)?;
        let lasts = best.tau > LASTS * span(&view, o)?.1;
        let is_sure = best.driven.likelihood - response.white(&view.tracks, o)? > SURELY;
        (is_sure && lasts && best.ratio > MUCH).then_some((o, best))
    };
    let outputs = (0..fit.model.outputs.len()).filter_map(sensor);
    let (output, sensor) = outputs.max_by(|a, b| a.1.ratio.total_cmp(&b.1.ratio))?;
    let pushed: Vec<usize> = pushed(&fit.model);
    let forces = pushed.into_par_iter().filter_map(|j| Some((j, best(response, &view, output, Some(j))?)));
    let likelihood = |f: &(usize, Best)| f.1.driven.likelihood;
    let force = forces.max_by(|a, b| likelihood(a).total_cmp(&likelihood(b)));
    Some(says(fit, output, &sensor, force))
}

/// States whose rates a force may enter: those that are not the rate of another state alone.
fn pushed(model: &Model) -> Vec<usize> {
    let is_state = |e: &Expr| matches!(e, Expr::Name(n) if model.states.iter().any(|s| s.name == *n));
    (0..model.states.len()).filter(|j| !is_state(edit::opened(model, &model.states[*j].rate))).collect()
}

/// The time that an output spans, and the step of its samples.
fn span(view: &View, output: usize) -> Option<(f64, f64)> {
    let time = &view.tracks.iter().find(|t| t.output == output)?.time;
    let length = time.last()? - time.first()?;
    Some((length, length / time.len() as f64))
}

/// The likeliest memory and size.
fn best(response: &Response, view: &View, output: usize, state: Option<usize>) -> Option<Best> {
    let (length, step) = span(view, output)?;
    let (mut tau, mut ratio) = ((2.0 * step).ln(), RATIOS.0.ln());
    let mut by =
        (((0.25 * length).ln() - tau) / (GRID.0 - 1) as f64, (RATIOS.1.ln() - ratio) / (GRID.1 - 1) as f64);
    let at = |tau: f64, ratio: f64| {
        let (tau, ratio) = (tau.exp(), ratio.exp());
        Some(Best { driven: response.driven(&view.tracks, output, state, (tau, ratio))?, tau, ratio })
    };
    let likelier = |a: Option<Best>, b: Best| match a {
        Some(a) if a.driven.likelihood >= b.driven.likelihood => Some(a),
        _ => Some(b),
    };
    let mut grid: Vec<(f64, f64)> = Vec::new();
    (0..GRID.0)
        .for_each(|i| grid.extend((0..GRID.1).map(|k| (tau + by.0 * i as f64, ratio + by.1 * k as f64))));
    let mut found = grid.into_iter().filter_map(|(t, r)| at(t, r)).fold(None, likelier)?;
    for _ in 0..GRID.2 {
        by = (0.5 * by.0, 0.5 * by.1);
        (tau, ratio) = (found.tau.ln(), found.ratio.ln());
        let near = [
            (-1.0, 0.0),
            (1.0, 0.0),
            (0.0, -1.0),
            (0.0, 1.0),
            (-1.0, -1.0),
            (1.0, 1.0),
            (-1.0, 1.0),
            (1.0, -1.0),
        ];
        let tried = near.iter().filter_map(|(t, r)| at(tau + by.0 * t, ratio + by.1 * r));
        found = tried.fold(Some(found), likelier)?;
    }
    Some(found)
}

/// The sentence.
fn says(fit: &Fit, output: usize, sensor: &Best, force: Option<(usize, Best)>) -> String {
    let (model, shown) = (&fit.model, &fit.model.outputs[output]);
    let in_unit =
        |x: f64, unit: &Unit| quantity(unit.of_differences().from_si(x), unit.of_differences().text());
    let size = in_unit(fit.rmse[output], &shown.unit);
    let begin = |by: &Best| {
        let noise = in_unit(by.driven.noise, &shown.unit);
        let beside = if by.ratio < RATIOS.1 { format!(", beside noise of {noise}") } else { String::new() };
        format!("what is left of “{}” wanders by {size}{beside}", shown.name)
    };
    let memory = |b: &Best| format!("with a memory of {} s", figure(b.tau));
    let own = format!("a sensor that wanders by itself, {}", memory(sensor));
    let Some((j, force)) = force else { return format!("{}: {own}", begin(sensor)) };
    let state = &model.states[j];
    let second = Unit::parse("s").unwrap_or_else(|_| Unit::one());
    let unit = state.unit.of_differences().over(&second).usual();
    let push = format!(
        "what acts on {} and nobody recorded, {} in its rate, {},",
        state.name,
        in_unit(force.driven.size, &unit),
        memory(&force)
    );
    let gain = force.driven.likelihood - sensor.driven.likelihood;
    let by = |g: f64| format!("ln L {} higher", figure(g));
    match gain {
        g if g > SURELY => format!("{}: {push} explains it better than {own} ({})", begin(&force), by(g)),
        g if g < -SURELY => format!("{}: {own}, explains it better than {push} ({})", begin(sensor), by(-g)),
        _ => format!(
            "{}: {push} explains it as well as {own}; this recording cannot tell which",
            begin(sensor)
        ),
    }
}
