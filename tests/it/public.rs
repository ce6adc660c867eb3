//! What the library offers at its root is a list that shows in review.

use std::fs;
use std::path::Path;

/// What stands at the root of the library for everybody: rooms, types, functions, one a line.
fn offered(source: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut hidden = false;
    for statement in source.split_inclusive([';', ']']) {
        let statement = statement.trim();
        if let Some(room) = statement.strip_prefix("pub mod ").filter(|_| !hidden) {
            names.push(format!("mod {}", room.trim_end_matches(';')));
        }
        if let Some(path) = statement.strip_prefix("pub use ") {
            let (_, last) = path.trim_end_matches(';').rsplit_once("::").unwrap();
            let last = last.trim_matches(['{', '}', '\n', ' ']);
            names.extend(last.split(',').map(str::trim).filter(|n| !n.is_empty()).map(str::to_owned));
        }
        // an attribute speaks of what follows it
        hidden = statement.starts_with("#[") && (hidden || statement == "#[doc(hidden)]");
    }
    names.sort();
    names
}

#[test]
fn what_is_offered_is_what_is_listed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let code: String = fs::read_to_string(root.join("src/lib.rs")).unwrap();
    let code: String = code.lines().filter(|l| !l.starts_with("//")).flat_map(|l| [l, "\n"]).collect();
    let listed = fs::read_to_string(root.join("tests/public.txt")).unwrap();
    let listed: Vec<&str> = listed.lines().collect();
    assert_eq!(
        offered(&code),
        listed,
        "tests/public.txt lists what a program may rely on: change it with care"
    );
}
