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
//!     p -> p/(1 + a (t - t0)) of what has a growing resistance in series
//! ```
//!
//! # What else looks like this
//! parameter-dependence on a signal that drifts, drift-force (a sum, not a product), parameter-
//! change.
//!
//! # Reference
//! P. C. Young, Recursive Estimation and Time-Series Analysis (2011), ch. 4; D. Q. Kern, R. E. Seaton, Br. Chem. Eng. 4
//! (1959) 258, on resistances of fouling that grow with time.
//!
//! # Example
//! Grease that warms up in the first hour; a heat exchanger that fouls.

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
    let forms = |p: &String| [Form::Straight, Form::Decays, Form::Resists].map(|form| at(scene, p, form));
    scene.acting_parameters().iter().flat_map(forms).flatten().collect()
}

/// How it drifts: along a straight line, by the same share in the same time, or as one over a straight line.
#[derive(Clone, Copy)]
enum Form {
    Straight,
    Decays,
    Resists,
}

/// Share of the way to zero that the line of a drift that is one over it may go in all that was recorded.
const ABOVE_ZERO: f64 = 0.9;

fn at(scene: &Scene, p: &str, form: Form) -> Option<Proposal> {
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::new(scene, "parameter-drift", SiteKind::Parameter, p);
    let mid = 0.5 * (scene.from + scene.to);
    let limits = match form {
        Form::Resists => (-ABOVE_ZERO / (scene.whole.1 - mid), ABOVE_ZERO / (mid - scene.whole.0)),
        _ => ANY,
    };
    let a = d.amplitude("a", &Unit::one().over(&second), limits, "relative drift of the parameter");
    let middle = d.constant("t_mid", &second, mid, "middle of the fitted part");
    let (law, how) = match form {
        Form::Straight => (format!("({p}*(1 + {a}*(t - {middle})))"), ""),
        Form::Decays => (format!("({p}*exp({a}*(t - {middle})))"), " by equal shares in equal times"),
        Form::Resists => (format!("({p}/(1 + {a}*(t - {middle})))"), " as one over a straight line"),
    };
    d.replace(p, &law, |_| true);
    d.start(&[1.0 / scene.length()]);
    d.done(&format!("{} drifts{how}, relatively by {{0}}", scene.words(p)))
}
