//! # What it is
//! A loss, a drag or a flow with a power of its own, where the model has it in proportion: turbulent and free
//! convection, openings, worn seals, reactions of an order between.
//!
//! # Signature in a recording
//! The residual bends against the speed, the level or the difference that drives it, the same way on both sides of 0.
//!
//! # Equation
//! ```text
//!     c x -> c x |x/r|^p      where c x stands in a rate, or c x |x|, c x², c sqrt(x); at p = 0 it is that law, r is a scale
//!     s' = … - c x |x/r|^p    where no law of the speed or the level x stands, or beside a steep one
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
use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, draft::Limits, draft::POSITIVE, edit, edit::Place,
};
use crate::expression::{BinaryOp, Expr, Function};
use crate::units::Unit;

/// A law with a power of its own.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "power-law",
    "a loss, drag or flow with a power of its own",
    Group::Friction,
    include_str!("power_law.rs"),
    propose,
);

/// Powers: below them it is dry friction.
const POWERS: Limits = (0.3, 6.0);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = Vec::new();
    for m in scene.motions() {
        let rate = scene.model.states.iter().find(|s| s.name == m.state).map(|s| &s.rate);
        let own = m.speed.as_ref().unwrap_or(&m.state);
        let terms = rate.map(|r| terms(scene, own, r)).unwrap_or_default();
        let drivers: Vec<(&Expr, Driver)> =
            terms.iter().filter_map(|t| Some((t, driver(scene, own, t)?))).collect();
        all.extend(drivers.iter().filter_map(|(term, x)| at(scene, &m, term, x)));
        // beside what is in proportion the laws of whole powers have fewer parameters
        let is_steep = |(_, d): &(&Expr, Driver)| d.x == Expr::name(own) && d.power > 1.0;
        if drivers.iter().any(is_steep) || !terms.iter().any(|t| t.mentions(own)) {
            all.extend(alone(scene, &m, own));
        }
    }
    all.dedup_by(|a, b| a.term == b.term);
    all
}

/// The laws of a rate of a speed or level: the terms of its sum, and the differences with it in that.
fn terms(scene: &Scene, own: &str, rate: &Expr) -> Vec<Expr> {
    let (whole, sum) = (edit::opened(scene.model, rate), edit::sum_of(scene.model, rate));
    let is_difference = |e: &Expr| is_difference(scene, e, own);
    let mut within = Vec::new();
    differences(sum, &is_difference, &mut within);
    let mut all = edit::laws_of(scene.model, sum);
    // a level by itself may have the power where a gain makes up for its scale
    let is_scaled = |d: &Expr| matches!(d, Expr::Binary(_, a, b) if factors(a).len() + factors(b).len() > 2);
    let is_part = |n: &str| within.iter().any(|d| !is_scaled(d) && edit::reaches(scene.model, d, n));
    all.retain(|t| !matches!(t, Expr::Name(n) if is_part(n)));
    if is_difference(sum) {
        within = vec![whole.clone()];
    }
    all.extend(within);
    all
}

/// Whether an expression, or the definition that it names, is the difference of a speed or level and one signal, which
/// parameters may multiply.
fn is_difference(scene: &Scene, e: &Expr, own: &str) -> bool {
    let (a, b) = match e {
        Expr::Binary(BinaryOp::Sub, a, b) => (&**a, &**b),
        Expr::Name(n) => {
            let defined = scene.model.definitions.iter().find(|d| d.name == *n);
            return defined.is_some_and(|d| is_difference(scene, &d.equals, own));
        }
        _ => return false,
    };
    let other = if *a == Expr::name(own) { b } else { a };
    let is_signal = |f: &&&Expr| matches!(f, Expr::Name(n) if parameter(scene, n).is_none());
    let parts = factors(other);
    let is_known = |f: &&Expr| matches!(f, Expr::Number(_) | Expr::Name(_));
    [a, b].contains(&&Expr::name(own))
        && parts.iter().all(is_known)
        && (parts.iter().filter(is_signal).count() == 1 || parts.len() == 1)
}

/// The differences that are terms of a sum.
fn differences(sum: &Expr, is_difference: &dyn Fn(&Expr) -> bool, all: &mut Vec<Expr>) {
    match sum {
        e if is_difference(e) => all.push(e.clone()),
        Expr::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
            differences(a, is_difference, all);
            differences(b, is_difference, all);
        }
        Expr::Neg(a) => differences(a, is_difference, all),
        _ => {}
    }
}

/// A law of a power: its argument, the factor in which that stands, and the power that it has.
struct Driver {
    x: Expr,
    factor: Expr,
    power: f64,
}

/// x, and the power with which it stands in a factor.
fn powered(factor: &Expr) -> (&Expr, f64) {
    match factor {
        Expr::Binary(BinaryOp::Pow, a, b) => match &**b {
            Expr::Number(p) => (a, *p),
            _ => (factor, 1.0),
        },
        Expr::Call(Function::Sqrt, a) => (&a[0], 0.5),
        Expr::Call(Function::Abs, a) => (&a[0], 1.0),
        _ => (factor, 1.0),
    }
}

/// What drives a term c·x, c·x·|x| or the like: the state's own speed or level, or a difference with it; all other factors
/// are parameters.
fn driver(scene: &Scene, own: &str, term: &Expr) -> Option<Driver> {
    let is_parameter = |e: &Expr| {
        matches!(e, Expr::Number(_)) || matches!(e, Expr::Name(n) if parameter(scene, n).is_some())
    };
    let others: Vec<&Expr> = factors(term).into_iter().filter(|f| !is_parameter(f)).collect();
    let x = powered(others.first()?).0;
    if others.iter().any(|f| powered(f).0 != x) {
        return None;
    }
    // the root of a difference, rounded where that is 0, as a flow between two levels has it
    let is_root = |e: &Expr| matches!(e, Expr::Call(Function::Sqrt, _)) && edit::is_plainly_in(e, own);
    if !is_root(others[0]) && edit::find(term, &is_root).is_some() {
        return None;
    }
    let power = others.iter().map(|f| powered(f).1).sum();
    let fits = *x == Expr::name(own) || is_difference(scene, x, own);
    fits.then(|| Driver { x: x.clone(), factor: others[0].clone(), power })
}

fn at(scene: &Scene, m: &Motion, term: &Expr, driver: &Driver) -> Option<Proposal> {
    let Driver { x, factor, power } = driver;
    let size = x.value(&|n| scene.signal(n).map(|s| s.mean).or_else(|| parameter(scene, n)))?;
    let spread = scene.signal(m.speed.as_ref().unwrap_or(&m.state))?.spread;
    let mut d = Draft::at(scene, "power-law", m);
    let unit = scene.unit_of(x);
    let scale = d.constant("r_ref", &unit, size.hypot(spread), "scale of the power law, not fitted");
    let limits = (POWERS.0 - power, POWERS.1 - power);
    let p = d.amplitude("p", &Unit::one(), limits, "power beside that of the model");
    let new = Expr::parse(&format!("({factor})*(abs(({x})/{scale}) + 1e-6)^{p}")).ok()?;
    let with = |e: &Expr| rewritten(e, &|t| (t == term).then(|| with_factor(t, factor, &new)));
    if term == factor {
        let rate = scene.model.states.iter().find(|s| s.name == m.state).map(|s| &s.rate)?;
        let home = edit::home(scene.model, rate).map(|i| &scene.model.definitions[i].name);
        d.each_where(&with, &|p| home.map_or(p == Place::Rate(&m.state), |n| p == Place::Definition(n)));
    } else {
        d.each(&with);
    }
    d.term(&with_factor(term, factor, &new).to_string());
    for start in [0.5, -0.4] {
        d.start(&[start]);
    }
    let words = if let Expr::Name(n) = x { scene.words(n) } else { x.to_string() };
    let beside = match *power {
        1.0 => "the first".to_owned(),
        2.0 => "the second".to_owned(),
        power => power.to_string(),
    };
    d.done(&format!("{term} goes with a power of {words}, {{0}} beside {beside}"))
}

/// A law of its own where the model has none, or beside one of another power above 1.
fn alone(scene: &Scene, m: &Motion, x: &str) -> Option<Proposal> {
    let size = scene.size(x);
    let mut d = Draft::at(scene, "power-law", m);
    let c = d.amplitude("c", &m.force.over(&scene.unit(x)), POSITIVE, "size of the law at its scale");
    let p = d.parameter("p", &Unit::one(), (POWERS.0 - 1.0, POWERS.1 - 1.0), "power beside the first");
    let scale = d.constant("r_ref", &scene.unit(x), size, "scale of the power law, not fitted");
    d.uses(x);
    d.force(&m.state, &format!("-{c}*{x}*(abs({x}/{scale}) + 1e-6)^{p}"));
    for start in [-0.5, 0.0, 1.0, 3.0] {
        d.start(&[m.size / size, start]);
    }
    d.done(&format!(
        "a loss or drag of {{0}} at {x} = {scale} goes with a power of {}, {{1}} beside the first",
        scene.words(x)
    ))
}

fn parameter(scene: &Scene, name: &str) -> Option<f64> {
    scene.model.parameters.iter().find(|p| p.name == name).map(|p| p.value)
}
