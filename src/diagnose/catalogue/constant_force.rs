//! # What it is
//! A force or a flow that is always there, from a moment on, or in one recording of several alone: a leaning axis, an unbalanced weight, an offset of the
//! drive; a leak that opens, a load that is put down.
//!
//! # Signature in a recording
//! The motion drifts or rests off its zero; the residual force has a mean, or another one from a moment on.
//!
//! # Equation
//! ```text
//!     M v' = … + F0
//!     M v' = … + F0 step(t - tc)
//!     M v' = … + F0 in            in: 1 in one recording, 0 in the others
//! ```
//!
//! # What else looks like this
//! input-offset and output-offset: where the model is linear they are the same thing. Of one that sets in:
//! parameter-change, whose effect goes with the motion; drift-force, which comes by and by.
//!
//! # Reference
//! L. Ljung, System Identification, 2nd ed. (1999), 14.1 on offsets.
//!
//! # Example
//! A positioning axis on a table that is not level.

use super::{Alone, Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY};
use crate::units::Unit;

/// A constant force.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "constant-force",
    "a constant force",
    Group::Force,
    include_str!("constant_force.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let late = motions.iter().filter(|_| !scene.trials).filter_map(|m| from_a_moment_on(scene, m));
    let always = motions.iter().flat_map(|m| scene.all_or_one().filter_map(|one| at(scene, m, one)));
    always.chain(late).collect()
}

fn from_a_moment_on(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let mut d = Draft::at(scene, "constant-force", m);
    let f = d.amplitude("F0", &m.force, ANY, "force that sets in");
    let time = d.parameter("tc", &Unit::parse("s").ok()?, scene.within(), "when it sets in");
    d.force(&m.state, &format!("{f}*step(t - {time})"));
    for moment in scene.moments() {
        d.start(&[m.size, moment]);
    }
    d.done(&format!("a constant {{0}} acts on {} from {{1}} on", scene.words(&m.state)))
}

fn at(scene: &Scene, m: &Motion, one: Option<&Alone>) -> Option<Proposal> {
    let mut d = Draft::at(scene, "constant-force", m).alone(one);
    let f = d.amplitude("F0", &m.force, ANY, "constant force");
    d.force(&m.state, &f);
    d.start(&[m.size]);
    d.done(&format!("a constant {{0}} acts on {}", scene.words(&m.state)))
}
