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
    let odd = |u| scene.alone.iter().filter_map(move |one| in_one_alone(scene, u, one));
    inputs.flat_map(|u| at(scene, u).into_iter().chain(odd(u))).collect()
}

fn in_one_alone(scene: &Scene, u: &Signal, one: &Alone) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-offset", SiteKind::Input, &u.name);
    let b = d.amplitude("b", &u.unit, ANY, "offset of the input in one recording");
    let mark = d.mark(one);
    d.replace(&u.name, &format!("({} + {b}*{mark})", u.name), |_| true);
    d.start(&[0.3 * u.spread]);
    let words = scene.words(&u.name);
    d.done(&format!("in the recording '{}' alone what acts differs from {words} by {{0}}", one.recording))
}

fn at(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-offset", SiteKind::Input, &u.name);
    let b = d.amplitude("b", &u.unit, ANY, "offset of the input");
    d.replace(&u.name, &format!("({} + {b})", u.name), |_| true);
    d.start(&[0.3 * u.spread]);
    d.done(&format!("what acts differs from {} by {{0}}", scene.words(&u.name)))
}
