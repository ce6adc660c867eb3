//! # What it is
//! The sensor's zero moves steadily with time.
//!
//! # Signature in a recording
//! The residual is a straight line in time.
//!
//! # Equation
//! ```text
//!     y -> y + d (t - t0)
//! ```
//!
//! # What else looks like this
//! drift-force, parameter-drift; slow noise, which does not go on along the line.
//!
//! # Reference
//! IEEE Std 952-2020, on drift of gyroscopes.
//!
//! # Example
//! An integrating gyroscope with a constant rate error.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind, draft::ANY};
use crate::units::Unit;

/// A sensor that drifts.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-drift",
    "a sensor that drifts",
    Group::Output,
    include_str!("output_drift.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.model.outputs.iter().filter_map(|o| at(scene, &o.name)).collect()
}

fn at(scene: &Scene, output: &str) -> Option<Proposal> {
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::new(scene, "output-drift", SiteKind::Output, output);
    let rate = d.amplitude("drift", &scene.unit(output).over(&second), ANY, "drift of the sensor");
    let start = d.constant("t0", &second, scene.from, "beginning of the recording");
    d.output(output, &format!("{{}} + {rate}*(t - {start})"));
    d.start(&[scene.signal(output)?.spread / scene.length()]);
    d.done(&format!("the sensor of {} drifts by {{0}}", scene.words(output)))
}
