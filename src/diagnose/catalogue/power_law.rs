//! # What it is
//! A loss, a drag or a flow with a power of its own, where the model has it in proportion: turbulent and free
//! convection, openings, worn seals, reactions of an order between.
//!
//! # Signature in a recording
//! The residual bends against the speed, the level or the difference that drives it, the same way on both sides of 0.
//!
//! # Equation
//! ```text
//!     c x -> c x |x/r|^p      where c x stands in a rate; p = 0 is the law in proportion, r only a scale
//! ```
//!
//! # What else looks like this
//! quadratic-damping (p = 1), cubic-damping (p = 2), square-root-flow (p = -1/2), saturable-rate; a parameter that depends
//! on the same signal.
//!
//! # Reference
//! F. P. Incropera, D. P. DeWitt, Fundamentals of Heat and Mass Transfer, 6th ed. (2006), ch. 9; O. Levenspiel, Chemical
//! Reaction Engineering, 3rd ed. (1999), ch. 3.
//!
//! # Example
//! A wall whose free convection grows with the 5/4th power of the difference of temperatures.

use super::terms::{factors, rewritten, with_factor};
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::Limits, edit};
use crate::expression::{BinaryOp, Expr};
use crate::units::Unit;

/// A law with a power of its own.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "power-law",
    "a loss, drag or flow with a power of its own",
    Group::Friction,
    include_str!("power_law.rs"),
    propose,
);

/// Powers beside the first: below them it is dry friction.
const POWERS: Limits = (-0.7, 3.0);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = Vec::new();
    for m in scene.motions() {
        let rate = scene.model.states.iter().find(|s| s.name == m.state).map(|s| &s.rate);
        let terms =
            rate.map(|r| edit::terms_of(scene.model, edit::sum_of(scene.model, r))).unwrap_or_default();
        for term in &terms {
            let driver = driver(scene, &m, term);
            all.extend(driver.and_then(|x| at(scene, &m, term, &x)));
        }
    }
    all.dedup_by(|a, b| a.term == b.term);
    all
}

/// What drives a term c·x in proportion: the state's own speed or level, or a difference with it; all other factors are
/// parameters.
fn driver(scene: &Scene, m: &Motion, term: &Expr) -> Option<Expr> {
    let own = m.speed.as_ref().unwrap_or(&m.state);
    let is_parameter = |e: &Expr| {
        matches!(e, Expr::Number(_))
            || matches!(e, Expr::Name(n) if scene.model.parameters.iter().any(|p| p.name == *n))
    };
    let (known, others): (Vec<&Expr>, Vec<&Expr>) = factors(term).into_iter().partition(|f| is_parameter(f));
    let [x] = others[..] else { return None };
    let is_difference = |x: &Expr| {
        let Expr::Binary(BinaryOp::Sub, a, b) = x else { return false };
        [a, b].into_iter().all(|e| matches!(**e, Expr::Name(_)))
    };
    let fits = *x == Expr::name(own) || is_difference(x) && x.mentions(own);
    (fits && !known.is_empty()).then(|| x.clone())
}

fn at(scene: &Scene, m: &Motion, term: &Expr, x: &Expr) -> Option<Proposal> {
    let size = x.value(&|n| scene.signal(n).map(|s| s.mean).or_else(|| parameter(scene, n)))?;
    let spread = scene.signal(m.speed.as_ref().unwrap_or(&m.state))?.spread;
    let mut d = Draft::at(scene, "power-law", m);
    let unit = scene.unit_of(x);
    let scale = d.constant("r_ref", &unit, size.hypot(spread), "scale of the power law, not fitted");
    let p = d.amplitude("p", &Unit::one(), POWERS, "power beside the first");
    let new = Expr::parse(&format!("({x})*(abs(({x})/{scale}) + 1e-6)^{p}")).ok()?;
    d.each_rate(&|e| rewritten(e, &|t| (t == term).then(|| with_factor(t, x, &new))));
    d.term(&with_factor(term, x, &new).to_string());
    for start in [0.5, -0.4] {
        d.start(&[start]);
    }
    let words = if let Expr::Name(n) = x { scene.words(n) } else { x.to_string() };
    d.done(&format!("{term} goes with a power of {words}, {{0}} beside the first"))
}

fn parameter(scene: &Scene, name: &str) -> Option<f64> {
    scene.model.parameters.iter().find(|p| p.name == name).map(|p| p.value)
}
