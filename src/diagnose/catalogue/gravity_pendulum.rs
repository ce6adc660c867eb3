//! # What it is
//! An unbalanced mass turns with the axis; its moment goes with the sine of the angle.
//!
//! # Signature in a recording
//! The residual force repeats every turn; for swings under a radian it looks like a softening
//! spring.
//!
//! # Equation
//! ```text
//!     J v' = … - Gs sin(q) - Gc cos(q)
//!     J v' = … - Gs sin(q) - Gc (cos(q) - 1)    balanced at q = 0, by what holds it there
//! ```
//!
//! # What else looks like this
//! cubic-stiffness (softening) at small swings, constant-force where the angle hardly moves,
//! periodic-force with the position.
//!
//! # Reference
//! H. Goldstein, Classical Mechanics, 3rd ed., ch. 2.
//!
//! # Example
//! A radar antenna that is heavier on one side.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY};

/// A weight off the axis.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "gravity-pendulum",
    "a weight off the axis",
    Group::Force,
    include_str!("gravity_pendulum.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let turning = motions.iter().filter(|m| m.position.as_ref().is_some_and(|q| scene.is_angle(q)));
    let weights = [Weight::Below, Weight::Anywhere, Weight::Balanced];
    turning.flat_map(|m| weights.map(|weight| at(scene, m, weight))).flatten().collect()
}

/// Where the weight is at rest: below the axis, anywhere, or anywhere and balanced there.
#[derive(Clone, Copy, PartialEq)]
enum Weight {
    Below,
    Anywhere,
    Balanced,
}

fn at(scene: &Scene, m: &Motion, weight: Weight) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let mut d = Draft::at(scene, "gravity-pendulum", m);
    let s = d.amplitude("Gs", &m.force, ANY, "moment of the weight with the sine of the angle");
    d.force(&m.state, &format!("-{s}*sin({q})"));
    if weight == Weight::Below {
        d.start(&[m.size]);
    } else {
        let c = d.amplitude("Gc", &m.force, ANY, "moment of the weight with the cosine of the angle");
        let held = if weight == Weight::Balanced { " - 1" } else { "" };
        d.force(&m.state, &format!("-{c}*(cos({q}){held})"));
        d.start(&[m.size, m.size]);
    }
    d.done(&format!("a weight off the axis pulls with {{0}} times the sine of {}", scene.words(q)))
}
