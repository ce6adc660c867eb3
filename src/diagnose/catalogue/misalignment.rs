//! # What it is
//! An instrument stands turned against the axis from which its angle is counted.
//!
//! # Signature in a recording
//! The error repeats with the heading, shifted against the model's own harmonic by a constant
//! angle.
//!
//! # Equation
//! ```text
//!     K -> K + delta
//! ```
//!
//! # What else looks like this
//! output-offset at one heading, a harmonic of the heading (cross-coupling), input-delay while
//! turning.
//!
//! # Reference
//! A. Lawrence, Modern Inertial Technology, 2nd ed. (1998), on misalignment.
//!
//! # Example
//! A gyrocompass stand turned by three degrees against the keel.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SiteKind};

/// An angle used by the model is off.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "misalignment",
    "an angle used by the model is off",
    Group::Input,
    include_str!("misalignment.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let angles: Vec<&Signal> = scene.headings();
    angles.iter().filter_map(|h| at(scene, h)).collect()
}

fn at(scene: &Scene, h: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "misalignment", SiteKind::Input, &h.name);
    let delta = d.amplitude("delta", &h.unit, (-1.6, 1.6), "angle by which the input is off");
    d.replace(&h.name, &format!("({} + {delta})", h.name), |_| true);
    d.start(&[0.3]);
    d.done(&format!("{} is off by {{0}}: the instrument stands turned", scene.words(&h.name)))
}
