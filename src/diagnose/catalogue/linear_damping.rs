//! # What it is
//! A viscous force: it takes energy in proportion to the square of the speed. At a level, a
//! temperature or a charge the same is a leak in proportion to it.
//!
//! # Signature in a recording
//! Free motion decays as an exponential; the residual force is a straight line against the speed
//! through zero. A leak: the rest that an input leads to is nearer, and sooner reached.
//!
//! # Equation
//! ```text
//!     M v' = … - c v,  c >= 0
//!     A h' = … - c h,  c >= 0
//!     X' = (… - c) X,  c >= 0, of what grows in proportion to itself
//!     C T' = … - c (T - Ta),  c >= 0, of a temperature, to surroundings Ta that nobody recorded
//! ```
//!
//! # What else looks like this
//! At one amplitude every other damping; input-lag and extra-lag near one frequency. A leak where
//! the capacity is free: output-scale.
//!
//! # Reference
//! J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), ch. 2.
//!
//! # Example
//! A pendulum modelled without any loss.

use super::scene::{Signal, is_temperature};
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};
use crate::units::Unit;

/// Damping in proportion to the speed, or a leak in proportion to a level.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "linear-damping",
    "damping in proportion to the speed, or a loss in proportion to the level",
    Group::Friction,
    include_str!("linear_damping.rs"),
    propose,
);

/// Temperature of surroundings to begin with, K: that of a room.
const ROOM: f64 = 293.15;
/// Below this, K, a temperature counts from somewhere else than absolute zero.
const ABSOLUTE: f64 = 100.0;

fn propose(scene: &Scene) -> Vec<Proposal> {
    let absolute = |m: &Motion| {
        let signal = scene.signal(&m.state)?;
        (m.speed.is_none() && is_temperature(&signal.unit) && signal.min > ABSOLUTE).then_some(signal)
    };
    let one = |m: &Motion| absolute(m).map_or_else(|| at(scene, m), |signal| cools(scene, m, signal));
    let motions = scene.motions();
    motions.iter().filter_map(one).chain(motions.iter().filter_map(|m| dies(scene, m))).collect()
}

/// A loss beside growth that stands as a rate for each unit: the sum is a rate where the state is none.
fn dies(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let per_second = Unit::parse("1/s").ok()?;
    let is_growth = m.speed.is_none()
        && m.force.dimension() == per_second.dimension()
        && scene.unit(&m.state).dimension() != Unit::one().dimension();
    if !is_growth {
        return None;
    }
    let mut d = Draft::at(scene, "linear-damping", m);
    let c = d.amplitude("c", &m.force, POSITIVE, "rate of loss");
    d.force(&m.state, &format!("-{c}"));
    d.start(&[m.size]);
    d.done(&format!("a loss of {{0}} in proportion to {} is missing", scene.words(&m.state)))
}

/// A loss of heat to surroundings of one temperature.
fn cools(scene: &Scene, m: &Motion, signal: &Signal) -> Option<Proposal> {
    let mut d = Draft::at(scene, "linear-damping", m);
    let c = d.amplitude("c", &m.force.over(&signal.unit), POSITIVE, "loss of heat for a degree");
    let around =
        d.parameter("Ta", &signal.unit, (ABSOLUTE, f64::INFINITY), "temperature of the surroundings");
    d.force(&m.state, &format!("-{c}*({} - {around})", m.state));
    for other in [ROOM, signal.min - signal.spread, signal.max + signal.spread] {
        d.start(&[m.size / (signal.mean - other).abs().max(signal.spread), other]);
    }
    d.done(&format!(
        "a loss of heat of {}, {{0}}, to surroundings of {{1}} is missing",
        scene.words(&m.state)
    ))
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    // What is no speed and has none leaks in proportion to itself.
    let v = m.speed.as_ref().unwrap_or(&m.state);
    let mut d = Draft::at(scene, "linear-damping", m);
    let (meaning, says) = match m.speed {
        Some(_) => {
            ("viscous damping", format!("damping of {{0}} in proportion to {} is missing", scene.words(v)))
        }
        None => ("leak", format!("a loss of {{0}} in proportion to {} is missing", scene.words(v))),
    };
    let c = d.amplitude("c", &m.force.over(&scene.unit(v)), POSITIVE, meaning);
    d.force(&m.state, &format!("-{c}*{v}"));
    d.start(&[m.size / scene.size(v)]);
    d.done(&says)
}
