//! What docs/evidence.md quotes is what the program says of the recordings, where they are to be had.

use crate::record::recordings;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files of a set as `benches/evidence/evidence.py` places them; what `diagnose` answers.
fn answer(set: &str, recordings: &Path) -> Value {
    let folder = tempfile::tempdir().unwrap();
    for name in ["model.toml", "fit.toml"] {
        let text = fs::read_to_string(root().join("benches/evidence").join(set).join(name)).unwrap();
        let place = recordings.to_str().unwrap().replace('\\', "/");
        fs::write(folder.path().join(name), text.replace("../../../recordings", &place)).unwrap();
    }
    let run = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .args(["diagnose", "model.toml", "fit.toml", "--json", "-"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    serde_json::from_slice(&run.stdout).unwrap()
}

/// The quotes of a page, each on one line.
fn quotes(page: &str) -> String {
    let lines = page.lines().map(|l| l.strip_prefix("> ").map_or("\n".to_string(), |l| format!("{l} ")));
    lines.collect()
}

/// As the table prints a figure: three digits.
fn three_digits(x: f64) -> String {
    let digits = (2 - x.abs().log10().floor() as i32).max(0) as usize;
    let text = format!("{x:.digits$}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

#[test]
fn the_page_of_evidence_quotes_the_program() {
    let page = fs::read_to_string(root().join("docs/evidence.md")).unwrap();
    let quotes = quotes(&page);
    for (set, recorded) in [
        ("dryer", "daisy"),
        ("lamp", "daisy"),
        ("gyro-1", "ship_gyrocompass_skq201822s"),
        ("gyro-2", "ship_gyrocompass_skq201822s"),
    ] {
        let Some(folder) = recordings(recorded) else { continue };
        let answer = answer(set, folder.parent().unwrap());
        let says = answer["says"].as_str().unwrap();
        assert!(quotes.contains(&format!("\n{says} \n")), "docs/evidence.md does not quote of {set}: {says}");
        let row = page.lines().find(|l| l.starts_with(&format!("| {set} |"))).unwrap();
        let verdict = answer["verdict"].as_str().unwrap();
        assert!(row.contains(&format!("| {verdict} |")), "{set}: {verdict}");
        for figure in ["fit_before", "fit_after", "holdout_before", "holdout_after"] {
            let shown = three_digits(answer["proof"][0][figure].as_f64().unwrap());
            assert!(row.contains(&format!("| {shown} |")), "{set}: {figure} is {shown}, but\n{row}");
        }
    }
}

#[test]
fn figures_are_printed_to_three_digits() {
    assert_eq!(
        [0.0280, 0.010_967, 6.8709, 14.9779, 15.04].map(three_digits),
        ["0.028", "0.011", "6.87", "15", "15"]
    );
    assert_eq!(quotes("a\n> b\n> c\n\nd"), "\nb c \n\n");
}

/// The friction of the axis is 20.4 N as published (docs/evidence.md); without it, and what is uneven beside it, the
/// model is lost: what is held out falls to a tenth.
#[test]
fn the_positioning_axis_has_dry_friction() {
    let Some(folder) = recordings("emps") else { return };
    let answer = answer("emps", folder.parent().unwrap());
    let findings = answer["findings"].as_array().unwrap();
    let frictions: Vec<f64> = findings
        .iter()
        .filter(|f| ["dry-friction", "asymmetric-friction"].contains(&f["code"].as_str().unwrap()))
        .flat_map(|f| f["parameters"].as_array().unwrap())
        .map(|p| p["value"].as_f64().unwrap())
        .collect();
    let mean = frictions.iter().sum::<f64>() / frictions.len() as f64;
    assert_eq!(answer["verdict"], "named", "{}", answer["says"]);
    assert!((mean - 20.4).abs() < 2.0, "{mean} N: {}", answer["says"]);
    let proof = |name: &str| answer["proof"][0][name].as_f64().unwrap();
    assert!(proof("holdout_after") < 0.1 * proof("holdout_before"), "{}", answer["says"]);
}
