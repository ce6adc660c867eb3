//! # What it is
//! A restoring force with an even part: stiffer to one side than to the other.
//!
//! # Signature in a recording
//! The motion's mean shifts with its amplitude; even harmonics.
//!
//! # Equation
//! ```text
//!     M v' = … - k2 q^2
//! ```
//!
//! # What else looks like this
//! constant-force at one amplitude; cubic-stiffness about a position that is not zero.
//!
//! # Reference
//! A. H. Nayfeh, D. T. Mook, Nonlinear Oscillations (1979), 4.1.
//!
//! # Example
//! A ship with a list: other righting arms to port and starboard.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY, field};

/// Stiffness that differs to both sides.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "quadratic-stiffness",
    "stiffness that differs to both sides",
    Group::Force,
    include_str!("quadratic_stiffness.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let mut d = Draft::at(scene, "quadratic-stiffness", m);
    let unit = m.force.over(&scene.unit(q).power(2.0));
    let k = d.amplitude("k2", &unit, ANY, "quadratic stiffness");
    d.force(&m.state, &format!("-{k}*{q}^2"));
    d.start(&[m.size / scene.size(q).powi(2)]);
    let back = field::words(m).back;
    d.done(&format!("{back} has a part with the square of {}, {{0}}", scene.words(q)))
}
