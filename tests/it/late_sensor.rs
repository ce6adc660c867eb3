//! A sensor that is late where more than one thing acts: its delay is none of an input, and none from a moment on.

use crate::diagnose::diagnosed;
use crate::fields::Plant;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};

const CARRIAGE: Plant<'_> = Plant {
    step: 0.02,
    start: &[0.0, 0.0],
    inputs: &[("force", "N"), ("draught", "m/s")],
    states: &[("z", "m"), ("v", "m/s")],
    sizes: &[(0.0, 4.0), (0.0, 2.0)],
    noise: 0.02,
    measured: 1,
};
const MODEL: &str = r#"
    name = "carriage"
    [inputs]
    force = { unit = "N" }
    [parameters]
    m = { value = 0.8, unit = "kg", fit = true, min = 0.1, max = 10 }
    d = { value = 1.5, unit = "N*s/m", fit = true, min = 0, max = 100 }
    k = { value = 15, unit = "N/m", fit = true, min = 0, max = 1000 }
    [states]
    z = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(force - d*v - k*z)/m", unit = "m/s", initial = "fit" }
    [outputs]
    z_meas = { equals = "z", unit = "m" }
"#;
/// Samples by which the sensor is late.
const LATE: usize = 3;

/// A recording whose sensor is late.
fn late(made: &Recording, step: f64) -> Recording {
    let rows = made.find("z_meas").unwrap().values.len() - LATE;
    let time: Vec<f64> = (0..rows).map(|i| step * i as f64).collect();
    let shifted = made.channels.iter().map(|c| {
        let first = if c.name == "z_meas" { 0 } else { LATE };
        Channel::new(&c.name, c.unit.clone(), time.clone(), c.values[first..first + rows].to_vec())
    });
    Recording::from_channels("late", shifted.collect()).unwrap()
}

#[test]
fn a_late_sensor_is_told_beside_a_draught_that_acts() {
    let made = CARRIAGE.recorded(|x, u| vec![x[1], u[0] - 2.0 * x[1] - 20.0 * x[0] + 0.8 * u[1]]);
    let told = diagnosed(&Model::parse(MODEL).unwrap(), late(&made, 0.02)).answer;
    assert_eq!(told.verdict, Verdict::Named, "{}", told.says);
    let mut codes: Vec<&str> = told.findings.iter().map(|f| f.code.as_str()).collect();
    codes.sort_unstable();
    assert_eq!(codes, ["cross-coupling", "output-delay"], "{}", told.says);
    // in proportion to it: its square follows as well while the delay is missing
    let draught = told.findings.iter().flat_map(|f| &f.parameters).find(|v| v.name == "c").unwrap();
    assert!(draught.unit == "N*s/m" && (draught.value - 0.8).abs() < 0.01, "{draught:?} {}", told.says);
    let delay = told.findings.iter().flat_map(|f| &f.parameters).find(|v| v.name == "Td").unwrap();
    let truth = 0.02 * LATE as f64;
    assert!(delay.low < truth && truth < delay.high && delay.high - delay.low < 0.02, "{delay:?}");
}

/// A magnet that floats above another: its force has no value at a gap of zero.
const FLOATING: Plant<'_> = Plant {
    step: 0.002,
    start: &[0.015, 0.0],
    inputs: &[("coil", "A")],
    states: &[("z", "m"), ("v", "m/s")],
    sizes: &[(0.0, 0.3)],
    noise: 0.01,
    measured: 1,
};

#[test]
fn a_late_sensor_is_told_of_a_state_that_must_not_begin_at_zero() {
    let made = FLOATING.recorded(|x, u| {
        let lift = 8.277e-6 / x[0].powi(3);
        vec![x[1], (lift + 0.4 * u[0] - 2.2 * x[1]) / 0.25 - 9.81]
    });
    let model = r#"
        name = "levitation"
        [inputs]
        coil = { unit = "A" }
        [parameters]
        C = { value = 1e-5, unit = "N*m^3", fit = true, min = 1e-6, max = 1e-4 }
        ki = { value = 0.3, unit = "N/A", fit = true }
        d = { value = 3.0, unit = "N*s/m", fit = true, min = 0.1, max = 50 }
        m = { value = 0.25, unit = "kg" }
        g = { value = 9.81, unit = "m/s^2" }
        [states]
        z = { rate = "v", unit = "m", initial = "fit" }
        v = { rate = "(C/z^3 + ki*coil - d*v)/m - g", unit = "m/s", initial = "fit" }
        [outputs]
        z_meas = { equals = "z", unit = "m" }
    "#;
    let told = diagnosed(&Model::parse(model).unwrap(), late(&made, 0.002)).answer;
    let [found] = &told.findings[..] else { panic!("{}", told.says) };
    // with one input and one output both delays are one
    let codes: Vec<&str> = std::iter::once(&found.code).chain(&found.ties).map(String::as_str).collect();
    assert!(codes.contains(&"output-delay"), "{codes:?} {}", told.says);
    let delay = &found.parameters[0];
    let truth = 0.002 * LATE as f64;
    assert!((delay.value - truth).abs() < 1e-4 && delay.high - delay.low < 1e-4, "{delay:?}");
}
