//! # What it is
//! Within a gap about zero the spring or the coupling does not act.
//!
//! # Signature in a recording
//! Slow or no return near zero; the period grows as the amplitude falls.
//!
//! # Equation
//! ```text
//!     q -> q - clamp(q, -d, d),  d >= 0
//! ```
//!
//! # What else looks like this
//! cubic-stiffness (hardening), backlash (which remembers the side), input-dead-zone.
//!
//! # Reference
//! D. P. Atherton, Nonlinear Control Engineering (1975).
//!
//! # Example
//! A rudder with play about amidships.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, SiteKind, edit::Place};

/// A gap in which nothing acts.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "dead-zone",
    "a gap in which nothing acts",
    Group::Force,
    include_str!("dead_zone.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let mut all: Vec<Proposal> = motions.iter().filter_map(|m| at(scene, m)).collect();
    all.extend(scene.model.outputs.iter().filter_map(|o| seen(scene, &o.name)));
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let size = scene.signal(q).filter(|s| !s.stays_off_zero())?.size();
    let mut d = Draft::at(scene, "dead-zone", m);
    let gap = d.parameter("dz", &scene.unit(q), (0.0, 3.0 * size), "half width of the gap");
    let own = m.state.clone();
    let text = format!("({q} - clamp({q}, -{gap}, {gap}))");
    d.replace(q, &text, |p| p == Place::Rate(&own) || matches!(p, Place::Definition(_)));
    for fraction in [0.1, 0.4] {
        d.start(&[fraction * size]);
    }
    d.done(&format!("within {{0}} of zero {} meets no force", scene.words(q)))
}

fn seen(scene: &Scene, output: &str) -> Option<Proposal> {
    let size = scene.signal(output).filter(|s| !s.stays_off_zero())?.spread;
    let mut d = Draft::new(scene, "dead-zone", SiteKind::Output, output);
    let gap = d.parameter("dz", &scene.unit(output), (0.0, 3.0 * size), "half width of the gap");
    d.output(output, &format!("({{}} - clamp({{}}, -{gap}, {gap}))"));
    for fraction in [0.1, 0.4] {
        d.start(&[fraction * size]);
    }
    d.done(&format!("{} does not show the first {{0}} to either side", scene.words(output)))
}
