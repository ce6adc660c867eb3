//! # What it is
//! The clock of one table runs at another rate than that of the others.
//!
//! # Signature in a recording
//! A time shift that grows through the recording.
//!
//! # Equation
//! ```text
//!     u(t) -> u(t + rate (t - t0)) for each channel of the table
//! ```
//!
//! # What else looks like this
//! clock-offset in a short recording, clock-jump.
//!
//! # Reference
//! D. L. Mills, Computer Network Time Synchronization, 2nd ed. (2010).
//!
//! # Example
//! A logger with its own quartz, 100 parts in a million fast, over a day.

use super::{Draft, Group, Mechanism, Proposal, Scene, SiteKind};
use crate::units::Unit;

/// A clock that runs fast or slow.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "clock-drift",
    "a clock that runs fast or slow",
    Group::Output,
    include_str!("clock_drift.rs"),
    propose,
)
.shifting_time();

/// Parts of the recording, over which the shift is straight.
const PARTS: u32 = 8;

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    scene.clocks().iter().filter_map(|t| at(scene, t)).collect()
}

fn at(scene: &Scene, inputs: &[String]) -> Option<Proposal> {
    let first = inputs.first()?;
    let mut d = Draft::new(scene, "clock-drift", SiteKind::Input, first);
    let rate = d.amplitude("rate", &Unit::one(), (-0.2, 0.2), "by how much the clock runs fast, s a second");
    d.term(&format!("{first} on a clock of another rate"));
    let second = Unit::parse("s").ok()?;
    // The shift goes on growing in what is held out.
    let (from, to) = scene.whole;
    let start = d.constant("t0", &second, from, "beginning of the recording");
    let part = (to - from) / f64::from(PARTS);
    let width = d.constant("part", &second, part, "an eighth of the recording");
    for input in inputs {
        // Between its grid points the shift is interpolated.
        let copy = |i: u32| {
            let weight = if i == PARTS {
                format!("clamp((t - {start})/{width} - {}, 0, 1)", PARTS - 1)
            } else {
                format!("max(0, 1 - abs((t - {start})/{width} - {i}))")
            };
            format!("delay({input}, -{rate}*{i}*{width})*{weight}")
        };
        let copies: Vec<String> = (0..=PARTS).map(copy).collect();
        d.replace(input, &format!("({})", copies.join(" + ")), |_| true);
    }
    d.term(&format!("{first}(t + {rate}*(t - {start}))"));
    d.start(&[20.0 * scene.step / scene.length()]);
    d.done(&format!("the clock of {} gains {{0}} s a second on the others", scene.words(first)))
}
