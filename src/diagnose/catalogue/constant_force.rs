//! # What it is
//! A force or a flow that is always there: a leaning axis, an unbalanced weight, an offset of the
//! drive.
//!
//! # Signature in a recording
//! The motion drifts or rests off its zero; the residual force has a mean.
//!
//! # Equation
//! ```text
//!     M v' = … + F0
//! ```
//!
//! # What else looks like this
//! input-offset and output-offset: where the model is linear they are the same thing.
//!
//! # Reference
//! L. Ljung, System Identification, 2nd ed. (1999), 14.1 on offsets.
//!
//! # Example
//! A positioning axis on a table that is not level.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY};

/// A constant force.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "constant-force",
    "a constant force",
    Group::Force,
    include_str!("constant_force.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let mut d = Draft::at(scene, "constant-force", m);
    let f = d.amplitude("F0", &m.force, ANY, "constant force");
    d.force(&m.state, &f);
    d.start(&[m.size]);
    d.done(&format!("a constant {{0}} acts on {}", scene.words(&m.state)))
}
