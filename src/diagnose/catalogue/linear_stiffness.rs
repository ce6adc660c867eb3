//! # What it is
//! A spring that the model has none of: a force in proportion to the deflection.
//!
//! # Signature in a recording
//! What ran away in the simulation comes back: a steady force ends in a deflection, not in a speed;
//! the residual force is a straight line against the position.
//!
//! # Equation
//! ```text
//!     M v' = … - k1 q
//! ```
//!
//! # What else looks like this
//! gravity-pendulum (small swings), extra-lag whose time is long, constant-force where the position
//! hardly moves. A spring whose stiffness alone is wrong: parameter-value.
//!
//! # Reference
//! J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), ch. 2.
//!
//! # Example
//! The cable that trails behind a carriage; a hose that a platform bends.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY, edit, field};

/// A force in proportion to the deflection.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "linear-stiffness",
    "a force in proportion to the deflection",
    Group::Force,
    include_str!("linear_stiffness.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    // what is no speed loses in proportion to itself: linear-damping
    m.speed.as_ref()?;
    let q = m.position.as_ref()?;
    let rate = &scene.model.states.iter().find(|s| s.name == m.state)?.rate;
    // a spring that the model has is another value of its stiffness
    if edit::has_term_in(scene.model, rate, q) {
        return None;
    }
    let mut d = Draft::at(scene, "linear-stiffness", m);
    let k = d.amplitude("k1", &m.force.over(&scene.unit(q)), ANY, "stiffness");
    d.force(&m.state, &format!("-{k}*{q}"));
    d.start(&[m.size / scene.size(q)]);
    let back = field::words(m).back;
    d.done(&format!("{back} in proportion to {}, {{0}}, is missing", scene.words(q)))
}
