//! # What it is
//! Small values of what is recorded have no effect: overlap of a valve, a threshold of a motor.
//!
//! # Signature in a recording
//! The response is missing while the input is small.
//!
//! # Equation
//! ```text
//!     u -> u - clamp(u, -d, d),  d >= 0      u an input, or a definition of inputs and states, as a controller's
//! ```
//!
//! # What else looks like this
//! dry-friction behind the input, backlash, dead-zone.
//!
//! # Reference
//! G. Tao, P. V. Kokotovic, Adaptive Control of Systems with Actuator and Sensor Nonlinearities
//! (1996).
//!
//! # Example
//! A hydraulic valve with ten per cent overlap.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal};

/// An input that does nothing near zero.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "input-dead-zone",
    "an input that does nothing near zero",
    Group::Input,
    include_str!("input_dead_zone.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let felt = scene.loops().filter(|u| !u.is_heading() && !u.stays_off_zero() && u.levels > 2);
    felt.filter_map(|u| at(scene, u)).collect()
}

fn at(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-dead-zone", u.site(), &u.name);
    let top = u.max.abs().max(u.min.abs());
    let gap = d.parameter("dz", &u.unit, (0.0, top), "half width of the dead zone");
    d.replace(&u.name, &format!("({} - clamp({}, -{gap}, {gap}))", u.name, u.name), |_| true);
    for fraction in [0.1, 0.4, 1.0] {
        d.start(&[(fraction * u.spread).min(0.95 * top)]);
    }
    d.done(&format!("within {{0}} of zero {} does nothing", scene.words(&u.name)))
}
