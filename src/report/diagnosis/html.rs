//! A diagnosis as one page that opens offline.

use super::figures;
use super::tables;
use super::text::title;
use super::text::{headline, hints};
use crate::diagnose::Diagnosis;
use crate::diagnose::answer::{Answer, FREE_LAW, Finding, Verdict, at_fault, told};
use crate::diagnose::pictures::Pictures;
use crate::estimate::Direction;
use crate::report::page::{self, Page, Section};
use crate::report::svg::escaped;
use crate::report::{correlation, fit};
use crate::units::without_needless_zeros;
use std::path::Path;

/// The page of a diagnosis.
pub fn html(d: &Diagnosis) -> String {
    let unseen = fit::unseen(&d.after.unseen, &d.after.determined);
    whole(&d.before.model.name, &d.answer, &d.pictures, unseen)
}

/// The page of an answer about a model, with its pictures and what the data do not tell of its unknowns.
pub fn page(model: &str, a: &Answer, pictures: &Pictures, unseen: &[Direction]) -> String {
    whole(model, a, pictures, fit::unseen(unseen, &[]))
}

fn whole(model: &str, a: &Answer, pictures: &Pictures, unseen: String) -> String {
    let page = Page {
        kind: format!("Diagnosis of the model “{model}”"),
        title: format!("{model}: {}", headline(a).to_lowercase()),
        verdict: sentence(a),
        lead: without_needless_zeros(&a.says),
        sections: sections(a, pictures, unseen),
    };
    page.html()
}

fn sections(a: &Answer, pictures: &Pictures, unseen: String) -> Vec<Section> {
    let sure = !matches!(a.verdict, Verdict::Unknown | Verdict::NotIdentifiable);
    let inputs = a.made.inputs.iter().map(|i| (Path::new(&i.file), i.sha256.as_str()));
    vec![
        Section::new(
            "findings",
            if sure { "What was found" } else { "What it resembles" },
            tables::findings(a),
        ),
        Section::new("faults", "Where the data are at fault", tables::faults(a) + &figures::faults(pictures)),
        Section::new("laws", "The law, seen in the recording", figures::laws(pictures, a)),
        Section::new("courses", "Recording and model", figures::courses(pictures)),
        Section::new("residuals", "What the model leaves over time", figures::residuals(pictures, a)),
        Section::new("spectra", "What it leaves in frequency", figures::spectra(pictures, a)),
        Section::new(
            "correlations",
            "What it leaves, against itself and its inputs",
            correlation::section(&pictures.left_before, &pictures.left_after),
        ),
        Section::new("proof", "Proof on what was held out", tables::proof(a)),
        Section::new("sites", "What was considered", tables::tried(pictures, a)),
        Section::new("unexplained", "What no name explains", figures::unexplained(a)),
        Section::new("parameters", "Parameters before and after", tables::parameters(a)),
        Section::new("unseen", "What these data do not tell", unseen),
        Section::new("visible", "What would have been seen", tables::visible(a)),
        Section::new("next", "What would tell next", next(a)),
        Section::new("notes", "What to know beside", notes(a)),
        page::made(&a.made.program, a.made.seed, inputs),
    ]
}

/// What was not compared, not offered or left unfinished, a paragraph each.
fn notes(a: &Answer) -> String {
    a.notes.iter().map(|n| format!("<p>{}</p>", escaped(&without_needless_zeros(n)))).collect()
}

/// The verdict in one sentence, and the faults of the data in another.
fn sentence(a: &Answer) -> String {
    let (_, found) = told(&a.findings);
    let faults: Vec<&Finding> = a.faults.iter().filter(|f| !f.is_reading()).map(|f| &f.finding).collect();
    let said = format!("{}{}", listed(&titles(&faults)), place(&faults));
    match a.verdict {
        Verdict::DataFault if found.is_empty() => format!("{}: {said}.", at_fault(&a.faults)),
        Verdict::DataFault => format!(
            "{}: {said}. The model also leaves out {}{}.",
            at_fault(&a.faults),
            listed(&titles(&found)),
            place(&found)
        ),
        _ if faults.is_empty() => physics(a, &found),
        _ => format!("{} The data have faults too: {said}.", physics(a, &found)),
    }
}

/// The verdict on the physics.
fn physics(a: &Answer, found: &[&Finding]) -> String {
    let names = titles(found);
    match a.verdict {
        Verdict::Named => format!("The model leaves out {}{}.", listed(&names), place(found)),
        Verdict::Tie => {
            let ties: Vec<String> =
                a.findings.iter().flat_map(|f| &f.ties).map(|c| title(c).to_owned()).collect();
            format!(
                "The model leaves out {}{}; {} would fit as well.",
                names.first().map_or("something", String::as_str),
                place(&found[..found.len().min(1)]),
                listed(&ties)
            )
        }
        Verdict::Unknown if found.iter().any(|f| f.code == FREE_LAW) => format!(
            "Something is missing that no name of the catalogue fits; as {} it is in the model{}.",
            title(FREE_LAW),
            place(&found.iter().filter(|f| f.code == FREE_LAW).copied().collect::<Vec<_>>())
        ),
        Verdict::Unknown => "Something is missing that no name of the catalogue fits.".into(),
        Verdict::NothingMissing | Verdict::DataFault => "Nothing is missing.".into(),
        Verdict::NotIdentifiable => "This recording cannot tell what is missing.".into(),
    }
}

fn titles(all: &[&Finding]) -> Vec<String> {
    let mut different: Vec<String> = Vec::new();
    for f in all {
        if !different.iter().any(|t| t == title(&f.code)) {
            different.push(title(&f.code).to_owned());
        }
    }
    different
}

/// Where it is, of one alone.
fn place(all: &[&Finding]) -> String {
    match all {
        [f] => format!(" ({} {})", f.site.kind, f.site.name),
        _ => String::new(),
    }
}

fn listed(names: &[String]) -> String {
    match names {
        [] => "something".into(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

/// What would tell next; where nothing was asked for, what would confirm the answer.
fn next(a: &Answer) -> String {
    let said = hints(a);
    if said.is_empty() {
        return format!("<p>{}</p>", escaped(&confirmation(a)));
    }
    said.iter().map(|s| format!("<p>{}</p>", escaped(s))).collect()
}

/// What would confirm an answer that asks for no experiment.
fn confirmation(a: &Answer) -> String {
    let (_, others) = told(&a.findings);
    let mut channels: Vec<String> = a.faults.iter().map(|f| f.finding.site.name.clone()).collect();
    channels.dedup();
    match a.verdict {
        Verdict::DataFault if others.is_empty() => format!(
            "Record {} again without the fault and diagnose again: only that can show whether anything else is missing.",
            listed(&channels)
        ),
        Verdict::DataFault => format!(
            "Record {} again without the fault and diagnose again: what was found beside it rests on the other samples alone.",
            listed(&channels)
        ),
        Verdict::NothingMissing => "Nothing further is needed.".into(),
        _ => "Nothing further is needed for the name; another recording, given with --holdout, would confirm it.".into(),
    }
}
