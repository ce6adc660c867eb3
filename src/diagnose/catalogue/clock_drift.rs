//! # What it is
//! The clock of one table runs at another rate than that of the others, or did before both were joined row by row.
//!
//! # Signature in a recording
//! A time shift that grows through the recording.
//!
//! # Equation
//! ```text
//!     u(t) -> u(t + rate (t - t0)) for each input of the table,
//!     y(t) -> y(t - rate (t - t0)) for each output, of a clock that is fast
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

/// Parts of the recording, over which the shift is straight: of inputs, and where outputs that have to be remembered go
/// with them, each part of which costs a mesh and a past.
const PARTS: u32 = 8;
const FEWER: u32 = 4;
/// The same of rows that were joined, where it is a guess at most.
const JOINED: u32 = 2;
/// The largest rate.
const MOST: f64 = 0.2;

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let of_inputs = scene.clocks().into_iter().map(|inputs| (inputs, Vec::new()));
    let of_tables = of_inputs.chain(scene.sensor_clocks());
    let all = of_tables.filter_map(|(inputs, outputs)| at(scene, &inputs, &outputs, None));
    all.chain(of_rows(scene).and_then(|inputs| at(scene, &inputs, &[], Some(JOINED)))).collect()
}

/// The inputs of a model where one table holds all: who joined them by their times, row by row, took the clocks for one.
fn of_rows(scene: &Scene) -> Option<Vec<String>> {
    let inputs: Vec<String> = scene.model.inputs.iter().map(|i| i.name.clone()).collect();
    let outputs = scene.model.outputs.iter().map(|o| &o.name);
    let all: Vec<&String> = inputs.iter().chain(outputs).collect();
    let is_one = scene.tables.iter().any(|t| all.iter().all(|n| t.contains(n)));
    (is_one && !inputs.is_empty()).then_some(inputs)
}

/// A time that grows with the recording, straight over each of its parts.
struct Shift {
    start: String,
    part: String,
    parts: u32,
}

impl Shift {
    fn of(scene: &Scene, d: &mut Draft, parts: u32) -> Option<Self> {
        let second = Unit::parse("s").ok()?;
        // The shift goes on growing in what is held out.
        let (from, to) = scene.whole;
        let start = d.constant("t0", &second, from, "beginning of the recording");
        let part = (to - from) / f64::from(parts);
        let part = d.constant("part", &second, part, "a part of the recording");
        Some(Self { start, part, parts })
    }

    /// Something later by a rate times the time since the beginning.
    fn late(&self, what: &str, rate: &str) -> String {
        let Self { start, part, parts } = self;
        // Between its grid points the shift is interpolated.
        let copy = |i: u32| {
            let weight = if i == *parts {
                format!("clamp((t - {start})/{part} - {}, 0, 1)", parts - 1)
            } else {
                format!("max(0, 1 - abs((t - {start})/{part} - {i}))")
            };
            format!("delay({what}, {rate}*{i}*{part})*{weight}")
        };
        (0..=*parts).map(copy).collect::<Vec<String>>().join(" + ")
    }
}

/// What inputs hold is known before and after, what a model makes before alone: of several clocks with outputs one is fast
/// and reads late.
fn at(scene: &Scene, inputs: &[String], outputs: &[String], parts: Option<u32>) -> Option<Proposal> {
    let first = outputs.first().or(inputs.first())?;
    let (kind, least, most) = match (inputs.is_empty(), outputs.is_empty()) {
        (_, true) => (SiteKind::Input, -MOST, PARTS),
        (true, false) => (SiteKind::Output, 0.0, PARTS),
        (false, false) => (SiteKind::Output, 0.0, FEWER),
    };
    let mut d = Draft::new(scene, "clock-drift", kind, first);
    let rate =
        d.amplitude("rate", &Unit::one(), (least, MOST), "by how much the clock runs fast, s a second");
    d.term(&format!("{first} on a clock of another rate"));
    let shift = Shift::of(scene, &mut d, parts.unwrap_or(most))?;
    for input in inputs {
        d.replace(input, &format!("({})", shift.late(input, &format!("-{rate}"))), |_| true);
    }
    for output in outputs {
        d.output(output, &shift.late("{}", &rate));
    }
    d.start(&[20.0 * scene.step / scene.length()]);
    let others = if inputs.len() + outputs.len() > 1 { " and of what else stands in its table" } else { "" };
    d.done(&format!("the clock of {}{others} gains {{0}} s a second on the others", scene.words(first)))
}
