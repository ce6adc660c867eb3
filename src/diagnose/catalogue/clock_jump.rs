//! # What it is
//! From one moment on the stamps of one table are off: a clock was set, or samples were lost.
//!
//! # Signature in a recording
//! The residual is proportional to the rate of change of the channel, from one time on.
//!
//! # Equation
//! ```text
//!     u(t) -> u(t + jump step(t - tj)) for each channel of the table
//!     u(t) -> u(t - late step(t - tj)) for all inputs in a table with outputs: what is measured comes later from then on
//! ```
//!
//! # What else looks like this
//! parameter-change, clock-drift, gap.
//!
//! # Reference
//! D. L. Mills, Computer Network Time Synchronization, 2nd ed. (2010).
//!
//! # Example
//! A logger that drops a second while it writes its file; a compass whose messages wait longer from a restart on.

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
    let (tables, rows) = (scene.clocks(), scene.rows());
    let of_tables = tables.iter().filter_map(|inputs| of_table(scene, inputs));
    of_tables.chain(rows.iter().filter_map(|inputs| of_row(scene, inputs))).collect()
}

/// All that one table holds, against the others.
fn of_table(scene: &Scene, inputs: &[String]) -> Option<Proposal> {
    let d = from_a_moment(scene, inputs, ("jump", "-", "time by which the stamps jump late"))?;
    d.done(&format!("the stamps of {} jump by {{0}} at {{1}}", scene.words(inputs.first()?)))
}

/// The inputs of a row, against what is measured.
fn of_row(scene: &Scene, inputs: &[String]) -> Option<Proposal> {
    let d = from_a_moment(scene, inputs, ("late", "", "time by which what is measured comes later"))?;
    d.done(&format!(
        "what is measured comes {{0}} later (negative: sooner) after {} from {{1}} on",
        scene.words(inputs.first()?)
    ))
}

/// Inputs that are read at another time from a moment on.
fn from_a_moment<'s>(
    scene: &'s Scene<'s>,
    inputs: &[String],
    (name, sign, meaning): (&str, &str, &str),
) -> Option<Draft<'s>> {
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::new(scene, "clock-jump", SiteKind::Input, inputs.first()?);
    let reach = 0.1 * scene.length();
    let by = d.amplitude(name, &second, (-reach, reach), meaning);
    let time = d.parameter("tj", &second, scene.within(), "when they jump");
    for input in inputs {
        let before = format!("{input}*(1 - step(t - {time}))");
        d.replace(input, &format!("({before} + delay({input}, {sign}{by})*step(t - {time}))"), |_| true);
    }
    for moment in scene.moments() {
        d.start(&[10.0 * scene.step, moment]);
    }
    Some(d)
}
