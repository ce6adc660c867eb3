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
    let outputs = &scene.model.outputs;
    let odd =
        outputs.iter().flat_map(|o| scene.alone.iter().filter_map(|one| in_one_alone(scene, &o.name, one)));
    outputs.iter().filter_map(|o| at(scene, &o.name)).chain(odd).collect()
}

fn in_one_alone(scene: &Scene, output: &str, one: &Alone) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-scale", SiteKind::Output, output);
    let a = d.amplitude("a", &Unit::one(), (-0.95, 30.0), "relative error of the scale in one recording");
    let mark = d.mark(one);
    d.output(output, &format!("(1 + {a}*{mark})*{{}}"));
    d.start(&[0.3]);
    let words = scene.words(output);
    d.done(&format!(
        "in the recording '{}' alone the sensor of {words} has another scale, relatively by {{0}}",
        one.recording
    ))
}

fn at(scene: &Scene, output: &str) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-scale", SiteKind::Output, output);
    let a = d.amplitude("a", &Unit::one(), (-0.95, 30.0), "relative error of the scale");
    d.output(output, &format!("(1 + {a})*{{}}"));
    d.start(&[0.3]);
    d.done(&format!("the sensor of {} has a scale that is off, relatively by {{0}}", scene.words(output)))
}
