//! A logger that was off for a while before a thing that remembers for longer: what follows has a start of its own.

use crate::diagnose::{diagnosed, noise};
use crate::laws_met::{FURNACE, inputs, named, run};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use std::ops::Range;

/// What is told where no row was written for 3 s, and the probe shows so much at so many degrees.
fn told(shows: impl Fn(f64) -> f64) -> Answer {
    let answer = told_with_time(1200..1350, |_, t| shows(t));
    assert!(answer.notes.iter().any(|n| n.contains("'off' is read in 2 pieces")), "{:?}", answer.notes);
    assert!(!answer.notes.iter().any(|n| n.contains("are not compared")), "{:?}", answer.notes);
    answer
}

/// What is told where some rows were not written, and the probe shows so much at a time and so many degrees.
fn told_with_time(lacks: Range<usize>, shows: impl Fn(f64, f64) -> f64) -> Answer {
    // a time constant of 20 s in a recording of 60 s
    let states = run(|[x], u| [(u + 3.0 - 0.1 * x) / 2.0]);
    let kept: Vec<usize> = (0..states.len()).filter(|i| !lacks.contains(i)).collect();
    let time: Vec<f64> = kept.iter().map(|i| 0.02 * *i as f64).collect();
    let noise = noise(states.len(), 12);
    let power = kept.iter().map(|i| inputs()[*i] + 3.0).collect();
    let shown = |i: usize| 273.15 + shows(0.02 * i as f64, 20.0 + states[i][0]) + 0.02 * noise[i];
    let probe = kept.iter().map(|i| shown(*i)).collect();
    let unit = |text| Unit::parse(text).unwrap();
    let channels = vec![
        Channel::new("power", unit("W"), time.clone(), power),
        Channel::new("probe", unit("degC"), time, probe),
    ];
    let recording = Recording::from_channels("off", channels).unwrap();
    diagnosed(&Model::parse(FURNACE).unwrap(), recording).answer
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_follows_a_gap_of_the_logger_is_compared() {
    let answer = told(|t| t);
    assert_eq!(answer.verdict, Verdict::DataFault, "{}", answer.says);
    assert!(answer.says.contains("Beside that nothing is missing"), "{}", answer.says);
    assert!(answer.faults.iter().all(|f| f.finding.code == "gap" && f.masked), "{}", answer.says);
    assert!((answer.parameters[0].after - 2.0).abs() < 0.01, "{:?}", answer.parameters[0].after);
    assert!((answer.proof[0].holdout_after - 0.02).abs() < 0.002, "{}", answer.proof[0].holdout_after);

    let answer = told(|t| t - 2e-3 * t * t);
    let found = named(&answer);
    assert!(matches!(found[..], [("output-square", "probe", a)] if (a + 2e-3).abs() < 2e-4), "{found:?}");
}

#[test]
fn what_goes_with_time_is_found_beside_a_gap_of_the_logger() {
    // a sensor that drifts by 0.02 K/s: the pieces share a clock
    let answer = told_with_time(2200..2350, |time, t| t + 0.02 * time);
    assert!(matches!(answer.verdict, Verdict::Named | Verdict::Tie), "{}", answer.says);
    assert_eq!(answer.findings[0].code, "output-drift", "{}", answer.says);
    let drift = &answer.findings[0].parameters[0];
    assert!(drift.low < 0.02 && 0.02 < drift.high && drift.high < 0.03, "{}", answer.says);
}
