//! No two files of a room import each other, in however many steps.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// A file by the path of its module, such as `gyro::elastic::lag`.
type Module = Vec<String>;

/// What a file imports: the path from the root of the library, and whether it only passes it on.
type Imports = Vec<(Module, bool)>;

/// Rooms whose files may still import each other.
const NOT_YET: [&str; 1] = ["diagnose"];

fn collect(folder: &Path, at: &[String], found: &mut BTreeMap<Module, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let module = |name: &str| -> Module { at.iter().cloned().chain([name.to_owned()]).collect() };
        if path.is_dir() {
            collect(&path, &module(&name), found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = fs::read_to_string(&path).unwrap();
            let kept = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
            let code: String =
                kept.lines().map(|l| l.split("//").next().unwrap()).collect::<Vec<_>>().join("\n");
            found.insert(if name == "mod" { at.to_vec() } else { module(&name) }, code);
        }
    }
}

/// All paths of a `use` tree.
fn spread(before: &str, tree: &str, out: &mut Vec<String>) {
    let Some((head, rest)) = tree.split_once('{') else {
        out.push(format!("{before}{}", tree.trim()));
        return;
    };
    let (before, body) = (format!("{before}{}", head.trim()), rest.trim_end().strip_suffix('}').unwrap());
    let (mut depth, mut part) = (0, String::new());
    for c in body.chars().chain([',']) {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if c == ',' && depth == 0 {
            if !part.trim().is_empty() {
                spread(&before, part.trim(), out);
            }
            part.clear();
        } else {
            part.push(c);
        }
    }
}

/// The path from the root; `None` for another crate.
fn absolute(own: &Module, path: &str, all: &BTreeMap<Module, String>) -> Option<Module> {
    let path = path.split(" as ").next().unwrap();
    let mut steps: Vec<&str> = path.split("::").map(str::trim).collect();
    let mut at = own.clone();
    match steps[0] {
        "crate" => at.clear(),
        "super" => {
            at.pop();
        }
        "self" => {}
        child => {
            let inside: Module = own.iter().cloned().chain([child.to_owned()]).collect();
            return all
                .contains_key(&inside)
                .then(|| own.iter().cloned().chain(steps.iter().map(|s| (*s).into())).collect());
        }
    }
    steps.remove(0);
    while steps.first() == Some(&"super") {
        at.pop();
        steps.remove(0);
    }
    at.extend(steps.into_iter().map(str::to_owned));
    Some(at)
}

fn imports(own: &Module, code: &str, all: &BTreeMap<Module, String>) -> Imports {
    let mut out = Vec::new();
    let mut rest = code.to_owned();
    for statement in code.split(';') {
        let Some(at) = statement.rfind("use ").filter(|at| {
            let before = statement[..*at].trim_end();
            before.is_empty() || before.ends_with(['}', ']', ')', '{']) || before.ends_with("pub")
        }) else {
            continue;
        };
        let passes_on = statement[..at].trim_end().rsplit(['\n', '}', ']']).next().unwrap().contains("pub");
        let mut paths = Vec::new();
        spread("", &statement[at + 4..], &mut paths);
        out.extend(paths.iter().filter_map(|p| Some((absolute(own, p, all)?, passes_on))));
        rest = rest.replace(&statement[at..], "");
    }
    for start in ["crate::", "super::"] {
        for (at, _) in rest.match_indices(start) {
            let path: String =
                rest[at..].chars().take_while(|c| c.is_alphanumeric() || *c == '_' || *c == ':').collect();
            out.extend(absolute(own, path.trim_end_matches(':'), all).map(|p| (p, false)));
        }
    }
    out
}

/// The file behind a path, through what other files pass on.
fn file(
    path: &[String],
    all: &BTreeMap<Module, String>,
    passed: &BTreeMap<Module, Imports>,
) -> Option<Module> {
    let known = (0..=path.len()).rev().map(|k| &path[..k]).find(|p| all.contains_key(*p))?.to_vec();
    let Some(name) = path.get(known.len()) else { return Some(known) };
    let further = passed[&known].iter().find(|(p, passes_on)| *passes_on && p.last() == Some(name));
    match further {
        Some((p, _)) if p != path => file(p, all, passed).or(Some(known)),
        _ => Some(known),
    }
}

/// Every file that can be reached from one, each with the file that leads to it.
fn reached(from: &Module, arrows: &BTreeMap<Module, BTreeSet<Module>>) -> BTreeMap<Module, Module> {
    let (mut seen, mut open) = (BTreeMap::new(), vec![from.clone()]);
    while let Some(at) = open.pop() {
        for next in &arrows[&at] {
            if !seen.contains_key(next) {
                seen.insert(next.clone(), at.clone());
                open.push(next.clone());
            }
        }
    }
    seen
}

#[test]
fn no_two_files_import_each_other() {
    let mut all = BTreeMap::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &[], &mut all);
    all.retain(|m, _| !matches!(m[0].as_str(), "main" | "lib"));
    let imported: BTreeMap<Module, Imports> =
        all.iter().map(|(own, code)| (own.clone(), imports(own, code, &all))).collect();
    let arrows: BTreeMap<Module, BTreeSet<Module>> = imported
        .iter()
        .map(|(own, paths)| {
            let used = paths.iter().filter(|p| !p.1).filter_map(|p| file(&p.0, &all, &imported));
            (own.clone(), used.filter(|m| m != own).collect())
        })
        .collect();
    assert!(arrows.values().map(BTreeSet::len).sum::<usize>() > 1000, "the arrows are not seen");
    let mut circles = Vec::new();
    for own in arrows.keys().filter(|m| !NOT_YET.contains(&m[0].as_str())) {
        let seen = reached(own, &arrows);
        if let Some(last) = seen.get(own) {
            circles.push(format!("{} is imported again by {}", own.join("::"), last.join("::")));
        }
    }
    assert!(circles.is_empty(), "{circles:#?}");
}
