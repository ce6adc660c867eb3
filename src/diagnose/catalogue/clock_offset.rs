//! # What it is
//! The time stamps of one table are off by a constant, early or late, against those of the others.
//!
//! # Signature in a recording
//! The residual is proportional to the rate of change of what the table holds; a shift of the
//! stamps removes it.
//!
//! # Equation
//! ```text
//!     u(t) -> u(t + offset) for each channel of the table
//! ```
//!
//! # What else looks like this
//! input-delay, output-delay (only late, and of one channel); a lag at low frequency.
//!
//! # Reference
//! Raw logs of ships: a reference's message logged half a second after the time that it carries.
//!
//! # Example
//! Two gyrocompasses against a satellite compass whose stamps are late.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::units::Unit;

/// A clock that is off.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "clock-offset",
    "a clock that is off",
    Group::Output,
    include_str!("clock_offset.rs"),
    propose,
)
.shifting_time();

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials || scene.tables.len() < 2 {
        return Vec::new();
    }
    scene.tables.iter().filter_map(|t| at(scene, t)).collect()
}

fn at(scene: &Scene, table: &[String]) -> Option<Proposal> {
    let model = scene.model;
    let inputs: Vec<&str> =
        model.inputs.iter().map(|i| i.name.as_str()).filter(|n| table.iter().any(|c| c == n)).collect();
    let holds_outputs = model.outputs.iter().any(|o| table.contains(&o.name));
    let first = *inputs.first()?;
    if holds_outputs || inputs.len() < model.inputs.len() && model.inputs.is_empty() {
        return None;
    }
    let mut d = Draft::new(scene, "clock-offset", SiteKind::Input, first);
    let reach = 0.1 * scene.length();
    let offset =
        d.amplitude("offset", &Unit::parse("s").ok()?, (-reach, reach), "time by which the stamps are late");
    for input in &inputs {
        d.replace(input, &format!("delay({input}, -{offset})"), |_| true);
    }
    d.start(&[10.0 * scene.step]);
    d.done(&format!(
        "the stamps of {} are {{0}} late (negative: early) against the others",
        scene.words(first)
    ))
}
