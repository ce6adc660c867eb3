//! Results that are written: they destroy nothing.
#![cfg(unix)]

use std::fs::{self, Permissions};
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

const MODEL: &str = r#"
name = "m"
[inputs]
u = { unit = "1" }
[parameters]
a = { value = 1, unit = "1", fit = true }
[outputs]
y = { equals = "a*u", unit = "1" }
"#;
const TABLE: &str = "[[tables]]\nfile = \"data/r.csv\"\n";
const LOG: &str = "[[tables]]\nfile = \"data/log\"\nformat = \"nmea0183\"\ntime = { start = \"2018-12-06T00:00:00Z\" }\n[tables.channels]\nroll = { sentence = \"PSXN\", id = 23, field = 2, unit = \"deg\" }\n";
const REQUEST: &str = "h = \"T*s + 1\"\n";
const FORMULAS: &str = "[[formulas]]\nname = \"one\"\nprinted = \"a\"\nright = \"a\"\n";

/// A folder with everything that a call may read.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    fs::create_dir(folder.path().join("data")).unwrap();
    let t = |i: u32| 0.1 * f64::from(i);
    let rows: String = (0..60).map(|i| format!("{},{},{}\n", t(i), i % 7, 2 * (i % 7))).collect();
    write("data/r.csv", &format!("t [s],u [1],y [1]\n{rows}"));
    let roll: String =
        (0..2000).map(|i| format!("{},{}\n", t(i), (0.7 * t(i)).sin() + (0.61 * t(i)).sin())).collect();
    write("data/roll.csv", &format!("t [s],roll [deg]\n{roll}"));
    let stamp = |i: u32| {
        let says = format!("PSXN,23,{:.2},0,0,0", (0.7 * f64::from(i)).sin());
        let sum = says.bytes().fold(0, |sum, b| sum ^ b);
        format!("2018-12-06T00:{:02}:{:02}Z ${says}*{sum:02X}", i / 60, i % 60)
    };
    write("data/log", &(0..600).map(|i| stamp(i) + "\n").collect::<String>());
    write("m.toml", MODEL);
    write("r.toml", TABLE);
    write("roll.toml", &TABLE.replace("r.csv", "roll.csv"));
    write("log.toml", LOG);
    write("compass.toml", "[parameters]\nh = { value = 3.0, unit = \"m\" }\n");
    write("request.toml", REQUEST);
    write("formulas.toml", FORMULAS);
    folder
}

fn call(folder: &Path, line: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_gyrospec");
    Command::new(program).args(line.split_whitespace()).current_dir(folder).output().unwrap()
}

/// Every file of a folder and of those in it, with what is in it.
fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            all.extend(contents(&path));
        } else {
            all.push((path.clone(), fs::read(&path).unwrap_or_default()));
        }
    }
    all.sort();
    all
}

fn refused(folder: &Path, line: &str, says: &str) {
    let before = contents(folder);
    let said = call(folder, line);
    let error = String::from_utf8_lossy(&said.stderr);
    assert_eq!(said.status.code(), Some(2), "{line}: {error}");
    assert!(error.contains(says), "{line}: {error}");
    assert_eq!(contents(folder), before, "{line} changed a file");
}

/// Each option that writes, in each subcommand, on each file that it reads, in every spelling of its name.
#[test]
fn no_result_destroys_what_was_read() {
    let folder = folder();
    let root = folder.path();
    symlink("data/r.csv", root.join("link")).unwrap();
    symlink("data", root.join("elsewhere")).unwrap();
    fs::hard_link(root.join("data/r.csv"), root.join("twin")).unwrap();
    let absolute = root.join("data/r.csv").display().to_string();
    for (line, files) in [
        ("simulate m.toml r.toml --out", &["data/r.csv", "r.toml", "m.toml"][..]),
        ("fit m.toml r.toml --html", &["data/r.csv", "r.toml", "m.toml"]),
        ("fit m.toml r.toml --json", &["data/r.csv", "r.toml", "m.toml"]),
        ("fit m.toml r.toml --model-out", &["data/r.csv", "r.toml"]),
        (
            "diagnose m.toml r.toml --json",
            &["data/r.csv", "data/../data/r.csv", "link", "twin", "elsewhere/r.csv", "./r.toml", &absolute],
        ),
        ("diagnose m.toml r.toml --html", &["data/r.csv", "m.toml"]),
        ("diagnose m.toml r.toml --model-out", &["data/r.csv"]),
        ("fit m.toml data/r.csv --holdout r.toml --json", &["r.toml"]),
        ("roll-error compass.toml roll.toml --svg", &["data/roll.csv", "roll.toml", "compass.toml"]),
        ("roll-error roll.toml --html", &["data/roll.csv", "roll.toml"]),
        ("roll-error log.toml --html", &["data/log", "log.toml"]),
        ("roll-error compass.toml roll.toml --card --csv", &["data/roll.csv", "roll.toml", "compass.toml"]),
        ("roll-error roll.toml --card --html", &["data/roll.csv", "roll.toml"]),
        ("formula request.toml --out", &["request.toml", "./request.toml"]),
        ("audit formulas.toml --out", &["formulas.toml", "data/../formulas.toml"]),
    ] {
        for file in files {
            refused(root, &format!("{line} {file}"), "this file is read");
        }
    }
    let simulated = call(root, "simulate m.toml r.toml --out new.csv");
    assert!(simulated.status.success(), "{}", String::from_utf8_lossy(&simulated.stderr));
    let fitted = call(root, "fit m.toml r.toml --model-out ./m.toml");
    assert!(fitted.status.success(), "a model may be fitted in place");
    assert!(fs::read_to_string(root.join("m.toml")).unwrap().contains("value = 2.0"));
    // what is written has no comments
    let said = MODEL.replace("[outputs]", "# weighed on Monday\n[outputs]").replace("\"m\"", "\"m # 1\"");
    fs::write(root.join("m.toml"), &said).unwrap();
    refused(root, "fit m.toml r.toml --model-out m.toml", "comments");
    assert_eq!(fs::read_to_string(root.join("m.toml")).unwrap(), said);
}

/// What comes through a redirection is a file too.
#[test]
fn what_standard_input_comes_from_is_not_destroyed() {
    let folder = folder();
    for (command, file) in [("audit", "formulas.toml"), ("formula", "request.toml")] {
        let path = folder.path().join(file);
        let before = fs::read(&path).unwrap();
        let said = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
            .args([command, "-", "--out", file])
            .current_dir(folder.path())
            .stdin(fs::File::open(&path).unwrap())
            .output()
            .unwrap();
        assert_eq!(said.status.code(), Some(2));
        assert_eq!(fs::read(&path).unwrap(), before);
    }
}

#[test]
fn two_results_never_go_to_one_place() {
    let folder = folder();
    let root = folder.path();
    symlink("new.x", root.join("to-new")).unwrap();
    fs::create_dir(root.join("a")).unwrap();
    let absolute = root.join("new.x").display().to_string();
    for other in ["./new.x", &absolute, "a/../new.x", "to-new"] {
        refused(root, &format!("fit m.toml r.toml --json new.x --html {other}"), "two results");
        refused(root, &format!("roll-error roll.toml --svg {other} --html new.x"), "two results");
    }
    refused(root, "fit m.toml r.toml --json - --html -", "two results");
}

/// Links are followed, also to what is not there yet; a device stays one.
#[test]
fn a_result_goes_where_its_name_leads() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("real.csv"), "old").unwrap();
    symlink("real.csv", path("link.csv")).unwrap();
    symlink("../fresh.csv", path("data/dangling.csv")).unwrap();
    for (name, target) in [("link.csv", "real.csv"), ("data/dangling.csv", "fresh.csv")] {
        assert!(call(folder.path(), &format!("simulate m.toml r.toml --out {name}")).status.success());
        assert!(path(name).is_symlink());
        assert!(fs::read_to_string(path(target)).unwrap().lines().count() > 60);
    }
    assert!(call(folder.path(), "simulate m.toml r.toml --out /dev/null").status.success());
    assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}

#[test]
fn a_file_keeps_its_mode_and_its_owner() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    for mode in [0o600, 0o640, 0o755] {
        fs::write(path("out.csv"), "old").unwrap();
        fs::set_permissions(path("out.csv"), Permissions::from_mode(mode)).unwrap();
        // only root may give files away; elsewhere the owner stays what it is anyway
        let _ = std::os::unix::fs::chown(path("out.csv"), Some(65534), Some(65534));
        let before = fs::metadata(path("out.csv")).unwrap();
        assert!(call(folder.path(), "simulate m.toml r.toml --out out.csv").status.success());
        let after = fs::metadata(path("out.csv")).unwrap();
        assert!(after.len() > 100);
        let kept = |m: &fs::Metadata| (m.mode(), m.uid(), m.gid());
        assert_eq!(kept(&after), kept(&before));
    }
    fs::set_permissions(path("out.csv"), Permissions::from_mode(0o444)).unwrap();
    refused(folder.path(), "simulate m.toml r.toml --out out.csv", "write-protected");
}

/// A full disk for one result leaves the others as they were, and nothing beside them.
#[test]
#[cfg(target_os = "linux")]
fn where_one_result_fails_none_is_replaced() {
    let folder = folder();
    fs::write(folder.path().join("old.html"), "old").unwrap();
    fs::write(folder.path().join("old.toml"), "old").unwrap();
    for full in [
        "--json /dev/full --html old.html --model-out old.toml",
        "--html /dev/full --json new.json --model-out old.toml",
    ] {
        refused(folder.path(), &format!("fit m.toml r.toml {full}"), "/dev/full");
    }
}

/// A pipe behind a path takes what would go into a file, as it stands.
#[cfg(target_os = "linux")]
#[test]
fn a_pipe_by_its_path_takes_the_result() {
    let folder = folder();
    let shell = |line: &str| {
        let line = line.replace("GYROSPEC", env!("CARGO_BIN_EXE_gyrospec"));
        let said = Command::new("bash").args(["-c", &line]).current_dir(folder.path()).output().unwrap();
        assert!(
            matches!(said.status.code(), Some(0 | 1)),
            "{line}: {}",
            String::from_utf8_lossy(&said.stderr)
        );
        said
    };
    let lines = [
        "GYROSPEC simulate m.toml data/r.csv --out @",
        "GYROSPEC fit m.toml data/r.csv --json @",
        "GYROSPEC fit m.toml data/r.csv --html @",
        "GYROSPEC roll-error --svg @",
        "GYROSPEC diagnose m.toml data/r.csv --json @",
        "GYROSPEC formula request.toml --out @",
    ];
    for line in lines {
        let before = contents(folder.path());
        shell(&line.replace('@', "kept"));
        let wanted = fs::read(folder.path().join("kept")).unwrap();
        fs::remove_file(folder.path().join("kept")).unwrap();
        assert_eq!(shell(&line.replace('@', "/dev/stdout")).stdout, wanted, "{line}");
        assert_eq!(shell(&line.replace('@', "/proc/self/fd/1")).stdout, wanted, "{line}");
        let error = shell(&line.replace('@', "/dev/stderr")).stderr;
        assert!(error.windows(wanted.len()).any(|part| part == wanted), "{line}");
        let piped = shell(&format!("{{ {} >&2; }} 3>&1 | cat", line.replace('@', "/dev/fd/3")));
        assert_eq!(piped.stdout, wanted, "{line}");
        assert_eq!(contents(folder.path()), before, "{line}");
    }
}

/// Two results in one pipe would be mingled; a device that keeps nothing takes both.
#[test]
fn two_results_never_go_to_one_pipe() {
    let folder = folder();
    let root = folder.path();
    assert!(Command::new("mkfifo").arg(root.join("pipe")).status().unwrap().success());
    symlink("pipe", root.join("to-pipe")).unwrap();
    for other in ["pipe", "./pipe", "to-pipe"] {
        let mut reader = Command::new("cat").arg(root.join("pipe")).stdout(Stdio::null()).spawn().unwrap();
        let said = call(root, &format!("fit m.toml r.toml --json pipe --html {other}"));
        let says = String::from_utf8_lossy(&said.stderr).into_owned();
        assert!(said.status.code() == Some(2) && says.contains("two results"), "{other}: {says}");
        reader.wait().unwrap();
    }
    let devices = call(root, "fit m.toml r.toml --json /dev/null --html /dev/null");
    assert!(devices.status.success(), "{}", String::from_utf8_lossy(&devices.stderr));
}

#[test]
fn two_results_for_standard_output_are_told_by_its_name() {
    let folder = folder();
    refused(folder.path(), "fit m.toml data/r.csv --json - --html -", "standard output: two results");
}
