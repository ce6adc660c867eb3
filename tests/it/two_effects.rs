//! Two effects at once: both are named, though another law may follow one of them while the other is missing.

use crate::fields::{Plant, value};
use gyrospec::diagnose::answer::Verdict;

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
    let mut names: Vec<&str> = a.findings.iter().map(|f| f.code.as_str()).collect();
    names.sort_unstable();
    // the power of the damping may be left open at this noise
    assert!(matches!(a.verdict, Verdict::Named | Verdict::Tie), "{}", a.says);
    assert_eq!(names, ["dry-friction", "quadratic-damping"], "{}", a.says);
    let [low, c2, high] = value(&a, "c2");
    assert!(low < c2 && c2 < high && (c2 - 10.0).abs() < 1.0, "{low} {c2} {high}");
}
