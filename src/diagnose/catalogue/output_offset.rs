//! # What it is
//! The sensor shows a constant more than there is, always or from a moment on: it was knocked, or plugged in anew.
//!
//! # Signature in a recording
//! The residual has a mean that does not depend on the motion; where the zero jumps, another from one sample to the next.
//!
//! # Equation
//! ```text
//!     y -> y + b
//!     y -> y + b step(t - tc)
//! ```
//!
//! # What else looks like this
//! constant-force, input-offset: the same where the model is linear and has a rest.
//! Of a jump: parameter-change, whose effect goes with the motion and comes no faster than the system responds; clock-jump.
//!
//! # Reference
//! JCGM 200:2012, International vocabulary of metrology, 4.20; R. S. Tsay, J. Forecasting 7
//! (1988) 1, on level shifts.
//!
//! # Example
//! An angle sensor whose zero was not set; a level gauge that is bumped in the middle of a trial.

use super::{Alone, Draft, Group, Mechanism, Proposal, Scene, SiteKind, draft::ANY, scene::Shift};
use crate::units::Unit;

/// An offset of the sensor.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-offset",
    "an offset of the sensor",
    Group::Output,
    include_str!("output_offset.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let outputs = scene.model.outputs.iter();
    let always = outputs.flat_map(|o| scene.all_or_one().filter_map(|one| at(scene, &o.name, one)));
    let jumps = scene.shifts.iter().filter(|_| !scene.trials).filter_map(|s| from_a_moment_on(scene, s));
    always.chain(jumps).collect()
}

fn at(scene: &Scene, output: &str, one: Option<&Alone>) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-offset", SiteKind::Output, output).alone(one);
    let b = d.amplitude("b", &scene.unit(output), ANY, "offset of the sensor");
    d.output(output, &format!("{{}} + {b}"));
    d.start(&[0.5 * scene.signal(output)?.spread]);
    d.done(&format!("the sensor of {} shows {{0}} too much", scene.words(output)))
}

/// The moment lies between two samples; where between them, no sample tells.
fn from_a_moment_on(scene: &Scene, s: &Shift) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-offset", SiteKind::Output, &s.output);
    let b = d.amplitude("b", &scene.unit(&s.output), ANY, "jump of the sensor's zero");
    let time = d.parameter("tc", &Unit::parse("s").ok()?, s.between, "time of the jump");
    d.output(&s.output, &format!("{{}} + {b}*step(t - {time})"));
    d.start(&[s.size, 0.5 * (s.between.0 + s.between.1)]);
    d.done(&format!("the zero of the sensor of {} jumps by {{0}} at {{1}}", scene.words(&s.output)))
}
