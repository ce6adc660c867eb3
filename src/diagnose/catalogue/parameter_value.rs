//! # What it is
//! A value that the model holds for known is another: a stiffness of the data sheet, a mass without its load.
//!
//! # Signature in a recording
//! The residual goes as the output changes with the parameter, whatever drives it and from the first sample to the last.
//!
//! # Equation
//! ```text
//!     p -> p + d      p a parameter that is not fitted
//! ```
//!
//! # What else looks like this
//! linear-damping, output-scale, neglected-inertia, a part that adds to the same term. parameter-drift and
//! parameter-dependence, where it is off on the mean alone.
//!
//! # Reference
//! L. Ljung, System Identification, 2nd ed. (1999), 4.3.
//!
//! # Example
//! A spring of 2600 N/m that the drawing calls one of 2500.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::model::Parameter;

/// A known value that is off.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "parameter-value",
    "a known value that is off",
    Group::Ignored,
    include_str!("parameter_value.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let known = scene.model.parameters[..scene.own_parameters].iter().filter(|p| !p.fit && p.value != 0.0);
    known.filter_map(|p| at(scene, p)).collect()
}

fn at(scene: &Scene, p: &Parameter) -> Option<Proposal> {
    let mut d = Draft::new(scene, "parameter-value", SiteKind::Parameter, &p.name);
    let ends = (-0.95 * p.value, 30.0 * p.value);
    let limits = (ends.0.min(ends.1), ends.0.max(ends.1));
    let off = d.amplitude(&format!("d{}", p.name), &p.unit, limits, "what the known value is off by");
    d.replace(&p.name, &format!("({} + {off})", p.name), |_| true);
    d.start(&[0.3 * p.value]);
    d.done(&format!("the value of {}, held for known, is off by {{0}}", scene.words(&p.name)))
}
