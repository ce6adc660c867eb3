//! One page that opens offline and asks for nothing: the same house for every report. Its only script looks closer at
//! the pictures; without it the page is the same.

mod sheet;
mod table;

pub use sheet::sheet;
pub use table::{estimate, estimates, head, interval, quantity, table};

use crate::report::svg::escaped;
use std::fmt::Write;
use std::path::Path;

const STYLE: &str = include_str!("style.css");
/// A closer look at the pictures.
const CLOSER: &str = include_str!("closer.js");

/// A part of a page: its name, its heading, its content as HTML.
#[derive(Debug, Clone)]
pub struct Section {
    /// Name, by which links find it.
    pub name: &'static str,
    pub heading: &'static str,
    /// HTML; a section without content is left out.
    pub content: String,
}

impl Section {
    /// A section.
    pub fn new(name: &'static str, heading: &'static str, content: String) -> Self {
        Self { name, heading, content }
    }
}

/// A page in the making; all its words are plain text, save the sections' content.
#[derive(Debug, Clone)]
pub struct Page {
    /// What the page is, above the verdict.
    pub kind: String,
    /// What the browser's tab says.
    pub title: String,
    /// The one sentence.
    pub verdict: String,
    /// The paragraph below it; empty for none.
    pub lead: String,
    /// The parts, in order.
    pub sections: Vec<Section>,
}

impl Page {
    /// The whole page.
    ///
    /// ```
    /// use gyrospec::report::page::{Page, Section};
    /// let page = Page {
    ///     kind: "Test".into(),
    ///     title: "a & b".into(),
    ///     verdict: "Nothing is missing.".into(),
    ///     lead: String::new(),
    ///     sections: vec![Section::new("made", "How this was made", "<p>by hand</p>".into())],
    /// };
    /// assert!(page.html().contains("<title>a &amp; b</title>"));
    /// ```
    pub fn html(&self) -> String {
        let lead = match self.lead.as_str() {
            "" => String::new(),
            words => format!("<p class=\"lead\">{}</p>", escaped(words)),
        };
        let mut page = format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><meta name=\"color-scheme\" content=\"light dark\"><link rel=\"icon\" href=\"data:,\"><title>{}</title><style>\n{STYLE}</style></head><body>\n<header><p class=\"note\">{}</p><h1 id=\"verdict\">{}</h1>{lead}</header>\n<nav>",
            escaped(&self.title),
            escaped(&self.kind),
            escaped(&self.verdict),
        );
        let sections = || self.sections.iter().filter(|s| !s.content.is_empty());
        for s in sections() {
            let _ = write!(page, "<a href=\"#{}\">{}</a> ", s.name, s.heading);
        }
        let has_pictures = self.sections.iter().any(|s| s.content.contains("<svg viewBox"));
        page.push_str(if has_pictures {
            "</nav>\n<p class=\"note\" id=\"closer\"></p><main>"
        } else {
            "</nav>\n<main>"
        });
        for s in sections() {
            let _ =
                write!(page, "\n<section id=\"{}\"><h2>{}</h2>{}</section>", s.name, s.heading, s.content);
        }
        page.push_str("</main>");
        if has_pictures {
            let _ = write!(page, "<script>\n{CLOSER}</script>");
        }
        page + "</body></html>\n"
    }
}

/// Program, seed and inputs: how a report was made.
pub fn made<'a>(program: &str, seed: u64, inputs: impl Iterator<Item = (&'a Path, &'a str)>) -> Section {
    let cells = |(file, hash): (&Path, &str)| {
        vec![escaped(&file.display().to_string()), format!("<code>{}</code>", escaped(hash))]
    };
    let rows: Vec<Vec<String>> = inputs.map(cells).collect();
    let content = format!(
        "<p>{}, seed {seed}. The same inputs and seed give the same bytes.</p>{}",
        escaped(program),
        table(&["file", "SHA-256"], &rows)
    );
    Section::new("made", "How this was made", content)
}

/// Words and, behind a comma, a unit that is not `1`.
pub fn with_unit(words: &str, unit: &str) -> String {
    if unit == "1" { words.to_string() } else { format!("{words}, {unit}") }
}

/// How much of a signal's movement a model follows, in brackets for a legend: on what was fitted and on what was held
/// out, each where it is known.
///
/// ```
/// use gyrospec::report::page::percent;
/// assert_eq!(percent(93.21, f64::NAN), " (fit 93.2 %)");
/// assert_eq!(percent(93.21, -7.0), " (fit 93.2 %, held out −7.0 %)");
/// ```
pub fn percent(fitted: f64, held_out: f64) -> String {
    let one = |words: &str, x: f64| x.is_finite().then(|| format!("{words} {x:.1} %").replace('-', "−"));
    let both: Vec<String> = [one("fit", fitted), one("held out", held_out)].into_iter().flatten().collect();
    if both.is_empty() { String::new() } else { format!(" ({})", both.join(", ")) }
}
