//! What stands between two bodies: a coupling with play, a damper with friction or harder one way, a spring that hardens.

use crate::diagnose::{diagnosed, noise};
use crate::laws_met::runge_kutta;
use gyrospec::diagnose::answer::{Finding, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use std::f64::consts::TAU;

const DRIVE: &str = r#"
name = "drive"
[inputs]
M = { unit = "N*m" }
[parameters]
Jm = { value = 0.02, unit = "kg*m^2" }
Jl = { value = 0.1, unit = "kg*m^2", fit = true, min = 0.01, max = 1 }
k = { value = 60, unit = "N*m/rad", fit = true, min = 5, max = 1000 }
c = { value = 0.3, unit = "N*m*s/rad", fit = true, min = 0.01, max = 10 }
b = { value = 0.1, unit = "N*m*s/rad", fit = true, min = 0, max = 10 }
[definitions]
slip = { equals = "wm - wl", unit = "rad/s" }
[states]
qm = { rate = "wm", unit = "rad", initial = 0 }
wm = { rate = "(M - b*wm - k*(qm - ql) - c*slip)/Jm", unit = "rad/s", initial = 0 }
ql = { rate = "wl", unit = "rad", initial = 0 }
wl = { rate = "(c*slip - k*(ql - qm))/Jl", unit = "rad/s", initial = 0 }
[outputs]
motor = { equals = "wm", unit = "rad/s" }
load = { equals = "wl", unit = "rad/s" }
"#;

const STEP: f64 = 0.01;
const COUNT: usize = 3000;
const NOISE: f64 = 0.02;

fn torque(t: f64) -> f64 {
    let lines = [(0.31, 0.2), (0.83, 1.7), (1.37, 4.0), (2.21, 0.9), (3.13, 2.8), (3.77, 5.1)];
    lines.iter().map(|(f, p)| 0.7 * (TAU * f * t + p).sin()).sum()
}

/// The drive with a torque of twist and slip between motor and load.
fn recorded(between: impl Fn(f64, f64) -> f64) -> Recording {
    let rates = |x: [f64; 4], [m]: [f64; 1]| {
        let through = between(x[0] - x[2], x[1] - x[3]);
        [x[1], (m - 0.13 * x[1] - through) / 0.02, x[3], through / 0.13]
    };
    let states = runge_kutta((STEP, COUNT, 20), |t| [torque(t)], rates);
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let of = |k: usize| states.iter().map(|x| x[k]).collect();
    let (motor, load) = (of(1), of(3));
    let noisy = |v: Vec<f64>, seed| v.iter().zip(noise(COUNT, seed)).map(|(v, e)| v + NOISE * e).collect();
    let channel = |name, unit, v| Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), v);
    let channels = vec![
        channel("M", "N*m", time.iter().map(|t| torque(*t)).collect()),
        channel("motor", "rad/s", noisy(motor, 5)),
        channel("load", "rad/s", noisy(load, 6)),
    ];
    Recording::from_channels("drive", channels).unwrap()
}

/// The one finding, with what is held out down to the noise.
fn named(between: impl Fn(f64, f64) -> f64) -> Finding {
    let found = diagnosed(&Model::parse(DRIVE).unwrap(), recorded(between)).answer;
    assert_eq!((found.verdict, found.findings.len()), (Verdict::Named, 1), "{}", found.says);
    assert!(found.proof.iter().all(|p| p.holdout_after < 1.1 * NOISE), "{}", found.says);
    found.findings[0].clone()
}

fn is(found: &Finding, code: &str, place: &str, value: f64, within: f64) {
    assert_eq!((found.code.as_str(), found.site.name.as_str()), (code, place), "{}", found.says);
    let got = found.parameters[0].value;
    assert!((got - value).abs() < within, "{got}: {}", found.says);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn play_in_a_coupling() {
    let free = |x: f64| x - x.clamp(-0.01, 0.01);
    is(&named(|twist, slip| 80.0 * free(twist) + 0.2 * slip), "backlash", "wm", 0.02, 2e-4);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_shaft_that_stiffens() {
    let found = named(|twist, slip| 50.0 * twist + 30_000.0 * twist.powi(3) + 0.2 * slip);
    is(&found, "cubic-stiffness", "wm", 30_000.0, 1500.0);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn friction_between_two_bodies() {
    let found = named(|twist, slip| 80.0 * twist + 0.1 * slip + 0.15 * (slip / 0.003).tanh());
    is(&found, "dry-friction", "wm", 0.15, 0.01);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_damper_that_is_harder_one_way() {
    let found = named(|twist, slip| 80.0 * twist + 0.9 * (1.0 + 0.5 * slip.signum()) * slip);
    is(&found, "parameter-dependence", "c", 0.5, 0.05);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_stop_on_one_side_of_a_shaft() {
    let found = named(|twist, slip| 80.0 * twist - 300.0 * (-0.012 - twist).max(0.0) + 0.2 * slip);
    is(&found, "end-stop", "wm", 300.0, 15.0);
    assert!((found.parameters[1].value + 0.012).abs() < 5e-4, "{}", found.says);
}

/// A rubber stop and a damper that is harder one way, as in the suspension of a car.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_stop_beside_a_damper_that_is_harder_one_way() {
    let damper = |slip: f64| 0.9 * (1.0 + 0.5 * slip.signum()) * slip;
    let torque =
        |twist: f64, slip: f64| 80.0 * twist + 30_000.0 * (twist - 0.012).max(0.0).powi(2) + damper(slip);
    let found = diagnosed(&Model::parse(DRIVE).unwrap(), recorded(torque)).answer;
    assert_eq!((found.verdict, found.findings.len()), (Verdict::Named, 2), "{}", found.says);
    let of = |code: &str| found.findings.iter().find(|f| f.code == code).map(|f| f.parameters[0].value);
    assert!(of("end-stop").is_some_and(|k| (k / 30_000.0 - 1.0).abs() < 0.1), "{}", found.says);
    assert!(of("parameter-dependence").is_some_and(|a| (a - 0.5).abs() < 0.05), "{}", found.says);
}

#[test]
fn a_shaft_as_the_model_has_it() {
    let found =
        diagnosed(&Model::parse(DRIVE).unwrap(), recorded(|twist, slip| 80.0 * twist + 0.2 * slip)).answer;
    assert_eq!(found.verdict, Verdict::NothingMissing, "{}", found.says);
}
