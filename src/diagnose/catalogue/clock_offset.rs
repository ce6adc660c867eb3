//! # What it is
//! The time stamps of one table are off by a constant, early or late, against those of the others; or what a logger
//! writes into one row of a table was not taken at one time, so that an output seems to answer before its input.
//!
//! # Signature in a recording
//! The residual is proportional to the rate of change of what the table holds; a shift of the
//! stamps removes it.
//!
//! # Equation
//! ```text
//!     u(t) -> u(t + offset) for each channel of the table
//!     u(t) -> u(t + offset), offset >= 0, for an input or all of them in a table with an output: late is input-delay
//!     u(t) -> u(t + offset), y(t) -> y(t - offset), offset >= 0, for inputs and outputs of one table or of all others,
//!             where several tables hold outputs: a logger that is early is all the others late
//! ```
//! What is read ahead begins ahead: where states begin at given numbers and not at rest, their beginning is off by what they
//! move in that time.
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
    if scene.trials {
        return Vec::new();
    }
    let of_tables = scene.clocks().iter().filter_map(|names| of_table(scene, names)).collect::<Vec<_>>();
    let (loggers, rows) = (loggers(scene), in_rows(scene));
    let of_loggers = loggers.iter().filter_map(|(inputs, outputs)| of_logger(scene, inputs, outputs));
    of_tables.into_iter().chain(of_loggers).chain(rows.iter().filter_map(|r| of_rows(scene, r))).collect()
}

/// Inputs and outputs that may be stamped late together: those of a table with outputs, and those of all others.
fn loggers(scene: &Scene) -> Vec<(Vec<String>, Vec<String>)> {
    let (inputs, outputs) = (&scene.model.inputs, &scene.model.outputs);
    let but = |names: Vec<String>, not: &[String]| names.into_iter().filter(|n| !not.contains(n)).collect();
    let mut found: Vec<(Vec<String>, Vec<String>)> = Vec::new();
    for (own, read) in scene.sensor_clocks() {
        let others = (
            but(inputs.iter().map(|i| i.name.clone()).collect(), &own),
            but(outputs.iter().map(|o| o.name.clone()).collect(), &read),
        );
        for logger in [(own, read), others] {
            // One output by itself that is late is output-delay.
            let alone = logger.0.is_empty() && logger.1.len() < 2;
            if !alone && !logger.1.is_empty() && !found.contains(&logger) {
                found.push(logger);
            }
        }
    }
    found
}

/// What a logger with outputs holds, against the others.
fn of_logger(scene: &Scene, inputs: &[String], outputs: &[String]) -> Option<Proposal> {
    let first = outputs.first()?;
    let d = late(scene, (SiteKind::Output, first, "time by which the stamps are late"), (inputs, outputs))?;
    let others = scene.model.outputs.iter().map(|o| &o.name).filter(|n| !outputs.contains(n));
    let others: Vec<String> = others.map(|n| scene.words(n)).collect();
    let first = scene.words(first);
    d.done(&format!(
        "the stamps of the table of {first} are {{0}} late against those of {}, or these as much early",
        others.join(", ")
    ))
}

/// Inputs that stand in the rows of an output: each, and all that the model has.
fn in_rows(scene: &Scene) -> Vec<Vec<String>> {
    let all = scene.rows();
    let each = all.iter().flatten().map(|n| vec![n.clone()]);
    let together = all.iter().filter(|all| all.len() > 1 && all.len() == scene.model.inputs.len());
    each.chain(together.cloned()).collect()
}

/// All that one table holds, against the others.
fn of_table(scene: &Scene, inputs: &[String]) -> Option<Proposal> {
    let first = inputs.first()?;
    let reach = 0.1 * scene.length();
    let mut d = Draft::new(scene, "clock-offset", SiteKind::Input, first);
    let meaning = "time by which the stamps are late";
    let offset = d.amplitude("offset", &Unit::parse("s").ok()?, (-reach, reach), meaning);
    shift(&mut d, inputs, &offset);
    d.start(&[10.0 * scene.step]);
    d.done(&format!(
        "the stamps of {} are {{0}} late (negative: early) against the others",
        scene.words(first)
    ))
}

/// Inputs against the outputs of the same rows.
fn of_rows(scene: &Scene, inputs: &[String]) -> Option<Proposal> {
    let d = late(scene, (SiteKind::Input, inputs.first()?, "time by which they are late"), (inputs, &[]))?;
    let words: Vec<String> = inputs.iter().map(|n| scene.words(n)).collect();
    d.done(&format!("{} stands {{0}} too late in its rows: the output answers before it", words.join(", ")))
}

/// Inputs and outputs whose stamps are late together: what they hold was taken before.
fn late<'s>(
    scene: &'s Scene<'s>,
    (kind, site, meaning): (SiteKind, &str, &str),
    (inputs, outputs): (&[String], &[String]),
) -> Option<Draft<'s>> {
    let mut d = Draft::new(scene, "clock-offset", kind, site);
    let offset = d.parameter("offset", &Unit::parse("s").ok()?, (0.0, 0.1 * scene.length()), meaning);
    shift(&mut d, inputs, &offset);
    for output in outputs {
        d.output(output, &format!("delay({{}}, {offset})"));
    }
    for start in scene.delays() {
        d.start(&[start]);
    }
    Some(d)
}

/// Takes inputs from a later time.
fn shift(d: &mut Draft<'_>, inputs: &[String], offset: &str) {
    for input in inputs {
        d.replace(input, &format!("delay({input}, -{offset})"), |_| true);
    }
}
