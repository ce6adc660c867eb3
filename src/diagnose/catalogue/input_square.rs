//! # What it is
//! The effect goes with the square of what is recorded: power with voltage, thrust with
//! revolutions, drag with wind.
//!
//! # Signature in a recording
//! Large inputs do more, small ones less than the model says; with two levels of the input alone it
//! cannot be seen.
//!
//! # Equation
//! ```text
//!     u -> u + a u^2    or    u -> u |u|/u_ref    or    u -> u + a u^3
//! ```
//!
//! # What else looks like this
//! input-saturation (the other bend), parameter-dependence of the gain on the input.
//!
//! # Reference
//! G. Giri, E.-W. Bai (eds.), Block-oriented Nonlinear System Identification (2010).
//!
//! # Example
//! A halogen lamp driven by its voltage, modelled as if the heat went with the voltage.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY};
use crate::units::Unit;

/// An effect with the square of the input.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "input-square",
    "an effect with the square of the input",
    Group::Input,
    include_str!("input_square.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let inputs = scene.moving(&[SignalKind::Input]).filter(|u| !u.is_heading());
    inputs.flat_map(|u| [part(scene, u, 2), whole(scene, u), part(scene, u, 3)]).flatten().collect()
}

fn part(scene: &Scene, u: &Signal, power: i32) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-square", SiteKind::Input, &u.name);
    let unit = Unit::one().over(&u.unit.power(f64::from(power - 1)));
    let a = d.amplitude("a", &unit, ANY, "size of the part that is not straight");
    d.replace(&u.name, &format!("({} + {a}*{}^{power})", u.name, u.name), |_| true);
    d.start(&[1.0 / u.size().powi(power - 1)]);
    let how = if power == 2 { "square" } else { "third power" };
    d.done(&format!("the effect of {} has a part with its {how}, {{0}}", scene.words(&u.name)))
}

fn whole(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-square", SiteKind::Input, &u.name);
    let scale = d.constant(&format!("{}_ref", u.name), &u.unit, u.size(), "scale of the input, not fitted");
    d.replace(&u.name, &format!("({}*abs({})/{scale})", u.name, u.name), |_| true);
    d.start(&[]);
    d.done(&format!("the effect goes with the square of {}", scene.words(&u.name)))
}
