//! Two effects at once: both are named, though another law may follow one of them while the other is missing.

use crate::fields::{Plant, value};
use gyrospec::diagnose::answer::{Answer, Verdict};

/// An axis of 4 kg on a spring, with friction.
const AXIS: Plant<'_> = Plant {
    step: 0.02,
    start: &[0.0, 0.0],
    inputs: &[("force", "N")],
    states: &[("q", "m"), ("v", "m/s")],
    sizes: &[(0.0, 10.0)],
    noise: 0.005,
    measured: 1,
};
const MODEL: &str = r#"
    name = "axis"
    [inputs]
    force = { unit = "N" }
    [parameters]
    M = { value = 4.6, unit = "kg", fit = true, min = 0.1, max = 100 }
    Fv = { value = 7.5, unit = "N*s/m", fit = true, min = 0, max = 1000 }
    k = { value = 165, unit = "N/m", fit = true, min = 0, max = 100000 }
    [states]
    q = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(force - Fv*v - k*q)/M", unit = "m/s", initial = "fit" }
    [outputs]
    q_meas = { equals = "q", unit = "m" }
"#;

#[test]
fn friction_beside_a_square_damping_is_both() {
    let a = AXIS.diagnosed(MODEL, |x, u| {
        let friction = 0.5 * (x[1] / 1e-3).tanh() + 10.0 * x[1] * x[1].abs();
        vec![x[1], (u[0] - 6.0 * x[1] - 150.0 * x[0] - friction) / 4.0]
    });
    let names = names(&a);
    // the power of the damping may be left open at this noise
    assert!(matches!(a.verdict, Verdict::Named | Verdict::Tie), "{}", a.says);
    assert_eq!(names, ["dry-friction", "quadratic-damping"], "{}", a.says);
    let [low, c2, high] = value(&a, "c2");
    assert!(low < c2 && c2 < high && (c2 - 10.0).abs() < 1.0, "{low} {c2} {high}");
}

fn names(a: &Answer) -> Vec<&str> {
    let mut names: Vec<&str> = a.findings.iter().map(|f| f.code.as_str()).collect();
    names.sort_unstable();
    names
}

/// A ship and her rudder machine, which follows the order.
const SHIP: Plant<'_> = Plant {
    step: 0.5,
    start: &[0.0, 0.0],
    inputs: &[("order", "rad")],
    states: &[("r", "rad/s"), ("delta", "rad")],
    sizes: &[(0.0, 0.2)],
    noise: 0.01,
    measured: 1,
};
const NOMOTO: &str = r#"
    name = "ship"
    [inputs]
    order = { unit = "rad" }
    [parameters]
    T = { value = 11, unit = "s", fit = true, min = 1 }
    K = { value = 0.09, unit = "1/s", fit = true }
    Ts = { value = 1.3, unit = "s", fit = true, min = 0.1 }
    [states]
    r = { rate = "(K*delta - r)/T", unit = "rad/s", initial = "fit" }
    delta = { rate = "(order - delta)/Ts", unit = "rad", initial = 0 }
    [outputs]
    r_meas = { equals = "r", unit = "rad/s" }
"#;

/// Alone the order looks limited in its rate; beside the square damping it is the rudder that turns no faster.
#[test]
fn a_rudder_machine_has_a_greatest_rate_beside_a_square_damping() {
    let a = SHIP.diagnosed(NOMOTO, |x, u| {
        let rate = ((u[0] - x[1]) / 1.8).clamp(-0.04, 0.04);
        vec![(0.11 * x[1] - x[0] - 30.0 * x[0] * x[0].abs()) / 13.0, rate]
    });
    assert_eq!(names(&a), ["input-rate-limit", "quadratic-damping"], "{}", a.says);
    let limit = a.findings.iter().find(|f| f.code == "input-rate-limit").unwrap();
    assert_eq!(limit.site.name, "delta", "{}", a.says);
    assert!((limit.parameters[0].value - 0.04).abs() < 0.001, "{}", a.says);
    assert!(a.notes.iter().all(|n| !n.contains("something small")), "{:?}", a.notes);
}

/// A trolley with a load that swings: the load feels the trolley's acceleration, whatever makes it.
const CRANE: Plant<'_> = Plant {
    step: 0.05,
    start: &[0.0, 0.0, 0.0, 0.0],
    inputs: &[("drive", "N")],
    states: &[("x", "m"), ("th", "rad"), ("v", "m/s"), ("w", "rad/s")],
    sizes: &[(0.0, 150.0)],
    noise: 0.01,
    measured: 2,
};
const SWINGING: &str = r#"
    name = "crane"
    [inputs]
    drive = { unit = "N" }
    [parameters]
    M = { value = 190, unit = "kg", fit = true, min = 5 }
    m = { value = 95, unit = "kg", fit = true, min = 1 }
    b = { value = 85, unit = "N*s/m", fit = true, min = 0 }
    l = { value = 5, unit = "m", fit = true, min = 0.5 }
    d = { value = 0.015, unit = "1/s", fit = true }
    g = { value = 9.81, unit = "m/s^2" }
    [definitions]
    acc = { equals = "(drive - b*v + m*g*th)/M", unit = "m/s^2" }
    [states]
    x = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "acc", unit = "m/s", initial = 0 }
    th = { rate = "w", unit = "rad", initial = "fit" }
    w = { rate = "-g/l*th - acc/l - d*w", unit = "rad/s", initial = 0 }
    [outputs]
    x_meas = { equals = "x", unit = "m" }
    th_meas = { equals = "th", unit = "rad" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn friction_of_a_trolley_is_felt_by_its_load() {
    let a = CRANE.diagnosed(SWINGING, |x, u| {
        let friction = 40.0 * (x[2] / 1e-3).tanh();
        let acc = (u[0] - 75.0 * x[2] - friction + 85.0 * 9.81 * x[1]) / 210.0;
        vec![x[2], x[3], acc, -9.81 / 5.4 * x[1] - acc / 5.4 - 0.02 * x[3]]
    });
    assert_eq!((names(&a), a.verdict), (vec!["dry-friction"], Verdict::Named), "{}", a.says);
    let [low, force, high] = value(&a, "Fc");
    assert!(low < force && force < high && (force - 40.0).abs() < 2.0, "{low} {force} {high}");
}
