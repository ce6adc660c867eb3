//! # What it is
//! A spring in series with a slipping joint: rubber, wire rope, wound cable, presliding friction.
//!
//! # Signature in a recording
//! A loop of force against position that does not depend on speed; loss in proportion to amplitude
//! beyond the slip.
//!
//! # Equation
//! ```text
//!     M v' = … - kz z,  z = hysteresis(q, gap): follows q, held within gap/2
//! ```
//!
//! # What else looks like this
//! dry-friction (a stiff one), backlash, extra-lag (whose loop depends on speed).
//!
//! # Reference
//! Y.-K. Wen, Method for random vibration of hysteretic systems, ASCE J. Eng. Mech. 102 (1976) 249;
//! P. R. Dahl, Aerospace Corp. TOR-158 (1968).
//!
//! # Example
//! An instrument hung on wire-rope isolators.

use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY,
    draft::POSITIVE,
};
use crate::units::Unit;

/// An elastic part that slips.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "hysteresis",
    "an elastic part that slips",
    Group::Force,
    include_str!("hysteresis.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let mut all: Vec<Proposal> = scene.motions().iter().filter_map(|m| at(scene, m)).collect();
    all.extend(scene.moving(&[SignalKind::Input]).filter_map(|u| fed(scene, u)));
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let signal = scene.signal(q)?;
    let mut d = Draft::at(scene, "hysteresis", m);
    let k = d.amplitude("kz", &m.force.over(&signal.unit), POSITIVE, "stiffness of the slipping part");
    let range = signal.max - signal.min;
    let gap = d.parameter("gap", &signal.unit, (1e-4 * range, 2.0 * range), "width of the loop");
    d.force(&m.state, &format!("-{k}*hysteresis({q}, {gap})"));
    for fraction in [0.1, 0.5] {
        d.start(&[m.size / (fraction * signal.spread), fraction * 2.0 * signal.spread]);
    }
    d.done(&format!("a part of stiffness {{0}} gives with {} and slips beyond {{1}}", scene.words(q)))
}

fn fed(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "hysteresis", SiteKind::Input, &u.name);
    let a = d.amplitude("a", &Unit::one(), ANY, "share of the loop");
    let range = u.max - u.min;
    let gap = d.parameter("gap", &u.unit, (1e-4 * range, 2.0 * range), "width of the loop");
    let name = &u.name;
    d.replace(name, &format!("({name} + {a}*hysteresis({name}, {gap}))"), |_| true);
    for fraction in [0.2, 0.7] {
        d.start(&[1.0, fraction * 2.0 * u.spread]);
    }
    d.done(&format!("what acts for {} runs in a loop of width {{1}}", scene.words(name)))
}
