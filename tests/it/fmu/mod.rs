//! Functional Mock-up Units: those of the Modelica Association, where they are at hand, and some made on the spot.

mod made;
mod published;
mod wrong;

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use gyrospec::{fit, simulate};
use made::{EXCHANGE, SIMULATION, mass};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::path::Path;

/// s between samples.
const SAMPLE: f64 = 0.05;

/// The force on the mass, N: it runs straight between its samples.
fn force(t: f64) -> f64 {
    let at = |t: f64| (1..6).map(|k| (0.4 * f64::from(k * k) * t + f64::from(k)).sin()).sum::<f64>();
    let first = (t / SAMPLE + 1e-9).floor() * SAMPLE;
    at(first) + (at(first + SAMPLE) - at(first)) * (t - first) / SAMPLE
}

/// A motion of the mass by classical Runge-Kutta steps of 1 ms, sampled at 20 Hz for 90 s, with noise.
fn recorded([m, d, k, cubic]: [f64; 4], noise: f64) -> Recording {
    let rate = |t: f64, [x, v]: [f64; 2]| [v, (force(t) - d * v - k * x - cubic * x.powi(3)) / m];
    let add = |a: [f64; 2], h: f64, b: [f64; 2]| [a[0] + h * b[0], a[1] + h * b[1]];
    let (h, mut y, mut all) = (1e-3, [0.1, 0.0], Vec::new());
    for i in 0..90_000 {
        let t = f64::from(i) * h;
        if i % 50 == 0 {
            all.push((t, y[0]));
        }
        let a = rate(t, y);
        let b = rate(t + h / 2.0, add(y, h / 2.0, a));
        let c = rate(t + h / 2.0, add(y, h / 2.0, b));
        let e = rate(t + h, add(y, h, c));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + e[i]));
    }
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut stray = || noise * Distribution::<f64>::sample(&StandardNormal, &mut rng);
    let measured = all.iter().map(|(_, x)| x + stray()).collect();
    let unit = |u: &str| Unit::parse(u).unwrap();
    let times: Vec<f64> = all.iter().map(|p| p.0).collect();
    let forces = times.iter().map(|t| force(*t)).collect();
    let position = Channel::new("position", unit("m"), times.clone(), measured);
    Recording::from_channels("rig", vec![Channel::new("force", unit("N"), times, forces), position]).unwrap()
}

/// A model file beside the FMU that fits three parameters, one under the name that the description gives it.
fn beside(folder: &Path) -> Model {
    let text = "name = \"mass\"\nfmu = \"mass.fmu\"\n[parameters]\n\"body.m\" = { value = 1.5, fit = true }\n\
                d = { value = 0.8, unit = \"N*s/m\", fit = true }\nk = { value = 7, unit = \"N/m\", fit = true }\n";
    std::fs::write(folder.join("mass.toml"), text).unwrap();
    Model::read(folder.join("mass.toml")).unwrap()
}

#[test]
fn parameters_come_back_from_both_kinds() {
    let recording = [recorded([2.5, 0.6, 10.0, 0.0], 1e-3)];
    for kind in [EXCHANGE, SIMULATION] {
        let folder = tempfile::tempdir().unwrap();
        if mass(folder.path(), kind, "(void)0").is_none() {
            return;
        }
        let model = beside(folder.path());
        let fitted = fit(&model, &recording).run().unwrap();
        for (name, truth) in [("body_m", 2.5), ("d", 0.6), ("k", 10.0)] {
            let p = fitted.parameter(name).unwrap();
            // three and a half standard errors
            let half = 3.5 / 1.96 * (p.high - p.low) / 2.0;
            assert!((p.value - truth).abs() <= half && half < 0.05 * truth, "{kind}: {name} {p:?}");
        }
        // the fitted model, written and read, predicts as well
        let again = Model::parse(&fitted.model().to_toml()).unwrap();
        let ran = simulate(&again, &recording[0]).run().unwrap();
        let output = ran.outputs().next().unwrap();
        let error = published::off(output.measured(), output.predicted()).1;
        assert!(error < 1.1e-3, "{kind}: {error}");
    }
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_an_fmu_leaves_out_is_named_at_its_states() {
    let folder = tempfile::tempdir().unwrap();
    if mass(folder.path(), EXCHANGE, "(void)0").is_none() {
        return;
    }
    let model = beside(folder.path());
    let found = diagnosed(&model, recorded([2.5, 0.6, 10.0, 40.0], 1e-3)).answer;
    // k is one of its parameters: that k grows with the square of the position is the same law
    assert!(found.findings[0].ties.iter().all(|t| t == "parameter-dependence"), "{}", found.says);
    assert_eq!(
        (found.findings[0].code.as_str(), found.findings[0].site.name.as_str()),
        ("cubic-stiffness", "speed"),
        "{}",
        found.says
    );
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_fmu_that_is_complete_lacks_nothing() {
    let folder = tempfile::tempdir().unwrap();
    if mass(folder.path(), EXCHANGE, "(void)0").is_none() {
        return;
    }
    let none = diagnosed(&beside(folder.path()), recorded([2.5, 0.6, 10.0, 0.0], 1e-3)).answer;
    assert_eq!(none.verdict, Verdict::NothingMissing, "{}", none.says);
}

#[test]
fn beside_an_fmu_that_steps_itself_the_sensor_is_named() {
    let folder = tempfile::tempdir().unwrap();
    if mass(folder.path(), SIMULATION, "(void)0").is_none() {
        return;
    }
    let model = beside(folder.path());
    let mut recording = recorded([2.5, 0.6, 10.0, 0.0], 1e-3);
    let position = recording.channels.iter_mut().find(|c| c.name == "position").unwrap();
    let times = position.time.clone();
    position.values.iter_mut().zip(times.iter()).for_each(|(x, t)| *x += 2e-4 * t);
    let found = diagnosed(&model, recording).answer;
    assert_eq!(found.findings.first().map(|f| f.code.as_str()), Some("output-drift"), "{}", found.says);
}
