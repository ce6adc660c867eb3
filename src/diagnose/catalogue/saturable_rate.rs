//! # What it is
//! A rate that cannot grow for ever with what feeds it: enzymes, microbes and catalysts are all taken, a market is
//! served; at still higher levels the feed itself may inhibit. A brake by eddy currents likewise: above a speed its own
//! field weakens it.
//!
//! # Signature in a recording
//! Where the level is high everything that goes with it is slower than a rate in proportion says; with inhibition there
//! is a level of the fastest rate.
//!
//! # Equation
//! ```text
//!     x -> x/(1 + x/K)              wherever a parameter p multiplies x   (Michaelis and Menten, Monod);  a = 1/K
//!     x -> x/(1 + x/K + x²/KK)      with inhibition (Andrews, Haldane);  b = 1/KK
//!     M v' = … - c v/(1 + (v/vk)²)  a drag that is largest at the speed vk
//! ```
//!
//! # What else looks like this
//! parameter-dependence of the same parameter on the level; power-law with a power below one; stribeck-friction where the
//! speed passes quickly through 0.
//!
//! # Reference
//! J. E. Bailey, D. F. Ollis, Biochemical Engineering Fundamentals, 2nd ed. (1986), ch. 3 and 7; J. F. Andrews,
//! Biotechnol. Bioeng. 10 (1968) 707; J. H. Wouterse, IEE Proc. B 138 (1991) 153 on brakes by eddy currents.
//!
//! # Example
//! A drug whose elimination is modelled in proportion to its concentration.

use super::terms::{has_factor, rewritten, with_factor};
use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind, draft::POSITIVE, edit,
};
use crate::expression::Expr;
use crate::units::Unit;

/// A rate that saturates.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "saturable-rate",
    "a rate that saturates with its level",
    Group::Flow,
    include_str!("saturable_rate.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let level = |s: &&Signal| s.mean > 0.5 * s.spread && s.max > 0.0;
    let levels: Vec<&Signal> = scene.moving(&[SignalKind::State, SignalKind::Input]).filter(level).collect();
    let mut all = Vec::new();
    for x in levels {
        for p in &scene.model.parameters {
            all.extend([false, true].into_iter().filter_map(|inhibits| at(scene, &p.name, x, inhibits)));
        }
    }
    all.extend(scene.motions().iter().filter_map(|m| braked(scene, m)));
    all
}

/// A drag that has a largest value at some speed.
fn braked(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let (size, unit) = (scene.size(v), scene.unit(v));
    let mut d = Draft::at(scene, "saturable-rate", m);
    let c = d.amplitude("c", &m.force.over(&unit), POSITIVE, "damping at rest");
    let speed = d.parameter("vk", &unit, (0.02 * size, 10.0 * size), "speed of the largest drag");
    d.uses(v);
    d.force(&m.state, &format!("-{c}*{v}/(1 + ({v}/{speed})^2)"));
    for share in [0.1, 0.2, 0.4, 0.8, 1.6] {
        d.start(&[m.size / size, share * size]);
    }
    d.done(&format!("a drag of {{0}} in slow motion, largest at {{1}}, acts against {}", scene.words(v)))
}

/// The law in every term that a parameter and a level multiply.
fn at(scene: &Scene, p: &str, x: &Signal, inhibits: bool) -> Option<Proposal> {
    let is_own = |t: &Expr| has_factor(t, p) && has_factor(t, &x.name);
    let mut stands = false;
    let mut model = scene.model.clone();
    edit::for_each(&mut model, |place, e| {
        stands |= !matches!(place, edit::Place::Output(_))
            && rewritten(e, &|t| is_own(t).then_some(Expr::Number(1.0))) != *e;
    });
    if !stands {
        return None;
    }
    let mut d = Draft::new(scene, "saturable-rate", SiteKind::Parameter, p);
    let name = &x.name;
    let a = d.amplitude(
        "a",
        &Unit::one().over(&scene.unit(name)),
        POSITIVE,
        "one over the level of half the rate",
    );
    let inhibition = inhibits.then(|| {
        let unit = Unit::one().over(&scene.unit(name).power(2.0));
        d.amplitude("b", &unit, POSITIVE, "one over the square of the level of inhibition")
    });
    let more = inhibition.as_ref().map_or_else(String::new, |b| format!(" + {b}*{name}^2"));
    let text = format!("{name}/(1 + {a}*{name}{more})");
    let new = Expr::parse(&text).ok()?;
    d.uses(name);
    d.each(&|e| rewritten(e, &|t| is_own(t).then(|| with_factor(t, &Expr::name(name), &new))));
    d.term(&format!("{p}*{text}"));
    d.divides(p, x.size());
    let mut start = vec![0.5 / x.size()];
    start.extend(inhibits.then(|| 0.3 / x.size().powi(2)));
    d.start(&start);
    let how = if inhibits { " and is inhibited by it" } else { "" };
    d.done(&format!("what {} makes of {} saturates with it{how}", scene.words(p), scene.words(name)))
}
