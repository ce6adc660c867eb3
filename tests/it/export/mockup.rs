//! Our model as a Functional Mock-up Unit, read back.

use super::{EVERYTHING, SMOOTH, columns, differences, gyrospec, simulated};
use crate::skipped::skipped;
use rand::{RngExt, SeedableRng};
use std::path::Path;

/// Exports the model; false where there is no compiler.
fn exported(folder: &Path) -> bool {
    if std::process::Command::new("cc").arg("--version").output().is_err() {
        skipped("no C compiler `cc`: export to FMUs");
        return false;
    }
    let out = gyrospec(folder, &["export", "model.toml", "--to", "fmu", "--out", "model.fmu"]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    true
}

#[test]
fn a_unit_of_a_smooth_model_runs_as_the_model() {
    let (folder, reference) = simulated(SMOOTH, "N");
    if !exported(folder.path()) {
        return;
    }
    let out =
        gyrospec(folder.path(), &["simulate", "model.fmu", "in.csv", "--out", "-", "--tolerance", "1e-8"]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    for d in differences(&reference, &String::from_utf8_lossy(&out.stdout), &["a", "b", "c_out", "d"]) {
        assert!(d < 1e-8, "{d}");
    }
}

#[test]
fn a_unit_of_a_model_with_memories_is_for_co_simulation() {
    let (folder, reference) = simulated(EVERYTHING, "m");
    if !exported(folder.path()) {
        return;
    }
    let out = gyrospec(folder.path(), &["simulate", "model.fmu", "in.csv", "--out", "-"]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    // four steps between samples, in which the input runs straight
    for d in differences(&reference, &String::from_utf8_lossy(&out.stdout), &["y", "w"]) {
        assert!(d < 2e-3, "{d}");
    }
}

/// A recording of the smooth model, with an error of the sensor, and a damping that its unit does not have.
fn recording(unit: &Path, quadratic: f64, seed: u64) {
    let model =
        SMOOTH.replace("\"steady\"", "0.0").replace("c*v", &format!("c*v - {quadratic:?}*m/L*abs(v)*v"));
    let (folder, reference) = simulated(&model, "N");
    let x = columns(&reference).into_iter().find(|c| c.0 == "a").unwrap().1;
    let inputs = std::fs::read_to_string(folder.path().join("in.csv")).unwrap();
    let mut noise = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let rows = inputs.lines().skip(1).zip(x).map(|(row, x)| {
        let sum: f64 = (0..12).map(|_| noise.random::<f64>()).sum::<f64>() - 6.0;
        format!("{row},{}\n", x + 2e-5 * sum)
    });
    std::fs::write(unit.join("log.csv"), format!("t [s],u [N],a [m]\n{}", rows.collect::<String>())).unwrap();
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_a_recording_has_and_our_unit_lacks_is_found_in_the_unit() {
    let (folder, _) = simulated(&SMOOTH.replace("\"steady\"", "0.0"), "N");
    if !exported(folder.path()) {
        return;
    }
    let small = "name = \"from our unit\"\nfmu = \"model.fmu\"\n[inputs]\nu = { unit = \"N\" }\n[parameters]\n\
        c = { value = 1.7, unit = \"N*s/m\", fit = true }\nk = { value = 30.0, unit = \"N/m\", fit = true }\n\
        [outputs]\na = { unit = \"m\" }\n";
    std::fs::write(folder.path().join("small.toml"), small).unwrap();
    for (quadratic, wanted) in [(0.0, "nothing-missing"), (6.0, "named")] {
        recording(folder.path(), quadratic, 5);
        let out = gyrospec(folder.path(), &["diagnose", "small.toml", "log.csv", "--json", "-"]);
        let told: serde_json::Value = serde_json::from_slice(&out.stdout)
            .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&out.stderr)));
        assert_eq!(told["verdict"], wanted, "{}", told["says"]);
        if quadratic > 0.0 {
            assert_eq!(told["findings"][0]["code"], "quadratic-damping", "{}", told["says"]);
        }
    }
}

#[test]
fn without_a_compiler_the_reason_is_told() {
    let (folder, _) = simulated(SMOOTH, "N");
    let out = std::process::Command::new(env!("CARGO_BIN_EXE_gyrospec"))
        .args(["export", "model.toml", "--to", "fmu", "--out", "model.fmu"])
        .env("CC", "no-such-compiler -x")
        .current_dir(folder.path())
        .output()
        .unwrap();
    let words = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(3), "{words}");
    assert!(words.contains("no-such-compiler") && !folder.path().join("model.fmu").exists(), "{words}");
}
