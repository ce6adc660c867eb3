//! What the rolling error says where an input is odd: turns a second, a name with a slip, an input without an end, samples
//! too far apart, an error of zero, a sea whose rational spectrum is off.

use crate::roll_error::{asked, asked_json, command};
use std::f64::consts::TAU;
use std::fmt::Write;
use std::process::Command;

#[test]
fn a_frequency_of_trials_is_read_in_turns_as_in_radians() {
    let folder = tempfile::tempdir().unwrap();
    let told = |unit: &str, by: f64| -> serde_json::Value {
        let mut text = format!("heading [deg],amplitude [cm],frequency [{unit}],error [deg]\n");
        for k in 0..40 {
            let (heading, p) = (9.0 * f64::from(k), 0.5 + 0.05 * f64::from(k % 8));
            let error = -(2.0 * heading.to_radians()).sin() * p.powi(4) / (1.0 + 0.2 * p * p);
            writeln!(text, "{heading},25,{},{}", p * by, error + 1e-3 * f64::from(k * k % 7)).unwrap();
        }
        let file = folder.path().join("trials.csv");
        std::fs::write(&file, text).unwrap();
        let mut run = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
        let out = run.args(["identify", "--json", "--latitude", "60"]).arg(&file).output().unwrap();
        assert!(out.status.success(), "{unit}: {}", String::from_utf8_lossy(&out.stderr));
        serde_json::from_slice(&out.stdout).unwrap()
    };
    let radians = told("rad/s", 1.0);
    let turn = TAU;
    for (unit, by) in [("Hz", 1.0 / turn), ("rev/s", 1.0 / turn), ("rpm", 60.0 / turn)] {
        let turns = told(unit, by);
        for number in ["T_s", "C0_N_per_m"] {
            let [a, b] = [&turns, &radians].map(|t| t[number]["value"].as_f64().unwrap());
            assert!((a / b - 1.0).abs() < 1e-9, "{unit}: {turns} and {radians}");
        }
    }
}

#[test]
fn a_slip_in_a_name_and_an_input_without_an_end_are_told() {
    let (code, _, message) = asked(&["gyrosfere"]);
    assert!(code == 2 && message.contains("the nearest is gyrosphere;"), "{message}");
    if std::path::Path::new("/dev/zero").exists() {
        let (code, _, message) = asked(&["/dev/zero"]);
        assert!(code != 0 && message.contains("without the end of a line"), "{message}");
    }
    let (_, text, _) = asked(&["--list"]);
    assert!(text.contains("U = 7.2921e-5 rad/s") && text.contains("U = 7.3e-5 rad/s"), "{text}");
}

#[test]
fn an_error_of_zero_has_no_side() {
    let (_, text, _) = asked(&["--formula", "--heading", "0"]);
    let line = text.lines().find(|l| l.contains("heading    0.0°")).unwrap();
    assert!(line.ends_with("(neither way)"), "{line}");
}

#[test]
fn samples_too_far_apart_are_told() {
    // waves of 4 s that are seen every 3 s, beside some of 12 s
    let roll = |step: f64| -> String {
        (0..1200).fold("time [s],roll [deg]\n".into(), |text, k| {
            let t = step * f64::from(k);
            let envelope = (0.013 * t).cos() + 0.4 * (0.031 * t).sin();
            format!("{text}{t},{}\n", envelope * (3.0 * (t / 12.0 * TAU).sin() + (t / 4.0 * TAU).sin()))
        })
    };
    let (_, text, message) = command("roll.csv", &roll(3.0), &["--heading", "45"]);
    assert!(text.contains("the samples are too far apart"), "{text}{message}");
    let (_, text, _) = command("roll.csv", &roll(0.25), &["--heading", "45"]);
    assert!(text.contains("good fit") || text.contains("fit") && !text.contains("too far apart"), "{text}");
}

#[test]
fn too_little_roll_is_refused_and_what_is_missing_is_counted() {
    let roll = |rows: &dyn Fn(usize) -> bool, count: usize| -> String {
        (0..count).filter(|k| rows(*k)).fold("time [s],roll [deg]\n".into(), |text, k| {
            let t = 0.25 * k as f64;
            format!("{text}{t},{}\n", 5.0 * (0.6 * t).sin() + 2.0 * (0.7 * t + 1.0).sin())
        })
    };
    // half a period
    let (code, _, message) = command("roll.csv", &roll(&|_| true, 20), &["--heading", "45"]);
    assert!(code != 0 && message.contains("too short"), "{message}");
    // rows of 30 s are not there
    let (_, text, _) = command("roll.csv", &roll(&|k| !(401..520).contains(&k), 1200), &["--heading", "45"]);
    assert!(text.contains("1200 samples 0.2500 s apart, 119 of them missing"), "{text}");
}

#[test]
fn sentences_without_stamps_and_unknown_ones_are_told() {
    let bare = "$GPGGA,120000.00,6000.0,N,00500.0,E,1,8,1.0,10.0,M,40.0,M,,*5C\n$HEHDT,45.0,T*1F\n";
    let folder = tempfile::tempdir().unwrap();
    let record = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).unwrap();
        let mut run = Command::new(env!("CARGO_BIN_EXE_gyrospec"));
        let out = run.arg("record").arg(folder.path().join(name)).output().unwrap();
        String::from_utf8_lossy(&[out.stdout, out.stderr].concat()).into_owned()
    };
    assert!(record("bare.nmea", bare).contains("NMEA 0183 without time stamps"));
    let sentence = |body: &str| {
        let sum = body.bytes().fold(0, |a, b| a ^ b);
        format!("${body}*{sum:02X}\n")
    };
    let both = (0..60).fold(String::new(), |text, k| {
        let line = |body: &str| format!("{} {}", 1_500_000_000 + k, sentence(body));
        text + &line(&format!("HEHDT,{}.5,T", 40 + k % 3)) + &line(&format!("YXXDR,A,{}.25,D,ROLL", k % 4))
    });
    let told = record("both.nmea", &both);
    assert!(told.contains("YXXDR (60) left out") && told.contains("field = 2"), "{told}");
}

#[test]
fn where_the_rational_spectrum_of_a_sea_is_off_each_row_has_the_sums() {
    // from astern nearly at the speed of its waves, and abeam
    let astern = ["--period", "14s", "--sea-from", "160deg", "--also", "pitch", "--speed", "12kn"];
    let (sea, mut seen) = (["--sea", "jonswap"], 0);
    for more in [&astern[..], &["--period", "8s"]] {
        let told = asked_json(&[&sea[..], more].concat());
        let off = told["sea"]["off_by"]["mean"].as_f64().unwrap();
        let much = off.abs() > 0.05;
        assert_eq!(told["trusted_mean"] == "summed_mean_deg", much, "{told}");
        let rows = told["rows"].as_array().unwrap();
        assert_eq!(rows.iter().any(|r| r["summed_mean_deg"].is_f64()), much);
        if much {
            seen += 1;
            let heading = told["sea"]["off_by"]["heading_deg"].as_f64().unwrap();
            let worst = rows.iter().find(|r| r["heading_deg"].as_f64() == Some(heading)).unwrap();
            let sailing = worst["sailing_deg"].as_f64().unwrap();
            let summed = worst["summed_mean_deg"].as_f64().unwrap() - sailing;
            // 1 + off is the mean by the motion over that by the sums
            let by_motion = worst["rectified_deg"].as_f64().unwrap();
            assert!((by_motion / summed - 1.0 - off).abs() < 1e-9, "{worst} {off}");
        }
    }
    assert_eq!(seen, 1);
}

/// Acceleration goes with the square of the frequency, and the error with its square: the rounding of a coarse instrument would
/// outweigh the roll in the measured spectrum.
#[test]
fn a_roll_in_coarse_steps_is_not_trusted_to_its_spectrum() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("roll.csv");
    let mean = |step: f64| {
        let mut text = "time [s],roll [deg]\n".to_owned();
        for k in 0..4800 {
            let t = 0.25 * f64::from(k);
            let roll = 3.0 * (TAU * t / 9.0).sin();
            writeln!(text, "{t},{:.4}", (roll / step).round() * step).unwrap();
        }
        std::fs::write(&file, text).unwrap();
        let told = asked_json(&[file.to_str().unwrap()]);
        let trusted = told["trusted_mean"].as_str().unwrap().to_owned();
        (told["rows"][0][&trusted].as_f64().unwrap(), told["note"].as_str().unwrap().to_owned())
    };
    // the mean on such a sine by the formula of regular roll
    let told = asked_json(&["--regular", "3deg,9s"]);
    let regular = told["rows"][0]["mean_deg"].as_f64().unwrap();
    for step in [1.0, 0.5] {
        let (coarse, note) = mean(step);
        assert!((coarse / regular - 1.0).abs() < 0.1, "{step}: {coarse} for {regular}");
        assert!(note.contains(&format!("in steps of {step}")), "{note}");
    }
    let (fine, note) = mean(0.001);
    assert!((fine / regular - 1.0).abs() < 0.1 && !note.contains("in steps of"), "{fine}: {note}");
}

/// ⟨x⁴⟩/⟨x²⟩² of a sine is 3/2: no strong and weak rolling come and go in it.
#[test]
fn a_recorded_roll_that_keeps_its_size_has_no_slow_spread_and_that_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let told = |size: &dyn Fn(f64) -> f64| {
        let mut text = String::from("t [s],roll [deg]\n");
        for k in 0..3600 {
            let t = 0.5 * f64::from(k);
            writeln!(text, "{t},{:.4}", size(t) * (TAU * t / 10.0).sin()).unwrap();
        }
        let file = folder.path().join("roll.csv");
        std::fs::write(&file, text).unwrap();
        asked(&[file.to_str().unwrap(), "--heading", "45"]).1
    };
    let steady = told(&|_| 5.0);
    assert!(steady.contains("this roll keeps its size (kurtosis 1.50"), "{steady}");
    // a beat of all of it: 3/2 · 35/128 · 64/9
    let beating = told(&|t| 5.0 * (TAU * t / 97.0).sin().powi(2));
    assert!(!beating.contains("keeps its size"), "{beating}");
}
