//! A diagnosis as one page that opens offline, without scripts.

use super::figures;
use super::tables;
use super::text::headline;
use crate::diagnose::Diagnosis;
use crate::diagnose::answer::{Answer, Verdict};
use crate::diagnose::catalogue;
use crate::diagnose::pictures::Pictures;
use crate::report::svg::escaped;
use std::fmt::Write;

const STYLE: &str = include_str!("style.css");

/// A part of the page: its name, its heading, its content; left out where it has none.
struct Section {
    name: &'static str,
    heading: &'static str,
    content: String,
}

/// The page of a diagnosis.
pub fn html(d: &Diagnosis) -> String {
    page(&d.before.model.name, &d.answer, &d.pictures)
}

/// The page of an answer about a model, with its pictures.
pub fn page(model: &str, a: &Answer, pictures: &Pictures) -> String {
    let sections = sections(a, pictures);
    let title = escaped(&format!("{}: {}", model, headline(a.verdict).to_lowercase()));
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><meta name=\"color-scheme\" content=\"light dark\"><link rel=\"icon\" href=\"data:,\"><title>{title}</title><style>\n{STYLE}</style></head><body>\n<header><p class=\"note\">Diagnosis of the model “{}”</p><h1 id=\"verdict\">{}</h1><p class=\"lead\">{}</p></header>\n<nav>",
        escaped(model),
        escaped(&sentence(a)),
        escaped(&a.says)
    );
    for s in &sections {
        let _ = write!(page, "<a href=\"#{}\">{}</a> ", s.name, s.heading);
    }
    page.push_str("</nav>\n<main>");
    for s in &sections {
        let _ = write!(page, "\n<section id=\"{}\"><h2>{}</h2>{}</section>", s.name, s.heading, s.content);
    }
    page + "</main></body></html>\n"
}

fn sections(a: &Answer, pictures: &Pictures) -> Vec<Section> {
    let section = |name, heading, content| Section { name, heading, content };
    let mut all = vec![
        section("findings", "What was found", tables::findings(a)),
        section("faults", "Where the data are at fault", figures::faults(pictures)),
        section("laws", "The law, seen in the recording", figures::laws(pictures, a)),
        section("courses", "Recording and model", figures::courses(pictures)),
        section("residuals", "What the model leaves over time", figures::residuals(pictures, a)),
        section("spectra", "What it leaves in frequency", figures::spectra(pictures, a)),
        section("proof", "Proof on what was held out", tables::proof(a)),
        section("sites", "What was considered", tables::tried(pictures, a)),
        section("unexplained", "What no name explains", figures::unexplained(a)),
        section("parameters", "Parameters before and after", tables::parameters(a)),
        section("visible", "What would have been seen", tables::visible(a)),
        section("next", "What would tell next", next(a)),
        section("made", "How this was made", tables::made(a)),
    ];
    all.retain(|s| !s.content.is_empty());
    all
}

/// The verdict in one sentence.
fn sentence(a: &Answer) -> String {
    let names: Vec<&str> = a.findings.iter().map(|f| title(&f.code)).collect();
    let at = a.findings.first().map(|f| format!(" ({} {})", f.site.kind, f.site.name)).unwrap_or_default();
    match a.verdict {
        Verdict::Named if names.len() == 1 => format!("The model leaves out {}{at}.", names[0]),
        Verdict::Named => format!("The model leaves out {}.", listed(&names)),
        Verdict::Tie => {
            let ties: Vec<&str> = a.findings.iter().flat_map(|f| &f.ties).map(|c| title(c)).collect();
            format!(
                "The model leaves out {}{at}; {} would fit as well.",
                names.first().unwrap_or(&"something"),
                listed(&ties)
            )
        }
        Verdict::Unknown => "Something is missing that no name of the catalogue fits.".into(),
        Verdict::NothingMissing => "Nothing is missing.".into(),
        Verdict::DataFault => format!("The data are at fault: {}{at}.", listed(&names)),
        Verdict::NotIdentifiable => "This recording cannot tell what is missing.".into(),
    }
}

/// The plain words of a code.
pub(super) fn title(code: &str) -> &str {
    catalogue::find(code).map_or(code, |m| m.title)
}

fn listed(names: &[&str]) -> String {
    match names {
        [] => "something".into(),
        [one] => (*one).into(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

fn next(a: &Answer) -> String {
    let hints = a.next_experiment.iter().chain(&a.located.separating_measurement);
    let mut said: Vec<&String> = Vec::new();
    for hint in hints {
        if !said.contains(&hint) {
            said.push(hint);
        }
    }
    said.iter().map(|s| format!("<p>{}</p>", escaped(s))).collect()
}
