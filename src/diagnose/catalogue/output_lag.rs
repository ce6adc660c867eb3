//! # What it is
//! The sensor follows with a first-order lag: a thermometer in its pocket, a filter.
//!
//! # Signature in a recording
//! Fast changes of the output are rounded; the system itself is not slower, as other sensors show.
//!
//! # Equation
//! ```text
//!     y -> lag(y, Tl),  Tl >= 0
//! ```
//!
//! # What else looks like this
//! input-lag (the same in a linear model with one input), output-delay at low frequency, extra-lag.
//!
//! # Reference
//! E. O. Doebelin, Measurement Systems, 5th ed. (2004), ch. 3.
//!
//! # Example
//! A thermometer in a steel pocket.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::units::Unit;

/// A sensor with a lag.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-lag",
    "a sensor with a lag",
    Group::Output,
    include_str!("output_lag.rs"),
    propose,
)
.shifting_time();

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.model.outputs.iter().filter_map(|o| at(scene, &o.name)).collect()
}

fn at(scene: &Scene, output: &str) -> Option<Proposal> {
    let mut d = Draft::new(scene, "output-lag", SiteKind::Output, output);
    let time = d.parameter("Tl", &Unit::parse("s").ok()?, (0.0, 0.5 * scene.length()), "lag of the sensor");
    d.output(output, &format!("lag({{}}, {time})"));
    for start in scene.times() {
        d.start(&[start]);
    }
    d.done(&format!("the sensor of {} has a lag of {{0}}", scene.words(output)))
}
