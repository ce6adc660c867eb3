//! # What it is
//! A parameter grows or falls steadily: wear, warming, a leak, a catalyst that dies.
//!
//! # Signature in a recording
//! Fits on successive parts of the recording give values on a line.
//!
//! # Equation
//! ```text
//!     p -> p (1 + a (t - t0)),  t0 the middle of the fitted part
//!     p -> p exp(a (t - t0)) of what decays
//! ```
//!
//! # What else looks like this
//! parameter-dependence on a signal that drifts, drift-force (a sum, not a product), parameter-
//! change.
//!
//! # Reference
//! P. C. Young, Recursive Estimation and Time-Series Analysis (2011), ch. 4.
//!
//! # Example
//! Grease that warms up in the first hour.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind, draft::ANY};
use crate::units::Unit;

/// A parameter that drifts with time.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "parameter-drift",
    "a parameter that drifts with time",
    Group::Ignored,
    include_str!("parameter_drift.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let forms = |p: &String| [false, true].map(|decays| at(scene, p, decays));
    scene.acting_parameters().iter().flat_map(forms).flatten().collect()
}

/// Along a straight line, or by the same share in the same time.
fn at(scene: &Scene, p: &str, decays: bool) -> Option<Proposal> {
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::new(scene, "parameter-drift", SiteKind::Parameter, p);
    let a = d.amplitude("a", &Unit::one().over(&second), ANY, "relative drift of the parameter");
    let middle = d.constant("t_mid", &second, 0.5 * (scene.from + scene.to), "middle of the fitted part");
    let (law, how) = if decays {
        (format!("({p}*exp({a}*(t - {middle})))"), " by equal shares in equal times")
    } else {
        (format!("({p}*(1 + {a}*(t - {middle})))"), "")
    };
    d.replace(p, &law, |_| true);
    d.start(&[1.0 / scene.length()]);
    d.done(&format!("{} drifts{how}, relatively by {{0}}", scene.words(p)))
}
