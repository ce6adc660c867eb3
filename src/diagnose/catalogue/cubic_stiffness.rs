//! # What it is
//! A restoring force with a cubic part: hardening (positive) or softening (negative).
//!
//! # Signature in a recording
//! The period depends on the amplitude; the residual force bends oddly with the position.
//!
//! # Equation
//! ```text
//!     M v' = … - k3 q^3
//!     k (q - p) -> k (q - p) + k3 (q - p)^3 of a spring between two bodies
//! ```
//!
//! # What else looks like this
//! quadratic-damping at one amplitude, gravity-pendulum (softening), end-stop, parameter-change.
//!
//! # Reference
//! I. Kovacic, M. J. Brennan, The Duffing Equation (2011).
//!
//! # Example
//! The righting arm of a ship rolled beyond ten degrees.

use super::between::{self, Between, Of};
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::ANY, field};
use crate::units::Unit;

/// Stiffness that grows or falls with the deflection.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "cubic-stiffness",
    "stiffness that grows or falls with the deflection",
    Group::Force,
    include_str!("cubic_stiffness.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = scene.motions().iter().filter_map(|m| at(scene, m)).collect();
    all.extend(between::all(scene, Of::Positions).iter().filter_map(|b| stiffens(scene, b)));
    all.extend(scene.richer_lag("cubic-stiffness").and_then(|(mut d, lag)| {
        let (w, a) = (&lag.frequency, lag.amplitude.as_ref()?);
        let unit = Unit::one().over(&scene.unit(a).times(&scene.unit(w).power(2.0)).power(2.0));
        let k = d.amplitude("k3", &unit, ANY, "growth of the stiffness with the square of the acceleration");
        let stiffness = format!("(1 + {k}*({a}*{w}^2)^2)");
        d.lag_factor(&format!("({stiffness}^2 + {})/{stiffness}", lag.square));
        d.start(&[0.5 / (scene.size(a) * scene.size(w).powi(2)).powi(2)]);
        d.done(&format!("the giving part stiffens or softens with {a}, {{0}}"))
    }));
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let mut d = Draft::at(scene, "cubic-stiffness", m);
    let unit = m.force.over(&scene.unit(q).power(3.0));
    let k = d.amplitude("k3", &unit, ANY, "cubic stiffness, positive where it hardens");
    d.force(&m.state, &format!("-{k}*{q}^3"));
    d.start(&[m.size / scene.size(q).powi(3)]);
    let back = field::words(m).back;
    d.done(&format!("{back} grows with the third power of {}, {{0}}", scene.words(q)))
}

/// A spring between two bodies.
fn stiffens(scene: &Scene, b: &Between) -> Option<Proposal> {
    let mut d = b.draft(scene, "cubic-stiffness");
    let k = d.amplitude(
        "k3",
        &b.force.over(&b.unit.power(3.0)),
        ANY,
        "cubic stiffness, positive where it hardens",
    );
    b.obeys(&mut d, &|q, _| format!("{}*{q} + {k}*{q}^3", b.parameter));
    d.start(&[b.force_size(scene) / b.size.powi(3)]);
    d.done(&format!(
        "the force of {} grows with the third power of {}, {{0}}",
        scene.words(&b.parameter),
        b.difference
    ))
}
