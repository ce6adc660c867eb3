//! What the program says where the system gives it too little: threads, memory.
#![cfg(target_os = "linux")]

use crate::transcript::with_examples;
use std::process::{Command, Output};

/// Runs the program in the folder of examples after a line of shell.
fn after(line: &str, call: &str) -> Output {
    let folder = with_examples();
    let program = env!("CARGO_BIN_EXE_gyrospec");
    let script = format!("{line}\nexec '{program}' {call}");
    Command::new("sh").args(["-c", &script]).current_dir(folder.path().join("examples")).output().unwrap()
}

/// No thread can be started with a stack of a petabyte: what needs none goes on in the one that is there.
#[test]
fn without_threads_the_work_goes_on_in_one() {
    let batch = r#"integral --h "1 2 3" --g "0 1" --check"#;
    let alone = "export RUST_MIN_STACK=1000000000000000";
    let sums = "roll-error --inertia --heading 45deg --heading 90deg --simulate 2 --band 2.5rad/s";
    let reads = ["record clinometer.csv", "fit clinometer.toml clinometer.csv --json -"];
    for call in [batch, sums].into_iter().chain(reads) {
        let (told, usual) = (after(alone, call), after("", call));
        let error = String::from_utf8_lossy(&told.stderr);
        assert_eq!(told.status.code(), Some(0), "{call}: {error}");
        assert!(error.contains("the system gives no threads"), "{call}: {error}");
        assert_eq!(told.stdout, usual.stdout, "{call}");
    }
}

/// More threads than can be of use are not started.
#[test]
fn a_huge_number_of_threads_is_not_started() {
    let asked = "export RAYON_NUM_THREADS=60000; ulimit -v 4000000";
    let told = after(asked, r#"integral --h "1 2 3" --g "0 1""#);
    assert_eq!(told.status.code(), Some(0), "{}", String::from_utf8_lossy(&told.stderr));
}

/// A file that may not grow further is an error of the write, and leaves nothing behind.
#[test]
fn a_file_too_long_is_an_error_and_nothing_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).display().to_string();
    let call = format!("fit clinometer.toml clinometer.csv --json {} --html {}", at("a"), at("b"));
    let told = after("ulimit -f 10", &call);
    let error = String::from_utf8_lossy(&told.stderr);
    assert!(matches!(told.status.code(), Some(2 | 3)), "{:?} {error}", told.status);
    assert!(error.contains("error: "), "{error}");
    let left: Vec<_> = std::fs::read_dir(folder.path()).unwrap().collect();
    assert!(left.is_empty(), "{left:?}");
}

/// Memory at its end is said, and is what could not be computed.
#[test]
fn memory_at_its_end_is_said_and_ends_with_3() {
    let mut ended = 0;
    for kilobytes in [90_000, 160_000] {
        let told = after(&format!("ulimit -v {kilobytes}"), "diagnose clinometer.toml clinometer.csv");
        let error = String::from_utf8_lossy(&told.stderr);
        assert!(matches!(told.status.code(), Some(0 | 1 | 3)), "{kilobytes}: {:?} {error}", told.status);
        if told.status.code() == Some(3) {
            // whole and in one line, whatever the runtime said before it
            let own: Vec<&str> = error.lines().filter(|line| line.starts_with("error: ")).collect();
            let says =
                "error: the work could not go on: as a rule, the memory that the system gives is not enough";
            assert_eq!(own, [says], "{kilobytes}: {error}");
            ended += 1;
        }
    }
    assert!(ended > 0, "no limit was low enough");
}
