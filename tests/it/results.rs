//! Results that are written: they destroy nothing.
#![cfg(unix)]

use std::os::unix::fs::FileTypeExt;
use std::path::Path;
use std::process::{Command, Output};

const MODEL: &str = r#"
name = "m"
[inputs]
u = { unit = "1" }
[parameters]
a = { value = 1, unit = "1", fit = true }
[outputs]
y = { equals = "a*u", unit = "1" }
"#;

fn simulate(folder: &Path, out: &Path) -> Output {
    let call = ["simulate", "m.toml", "r.csv", "--out"];
    let program = env!("CARGO_BIN_EXE_gyrospec");
    Command::new(program).args(call).arg(out).current_dir(folder).output().unwrap()
}

/// A result never takes the place of what is read, of a link or of a device.
#[test]
fn results_destroy_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let rows: String = (0..60).map(|i| format!("{},{}\n", 0.1 * f64::from(i), i % 7)).collect();
    let recording = format!("t [s],u [1]\n{rows}");
    std::fs::write(path("r.csv"), &recording).unwrap();
    std::fs::write(path("m.toml"), MODEL).unwrap();

    let refused = simulate(folder.path(), Path::new("r.csv"));
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("this file is read"));
    assert_eq!(std::fs::read_to_string(path("r.csv")).unwrap(), recording);

    std::fs::write(path("real.csv"), "old").unwrap();
    std::os::unix::fs::symlink(path("real.csv"), path("link.csv")).unwrap();
    assert_eq!(simulate(folder.path(), Path::new("link.csv")).status.code(), Some(0));
    assert!(path("link.csv").is_symlink());
    assert!(std::fs::read_to_string(path("real.csv")).unwrap().lines().count() > 60);

    assert_eq!(simulate(folder.path(), Path::new("/dev/null")).status.code(), Some(0));
    assert!(std::fs::metadata("/dev/null").unwrap().file_type().is_char_device());
}
