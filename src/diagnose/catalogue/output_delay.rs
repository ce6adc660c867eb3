//! # What it is
//! The sensor gives what was a while ago: filters, buses, averaging, late time stamps.
//!
//! # Signature in a recording
//! The residual is proportional to the rate of the output.
//!
//! # Equation
//! ```text
//!     y -> delay(y, Td),  Td >= 0
//! ```
//!
//! # What else looks like this
//! input-delay (the same with one input and one output), output-lag, clock-offset (of a whole
//! table).
//!
//! # Reference
//! T. Blochliger, Clock synchronisation of sensors; L. Ljung (1999), ch. 4.
//!
//! # Example
//! A GPS receiver that stamps positions a fifth of a second late.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::units::Unit;

/// A sensor that is late.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-delay",
    "a sensor that is late",
    Group::Output,
    include_str!("output_delay.rs"),
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
    let mut d = Draft::new(scene, "output-delay", SiteKind::Output, output);
    let time = d.parameter("Td", &Unit::parse("s").ok()?, (0.0, 0.2 * scene.length()), "delay of the sensor");
    d.output(output, &format!("delay({{}}, {time})"));
    for start in scene.delays() {
        d.start(&[start]);
    }
    d.done(&format!("the sensor of {} is {{0}} late", scene.words(output)))
}
