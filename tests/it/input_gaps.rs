//! What a gap of an input leaves in a model that remembers it.

use crate::held_inputs::AXIS;
use gyrospec::estimate::{Fit, FitOptions, fit};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use num_complex::Complex64;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const STEP: f64 = 0.01;
const COUNT: usize = 2000;
/// N at rad/s.
const FORCE: [(f64, f64); 2] = [(30.0, 1.3), (20.0, 4.1)];

/// A recording of both, in which the input is missing for a second.
fn with_gap(gap: f64, units: [&str; 2], names: [&str; 2], output: impl Fn(f64) -> f64) -> Recording {
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let known = |t: f64| if (gap..gap + 1.0).contains(&t) { f64::NAN } else { force(t) };
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut noise = || -> f64 { 1e-3 * Distribution::<f64>::sample(&StandardNormal, &mut rng) };
    let measured = time.iter().map(|t| output(*t) + noise()).collect();
    let unit = |text| Unit::parse(text).unwrap();
    let input =
        Channel::new(names[0], unit(units[0]), time.clone(), time.iter().map(|t| known(*t)).collect());
    let output = Channel::new(names[1], unit(units[1]), time, measured);
    Recording::from_channels("gap", vec![input, output]).unwrap()
}

fn force(t: f64) -> f64 {
    FORCE.iter().map(|(a, w)| a * (w * t).sin()).sum()
}

fn fitted(model: &str, recording: Recording) -> Fit {
    fit(&Model::parse(model).unwrap(), &[recording], &FitOptions::default()).unwrap()
}

#[test]
fn an_axis_that_rings_is_waited_for_as_long_as_it_rings() {
    // the steady answer of 2.2 q″ + 2.5 q′ + 70 q = F: it rings with 2 M/b = 1.8 s
    let swing = |t: f64| {
        let part = |(a, w): &(f64, f64)| {
            let stiffness = Complex64::new(70.0 - 2.2 * w * w, 2.5 * w);
            a * (Complex64::from_polar(1.0, w * t) / stiffness).im
        };
        FORCE.iter().map(part).sum::<f64>()
    };
    let fit = fitted(AXIS, with_gap(8.0, ["N", "m"], ["F", "position"], swing));
    for (name, truth, within) in [("M", 2.2, 0.01), ("b", 2.5, 0.05), ("k", 70.0, 0.2)] {
        let found = fit.parameters.iter().find(|p| p.name == name).unwrap().value;
        assert!((found - truth).abs() < within, "{name} = {found}");
    }
}

#[test]
fn what_is_never_forgotten_is_told() {
    let model = r#"
        name = "tank"
        [inputs]
        u = { unit = "m/s" }
        [parameters]
        g = { value = 0.5, unit = "1", fit = true }
        [states]
        x = { rate = "g*u", unit = "m", initial = "fit" }
        [outputs]
        y = { equals = "x", unit = "m" }
    "#;
    let filled = |t: f64| -0.8 * FORCE.iter().map(|(a, w)| a / w * (w * t).cos()).sum::<f64>();
    let fit = fitted(model, with_gap(4.0, ["m/s", "m"], ["u", "y"], filled));
    let told =
        fit.warnings.iter().any(|w| w.message.contains("u has a gap from 3.99") && w.message.contains("Cut"));
    assert!(told, "{:?}", fit.warnings);
}
