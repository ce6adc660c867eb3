//! # What it is
//! A liquid leaves through an opening with the root of its level (Torricelli), a gas with that of
//! the pressure.
//!
//! # Signature in a recording
//! High levels fall more slowly, low ones faster than a linear outflow says; time constants grow
//! with the level.
//!
//! # Equation
//! ```text
//!     s -> sqrt(max(s, 0) s_ref)  wherever s drives a flow;  s_ref is only a scale
//!     C s' = … - k sqrt(max(s - a, 0)),  a: nothing, or a known or recorded level outside
//! ```
//!
//! # What else looks like this
//! parameter-dependence on the level; cubic-stiffness (softening) over a narrow range.
//!
//! # Reference
//! E. Torricelli, De motu gravium (1643); M. Schoukens et al., Cascaded tanks benchmark (2016).
//!
//! # Example
//! Two tanks above each other, modelled with linear outflow.

use super::draft::POSITIVE;
use super::scene::is_temperature;
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, edit::Place};
use crate::units::Unit;

/// Flow with the root of the level.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "square-root-flow",
    "flow with the root of the level",
    Group::Flow,
    include_str!("square_root_flow.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let levels: Vec<&Motion> = motions.iter().filter(|m| is_level(scene, m)).collect();
    let mut all: Vec<Proposal> = levels.iter().filter_map(|m| at(scene, &[m])).collect();
    if levels.len() > 1 {
        all.extend(at(scene, &levels));
    }
    for m in &levels {
        all.extend(outside(scene, m).iter().filter_map(|o| leak(scene, m, o.as_deref())));
    }
    all
}

/// What may stand outside a level: nothing, or what has its unit and is lower on the whole.
fn outside(scene: &Scene, m: &Motion) -> Vec<Option<String>> {
    let Some(level) = scene.signal(&m.state) else { return Vec::new() };
    let is = |unit: &Unit| unit.dimension() == level.unit.dimension();
    let known = &scene.model.parameters[..scene.own_parameters];
    let known = known.iter().filter(|p| !p.fit && is(&p.unit) && p.value > 0.0 && p.value < level.mean);
    let recorded = scene.moving(&[SignalKind::Input, SignalKind::Channel]);
    let recorded = recorded.filter(|s| is(&s.unit) && s.mean < level.mean);
    let names = known.map(|p| p.name.clone()).chain(recorded.map(|s| s.name.clone()));
    std::iter::once(None).chain(names.map(Some)).collect()
}

/// An opening that the model does not have.
fn leak(scene: &Scene, m: &Motion, outside: Option<&str>) -> Option<Proposal> {
    let (s, level) = (&m.state, scene.signal(&m.state)?);
    let mut d = Draft::at(scene, "square-root-flow", m);
    let unit = level.unit.of_differences();
    let k = d.amplitude("k", &m.force.over(&unit.power(0.5)), POSITIVE, "flow for a root of the level");
    let above = outside.map_or_else(|| s.clone(), |o| format!("({s} - {o})"));
    d.uses(s);
    if let Some(o) = outside {
        d.uses(o);
    }
    d.force(s, &format!("-{k}*sqrt(max({above}, 0*{above}))"));
    d.start(&[0.3 * m.size / scene.size(s).sqrt()]);
    let over = outside.map_or_else(String::new, |o| format!(" less {}", scene.words(o)));
    let s = scene.words(s);
    d.done(&format!("{s} leaks with the root of {s}{over}, by {{0}}"))
}

/// What flows by its own head: a temperature makes none.
fn is_level(scene: &Scene, m: &Motion) -> bool {
    let mostly_positive = |s: &Signal| s.mean > 0.5 * s.spread && s.max > 0.0 && !is_temperature(&s.unit);
    m.speed.is_none() && scene.signal(&m.state).is_some_and(mostly_positive)
}

fn at(scene: &Scene, levels: &[&Motion]) -> Option<Proposal> {
    let mut d = Draft::at(scene, "square-root-flow", levels.last()?);
    let mut laws = Vec::new();
    for m in levels {
        let s = &m.state;
        let signal = scene.signal(s)?;
        let scale =
            d.constant(&format!("{s}_ref"), &signal.unit, signal.max, "scale of the level, not fitted");
        d.replace(s, &format!("sqrt(max({s}, 0*{scale})*{scale})"), |p| !matches!(p, Place::Output(_)));
        laws.push(format!("sqrt({s}*{scale}) stands for {s}"));
    }
    d.start(&[]);
    let names: Vec<String> = levels.iter().map(|m| scene.words(&m.state)).collect();
    d.done(&format!("the flow goes with the root of {}: {}", names.join(" and of "), laws.join(", ")))
}
