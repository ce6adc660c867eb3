//! Inputs that come through a pipe: read once, whole, whatever they are.
#![cfg(unix)]

use flate2::{Compression, write::GzEncoder};
use serde_json::Value;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const MODEL: &str = "name = \"m\"\n[inputs]\nu = { unit = \"1\" }\n[parameters]\n\
    a = { value = 1, unit = \"1\", fit = true }\n[outputs]\ny = { equals = \"a*u\", unit = \"1\" }\n";
const COMPASS: &str = "[parameters]\nh = { value = 2, unit = \"m\" }\n";
const PRINTED: &str = "title = \"t\"\n[[formulas]]\nname = \"one\"\nprinted = \"x + x\"\nright = \"2*x\"\n";

/// Runs the program in a folder; what hangs is ended and fails.
fn run(folder: &Path, words: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .args(words)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = child.stdin.take().unwrap();
    let bytes = input.to_vec();
    // A program that does not want all of it closes the pipe.
    let writer = std::thread::spawn(move || drop(pipe.write_all(&bytes)));
    let begun = Instant::now();
    while child.try_wait().unwrap().is_none() && begun.elapsed() < Duration::from_secs(900) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let hangs = child.try_wait().unwrap().is_none();
    if hangs {
        child.kill().unwrap();
    }
    let out = child.wait_with_output().unwrap();
    assert!(!hangs, "{words:?} hangs");
    writer.join().unwrap();
    out
}

fn fifo(folder: &Path, name: &str, bytes: &[u8]) -> std::thread::JoinHandle<()> {
    let path = fifo_alone(folder, name);
    let bytes = bytes.to_vec();
    std::thread::spawn(move || {
        drop(std::fs::OpenOptions::new().write(true).open(path).unwrap().write_all(&bytes));
    })
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn table() -> String {
    repeating(7)
}

/// A table whose signals repeat after so many rows.
fn repeating(period: u32) -> String {
    let row = |i: u32| format!("{},{},{}\n", 0.1 * f64::from(i), i % period, i % period);
    let rows: String = (0..3000).map(row).collect();
    format!("t [s],u [1],y [1]\n{rows}")
}

fn log() -> String {
    let line = |i: u32| {
        let body = format!("HEHDT,{}.5,T", i % 300);
        let sum = body.bytes().fold(0, |x, b| x ^ b);
        format!("2020-01-01T{:02}:{:02}:{:02}Z ${body}*{sum:02X}\n", i / 3600, i / 60 % 60, i % 60)
    };
    (0..6000).map(line).collect()
}

fn json(out: &Output) -> Value {
    serde_json::from_slice(&out.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&out.stderr)))
}

/// A folder with a model, a table, a recording that names it, and the like.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let toml = "name = \"r\"\n[[tables]]\nfile = \"r.csv\"\n";
    for (name, text) in [("m.toml", MODEL), ("r.csv", &table()), ("r.toml", toml), ("c.toml", COMPASS)] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

#[test]
fn a_recording_through_a_pipe_is_the_one_in_the_file() {
    let folder = folder();
    let toml = std::fs::read(folder.path().join("r.toml")).unwrap();
    let texts = [table().into_bytes(), log().into_bytes()];
    let packed = texts.iter().map(|t| gzip(t)).collect::<Vec<_>>();
    for (i, bytes) in texts.iter().chain(&packed).chain([&toml]).enumerate() {
        let file = folder.path().join(format!("file{i}"));
        std::fs::write(&file, bytes).unwrap();
        let wanted = json(&run(folder.path(), &["record", "--json", &format!("file{i}")], b""));
        let writer = fifo(folder.path(), &format!("fifo{i}"), bytes);
        let got = [
            run(folder.path(), &["record", "--json", "-"], bytes),
            run(folder.path(), &["record", "--json", "/dev/stdin"], bytes),
            run(folder.path(), &["record", "--json", &format!("fifo{i}")], b""),
        ];
        writer.join().unwrap();
        for out in got {
            let got = json(&out);
            for field in ["range", "channels", "notes"] {
                assert_eq!(got[field], wanted[field], "file{i}");
            }
            assert_eq!(got["inputs"][0]["sha256"], wanted["inputs"][0]["sha256"]);
        }
        let samples = wanted["channels"][0]["samples"].as_u64().unwrap();
        assert_eq!(samples, if i % 2 == 1 { 6000 } else { 3000 }, "file{i}");
    }
}

#[test]
fn a_bad_line_in_a_pipe_is_told_and_ends_it() {
    let folder = folder();
    let bad = table() + "300,x,1\n301,1,1\n";
    let writer = fifo(folder.path(), "bad", bad.as_bytes());
    for out in [
        run(folder.path(), &["record", "bad"], b""),
        run(folder.path(), &["record", "-"], bad.as_bytes()),
        run(folder.path(), &["simulate", "m.toml", "-"], bad.as_bytes()),
        run(folder.path(), &["simulate", "-", "r.csv"], b"name = 7\n"),
    ] {
        let says = String::from_utf8_lossy(&out.stderr).into_owned();
        assert_eq!(out.status.code(), Some(2), "{says}");
        let place = ["bad:3002:5:", "standard input:3002:5:", "standard input:1:8:"];
        assert!(place.iter().any(|p| says.contains(p)), "{says}");
    }
    writer.join().unwrap();
}

#[test]
fn a_bad_line_is_told_while_the_writer_keeps_the_pipe_open() {
    let folder = folder();
    let mut child = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .args(["record", "-"])
        .current_dir(folder.path())
        .stdin(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut pipe = child.stdin.take().unwrap();
    let rows = "0,x\n".repeat(200_000);
    let _ = pipe.write_all(format!("t [s],x [m]\n{rows}").as_bytes());
    let begun = Instant::now();
    while child.try_wait().unwrap().is_none() && begun.elapsed() < Duration::from_secs(900) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let ended = child.try_wait().unwrap();
    child.kill().unwrap();
    assert_eq!(ended.and_then(|status| status.code()), Some(2));
    drop(pipe);
}

#[test]
fn every_subcommand_takes_standard_input() {
    let folder = folder();
    let text = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    let formula = b"h = \"m*s^2 + r*s + c\"\ng = \"N\"\n".to_vec();
    let roll: String =
        (0..2000).map(|i| format!("{},{:.6}\n", 0.5 * f64::from(i), (0.4 * f64::from(i)).sin())).collect();
    let calls: [(&[&str], Vec<u8>); 13] = [
        (&["simulate", "@", "r.csv"], text("m.toml")),
        (&["simulate", "m.toml", "@"], text("r.csv")),
        (&["simulate", "m.toml", "@"], text("r.toml")),
        (&["fit", "m.toml", "@"], gzip(&text("r.csv"))),
        (&["fit", "@", "r.toml"], text("m.toml")),
        (&["fit", "m.toml", "r.csv", "--holdout", "@"], repeating(5).into_bytes()),
        (&["roll-error", "@"], text("c.toml")),
        (&["roll-error", "@"], format!("t [s],roll [deg]\n{roll}").into_bytes()),
        (&["roll-error", "c.toml", "@", "--roll", "x:deg"], format!("t,x\n{roll}").into_bytes()),
        (&["audit", "@"], PRINTED.into()),
        (&["formula", "@"], formula),
        (&["gimbal", "@"], b"[parameters]\nH = { value = 0.5, unit = \"N*m*s\" }\n".to_vec()),
        (&["integral", "--batch", "@"], b"{\"h\":[1,2,3],\"g\":[0,1]}\n".to_vec()),
    ];
    for (words, bytes) in calls {
        std::fs::write(folder.path().join("given"), &bytes).unwrap();
        let call = |name: &str, input: &[u8]| {
            let all: Vec<&str> = words.iter().map(|w| if *w == "@" { name } else { w }).collect();
            run(folder.path(), &all, input)
        };
        let (file, piped) = (call("given", b""), call("-", &bytes));
        let says = String::from_utf8_lossy(&piped.stderr);
        assert!(matches!(piped.status.code(), Some(0 | 1)), "{words:?}: {says}");
        assert_eq!(piped.status, file.status, "{words:?}: {says}");
        let named = |out: &Output| String::from_utf8_lossy(&out.stdout).replace("standard input", "given");
        assert_eq!(named(&piped), named(&file), "{words:?}");
    }
}

#[test]
fn standard_input_and_standard_output_go_together() {
    let folder = folder();
    let file = run(folder.path(), &["simulate", "m.toml", "r.csv", "--out", "-"], b"");
    let piped = run(folder.path(), &["simulate", "m.toml", "-", "--out", "-"], table().as_bytes());
    assert_eq!((piped.status.code(), &piped.stdout), (Some(0), &file.stdout));
    assert_eq!(piped.stdout.split(|b| *b == b'\n').count(), 3002);
}

#[test]
fn a_guess_of_a_table_through_a_pipe_asks_for_its_name() {
    let folder = folder();
    let of_file = run(folder.path(), &["new", "recording", "r.csv"], b"");
    let piped = run(folder.path(), &["new", "recording", "-"], table().as_bytes());
    assert_eq!(piped.status.code(), Some(0), "{}", String::from_utf8_lossy(&piped.stderr));
    let [file, piped] = [of_file, piped].map(|out| String::from_utf8(out.stdout).unwrap());
    let after =
        |text: &str| text.split("[[tables]]").nth(1).unwrap().split_once("\ntime").unwrap().1.to_owned();
    assert_eq!(after(&file), after(&piped));
    let line = piped.lines().find(|l| l.starts_with("file = ")).unwrap();
    assert!(line.starts_with("file = \"recording.csv\"") && line.contains("GUESS"), "{line}");
    let bad = run(folder.path(), &["new", "recording", "-"], b"t,x\n0,1\n1,two\n");
    assert!(String::from_utf8_lossy(&bad.stderr).contains("standard input:3:3:"), "{bad:?}");
}

#[test]
fn a_pipe_that_is_named_twice_is_refused() {
    let folder = folder();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("twice.toml", "[[tables]]\nfile = \"f\"\n[[tables]]\nfile = \"./f\"\n");
    write("dash.toml", "[[tables]]\nfile = \"-\"\n");
    let table = table();
    fifo_alone(folder.path(), "f");
    for (words, says) in [
        (vec!["simulate", "-", "-"], "twice"),
        (vec!["simulate", "-", "/dev/stdin"], "twice"),
        (vec!["fit", "m.toml", "-", "-"], "twice"),
        (vec!["fit", "m.toml", "-", "--holdout", "-"], "twice"),
        (vec!["diagnose", "m.toml", "-", "--holdout", "/dev/stdin"], "twice"),
        (vec!["fit", "m.toml", "f", "./f"], "twice"),
        (vec!["roll-error", "-", "-"], "twice"),
        (vec!["laboratory", "-", "-"], "twice"),
        (vec!["record", "dash.toml"], "standard input"),
    ] {
        let out = run(folder.path(), &words, table.as_bytes());
        let text = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{words:?}: {text}");
        assert!(text.contains(says) && text.contains("help: "), "{words:?}: {text}");
    }
    let writer = fifo(folder.path(), "f", table.as_bytes());
    let out = run(folder.path(), &["record", "twice.toml"], b"");
    writer.join().unwrap();
    assert!(String::from_utf8_lossy(&out.stderr).contains("twice.toml:4:8:"), "{out:?}");
}

/// A FIFO to which nobody writes.
fn fifo_alone(folder: &Path, name: &str) -> std::path::PathBuf {
    let path = folder.join(name);
    if !path.exists() {
        assert!(Command::new("mkfifo").arg(&path).status().unwrap().success());
    }
    path
}
