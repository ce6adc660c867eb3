//! A gyrocompass whose readings come late: what is missing goes with the rate of turn, and is drawn against it.

use crate::diagnose::diagnosed;
use gyrospec::record::Channel;
use gyrospec::{Model, Recording, Unit};
use std::f64::consts::TAU;

const MODEL: &str = r#"
name = "a gyro beside a satellite compass"
[inputs]
satellite = { unit = "deg" }
[parameters]
A = { value = 0.0, unit = "deg", fit = true }
[outputs]
gyro = { equals = "satellite + A", unit = "deg" }
"#;

/// Heading of a ship that zigzags, rad.
fn heading(t: f64) -> f64 {
    0.8 + 0.35 * (TAU * t / 240.0).sin() + 0.1 * (TAU * t / 67.0 + 0.4).sin()
}

fn noise(count: usize) -> Vec<f64> {
    let mut state = 7u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    (0..count).map(|_| 2e-3 * (next() + next() + next())).collect()
}

#[test]
fn a_shift_in_time_is_drawn_against_the_rate_of_turn() {
    let late = 0.6;
    let time: Vec<f64> = (0..2400).map(f64::from).collect();
    let degrees = Unit::parse("deg").unwrap();
    let satellite: Vec<f64> = time.iter().map(|t| heading(*t)).collect();
    let gyro: Vec<f64> =
        time.iter().zip(noise(time.len())).map(|(t, e)| heading(t - late) + 0.01 + e).collect();
    let channels = [("satellite", satellite), ("gyro", gyro)]
        .map(|(name, values)| Channel::new(name, degrees.clone(), time.clone(), values));
    let recording = Recording::from_channels("zigzag", channels.to_vec()).unwrap();
    let d = diagnosed(&Model::parse(MODEL).unwrap(), recording);
    let codes: Vec<&str> = d.answer.findings.iter().map(|f| f.code.as_str()).collect();
    assert!(matches!(codes[..], ["input-delay" | "output-delay", ..]), "{codes:?} {}", d.answer.says);
    let law = &d.pictures.laws[0];
    assert!(law.signal == "rate of satellite" || law.signal == "rate of gyro", "{}", law.signal);
    assert_eq!(law.signal_unit, "deg/s");
    // u(t − τ) − u(t) = −τ u̇: the slope of what is missing is the shift, and so is that of the fitted line
    let slope = |points: &[[f64; 2]]| {
        let n = points.len() as f64;
        let [x, y] = [0, 1].map(|i| points.iter().map(|p| p[i]).sum::<f64>() / n);
        let xy: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
        xy / points.iter().map(|p| (p[0] - x).powi(2)).sum::<f64>()
    };
    let curve: Vec<[f64; 2]> = law.curve.iter().map(|c| [c[0], c[1]]).collect();
    for found in [slope(&law.samples), slope(&curve)] {
        assert!((found + late).abs() < 0.06, "{found}");
    }
    let rate = law.samples.iter().map(|p| p[0].abs()).fold(0.0, f64::max);
    let fastest = (0.35f64 / 240.0 + 0.1 / 67.0) * TAU;
    assert!(rate < 1.1 * fastest.to_degrees() && rate > 0.6 * fastest.to_degrees(), "{rate}");
    assert!(d.answer.next_experiment.iter().all(|n| !n.contains("switched off")));
}
