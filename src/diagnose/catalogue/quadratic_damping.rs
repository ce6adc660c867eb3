//! # What it is
//! Drag of a fluid with separated flow: bilge keels, rudders, hulls, propellers; the loss of a turbulent flow.
//!
//! # Signature in a recording
//! Large swings decay faster than small ones; the residual force bends with the speed, oddly.
//!
//! # Equation
//! ```text
//!     M v' = … - c2 v |v|,  c2 >= 0
//!     c (v - w) -> c (v - w) + c2 (v - w) |v - w| of a damper between two bodies
//! ```
//!
//! # What else looks like this
//! cubic-damping, dry-friction (the other way: small swings decay faster), cubic-stiffness seen
//! through the phase.
//!
//! # Reference
//! Y. Himeno, Prediction of ship roll damping: state of the art, Univ. of Michigan report 239
//! (1981).
//!
//! # Example
//! A ship model with bilge keels in a roll decay test.

use super::between::{self, Between, Of};
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};
use crate::units::Unit;

/// Damping with the square of the speed.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "quadratic-damping",
    "damping with the square of the speed",
    Group::Friction,
    include_str!("quadratic_damping.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = scene.motions().iter().filter_map(|m| at(scene, m)).collect();
    all.extend(between::all(scene, Of::Speeds).iter().filter_map(|b| damps(scene, b)));
    all.extend(scene.richer_lag("quadratic-damping").and_then(|(mut d, lag)| {
        let (w, a) = (&lag.frequency, lag.amplitude.as_ref()?);
        let unit = Unit::one().over(&scene.unit(a).times(&scene.unit(w).power(3.0)));
        let c = d.amplitude("c2", &unit, POSITIVE, "growth of the damping with the speed");
        d.lag_factor(&format!("1 + {}*(1 + {c}*{a}*{w}^3)^2", lag.square));
        d.start(&[1.0 / (scene.size(a) * scene.size(w).powi(3))]);
        d.done(&format!(
            "the lag of the giving part grows with {a}: damping with the square of its speed, {{0}}"
        ))
    }));
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.flows(scene)?;
    let mut d = Draft::at(scene, "quadratic-damping", m);
    let unit = m.force.over(&scene.unit(v).power(2.0));
    let c = d.amplitude("c2", &unit, POSITIVE, "damping with the square of the speed");
    d.force(&m.state, &format!("-{c}*{v}*abs({v})"));
    d.start(&[m.size / scene.size(v).powi(2)]);
    let what = if m.speed.is_some() { "damping" } else { "a loss" };
    d.done(&format!("{what} of {{0}} grows with the square of {}", scene.words(v)))
}

/// Damping between two bodies.
fn damps(scene: &Scene, b: &Between) -> Option<Proposal> {
    let mut d = b.draft(scene, "quadratic-damping");
    let c = d.amplitude(
        "c2",
        &b.force.over(&b.unit.power(2.0)),
        POSITIVE,
        "damping with the square of the speed",
    );
    b.obeys(&mut d, &|v, _| format!("{}*{v} + {c}*{v}*abs({v})", b.parameter));
    d.start(&[b.force_size(scene) / b.size.powi(2)]);
    d.done(&format!("damping of {{0}} grows with the square of {}", b.difference))
}
