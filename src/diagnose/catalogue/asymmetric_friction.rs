//! # What it is
//! Dry friction that is larger in one direction than in the other; the same as dry friction with a
//! constant force (a leaning axis, an offset of the drive).
//!
//! # Signature in a recording
//! The residual force jumps at the reversal of the speed, about a mean that is not zero.
//!
//! # Equation
//! ```text
//!     M v' = … - Fp  while v > 0,  + Fm  while v < 0
//! ```
//!
//! # What else looks like this
//! dry-friction together with constant-force or input-offset: in a recording they are the same
//! thing.
//!
//! # Reference
//! A. Janot, M. Gautier, M. Brunot, Data set and reference models of EMPS, Workshop on Nonlinear
//! System Identification Benchmarks (2019).
//!
//! # Example
//! A drive whose amplifier has an offset of 3 N on top of 20 N of dry friction.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};

/// Dry friction of another size each way.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "asymmetric-friction",
    "dry friction of another size each way",
    Group::Friction,
    include_str!("asymmetric_friction.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    scene.motions().iter().filter_map(|m| at(scene, m)).collect()
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let mut d = Draft::at(scene, "asymmetric-friction", m);
    let p = d.amplitude("Fp", &m.force, POSITIVE, "dry friction in the positive direction");
    let n = d.amplitude("Fm", &m.force, POSITIVE, "dry friction in the negative direction");
    d.force(&m.state, &format!("-({p} + {n})/2*sign({v})"));
    d.force(&m.state, &format!("-({p} - {n})/2"));
    d.term(&format!("-({p} + {n})/2*sign({v}) - ({p} - {n})/2"));
    d.start(&[m.size, m.size]);
    d.done(&format!("dry friction against {} is {{0}} one way and {{1}} the other", scene.words(v)))
}
