//! What is said of a compass, its motion and its figures, in words that all reports share.

use super::{distribution, recorded, sea, tail};
use crate::gyro::validity::{LARGEST_MEAN, Smallness};
use crate::gyro::{Axis, IDLE};
use crate::rolling::{Against, Excitation, Origin, SeaMotion, Source, Table};
use crate::units::figure;
use std::f64::consts::{PI, TAU};

/// Where the numbers of a compass come from.
pub fn origin(o: &Origin) -> String {
    let base =
        o.builtin.as_ref().map_or_else(|| "the paper".into(), |name| format!("the built-in model {name}"));
    let mut text = if o.given.is_empty() {
        format!("numbers of {base}")
    } else {
        format!("{} as given, the rest of {base}", o.given.join(", "))
    };
    if !o.unused.is_empty() {
        text.push_str("; not used here: ");
        text.push_str(&o.unused.join(", "));
    }
    text
}

/// The elastic part, without the paper's name and numbers of equations.
pub fn part(name: &str) -> String {
    let spring = "damped spring";
    let plain =
        name.replace("lag with inertia (2.2)", "damped spring with inertia").replace("lag (2.3)", spring);
    if plain.starts_with("lag and") { plain.replacen("lag", spring, 1) } else { plain }
}

/// What the two parts of the spread are.
pub const PARTS_OF_SPREAD: &str = "spread: quick, with each roll of the ship, and slow, as strong and weak rolling come and go; \
the squares of both add up to its square";

/// The motion of a table.
pub fn motion(table: &Table) -> String {
    match (&table.excitation, &table.recorded) {
        (Some(e), _) => excitation(e, table.sea.as_ref(), matches!(table.against, Against::Height { .. })),
        (None, Some(r)) if r.mean.is_none() => format!(
            "the recorded roll itself, to {:.2} rad/s{}",
            PI / r.analysis.samples.step,
            r.band.map_or_else(String::new, |b| format!("; behind two low-passes at {b} rad/s"))
        ),
        (None, Some(r)) => format!(
            "the recorded roll by its fit, and the last column by its measured spectrum to {:.2} rad/s{}",
            PI / r.analysis.samples.step,
            r.band.map_or_else(String::new, |b| format!("; both behind two low-passes at {b} rad/s"))
        ),
        (None, None) => String::new(),
    }
}

/// An excitation, and how far the rational spectrum of its sea is off; of several sizes in turn, or of its own.
pub fn excitation(e: &Excitation, sea: Option<&SeaMotion>, in_turn: bool) -> String {
    let mut text = match &e.source {
        Source::Irregular(roll) => format!(
            "irregular roll, {}, μ = {} 1/s, ε = {} rad/s (period {} s)",
            size("standard deviation", roll.variance.sqrt(), in_turn),
            figure(roll.decay),
            figure(roll.frequency),
            figure(TAU / roll.frequency)
        ),
        Source::Regular(roll) => format!(
            "regular roll, {}, frequency {} rad/s (period {} s)",
            size("amplitude", roll.amplitude, in_turn),
            figure(roll.frequency),
            figure(TAU / roll.frequency)
        ),
        Source::Sea(waves) => sea::words(waves, sea, in_turn),
    };
    if let Some(corner) = e.band {
        text.push_str(&format!("; behind two low-passes at {} rad/s", figure(corner)));
    }
    text
}

/// The size of a roll, rad.
fn size(what: &str, size: f64, in_turn: bool) -> String {
    if in_turn { format!("of each {what} in turn") } else { format!("{what} {:.2}°", size.to_degrees()) }
}

/// What of the numbers to trust, in lines.
pub fn note(table: &Table) -> String {
    let mut out = trust(table, "trust the last column more");
    if !table.left_out.is_empty() {
        let left: Vec<String> = table.left_out.iter().map(ToString::to_string).collect();
        out.push_str(&format!(
            "Left out, since the linear theory would give a mean error beyond {:.0}°: {}.\n",
            LARGEST_MEAN.to_degrees(),
            left.join(", ")
        ));
    }
    out
}

/// The same but for what was left out; what follows where the mean by the measured spectrum is the one to trust.
pub fn trust(table: &Table, follows: &str) -> String {
    let mut out = match (&table.recorded, &table.tail) {
        (Some(measured), _) => recorded::differs(measured, follows),
        (None, Some(t)) => tail::text(t),
        (None, None) => not_linear(table),
    };
    out.push_str(&asides(table));
    out.push_str(unjudged(&table.smallness));
    out
}

/// What changes no mean, and why; empty where there is nothing.
pub fn idle(what: &str) -> String {
    if what.is_empty() { String::new() } else { format!("{what} changes no mean: {IDLE}.\n") }
}

/// What else is to be said of what was asked for.
fn asides(table: &Table) -> String {
    let waves = table.excitation.as_ref().and_then(Excitation::waves);
    let also = |axis: Axis| waves.is_some_and(|w| w.also.contains(&axis));
    let moved = match (also(Axis::Heave), also(Axis::Yaw)) {
        (true, true) => "heave or yaw",
        (false, true) => "yaw",
        (heaves, _) => {
            if heaves {
                "heave"
            } else {
                ""
            }
        }
    };
    let part = table.compass.part.idle();
    let mut out = String::new();
    if !(moved.is_empty() && part.is_empty()) {
        out.push_str(&idle(if part.is_empty() { moved } else { part }));
    }
    out + &sea::left_out(table) + &sea::off_by(table) + &distribution::words(table)
}

/// How the figures of a part that is not linear come about.
fn not_linear(table: &Table) -> String {
    if table.compass.instrument().is_linear().unwrap_or(true) {
        return String::new();
    }
    let name = part(table.compass.part.name());
    let (first, rest) = name.split_at(1);
    let regular = matches!(table.excitation, Some(Excitation { source: Source::Regular(_), .. }));
    let beside = if regular {
        "the mean is right within the margin of its step.\n"
    } else {
        "the mean is right within the margin told\n\
         (99 %, with the error of the step). The linearised mean (Booton, Caughey) stands beside it, with what it is off by.\n"
    };
    format!(
        "{}{rest} is not linear: mean and spread come from following it in time as it is; {beside}",
        first.to_uppercase()
    )
}

/// What of the linear theory does not hold; empty where all of it does.
pub fn beyond(smallness: &[Smallness]) -> String {
    let broken = smallness.iter().filter(|s| s.is_judged() && !s.holds());
    let broken: Vec<String> = broken.map(Smallness::told).collect();
    if broken.is_empty() {
        return String::new();
    }
    format!(
        "BEYOND THE LINEAR THEORY where the mean is largest: {}. The figures are a guide at best.",
        broken.join(", ")
    )
}

/// What of the linear theory cannot be judged.
pub fn unjudged(smallness: &[Smallness]) -> &'static str {
    if smallness.iter().all(Smallness::is_judged) {
        return "";
    }
    "The acceleration at the compass is infinite without a band, so it is not held against gravity: --band gives it an end.\n"
}

/// A number without a sign on its zero.
pub fn plain(degrees: f64) -> f64 {
    if degrees.abs() < 5e-6 { 0.0 } else { degrees }
}
