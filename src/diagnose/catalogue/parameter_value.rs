//! # What it is
//! A value that the model holds for known is another: a stiffness of the data sheet, a mass without its load.
//!
//! # Signature in a recording
//! The residual goes as the output changes with the parameter, whatever drives it and from the first sample to the last.
//!
//! # Equation
//! ```text
//!     p -> p + d      p a parameter that is not fitted
//!     p -> p + d, q -> q + e  two of them: what one spoils the other hides
//!     p = b -> b + d  p one that is fitted and pressed against its bound b, from there on
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

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind, edit};
use crate::estimate::Side;
use crate::model::Parameter;

/// A known value that is off.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "parameter-value",
    "a known value that is off",
    Group::Ignored,
    include_str!("parameter_value.rs"),
    propose,
);

/// Known values of which pairs are tried, at most.
const MOST_OF_PAIRS: usize = 5;

fn propose(scene: &Scene) -> Vec<Proposal> {
    let own = || scene.model.parameters[..scene.own_parameters].iter();
    let known: Vec<&Parameter> = own().filter(|p| !p.fit && p.value != 0.0).collect();
    let few = if known.len() <= MOST_OF_PAIRS { &known[..] } else { &[] };
    let pairs = few.iter().enumerate().flat_map(|(i, p)| few[i + 1..].iter().map(move |q| [*p, *q]));
    let singles = known.iter().filter_map(|p| off(scene, &[*p]));
    singles
        .chain(pairs.filter_map(|pair| off(scene, &pair)))
        .chain(own().filter_map(|p| beyond(scene, p)))
        .collect()
}

/// A value beyond a bound of the model; a bound of 0 is where something is not there at all.
fn beyond(scene: &Scene, p: &Parameter) -> Option<Proposal> {
    let side = edit::pressed_against(p).filter(|_| p.fit)?;
    let is_upper = side == Side::Upper;
    let bound = if is_upper { p.max } else { p.min }.filter(|b| *b != 0.0)?;
    let mut d = Draft::new(scene, "parameter-value", SiteKind::Parameter, &p.name);
    d.hold(&p.name, bound);
    // from the bound on, as far as a value held for known may be off
    let far = if is_upper == (bound > 0.0) { 30.0 } else { 0.95 } * bound.abs();
    let limits = if is_upper { (0.0, far) } else { (-far, 0.0) };
    let off =
        d.amplitude(&format!("d{}", p.name), &p.unit, limits, "how far the value lies beyond its bound");
    d.replace(&p.name, &format!("({} + {off})", p.name), |_| true);
    d.start(&[0.1 * if is_upper { bound.abs() } else { -bound.abs() }]);
    d.done(&format!(
        "{} lies {{0}} beyond the bound that the model gives it: widen that",
        scene.words(&p.name)
    ))
}

/// Some known values that are off at once; the first is the site.
fn off(scene: &Scene, all: &[&Parameter]) -> Option<Proposal> {
    let mut d = Draft::new(scene, "parameter-value", SiteKind::Parameter, &all.first()?.name);
    let mut says = Vec::new();
    for (i, p) in all.iter().enumerate() {
        let ends = (-0.95 * p.value, 30.0 * p.value);
        let limits = (ends.0.min(ends.1), ends.0.max(ends.1));
        let off = d.amplitude(&format!("d{}", p.name), &p.unit, limits, "what the known value is off by");
        d.replace(&p.name, &format!("({} + {off})", p.name), |_| true);
        says.push(match i {
            0 => format!("the value of {}, held for known, is off by {{0}}", scene.words(&p.name)),
            _ => format!("and that of {} by {{{i}}}", scene.words(&p.name)),
        });
    }
    d.start(&all.iter().map(|p| 0.3 * p.value).collect::<Vec<_>>());
    d.done(&says.join(", "))
}
