//! # What it is
//! Beyond a level the sensor shows that level, while the motion goes on.
//!
//! # Signature in a recording
//! Flat tops at exactly one value, and right again after them; the rest of the motion is not
//! disturbed.
//!
//! # Equation
//! ```text
//!     y -> min(y, L)    or    max(y, L)    or both
//! ```
//!
//! # What else looks like this
//! end-stop, overflow, input-saturation: there the motion itself stops; frozen-channel.
//!
//! # Reference
//! E. O. Doebelin, Measurement Systems, 5th ed. (2004), ch. 3.
//!
//! # Example
//! A level sensor that ends at ten volts.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind};

/// A sensor that clips.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-saturation",
    "a sensor that clips",
    Group::Output,
    include_str!("output_saturation.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let outputs = &scene.model.outputs;
    outputs
        .iter()
        .flat_map(|o| [at(scene, &o.name, 1), at(scene, &o.name, -1), at(scene, &o.name, 0)])
        .flatten()
        .collect()
}

fn at(scene: &Scene, output: &str, side: i8) -> Option<Proposal> {
    let (low, high) = *scene.measured.get(output)?;
    let mut d = Draft::new(scene, "output-saturation", SiteKind::Output, output);
    let unit = scene.unit(output);
    let reach = high - low;
    let (start, text) = match side {
        1 => (high - 0.002 * reach, "min({}, L)"),
        -1 => (low + 0.002 * reach, "max({}, L)"),
        _ => (high.abs().min(low.abs()), "clamp({}, -L, L)"),
    };
    let limits = if side == 0 { (0.5 * start, 1.1 * start) } else { (low - 0.1 * reach, high + 0.1 * reach) };
    let level = d.parameter("L", &unit, limits, "level at which the sensor ends");
    d.output(output, &text.replace("L)", &format!("{level})")).replace("-L", &format!("-{level}")));
    d.start(&[start]);
    d.done(&format!("the sensor of {} ends at {{0}}", scene.words(output)))
}
