//! What would tell more: the experiment or the measurement that parts what this recording cannot.

use super::answer::Verdict;
use super::catalogue::{Proposal, SiteKind};
use super::search::Found;
use crate::model::Model;

/// What the next experiment should be, for a verdict.
pub fn experiment(model: &Model, found: &Found, verdict: Verdict, blind: Option<&str>) -> Option<String> {
    match verdict {
        Verdict::NotIdentifiable => blind.map(|b| format!("{b}: record again with what is missing there.")),
        Verdict::Tie => {
            let first = found.taken.first()?;
            separation(&first.proposal, &first.ties)
        }
        Verdict::Unknown => Some(format!(
            "Repeat the recording at half and at twice the amplitude, and record {} beside it: a law of two signals shows itself when one of them is held.",
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

/// What parts a mechanism from those that fit as well.
pub fn separation(first: &Proposal, ties: &[Proposal]) -> Option<String> {
    let other = ties.first()?;
    let kinds = [first.site.kind, other.site.kind];
    let has = |k: SiteKind| kinds.contains(&k);
    let codes = format!("{} {}", first.code, other.code);
    let text = if has(SiteKind::Output) && (has(SiteKind::Input) || has(SiteKind::State)) {
        format!(
            "a second, independent sensor of {}: a fault of one sensor does not show in the other",
            site_of(first, other, SiteKind::Output)
        )
    } else if codes.contains("offset") || codes.contains("constant") {
        "a recording with the input switched off: an offset of the input goes with its cable, a force stays"
            .to_string()
    } else if codes.contains("lag") || codes.contains("delay") || codes.contains("inertia") {
        "an input with faster changes, up to ten times the present band: lags, delays and inertias part there"
            .to_string()
    } else if codes.contains("friction") || codes.contains("damping") || codes.contains("stiffness") {
        "recordings at a third and at three times the amplitude: friction, damping and stiffness scale apart"
            .to_string()
    } else {
        "a recording in which the signals of the two vary independently of each other".to_string()
    };
    Some(format!("{} and {} fit alike here. What would part them: {text}.", first.code, other.code))
}

fn site_of<'a>(a: &'a Proposal, b: &'a Proposal, kind: SiteKind) -> &'a str {
    if a.site.kind == kind { &a.site.name } else { &b.site.name }
}
