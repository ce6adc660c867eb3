//! # What it is
//! The sensor shows a constant more than there is.
//!
//! # Signature in a recording
//! The residual has a mean that does not depend on the motion.
//!
//! # Equation
//! ```text
//!     y -> y + b
//! ```
//!
//! # What else looks like this
//! constant-force, input-offset: the same thing where the model is linear and has a rest.
//!
//! # Reference
//! JCGM 200:2012, International vocabulary of metrology, 4.20.
//!
//! # Example
//! An angle sensor whose zero was not set.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind, draft::ANY};

/// An offset of the sensor.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-offset",
    "an offset of the sensor",
    Group::Output,
    include_str!("output_offset.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.model.outputs.iter().filter_map(|o| at(scene, &o.name)).collect()
}

fn at(scene: &Scene, output: &str) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-offset", SiteKind::Output, output);
    let b = d.amplitude("b", &scene.unit(output), ANY, "offset of the sensor");
    d.output(output, &format!("{{}} + {b}"));
    d.start(&[0.5 * scene.signal(output)?.spread]);
    d.done(&format!("the sensor of {} shows {{0}} too much", scene.words(output)))
}
