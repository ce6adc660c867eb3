//! What the head of an export says in words, and units.

use super::lowered::Lowered;
use crate::text::one_line;
use crate::units::Unit;

/// The lines of the head, without marks of comment.
pub(super) fn head(own: &Lowered<'_>, runs: bool) -> Vec<String> {
    let mut lines = vec![
        one_line(&own.model.name),
        format!("Written by gyrospec {}; needs nothing of it.", env!("CARGO_PKG_VERSION")),
        String::new(),
        "All values are in SI units and radians, parameters and outputs too. The unit that stands beside a name is SI; where"
            .to_string(),
        "the model file has another, it follows in parentheses.".to_string(),
    ];
    let changed: Vec<String> = own.names.changed().map(|(a, b)| format!("{a} is {b}")).collect();
    if !changed.is_empty() {
        lines.push(format!("Names that this language cannot take: {}.", changed.join(", ")));
    }
    if runs {
        lines.extend(runner(own).into_iter().map(str::to_string));
    }
    lines
}

fn runner(own: &Lowered<'_>) -> Vec<&'static str> {
    let mut lines = Vec::new();
    if own.steps() {
        lines.push("The runner takes fixed steps by the method of Runge and Kutta; more substeps make it more exact.");
    }
    if own.counts.signs > 0 && own.steps() {
        lines.push("A sign is constant over a step: its mean where it changes, and between -1 and 1 where it holds its");
        lines.push("argument at zero, so that dry friction sticks. Errors at such changes fall in proportion to the step.");
    }
    if own.counts.pasts > 0 {
        lines.push(
            "A delayed signal is remembered at the ends of the steps, and the cubic through them is read.",
        );
    }
    lines
}

/// A unit in SI, with that of the model file.
pub(super) fn unit(unit: &Unit) -> String {
    let si = si(unit);
    if si == unit.text() { si } else { format!("{si} (model file: {})", unit.text()) }
}

/// The words of a comment: unit and meaning.
pub(super) fn comment(of: &Unit, meaning: Option<&String>) -> String {
    match meaning {
        Some(meaning) => format!("{}: {}", unit(of), one_line(meaning)),
        None => unit(of),
    }
}

/// The SI unit; angles are told, and one that is SI stays as it is written.
pub(super) fn si(unit: &Unit) -> String {
    if unit.to_si(0.0) == 0.0 && unit.to_si(1.0) == 1.0 {
        return unit.text().to_string();
    }
    let plain = Unit::of(unit.dimension());
    let begins = |list: &[&str]| list.iter().any(|w| unit.text().starts_with(w));
    let is_angle =
        begins(&["rad", "mrad", "urad", "deg", "arcmin", "arcsec", "rev", "rpm"]) && !begins(&["degC"]);
    match plain.text() {
        "1" if is_angle => "rad".into(),
        "Hz" | "1/s" if is_angle => "rad/s".into(),
        other if is_angle && other.starts_with("1/") => format!("rad{}", &other[1..]),
        other => other.to_string(),
    }
}
