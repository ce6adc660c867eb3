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
//!     x' = f  ->  x' = clamp(f, -r, r)   x a state that follows: f has the form (… - x)/T, as an actuator's
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

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SiteKind, edit};
use crate::model::State;
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
    let commands = scene.loops().filter_map(|u| at(scene, u));
    commands.chain(scene.model.states.iter().filter_map(|x| follower(scene, x))).collect()
}

/// A state that follows what acts on it, and no faster: an actuator of the model.
fn follower(scene: &Scene, x: &State) -> Option<Proposal> {
    edit::follows(scene.model, x)?;
    let signal = scene.signal(&x.name).filter(|s| s.varies())?;
    let mut d = Draft::new(scene, "input-rate-limit", SiteKind::State, &x.name);
    let (rate, usual) = limit(&mut d, signal)?;
    let text = format!("clamp({}, -{rate}, {rate})", x.rate);
    d.rate(&x.name, &text);
    d.term(&text);
    d.uses(&x.name);
    starts(&mut d, usual);
    d.done(&format!("{} changes no faster than {{0}}", scene.words(&x.name)))
}

/// The largest rate of a signal as a parameter, and the usual one, in SI.
fn limit(d: &mut Draft, u: &Signal) -> Option<(String, f64)> {
    let usual = u.spread / u.pace;
    let unit = u.unit.of_differences().over(&Unit::parse("s").ok()?);
    Some((d.parameter("r", &unit, (1e-3 * usual, 1e3 * usual), "largest rate"), usual))
}

fn starts(d: &mut Draft, usual: f64) {
    for fraction in [0.2, 0.7, 2.0] {
        d.start(&[fraction * usual]);
    }
}

fn at(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-rate-limit", u.site(), &u.name);
    let (rate, usual) = limit(&mut d, u)?;
    d.replace(&u.name, &format!("rate_limit({}, {rate})", u.name), |_| true);
    starts(&mut d, usual);
    d.done(&format!("what acts for {} changes no faster than {{0}}", scene.words(&u.name)))
}
