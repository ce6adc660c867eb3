//! Models of which only a simulation's output is known: what they read, what is found beside them, what is refused.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::fmt::Write;
use std::path::Path;

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
    std::fs::write(
        folder.path().join("sim.csv"),
        "time,position\n2024-01-01T00:00:00Z,1\n2024-01-01T00:00:01Z,2\n",
    )
    .unwrap();
    assert!(refused(MODEL).contains("seconds"), "{}", refused(MODEL));
    std::fs::write(folder.path().join("sim.csv"), "").unwrap();
    assert!(refused(MODEL).contains("sim.csv"), "{}", refused(MODEL));
    simulated(folder.path(), (0..100).map(|i| 900.0 + f64::from(i)));
    let model = model(folder.path());
    let e = gyrospec::simulate(&model, &recorded(motion)).run().unwrap_err().to_string();
    assert!(e.contains("share no time"), "{e}");
}
