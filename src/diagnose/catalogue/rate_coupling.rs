//! # What it is
//! The rate of change of a signal acts, beside its level or alone: an acceleration on what knows speeds.
//!
//! # Signature in a recording
//! After each step of the signal the state jumps and goes back as it does by itself; nothing is left where the signal
//! rests.
//!
//! # Equation
//! ```text
//!     x' = f(x) + c u':  with x = z + c u,  z' = f(z + c u), and z + c u wherever x stands
//! ```
//! It is looked for where x begins anywhere (`initial = "fit"`) or at rest. The state of the model is z then: nothing more is
//! added beside it.
//!
//! # What else looks like this
//! output-cross-axis: where a fitted gain of u and the state's own decay take up the rest, both are one law, and only a
//! known gain, or a second output that shows the state, parts them; cross-coupling (the level acts), input-lag.
//!
//! # Reference
//! W. Wrigley, W. M. Hollister, W. G. Denhard, Gyroscopic Theory, Design, and Instrumentation (1969), on ballistic
//! deflection.
//!
//! # Example
//! The ballistic deflection of a gyrocompass: its pendulum feels the acceleration to the north, the change of the speed
//! that stands in the speed error.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, felt};
use crate::expression::Expr;
use crate::model::{Initial, State};

/// The change of a signal acts.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "rate-coupling",
    "the change of a signal acts",
    Group::Ignored,
    include_str!("rate_coupling.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let turns = |s: &Signal| s.is_heading() && s.spread > 0.3;
    let signals: Vec<&Signal> =
        scene.moving(&[SignalKind::Channel, SignalKind::Input]).filter(|s| !turns(s)).collect();
    // where it begins at a number that stands, that of x - c u does not
    let may = |x: &&State| !matches!(x.initial, Initial::Number(_)) && is_felt(scene, x);
    let states = scene.model.states[..scene.own_states].iter().filter(may);
    states.flat_map(|x| signals.iter().filter_map(|u| at(scene, x, u))).collect()
}

/// Whether a state is felt by a rate: one that outputs alone show moves them as a sensor's share of the signal does. What an
/// accelerometer shows of a rate would jump without end.
fn is_felt(scene: &Scene, x: &State) -> bool {
    let model = scene.model;
    let in_rates = model.states.iter().any(|s| super::edit::reaches(model, &s.rate, &x.name));
    in_rates && felt::outputs(model, x, &Expr::Number(1.0)).is_empty()
}

fn at(scene: &Scene, x: &State, u: &Signal) -> Option<Proposal> {
    let own = scene.signal(&x.name)?;
    let mut d = Draft::new(scene, "rate-coupling", SiteKind::State, &x.name);
    let c = d.amplitude("c", &scene.unit(&x.name).over(&u.unit), ANY, "part of the change");
    d.uses(&u.name);
    d.term(&format!("{c}*{}'", u.name));
    let change = d.centred(u);
    d.replace(&x.name, &format!("({} + {c}*{change})", x.name), |_| true);
    d.ends();
    d.start(&[own.spread / u.spread]);
    d.done(&format!("{} moves with each change of {}, by {{0}}", scene.words(&x.name), scene.words(&u.name)))
}
