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
//!     v' = … + c w^2 r        the centrifugal force at a place r of what turns at w, where the model has no such turn
//!     J w' = … + c a b         a, b recorded and not in the model: the turns about the other two axes of a body
//!     J1 w1' = … + c h w2,  J2 w2' = … - c h w1      two axes of a body whose rotor turns at h
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

use crate::expression::{BinaryOp, Expr};
use crate::units::Unit;

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
/// The same of recorded channels that the model does not use.
const FEW: usize = 5;

fn propose(scene: &Scene) -> Vec<Proposal> {
    let signals: Vec<&Signal> =
        scene.moving(&[SignalKind::State, SignalKind::Input]).filter(|s| !s.is_heading()).collect();
    if signals.len() > MANY {
        return Vec::new();
    }
    let beside = unused(scene);
    let mut all = Vec::new();
    for m in scene.motions() {
        let levers = levers(scene, &m);
        for (i, a) in signals.iter().enumerate() {
            all.extend(signals[i..].iter().flat_map(|b| acting(scene, &m, [a, b], &levers)));
        }
        all.extend(scaled(scene, &m).into_iter().flat_map(|(a, b)| acting(scene, &m, [a, b], &levers)));
        all.extend(turning(scene, &signals).flat_map(|(a, b)| acting(scene, &m, [a, b], &levers)));
        all.extend(beside.iter().flat_map(|(a, b)| acting(scene, &m, [a, b], &levers)));
    }
    all.extend(gyroscopic(scene, &signals));
    all.extend(centrifugal(scene, &signals));
    all
}

/// What moves along a radius of what turns: speeds among states, inputs and recorded channels, each squared, times a place.
fn centrifugal(scene: &Scene, signals: &[&Signal]) -> Vec<Proposal> {
    let channels: Vec<&Signal> = scene.moving(&[SignalKind::Channel]).collect();
    let turns: Vec<&&Signal> =
        signals.iter().chain(&channels).filter(|s| edit::is_frequency(&s.unit)).collect();
    let of = |m: &Motion| turns.iter().filter_map(|w| outward(scene, m, w)).collect::<Vec<_>>();
    scene.motions().iter().filter(|m| m.speed.as_ref() == Some(&m.state)).flat_map(of).collect()
}

fn outward(scene: &Scene, m: &Motion, turn: &Signal) -> Option<Proposal> {
    let (w, r) = (&turn.name, scene.signal(m.position.as_ref()?)?);
    if m.speed.as_ref() == Some(w) {
        return None;
    }
    let mut d = Draft::at(scene, "product-coupling", m);
    let unit = m.force.over(&turn.unit.power(2.0).times(&scene.unit(&r.name)));
    let c = d.amplitude("c", &unit, ANY, "what moves outward");
    d.uses(w);
    d.uses(&r.name);
    d.force(&m.state, &format!("{c}*{w}^2*{}", r.name));
    d.start(&[m.size / (turn.size().powi(2) * r.size())]);
    let (w, r, state) = (scene.words(w), scene.words(&r.name), scene.words(&m.state));
    d.done(&format!("the square of {w} times {r} acts on {state}, as a centrifugal force does, {{0}}"))
}

/// Speeds with recorded channels that the model does not use, as that of a rotor may be.
fn turning<'s>(scene: &'s Scene, signals: &'s [&Signal]) -> impl Iterator<Item = (&'s Signal, &'s Signal)> {
    let speeds = signals.iter().copied().filter(|s| s.kind == SignalKind::State && edit::is_rate(&s.unit));
    let channels: Vec<&Signal> =
        scene.moving(&[SignalKind::Channel]).filter(|c| edit::is_rate(&c.unit)).collect();
    speeds.flat_map(move |s| channels.clone().into_iter().map(move |c| (s, c)))
}

/// Pairs of recorded channels that the model does not use, as the turns about the other two axes of a body.
fn unused<'s>(scene: &'s Scene) -> Vec<(&'s Signal, &'s Signal)> {
    let channels: Vec<&Signal> = scene.moving(&[SignalKind::Channel]).filter(|c| !c.is_heading()).collect();
    if channels.len() > FEW {
        return Vec::new();
    }
    let with_later =
        |(i, a): (usize, &&'s Signal)| channels[i + 1..].iter().map(|b| (*a, *b)).collect::<Vec<_>>();
    channels.iter().enumerate().flat_map(with_later).collect()
}

/// A state in its own rate with recorded channels that turn about 0 and that the model does not use. Where a fitted factor
/// multiplies the state, that factor varies with the channel; a time constant T, which divides it, cannot change its sign.
fn scaled<'s>(scene: &'s Scene, m: &Motion) -> Vec<(&'s Signal, &'s Signal)> {
    let Some(own) = scene.signal(&m.state).filter(|s| !edit::is_rate(&s.unit) && !s.is_heading()) else {
        return Vec::new();
    };
    let rate = scene.model.states.iter().find(|s| s.name == m.state).map(|s| &s.rate);
    let laws = rate.map(|r| edit::laws_of(scene.model, edit::sum_of(scene.model, r))).unwrap_or_default();
    let is_fitted = |t: &Expr| scene.model.parameters.iter().any(|p| p.fit && has_factor(t, &p.name));
    if laws.iter().any(|t| t.mentions(&own.name) && is_fitted(t)) {
        return Vec::new();
    }
    let is_unused = |c: &&Signal| rate.is_some_and(|r| !edit::reaches(scene.model, r, &c.name));
    let channels =
        scene.moving(&[SignalKind::Channel]).filter(|c| c.mean.abs() < c.spread && !c.is_heading());
    channels.filter(is_unused).map(|c| (own, c)).collect()
}

/// A rotor's moments on two axes, each by the speed of the other, of one size and opposite signs.
fn gyroscopic(scene: &Scene, signals: &[&Signal]) -> Vec<Proposal> {
    let motions: Vec<Motion> = scene.motions().into_iter().filter(|m| m.speed.is_some()).collect();
    let rotors: Vec<&Signal> = scene
        .moving(&[SignalKind::Channel, SignalKind::Input])
        .filter(|r| edit::is_rate(&r.unit) && !r.is_heading())
        .collect();
    if signals.len() > MANY {
        return Vec::new();
    }
    let mut all = Vec::new();
    for (i, m) in motions.iter().enumerate() {
        let alike = |n: &&Motion| {
            let of = |x: &Motion| (x.force.dimension(), scene.unit(&x.state).dimension());
            of(n) == of(m)
        };
        for n in motions[i + 1..].iter().filter(alike) {
            all.extend(rotors.iter().filter_map(|r| pair(scene, [m, n], r)));
        }
    }
    all
}

fn pair(scene: &Scene, [m, n]: [&Motion; 2], rotor: &Signal) -> Option<Proposal> {
    let (x, y, h) = (&m.state, &n.state, &rotor.name);
    let mut d = Draft::at(scene, "product-coupling", m);
    let unit = m.force.over(&scene.unit(x).times(&scene.unit(h)));
    let c = d.amplitude("c", &unit, ANY, "what the rotor's speed is multiplied with");
    d.uses(h);
    d.uses(y);
    d.force(x, &format!("{c}*{h}*{y}"));
    d.force(y, &format!("-{c}*{h}*{x}"));
    d.start(&[m.size.max(n.size) / (rotor.size() * scene.size(x).max(scene.size(y)))]);
    d.done(&format!(
        "a rotor that turns with {} acts on {} by {} and back, {{0}}",
        scene.words(h),
        scene.words(x),
        scene.words(y)
    ))
}

/// A product as it is, and over whatever moves under the terms of that rate, as a length that changes.
fn acting(scene: &Scene, m: &Motion, [a, b]: [&Signal; 2], levers: &[Expr]) -> Vec<Proposal> {
    let over = std::iter::once(None).chain(levers.iter().map(Some));
    over.filter_map(|lever| at(scene, m, a, b, lever)).collect()
}

/// What the terms of a rate are divided by, where it moves.
fn levers(scene: &Scene, m: &Motion) -> Vec<Expr> {
    let Some(state) = scene.model.states.iter().find(|s| s.name == m.state) else { return Vec::new() };
    let moves = |e: &Expr| scene.signals.iter().any(|s| edit::reaches(scene.model, e, &s.name));
    let mut all: Vec<Expr> = Vec::new();
    for term in edit::terms_of(scene.model, edit::sum_of(scene.model, &state.rate)) {
        if let Expr::Binary(BinaryOp::Div, _, under) = term
            && moves(&under)
            && !all.contains(&under)
        {
            all.push(*under);
        }
    }
    all
}

fn at(scene: &Scene, m: &Motion, a: &Signal, b: &Signal, lever: Option<&Expr>) -> Option<Proposal> {
    let own = |s: &Signal| [&m.speed, &m.position].into_iter().flatten().any(|n| *n == s.name);
    // its own square is a damping or a stiffness, the square of an input has a name of its own, and of squares of states
    // only that of a speed acts: the centrifugal force
    let is_square = a.name == b.name;
    if is_square && (own(a) || a.kind == SignalKind::Input || !edit::is_rate(&a.unit)) {
        return None;
    }
    let rate = &scene.model.states.iter().find(|s| s.name == m.state)?.rate;
    let both = |t: &Expr| has_factor(t, &a.name) && has_factor(t, &b.name);
    if a.name != b.name && edit::laws_of(scene.model, edit::sum_of(scene.model, rate)).iter().any(both) {
        return None;
    }
    let mut d = Draft::at(scene, "product-coupling", m);
    let product = scene.unit(&a.name).times(&scene.unit(&b.name));
    let (per, size, over) = match lever {
        None => (Unit::one(), 1.0, String::new()),
        Some(l) => (scene.unit_of(l), scene.size_of(l), format!("/({l})")),
    };
    let c = d.amplitude("c", &m.force.times(&per).over(&product), ANY, "coupling");
    d.uses(&a.name);
    d.uses(&b.name);
    d.force(&m.state, &format!("{c}*{}*{}{over}", a.name, b.name));
    d.start(&[m.size * size / (a.size() * b.size())]);
    d.done(&format!(
        "{} times {}{over} acts on {}, {{0}}",
        scene.words(&a.name),
        scene.words(&b.name),
        scene.words(&m.state)
    ))
}
