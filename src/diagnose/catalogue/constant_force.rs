//! # What it is
//! A force or a flow that is always there, or from a moment on: a leaning axis, an unbalanced weight, an offset of the
//! drive; a leak that opens, a load that is put down.
//!
//! # Signature in a recording
//! The motion drifts or rests off its zero; the residual force has a mean, or another one from a moment on.
//!
//! # Equation
//! ```text
//!     M v' = … + F0
//!     M v' = … + F0 step(t - tc)
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

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY};
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
    motions.iter().filter_map(|m| at(scene, m)).chain(late).collect()
}

/// Moments to start from, in equal parts of the recording.
const PARTS: u32 = 10;

fn from_a_moment_on(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let mut d = Draft::at(scene, "constant-force", m);
    let f = d.amplitude("F0", &m.force, ANY, "force that sets in");
    // one that sets in at the beginning is there always
    let part = scene.length() / f64::from(PARTS);
    let within = (scene.from + 0.5 * part, scene.to - 0.5 * part);
    let time = d.parameter("tc", &Unit::parse("s").ok()?, within, "when it sets in");
    d.force(&m.state, &format!("{f}*step(t - {time})"));
    for i in 1..PARTS {
        d.start(&[m.size, scene.from + part * f64::from(i)]);
    }
    d.done(&format!("a constant {{0}} acts on {} from {{1}} on", scene.words(&m.state)))
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let mut d = Draft::at(scene, "constant-force", m);
    let f = d.amplitude("F0", &m.force, ANY, "constant force");
    d.force(&m.state, &f);
    d.start(&[m.size]);
    d.done(&format!("a constant {{0}} acts on {}", scene.words(&m.state)))
}
