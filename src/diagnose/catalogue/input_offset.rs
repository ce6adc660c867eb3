//! # What it is
//! What acts differs from what is recorded by a constant: an amplifier's offset, a shifted zero.
//!
//! # Signature in a recording
//! The response drifts or rests off its place even at zero input.
//!
//! # Equation
//! ```text
//!     u -> u + b
//! ```
//!
//! # What else looks like this
//! constant-force, output-offset: the same thing where the model is linear.
//!
//! # Reference
//! L. Ljung, System Identification, 2nd ed. (1999), 14.1.
//!
//! # Example
//! A drive whose zero volts push a little.

use super::{Alone, Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY};

/// An offset of the input.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "input-offset",
    "an offset of the input",
    Group::Input,
    include_str!("input_offset.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let inputs = scene.moving(&[SignalKind::Input]).filter(|u| !u.is_heading());
    inputs.flat_map(|u| scene.all_or_one().filter_map(move |one| at(scene, u, one))).collect()
}

fn at(scene: &Scene, u: &Signal, one: Option<&Alone>) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-offset", SiteKind::Input, &u.name).alone(one);
    let b = d.amplitude("b", &u.unit, ANY, "offset of the input");
    d.replace(&u.name, &format!("({} + {b})", u.name), |_| true);
    d.start(&[0.3 * u.spread]);
    d.done(&format!("what acts differs from {} by {{0}}", scene.words(&u.name)))
}
