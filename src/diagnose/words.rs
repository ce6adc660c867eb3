//! Sentences for people.

use super::catalogue::{Limits, Proposal};
use crate::estimate::Fit;
use crate::model::Model;
use crate::units::{figure, figure_of};

/// A number with its unit; pure numbers have none.
pub fn quantity(value: f64, unit: &str) -> String {
    if unit == "1" { figure(value) } else { format!("{} {unit}", figure(value)) }
}

/// Words for a signal or parameter: its meaning where the model gives one, else its name.
pub fn signal(m: &Model, name: &str) -> String {
    let state = m.states.iter().find(|s| s.name == name).and_then(|s| s.meaning.clone());
    let input = || m.inputs.iter().find(|i| i.name == name).and_then(|i| i.meaning.clone());
    let output = || m.outputs.iter().find(|o| o.name == name).and_then(|o| o.meaning.clone());
    let parameter = || m.parameters.iter().find(|p| p.name == name).and_then(|p| p.meaning.clone());
    let definition = || m.definitions.iter().find(|d| d.name == name).and_then(|d| d.meaning.clone());
    let meaning = state.or_else(input).or_else(output).or_else(parameter).or_else(definition);
    meaning.map_or_else(|| name.to_string(), |words| format!("{words} ({name})"))
}

/// Share of the time in which it may lie from which on the moment of a change is not known.
const UNKNOWN: f64 = 0.5;

/// Whether an added parameter is the moment of a change, and may lie in most of the time that was fitted.
fn is_untold(p: &Proposal, number: usize, fit: &Fit) -> bool {
    let timed = ["parameter-change", "clock-jump"].contains(&p.code) && !p.amplitudes.contains(&number);
    let estimate = fit.parameters.iter().find(|e| e.name == p.added[number].name);
    timed && estimate.is_some_and(|e| covers(p.limits[number], (e.low, e.high)))
}

/// Whether an interval covers so much of what is possible that it tells nothing, as one without numbers does.
fn covers(limits: Limits, interval: (f64, f64)) -> bool {
    let width = interval.1.min(limits.1) - interval.0.max(limits.0);
    width.is_nan() || interval.0.is_nan() || width >= UNKNOWN * (limits.1 - limits.0)
}

/// How one that fits as well is called beside another: by its code, and by its place where both have the same.
pub fn beside(first: &Proposal, other: &Proposal) -> String {
    let place = if first.code == other.code { format!(" of {}", other.site.name) } else { String::new() };
    format!("{}{place}", other.code)
}

/// Digits of a constant: as many as a value has whose interval is narrow.
const DIGITS: usize = 6;

/// The constants that stand in a mechanism's term or sentence, in brackets behind it; empty where there are none.
fn constants(p: &Proposal) -> String {
    let stands_in = |text: &str, name: &str| {
        text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name)
    };
    let stands = |name: &String| stands_in(&p.term, name) || stands_in(&p.says, name);
    let told = p.model.parameters.iter().filter(|q| p.constants.contains(&q.name) && stands(&q.name));
    let told: Vec<String> = told
        .map(|q| {
            let value = figure_of(q.unit.from_si(q.value), DIGITS);
            let unit = if q.unit.text() == "1" { "" } else { q.unit.text() };
            format!("{} = {value} {unit}", q.name).trim_end().to_owned()
        })
        .collect();
    if told.is_empty() { String::new() } else { format!(" ({})", told.join(", ")) }
}

/// A mechanism's sentence with the fitted values in it, and with the constants that its law needs.
pub fn sentence(p: &Proposal, fit: &Fit) -> String {
    let mut says = p.says.clone();
    for (i, a) in p.added.iter().enumerate() {
        if is_untold(p, i, fit) {
            says = says.replace(&format!(" at {{{i}}}"), ", at a time that this recording does not tell");
        }
        let value = fit.model.parameters.iter().find(|q| q.name == a.name).map_or(f64::NAN, |q| q.value);
        says = says.replace(&format!("{{{i}}}"), &quantity(a.unit.difference_from_si(value), a.unit.text()));
    }
    says + &constants(p)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_in_half_of_the_recording_or_more_is_not_known() {
        let of = |low: f64, high: f64| covers((0.0, 120.0), (low, high));
        assert!(!of(77.0, 82.4) && !of(100.0, 140.0));
        assert!(of(0.0, 120.0) && of(-500.0, 700.0) && of(40.0, 101.0) && of(f64::NAN, f64::NAN));
    }
}
