//! What acts as strongly as the input leads a fit without it far astray; it is found from the values as given.

use crate::fields::{Plant, first, value};
use gyrospec::diagnose::answer::Verdict;

const SHIP: Plant<'_> = Plant {
    step: 0.2,
    start: &[0.0, 0.0],
    inputs: &[("rudder", "rad"), ("wind", "m/s")],
    states: &[("psi", "rad"), ("r", "rad/s")],
    sizes: &[(0.07, 0.25), (2.0, 4.0)],
    noise: 0.002,
    measured: 1,
};
const MODEL: &str = r#"
    name = "ship"
    [inputs]
    rudder = { unit = "rad" }
    [parameters]
    K = { value = 0.2, unit = "1/s", fit = true }
    T = { value = 4, unit = "s", fit = true, min = 0.1 }
    [states]
    psi = { rate = "r", unit = "rad", initial = "fit" }
    r = { rate = "(K*rudder - r)/T", unit = "rad/s", initial = "fit" }
    [outputs]
    psi_meas = { equals = "psi", unit = "rad" }
"#;

#[test]
fn a_wind_that_outweighs_the_rudder_is_found_though_the_fit_without_it_runs_away() {
    let told = SHIP.diagnosed(MODEL, |x, u| vec![x[1], (0.25 * u[0] + 0.06 * u[1] - x[1]) / 5.0]);
    let fitted = |name: &str| told.parameters.iter().find(|p| p.name == name).unwrap();
    // it may run to anywhere, but not to where it was
    assert!(fitted("T").before > 100.0, "{:?}", fitted("T"));
    assert_eq!((told.verdict, first(&told)), (Verdict::Named, "cross-coupling"), "{}", told.says);
    let [low, c, high] = value(&told, "c");
    assert!(low < 0.06 && 0.06 < high && (c - 0.06).abs() < 5e-4, "{low} {c} {high}");
    assert!((fitted("T").after - 5.0).abs() < 0.1 && (fitted("K").after - 0.25).abs() < 0.01);
}
