//! The arrows of the house: a room imports only rooms that stand above it.

use std::fs;
use std::path::Path;

const ROOMS: [&str; 21] = [
    "text",
    "error",
    "units",
    "expression",
    "exact",
    "poly",
    "integral",
    "symbolic",
    "lti",
    "spectrum",
    "record",
    "gyro",
    "model",
    "export",
    "simulate",
    "estimate",
    "rolling",
    "diagnose",
    "report",
    "facade",
    "cli",
];

fn visit(path: &Path, files: &mut Vec<std::path::PathBuf>) {
    if path.is_dir() {
        for entry in fs::read_dir(path).unwrap() {
            visit(&entry.unwrap().path(), files);
        }
    } else if path.extension().is_some_and(|e| e == "rs") {
        files.push(path.to_owned());
    }
}

fn rank(room: &str) -> Option<usize> {
    ROOMS.iter().position(|r| *r == room)
}

#[test]
fn no_arrow_runs_backwards() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut wrong = Vec::new();
    for (own, room) in ROOMS.iter().enumerate() {
        let mut files = Vec::new();
        if src.join(room).exists() {
            visit(&src.join(room), &mut files);
        }
        let single = src.join(format!("{room}.rs"));
        if single.exists() {
            files.push(single);
        }
        for file in files {
            let text = fs::read_to_string(&file).unwrap();
            for (at, _) in text.match_indices("crate::") {
                let name: String =
                    text[at + 7..].chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                if rank(&name).is_some_and(|other| other > own) {
                    wrong.push(format!("{}: crate::{name}", file.display()));
                }
                let pair = [(*room, name.as_str()), (name.as_str(), *room)];
                let apart = |room: &str| pair.contains(&(room, "diagnose"));
                if apart("gyro") || apart("rolling") {
                    wrong.push(format!("{}: gyroscopes and diagnose meet only in model", file.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
