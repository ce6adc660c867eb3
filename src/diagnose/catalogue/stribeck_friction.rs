//! # What it is
//! Dry friction that falls from its break-away value to a smaller one as a lubricating film builds
//! up.
//!
//! # Signature in a recording
//! Stick and slip at low speed; the residual force has a peak on both sides of zero speed.
//!
//! # Equation
//! ```text
//!     M v' = … - (Fc + Fs exp(-(v/vs)^2)) sign(v),  Fc, Fs >= 0
//! ```
//!
//! # What else looks like this
//! dry-friction (no peak), quadratic-damping with dry friction; they part at very low speed.
//!
//! # Reference
//! B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, A survey of models of friction, Automatica
//! 30 (1994) 1083.
//!
//! # Example
//! A rudder actuator that creeps in jerks when moved slowly.

use super::terms::{factors, has_factor, rewritten, with_factor};
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE, edit};
use crate::expression::{Expr, Function};

/// Dry friction that is larger near rest.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "stribeck-friction",
    "dry friction that is larger near rest",
    Group::Friction,
    include_str!("stribeck_friction.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let mut all: Vec<Proposal> = motions.iter().filter_map(|m| at(scene, m)).collect();
    let names = scene.acting_parameters();
    let pairs = motions.iter().flat_map(|m| names.iter().map(move |p| (m, p)));
    all.extend(pairs.filter_map(|(m, p)| beside(scene, m, p)));
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let mut d = Draft::at(scene, "stribeck-friction", m);
    let c = d.amplitude("Fc", &m.force, POSITIVE, "dry friction in fast motion");
    let s = d.amplitude("Fs", &m.force, POSITIVE, "excess of the friction near rest");
    let size = scene.size(v);
    let vs =
        d.parameter("vs", &scene.unit(v), (1e-3 * size, 3.0 * size), "speed at which the excess is gone");
    d.force(&m.state, &format!("-({c} + {s}*exp(-({v}/{vs})^2))*sign({v})"));
    for fraction in [0.1, 0.4] {
        d.start(&[m.size, m.size, fraction * size]);
    }
    d.done(&format!("dry friction against {} is {{0}} and by {{1}} more below {{2}}", scene.words(v)))
}

/// The excess of a friction that the model has already: a parameter times the sign of the speed, smoothed or not.
fn beside(scene: &Scene, m: &Motion, p: &str) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let model = scene.model;
    let is_sign = |f: &&Expr| matches!(f, Expr::Call(Function::Sign | Function::Tanh, a) if a[0].mentions(v));
    let rubs = |t: &Expr| has_factor(t, p) && factors(t).iter().any(is_sign);
    let rate = &model.states.iter().find(|s| s.name == m.state)?.rate;
    let unit = scene.unit_of(&Expr::name(p));
    if unit.dimension() != m.force.dimension()
        || !edit::terms_of(model, edit::sum_of(model, rate)).iter().any(rubs)
    {
        return None;
    }
    let mut d = Draft::at(scene, "stribeck-friction", m);
    let s = d.amplitude("Fs", &unit, POSITIVE, "excess of the friction near rest");
    let size = scene.size(v);
    let vs =
        d.parameter("vs", &scene.unit(v), (1e-3 * size, 3.0 * size), "speed at which the excess is gone");
    let law = format!("({p} + {s}*exp(-({v}/{vs})^2))");
    let (own, new) = (Expr::name(p), Expr::parse(&law).ok()?);
    d.each(&|e| rewritten(e, &|t| rubs(t).then(|| with_factor(t, &own, &new))));
    d.uses(v);
    d.term(&law);
    for fraction in [0.1, 0.4] {
        d.start(&[m.size, fraction * size]);
    }
    d.done(&format!("dry friction against {} is {{0}} more than {p} below {{1}}", scene.words(v)))
}
