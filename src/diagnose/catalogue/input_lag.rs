//! # What it is
//! What is recorded acts on the system through a first-order lag: an amplifier, a valve, a warming
//! filament.
//!
//! # Signature in a recording
//! Corners of the input are rounded in the response.
//!
//! # Equation
//! ```text
//!     u -> lag(u, Tl),  Tl >= 0
//! ```
//!
//! # What else looks like this
//! output-lag (the same in a linear model with one input), input-delay at low frequency,
//! neglected-inertia.
//!
//! # Reference
//! L. Ljung, System Identification, 2nd ed. (1999), ch. 4.
//!
//! # Example
//! A valve that needs half a second to open.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind};
use crate::units::Unit;

/// A lag of an input.
pub(super) const MECHANISM: Mechanism =
    Mechanism::new("input-lag", "a lag of an input", Group::Input, include_str!("input_lag.rs"), propose)
        .shifting_time();

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.moving(&[SignalKind::Input]).filter_map(|u| at(scene, u)).collect()
}

fn at(scene: &Scene, u: &Signal) -> Option<Proposal> {
    let mut d = Draft::new(scene, "input-lag", SiteKind::Input, &u.name);
    let time = d.parameter("Tl", &Unit::parse("s").ok()?, (0.0, 0.5 * scene.length()), "time of the lag");
    d.replace(&u.name, &format!("lag({}, {time})", u.name), |_| true);
    for start in scene.times() {
        d.start(&[start]);
    }
    d.done(&format!("{} acts on the system through a lag of {{0}}", scene.words(&u.name)))
}
