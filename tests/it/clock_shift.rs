//! A gyrocompass whose readings come late: what is missing goes with the rate of turn, and is drawn against it.

use crate::diagnose::diagnosed;
use crate::laws_met::runge_kutta;
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

/// A line of a log, from a second after midnight and a heading in degrees.
fn sentence(second: f64, talker: &str, heading: f64) -> String {
    let body = format!("{talker}HDT,{:.2},T", heading.rem_euclid(360.0));
    let sum = body.bytes().fold(0, |x, b| x ^ b);
    let (minute, second) = ((second / 60.0).floor(), second.rem_euclid(60.0));
    format!("2025-03-04T00:{minute:02}:{second:06.3}Z ${body}*{sum:02X}\n")
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_instrument_that_is_logged_late_beside_another_in_one_log_is_found() {
    let (late, noise) = (0.43, noise(1200));
    let mut lines: Vec<(f64, String)> = (0..1200)
        .flat_map(|i| {
            let (t, e) = (f64::from(i), noise[i as usize]);
            let gyro = sentence(t, "HE", (heading(t) + 0.01 + 0.1 * e).to_degrees());
            // the satellite compass says where the ship headed before its line was written
            let satellite = sentence(t + 0.2, "GP", heading(t + 0.2 - late).to_degrees());
            [(t, gyro), (t + 0.2, satellite)]
        })
        .collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    let folder = tempfile::tempdir().unwrap();
    let log: String = lines.into_iter().map(|(_, line)| line).collect();
    std::fs::write(folder.path().join("ship.nmea"), log).unwrap();
    let text = "[[tables]]\nfile = \"ship.nmea\"\nformat = \"nmea0183\"\ntime = { start = \"2025-03-04T00:00:00Z\" }\n\
        [tables.channels]\ngyro = { sentence = \"HEHDT\", field = 1, unit = \"deg\", wraps = true }\n\
        satellite = { sentence = \"GPHDT\", field = 1, unit = \"deg\", wraps = true }\n";
    std::fs::write(folder.path().join("ship.toml"), text).unwrap();
    let recording = Recording::read(folder.path().join("ship.toml")).unwrap();
    let found = &diagnosed(&Model::parse(MODEL).unwrap(), recording).answer;
    assert_eq!(found.findings.first().map(|f| f.code.as_str()), Some("clock-offset"), "{}", found.says);
    let offset = &found.findings[0].parameters[0];
    assert!(offset.low < late && late < offset.high && offset.high - offset.low < 0.1, "{offset:?}");
}

const TURNTABLE: &str = r#"
name = "turntable"
[inputs]
torque = { unit = "N*m" }
[parameters]
J = { value = 2, unit = "kg*m^2" }
c = { value = 0.3, unit = "N*m*s", fit = true, min = 0 }
k = { value = 1, unit = "N*m", fit = true, min = 0 }
[states]
a = { rate = "w", unit = "rad", initial = 0 }
w = { rate = "(torque - c*w - k*a)/J", unit = "rad/s", initial = 0 }
[outputs]
speed = { equals = "w", unit = "rad/s" }
angle = { equals = "a", unit = "rad" }
"#;

/// A turntable with a spring, whose angle and speed two loggers read: time, and both with noise; nothing is left out but
/// that the rows of the second are stamped early by so much.
fn turntable(early: f64) -> Recording {
    let torque = |t: f64| (0.9 * t).sin() + 0.8 * (2.3 * t + 1.0).cos() + 0.6 * (0.31 * t).sin();
    let (step, count, finer) = (0.1, 1500, 10);
    // Rows of the second logger that hold what was a little later: taken from a finer run.
    let fine = runge_kutta(
        (step / finer as f64, count * finer, 4),
        |t| [torque(t)],
        |[a, w]: [f64; 2], [u]| [w, (u - 0.4 * w - 1.3 * a) / 2.0],
    );
    let later = (early * finer as f64 / step).round() as i64;
    let unit = |text: &str| Unit::parse(text).unwrap();
    let time: Vec<f64> = (0..count).map(|i| step * i as f64).collect();
    let read = |k: usize, shift: i64| -> Vec<f64> {
        let noise = crate::diagnose::noise(count, 3 + k as u64);
        let at =
            |i: usize| fine[(i as i64 * finer as i64 + shift).clamp(0, fine.len() as i64 - 1) as usize][k];
        noise.iter().enumerate().map(|(i, e)| at(i) + 0.005 * e).collect()
    };
    let mut channels = vec![
        Channel::new(
            "torque",
            unit("N*m"),
            time.clone(),
            time.iter().map(|t| torque(*t)).collect::<Vec<f64>>(),
        ),
        Channel::new("speed", unit("rad/s"), time.clone(), read(1, 0)),
        Channel::new("angle", unit("rad"), time, read(0, later)),
    ];
    channels[2].table = 1;
    Recording::from_channels("night", channels).unwrap()
}

/// What a logger with the input and an output stamps late, and what one without inputs stamps early, is one thing; an
/// output that is late by itself is a late sensor.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_second_logger_stamps_early_or_late() {
    // A run that is read ahead begins where the turntable was a little later than at its given beginning.
    let model = Model::parse(&TURNTABLE.replace("initial = 0", "initial = \"fit\"")).unwrap();
    for (early, code, site) in [(0.07, "clock-offset", "speed"), (-0.07, "output-delay", "angle")] {
        let answer = diagnosed(&model, turntable(early)).answer;
        let finding = &answer.findings[0];
        assert_eq!((answer.findings.len(), finding.code.as_str()), (1, code), "{}", answer.says);
        assert_eq!(finding.site.name, site, "{}", answer.says);
        let found = &finding.parameters[0];
        assert!(found.low < 0.07 && 0.07 < found.high && found.high - found.low < 0.01, "{}", answer.says);
    }
    let answer = diagnosed(&model, turntable(0.0)).answer;
    assert!(answer.findings.is_empty(), "{}", answer.says);
}

/// A turntable whose angle a second logger reads, with a clock of its own: what the model makes is known before alone,
/// so that of two loggers the fast one reads late.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn the_clock_of_a_second_logger_runs_fast_or_slow() {
    let torque = |t: f64| (0.9 * t).sin() + 0.8 * (2.3 * t + 1.0).cos() + 0.6 * (0.31 * t).sin();
    let (step, count) = (0.1, 1500);
    let states = runge_kutta(
        (step, count, 20),
        |t| [torque(t)],
        |[a, w]: [f64; 2], [u]| [w, (u - 0.4 * w - 1.3 * a) / 2.0],
    );
    for fast in [7e-4, -7e-4] {
        let time: Vec<f64> = (0..count).map(|i| step * i as f64).collect();
        let unit = |text: &str| Unit::parse(text).unwrap();
        let noisy = |k: usize, size: f64| -> Vec<f64> {
            let noise = crate::diagnose::noise(count, 3 + k as u64);
            states.iter().zip(noise).map(|(x, e)| x[k] + size * e).collect()
        };
        let first = time.iter().map(|t| torque(*t)).collect();
        let mut channels = vec![
            Channel::new("torque", unit("N*m"), time.clone(), first),
            Channel::new("speed", unit("rad/s"), time.clone(), noisy(1, 0.005)),
            Channel::new(
                "angle",
                unit("rad"),
                time.iter().map(|t| t * (1.0 + fast)).collect::<Vec<f64>>(),
                noisy(0, 0.005),
            ),
        ];
        channels[2].table = 1;
        let recording = Recording::from_channels("night", channels).unwrap();
        let answer = diagnosed(&Model::parse(TURNTABLE).unwrap(), recording).answer;
        let finding = &answer.findings[0];
        assert_eq!((answer.findings.len(), finding.code.as_str()), (1, "clock-drift"), "{}", answer.says);
        // where the second runs slow, the first runs fast against it
        let site = if fast > 0.0 { "angle" } else { "speed" };
        assert_eq!(finding.site.name, site, "{}", answer.says);
        let rate = finding.parameters[0].value;
        assert!((rate - 7e-4).abs() < 3e-5, "{}", answer.says);
    }
}

/// Who joined two loggers row by row took both clocks for one.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_clock_that_ran_off_before_the_rows_were_joined_is_told() {
    let fast = 8e-4;
    let torque = |t: f64| (0.9 * t).sin() + 0.8 * (2.3 * t + 1.0).cos() + 0.6 * (0.31 * t).sin();
    let (step, count) = (0.1, 1500);
    let drifted = |early: f64| {
        let pace = 1.0 + early;
        let states = runge_kutta(
            (step, count, 20),
            |t| [torque(t * pace)],
            |[a, w]: [f64; 2], [u]| [pace * w, pace * (u - 0.4 * w - 1.3 * a) / 2.0],
        );
        let time: Vec<f64> = (0..count).map(|i| step * i as f64).collect();
        let unit = |text: &str| Unit::parse(text).unwrap();
        let given = time.iter().map(|t| torque(*t)).collect();
        let errors = crate::diagnose::noise(count, 8);
        let read = states.iter().zip(errors).map(|(x, e)| x[0] + 0.005 * e).collect();
        let channels = vec![
            Channel::new("torque", unit("N*m"), time.clone(), given),
            Channel::new("angle", unit("rad"), time, read),
        ];
        let model = TURNTABLE.replace(r#"speed = { equals = "w", unit = "rad/s" }"#, "");
        diagnosed(&Model::parse(&model).unwrap(), Recording::from_channels("joined", channels).unwrap())
            .answer
    };
    let answer = drifted(fast);
    let finding = &answer.findings[0];
    assert_eq!((answer.findings.len(), finding.code.as_str()), (1, "clock-drift"), "{}", answer.says);
    // the angle at t is that of t (1 + 8e-4): against it the clock of the torque gains as much
    let rate = finding.parameters[0].value;
    assert!((rate - fast).abs() < 3e-5, "{}", answer.says);
    assert_eq!(drifted(0.0).verdict, gyrospec::diagnose::answer::Verdict::NothingMissing);
}
