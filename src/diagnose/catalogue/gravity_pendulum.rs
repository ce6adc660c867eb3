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
    turning.flat_map(|m| [at(scene, m, false), at(scene, m, true)]).flatten().collect()
}

fn at(scene: &Scene, m: &Motion, both: bool) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let mut d = Draft::at(scene, "gravity-pendulum", m);
    let s = d.amplitude("Gs", &m.force, ANY, "moment of the weight with the sine of the angle");
    d.force(&m.state, &format!("-{s}*sin({q})"));
    if both {
        let c = d.amplitude("Gc", &m.force, ANY, "moment of the weight with the cosine of the angle");
        d.force(&m.state, &format!("-{c}*cos({q})"));
        d.start(&[m.size, m.size]);
    } else {
        d.start(&[m.size]);
    }
    d.done(&format!("a weight off the axis pulls with {{0}} times the sine of {}", scene.words(q)))
}
