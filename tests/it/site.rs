//! The documentation as a book: its pages stand in the summary, their links lead somewhere, their commands run, and what
//! is generated is what the program prints.

use crate::transcript::{play, typed};
use rayon::prelude::*;
use std::collections::HashMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All Markdown files below a folder, sorted.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            all.extend(pages(&path));
        } else if path.extension().is_some_and(|e| e == "md") {
            all.push(path);
        }
    }
    all.sort();
    all
}

/// The pages of the book, and those beside it.
fn documents() -> Vec<PathBuf> {
    let mut all = pages(&root().join("docs"));
    for name in ["README.md", "DESIGN.md", "COMPARE.md", "CHANGELOG.md", "examples/README.md"] {
        all.push(root().join(name));
    }
    all.extend(["CONTRIBUTING.md", "SECURITY.md"].map(|n| root().join(n)).into_iter().filter(|p| p.exists()));
    all
}

/// The lines outside fenced blocks, with their numbers from 1.
fn prose(text: &str) -> Vec<(usize, &str)> {
    let mut fenced = false;
    let mut lines = Vec::new();
    for (k, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            lines.push((k + 1, line));
        }
    }
    lines
}

/// Targets of the links of a line; code is no link.
fn links(line: &str) -> Vec<String> {
    let plain: String = line.split('`').step_by(2).collect::<Vec<_>>().join("`");
    let parts = plain.split("](").skip(1);
    parts.filter_map(|p| p.split_once(')')).map(|(target, _)| target.to_string()).collect()
}

/// The anchor that a heading gets on the web: small letters, digits, `-` and `_`, blanks as `-`.
fn anchor(heading: &str) -> String {
    let words = heading.trim_start_matches('#').trim().to_lowercase();
    words
        .chars()
        .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
        .map(|c| if c == ' ' { '-' } else { c })
        .collect()
}

fn anchors(page: &Path) -> Vec<String> {
    let text = fs::read_to_string(page).unwrap();
    let mut seen: HashMap<String, usize> = HashMap::new();
    let mut all = Vec::new();
    for (_, line) in prose(&text).into_iter().filter(|(_, l)| l.starts_with('#')) {
        let name = anchor(line);
        let count = seen.entry(name.clone()).or_default();
        all.push(if *count == 0 { name.clone() } else { format!("{name}-{count}") });
        *count += 1;
    }
    all
}

/// What is wrong with a link of a page, if anything.
fn broken(page: &Path, target: &str) -> Option<String> {
    if target.contains("://") || target.starts_with("mailto:") {
        return None;
    }
    let (file, wanted) = target.split_once('#').map_or((target, None), |(f, a)| (f, Some(a)));
    let path = if file.is_empty() { page.to_path_buf() } else { page.parent().unwrap().join(file) };
    if !path.exists() {
        return Some(format!("{target}: there is no such file"));
    }
    let book = root().join("docs").canonicalize().unwrap();
    let inside = |p: &Path| p.canonicalize().unwrap().starts_with(&book);
    if inside(page) && !inside(&path) {
        return Some(format!("{target}: the book does not hold that file"));
    }
    let missing = |a: &str| !anchors(&path).iter().any(|n| n == a);
    wanted.filter(|a| missing(a)).map(|a| format!("{target}: no heading gives the anchor {a}"))
}

#[test]
fn links_lead_somewhere() {
    let mut wrong = String::new();
    let mut count = 0;
    for page in documents() {
        let text = fs::read_to_string(&page).unwrap();
        for (line, words) in prose(&text) {
            for target in links(words) {
                count += 1;
                if let Some(what) = broken(&page, &target) {
                    let _ = writeln!(wrong, "{}:{line}: {what}", page.display());
                }
            }
        }
    }
    assert!(count > 40, "{count}");
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn a_link_that_leads_nowhere_is_seen() {
    let page = root().join("docs/symbols.md");
    assert_eq!(broken(&page, "symbols.md#errata"), None);
    assert_eq!(broken(&page, "#errata"), None);
    assert!(broken(&page, "symbols.md#erratum").is_some());
    assert!(broken(&page, "nowhere.md").is_some());
    assert!(broken(&page, "../README.md").is_some());
    assert_eq!(broken(&root().join("README.md"), "docs/symbols.md"), None);
    assert_eq!(links("[a](b.md) and `[c](d.md)` and ![e](f.png)"), ["b.md", "f.png"]);
    assert_eq!(anchor("## What it is: `x`, y"), "what-it-is-x-y");
}

#[test]
fn every_page_of_the_book_stands_in_its_summary_once() {
    let docs = root().join("docs");
    let summary = fs::read_to_string(docs.join("SUMMARY.md")).unwrap();
    let mut listed: Vec<PathBuf> = summary.lines().flat_map(links).map(|l| docs.join(l)).collect();
    listed.push(docs.join("SUMMARY.md"));
    listed.sort();
    assert_eq!(listed, pages(&docs));
}

/// What a page types that cannot run in a test: it fetches, builds or needs Python or recordings of others.
const NOT_RUN: [&str; 4] = ["cargo ", "pip ", "python ", "mdbook "];

#[test]
fn every_command_of_the_book_runs_or_says_why_not() {
    pages(&root().join("docs")).into_par_iter().for_each(|page| {
        let text = fs::read_to_string(&page).unwrap();
        let mut block = None;
        for line in text.lines() {
            if let Some(info) = line.strip_prefix("```") {
                block = if block.is_some() { None } else { Some(info.to_string()) };
            } else if block.as_deref() == Some("sh") {
                let known = NOT_RUN.iter().any(|n| line.starts_with(n));
                assert!(known, "{}: `{line}` runs in no test: show it as ```console", page.display());
            }
        }
        if text.contains("```console") {
            play(page.strip_prefix(root()).unwrap().to_str().unwrap());
        }
    });
}

fn said(command: &str) -> String {
    let (code, said) = typed(command, &std::env::temp_dir());
    assert_eq!(code, 0, "{command}: {said}");
    said.lines().map(str::trim_end).collect::<Vec<_>>().join("\n").trim_end().to_string()
}

/// The names of the subcommands, in the order of `gyrospec --help`.
fn subcommands() -> Vec<String> {
    let help = said("gyrospec --help");
    let lines = help.lines().skip_while(|l| !l.starts_with("Commands:")).skip(1);
    let names = lines.take_while(|l| !l.is_empty()).filter_map(|l| l.split_whitespace().next());
    names.filter(|n| *n != "help").map(str::to_string).collect()
}

fn commands() -> String {
    let mut page = "# Commands\n\nWhat each `--help` says.\n".to_string();
    for name in subcommands() {
        let _ = write!(page, "\n## {name}\n\n```text\n{}\n```\n", said(&format!("gyrospec {name} --help")));
    }
    page
}

/// The list of the catalogue, with each page of `explain` below: its headings go two deeper.
fn catalogue() -> String {
    let list = said("gyrospec explain");
    let mut page = "# The catalogue\n\nWhat `gyrospec explain` says of each effect.\n".to_string();
    for line in list.lines().filter(|l| !l.is_empty()) {
        let Some((code, _)) = line.strip_prefix("  ").and_then(|l| l.split_once(' ')) else {
            let _ = write!(page, "\n## {line}\n");
            continue;
        };
        let text = said(&format!("gyrospec explain {code}"));
        let (title, body) = text.split_once('\n').unwrap();
        let _ = write!(page, "\n### {code}\n\n{}\n", title.split_once(": ").unwrap().1);
        for line in body.lines() {
            match line.strip_prefix("# ") {
                Some(heading) => {
                    let _ = writeln!(page, "#### {heading}");
                }
                None => page += &format!("{line}\n"),
            }
        }
    }
    page
}

fn units() -> String {
    let text = said("gyrospec explain units");
    let body = text.strip_prefix("# Units\n").unwrap();
    format!("# Units\n\nWhat `gyrospec explain units` says.\n\n```text\n{body}\n```\n")
}

/// The page holds what the program prints; with `GYROSPEC_WRITE_PAGES` set it is written anew.
fn holds(name: &str, text: &str) {
    let page = root().join("docs/reference").join(name);
    if std::env::var_os("GYROSPEC_WRITE_PAGES").is_some() {
        fs::write(&page, text).unwrap();
    }
    let now = fs::read_to_string(&page).unwrap();
    let line = now.lines().zip(text.lines()).position(|(a, b)| a != b);
    assert!(
        now == text,
        "{} is not what the program prints, first at line {line:?} from 0: run this test with GYROSPEC_WRITE_PAGES=1",
        page.display()
    );
}

#[test]
fn the_page_of_commands_is_what_each_help_says() {
    holds("commands.md", &commands());
}

#[test]
fn the_page_of_the_catalogue_is_what_explain_says() {
    let text = catalogue();
    assert!(text.matches("\n### ").count() > 50);
    holds("catalogue.md", &text);
}

#[test]
fn the_page_of_units_is_what_explain_says() {
    holds("units.md", &units());
}

#[test]
fn the_page_of_schemas_names_each() {
    let page = fs::read_to_string(root().join("docs/reference/schemas.md")).unwrap();
    let mut count = 0;
    for entry in fs::read_dir(root().join("docs/schemas")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(page.contains(&format!("(../schemas/{name})")), "{name} is not on the page");
        count += 1;
    }
    assert!(count > 10);
}

/// The codes that `explain` lists below a heading.
fn listed_below(heading: &str) -> usize {
    let list = said("gyrospec explain");
    let (_, below) = list.split_once(&format!("{heading}\n")).unwrap();
    below.lines().take_while(|l| l.starts_with("  ")).count()
}

#[test]
fn the_comparison_counts_the_catalogue() {
    let all = said("gyrospec explain").lines().filter(|l| l.starts_with("  ")).count();
    let faults = listed_below("Faulty data");
    let laws = all - faults - listed_below("Without a name");
    let page = fs::read_to_string(root().join("COMPARE.md")).unwrap();
    assert!(
        page.contains(&format!("of {laws} laws and {faults} faults of data")),
        "{laws} laws, {faults} faults"
    );
}

/// The first test command of the README is the one that a change must pass.
#[test]
fn the_readme_names_the_command_of_all_tests_first() {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let (_, rest) = readme.split_once("`cargo test ").unwrap();
    assert_eq!(rest.split_once('`').unwrap().0, "--release --workspace");
}

#[test]
fn a_release_note_is_the_part_of_the_changelog() {
    let script = root().join(".ci/release-note");
    if cfg!(windows) || !script.exists() {
        crate::skipped::skipped(format_args!("there is no shell, or no {}", script.display()));
        return;
    }
    let changelog = fs::read_to_string(root().join("CHANGELOG.md")).unwrap();
    let parts: Vec<&str> = changelog.split("\n## ").skip(1).collect();
    assert!(parts.len() > 1);
    for part in parts {
        let (title, text) = part.split_once('\n').unwrap();
        let version = title.split([',', ' ']).next().unwrap();
        let run = std::process::Command::new(&script).arg(version).output().unwrap();
        let note = String::from_utf8(run.stdout).unwrap();
        assert_eq!(note.trim_end(), format!("# gyrospec {version}\n{}", text.trim_end()).trim_end());
    }
    let unknown = std::process::Command::new(&script).arg("9.9.9").output().unwrap();
    assert!(!unknown.status.success() && unknown.stdout.is_empty());
}
