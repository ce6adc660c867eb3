//! # What it is
//! What is recorded acts on the system only after a dead time: transport in a pipe, a bus, a sampled
//! controller.
//!
//! # Signature in a recording
//! Every response comes late by the same time; the residual is largest where the input changes, and
//! its phase grows with frequency.
//!
//! # Equation
//! ```text
//!     u -> delay(u, Td),  Td >= 0      u an input, or a definition of inputs and states, as a controller's
//! ```
//!
//! # What else looks like this
//! output-delay (the same with one input and one output), input-lag, clock-offset, neglected-
//! inertia.
//!
//! # Reference
//! L. Ljung, System Identification, 2nd ed. (1999), 17.3 (hair dryer).
//!
//! # Example
//! A hair dryer: the heated air takes a quarter of a second along the tube.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal};
use crate::units::Unit;

/// A delay of an input.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "input-delay",
    "a delay of an input",
    Group::Input,
    include_str!("input_delay.rs"),
    propose,
)
.shifting_time();

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.loops().filter_map(|u| at(scene, u)).collect()
}

fn at(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-delay", u.site(), &u.name);
    let time = d.parameter("Td", &Unit::parse("s").ok()?, (0.0, 0.2 * scene.length()), "dead time");
    d.replace(&u.name, &format!("delay({}, {time})", u.name), |_| true);
    for start in scene.delays() {
        d.start(&[start]);
    }
    d.done(&format!("{} acts on the system {{0}} late", scene.words(&u.name)))
}
