//! Laws of one size that hold all together, forgotten: a spring, a loss of heat to a room that nobody recorded.

use crate::fields::{Plant, first, value};
use gyrospec::diagnose::answer::Verdict;

const CARRIAGE: Plant<'_> = Plant {
    step: 0.05,
    start: &[0.0, 0.0],
    inputs: &[("force", "N")],
    states: &[("q", "m"), ("v", "m/s")],
    sizes: &[(0.0, 200.0)],
    noise: 0.001,
    measured: 1,
};
const CARRIAGE_MODEL: &str = r#"
    name = "carriage"
    [inputs]
    force = { unit = "N" }
    [parameters]
    M = { value = 80, unit = "kg", fit = true, min = 1, max = 1000 }
    d = { value = 150, unit = "N*s/m", fit = true, min = 0, max = 1e4 }
    [states]
    q = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(force - d*v)/M", unit = "m/s", initial = "fit" }
    [outputs]
    q_meas = { equals = "q", unit = "m" }
"#;

/// Without its spring the fit of the model ends far from all that is true, a thousand times the noise away.
#[test]
fn a_cable_pulls_a_carriage_back() {
    let of = |k: f64, cubic: f64| {
        CARRIAGE.diagnosed(CARRIAGE_MODEL, |x, u| {
            vec![x[1], (u[0] - 200.0 * x[1] - k * x[0] - cubic * x[0].powi(3)) / 90.0]
        })
    };
    let held = of(60.0, 0.0);
    assert_eq!((held.verdict, first(&held)), (Verdict::Named, "linear-stiffness"), "{}", held.says);
    assert_eq!(held.findings.len(), 1, "{}", held.says);
    let [low, _, high] = value(&held, "k1");
    assert!(low < 60.0 && 60.0 < high && high - low < 0.6, "{low} to {high}");
    let hardening = of(0.0, 60.0);
    assert_eq!(
        (hardening.verdict, first(&hardening)),
        (Verdict::Named, "cubic-stiffness"),
        "{}",
        hardening.says
    );
    assert_eq!(of(0.0, 0.0).verdict, Verdict::NothingMissing);
}

/// A spring that the model has, of another stiffness, is a value and no further spring.
#[test]
fn a_spring_of_another_stiffness_is_a_value() {
    let model = CARRIAGE_MODEL
        .replace("force - d*v", "force - d*v - k*q")
        .replace("[states]", "k = { value = 45, unit = \"N/m\" }\n    [states]");
    let other = CARRIAGE.diagnosed(&model, |x, u| vec![x[1], (u[0] - 200.0 * x[1] - 60.0 * x[0]) / 90.0]);
    // with mass and damping free, a sensor's scale is the same equation
    let names = [&[other.findings[0].code.clone()][..], &other.findings[0].ties].concat();
    assert!(matches!(other.verdict, Verdict::Named | Verdict::Tie), "{}", other.says);
    assert!(names.iter().any(|n| n == "parameter-value"), "{}", other.says);
    assert!(!names.iter().any(|n| n == "linear-stiffness"), "{}", other.says);
}

const VESSEL: Plant<'_> = Plant {
    step: 20.0,
    start: &[320.0],
    inputs: &[("jacket", "K"), ("steam", "W")],
    states: &[("T", "K")],
    sizes: &[(330.0, 15.0), (2000.0, 1500.0)],
    noise: 0.01,
    measured: 1,
};
const VESSEL_MODEL: &str = r#"
    name = "vessel"
    [inputs]
    jacket = { unit = "degC" }
    steam = { unit = "W" }
    [parameters]
    C = { value = 200, unit = "kJ/K" }
    UA = { value = 400, unit = "W/K", fit = true, min = 0 }
    [states]
    T = { rate = "(UA*(jacket - T) + steam)/C", unit = "degC", initial = "fit" }
    [outputs]
    T_meas = { equals = "T", unit = "degC" }
"#;

#[test]
fn a_vessel_cools_to_a_room_that_nobody_recorded() {
    let of = |loss: f64| {
        VESSEL.diagnosed(VESSEL_MODEL, |x, u| {
            vec![(450.0 * (u[0] - x[0]) + u[1] - loss * (x[0] - 291.0)) / 200e3]
        })
    };
    let cooled = of(60.0);
    assert_eq!((cooled.verdict, first(&cooled)), (Verdict::Named, "linear-damping"), "{}", cooled.says);
    let [low, _, high] = value(&cooled, "Ta");
    assert!(low < 291.0 && 291.0 < high && high - low < 6.0, "{low} to {high}: {}", cooled.says);
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

/// A temperature makes no flow with its root and never comes near the zero of a dead zone: both had been named for an offset.
#[test]
fn a_thermometer_that_reads_low_has_an_offset() {
    let found = VESSEL.diagnosed(VESSEL_MODEL, |x, u| {
        let warm = x[0] + 0.8;
        vec![(450.0 * (u[0] - warm) + u[1]) / 200e3]
    });
    assert!(matches!(found.verdict, Verdict::Named | Verdict::Tie), "{}", found.says);
    let names = [&[found.findings[0].code.clone()][..], &found.findings[0].ties].concat();
    let is_none = |n: &String| ["square-root-flow", "dead-zone", "input-dead-zone"].contains(&n.as_str());
    assert!(!names.iter().any(is_none) && names.iter().any(|n| n == "output-offset"), "{}", found.says);
}

const CULTURE: Plant<'_> = Plant {
    step: 360.0,
    start: &[2.0],
    inputs: &[("food", "1"), ("dilution", "1/s")],
    states: &[("X", "kg/m^3")],
    sizes: &[(1.0, 0.5), (8e-5, 5e-5)],
    noise: 0.003,
    measured: 1,
};
const CULTURE_MODEL: &str = r#"
    name = "culture"
    [inputs]
    food = { unit = "1" }
    dilution = { unit = "1/s" }
    [parameters]
    growth = { value = 0.25, unit = "1/h", fit = true, min = 0 }
    [states]
    X = { rate = "(growth*food - dilution)*X", unit = "kg/m^3", initial = "fit" }
    [outputs]
    X_meas = { equals = "X", unit = "kg/m^3" }
"#;

/// Where a balance grows in proportion to itself, what is lost of it in proportion is no constant force.
#[test]
fn a_culture_dies_beside_its_growth() {
    let of =
        |death: f64| CULTURE.diagnosed(CULTURE_MODEL, |x, u| vec![(8.4e-5 * u[0] - u[1] - death) * x[0]]);
    let dying = of(4e-6);
    // as a constant in the bracket, or as a dilution that is off, it is the same equation
    let mut names = [&[first(&dying).to_string()][..], &dying.findings[0].ties].concat();
    names.sort();
    assert_eq!(names, ["constant-force", "input-offset", "linear-damping"], "{}", dying.says);
    assert_eq!((dying.verdict, dying.findings.len()), (Verdict::Tie, 1), "{}", dying.says);
    let size = dying.findings[0].parameters[0].value.abs();
    let death = if dying.findings[0].code == "input-offset" { 4e-6 } else { 4e-6 * 3600.0 };
    assert!((size - death).abs() < 0.02 * death, "{size}");
    assert_eq!(of(0.0).verdict, Verdict::NothingMissing);
}

/// A buffer tank, and the clock by which it springs a leak.
const BUFFER: Plant<'_> = Plant {
    step: 2.0,
    start: &[0.8, 0.0],
    inputs: &[("feed", "m^3/s")],
    states: &[("h", "m"), ("clock", "s")],
    sizes: &[(0.004, 0.002)],
    noise: 0.004,
    measured: 1,
};
const BUFFER_MODEL: &str = r#"
    name = "buffer tank"
    [inputs]
    feed = { unit = "m^3/s" }
    [parameters]
    A = { value = 1.5, unit = "m^2", fit = true, min = 0.1, max = 10 }
    k = { value = 0.004, unit = "m^2/s", fit = true, min = 0, max = 0.1 }
    [states]
    h = { rate = "(feed - k*h)/A", unit = "m", initial = "fit" }
    [outputs]
    h_meas = { equals = "h", unit = "m" }
"#;

/// A constant loss from a moment on is neither a jump of the outlet's size nor a drift.
#[test]
fn a_tank_springs_a_leak() {
    let of = |leak: f64, wider: f64| {
        BUFFER.diagnosed(BUFFER_MODEL, |x, u| {
            let is_late = x[1] > 1500.0;
            let (lost, size) = if is_late { (leak, 0.005 * wider) } else { (0.0, 0.005) };
            vec![(u[0] - size * x[0] - lost) / 1.8, 1.0]
        })
    };
    let leaking = of(0.0012, 1.0);
    assert_eq!((leaking.verdict, first(&leaking)), (Verdict::Named, "constant-force"), "{}", leaking.says);
    assert_eq!(leaking.findings.len(), 1, "{}", leaking.says);
    let [low, size, high] = value(&leaking, "F0");
    assert!(low < -0.0012 && -0.0012 < high && (size + 0.0012).abs() < 6e-5, "{low} {size} {high}");
    let [low, _, high] = value(&leaking, "tc");
    assert!(low < 1500.0 && 1500.0 < high && high - low < 60.0, "{low} to {high}");
    let widened = of(0.0, 1.5);
    assert_eq!((widened.verdict, first(&widened)), (Verdict::Named, "parameter-change"), "{}", widened.says);
    assert_eq!(of(0.0, 1.0).verdict, Verdict::NothingMissing);
}

const COLLECTOR: Plant<'_> = Plant {
    step: 20.0,
    start: &[320.0],
    inputs: &[("G", "W/m^2"), ("air", "K")],
    states: &[("T", "K")],
    sizes: &[(520.0, 330.0), (285.0, 8.0)],
    noise: 0.01,
    measured: 1,
};
const COLLECTOR_MODEL: &str = r#"
    name = "solar collector"
    [inputs]
    G = { unit = "W/m^2" }
    air = { unit = "K" }
    [parameters]
    C = { value = 6800, unit = "J/K/m^2", fit = true, min = 1 }
    eta = { value = 0.7, unit = "1", fit = true, min = 0 }
    a1 = { value = 3, unit = "W/m^2/K", fit = true, min = 0 }
    [states]
    T = { rate = "(eta*G - a1*(T - air))/C", unit = "K", initial = "fit" }
    [outputs]
    T_meas = { equals = "T", unit = "K" }
"#;

/// The efficiency of a collector as it is measured, ISO 9806: a loss that grows with the square of the difference.
#[test]
fn a_collector_loses_more_the_hotter_it_is() {
    let a = COLLECTOR.diagnosed(COLLECTOR_MODEL, |x, u| {
        let over = x[0] - u[1];
        vec![(0.78 * u[0] - 3.5 * over - 0.03 * over * over.abs()) / 6000.0]
    });
    assert_eq!(a.findings.len(), 1, "{}", a.says);
    let f = &a.findings[0];
    let alike = ["parameter-dependence", "power-law"];
    assert!(alike.contains(&f.code.as_str()) && f.ties.iter().all(|t| alike.contains(&&**t)), "{}", a.says);
}

const ARM: Plant<'_> = Plant {
    step: 0.01,
    start: &[0.0, 0.0],
    inputs: &[("torque", "N*m")],
    states: &[("q", "rad"), ("w", "rad/s")],
    sizes: &[(0.0, 7.0)],
    noise: 0.002,
    measured: 1,
};
const ARM_MODEL: &str = r#"
    name = "arm with a counterbalance"
    [inputs]
    torque = { unit = "N*m" }
    [parameters]
    J = { value = 0.3, unit = "kg*m^2", fit = true, min = 0.01 }
    B = { value = 1.1, unit = "N*m*s", fit = true, min = 0 }
    K = { value = 8, unit = "N*m", fit = true, min = 0 }
    [states]
    q = { rate = "w", unit = "rad", initial = "fit" }
    w = { rate = "(torque - B*w - K*q)/J", unit = "rad/s", initial = "fit" }
    [outputs]
    q_meas = { equals = "q", unit = "rad" }
"#;

/// Its spring holds it level, wherever its weight is: had been a weight below the axis and a spring of another power.
#[test]
fn a_weight_that_is_balanced_at_rest() {
    let found = ARM.diagnosed(ARM_MODEL, |x, u| {
        let weight = 2.2 * ((x[0] + 0.6).sin() - 0.6f64.sin());
        vec![x[1], (u[0] - 0.9 * x[1] - 6.0 * x[0] - weight) / 0.32]
    });
    assert_eq!((found.verdict, first(&found)), (Verdict::Named, "gravity-pendulum"), "{}", found.says);
    assert_eq!(found.findings.len(), 1, "{}", found.says);
    let [low, _, high] = value(&found, "Gc");
    assert!(low < 2.2 * 0.6f64.sin() && 2.2 * 0.6f64.sin() < high, "{low} to {high}");
}
