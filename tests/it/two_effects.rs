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
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
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
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
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

/// A drug in the blood and in the tissue behind it, and what a slow sensor shows of the former.
const DRUG: Plant<'_> = Plant {
    step: 120.0,
    start: &[0.0, 0.0, 0.0],
    inputs: &[("infusion", "kg/s")],
    states: &[("seen", "kg/m^3"), ("c1", "kg/m^3"), ("c2", "kg/m^3")],
    sizes: &[(2.4e-8, 1.2e-8)],
    noise: 0.004,
    measured: 1,
};
const DRUG_MODEL: &str = r#"
    name = "two compartments"
    [inputs]
    infusion = { unit = "kg/s" }
    [parameters]
    V = { value = 10.4, unit = "l", fit = true, min = 1 }
    ke = { value = 0.48, unit = "1/h", fit = true, min = 0 }
    k12 = { value = 0.66, unit = "1/h", fit = true, min = 0 }
    k21 = { value = 0.41, unit = "1/h", fit = true, min = 0 }
    [states]
    c1 = { rate = "infusion/V - ke*c1 - k12*c1 + k21*c2", unit = "kg/m^3", initial = 0 }
    c2 = { rate = "k12*c1 - k21*c2", unit = "kg/m^3", initial = 0 }
    [outputs]
    seen_meas = { equals = "c1", unit = "kg/m^3" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_slow_sensor_beside_a_rate_that_saturates_is_no_inertia() {
    let a = DRUG.diagnosed(DRUG_MODEL, |x, u| {
        let hour = 1.0 / 3600.0;
        let (leaves, back) = (0.45 * hour * x[1] / (1.0 + 50.0 * x[1]), 0.35 * hour * x[2]);
        let over = 0.6 * hour * x[1];
        vec![(x[1] - x[0]) / 1200.0, u[0] / 0.012 - leaves - over + back, over - back]
    });
    assert_eq!(names(&a), ["output-lag", "saturable-rate"], "{}", a.says);
    let of = |code: &str, name: &str| {
        let f = a.findings.iter().find(|f| f.code == code).unwrap();
        let v = f.parameters.iter().find(|v| v.name == name).unwrap();
        (v.low, v.high)
    };
    let (low, high) = of("output-lag", "Tl");
    assert!(low < 1200.0 && 1200.0 < high, "{low} to {high}");
    let (low, high) = of("saturable-rate", "a");
    assert!(low < 50.0 && 50.0 < high, "{low} to {high}");
}

/// A crane's trolley, whose acceleration moves the load that hangs from it; no position is in the model.
const TROLLEY: Plant<'_> = Plant {
    step: 0.06,
    start: &[0.0, 0.0, 0.0],
    inputs: &[("force", "N")],
    states: &[("v", "m/s"), ("th", "rad"), ("w", "rad/s")],
    sizes: &[(0.0, 180.0)],
    noise: 0.02,
    measured: 2,
};
const TROLLEY_MODEL: &str = r#"
    name = "crane"
    [inputs]
    force = { unit = "N" }
    [parameters]
    Mt = { value = 410, unit = "kg", fit = true, min = 1 }
    ml = { value = 180, unit = "kg", fit = true, min = 1 }
    L = { value = 4.2, unit = "m", fit = true, min = 0.1 }
    b = { value = 150, unit = "N*s/m", fit = true, min = 0 }
    d = { value = 0.07, unit = "1/s", fit = true, min = 0 }
    gr = { value = 9.81, unit = "m/s^2" }
    [definitions]
    acc = { equals = "(force + ml*gr*th - b*v)/Mt", unit = "m/s^2" }
    [states]
    v = { rate = "acc", unit = "m/s", initial = "fit" }
    th = { rate = "w", unit = "rad", initial = "fit" }
    w = { rate = "-gr/L*th - acc/L - d*w", unit = "rad/s", initial = "fit" }
    [outputs]
    v_meas = { equals = "v", unit = "m/s" }
    th_meas = { equals = "th", unit = "rad" }
"#;

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn friction_of_a_trolley_is_felt_by_what_hangs_from_it() {
    let a = TROLLEY.diagnosed(TROLLEY_MODEL, |x, u| {
        let acc = (u[0] + 200.0 * 9.81 * x[1] - 180.0 * x[0] - 35.0 * (x[0] / 0.005).tanh()) / 450.0;
        vec![acc, x[2], -9.81 / 4.0 * x[1] - acc / 4.0 - 0.08 * x[2]]
    });
    assert_eq!((a.verdict, names(&a)), (Verdict::Named, vec!["dry-friction"]), "{}", a.says);
    let [low, force, high] = value(&a, "Fc");
    assert!(low < force && force < high && (force - 35.0).abs() < 1.5, "{low} {force} {high}");
    assert_eq!(a.findings[0].parameters[0].unit, "N");
}
