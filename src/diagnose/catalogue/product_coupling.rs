//! # What it is
//! A product of two motions, inputs or levels acts on an equation: gyroscopic and centrifugal moments, a field times a
//! current, two substances that react.
//!
//! # Signature in a recording
//! The residual is coherent with neither signal alone, but with their product.
//!
//! # Equation
//! ```text
//!     s' = … + c a b
//! ```
//!
//! # What else looks like this
//! parameter-dependence (one of the two stands in the model with a parameter); cross-coupling where one of the two hardly
//! varies.
//!
//! # Reference
//! H. Goldstein, Classical Mechanics, 2nd ed. (1980), ch. 5 (Euler's equations).
//!
//! # Example
//! A drone whose three axes are modelled each for itself.

use super::terms::has_factor;
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, draft::ANY, edit};

/// A product of two signals acts.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "product-coupling",
    "a product of two motions or inputs acts",
    Group::Dynamics,
    include_str!("product_coupling.rs"),
    propose,
);

/// Signals from which on pairs are too many.
const MANY: usize = 8;

fn propose(scene: &Scene) -> Vec<Proposal> {
    let signals: Vec<&Signal> =
        scene.moving(&[SignalKind::State, SignalKind::Input]).filter(|s| !s.is_heading()).collect();
    if signals.len() > MANY {
        return Vec::new();
    }
    let mut all = Vec::new();
    for m in scene.motions() {
        for (i, a) in signals.iter().enumerate() {
            all.extend(signals[i..].iter().filter_map(|b| at(scene, &m, a, b)));
        }
    }
    all
}

fn at(scene: &Scene, m: &Motion, a: &Signal, b: &Signal) -> Option<Proposal> {
    let own = |s: &Signal| [&m.speed, &m.position].into_iter().flatten().any(|n| *n == s.name);
    // its own square is a damping or a stiffness, the square of an input has a name of its own, and of squares of states
    // only that of a speed acts: the centrifugal force
    let is_square = a.name == b.name;
    if is_square && (own(a) || a.kind == SignalKind::Input || !edit::is_rate(&a.unit)) {
        return None;
    }
    let rate = &scene.model.states.iter().find(|s| s.name == m.state)?.rate;
    let both = |t: &crate::expression::Expr| has_factor(t, &a.name) && has_factor(t, &b.name);
    if a.name != b.name && edit::terms_of(scene.model, edit::sum_of(scene.model, rate)).iter().any(both) {
        return None;
    }
    let mut d = Draft::at(scene, "product-coupling", m);
    let unit = m.force.over(&scene.unit(&a.name).times(&scene.unit(&b.name)));
    let c = d.amplitude("c", &unit, ANY, "coupling");
    d.uses(&a.name);
    d.uses(&b.name);
    d.force(&m.state, &format!("{c}*{}*{}", a.name, b.name));
    d.start(&[m.size / (a.size() * b.size())]);
    d.done(&format!(
        "{} times {} acts on {}, {{0}}",
        scene.words(&a.name),
        scene.words(&b.name),
        scene.words(&m.state)
    ))
}
