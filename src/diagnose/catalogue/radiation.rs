//! # What it is
//! Heat that leaves as radiation: it grows with the fourth power of the absolute temperature.
//!
//! # Signature in a recording
//! The hot end of a heating comes to rest lower, and sooner, than a loss in proportion to the difference says.
//!
//! # Equation
//! ```text
//!     C T' = … - c (T^4 - Ta^4),  c >= 0;  Ta another temperature, or left out
//! ```
//!
//! # What else looks like this
//! power-law, cubic-stiffness and quadratic-damping over a narrow range of temperatures; a conductivity that grows with
//! temperature (parameter-dependence).
//!
//! # Reference
//! F. P. Incropera, D. P. DeWitt, Fundamentals of Heat and Mass Transfer, 6th ed. (2006), ch. 1 and 13.
//!
//! # Example
//! A furnace modelled with a loss in proportion to its temperature.

use super::scene::is_temperature;
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};

/// A loss by radiation.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "radiation",
    "heat that leaves as radiation",
    Group::Flow,
    include_str!("radiation.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let hot = |m: &&Motion| scene.signal(&m.state).is_some_and(|s| is_temperature(&s.unit) && s.min > 0.0);
    let mut all = Vec::new();
    for m in motions.iter().filter(hot) {
        let signals =
            scene.signals.iter().filter(|s| is_temperature(&s.unit) && s.name != m.state && s.mean > 0.0);
        let is_output = |n: &str| scene.model.outputs.iter().any(|o| o.name == n);
        let signals = signals.map(|s| s.name.clone()).filter(|n| !is_output(n));
        let fixed = scene.model.parameters.iter().filter(|p| is_temperature(&p.unit) && p.value > 0.0);
        let around: Vec<Option<String>> = signals.chain(fixed.map(|p| p.name.clone())).map(Some).collect();
        let around = if around.is_empty() { vec![None] } else { around };
        all.extend(around.iter().filter_map(|a| at(scene, m, a.as_deref())));
    }
    all
}

fn at(scene: &Scene, m: &Motion, around: Option<&str>) -> Option<Proposal> {
    let s = &m.state;
    let mut d = Draft::at(scene, "radiation", m);
    let unit = m.force.over(&scene.unit(s).power(4.0));
    let c = d.amplitude("c4", &unit, POSITIVE, "radiating surface times Stefan and Boltzmann's constant");
    let text = match around {
        Some(a) => format!("-{c}*({s}^4 - {a}^4)"),
        None => format!("-{c}*{s}^4"),
    };
    if let Some(a) = around {
        // the state first: it is what the law is drawn along
        d.uses(s);
        d.uses(a);
    }
    d.force(s, &text);
    let signal = scene.signal(s)?;
    d.start(&[m.size / (signal.mean.powi(3) * (signal.mean - signal.min + signal.spread))]);
    d.done(&format!("heat of {} leaves as radiation, {{0}}", scene.words(s)))
}
