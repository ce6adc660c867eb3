//! # What it is
//! A sensor whose calibration is not straight: a thermocouple, a bridge far out, a gauge whose lever turns.
//!
//! # Signature in a recording
//! What is left goes with the reading itself, bent, whatever the system does.
//!
//! # Equation
//! ```text
//!     y -> y + a y^2    or    y -> y + a y^3,  y from the zero of its unit
//! ```
//!
//! # What else looks like this
//! output-saturation (a sharp end), output-scale (straight); quadratic-stiffness and cubic-stiffness, which change the
//! motion too.
//!
//! # Reference
//! JCGM 200:2012, International vocabulary of metrology, 4.30 and 4.31 (calibration curve).
//!
//! # Example
//! A resistance thermometer read with its slope at 0 degC alone.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind, draft::ANY};
use crate::model::Output;
use crate::units::Unit;

/// A sensor with a bent calibration.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-square",
    "a sensor with a bent calibration",
    Group::Output,
    include_str!("output_square.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let outputs = || scene.model.outputs.iter();
    outputs().flat_map(|o| [2, 3].map(|power| bent(scene, o, power))).flatten().collect()
}

fn bent(scene: &Scene, o: &Output, power: i32) -> Option<Proposal> {
    let signal = scene.signal(&o.name).filter(|s| s.varies() && !s.is_heading())?;
    let mut d = Draft::new(scene, "output-square", SiteKind::Output, &o.name);
    let unit = scene.unit(&o.name);
    let beyond = f64::from(power - 1);
    let a = d.amplitude("a", &Unit::one().over(&unit.power(beyond)), ANY, "bend of the calibration");
    let zero = o.unit.to_si(0.0);
    let reading = if zero == 0.0 {
        "{}".to_owned()
    } else {
        let name = d.constant(&format!("{}_zero", o.name), &unit, zero, "zero of the reading");
        format!("({{}} - {name})")
    };
    d.output(&o.name, &format!("{{}} + {a}*{reading}^{power}"));
    d.start(&[0.1 / (signal.mean - zero).hypot(signal.spread).powi(power - 1)]);
    let how = if power == 2 { "square" } else { "third power" };
    d.done(&format!("the reading of {} has a part with its {how}, {{0}}", scene.words(&o.name)))
}
