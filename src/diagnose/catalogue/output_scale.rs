//! # What it is
//! The sensor shows a fixed proportion more than there is.
//!
//! # Signature in a recording
//! The residual is proportional to the output.
//!
//! # Equation
//! ```text
//!     y -> (1 + a) y
//! ```
//!
//! # What else looks like this
//! Any gain of the model that is fitted: then it cannot be seen. wrong-unit where the factor is a
//! known one. A linear-damping (a leak) where the capacity is free.
//!
//! # Reference
//! JCGM 200:2012, International vocabulary of metrology, 4.12.
//!
//! # Example
//! A potentiometer calibrated with another supply.

use super::{Alone, Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::units::Unit;

/// A wrong scale of the sensor.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-scale",
    "a wrong scale of the sensor",
    Group::Output,
    include_str!("output_scale.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let outputs = scene.model.outputs.iter();
    outputs.flat_map(|o| scene.all_or_one().filter_map(|one| at(scene, &o.name, one))).collect()
}

fn at(scene: &Scene, output: &str, one: Option<&Alone>) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-scale", SiteKind::Output, output).alone(one);
    let a = d.amplitude("a", &Unit::one(), (-0.95, 30.0), "relative error of the scale");
    d.output(output, &format!("(1 + {a})*{{}}"));
    d.start(&[0.3]);
    d.done(&format!("the sensor of {} has a scale that is off, relatively by {{0}}", scene.words(output)))
}
