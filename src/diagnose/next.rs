//! What would tell more: the experiment or the measurement that parts what this recording cannot.

use super::answer::Verdict;
use super::apart::{self, Apart};
use super::bench::Bench;
use super::catalogue::{Proposal, SiteKind};
use super::search::{Found, Refitted, Taken};
use super::words;
use crate::model::Model;
use crate::units::figure;

/// Difference of two predictions, over what is left, from which on a recording shows it.
const SEEN: f64 = 0.5;
/// The same below which two predictions are one.
const SAME: f64 = 1e-3;

/// What to do where the search was not through.
pub const PATIENCE: &str =
    "Start the parameters nearer to the instrument's and bound them, or give the search more time.";

/// What tells a step of a sensor from one of the system.
pub fn second_sensor(output: &str) -> String {
    format!(
        "Record {output} by a second, independent sensor too: a step of one sensor's zero does not show in the other, a push on the system shows in both."
    )
}

/// What tells of a disturbance that nobody recorded.
pub fn still(state: &str) -> String {
    format!(
        "Record beside it what may act on {state} (weather, people, loads, a neighbouring machine), or repeat the recording where that is still: what is left then shows what else is missing."
    )
}

/// What tells of a law that fits and cannot be run beyond where it was fitted.
pub fn wider(fallen: &Refitted) -> String {
    let over = listed(fallen.proposal.depends.iter()).unwrap_or_else(|| fallen.proposal.site.name.clone());
    format!(
        "Fit a part in which {over} ranges as widely as where it is held out: what fits here cannot be run there."
    )
}

/// What the next experiment should be, for a verdict.
pub fn experiment(
    model: &Model,
    bench: &Bench,
    found: &Found,
    verdict: Verdict,
    blind: Option<&str>,
) -> Option<String> {
    match verdict {
        Verdict::NotIdentifiable => {
            blind.map(|b| format!("Record again, for longer and over more of the range: {b}."))
        }
        Verdict::Tie => {
            let first = found.taken.first()?;
            let text = separation(model, &first.proposal, &first.ties)?;
            Some(
                format!("{text} {}", expected(model, bench, first).unwrap_or_default())
                    .trim_end()
                    .to_string(),
            )
        }
        Verdict::Unknown => Some(format!(
            "Repeat the recording at half and at twice the amplitude of {}, and record {} beside it: a law of two signals shows itself when one of them is held.",
            listed(model.inputs.iter().map(|i| &i.name)).unwrap_or_else(|| "its motion".into()),
            unseen_state(model).unwrap_or_else(|| "temperature and load".into())
        )),
        _ => None,
    }
}

/// A state that no output shows directly.
fn unseen_state(model: &Model) -> Option<String> {
    let shown = |name: &str| model.outputs.iter().any(|o| o.equals.mentions(name));
    model.states.iter().find(|s| !shown(&s.name)).map(|s| s.meaning.clone().unwrap_or_else(|| s.name.clone()))
}

/// By how much it and the first that fits as well would differ, in words.
fn expected(model: &Model, bench: &Bench, taken: &Taken) -> Option<String> {
    let Apart { input, swing, output, difference, ratio } = apart::farthest(bench, taken.rivals.as_ref()?)?;
    let output = &model.outputs[output];
    let unit = output.unit.of_differences();
    let size = words::quantity(unit.difference_from_si(difference), unit.text());
    Some(if ratio < SAME {
        "Inputs of half or twice the size would not: both predict the same.".to_string()
    } else if ratio < SEEN {
        format!(
            "Inputs of half or twice the size would not: the two would differ by {size} in {} at most, less than half of what is left there now.",
            output.name
        )
    } else {
        format!(
            "With {input} at {swing} its size the two would differ by {size} in {} (root mean square), {} times what is left there now.",
            output.name,
            figure(ratio)
        )
    })
}

/// What parts a mechanism from those that fit as well.
pub fn separation(model: &Model, first: &Proposal, ties: &[Proposal]) -> Option<String> {
    let other = ties.first()?;
    let inputs = listed(model.inputs.iter().map(|i| &i.name)).unwrap_or_else(|| "its inputs".into());
    let outputs = listed(model.outputs.iter().map(|o| &o.name)).unwrap_or_else(|| "its outputs".into());
    let kinds = [first.site.kind, other.site.kind];
    let has = |k: SiteKind| kinds.contains(&k);
    let codes = format!("{} {}", first.code, other.code);
    let text = if has(SiteKind::Output) && (has(SiteKind::Input) || has(SiteKind::State)) {
        format!(
            "a second, independent sensor of {}: a fault of one sensor does not show in the other",
            site_of(first, other, SiteKind::Output)
        )
    } else if codes.contains("offset") || codes.contains("constant") {
        format!(
            "a second, independent reading of {inputs}: an offset of one shows where the two part, a force does not"
        )
    } else if codes.contains("lag") || codes.contains("delay") || codes.contains("inertia") {
        format!(
            "faster changes of {inputs}, up to ten times the present band: lags, delays and inertias part there"
        )
    } else if codes.contains("friction") || codes.contains("damping") || codes.contains("stiffness") {
        format!(
            "recordings at a third and at three times the amplitude of {outputs}: friction, damping and stiffness scale apart"
        )
    } else {
        let [one, two] = [first, other].map(|p| p.depends.first().unwrap_or(&p.site.name));
        if one == two {
            format!("a recording in which {one} covers three times this range")
        } else {
            format!("a recording in which {one} and {two} vary independently of each other")
        }
    };
    let names = (words::beside(other, first), words::beside(first, other));
    Some(format!("{} and {} fit equally well here. To tell them apart: {text}.", names.0, names.1))
}

/// Different names, with "and" before the last; none where there are none.
fn listed<'a>(names: impl Iterator<Item = &'a String>) -> Option<String> {
    let mut different: Vec<&str> = Vec::new();
    for name in names {
        if !different.contains(&name.as_str()) {
            different.push(name);
        }
    }
    let (last, others) = different.split_last()?;
    Some(if others.is_empty() { (*last).to_owned() } else { format!("{} and {last}", others.join(", ")) })
}

fn site_of<'a>(a: &'a Proposal, b: &'a Proposal, kind: SiteKind) -> &'a str {
    if a.site.kind == kind { &a.site.name } else { &b.site.name }
}
