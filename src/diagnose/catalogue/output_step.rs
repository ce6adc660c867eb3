//! # What it is
//! The sensor's zero jumps once: it was knocked, or plugged in anew.
//!
//! # Signature in a recording
//! From one sample to the next the residual has another level, and keeps it whatever the thing does.
//!
//! # Equation
//! ```text
//!     y -> y + b step(t - tc)
//! ```
//!
//! # What else looks like this
//! parameter-change, whose effect goes with the motion and comes no faster than the thing is;
//! clock-jump; a push on a thing that is fast.
//!
//! # Reference
//! R. S. Tsay, J. Forecasting 7 (1988) 1, on level shifts.
//!
//! # Example
//! A level gauge that is bumped in the middle of a trial.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind, draft::ANY, scene::Shift};
use crate::units::Unit;

/// A sensor whose zero jumps.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-step",
    "a sensor whose zero jumps",
    Group::Output,
    include_str!("output_step.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.shifts.iter().filter_map(|s| at(scene, s)).collect()
}

/// The moment lies between two samples; where between them, no sample tells.
fn at(scene: &Scene, s: &Shift) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-step", SiteKind::Output, &s.output);
    let b = d.amplitude("b", &scene.unit(&s.output), ANY, "jump of the sensor's zero");
    let time = d.parameter("tc", &Unit::parse("s").ok()?, s.between, "time of the jump");
    d.output(&s.output, &format!("{{}} + {b}*step(t - {time})"));
    d.start(&[s.size, 0.5 * (s.between.0 + s.between.1)]);
    d.done(&format!("the zero of the sensor of {} jumps by {{0}} at {{1}}", scene.words(&s.output)))
}
