//! # What it is
//! A force that grows steadily: a leak, a warming amplifier, a shifting weight.
//!
//! # Signature in a recording
//! The mean of the residual runs away through the recording.
//!
//! # Equation
//! ```text
//!     M v' = … + d (t - t0)
//! ```
//!
//! # What else looks like this
//! output-drift (the sensor) where the model is linear; parameter-drift; slow noise.
//!
//! # Reference
//! P. C. Young, Recursive Estimation and Time-Series Analysis (2011).
//!
//! # Example
//! A ballast tank that slowly fills during the trial.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY};
use crate::units::Unit;

/// A force that drifts with time.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "drift-force",
    "a force that drifts with time",
    Group::Force,
    include_str!("drift_force.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::at(scene, "drift-force", m);
    let rate = d.amplitude("drift", &m.force.over(&second), ANY, "drift of the force");
    let start = d.constant("t0", &second, scene.from, "beginning of the recording");
    d.force(&m.state, &format!("{rate}*(t - {start})"));
    d.start(&[m.size / scene.length()]);
    d.done(&format!("a force on {} drifts by {{0}}", scene.words(&m.state)))
}
