//! Dead reckoning by a compass whose own error goes with the heading that it shows.

use crate::diagnose::{diagnosed, noise};
use crate::laws_met::{named, runge_kutta};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;

const RECKONING: &str = r#"
    name = "reckoning"
    [inputs]
    speed = { unit = "m/s" }
    compass = { unit = "deg" }
    [parameters]
    log = { value = 1.1, unit = "1", fit = true }
    drift_north = { value = 0, unit = "m/s", fit = true }
    drift_east = { value = 0, unit = "m/s", fit = true }
    [states]
    north = { rate = "log*speed*cos(compass) + drift_north", unit = "m", initial = 0 }
    east = { rate = "log*speed*sin(compass) + drift_east", unit = "m", initial = 0 }
    [outputs]
    fixed_north = { equals = "north", unit = "m" }
    fixed_east = { equals = "east", unit = "m" }
"#;

const COUNT: usize = 1500;
const STEP: f64 = 2.0;

/// What the compass shows, rad: turns through all headings.
fn shown(t: f64) -> f64 {
    0.004 * t + 1.3 * (0.009 * t).sin() + 0.3 * (0.027 * t).cos()
}

fn speed(t: f64) -> f64 {
    4.0 + 0.8 * (0.015 * t).sin() + 0.4 * (0.065 * t).sin()
}

/// What is said where the compass shows so much more than the course, rad, by what it shows.
fn told(deviation: impl Fn(f64) -> f64) -> Answer {
    let track = runge_kutta(
        (STEP, COUNT, 4),
        |t| [speed(t), shown(t) - deviation(shown(t))],
        |_, [v, k]: [f64; 2]| [v * k.cos() + 0.3, v * k.sin() - 0.2],
    );
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let fixed = |k: usize| -> Vec<f64> {
        track.iter().zip(noise(COUNT, 3 + k as u64)).map(|(x, e)| x[k] + 0.5 * e).collect()
    };
    let channel = |name: &str, unit: &str, values: Vec<f64>| {
        Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
    };
    let channels = vec![
        channel("speed", "m/s", time.iter().map(|t| speed(*t)).collect()),
        channel("compass", "deg", time.iter().map(|t| shown(*t)).collect()),
        channel("fixed_north", "m", fixed(0)),
        channel("fixed_east", "m", fixed(1)),
    ];
    let recording = Recording::from_channels("made", channels).unwrap();
    diagnosed(&Model::parse(RECKONING).unwrap(), recording).answer
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_compass_has_a_deviation() {
    let degrees = f64::to_radians(1.0);
    // semicircular: the course is what is shown, K, less 4 sin K - 3 cos K
    let answer = told(|k| degrees * (4.0 * k.sin() - 3.0 * k.cos()));
    let found = named(&answer);
    assert!(matches!(found[..], [("misalignment", "compass", _)]), "{found:?}");
    let parts: Vec<f64> = answer.findings[0].parameters.iter().map(|p| p.value).collect();
    assert!((parts[0] + 4.0).abs() < 0.05 && (parts[1] - 3.0).abs() < 0.05, "{parts:?}");

    // quadrantal
    let answer = told(|k| degrees * 2.0 * (2.0 * k).sin());
    let found = named(&answer);
    assert!(matches!(found[..], [("misalignment", "compass", a)] if (a + 2.0).abs() < 0.05), "{found:?}");

    // a whole card: A, B, C and D
    let answer = told(|k| degrees * (1.5 + 5.0 * k.sin() + 2.0 * k.cos() + 1.2 * (2.0 * k).sin()));
    let found = named(&answer);
    assert!(found.iter().all(|f| (f.0, f.1) == ("misalignment", "compass")), "{found:?}");
    assert!(answer.proof.iter().all(|p| p.holdout_after < 1.0), "{}", answer.says);

    let answer = told(|_| 0.0);
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
}

/// A compass beside a reference through 150 degrees, which the model reads as the reference and a constant.
#[test]
fn a_compass_beside_a_reference_has_a_deviation_though_no_turn_is_full() {
    let degrees = f64::to_radians(1.0);
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let course: Vec<f64> =
        time.iter().map(|t| 2.0 + 1.1 * (0.009 * t).sin() + 0.3 * (0.05 * t).sin()).collect();
    let deviation = |k: f64| degrees * (1.0 + 2.0 * k.sin() + 1.1 * k.cos());
    let shown = course.iter().zip(noise(COUNT, 8)).map(|(k, e)| k + deviation(*k) + 0.3 * degrees * e);
    let channel = |name: &str, values| Channel::new(name, Unit::parse("rad").unwrap(), time.clone(), values);
    let channels = vec![channel("compass", shown.collect()), channel("reference", course.clone())];
    let recording = Recording::from_channels("made", channels).unwrap();
    let model = Model::parse(
        r#"
        name = "compass"
        [inputs]
        reference = { unit = "rad" }
        [parameters]
        A = { value = 0, unit = "rad", fit = true }
        [outputs]
        compass = { equals = "reference + A", unit = "rad" }
        "#,
    );
    let answer = diagnosed(&model.unwrap(), recording).answer;
    let found = named(&answer);
    assert!(matches!(found[..], [("periodic-force", "compass", _)]), "{found:?} {}", answer.says);
    let parts: Vec<f64> = answer.findings[0].parameters.iter().map(|p| p.value / degrees).collect();
    assert!((parts[0] - 2.0).abs() < 0.1 && (parts[1] - 1.1).abs() < 0.1, "{parts:?}");
}
