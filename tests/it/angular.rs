//! Turns or radians, by the equations: what counts an angle is asked for wherever its unit may mean turns, and what
//! counts none is not.

use crate::diagnose::noise;
use gyrospec::model::{BUILTIN, Model};
use gyrospec::record::{Channel, Constant, Recording};
use gyrospec::simulate::{Options, Simulator};
use gyrospec::units::Unit;
use gyrospec::{Error, ErrorKind};
use std::fs;
use std::path::Path;
use std::process::Command;

const QUESTION: &str = "turns or radians?";

/// A model whose parts are `name: expression or value: unit`, one a line; inputs have no expression.
fn model(inputs: &str, parameters: &str, definitions: &str, states: &str, outputs: &str) -> String {
    let mut text = String::from("name = \"made\"\n");
    for (section, key, lines) in [
        ("inputs", "", inputs),
        ("parameters", "value", parameters),
        ("definitions", "equals", definitions),
        ("states", "rate", states),
        ("outputs", "equals", outputs),
    ] {
        text += &format!("[{section}]\n");
        for line in lines.split(';').filter(|l| !l.trim().is_empty()) {
            let parts: Vec<&str> = line.split(':').map(str::trim).collect();
            let unit = format!("unit = \"{}\"", parts[parts.len() - 1]);
            let what = match key {
                "" => unit,
                "value" => format!("value = {}, {unit}", parts[1]),
                "rate" => format!("rate = \"{}\", initial = 0.5, {unit}", parts[1]),
                _ => format!("equals = \"{}\", {unit}", parts[1]),
            };
            text += &format!("{} = {{ {what} }}\n", parts[0]);
        }
    }
    text
}

/// Reads a model and simulates it on channels with these units and perhaps a constant.
fn run(text: &str, channels: &[(&str, &str)], constant: Option<(&str, &str)>) -> Result<(), Error> {
    let model = Model::parse(text)?;
    let unit = |text: &str| Unit::parse(text).unwrap();
    let time: Vec<f64> = (0..30).map(|i| 0.1 * f64::from(i)).collect();
    let made = channels.iter().map(|(name, of)| {
        Channel::new(*name, unit(of), time.clone(), time.iter().map(|t| 0.3 + t.sin()).collect::<Vec<_>>())
    });
    let mut recording = Recording::from_channels("made", made.collect()).unwrap();
    recording.constants.extend(constant.map(|(name, of)| Constant {
        name: name.into(),
        value: unit(of).to_si(1.0),
        unit: unit(of),
    }));
    Simulator::new(&model, &recording, &Options::default()).map(|_| ())
}

fn asks(of: &str, answer: &Result<(), Error>) {
    let e = answer.as_ref().expect_err(of);
    assert!(e.kind() == ErrorKind::Units && e.message().contains(QUESTION), "{of}: {e}");
    assert!(e.hint().is_some_and(|h| h.contains("radians") && h.contains("turn")), "{of}: {e}");
}

fn takes(of: &str, answer: &Result<(), Error>) {
    assert!(answer.is_ok(), "{of}: {}", answer.as_ref().unwrap_err());
}

/// A motor by its gain and its time.
fn motor(gain: &str) -> String {
    model("u: V", &format!("k: 10: {gain}; T: 0.5: s"), "", "w: (k*u - w)/T: rad/s", "speed: w: rad/s")
}

/// A motor by its torques.
fn turned(speed: &str, damping: &str, rate: &str) -> String {
    let parameters = format!("K: 0.1: N*m/A; J: 0.01: kg*m^2; b: 0.001: {damping}");
    model("i: A", &parameters, "", &format!("w: {rate}: {speed}"), &format!("speed: w: {speed}"))
}

const MOTOR: [(&str, &str); 2] = [("u", "V"), ("speed", "rpm")];
const TURNED: [(&str, &str); 2] = [("i", "A"), ("speed", "rpm")];

#[test]
fn gains_that_may_count_turns_are_asked_about() {
    for gain in ["1/min/V", "Hz/V", "1/(min*V)"] {
        asks(gain, &run(&motor(gain), &MOTOR, None));
        asks(gain, &run(&motor("rad/(s*V)"), &MOTOR, Some(("k", gain))));
        asks(gain, &run(&motor("1/(V*s)"), &MOTOR, Some(("k", gain))));
        let back = model(
            "u: V",
            &format!("kv: 100: {gain}; R: 1: ohm; J: 1: kg*m^2; kt: 1: N*m/A"),
            "i: (u - w/kv)/R: A",
            "w: kt*i/J: rad/s",
            "speed: w: rpm",
        );
        asks(gain, &run(&back, &MOTOR, None));
    }
    for gain in ["rpm/V", "rev/min/V", "rad/min/V", "deg/(V*s)", "1/s/V"] {
        takes(gain, &run(&motor(gain), &MOTOR, None));
        takes(gain, &run(&motor("rad/(s*V)"), &MOTOR, Some(("k", gain))));
    }
    let e = run(&motor("1/(min*V)"), &MOTOR, None).unwrap_err();
    assert_eq!((e.line(), e.column()), (Some(5), Some(27)), "{e}");
    assert_eq!(e.hint(), Some("for radians write rad/(min*V), for turns rev/(min*V)"));
}

#[test]
fn damping_by_the_minute_is_asked_about() {
    let (usual, down) = ("(K*i - b*w)/J", "-b*w/J + 0*K*i/J");
    for damping in ["N*m*min", "N*m/Hz", "N*m*h"] {
        for (speed, rate) in [("rad/s", usual), ("rad/s", down), ("1/s", usual), ("1/s", down)] {
            asks(damping, &run(&turned(speed, damping, rate), &TURNED, None));
            asks(damping, &run(&turned(speed, "N*m*s", rate), &TURNED, Some(("b", damping))));
        }
        asks(damping, &run(&turned("rad/s", "N*m*s/rad", usual), &TURNED, Some(("b", damping))));
    }
    for damping in ["N*m*min/rad", "N*m*min/rev", "N*m*s", "N*m/rpm"] {
        takes(damping, &run(&turned("rad/s", damping, usual), &TURNED, None));
    }
}

#[test]
fn what_is_an_angular_speed_by_its_place_is_asked_about() {
    let pendulum = model("", "g: 9.81: m/s^2; L: 1: m", "", "q: v: 1; v: -g/L*sin(q): 1/s", "speed: v: 1/s");
    let turntable = model("speed: 1/s", "", "", "q: speed: rad", "at: q: rad");
    let measured = model("u: V", "k: 1: rad/(s*V); T: 1: s", "", "w: (k*u - w)/T: rad/s", "speed: w: 1/s");
    let torques = turned("1/s", "N*m*s", "(K*i - b*w)/J");
    let others: [&[(&str, &str)]; 4] = [&[], &[("at", "rad")], &[("u", "V")], &[("i", "A")]];
    for (text, other) in [pendulum, turntable, measured, torques].iter().zip(others) {
        for (given, asked) in
            [("1/min", true), ("Hz", true), ("1/s", false), ("rpm", false), ("rad/s", false)]
        {
            let answer = run(text, &[other, &[("speed", given)]].concat(), None);
            if asked { asks(given, &answer) } else { takes(given, &answer) }
        }
    }
    for speed in ["1/min", "Hz"] {
        asks(speed, &run(&turned(speed, "N*m*s", "(K*i - b*w)/J"), &TURNED, None));
    }
}

#[test]
fn what_a_sine_or_a_law_of_speed_takes_is_asked_about() {
    let wave = |unit: &str, e: &str| {
        model("u: V", &format!("r: 2: {unit}; a: 1: V"), "", "", &format!("y: u + a*{e}: V"))
    };
    let channels = [("u", "V"), ("y", "V")];
    let stribeck = |unit: &str| {
        model(
            "M: N*m",
            &format!("ws: 1: {unit}; J: 1: kg*m^2; F: 1: N*m"),
            "",
            "w: (M - F*exp(-(w/ws)^2)*sign(w))/J: rad/s",
            "y: w: rpm",
        )
    };
    for unit in ["1/min", "Hz"] {
        for e in ["sin(r*t)", "cos(0.3 + r*t)", "sin(r*t)*exp(-t/(2/r))"] {
            asks(e, &run(&wave(unit, e), &channels, None));
            asks(e, &run(&wave("1/s", e), &channels, Some(("r", unit))));
        }
        for e in ["sin(2*pi*r*t)", "cos(6.2832*r*t)", "exp(-r*t)", "exp(-r*t)*sin(t*pi*r)"] {
            takes(e, &run(&wave(unit, e), &channels, None));
        }
        let turned = |e: &str| {
            model("u: 1", &format!("r: 2: {unit}; lat: 0.8: rad"), "", &format!("q: {e}: rad"), "y: q: deg")
        };
        for e in ["r*cos(lat)", "r*sin(lat)", "r*sin(pi*r*t)"] {
            asks(e, &run(&turned(e), &[("u", "1"), ("y", "deg")], None));
        }
        asks(unit, &run(&stribeck(unit), &[("M", "N*m"), ("y", "rpm")], None));
    }
    takes("rpm", &run(&stribeck("rpm"), &[("M", "N*m"), ("y", "rpm")], None));
}

#[test]
fn rate_constants_and_counts_go_on_without_a_question() {
    for k in ["1/min", "Hz", "1/h", "1/d"] {
        for (inputs, parameters, states, output, unit) in [
            ("u: V", "", "x: k*(u - x): V", "x", "V"),
            ("u: rad/s", "", "w: k*(u - w): rad/s", "w", "rpm"),
            (
                "u: 1",
                "g: 9.81: m/s^2; L: 1: m",
                "q: v: rad; v: u*0/t^2 - k*v - g/L*sin(q): rad/s",
                "v",
                "rpm",
            ),
            ("u: 1", "g: 9.81: m/s^2; L: 1: m", "q: v: 1; v: -k*v - g/L*sin(q): 1/s", "v", "1/s"),
            ("u: N", "m: 1: kg", "x: v: m; v: u/m - k*v - k^2*x: m/s", "x", "m"),
            ("u: rad", "", "q: k*sin(u - q): rad", "q", "deg"),
            ("u: K", "E: 1000: K", "c: -k*exp(-E/u)*c: 1", "c", "1"),
            ("u: 1/s", "", "n: u - k*n: 1", "k*n", "1/s"),
            ("u: 1", "", "f: k*u/t: Hz; d: 2*pi*(f - k): rad", "f", "Hz"),
            ("u: N*m", "J: 1: kg*m^2", "w: u/J - k*w: rad/s", "w/(2*pi)", "Hz"),
        ] {
            let text = model(
                inputs,
                &format!("k: 1: {k}; {parameters}"),
                "",
                states,
                &format!("y: {output}: {unit}"),
            );
            let read = Model::parse(&text);
            assert!(read.is_ok(), "{k} in {states}: {}", read.unwrap_err());
        }
        let count = model("u: 1/s", "", "", "n: u: 1", "y: n: 1");
        takes(k, &run(&count, &[("u", k), ("y", "1")], None));
    }
}

#[test]
fn flows_and_speeds_along_a_line_are_no_angles() {
    for (flow, volume) in
        [("l/min", "l"), ("m^3/h", "cm^3"), ("kg/min", "kg"), ("m/min", "m"), ("K/min", "K")]
    {
        let pump = model("w: rad/s", &format!("D: 1: {volume}"), "", "", &format!("q: D*w: {flow}"));
        takes(flow, &run(&pump, &[("w", "rpm"), ("q", flow)], None));
        let hydraulic =
            model(&format!("q: {flow}"), &format!("D: 1: {volume}"), "", "at: q/D: rad", "y: at: deg");
        takes(flow, &run(&hydraulic, &[("q", flow), ("y", "deg")], None));
    }
    let times = model("w: rad/s", "T: 1: min; a: 2: rad", "", "q: (a - q)/T: rad", "y: w*T + q: rad");
    takes("T", &run(&times, &[("w", "rpm"), ("y", "rad")], None));
    let belt = model(
        "M: N*m",
        "c: 1: N*min/m; r: 0.1: m; J: 1: kg*m^2",
        "v: r*w: m/min",
        "w: (M - c*v*r)/J: rad/s",
        "y: v: m/min",
    );
    takes("belt", &run(&belt, &[("M", "N*m"), ("y", "m/min")], None));
}

#[test]
fn turns_for_turns_are_converted() {
    let text = model("u: V", "k: 1: rev/(V*s); T: 1: s", "", "w: (k*u - w)/T: rev/s", "speed: w: rev/s");
    takes("rpm", &run(&text, &MOTOR, None));
    let [rpm, turns] = ["rpm", "rev/s"].map(|u| Unit::parse(u).unwrap());
    // 60 turns a minute are one a second
    assert!((turns.from_si(rpm.to_si(60.0)) - 1.0).abs() < 1e-14);
    asks("rad/s", &run(&text, &[("u", "V"), ("speed", "rad/s")], None));
}

/// What a diagnosis adds beside a rate constant by the minute is written so that it reads.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_a_diagnosis_adds_is_not_asked_about() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    let noise = noise(1500, 5);
    let (mut w, mut rows) = (0.0_f64, String::from("t [s],u [rad/s^2],speed [rpm]\n"));
    let acts = |t: f64| 3.0 * (0.7 * t).sin() + 2.0 * (0.23 * t).sin();
    for (i, n) in noise.iter().enumerate() {
        let t = 0.05 * i as f64;
        // rad/s in rpm: 30/π
        rows += &format!("{t:.2},{:.5},{:.4}\n", acts(t), (w + 0.02 * n) * 30.0 / std::f64::consts::PI);
        for k in 0..20 {
            let u = acts(t + 0.0025 * (f64::from(k) + 0.5));
            w += 0.0025 * (2.0 * u - 0.5 * w - 0.8 * (40.0 * w).tanh());
        }
    }
    fs::write(place("r.csv"), rows).unwrap();
    let text = model("u: rad/s^2", "k: 30: 1/min; g: 2: 1", "", "w: -k*w + g*u: 1/s", "speed: w: rpm");
    fs::write(place("m.toml"), text.replace("unit = \"1/min\"", "fit = true, unit = \"1/min\"")).unwrap();
    let call = |words: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_gyrospec")).args(words).current_dir(folder.path()).output().unwrap()
    };
    let said = call(&["diagnose", "m.toml", "r.csv", "--model-out", "found.toml"]);
    let words = String::from_utf8_lossy(&said.stdout).into_owned() + &String::from_utf8_lossy(&said.stderr);
    assert!(said.status.code() == Some(1) && words.contains("dry friction"), "{words}");
    let found = Model::read(place("found.toml")).unwrap();
    assert!(found.parameters.len() > 2);
    assert!(call(&["simulate", "found.toml", "r.csv", "--out", "y.csv"]).status.success());
}

#[test]
fn every_model_of_the_project_still_reads() {
    for (name, text) in BUILTIN {
        assert!(Model::parse(text).is_ok(), "{name}");
    }
    for folder in ["examples", "tests/models"] {
        for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|e| e == "toml") {
                let read = Model::read(&path);
                assert!(read.is_ok(), "{}: {}", path.display(), read.unwrap_err());
            }
        }
    }
}
