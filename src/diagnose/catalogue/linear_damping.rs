//! # What it is
//! A viscous force: it takes energy in proportion to the square of the speed.
//!
//! # Signature in a recording
//! Free motion decays as an exponential; the residual force is a straight line against the speed
//! through zero.
//!
//! # Equation
//! ```text
//!     M v' = … - c v,  c >= 0
//! ```
//!
//! # What else looks like this
//! At one amplitude every other damping; input-lag and extra-lag near one frequency.
//!
//! # Reference
//! J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), ch. 2.
//!
//! # Example
//! A pendulum modelled without any loss.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};

/// Damping in proportion to the speed.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "linear-damping",
    "damping in proportion to the speed",
    Group::Friction,
    include_str!("linear_damping.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let mut d = Draft::at(scene, "linear-damping", m);
    let c = d.amplitude("c", &m.force.over(&scene.unit(v)), POSITIVE, "viscous damping");
    d.force(&m.state, &format!("-{c}*{v}"));
    d.start(&[m.size / scene.size(v)]);
    d.done(&format!("damping of {{0}} in proportion to {} is missing", scene.words(v)))
}
