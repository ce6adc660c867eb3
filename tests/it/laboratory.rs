//! The laboratory's folder: what was ended before its time goes on, and another call is kept out of it.

use std::path::Path;
use std::process::Command;

/// Exit code, what was said, and the complaint.
fn laboratory(folder: &Path, words: &[&str]) -> (Option<i32>, String, String) {
    let mut call = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
    call.current_dir(folder).args(["laboratory", "--only", "none", "--keep", "runs"]).args(words);
    let made = call.output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (made.status.code(), text(&made.stdout), text(&made.stderr))
}

#[test]
fn a_run_goes_on_where_it_was_ended_and_says_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let call = ["--cases", "2", "--seed", "4", "--plant", "battery"];
    let (code, whole, _) = laboratory(folder.path(), &call);
    assert_eq!(code, Some(0));
    assert!(whole.contains("false alarms    0/2"), "{whole}");
    let runs = folder.path().join("runs");
    // One answer is not there yet; the other is another's, and is believed: it is not asked again.
    std::fs::remove_file(runs.join("answer-0.json")).unwrap();
    assert_eq!(laboratory(folder.path(), &call).1, whole);
    let named = r#"{"verdict":"named","findings":[{"code":"backlash","place":"i","term":"backlash(i, gap)","ties":[],"resembles":false,"intervals":[]}]}"#;
    std::fs::write(runs.join("answer-1.json"), named).unwrap();
    let (_, changed, _) = laboratory(folder.path(), &call);
    assert!(changed.contains("Named: backlash") && changed.contains("false alarms    1/2"), "{changed}");
    let (code, _, complaint) = laboratory(folder.path(), &["--cases", "2", "--seed", "5"]);
    assert_eq!(code, Some(2));
    assert!(complaint.contains("runs holds the recordings of another call"), "{complaint}");
}

#[test]
fn a_folder_with_something_else_in_it_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("runs")).unwrap();
    std::fs::write(folder.path().join("runs/mine.txt"), "mine").unwrap();
    let (code, _, complaint) = laboratory(folder.path(), &["--cases", "1"]);
    assert_eq!(code, Some(2));
    assert!(complaint.contains("runs is not empty: name a new folder"), "{complaint}");
    assert_eq!(std::fs::read_dir(folder.path().join("runs")).unwrap().count(), 1);
    let (code, _, complaint) = laboratory(folder.path(), &["--plant", "shp"]);
    assert_eq!(code, Some(2));
    assert!(complaint.contains("the nearest is ship"), "{complaint}");
}

/// A name that is mistyped makes nothing of the folder.
#[test]
fn a_call_that_reads_nothing_leaves_its_folder_free() {
    let folder = tempfile::tempdir().unwrap();
    let (code, _, complaint) = laboratory(folder.path(), &["missing.toml", "missing.csv"]);
    assert_eq!(code, Some(2));
    assert!(complaint.contains("missing.toml"), "{complaint}");
    assert_eq!(std::fs::read_dir(folder.path().join("runs")).unwrap().count(), 0);
}
