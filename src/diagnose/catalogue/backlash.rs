//! # What it is
//! A part follows another only when it is pushed: gears, joints, loose bearings.
//!
//! # Signature in a recording
//! At each reversal the follower stands still for the width of the play; flat tops, a loop of
//! constant width at any speed.
//!
//! # Equation
//! ```text
//!     q -> backlash(q, gap): moves only while q pushes it
//!     k (a - b) -> k (x - clamp(x, -gap/2, gap/2)), x = a - b, where a spring stands between two bodies
//! ```
//!
//! # What else looks like this
//! dead-zone (no memory), dry-friction with a spring (hysteresis), output-delay (in time, not in
//! width).
//!
//! # Reference
//! G. Tao, P. V. Kokotovic, Adaptive Control of Systems with Actuator and Sensor Nonlinearities
//! (1996).
//!
//! # Example
//! A resolver driven by a worn gear.

use super::between::{self, Between, Of};
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, SignalKind, SiteKind, edit::Place};

/// Play that remembers its side.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "backlash",
    "play that remembers its side",
    Group::Force,
    include_str!("backlash.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let mut all: Vec<Proposal> =
        scene.motions().iter().flat_map(|m| [own(scene, m), used(scene, m)]).flatten().collect();
    all.extend(between::all(scene, Of::Positions).iter().filter_map(|b| coupled(scene, b)));
    all.extend(scene.model.outputs.iter().filter_map(|o| seen(scene, &o.name)));
    all.extend(scene.moving(&[SignalKind::Input]).filter_map(|u| fed(scene, &u.name)));
    all
}

fn widths(d: &mut Draft, scene: &Scene, name: &str) -> Option<String> {
    let signal = scene.signal(name)?;
    let range = signal.max - signal.min;
    let gap = d.parameter("gap", &signal.unit, (0.0, range), "full width of the play");
    for fraction in [0.03, 0.12, 0.4] {
        d.start(&[fraction * 2.8 * signal.spread]);
    }
    Some(gap)
}

fn own(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let mut d = Draft::at(scene, "backlash", m);
    let gap = widths(&mut d, scene, q)?;
    let state = m.state.clone();
    d.replace(q, &format!("backlash({q}, {gap})"), |p| {
        p == Place::Rate(&state) || matches!(p, Place::Definition(_))
    });
    d.done(&format!("there is play of {{0}} between {} and what it pushes", scene.words(q)))
}

fn used(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let s = &m.state;
    let mut d = Draft::at(scene, "backlash", m);
    let gap = widths(&mut d, scene, s)?;
    d.replace(s, &format!("backlash({s}, {gap})"), |p| p != Place::Rate(s) && !matches!(p, Place::Output(_)));
    d.done(&format!("there is play of {{0}} between {} and what it drives", scene.words(s)))
}

fn seen(scene: &Scene, output: &str) -> Option<Proposal> {
    let mut d = Draft::new(scene, "backlash", SiteKind::Output, output);
    let gap = widths(&mut d, scene, output)?;
    d.output(output, &format!("backlash({{}}, {gap})"));
    d.done(&format!("there is play of {{0}} between the system and the sensor of {}", scene.words(output)))
}

fn fed(scene: &Scene, input: &str) -> Option<Proposal> {
    let mut d = Draft::new(scene, "backlash", SiteKind::Input, input);
    let gap = widths(&mut d, scene, input)?;
    d.replace(input, &format!("backlash({input}, {gap})"), |_| true);
    d.done(&format!("there is play of {{0}} between {} and the system", scene.words(input)))
}

/// Play in what couples two bodies: within it their spring bears nothing.
fn coupled(scene: &Scene, b: &Between) -> Option<Proposal> {
    let mut d = b.draft(scene, "backlash");
    let gap = d.parameter("gap", &b.unit, (0.0, 6.0 * b.size), "full width of the play");
    b.obeys(&mut d, &|q, _| format!("{}*({q} - clamp({q}, -{gap}/2, {gap}/2))", b.parameter));
    for fraction in [0.02, 0.08, 0.3, 1.0] {
        d.start(&[fraction * b.size]);
    }
    d.done(&format!("there is play of {{0}} in what {} joins, {}", scene.words(&b.parameter), b.difference))
}
