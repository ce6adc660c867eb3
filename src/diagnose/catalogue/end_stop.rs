//! # What it is
//! Beyond a certain deflection a stiff stop carries the part.
//!
//! # Signature in a recording
//! The motion is cut at one level, with a kick back; nothing is wrong at small amplitude.
//!
//! # Equation
//! ```text
//!     M v' = … - ks max(q - qs, 0) + ks max(-qs - q, 0)        q from rest, or from a place that is an input
//!     k d -> k d + ks max(d - qs, 0) - ks max(-qs - d, 0)      on one side or both, d between two bodies
//!     k d -> k d + ks max(d - qs, 0)^2                         a rubber that comes to bear by and by
//! ```
//!
//! # What else looks like this
//! cubic-stiffness, input-saturation, output-saturation (the sensor clips, the motion does not).
//!
//! # Reference
//! S. W. Shaw, P. J. Holmes, A periodically forced piecewise linear oscillator, J. Sound Vib. 90
//! (1983) 129.
//!
//! # Example
//! A gyroscope's gimbal that reaches its stop in heavy roll; the bump stop of a car's suspension.

use super::between::{self, Between, Of};
use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, draft::ANY, draft::POSITIVE,
};

/// An end stop.
pub(super) const MECHANISM: Mechanism =
    Mechanism::new("end-stop", "an end stop", Group::Force, include_str!("end_stop.rs"), propose);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let sides = |m: &Motion| [at(scene, m, 0), at(scene, m, 1), at(scene, m, -1)];
    let moving = || motions.iter().filter(|m| m.speed.is_some());
    let own = moving().flat_map(sides).flatten();
    let about = moving().flat_map(|m| places(scene, m).filter_map(|x| from(scene, m, x)));
    let elements = between::all(scene, Of::Positions);
    let bears = |b: &Between| {
        let ways = [0, 1, -1].map(|side| (side, 1)).into_iter().chain([(1, 2), (-1, 2)]);
        ways.filter_map(|way| beside(scene, b, way)).collect::<Vec<_>>()
    };
    own.chain(about).chain(elements.iter().flat_map(bears)).collect()
}

/// Inputs and recorded channels that are places as the position of a motion is one: a track, a floor, a casing.
fn places<'s>(scene: &'s Scene, m: &'s Motion) -> impl Iterator<Item = &'s Signal> {
    let unit = m.position.as_ref().map(|q| scene.unit(q));
    let is_place = move |s: &&Signal| unit.as_ref().is_some_and(|u| u.dimension() == s.unit.dimension());
    scene.moving(&[SignalKind::Input, SignalKind::Channel]).filter(is_place).filter(|s| !s.is_heading())
}

/// A stop on both sides of a place that moves.
fn from(scene: &Scene, m: &Motion, place: &Signal) -> Option<Proposal> {
    let (q, x) = (scene.signal(m.position.as_ref()?)?, &place.name);
    let mut d = Draft::at(scene, "end-stop", m);
    let k = d.amplitude("ks", &m.force.over(&q.unit), POSITIVE, "stiffness of the stop");
    let qs = d.parameter("qs", &q.unit, POSITIVE, "how far the stop is");
    d.uses(x);
    let away = format!("({} - {x})", q.name);
    d.force(&m.state, &format!("-{k}*(max({away} - {qs}, 0*{qs}) - max(-{qs} - {away}, 0*{qs}))"));
    let size = q.size().hypot(place.size());
    for fraction in [0.8, 1.6, 2.4] {
        d.start(&[10.0 * m.size / size, fraction * size]);
    }
    let (q, x) = (scene.words(&q.name), scene.words(x));
    d.done(&format!("a stop of stiffness {{0}} stands {{1}} to each side of {x} in the way of {q}"))
}

/// A stop beside a spring between two bodies, on one side or both, whose force grows with a power.
fn beside(scene: &Scene, b: &Between, (side, power): (i8, u8)) -> Option<Proposal> {
    let mut d = b.draft(scene, "end-stop");
    let unit = b.force.over(&b.unit.power(f64::from(power)));
    let k = d.amplitude("ks", &unit, POSITIVE, "stiffness of the stop");
    let limits = if side == 0 { POSITIVE } else { ANY };
    let qs = d.parameter("qs", &b.unit, limits, "where the stop is");
    let raised = |x: String| if power == 1 { format!("{k}*{x}") } else { format!("{k}*{x}^{power}") };
    let above = |q: &str, level: &str| raised(format!("max({q} - {level}, 0*{qs})"));
    let below = |q: &str, level: &str| raised(format!("max({level} - {q}, 0*{qs})"));
    b.obeys(&mut d, &|q, is_turned| {
        let spring = format!("{}*{q}", b.parameter);
        // seen from the other body the stop is at -qs, on the other side
        let level = if is_turned { format!("(-{qs})") } else { qs.clone() };
        match if is_turned { -side } else { side } {
            0 => format!("{spring} + {} - {}", above(q, &qs), below(q, &format!("-{qs}"))),
            1 => format!("{spring} + {}", above(q, &level)),
            _ => format!("{spring} - {}", below(q, &level)),
        }
    });
    for level in [0.8, 1.6, 2.4].map(|x| x * b.size) {
        let size = b.force_size(scene) / (0.5 * b.size).powi(i32::from(power));
        d.start(&[size, if side < 0 { -level } else { level }]);
    }
    d.done(&format!(
        "a stop of stiffness {{0}} beside {} bears from {} = {{1}} on",
        scene.words(&b.parameter),
        b.difference
    ))
}

fn at(scene: &Scene, m: &Motion, side: i8) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let signal = scene.signal(q)?;
    let mut d = Draft::at(scene, "end-stop", m);
    let k = d.amplitude("ks", &m.force.over(&signal.unit), POSITIVE, "stiffness of the stop");
    let qs = d.parameter("qs", &signal.unit, ANY, "where the stop is");
    if side >= 0 {
        d.force(&m.state, &format!("-{k}*max({q} - {qs}, 0*{qs})"));
    }
    match side {
        0 => d.force(&m.state, &format!("{k}*max(-{qs} - {q}, 0*{qs})")),
        -1 => d.force(&m.state, &format!("{k}*max({qs} - {q}, 0*{qs})")),
        _ => {}
    }
    for fraction in [0.6, 0.85] {
        let level = match side {
            0 => fraction * signal.max.abs().max(signal.min.abs()),
            1 => signal.mean + fraction * (signal.max - signal.mean),
            _ => signal.mean + fraction * (signal.min - signal.mean),
        };
        d.start(&[10.0 * m.size / signal.size(), level]);
    }
    d.done(&format!("a stop of stiffness {{0}} stands at {} = {{1}}", scene.words(q)))
}
