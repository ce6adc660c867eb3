//! # What it is
//! Dry friction in proportion to a force that presses the parts together: a belt, a bearing, a gear
//! under load.
//!
//! # Signature in a recording
//! The jump of the residual force at the reversal of the speed is larger while the load is larger.
//!
//! # Equation
//! ```text
//!     M v' = … - mu |load| sign(v),  mu >= 0
//! ```
//!
//! # What else looks like this
//! dry-friction where the load is constant (a temperature is no load); parameter-dependence of the friction.
//!
//! # Reference
//! P. Hamon, M. Gautier, P. Garrec, Dynamic identification of robots with a dry friction model
//! depending on load and velocity, IROS 2010.
//!
//! # Example
//! A crane's slewing ring whose friction follows the recorded load.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, draft::POSITIVE};
use crate::units::Dimension;

/// Dry friction that grows with a load.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "load-friction",
    "dry friction that grows with a load",
    Group::Friction,
    include_str!("load_friction.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    // a temperature presses nothing together
    let presses = |s: &&Signal| s.unit.dimension() != Dimension::TEMPERATURE;
    let loads: Vec<&Signal> =
        scene.moving(&[SignalKind::Input, SignalKind::Channel]).filter(presses).collect();
    let motions = scene.motions();
    let pairs = motions.iter().flat_map(|m| loads.iter().map(move |load| (m, *load)));
    pairs.filter_map(|(m, load)| at(scene, m, load)).collect()
}

fn at(scene: &Scene, m: &Motion, load: &Signal) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let mut d = Draft::at(scene, "load-friction", m);
    let unit = m.force.over(&load.unit);
    let mu = d.amplitude("mu", &unit, POSITIVE, "friction over load");
    d.uses(&load.name);
    d.force(&m.state, &format!("-{mu}*abs({})*sign({v})", load.name));
    d.start(&[m.size / load.size()]);
    let (v, load) = (scene.words(v), scene.words(&load.name));
    d.done(&format!("dry friction against {v} grows with {load}, {{0}}"))
}
