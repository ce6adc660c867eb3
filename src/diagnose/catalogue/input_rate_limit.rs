//! # What it is
//! What acts follows what is recorded no faster than a certain rate: a rudder machine, a valve
//! motor.
//!
//! # Signature in a recording
//! Steps become ramps of one slope; small motions are followed exactly.
//!
//! # Equation
//! ```text
//!     u -> rate_limit(u, r),  r > 0      u an input, or a definition of inputs and states, as a controller's
//! ```
//!
//! # What else looks like this
//! input-lag (rounded corners, at any size), input-delay.
//!
//! # Reference
//! L. M. Kaplan et al. on rate-limited actuators; T. Hu, Z. Lin (2001).
//!
//! # Example
//! A rudder that turns at 2.3 deg/s whatever the order.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal};
use crate::units::Unit;

/// An input that cannot change faster.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "input-rate-limit",
    "an input that cannot change faster",
    Group::Input,
    include_str!("input_rate_limit.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.loops().filter_map(|u| at(scene, u)).collect()
}

fn at(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-rate-limit", u.site(), &u.name);
    let usual = u.spread / u.pace;
    let unit = u.unit.of_differences().over(&Unit::parse("s").ok()?);
    let rate = d.parameter("r", &unit, (1e-3 * usual, 1e3 * usual), "largest rate");
    d.replace(&u.name, &format!("rate_limit({}, {rate})", u.name), |_| true);
    for fraction in [0.2, 0.7, 2.0] {
        d.start(&[fraction * usual]);
    }
    d.done(&format!("what acts for {} changes no faster than {{0}}", scene.words(&u.name)))
}
