//! # What it is
//! An instrument stands turned against the axis from which its angle is counted, or an input against that along which
//! it acts; or an instrument's own error goes with the angle that it shows (a compass's deviation).
//!
//! # Signature in a recording
//! The error repeats with the heading, shifted against the model's own harmonic by a constant angle; where that angle
//! goes with the heading, harmonics one higher and one lower stand beside the model's own.
//!
//! # Equation
//! ```text
//!     K -> K + delta
//!     K -> K + A_sin sin(n K) + A_cos cos(n K)      n = 1 (semicircular: B, C), 2 (quadrantal: D, E)
//!     u -> u (1 + a y^2)      with a recorded angle y between u and its axis; a cosine where a = -1/2
//! ```
//!
//! # What else looks like this
//! output-offset at one heading, a harmonic of the heading (cross-coupling), input-delay while
//! turning.
//!
//! # Reference
//! A. Lawrence, Modern Inertial Technology, 2nd ed. (1998), on misalignment; N. Bowditch, The American Practical
//! Navigator, on the coefficients A to E of a compass's deviation.
//!
//! # Example
//! A gyrocompass stand turned by three degrees against the keel; a wind turbine that does not face the wind; dead
//! reckoning by a magnetic compass whose deviation nobody took out; an encoder that is not centred on its shaft.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, edit};
use crate::expression::{Expr, Function};
use crate::model::Model;
use crate::units::Unit;

/// An angle used by the model is off.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "misalignment",
    "an angle used by the model is off",
    Group::Input,
    include_str!("misalignment.rs"),
    propose,
);

/// A heading that spreads less than this does not show what goes with its sine and cosine beside a constant, rad.
pub(super) const ROUND: f64 = 0.5;

fn propose(scene: &Scene) -> Vec<Proposal> {
    let angles: Vec<&Signal> = scene.headings();
    let mut all: Vec<Proposal> = angles.iter().filter_map(|h| at(scene, h)).collect();
    let round = angles.iter().filter(|h| h.spread > ROUND && turns(scene.model, &h.name));
    all.extend(round.flat_map(|h| [&[1][..], &[2], &[1, 2]].map(|n| deviating(scene, h, n))).flatten());
    let small = |s: &&Signal| scene.is_angle(&s.name) && !s.is_heading();
    for angle in scene.moving(&[SignalKind::Channel]).filter(small) {
        let inputs = scene.moving(&[SignalKind::Input]).filter(|u| !u.is_heading());
        all.extend(inputs.filter_map(|u| component(scene, u, angle)));
    }
    all
}

/// An input that acts by its component along an axis from which a recorded angle turns it away.
fn component(scene: &Scene, u: &Signal, angle: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "misalignment", SiteKind::Input, &u.name);
    let unit = Unit::one().over(&scene.unit(&angle.name).power(2.0));
    let a = d.amplitude("a", &unit, ANY, "relative change with the square of the angle");
    d.uses(&angle.name);
    d.replace(&u.name, &format!("({}*(1 + {a}*{}^2))", u.name, angle.name), |_| true);
    d.start(&[-0.5]);
    let (u, angle) = (scene.words(&u.name), scene.words(&angle.name));
    d.done(&format!("{u} acts by a component that changes with the square of {angle}, relatively by {{0}}"))
}

fn at(scene: &Scene, h: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "misalignment", SiteKind::Input, &h.name);
    let delta = d.amplitude("delta", &h.unit, (-1.6, 1.6), "angle by which the input is off");
    d.replace(&h.name, &format!("({} + {delta})", h.name), |_| true);
    d.start(&[0.3]);
    d.done(&format!("{} is off by {{0}}: the instrument stands turned", scene.words(&h.name)))
}

/// Whether a rate takes the sine or cosine of an angle; where none does, the angle's own error is one of what shows it.
fn turns(model: &Model, angle: &str) -> bool {
    let is_turn = |e: &Expr| match e {
        Expr::Call(Function::Sin | Function::Cos, a) => a[0].mentions(angle),
        _ => false,
    };
    model.states.iter().any(|s| edit::find(edit::opened(model, &s.rate), &is_turn).is_some())
}

/// An error of the angle that goes with some harmonics of the angle itself; with several, a constant stands beside them.
fn deviating(scene: &Scene, h: &Signal, harmonics: &[u32]) -> Option<Proposal> {
    let mut d = Draft::new(scene, "misalignment", SiteKind::Input, &h.name);
    let part = |d: &mut Draft, name: &str, which: &str| {
        d.amplitude(name, &h.unit, (-1.0, 1.0), &format!("{which} part of the deviation"))
    };
    let (mut sum, mut says) = (h.name.clone(), Vec::new());
    for n in harmonics {
        let (a, b) = (part(&mut d, "A_sin", "sine"), part(&mut d, "A_cos", "cosine"));
        let angle = if *n == 1 { h.name.clone() } else { format!("{n}*{}", h.name) };
        sum += &format!(" + {a}*sin({angle}) + {b}*cos({angle})");
        let (k, of) = (2 * says.len(), if *n == 1 { "itself" } else { "twice itself" });
        says.push(format!("{{{k}}} times the sine and {{{}}} times the cosine of {of}", k + 1));
    }
    if harmonics.len() > 1 {
        sum += &format!(" + {}", part(&mut d, "delta", "constant"));
        says.push(format!("{{{}}}", 2 * harmonics.len()));
    }
    d.replace(&h.name, &format!("({sum})"), |_| true);
    d.start(&vec![0.05; 2 * harmonics.len() + usize::from(harmonics.len() > 1)]);
    d.done(&format!("{} is off by {}: its deviation", scene.words(&h.name), says.join(" and ")))
}
