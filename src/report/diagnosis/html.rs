//! A diagnosis as one page that opens offline, without scripts.

use super::figures;
use super::tables;
use super::text::headline;
use crate::diagnose::Diagnosis;
use crate::diagnose::answer::{Answer, Verdict};
use crate::diagnose::catalogue;
use crate::diagnose::pictures::Pictures;
use crate::report::page::{self, Page, Section};
use crate::report::svg::escaped;
use crate::units::without_needless_zeros;
use std::path::Path;

/// The page of a diagnosis.
pub fn html(d: &Diagnosis) -> String {
    page(&d.before.model.name, &d.answer, &d.pictures)
}

/// The page of an answer about a model, with its pictures.
pub fn page(model: &str, a: &Answer, pictures: &Pictures) -> String {
    let page = Page {
        kind: format!("Diagnosis of the model “{model}”"),
        title: format!("{model}: {}", headline(a.verdict).to_lowercase()),
        verdict: sentence(a),
        lead: without_needless_zeros(&a.says),
        sections: sections(a, pictures),
    };
    page.html()
}

fn sections(a: &Answer, pictures: &Pictures) -> Vec<Section> {
    let sure = !matches!(a.verdict, Verdict::Unknown | Verdict::NotIdentifiable);
    let inputs = a.made.inputs.iter().map(|i| (Path::new(&i.file), i.sha256.as_str()));
    vec![
        Section::new(
            "findings",
            if sure { "What was found" } else { "What it resembles" },
            tables::findings(a),
        ),
        Section::new("faults", "Where the data are at fault", figures::faults(pictures)),
        Section::new("laws", "The law, seen in the recording", figures::laws(pictures, a)),
        Section::new("courses", "Recording and model", figures::courses(pictures)),
        Section::new("residuals", "What the model leaves over time", figures::residuals(pictures, a)),
        Section::new("spectra", "What it leaves in frequency", figures::spectra(pictures, a)),
        Section::new("proof", "Proof on what was held out", tables::proof(a)),
        Section::new("sites", "What was considered", tables::tried(pictures, a)),
        Section::new("unexplained", "What no name explains", figures::unexplained(a)),
        Section::new("parameters", "Parameters before and after", tables::parameters(a)),
        Section::new("visible", "What would have been seen", tables::visible(a)),
        Section::new("next", "What would tell next", next(a)),
        page::made(&a.made.program, a.made.seed, inputs),
    ]
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
