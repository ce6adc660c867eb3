//! Turns or radians: a unit that may mean either is asked for wherever it meets an angular speed.

use gyrospec::ErrorKind;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Constant, Recording};
use gyrospec::simulate::{Options, Simulator};
use gyrospec::units::Unit;
use std::fs;
use std::process::Command;

const ANGULAR: [&str; 4] = ["rad/s", "rpm", "deg/s", "mrad/s"];
const ASKED: [&str; 5] = ["1/min", "Hz", "rev/s", "kHz", "rev/min"];

fn unit(text: &str) -> Unit {
    Unit::parse(text).unwrap()
}

/// A motor whose speed is an output, and one whose speed drives it.
fn motor(speed: &str) -> [Model; 2] {
    let output = format!(
        "name = \"motor\"\n[inputs]\nvoltage = {{ unit = \"V\" }}\n[parameters]\n\
         k = {{ value = 10.0, unit = \"rad/(V*s)\" }}\nT = {{ value = 0.5, unit = \"s\" }}\n\
         w0 = {{ value = 0.0, unit = \"{speed}\" }}\n[states]\n\
         w = {{ rate = \"(k*voltage + w0 - w)/T\", unit = \"rad/s\", initial = 0.0 }}\n\
         [outputs]\nspeed = {{ equals = \"w\", unit = \"{speed}\" }}\n"
    );
    let input = format!(
        "name = \"wheel\"\n[inputs]\nspeed = {{ unit = \"{speed}\" }}\n[states]\n\
         q = {{ rate = \"speed\", unit = \"rad\", initial = 0.0 }}\n[outputs]\nvoltage = {{ equals = \"q\", unit = \"rad\" }}\n"
    );
    [Model::parse(&output).unwrap(), Model::parse(&input).unwrap()]
}

fn recording(speed: &str, voltage: &str) -> Recording {
    let time: Vec<f64> = (0..50).map(|i| 0.1 * f64::from(i)).collect();
    let channel = |name: &str, of: &str| {
        Channel::new(name, unit(of), time.clone(), time.iter().map(|t| t.sin()).collect::<Vec<_>>())
    };
    Recording::from_channels("made", vec![channel("speed", speed), channel("voltage", voltage)]).unwrap()
}

#[test]
fn a_channel_that_may_mean_turns_is_asked_about() {
    for wanted in ANGULAR {
        for (model, voltage) in motor(wanted).iter().zip(["V", "rad"]) {
            for given in ASKED {
                let e = Simulator::new(model, &recording(given, voltage), &Options::default()).err().unwrap();
                assert_eq!(e.kind(), ErrorKind::Units);
                assert!(e.message().contains("turns or radians?"), "{given} for {wanted}: {e}");
                assert!(e.message().contains("put speed") && e.message().contains(given), "{e}");
                assert!(e.hint().unwrap().contains("rpm"), "{e}");
            }
            for given in ANGULAR.iter().chain(&["1/s", "rad/min", "rad/h"]) {
                Simulator::new(model, &recording(given, voltage), &Options::default()).unwrap();
            }
        }
    }
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_column_that_says_nothing_of_an_angle_is_taken_for_radians_and_said() {
    let said = |wanted: &str, given: &str| {
        let model = &motor(wanted)[0];
        let recordings = [recording(given, "V")];
        let ran = gyrospec::simulate(model, &recordings[0]).run().unwrap();
        let fitted = gyrospec::fit(model, &recordings).run().unwrap();
        let found = gyrospec::diagnose(model, &recordings).run().unwrap();
        let fitted: Vec<String> = fitted.warnings().map(str::to_owned).collect();
        let notes = found.answer().notes.clone();
        [ran.warnings(), fitted, notes].map(|all| {
            let about: Vec<String> = all.into_iter().filter(|w| w.contains("taken as radians")).collect();
            assert!(about.len() < 2, "{about:?}");
            about.first().cloned()
        })
    };
    for wanted in ["rpm", "rad/s"] {
        for about in said(wanted, "1/s") {
            let about = about.unwrap();
            assert!(
                about.contains("speed is in 1/s")
                    && about.contains(wanted)
                    && about.contains("times 60 in rpm")
            );
        }
        assert!(said(wanted, "rpm").iter().all(Option::is_none));
    }
}

#[test]
fn a_speed_for_what_counts_events_is_asked_about_too() {
    let text = "name = \"counter\"\n[inputs]\nspeed = { unit = \"Hz\" }\n[outputs]\nvoltage = { equals = \"speed\", unit = \"1/min\" }\n";
    let model = Model::parse(text).unwrap();
    for given in ["rpm", "rad/s", "deg/s", "rev/s"] {
        let e = Simulator::new(&model, &recording(given, "1/min"), &Options::default()).err().unwrap();
        assert!(e.message().contains("turns or radians?"), "{e}");
    }
    for given in ["Hz", "1/min", "kHz", "1/s", "1/d"] {
        Simulator::new(&model, &recording(given, "Hz"), &Options::default()).unwrap();
    }
}

#[test]
fn a_rate_constant_in_any_spelling_is_no_angular_speed() {
    let text = |unit: &str| {
        format!(
            "name = \"decay\"\n[inputs]\nvoltage = {{ unit = \"V\" }}\n[parameters]\nk = {{ value = 2.0, unit = \"{unit}\" }}\n\
             [states]\nspeed_state = {{ rate = \"k*(voltage - speed_state)\", unit = \"V\", initial = 0.0 }}\n\
             [outputs]\nspeed = {{ equals = \"speed_state\", unit = \"V\" }}\n"
        )
    };
    for given in ["1/s", "1/min", "Hz", "1/h", "1/d", "%/s"] {
        let model = Model::parse(&text(given)).unwrap();
        let mut r = recording("V", "V");
        let constant = unit("1/min");
        r.constants.push(Constant { name: "k".into(), value: constant.to_si(30.0), unit: constant });
        let s = Simulator::new(&model, &r, &Options::default()).unwrap();
        assert_eq!(s.parameters(), [0.5], "30 a minute is half a one a second, in {given}");
    }
}

#[test]
fn constants_of_a_recording_are_asked_about() {
    let [model, _] = motor("rpm");
    for given in ASKED {
        let mut r = recording("rpm", "V");
        r.constants.push(Constant { name: "w0".into(), value: 1.0, unit: unit(given) });
        let e = Simulator::new(&model, &r, &Options::default()).err().unwrap();
        assert!(e.message().contains("the constant w0") && e.message().contains("turns or radians?"), "{e}");
    }
}

#[test]
fn terms_and_wholes_of_a_model_are_asked_about() {
    let text = |slip: &str, speed: &str, rate: &str| {
        format!(
            "name = \"slip\"\n[inputs]\nw = {{ unit = \"rpm\" }}\n[parameters]\nf = {{ value = 50.0, unit = \"Hz\" }}\n\
             n = {{ value = 2.0, unit = \"rev/s\" }}\n\
             [definitions]\nslip = {{ equals = \"{slip}\", unit = \"rad/s\" }}\n[states]\n\
             q = {{ rate = \"{rate}\", unit = \"rad\", initial = 0.0 }}\n\
             [outputs]\nspeed = {{ equals = \"{speed}\", unit = \"rpm\" }}\n"
        )
    };
    for (slip, speed, rate, column) in [
        ("w + n - f", "w", "w", 9),
        ("abs(f)", "w", "w", 1),
        ("max(w, f)", "w", "w", 8),
        ("w", "-f", "w", 1),
        ("w", "clamp(w, 0, abs(f))", "w", 13),
        ("w", "w", "f", 1),
    ] {
        let e = Model::parse(&text(slip, speed, rate)).unwrap_err();
        assert!(e.to_string().contains("turns or radians?"), "{e}");
        let shown = e.to_string();
        let marked = shown.lines().find(|l| l.trim_start().starts_with('^')).unwrap();
        assert_eq!(marked.find('^').unwrap() - 2, column - 1, "{shown}");
        assert!(e.line().is_some(), "{shown}");
    }
    Model::parse(&text("2*pi*f - w + n", "w", "2*pi*f")).unwrap();
    Model::parse(&text("w - sin(2*pi*f*t)*w", "n", "n + w")).unwrap();
}

#[test]
fn the_program_asks_of_a_header_a_toml_channel_and_an_option() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write("m.toml", &motor("rad/s")[0].to_toml());
    write("r.csv", "t [s],voltage [V],speed [1/min]\n0,1,0\n1,1,80\n2,1,90\n");
    write(
        "r.toml",
        "[[tables]]\nfile = \"r.csv\"\n[tables.channels]\nvoltage = { column = \"voltage\" }\n\
         speed = { column = \"speed\", unit = \"Hz\" }\n",
    );
    write(
        "c.toml",
        "[parameters]\nA = { value = 0.01, unit = \"rad^2\" }\nmu = { value = 0.1, unit = \"Hz\" }\neps = { value = 0.1, unit = \"Hz\" }\n",
    );
    write("g.toml", "[parameters]\nOmega = { value = 50, unit = \"1/min\" }\n");
    let [model, table, toml] = [place("m.toml"), place("r.csv"), place("r.toml")];
    let [compass, gimbal] = [place("c.toml"), place("g.toml")];
    for words in [
        vec!["simulate", &model, &table],
        vec!["simulate", &model, &toml],
        vec!["fit", &model, &table],
        vec!["diagnose", &model, &toml],
        vec!["roll-error", &compass],
        vec!["roll-error", "--irregular", "4deg,0.1,0.1Hz"],
        vec!["roll-error", "--band", "3Hz"],
        vec!["gimbal", &gimbal],
        vec!["strapdown", "--resonance", "30rad/s,0.1", "--angular", "x=1mrad"],
        vec!["strapdown", "--tuned-rotor", "z,100Hz,1e-5,1e-7,1e-6"],
    ] {
        let out = Command::new(env!("CARGO_BIN_EXE_gyrospec")).args(&words).output().unwrap();
        let says = String::from_utf8_lossy(&out.stderr);
        assert_eq!(out.status.code(), Some(2), "{words:?}: {says}");
        assert!(says.contains("turns or radians?") && says.contains("help: "), "{words:?}: {says}");
    }
}
