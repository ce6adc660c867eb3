//! # What it is
//! A parameter is no constant: viscosity with temperature, stiffness with load, gain with voltage.
//!
//! # Signature in a recording
//! Fits on parts of the recording give other values, in step with the signal.
//!
//! # Equation
//! ```text
//!     p -> p (1 + a (u - mean u))
//! ```
//!
//! # What else looks like this
//! parameter-change, parameter-drift (when the signal drifts), cross-coupling (a sum, not a
//! product).
//!
//! # Reference
//! P. C. Young, P. McKenna, J. Bruun, Identification of non-linear stochastic systems by state
//! dependent parameter estimation, Int. J. Control 74 (2001) 1837.
//!
//! # Example
//! The lag of a gyrosphere's liquid that grows as it cools.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY};
use crate::units::Unit;

/// A parameter that varies with a signal.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "parameter-dependence",
    "a parameter that varies with a signal",
    Group::Ignored,
    include_str!("parameter_dependence.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let signals: Vec<&Signal> =
        scene.moving(&[SignalKind::Channel, SignalKind::Input]).filter(|s| !s.is_heading()).collect();
    let names = scene.acting_parameters();
    let pairs = names.iter().flat_map(|p| signals.iter().map(move |s| (p, *s)));
    pairs.filter_map(|(p, s)| at(scene, p, s)).collect()
}

fn at(scene: &Scene, p: &str, signal: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "parameter-dependence", SiteKind::Parameter, p);
    let a = d.amplitude(
        "a",
        &Unit::one().over(&signal.unit),
        ANY,
        "relative change of the parameter for a unit of the signal",
    );
    let mean =
        d.constant(&format!("{}_mean", signal.name), &signal.unit, signal.mean, "mean of the recording");
    d.uses(&signal.name);
    d.replace(p, &format!("({p}*(1 + {a}*({} - {mean})))", signal.name), |_| true);
    d.start(&[0.3 / signal.spread]);
    d.done(&format!("{} varies with {}, relatively by {{0}}", scene.words(p), scene.words(&signal.name)))
}
