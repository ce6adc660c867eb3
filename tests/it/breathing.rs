//! Laws of living things: a windpipe that resists with the flow through it, a membrane that opens from a voltage on.

use crate::actuators::{noisy, recording};
use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::units::Unit;

/// A value with its unit, in SI.
fn value(told: &Answer, name: &str) -> f64 {
    let all = &told.findings[0].parameters;
    let p = all.iter().find(|p| p.name == name).unwrap_or_else(|| panic!("{name}: {}", told.says));
    Unit::parse(&p.unit).unwrap().to_si(p.value)
}

/// Rohrer's law, p = K1 q + K2 q |q| (F. Rohrer, Pflügers Archiv 162 (1915) 225).
#[test]
fn a_windpipe_resists_with_the_size_of_the_flow() {
    let time: Vec<f64> = (0..3000).map(|i| 0.02 * f64::from(i)).collect();
    let breath = |t: f64| 0.4 * (1.6 * t).sin() + 0.16 * (3.5 * t + 0.7).sin() + 0.05 * (0.33 * t).cos();
    let filled = |t: f64| {
        0.4 / 1.6 * (1.0 - (1.6 * t).cos())
            + 0.16 / 3.5 * (0.7f64.cos() - (3.5 * t + 0.7).cos())
            + 0.05 / 0.33 * (0.33 * t).sin()
    };
    let flow: Vec<f64> = time.iter().map(|t| breath(*t)).collect();
    let resisted = |t: f64| 0.25 * breath(t) + 0.3 * breath(t) * breath(t).abs();
    let pressure: Vec<f64> = time.iter().map(|t| resisted(*t) + 2.0 * filled(*t) + 0.5).collect();
    let model = "name = \"lung\"\n[inputs]\nq = { unit = \"L/s\" }\n[parameters]\n\
         R = { value = 0.4, unit = \"kPa*s/L\", fit = true }\nE = { value = 2.2, unit = \"kPa/L\", fit = true }\n\
         P0 = { value = 0.5, unit = \"kPa\", fit = true }\n\
         [states]\nV = { rate = \"q\", unit = \"L\", initial = 0.0 }\n\
         [outputs]\np = { equals = \"R*q + E*V + P0\", unit = \"kPa\" }\n";
    let made = recording(&time, &[("q", "L/s", flow), ("p", "kPa", noisy(&pressure, 0.004, 5))]);
    let told = diagnosed(&Model::parse(model).unwrap(), made).answer;
    let first = &told.findings[0];
    assert_eq!((told.verdict, told.findings.len()), (Verdict::Named, 1), "{}", told.says);
    assert_eq!(
        (first.code.as_str(), first.site.name.as_str()),
        ("parameter-dependence", "R"),
        "{}",
        told.says
    );
    // K2/K1 for a cubic metre a second
    let ratio = value(&told, "a");
    assert!((ratio / 1200.0 - 1.0).abs() < 0.15, "{ratio}: {}", told.says);
}

/// Levels below 0 are levels as well.
#[test]
fn a_membrane_opens_from_a_voltage_on() {
    let time: Vec<f64> = (0..4000).map(|i| 2e-4 * f64::from(i)).collect();
    let current = |t: f64| 0.12 * (0.5 + 0.5 * (31.0 * t).sin() + 0.4 * (83.0 * t).sin());
    let mut voltage: f64 = -70.0;
    let mut course = Vec::new();
    for t in &time {
        course.push(voltage);
        for k in 0..20 {
            let now = t + 1e-5 * f64::from(k);
            // mV, nS, pA and pF: C V' = gL (EL - V) + I - g (V - Vt) above Vt
            let open = 8.0 * (voltage + 60.0).max(0.0);
            voltage += 1e-5 * 1e3 / 100.0 * (6.0 * (-70.0 - voltage) + 1e3 * current(now) - open);
        }
    }
    let fed = time.iter().map(|t| current(*t)).collect();
    let model = "name = \"membrane\"\n[inputs]\nI = { unit = \"nA\" }\n[parameters]\n\
         C = { value = 100, unit = \"pF\" }\ngL = { value = 9, unit = \"nS\", fit = true }\n\
         EL = { value = -68, unit = \"mV\", fit = true }\n\
         [states]\nv = { rate = \"(gL*(EL - v) + I)/C\", unit = \"mV\", initial = \"fit\" }\n\
         [outputs]\nvm = { equals = \"v\", unit = \"mV\" }\n";
    let made = recording(&time, &[("I", "nA", fed), ("vm", "mV", noisy(&course, 0.3, 7))]);
    let told = diagnosed(&Model::parse(model).unwrap(), made).answer;
    let first = &told.findings[0];
    assert_eq!((told.verdict, told.findings.len()), (Verdict::Named, 1), "{}", told.says);
    assert_eq!((first.code.as_str(), first.site.name.as_str()), ("overflow", "v"), "{}", told.says);
    let (edge, opens) = (value(&told, "so"), value(&told, "ko"));
    assert!(
        (edge + 0.060).abs() < 3e-4 && (opens / 8e-9 - 1.0).abs() < 0.05,
        "{edge}, {opens}: {}",
        told.says
    );
}
