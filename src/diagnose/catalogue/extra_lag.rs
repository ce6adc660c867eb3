//! # What it is
//! A part that follows with a lag of its own: a viscous liquid, creep of a suspension, heat in a
//! wall.
//!
//! # Signature in a recording
//! A slow tail after each change; stiffness and damping that depend on frequency.
//!
//! # Equation
//! ```text
//!     M v' = … - c (q - lag(q, tau))    or    s -> lag(s, tau)  or  s + c lag(s, tau)  where s is used
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
    Draft, Group, Mechanism, Motion, Proposal, Scene, SignalKind, SiteKind, draft::ANY, draft::POSITIVE,
    edit::Place,
};
use crate::units::Unit;

/// A relaxing part: creep, a liquid that shifts.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "extra-lag",
    "a relaxing part: creep, a liquid that shifts",
    Group::Dynamics,
    include_str!("extra_lag.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = Vec::new();
    for m in scene.motions() {
        all.extend(
            [beside(scene, &m), after(scene, &m.state, false), after(scene, &m.state, true)]
                .into_iter()
                .flatten(),
        );
    }
    if !scene.trials {
        let moving = scene.moving(&[SignalKind::Definition]);
        all.extend(moving.filter_map(|s| after(scene, &s.name, false)));
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

fn beside(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let mut d = Draft::at(scene, "extra-lag", m);
    let c = d.amplitude("c", &m.force.over(&scene.unit(q)), POSITIVE, "stiffness of the relaxing part");
    let tau =
        d.parameter("tau", &Unit::parse("s").ok()?, (0.1 * scene.step, scene.length()), "relaxation time");
    d.force(&m.state, &format!("-{c}*({q} - lag({q}, {tau}))"));
    for time in scene.times() {
        d.start(&[m.size / scene.size(q), time]);
    }
    d.done(&format!("a relaxing part of stiffness {{0}} and time {{1}} is attached to {}", scene.words(q)))
}

fn after(scene: &Scene, name: &str, in_parallel: bool) -> Option<Proposal> {
    let kind =
        if scene.signal(name)?.kind == SignalKind::State { SiteKind::State } else { SiteKind::Definition };
    let mut d = Draft::new(scene, "extra-lag", kind, name);
    let share = if in_parallel {
        Some(d.amplitude("share", &Unit::one(), ANY, "share of the relaxing part"))
    } else {
        None
    };
    let tau = d.parameter("tau", &Unit::parse("s").ok()?, (0.0, 0.5 * scene.length()), "relaxation time");
    let text = match &share {
        Some(c) => format!("({name} + {c}*lag({name}, {tau}))"),
        None => format!("lag({name}, {tau})"),
    };
    d.replace(name, &text, |p| {
        p != Place::Rate(name) && !matches!(p, Place::Output(_)) && p != Place::Definition(name)
    });
    for time in scene.times() {
        let start = if in_parallel { vec![1.0, time] } else { vec![time] };
        d.start(&start);
    }
    let time = if in_parallel { "{1}" } else { "{0}" };
    d.done(&format!("{} acts on the rest through a relaxing part of time {time}", scene.words(name)))
}
