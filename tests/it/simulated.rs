//! Models of which only a simulation's output is known: what they read, what is found beside them, what is refused.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::simulate;
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

const MODEL: &str = "name = \"rig\"\nsimulated = \"sim.csv\"\n[outputs]\nposition = { unit = \"m\" }\n";

/// A motion of five sines, m, as the simulation has it.
fn motion(t: f64) -> f64 {
    (1..6).map(|k| (0.7 * f64::from(k * k) * t + f64::from(k)).sin() / f64::from(k)).sum::<f64>() * 0.1
}

/// The simulation at 100 Hz, with no unit in its header.
fn simulated(folder: &Path, times: impl Iterator<Item = f64>) {
    let mut text = String::from("time,position\n");
    times.for_each(|t| writeln!(text, "{t:.4},{:.9}", motion(t)).unwrap());
    std::fs::write(folder.join("sim.csv"), text).unwrap();
}

fn hundred_hertz() -> impl Iterator<Item = f64> {
    (0..12_100).map(|i| f64::from(i) * 0.01 - 0.5)
}

/// A recording at 25 Hz with noise of 2 mm.
fn recorded(measured: impl Fn(f64) -> f64) -> Recording {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let times: Vec<f64> = (0..3000).map(|i| f64::from(i) * 0.04).collect();
    let mut noise = || -> f64 { Distribution::<f64>::sample(&StandardNormal, &mut rng) };
    let values = times.iter().map(|t| measured(*t) + 0.002 * noise()).collect();
    Recording::from_channels("rig", vec![Channel::new("position", Unit::parse("m").unwrap(), times, values)])
        .unwrap()
}

fn model(folder: &Path) -> Model {
    std::fs::write(folder.join("rig.toml"), MODEL).unwrap();
    Model::read(folder.join("rig.toml")).unwrap()
}

#[test]
fn a_simulation_that_is_right_lacks_nothing() {
    let folder = tempfile::tempdir().unwrap();
    simulated(folder.path(), hundred_hertz());
    let answer = diagnosed(&model(folder.path()), recorded(motion)).answer;
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
    assert!(answer.findings.is_empty() && answer.faults.is_empty());
}

#[test]
fn what_acts_on_the_output_is_named() {
    let folder = tempfile::tempdir().unwrap();
    simulated(folder.path(), hundred_hertz());
    let model = model(folder.path());
    let late = diagnosed(&model, recorded(|t| motion(t - 0.23))).answer;
    let codes: Vec<&str> = late
        .findings
        .iter()
        .flat_map(|f| std::iter::once(f.code.as_str()).chain(f.ties.iter().map(String::as_str)))
        .collect();
    assert!(codes.contains(&"output-delay") && codes.contains(&"clock-offset"), "{codes:?}");
    assert!(
        (late.findings[0].parameters[0].value.abs() - 0.23).abs() < 0.005,
        "{:?}",
        late.findings[0].parameters
    );
    let ends = diagnosed(&model, recorded(|t| motion(t).clamp(-0.12, 0.12))).answer;
    assert_eq!(ends.findings.iter().map(|f| f.code.as_str()).collect::<Vec<_>>(), ["output-saturation"]);
    assert!((ends.findings[0].parameters[0].value - 0.12).abs() < 0.001);
    let off = diagnosed(&model, recorded(|t| 1.05 * motion(t) + 0.01)).answer;
    let mut codes: Vec<&str> = off.findings.iter().map(|f| f.code.as_str()).collect();
    codes.sort_unstable();
    assert_eq!(codes, ["output-offset", "output-scale"]);
}

#[test]
fn what_is_written_reads_back() {
    let folder = tempfile::tempdir().unwrap();
    simulated(folder.path(), hundred_hertz());
    let model = model(folder.path());
    assert_eq!(Model::parse(&model.to_toml()).unwrap(), model);
    assert!(!model.to_toml().contains("[inputs]"));
    let text = MODEL.replace("unit = \"m\" }", "unit = \"m\", equals = \"1.05*position_simulated + b\" }")
        + "[parameters]\nb = { value = 1, unit = \"cm\" }\n";
    std::fs::write(folder.path().join("found.toml"), text).unwrap();
    let found = Model::read(folder.path().join("found.toml")).unwrap();
    let ran = gyrospec::simulate(&found, &recorded(|t| 1.05 * motion(t) + 0.01)).run().unwrap();
    assert!(ran.output("position").unwrap().errors().0 < 0.0022);
}

#[test]
fn what_cannot_be_compared_is_refused_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path().join("rig.toml");
    let refused = |text: &str| {
        std::fs::write(&at, text).unwrap();
        Model::read(&at).unwrap_err().to_string()
    };
    assert!(refused(MODEL).contains("sim.csv") && refused(MODEL).contains(":2:"), "{}", refused(MODEL));
    std::fs::write(folder.path().join("sim.csv"), "time [s],position [kg]\n0,1\n1,2\n").unwrap();
    assert!(refused(MODEL).contains("kg"), "{}", refused(MODEL));
    std::fs::write(folder.path().join("sim.csv"), "time,pos\n0,1\n1,2\n").unwrap();
    assert!(refused(MODEL).contains("position"), "{}", refused(MODEL));
    std::fs::write(folder.path().join("sim.csv"), "").unwrap();
    assert!(refused(MODEL).contains("sim.csv"), "{}", refused(MODEL));
    simulated(folder.path(), (0..100).map(|i| 900.0 + f64::from(i)));
    let model = model(folder.path());
    let e = gyrospec::simulate(&model, &recorded(motion)).run().unwrap_err().to_string();
    assert!(e.contains("share no time"), "{e}");
}

/// A table whose rows are stamped from some seconds after noon on, every 0.1 s, of one motion.
fn stamped(file: &Path, begins: f64, zone: &str) {
    let mut text = String::from("time,position [m]\n");
    for i in 0..600 {
        let t = begins + 0.1 * f64::from(i);
        let (minute, second) = ((t / 60.0).floor(), t % 60.0);
        writeln!(text, "2025-04-13T12:{minute:02}:{second:04.1}{zone},{:.9}", motion(t)).unwrap();
    }
    std::fs::write(file, text).unwrap();
}

#[test]
fn dates_of_the_simulation_and_of_the_recording_lie_on_one_clock() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let worst = |recording: &Recording| {
        let run = simulate(&model(folder.path()), recording).run()?;
        let output = run.outputs().next().unwrap();
        let pairs = output.measured().zip(output.predicted()).filter(|(m, p)| (m - p).is_finite());
        let count = |(n, w): (usize, f64), (m, p): (f64, f64)| (n + 1, w.max((m - p).abs()));
        Ok::<_, gyrospec::Error>(pairs.fold((0, 0.0), count))
    };
    stamped(&path("rec.csv"), 60.0, "Z");
    let recording = Recording::read(path("rec.csv")).unwrap();
    for begins in [55.0, 60.0, 64.2] {
        stamped(&path("sim.csv"), begins, "Z");
        let (samples, error) = worst(&recording).unwrap();
        let common = 600 - (10.0 * f64::abs(begins - 60.0)).round() as usize;
        assert!((common - 1..=common).contains(&samples) && error < 1e-7, "{begins}: {samples} {error}");
    }
    // without a zone, or beside numbers, no clock is common
    stamped(&path("sim.csv"), 55.0, "");
    let refused = worst(&recording).unwrap_err();
    assert!(refused.to_string().contains("no zero in common"), "{refused}");
    stamped(&path("sim.csv"), 55.0, "Z");
    let refused = worst(&recorded(motion)).unwrap_err();
    assert!(refused.to_string().contains("are numbers"), "{refused}");
}

#[test]
fn what_is_written_beside_the_simulation_can_be_moved_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let (here, there) = (folder.path().join("here"), folder.path().join("there"));
    std::fs::create_dir(&here).unwrap();
    simulated(&here, hundred_hertz());
    let recording = recorded(|t| motion(t) + 0.01);
    let mut rows = String::from("t [s],position [m]\n");
    recording.channels[0].samples().for_each(|(t, y)| writeln!(rows, "{t},{y}").unwrap());
    std::fs::write(here.join("log.csv"), rows).unwrap();
    std::fs::write(
        here.join("rig.toml"),
        format!("{MODEL}[parameters]\nz = {{ value = 0, unit = \"m\", fit = true }}\n")
            .replace("{ unit", "{ equals = \"position_simulated + z\", unit"),
    )
    .unwrap();
    let run = |folder: &Path, arguments: &[&str]| {
        let ran = Command::new(env!("CARGO_BIN_EXE_gyrospec"))
            .args(arguments)
            .current_dir(folder)
            .output()
            .unwrap();
        assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    };
    run(&here, &["fit", "rig.toml", "log.csv", "--model-out", "found.toml"]);
    run(&here, &["fit", "rig.toml", "log.csv", "--model-out", "../outside.toml"]);
    assert!(std::fs::read_to_string(here.join("found.toml")).unwrap().contains("simulated = \"sim.csv\""));
    run(folder.path(), &["simulate", "outside.toml", "here/log.csv"]);
    std::fs::rename(&here, &there).unwrap();
    run(&there, &["simulate", "found.toml", "log.csv"]);
}
