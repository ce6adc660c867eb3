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
use super::input_noise;
use super::measure::SURELY;
use super::response::{Drive, Driven};
use super::view::View;
use super::words::quantity;
use crate::estimate::Fit;
use crate::model::Model;
use crate::units::{Unit, figure};
use rayon::prelude::*;

/// Times the white noise from which on what wanders is told.
const MUCH: f64 = 2.0;
/// Steps that it must last: noise of a shorter memory is but coloured.
const LASTS: f64 = 5.0;
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

/// What wanders in an output.
struct Found {
    output: usize,
    sensor: Best,
    force: Option<(usize, Best)>,
}

impl Found {
    /// By how much likelier a force at a state is than the sensor.
    fn gain(&self) -> f64 {
        self.force.map_or(0.0, |(_, by)| by.driven.likelihood - self.sensor.driven.likelihood)
    }
}

/// What wanders.
pub struct Wanders {
    /// The sentence.
    pub says: String,
    /// The state that it drives for sure, and by more than noise of the inputs could.
    pub driven: Option<String>,
}

impl Wanders {
    /// What is missing, where it drives a state.
    pub fn acts(&self, state: &str) -> String {
        format!("a disturbance that nobody recorded acts on {state}; {}", self.says)
    }
}

/// What to know of what is left of a fitted model in which no law is seen; none where nothing wanders.
pub fn told(bench: &Bench, fit: &Fit) -> Option<Wanders> {
    let view = View::of(bench, fit).ok()?;
    let mut sensors: Vec<_> = (0..fit.model.outputs.len()).filter_map(|o| by_itself(&view, o)).collect();
    sensors.sort_by(|a, b| b.1.ratio.total_cmp(&a.1.ratio));
    let found = sensors.into_iter().find_map(|(output, sensor)| pushed(&view, fit, output, sensor))?;
    let state = found.force.map(|(j, _)| fit.model.states[j].name.clone());
    let is_more = found.gain() > SURELY && !input_noise::could_leave(bench, &view, fit, found.output);
    Some(Wanders { says: says(fit, &found), driven: state.filter(|_| is_more) })
}

/// An output in which much wanders for sure, as by itself.
fn by_itself(view: &View, output: usize) -> Option<(usize, Best)> {
    let drive = view.response.as_ref()?.drive(&view.tracks, output, None)?;
    let (sensor, white) = (best(&drive, span(view, output)?)?, drive.white()?);
    (sensor.driven.likelihood - white > SURELY && sensor.ratio > MUCH).then_some((output, sensor))
}

/// What wanders in it: by itself for long, or pushed at a state that swings or follows slowly.
fn pushed(view: &View, fit: &Fit, output: usize, sensor: Best) -> Option<Found> {
    let (response, span) = (view.response.as_ref()?, span(view, output)?);
    let push = |j: usize| Some((j, best(&response.drive(&view.tracks, output, Some(j))?, span)?));
    let forces = forced(&fit.model).into_par_iter().filter_map(push);
    let force = forces.max_by(|a, b| a.1.driven.likelihood.total_cmp(&b.1.driven.likelihood));
    let found = Found { output, sensor, force };
    (sensor.tau > LASTS * span.1 || found.gain() > SURELY).then_some(found)
}

/// States whose rates a force may enter.
fn forced(model: &Model) -> Vec<usize> {
    let rate = |j: &usize| edit::opened(model, &model.states[*j].rate);
    (0..model.states.len()).filter(|j| !edit::is_kinematic(model, rate(j))).collect()
}

/// The longest time that a recording of an output spans, and the step of its samples.
fn span(view: &View, output: usize) -> Option<(f64, f64)> {
    let of = |time: &[f64]| {
        let length = time.last()? - time.first()?;
        Some((length, length / time.len() as f64))
    };
    let own = view.tracks.iter().filter(|t| t.output == output).filter_map(|t| of(&t.time));
    own.max_by(|a, b| a.0.total_cmp(&b.0))
}

/// The likeliest memory and size.
fn best(drive: &Drive<'_>, (length, step): (f64, f64)) -> Option<Best> {
    let (shortest, least) = ((2.0 * step).ln(), RATIOS.0.ln());
    let mut by = (
        ((0.25 * length).ln() - shortest) / (GRID.0 - 1) as f64,
        (RATIOS.1.ln() - least) / (GRID.1 - 1) as f64,
    );
    let taus: Vec<f64> = (0..GRID.0).map(|i| shortest + by.0 * i as f64).collect();
    let ratios: Vec<f64> = (0..GRID.1).map(|k| least + by.1 * k as f64).collect();
    let mut found = likeliest(drive, &taus, &ratios, None)?;
    for _ in 0..GRID.2 {
        by = (0.5 * by.0, 0.5 * by.1);
        let around = |at: f64, by: f64| [at, at - by, at + by];
        let (taus, ratios) = (around(found.tau.ln(), by.0), around(found.ratio.ln(), by.1));
        found = likeliest(drive, &taus, &ratios, Some(found))?;
    }
    Some(found)
}

/// The likeliest of a grid of logarithms of memories and ratios, and one that is known.
fn likeliest(drive: &Drive<'_>, taus: &[f64], ratios: &[f64], known: Option<Best>) -> Option<Best> {
    let mut found = known;
    for tau in taus.iter().map(|t| t.exp()) {
        let shows = drive.shows(tau);
        for ratio in ratios.iter().map(|r| r.exp()).filter(|_| shows > 0.0) {
            let Some(driven) = drive.driven(tau, ratio / shows) else { continue };
            if found.is_none_or(|best| driven.likelihood > best.driven.likelihood) {
                found = Some(Best { driven, tau, ratio });
            }
        }
    }
    found
}

/// The sentence.
fn says(fit: &Fit, found: &Found) -> String {
    let (model, shown) = (&fit.model, &fit.model.outputs[found.output]);
    let in_unit =
        |x: f64, unit: &Unit| quantity(unit.of_differences().from_si(x), unit.of_differences().text());
    let size = in_unit(fit.rmse[found.output], &shown.unit);
    let begin = |by: &Best| {
        let noise = in_unit(by.driven.noise, &shown.unit);
        let beside = if by.ratio < RATIOS.1 { format!(", beside noise of {noise}") } else { String::new() };
        format!("what is left of “{}” wanders by {size}{beside}", shown.name)
    };
    let memory = |b: &Best| format!("with a memory of {} s", figure(b.tau));
    let sensor = &found.sensor;
    let own = format!("a sensor that wanders by itself, {}", memory(sensor));
    let Some((j, force)) = found.force else { return format!("{}: {own}", begin(sensor)) };
    let state = &model.states[j];
    let second = Unit::parse("s").unwrap_or_else(|_| Unit::one());
    let unit = state.unit.of_differences().over(&second).usual();
    let push = format!(
        "what acts on {} and nobody recorded, {} in its rate, {},",
        state.name,
        in_unit(force.driven.size, &unit),
        memory(&force)
    );
    let by = |g: f64| format!("ln L {} higher", figure(g));
    match found.gain() {
        g if g > SURELY => format!("{}: {push} explains it better than {own} ({})", begin(&force), by(g)),
        g if g < -SURELY => format!("{}: {own}, explains it better than {push} ({})", begin(sensor), by(-g)),
        _ => format!(
            "{}: {push} explains it as well as {own}; this recording cannot tell which",
            begin(sensor)
        ),
    }
}
