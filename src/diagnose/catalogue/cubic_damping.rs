//! # What it is
//! A damping that is weak in slow and strong in fast motion.
//!
//! # Signature in a recording
//! As quadratic damping, with a sharper bend.
//!
//! # Equation
//! ```text
//!     M v' = … - c3 v^3,  c3 >= 0
//! ```
//!
//! # What else looks like this
//! quadratic-damping: they part only where the amplitude varies by a factor of three and more.
//!
//! # Reference
//! M. R. Haddara, P. Bennett, A study of the angle dependence of roll damping moment, Ocean Eng. 16
//! (1989) 411.
//!
//! # Example
//! A damper with an orifice that closes.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};

/// Damping with the third power of the speed.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "cubic-damping",
    "damping with the third power of the speed",
    Group::Friction,
    include_str!("cubic_damping.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let mut d = Draft::at(scene, "cubic-damping", m);
    let unit = m.force.over(&scene.unit(v).power(3.0));
    let c = d.amplitude("c3", &unit, POSITIVE, "damping with the cube of the speed");
    d.force(&m.state, &format!("-{c}*{v}^3"));
    d.start(&[m.size / scene.size(v).powi(3)]);
    d.done(&format!("damping of {{0}} grows with the third power of {}", scene.words(v)))
}
