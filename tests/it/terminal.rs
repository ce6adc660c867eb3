//! What files and calls name never steers the terminal or the page that shows it.

use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Colour, clearing the screen in eight bits, turning the order of writing, a bell, a deletion, and what nobody sees:
/// a space without width, a byte-order mark, a soft hyphen, a letter of a tag.
const EVIL: &str = "\u{1b}[31m\u{9b}2J\u{202e}\u{7}\u{7f}\u{200b}\u{feff}\u{ad}\u{e0041}";
/// The same in a TOML string.
const IN_TOML: &str = r"\u001b[31m\u009b2J\u202e\u0007\u007f\u200b\ufeff\u00ad\U000e0041";

fn steers(c: char) -> bool {
    let turns = matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let unseen = matches!(c, '\u{200b}' | '\u{feff}' | '\u{ad}' | '\u{e0041}');
    turns || unseen || (c.is_control() && c != '\n' && c != '\t')
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let rows = |columns: fn(f64) -> String| (0..300).map(|i| columns(0.1 * f64::from(i))).collect::<String>();
    let wave = |t: f64| format!("{t:.1},{:.6},{:.6}\n", t.sin(), 2.0 * t.sin() + 0.1 * (7.3 * t).cos());
    write("r.csv", &format!("t [s],u [1],y [1]\n{}", rows(wave)));
    write("odd.csv", &format!("t [s],u{EVIL} [1],y [1]\n{}", rows(wave)));
    write(&format!("{EVIL}.csv"), &format!("t [s],u [1],y [1]\n{}", rows(wave)));
    write("cut.csv", &format!("t [s],u [1]\n0,1\n1,{EVIL}x\n"));
    write("unit.csv", &format!("t [s],u [{EVIL}]\n0,1\n1,2\n"));
    write("r.toml", &format!("name = \"{IN_TOML}\\nnothing is wrong\"\n[[tables]]\nfile = \"r.csv\"\n"));
    write(
        "key.toml",
        &format!(
            "[[tables]]\nfile = \"r.csv\"\n[tables.channels]\n\"a\\nb{IN_TOML}\" = {{ column = \"u\" }}\n"
        ),
    );
    write("lost.toml", &format!("[[tables]]\nfile = \"no/{IN_TOML}\"\n"));
    let model = format!(
        "name = \"m{IN_TOML}\"\n[inputs]\nu = {{ unit = \"1\", meaning = \"{IN_TOML}\" }}\n[parameters]\n\
         a = {{ value = 1, unit = \"1\", fit = true, meaning = \"{IN_TOML}\" }}\n[outputs]\n\
         y = {{ equals = \"a*u\", unit = \"1\", meaning = \"{IN_TOML}\" }}\n"
    );
    write("m.toml", &model);
    write("wrong.toml", &model.replace("a*u", &format!("a*{IN_TOML}")));
    write("key-of-model.toml", &format!("{model}[\"{IN_TOML}\"]\n"));
    write("request.toml", &format!("h = \"T*s + 1\"\nname = \"{IN_TOML}\"\n"));
    let formula = format!("name = \"{IN_TOML}\"\nsays = \"{IN_TOML}\"\nprinted = \"a\"\nright = \"b\"\n");
    write("audit.toml", &format!("title = \"{IN_TOML}\"\n[[formulas]]\n{formula}"));
    write("gimbal.toml", &format!("[parameters]\n\"{IN_TOML}\" = 1\n"));
    write("cases.jsonl", &format!("{{\"h\":[1,2],\"g\":[1],\"{EVIL}\n{{\"h\":\"{EVIL}\"}}\n"));
    folder
}

fn call(folder: &Path, words: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_gyrospec");
    Command::new(program).args(words).current_dir(folder).stdin(Stdio::null()).output().unwrap()
}

/// What every subcommand says where names, units, titles, meanings, paths and options hold such characters.
#[test]
fn nothing_that_is_shown_steers_the_terminal() {
    let folder = folder();
    let evil = EVIL;
    let (path, option) = (format!("no\nsuch{EVIL}.csv"), format!("--{EVIL}"));
    let odd_name = format!("{EVIL}.csv");
    let calls: Vec<Vec<&str>> = vec![
        vec!["record", "odd.csv"],
        vec!["record", "odd.csv", "--json"],
        vec!["record", &odd_name],
        vec!["record", &path],
        vec!["record", "cut.csv"],
        vec!["record", "unit.csv"],
        vec!["record", "r.toml"],
        vec!["record", "key.toml"],
        vec!["record", "lost.toml"],
        vec!["simulate", "m.toml", "r.toml"],
        vec!["simulate", "wrong.toml", "r.toml"],
        vec!["simulate", "key-of-model.toml", "r.toml"],
        vec!["simulate", "m.toml", "r.toml", "--tolerance", evil],
        vec!["fit", "m.toml", "r.toml"],
        vec!["fit", "m.toml", "r.toml", "--json", "-"],
        vec!["fit", "m.toml", "r.toml", "--html", "-"],
        vec!["fit", "m.toml", "r.toml", "--model-out", "-"],
        vec!["fit", "m.toml", "r.toml", "--json", &path, "--html", &path],
        vec!["diagnose", "m.toml", "r.toml"],
        vec!["diagnose", "m.toml", "r.toml", "--json", "-"],
        vec!["diagnose", "m.toml", "r.toml", "--html", "-"],
        vec!["diagnose", "m.toml", &odd_name, "--json", "-"],
        vec!["new", "recording", "odd.csv"],
        vec!["new", "recording", &odd_name],
        vec!["explain", evil],
        vec!["models", "show", evil],
        vec!["man", evil],
        vec!["completions", evil],
        vec!["laboratory", "--only", evil],
        vec!["laboratory", evil, "r.csv"],
        vec!["integral", "--h", evil, "--g", "1"],
        vec!["integral", "--h", evil, "--g", "1", "--json"],
        vec!["integral", "--batch", "cases.jsonl"],
        vec!["integral", &option],
        vec!["formula", "--h", evil],
        vec!["formula", "request.toml"],
        vec!["formula", "request.toml", "--format", "json"],
        vec!["formula", "request.toml", "--format", "c"],
        vec!["formula", "request.toml", "--format", "latex"],
        vec!["audit", "audit.toml"],
        vec!["audit", "audit.toml", "--format", "json"],
        vec!["table", "--orders", evil],
        vec!["gimbal", "gimbal.toml"],
        vec!["strapdown", "--angular", evil],
        vec!["strapdown", "--angular", "x=1mrad", "--tuned-rotor", evil],
        vec!["roll-error", &odd_name, "--roll", evil],
        vec!["roll-error", "--latitude", evil],
        vec!["roll-error", "--sea", evil],
        vec![evil],
        vec![&option],
    ];
    for words in calls {
        let said = call(folder.path(), &words);
        let [out, error] =
            [&said.stdout, &said.stderr].map(|bytes| String::from_utf8(bytes.clone()).unwrap());
        assert!(matches!(said.status.code(), Some(0..=3)), "{words:?}: {error}");
        assert!(!out.is_empty() || !error.is_empty(), "{words:?}");
        for text in [&out, &error] {
            let bad = text.chars().find(|c| steers(*c));
            assert_eq!(bad, None, "{words:?} says {text:?}");
            assert!(!text.lines().any(|l| l.starts_with("nothing is wrong")), "{words:?} forges a line");
        }
    }
}

/// The escapes of JSON and of a model file read back to the same texts.
#[test]
fn what_is_written_for_programs_reads_back_the_same() {
    let folder = folder();
    let json = |words: &[&str]| -> serde_json::Value {
        serde_json::from_slice(&call(folder.path(), words).stdout).unwrap()
    };
    assert_eq!(json(&["fit", "m.toml", "r.toml", "--json", "-"])["model"], format!("m{EVIL}"));
    assert_eq!(json(&["formula", "request.toml", "--format", "json"])["formulas"][0]["name"], EVIL);
    let model = call(folder.path(), &["fit", "m.toml", "r.toml", "--model-out", "-"]).stdout;
    let model = gyrospec::model::Model::parse(&String::from_utf8(model).unwrap()).unwrap();
    assert_eq!(model.name, format!("m{EVIL}"));
    assert_eq!(model.inputs[0].meaning.as_deref(), Some(EVIL));
}

/// A line end in the name of a file does not make a line of its own.
#[test]
fn the_name_of_a_file_stays_in_its_line() {
    let folder = folder();
    let name = "fake\nNOTHING IS MISSING\n.csv";
    std::fs::copy(folder.path().join("r.csv"), folder.path().join(name)).unwrap();
    for words in [
        vec!["record", name],
        vec!["record", name, "--json"],
        vec!["new", "recording", name],
        vec!["simulate", "m.toml", name],
        vec!["fit", "m.toml", name],
        vec!["fit", "m.toml", name, "--json", "-"],
        vec!["diagnose", "m.toml", name],
        vec!["roll-error", name, "--roll", "u:deg"],
        vec!["roll-error", name, "--roll", "u:deg", "--json"],
    ] {
        let said = call(folder.path(), &words);
        for text in [said.stdout, said.stderr] {
            let text = String::from_utf8_lossy(&text).into_owned();
            assert!(!text.lines().any(|line| line.starts_with("NOTHING IS MISSING")), "{words:?}: {text}");
        }
    }
    let guessed = String::from_utf8(call(folder.path(), &["new", "recording", name]).stdout).unwrap();
    let recording = gyrospec::record::Recording::parse(&guessed, folder.path().join("guessed.toml")).unwrap();
    assert!(recording.sources.iter().any(|s| s.file == folder.path().join(name)), "{guessed}");
}

/// Help that does not arrive is a failure; a reader who went away is none.
#[test]
#[cfg(target_os = "linux")]
fn help_that_is_lost_is_told() {
    let shell = |line: &str| {
        let line = line.replace("GYROSPEC", env!("CARGO_BIN_EXE_gyrospec"));
        Command::new("bash").args(["-c", &format!("set -o pipefail; {line}")]).output().unwrap()
    };
    for words in ["--help", "--version", "help fit", "roll-error --help"] {
        let lost = shell(&format!("GYROSPEC {words} > /dev/full"));
        assert_eq!(lost.status.code(), Some(2), "{words}");
        let says = String::from_utf8_lossy(&lost.stderr).into_owned();
        assert!(says.contains("standard output"), "{words}: {says}");
        assert!(shell(&format!("GYROSPEC {words} > /dev/null")).status.success(), "{words}");
    }
    assert!(
        shell("GYROSPEC roll-error --help | head -c 0").status.code().is_some_and(|c| c == 0 || c == 141)
    );
}
