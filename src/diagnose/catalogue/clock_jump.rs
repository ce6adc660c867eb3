//! # What it is
//! From one moment on the stamps of one table are off: a clock was set, or samples were lost.
//!
//! # Signature in a recording
//! The residual is proportional to the rate of change of the channel, from one time on.
//!
//! # Equation
//! ```text
//!     u(t) -> u(t + jump step(t - tj)) for each channel of the table
//! ```
//!
//! # What else looks like this
//! parameter-change, clock-drift, gap.
//!
//! # Reference
//! D. L. Mills, Computer Network Time Synchronization, 2nd ed. (2010).
//!
//! # Example
//! A logger that drops a second while it writes its file.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::units::Unit;

/// A clock that jumps.
pub(super) const MECHANISM: Mechanism =
    Mechanism::new("clock-jump", "a clock that jumps", Group::Output, include_str!("clock_jump.rs"), propose)
        .shifting_time();

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.clocks().iter().filter_map(|t| at(scene, t)).collect()
}

fn at(scene: &Scene, inputs: &[String]) -> Option<Proposal> {
    let first = inputs.first()?;
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::new(scene, "clock-jump", SiteKind::Input, first);
    let reach = 0.1 * scene.length();
    let jump = d.amplitude("jump", &second, (-reach, reach), "time by which the stamps jump late");
    let time = d.parameter("tj", &second, (scene.from, scene.to), "when they jump");
    for input in inputs {
        let early = format!("{input}*(1 - step(t - {time}))");
        d.replace(input, &format!("({early} + delay({input}, -{jump})*step(t - {time}))"), |_| true);
    }
    for moment in scene.moments() {
        d.start(&[10.0 * scene.step, moment]);
    }
    d.done(&format!("the stamps of {} jump by {{0}} at {{1}}", scene.words(first)))
}
