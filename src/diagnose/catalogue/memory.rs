//! # What it is
//! A fluid or a solid that remembers its past over several decades of time: boundary layers, waves
//! made by a hull.
//!
//! # Signature in a recording
//! Damping that falls with the root of the frequency; tails that no single lag fits.
//!
//! # Equation
//! ```text
//!     M v' = … - c sum_k s_k (q - lag(q, tau_k)),  tau_k = tau, tau/10, tau/100, s_k = 1, sqrt 10, 10
//! ```
//!
//! # What else looks like this
//! extra-lag (one time alone), linear-damping in a narrow band.
//!
//! # Reference
//! W. E. Cummins, The impulse response function and ship motions, DTMB report 1661 (1962).
//!
//! # Example
//! A hull whose roll radiates waves.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE, field};
use crate::units::Unit;

/// A force that remembers many times.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "memory",
    "a force that remembers many times",
    Group::Dynamics,
    include_str!("memory.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref().or(m.speed.as_ref())?;
    let mut d = Draft::at(scene, "memory", m);
    let c = d.amplitude("c", &m.force.over(&scene.unit(q)), POSITIVE, "strength of the memory");
    let tau = d.parameter(
        "tau",
        &Unit::parse("s").ok()?,
        (scene.step, scene.length()),
        "longest time of the memory",
    );
    let part = |weight: &str, share: &str| format!("{weight}*({q} - lag({q}, {tau}/{share}))");
    d.force(
        &m.state,
        &format!("-{c}*({} + {} + {})", part("1", "1"), part("3.1623", "10"), part("10", "100")),
    );
    for time in scene.times() {
        d.start(&[0.1 * m.size / scene.size(q), 10.0 * time]);
    }
    let what = field::words(m).acts.trim_start_matches("a ");
    d.done(&format!("the {what} on {} remembers its past over {{1}}", scene.words(&m.state)))
}
