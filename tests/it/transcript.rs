//! Documents as they are read: the files they show are written, the commands they show are typed in a
//! shell, and what they show as answers is compared.
//!
//! A fenced block ```` ```toml NAME ```` is a file of that name; below `src/`, one of the project's own, as
//! it stands. In a block ```` ```console ````, `$ ` begins a
//! command and `> ` goes on with it; `? 1` below it is its exit code, and the lines after that are what it
//! says, on both outputs. `$ echo $?` after a command shows its exit code as well. `...` on a line of its own
//! stands for any lines, `[..]` for any part of a line. A command that shows nothing may say anything.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// One command of a document.
struct Step {
    line: usize,
    command: String,
    code: i32,
    shown: Vec<String>,
}

enum Part {
    File(String, String),
    Step(Step),
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Files and commands of a document, in its order.
fn parts(document: &str) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut lines = document.lines().enumerate();
    while let Some((_, line)) = lines.next() {
        let Some(info) = line.strip_prefix("```").filter(|i| !i.is_empty()) else { continue };
        let block: Vec<(usize, &str)> = lines.by_ref().take_while(|l| l.1 != "```").collect();
        match info.split_once(' ') {
            Some((_, name)) => {
                let text: String = block.iter().flat_map(|l| [l.1, "\n"]).collect();
                parts.push(Part::File(name.to_string(), text));
            }
            None if info == "console" => parts.extend(steps(&block).into_iter().map(Part::Step)),
            None => {}
        }
    }
    parts
}

fn steps(block: &[(usize, &str)]) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    let mut lines = block.iter();
    while let Some((line, text)) = lines.next() {
        if *text == "$ echo $?" {
            let code = lines.next().and_then(|(_, shown)| shown.parse().ok());
            steps.last_mut().unwrap().code = code.expect("the exit code below `echo $?`");
        } else if let Some(command) = text.strip_prefix("$ ") {
            let (command, shown) = (command.to_string(), Vec::new());
            steps.push(Step { line: line + 1, command, code: 0, shown });
        } else if let Some(step) = steps.last_mut() {
            match (text.strip_prefix("> "), text.strip_prefix("? ")) {
                (Some(more), _) if step.shown.is_empty() => step.command += &format!("\n{more}"),
                (_, Some(code)) if step.shown.is_empty() => step.code = code.parse().unwrap(),
                _ => step.shown.push((*text).to_string()),
            }
        }
    }
    steps
}

/// Whether a line is as shown, with `[..]` for any part.
fn alike(shown: &str, said: &str) -> bool {
    let mut rest = said.trim_end();
    let pieces: Vec<&str> = shown.trim_end().split("[..]").collect();
    for (k, piece) in pieces.iter().enumerate() {
        let found = match (k, k + 1 == pieces.len()) {
            (0, true) => (rest == *piece).then_some(rest.len()),
            (0, false) => rest.starts_with(piece).then_some(piece.len()),
            (_, true) => rest.ends_with(piece).then_some(rest.len()),
            _ => rest.find(piece).map(|at| at + piece.len()),
        };
        let Some(end) = found else { return false };
        rest = &rest[end..];
    }
    true
}

/// Whether all is as shown, with `...` for any lines.
fn matches(shown: &[String], said: &[&str]) -> bool {
    match (shown.split_first(), said.split_first()) {
        (None, None) => true,
        (Some((first, rest)), _) if first == "..." => {
            (0..=said.len()).any(|skipped| matches(rest, &said[skipped..]))
        }
        (Some((first, rest)), Some((line, more))) => alike(first, line) && matches(rest, more),
        _ => false,
    }
}

/// Runs a command in a shell that finds the program; its exit code, and all that it said.
pub fn typed(command: &str, folder: &Path) -> (i32, String) {
    let program = PathBuf::from(env!("CARGO_BIN_EXE_gyrospec"));
    let mut path = vec![program.parent().unwrap().to_path_buf()];
    path.extend(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()));
    let run = Command::new("sh")
        .args(["-c", &format!("{command}\n")])
        .current_dir(folder)
        .env("PATH", std::env::join_paths(path).unwrap())
        .env("GYROSPEC_PROGRESS", "never")
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&run.stderr) + String::from_utf8_lossy(&run.stdout);
    (run.status.code().unwrap_or(-1), said.into_owned())
}

/// An empty folder with the project's examples in it.
pub fn with_examples() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let examples = folder.path().join("examples");
    std::fs::create_dir(&examples).unwrap();
    for entry in std::fs::read_dir(root().join("examples")).unwrap() {
        let entry = entry.unwrap();
        if entry.file_type().unwrap().is_file() {
            std::fs::copy(entry.path(), examples.join(entry.file_name())).unwrap();
        }
    }
    folder
}

/// Plays a document in an empty folder with the project's examples; what went another way than shown.
fn played(document: &Path) -> String {
    let folder = with_examples();
    let mut wrong = String::new();
    let mut typed_at_all = 0;
    for part in parts(&std::fs::read_to_string(document).unwrap()) {
        match part {
            Part::File(name, text) if name.starts_with("src/") => {
                if std::fs::read_to_string(root().join(&name)).unwrap() != text {
                    let _ = writeln!(wrong, "{name} is not as shown");
                }
            }
            Part::File(name, text) => std::fs::write(folder.path().join(name), text).unwrap(),
            Part::Step(step) => {
                typed_at_all += 1;
                let (code, said) = typed(&step.command, folder.path());
                let lines: Vec<&str> = said.trim_end().lines().collect();
                let shown = step.shown.is_empty() || matches(trimmed(&step.shown), &lines);
                if code != step.code || !shown {
                    let (line, command) = (step.line, &step.command);
                    let _ = writeln!(wrong, "line {line}: {command}\nended with {code} and said\n{said}");
                }
            }
        }
    }
    assert!(typed_at_all > 0, "{} shows no command", document.display());
    wrong
}

fn trimmed(shown: &[String]) -> &[String] {
    let end = shown.iter().rposition(|l| !l.trim().is_empty()).map_or(0, |k| k + 1);
    &shown[..end]
}

/// Plays a document; it must go as it shows.
pub fn play(document: &str) {
    if cfg!(windows) {
        crate::skipped::skipped(format_args!(
            "{document} is written for a shell that this system does not have"
        ));
        return;
    }
    let wrong = played(&root().join(document));
    assert!(wrong.is_empty(), "{document} says otherwise:\n{wrong}");
}

#[test]
fn the_readme_is_as_it_says() {
    play("README.md");
}
