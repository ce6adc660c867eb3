//! # What it is
//! From one moment on, or in one recording of several, a parameter has another value: something broke, was switched or
//! shifted.
//!
//! # Signature in a recording
//! The residual is small before and large after one time, or the other way; two fits on both sides
//! differ.
//!
//! # Equation
//! ```text
//!     p -> p (1 + a step(t - tc))
//!     p -> p (1 + a in)           in: 1 in one recording, 0 in the others
//! ```
//!
//! # What else looks like this
//! clock-jump, parameter-drift, parameter-dependence on a switched signal, frozen-channel.
//!
//! # Reference
//! M. Basseville, I. Nikiforov, Detection of Abrupt Changes (1993).
//!
//! # Example
//! A damper that loses its oil in the middle of the trial.

use super::{Alone, Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::units::Unit;

/// A parameter that jumps.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "parameter-change",
    "a parameter that jumps",
    Group::Ignored,
    include_str!("parameter_change.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let parameters = scene.acting_parameters();
    let odd =
        parameters.iter().flat_map(|p| others(scene, p).iter().filter_map(|one| in_one_alone(scene, p, one)));
    parameters.iter().filter_map(|p| at(scene, p)).chain(odd).collect()
}

/// The recordings in which a parameter may be another: of two, each is as good as the other where it is fitted.
fn others<'s>(scene: &'s Scene, p: &str) -> &'s [Alone] {
    let is_fitted = scene.model.parameters.iter().any(|q| q.name == p && q.fit);
    if is_fitted && scene.alone.len() == 2 { &scene.alone[1..] } else { &scene.alone }
}

fn in_one_alone(scene: &Scene, p: &str, one: &Alone) -> Option<Proposal> {
    let mut d = Draft::new(scene, "parameter-change", SiteKind::Parameter, p).alone(Some(one));
    let a = d.amplitude("a", &Unit::one(), (-3.0, 10.0), "relative change of the parameter");
    d.replace(p, &format!("({p}*(1 + {a}))"), |_| true);
    d.start(&[0.3]);
    d.done(&format!("{} is another, relatively by {{0}}", scene.words(p)))
}

fn at(scene: &Scene, p: &str) -> Option<Proposal> {
    let mut d = Draft::new(scene, "parameter-change", SiteKind::Parameter, p);
    let a = d.amplitude("a", &Unit::one(), (-3.0, 10.0), "relative jump of the parameter");
    let time = d.parameter("tc", &Unit::parse("s").ok()?, (scene.from, scene.to), "time of the jump");
    d.replace(p, &format!("({p}*(1 + {a}*step(t - {time})))"), |_| true);
    for moment in scene.moments() {
        d.start(&[0.3, moment]);
    }
    d.done(&format!("{} jumps relatively by {{0}} at {{1}}", scene.words(p)))
}
