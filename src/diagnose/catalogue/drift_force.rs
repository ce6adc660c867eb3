//! # What it is
//! A force that grows steadily: a leak, a warming amplifier, a shifting weight.
//!
//! # Signature in a recording
//! The mean of the residual runs away through the recording.
//!
//! # Equation
//! ```text
//!     M v' = … + F0 + d (t - t0)
//! ```
//!
//! t0 is the beginning of the recording; F0, the force there, may be nothing.
//!
//! # What else looks like this
//! output-drift (the sensor) where the model is linear; parameter-drift; slow noise.
//!
//! # Reference
//! P. C. Young, Recursive Estimation and Time-Series Analysis (2011).
//!
//! # Example
//! A ballast tank that slowly fills during the trial.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY, field};
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
    let motions = scene.motions();
    let of = |m: &Motion| {
        [false, true].into_iter().filter_map(|shifted| at(scene, m, shifted)).collect::<Vec<_>>()
    };
    motions.iter().flat_map(of).collect()
}

/// A force that is zero at the beginning of the recording, or `shifted` there.
fn at(scene: &Scene, m: &Motion, shifted: bool) -> Option<Proposal> {
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::at(scene, "drift-force", m);
    let rate = d.amplitude("drift", &m.force.over(&second), ANY, "drift of the force");
    let start = d.constant("t0", &second, scene.from, "beginning of the recording");
    let grown = m.size / scene.length();
    if shifted {
        let first = d.amplitude("F0", &m.force, ANY, "force at the beginning of the recording");
        d.force(&m.state, &format!("{first} + {rate}*(t - {start})"));
        d.start(&[grown, m.size]);
    } else {
        d.force(&m.state, &format!("{rate}*(t - {start})"));
        d.start(&[grown]);
    }
    let what = field::words(m).acts;
    d.done(&format!("{what} on {} drifts by {{0}}", scene.words(&m.state)))
}
