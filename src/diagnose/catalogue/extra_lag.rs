//! # What it is
//! A part that follows with a lag of its own: a viscous liquid, creep of a suspension; a second store behind a balance:
//! heat in a wall, a second vessel or compartment, a second RC element.
//!
//! # Signature in a recording
//! A slow tail after each change; stiffness and damping that depend on frequency.
//!
//! # Equation
//! ```text
//!     M v' = … - c (q - lag(q, tau))    or    s -> lag(s, tau)  or  s + c lag(s, tau)  where s is used
//!     y = … + s -> y = … + s + r lag(u, tau)    where u drives s: a second RC element in series with the first
//! ```
//!
//! # What else looks like this
//! neglected-inertia, memory, input-lag, output-lag (the sensor): they part where the lag enters
//! twice or not in proportion.
//!
//! # Reference
//! J. C. Maxwell, On the dynamical theory of gases, Phil. Trans. 157 (1867) 49; Potemkin (1978).
//!
//! # Example
//! The damping liquid of a gyrocompass; a gyrosphere's supporting fluid as a second relaxing part.

use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY,
    draft::POSITIVE, edit, edit::Place, field,
};
use crate::expression::Expr;
use crate::model::{Initial, Output};
use crate::units::Unit;

/// A relaxing part: creep, a liquid that shifts.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "extra-lag",
    "a part that relaxes, or a second store behind it",
    Group::Dynamics,
    include_str!("extra_lag.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = Vec::new();
    for m in scene.motions() {
        all.extend(
            [
                beside(scene, &m, Start::Settled),
                beside(scene, &m, Start::Own),
                after(scene, &m.state, (false, Start::Settled)),
                after(scene, &m.state, (true, Start::Settled)),
            ]
            .into_iter()
            .flatten(),
        );
    }
    all.extend(scene.motions().iter().flat_map(|m| parallel(scene, m)));
    if !scene.trials {
        let moving = scene.moving(&[SignalKind::Definition]);
        let starts = [Start::Settled, Start::Own];
        let each =
            |s: &Signal| starts.map(|start| after(scene, &s.name, (false, start))).into_iter().flatten();
        all.extend(moving.flat_map(each));
    }
    all.extend(scene.richer_lag("extra-lag").and_then(|(mut d, lag)| {
        let w = &lag.frequency;
        let tau = d.parameter("T2", &Unit::parse("s").ok()?, POSITIVE, "time of the second lag");
        let square = &lag.square;
        d.lag_factor(&format!("(1 + {square})*(1 + ({w}*{tau})^2)/(1 - sqrt({square})*{w}*{tau})"));
        for phase in [0.1, 0.4, 1.0] {
            d.start(&[phase / scene.size(w)]);
        }
        d.done("the giving part acts through a second lag of {0}")
    }));
    all.extend(scene.richer_lag("extra-lag").and_then(|(mut d, lag)| {
        let w = &lag.frequency;
        let share = d.amplitude("share", &Unit::one(), ANY, "give of the second part over that of the first");
        let tau = d.parameter("T2", &Unit::parse("s").ok()?, POSITIVE, "time of the second part");
        d.lag_factor(&format!("1/(1/(1 + {}) + {share}/(1 + ({w}*{tau})^2))", lag.square));
        for phase in [0.3, 3.0] {
            d.start(&[1.0, phase / scene.size(w)]);
        }
        d.done("a second relaxing part gives {0} of the first, with a lag of {1}")
    }));
    all
}

/// A second element beside a balance that an output holds as one of several parts: what drives the first drives it too.
fn parallel(scene: &Scene, m: &Motion) -> Vec<Proposal> {
    let s = &m.state;
    let is_part = |o: &Output| o.equals.mentions(s) && o.equals != Expr::name(s);
    let state = scene.model.states.iter().find(|x| x.name == *s);
    let Some(state) = state.filter(|_| m.speed.is_none() && scene.model.outputs.iter().any(is_part)) else {
        return Vec::new();
    };
    let inputs = scene.moving(&[SignalKind::Input]);
    let driving = inputs.filter(|u| edit::has_term_in(scene.model, &state.rate, &u.name));
    let one = |u: &Signal| {
        let mut d = Draft::at(scene, "extra-lag", m);
        let u = &u.name;
        let r = d.amplitude("r", &scene.unit(s).over(&scene.unit(u)), ANY, "what the second element takes");
        let second = Unit::parse("s").ok()?;
        let tau = d.parameter("tau", &second, (0.5 * scene.step, scene.length()), "its time");
        d.uses(u);
        // what begins at rest does so beside one that does
        let follows = if state.initial == Initial::Number(0.0) {
            let z =
                d.state("follows", &scene.unit(u), Initial::Number(0.0), "what the second element has taken");
            d.rate(&z, &format!("({u} - {z})/{tau}"));
            z
        } else {
            format!("lag({u}, {tau})")
        };
        d.replace(s, &format!("({s} + {r}*{follows})"), |p| matches!(p, Place::Output(_)));
        for time in scene.times() {
            d.start(&[scene.size(s) / scene.size(u), time]);
        }
        let (store, to) = (field::words(m).store, scene.words(s));
        d.done(&format!(
            "{store} in series with {to}, which takes {{0}} times {} and follows in {{1}}",
            scene.words(u)
        ))
    };
    driving.filter_map(one).collect()
}

/// How a relaxing part begins.
#[derive(Clone, Copy, PartialEq)]
enum Start {
    /// As if what it follows had been there for long.
    Settled,
    /// Anywhere, which is fitted.
    Own,
}

/// What follows a signal with a lag, beginning as it may.
fn following(d: &mut Draft, signal: &str, unit: &Unit, (tau, start): (&str, Start)) -> String {
    if start == Start::Settled {
        return format!("lag({signal}, {tau})");
    }
    let z = d.state("follows", unit, Initial::Fit, "what the relaxing part has taken");
    d.rate(&z, &format!("({signal} - {z})/{tau}"));
    z
}

fn beside(scene: &Scene, m: &Motion, start: Start) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    if start == Start::Own && m.speed.is_some() {
        return None;
    }
    let mut d = Draft::at(scene, "extra-lag", m);
    let is_balance = m.speed.is_none();
    let meaning =
        if is_balance { "flow for a unit of the difference" } else { "stiffness of the relaxing part" };
    let c = d.amplitude("c", &m.force.over(&scene.unit(q)), POSITIVE, meaning);
    let tau =
        d.parameter("tau", &Unit::parse("s").ok()?, (0.1 * scene.step, scene.length()), "relaxation time");
    let follows = following(&mut d, q, &scene.unit(q), (&tau, start));
    d.force(&m.state, &format!("-{c}*({q} - {follows})"));
    for time in scene.times() {
        d.start(&[m.size / scene.size(q), time]);
    }
    let (store, to) = (field::words(m).store, scene.words(q));
    d.done(&if is_balance {
        format!("{store} behind {to}, which takes {{0}} times their difference and follows in {{1}}")
    } else {
        format!("{store} of stiffness {{0}} and time {{1}} is attached to {to}")
    })
}

fn after(scene: &Scene, name: &str, (in_parallel, start): (bool, Start)) -> Option<Proposal> {
    let kind =
        if scene.signal(name)?.kind == SignalKind::State { SiteKind::State } else { SiteKind::Definition };
    let mut d = Draft::new(scene, "extra-lag", kind, name);
    let share = if in_parallel {
        Some(d.amplitude("share", &Unit::one(), ANY, "share of the relaxing part"))
    } else {
        None
    };
    let least = if start == Start::Own { 0.1 * scene.step } else { 0.0 };
    let limits = (least, 0.5 * scene.length());
    let tau = d.parameter("tau", &Unit::parse("s").ok()?, limits, "relaxation time");
    let follows = following(&mut d, name, &scene.unit(name), (&tau, start));
    let text = match &share {
        Some(c) => format!("({name} + {c}*{follows})"),
        None => follows.clone(),
    };
    let own = (start == Start::Own).then_some(&follows);
    if let Some(z) = own {
        d.term(&format!("{z}' = ({name} - {z})/{tau}"));
    }
    d.replace(name, &text, |p| {
        let is_own = own.is_some_and(|z| p == Place::Rate(z));
        p != Place::Rate(name) && !is_own && !matches!(p, Place::Output(_)) && p != Place::Definition(name)
    });
    for time in scene.times() {
        let start = if in_parallel { vec![1.0, time] } else { vec![time] };
        d.start(&start);
    }
    let time = if in_parallel { "{1}" } else { "{0}" };
    d.done(&format!("{} acts on the rest through a relaxing part of time {time}", scene.words(name)))
}
