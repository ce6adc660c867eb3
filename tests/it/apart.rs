//! What is fitted and what is held out are different data, whatever the files are called.

use crate::diagnose::noise;
use flate2::Compression;
use flate2::write::GzEncoder;
use gyrospec::record::{Recording, keep_apart};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

const MODEL: &str = r#"
name = "m"
[inputs]
u = { unit = "1" }
[parameters]
a = { value = 1, unit = "m", fit = true }
[outputs]
y = { equals = "a*u", unit = "m" }
"#;

/// Values of y in rows a to b, of a recording of a given seed.
fn table(
    head: &str,
    seed: u64,
    rows: std::ops::Range<usize>,
    row: impl Fn(f64, f64, f64) -> String,
) -> String {
    let noise = noise(1000, seed);
    let mut text = format!("{head}\n");
    for i in rows {
        let t = i as f64 * 0.01;
        let u = (1.3 * t).sin() + 0.2 * noise[(i + 371) % 1000];
        let _ = writeln!(text, "{}", row(t, u, 2.0 * u + 0.1 * noise[i]));
    }
    text
}

fn plain(t: f64, u: f64, y: f64) -> String {
    format!("{t:.2},{u:.6},{y:.6}")
}

struct Files(tempfile::TempDir);

impl Files {
    fn new() -> Self {
        let files = Self(tempfile::tempdir().unwrap());
        files.put("m.toml", MODEL);
        files.put("r.csv", &table("t [s],u [1],y [m]", 1, 0..1000, plain));
        files
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn put(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    /// A TOML recording of r.csv with more in it.
    fn toml(&self, name: &str, table: &str, spans: &str) {
        self.put(name, &format!("name = \"{name}\"\n[[tables]]\nfile = \"r.csv\"\n{table}\n{spans}"));
    }

    /// Exit code and standard error of the program.
    fn run(&self, call: &[&str]) -> (Option<i32>, String) {
        let program =
            Command::new(env!("CARGO_BIN_EXE_gyrospec")).current_dir(self.0.path()).args(call).output();
        let program = program.unwrap();
        (program.status.code(), String::from_utf8_lossy(&program.stderr).into())
    }

    fn refused(&self, given: &[&str], says: &[&str]) {
        for command in ["fit", "diagnose"] {
            let (code, text) = self.run(&[&[command, "m.toml"], given].concat());
            assert_eq!(code, Some(2), "{command} {given:?}: {text}");
            assert!(says.iter().all(|s| text.contains(s)), "{command} {given:?}: {text}");
        }
    }

    fn taken(&self, given: &[&str]) {
        let (code, text) = self.run(&[&["fit", "m.toml"], given].concat());
        assert_eq!(code, Some(0), "{given:?}: {text}");
        assert!(!text.contains("same data"), "{given:?}: {text}");
    }
}

fn pack(from: &Path, to: &Path) {
    let mut packed = GzEncoder::new(std::fs::File::create(to).unwrap(), Compression::default());
    packed.write_all(&std::fs::read(from).unwrap()).unwrap();
    packed.finish().unwrap();
}

#[test]
fn the_same_data_under_any_name_are_refused() {
    let f = Files::new();
    let both = "both fitted and held out";
    f.refused(&["r.csv", "--holdout", "r.csv"], &[both, "rows 0 to 999 of r.csv"]);
    f.refused(&["r.csv", "./r.csv"], &["fitted", "rows 0 to "]);
    std::fs::copy(f.path("r.csv"), f.path("copy.csv")).unwrap();
    f.refused(&["r.csv", "--holdout", "copy.csv"], &[both]);
    pack(&f.path("r.csv"), &f.path("r.csv.gz"));
    f.refused(&["r.csv", "--holdout", "r.csv.gz"], &[both, "0 s to 9.99 s"]);
    // in other units, other digits and another order of the columns
    f.put(
        "mm.csv",
        &table("t [ms],y [mm],u [1]", 1, 0..1000, |t, u, y| format!("{:.1},{:.4},{u:.9}", 1e3 * t, 1e3 * y)),
    );
    f.refused(&["r.csv", "--holdout", "mm.csv"], &[both]);
    // under another clock
    f.put("later.csv", &table("t [s],u [1],y [m]", 1, 0..1000, |t, u, y| plain(t + 5e3, u, y)));
    f.refused(&["r.csv", "--holdout", "later.csv"], &[both]);
    f.put("other.csv", &table("t [s],u [1],y [m]", 2, 0..1000, plain));
    f.refused(&["other.csv", "--holdout", "r.csv", "copy.csv"], &["held out twice"]);
    f.taken(&["r.csv", "--holdout", "other.csv"]);
    f.taken(&["r.csv", "other.csv"]);
}

#[test]
fn parts_of_one_file_are_refused_where_they_overlap() {
    let f = Files::new();
    let clock = "time = { start = 0.0, step = 0.01, unit = \"s\" }\n[tables.channels]\nu = { column = \"u\", unit = \"1\" }\ny = { column = \"y\", unit = \"m\" }";
    for (name, rows) in [("a.toml", "[0, 599]"), ("b.toml", "[500, 999]"), ("c.toml", "[600, 999]")] {
        f.toml(name, &format!("rows = {rows}\n{clock}"), "");
    }
    f.refused(&["a.toml", "--holdout", "b.toml"], &["rows 500 to 599 of", "both fitted and held out"]);
    f.taken(&["a.toml", "--holdout", "c.toml"]);
    // spans of two files that name one table
    f.toml("early.toml", "", "[spans]\nfit = [[0, 5]]\n");
    f.toml("late.toml", "", "[spans]\nholdout = [[5, 9.99]]\n");
    f.toml("across.toml", "", "[spans]\nholdout = [[4, 9]]\n");
    f.taken(&["early.toml", "--holdout", "late.toml"]);
    f.refused(&["early.toml", "--holdout", "across.toml"], &["rows 400 to 500 of"]);
    f.toml("twice.toml", "", "[spans]\nfit = [[0, 5], [4, 9]]\n");
    f.toml("inside.toml", "", "[spans]\nfit = [[0, 3]]\nholdout = [[6, 7], [4, 9]]\n");
    f.toml("touching.toml", "", "[spans]\nfit = [[2, 4], [0, 2]]\nholdout = [[4, 6], [6, 9]]\n");
    f.toml("itself.toml", "", "[spans]\nfit = [[0, 5]]\nholdout = [[4, 9]]\n");
    f.refused(&["itself.toml"], &["4 to 5 is both fitted and held out"]);
    f.refused(&["twice.toml"], &["twice.toml:6:16", "4 to 5 would be fitted twice"]);
    f.refused(&["inside.toml"], &["6 to 7 would be held out twice"]);
    f.taken(&["touching.toml"]);
    // a table cut in two files that overlap
    f.put("first.csv", &table("t [s],u [1],y [m]", 1, 0..600, plain));
    f.put("second.csv", &table("t [s],u [1],y [m]", 1, 540..1000, plain));
    f.put("third.csv", &table("t [s],u [1],y [m]", 1, 600..1000, plain));
    f.refused(&["first.csv", "--holdout", "second.csv"], &["5.4 s to 5.99 s"]);
    f.taken(&["first.csv", "--holdout", "third.csv"]);
}

/// Two machines in one file, and one machine that repeats itself, are not the same rows.
#[test]
fn disjoint_rows_and_other_columns_stay_legal() {
    let f = Files::new();
    let rows = |y: &dyn Fn(usize) -> f64| -> String {
        (0..1000).map(|i| format!("{},{},{},{}\n", i, i % 50, y(i), y(i) + 0.5)).collect()
    };
    f.put("r.csv", &format!("t [s],u [1],y [m],z [m]\n{}", rows(&|i| (2 * (i % 50)) as f64)));
    for (name, column, rows) in
        [("y.toml", "y", "[0, 499]"), ("late.toml", "y", "[500, 999]"), ("z.toml", "z", "[0, 499]")]
    {
        let channels = format!(
            "time = {{ column = \"t\", unit = \"s\" }}\nrows = {rows}\n[tables.channels]\nu = {{ column = \"u\", unit = \"1\" }}\ny = {{ column = \"{column}\", unit = \"m\" }}"
        );
        f.toml(name, &channels, "");
    }
    f.taken(&["y.toml", "--holdout", "late.toml"]);
    f.taken(&["y.toml", "--holdout", "z.toml"]);
}

/// Rows of trials have no order.
#[test]
fn trials_are_the_same_in_any_order() {
    let f = Files::new();
    let names = (&["u"][..], &["y"][..]);
    let head = "kind = \"trials\"\n[[tables]]\nfile = ";
    let lines: Vec<String> =
        table("", 3, 0..60, |_, u, y| format!("{u:.4},{y:.4}")).lines().skip(1).map(str::to_string).collect();
    let read = |name: &str, lines: &[String]| {
        f.put(&format!("{name}.csv"), &format!("u [1],y [m]\n{}\n", lines.join("\n")));
        f.put(&format!("{name}.toml"), &format!("{head}\"{name}.csv\"\n"));
        Recording::read(f.path(&format!("{name}.toml"))).unwrap()
    };
    let turned: Vec<String> = lines.iter().rev().take(40).cloned().collect();
    let other: Vec<String> =
        table("", 4, 0..60, |_, u, y| format!("{u:.4},{y:.4}")).lines().skip(1).map(str::to_string).collect();
    let (a, b, c) = (read("a", &lines), read("b", &turned), read("c", &other));
    let apart = |x: &Recording, y: &Recording| {
        keep_apart(names.0, names.1, std::slice::from_ref(x), std::slice::from_ref(y))
    };
    assert!(apart(&a, &b).unwrap_err().to_string().contains("40 rows"));
    assert!(apart(&a, &c).is_ok());
}
