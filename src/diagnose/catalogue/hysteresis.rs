//! # What it is
//! A spring in series with a slipping joint: rubber, wire rope, wound cable, presliding friction.
//!
//! # Signature in a recording
//! A loop of force against position that does not depend on speed; loss in proportion to amplitude
//! beyond the slip.
//!
//! # Equation
//! ```text
//!     M v' = … - kz z,  z = hysteresis(q, gap): follows q, held within gap/2
//!     z' = q' - |q'| z/z0                       as Dahl has it: the slip comes by and by
//!     y = … + kz z                              of a reading or a voltage, either way
//! ```
//!
//! # What else looks like this
//! dry-friction (a stiff one), backlash, extra-lag (whose loop depends on speed).
//!
//! # Reference
//! Y.-K. Wen, Method for random vibration of hysteretic systems, ASCE J. Eng. Mech. 102 (1976) 249;
//! P. R. Dahl, Aerospace Corp. TOR-158 (1968).
//!
//! # Example
//! An instrument hung on wire-rope isolators; the voltage of a cell, which is another while it charges.

use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY,
    draft::POSITIVE, edit,
};
use crate::expression::Expr;
use crate::model::{Initial, Output};
use crate::units::Unit;

/// An elastic part that slips.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "hysteresis",
    "an elastic part that slips",
    Group::Force,
    include_str!("hysteresis.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let mut all: Vec<Proposal> = Vec::new();
    for m in scene.motions() {
        all.extend([at(scene, &m), by_and_by(scene, &m)].into_iter().flatten());
    }
    all.extend(scene.moving(&[SignalKind::Input]).filter_map(|u| fed(scene, u)));
    // what gives a state as it is errs by a gap, if at all
    for o in scene.model.outputs.iter().filter(|o| !matches!(o.equals, Expr::Name(_))) {
        let behind = scene.model.states.iter().filter(|s| edit::reaches(scene.model, &o.equals, &s.name));
        all.extend(behind.flat_map(|s| read(scene, o, &s.name)));
    }
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let signal = scene.signal(q)?;
    let mut d = Draft::at(scene, "hysteresis", m);
    let k = d.amplitude("kz", &m.force.over(&signal.unit), POSITIVE, "stiffness of the slipping part");
    let range = signal.max - signal.min;
    let gap = d.parameter("gap", &signal.unit, (1e-4 * range, range), "width of the loop");
    d.force(&m.state, &format!("-{k}*hysteresis({q}, {gap})"));
    for fraction in [0.1, 0.5] {
        d.start(&[m.size / (fraction * signal.spread), fraction * 2.0 * signal.spread]);
    }
    d.done(&format!("a part of stiffness {{0}} gives with {} and slips beyond {{1}}", scene.words(q)))
}

/// A part that gives with a state and slips by and by: `act` puts its deflection z into the model, and
/// z' = q' - |q'| z/z0.
fn dahl(d: &mut Draft, scene: &Scene, q: &str, act: impl FnOnce(&mut Draft, &str)) -> Option<()> {
    let signal = scene.signal(q)?;
    let range = signal.max - signal.min;
    let unit = scene.unit(q);
    let slips = d.parameter("z0", &unit, (1e-4 * range, range), "deflection at which it slips");
    let z = d.state("z_slip", &unit, Initial::Fit, "deflection of the slipping part");
    act(d, &z);
    let rate = d.rate_of(q);
    d.rate(&z, &format!("{rate} - abs{rate}*{z}/{slips}"));
    Some(())
}

fn by_and_by(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref().filter(|_| m.speed.is_some())?;
    let mut d = Draft::at(scene, "hysteresis", m);
    let k = d.amplitude("kz", &m.force.over(&scene.unit(q)), POSITIVE, "stiffness of the slipping part");
    dahl(&mut d, scene, q, |d, z| d.force(&m.state, &format!("-{k}*{z}")))?;
    let spread = scene.signal(q)?.spread;
    for fraction in [0.1, 0.5] {
        d.start(&[m.size / (fraction * spread), fraction * spread]);
    }
    d.done(&format!("a part of stiffness {{0}} gives with {} and slips by and by, at {{1}}", scene.words(q)))
}

/// A loop of an output over a state.
fn read(scene: &Scene, o: &Output, q: &str) -> Vec<Proposal> {
    let loops = |slips: bool| {
        let (signal, own) = (scene.signal(q)?, scene.signal(&o.name)?);
        let mut d = Draft::new(scene, "hysteresis", SiteKind::Output, &o.name);
        let unit = scene.unit(&o.name).over(&scene.unit(q));
        let k = d.amplitude("kz", &unit, ANY, "height of the loop over its width");
        let range = signal.max - signal.min;
        if slips {
            dahl(&mut d, scene, q, |d, z| d.output(&o.name, &format!("{{}} + {k}*{z}")))?;
        } else {
            let gap = d.parameter("gap", &signal.unit, (1e-4 * range, range), "width of the loop");
            d.output(&o.name, &format!("{{}} + {k}*hysteresis({q}, {gap})"));
        }
        for fraction in [0.1, 0.5] {
            let width = if slips { fraction } else { 2.0 * fraction } * signal.spread;
            d.start(&[0.1 * own.spread / signal.spread, width]);
        }
        d.done(&format!("{} runs in a loop over {} of width {{1}}", scene.words(&o.name), scene.words(q)))
    };
    [false, true].into_iter().filter_map(loops).collect()
}

fn fed(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "hysteresis", SiteKind::Input, &u.name);
    let a = d.amplitude("a", &Unit::one(), ANY, "share of the loop");
    let range = u.max - u.min;
    let gap = d.parameter("gap", &u.unit, (1e-4 * range, range), "width of the loop");
    let name = &u.name;
    d.replace(name, &format!("({name} + {a}*hysteresis({name}, {gap}))"), |_| true);
    for fraction in [0.2, 0.7] {
        d.start(&[1.0, fraction * 2.0 * u.spread]);
    }
    d.done(&format!("what acts for {} runs in a loop of width {{1}}", scene.words(name)))
}
