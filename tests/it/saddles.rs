//! Parameters that act evenly leave no slope at their zero; a fit does not rest there.

use gyrospec::estimate::Side;
use gyrospec::estimate::fit::{Fit, FitOptions, Status, fit};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording, Span};
use gyrospec::units::Unit;
use rand::{RngExt, SeedableRng};
use rand_distr::{Distribution, StandardNormal};

fn value(fit: &Fit, name: &str) -> f64 {
    fit.parameters.iter().find(|p| p.name == name).unwrap().value
}

/// (2.4): the constant error of a gyrocompass in regular roll, in CGS and radians.
fn steady_error(c0: f64, t: f64, [amplitude, p, course]: [f64; 3]) -> f64 {
    let (weight, momentum, rate, latitude) = (8.5e6, 1.55e8, 7.3e-5, 46.5f64.to_radians());
    let fast = (amplitude * p * p / 981.0).powi(2);
    let whole = weight * weight / (4.0 * momentum * rate * latitude.cos());
    -whole * fast * (2.0 * course).sin() / (c0 * (1.0 + p * p * t * t))
}

const STEADY: &str = r#"
    name = "steady rolling error"
    [inputs]
    amplitude = { unit = "cm" }
    p = { unit = "rad/s" }
    K = { unit = "deg" }
    [parameters]
    C0 = { value = 1.35e5, unit = "g/s^2", fit = true }
    T = { value = 1.0, unit = "s", fit = true, min = 0 }
    P = { value = 8.5e6, unit = "g*cm/s^2" }
    H = { value = 1.55e8, unit = "g*cm^2/s" }
    U = { value = 7.3e-5, unit = "rad/s" }
    phi = { value = 46.5, unit = "deg" }
    g = { value = 981, unit = "cm/s^2" }
    [outputs]
    error = { equals = "-P^2*(amplitude*p^2/g)^2*sin(2*K)/(4*H*U*cos(phi)*C0*(1 + p^2*T^2))", unit = "deg" }
"#;

/// Sixty trials, every figure drawn, with a scatter of 0.02°.
fn table(seed: u64) -> Recording {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let mut text = String::from("amplitude [cm],p [rad/s],K [deg],error [deg]\n");
    for _ in 0..60 {
        let amplitude = rng.random_range(10.0..30.0);
        let p = rng.random_range(0.5..1.6);
        let course = rng.random_range(0.0..360.0f64);
        let scatter: f64 = StandardNormal.sample(&mut rng);
        let error = steady_error(13.5e7, 0.44, [amplitude, p, course.to_radians()]).to_degrees();
        text += &format!("{amplitude},{p},{course},{}\n", error + 0.02 * scatter);
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("t.csv"), text).unwrap();
    let file = "name = \"t\"\nkind = \"trials\"\n[[tables]]\nfile = \"t.csv\"\n[spans]\nfit = [[0, 59]]\n";
    std::fs::write(folder.path().join("t.toml"), file).unwrap();
    Recording::read(folder.path().join("t.toml")).unwrap()
}

#[test]
fn a_steady_rolling_error_does_not_rest_without_a_time_constant() {
    // a thousandth and a thousand times the truth, and without a bound that makes it a logarithm
    for start in ["min = 1, value = 1.35e5", "min = 1, value = 1.35e11", "value = 1.35e11"] {
        let model = Model::parse(&STEADY.replace("value = 1.35e5", start)).unwrap();
        for seed in 0..30 {
            let fitted = fit(&model, &[table(seed)], &FitOptions::default()).unwrap();
            let (t, rmse) = (value(&fitted, "T"), fitted.rmse[0].to_degrees());
            // chance alone lets T stray by a few hundredths of a second and the error by a tenth of its size
            assert!((t - 0.44).abs() < 0.1 && rmse < 0.026, "{start}, table {seed}: T = {t}, {rmse} degrees");
        }
    }
}

/// y over u = 0.1, 0.2 … 6 by a formula, with a scatter of a thousandth.
fn curve(y: impl Fn(f64) -> f64) -> Recording {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(4);
    let u: Vec<f64> = (1..=60).map(|i| 0.1 * f64::from(i)).collect();
    let scatter = |_: &f64| -> f64 { StandardNormal.sample(&mut rng) };
    let e: Vec<f64> = u.iter().map(scatter).collect();
    let measured = u.iter().zip(&e).map(|(u, e)| y(*u) + 1e-3 * e).collect();
    let one = Unit::parse("1").unwrap();
    let channels =
        vec![Channel::new("u", one.clone(), u.clone(), u.clone()), Channel::new("y", one, u, measured)];
    let whole = Recording::from_channels("curve", channels).unwrap();
    whole.with_spans(vec![Span::new(0.0, 10.0)], vec![])
}

fn fitted(parameters: &str, y: &str, recording: Recording) -> Fit {
    let text = format!(
        "name = \"even\"\n[inputs]\nu = {{ unit = \"1\" }}\n[parameters]\n{parameters}\n[outputs]\ny = {{ equals = \"{y}\", unit = \"1\" }}\n"
    );
    fit(&Model::parse(&text).unwrap(), &[recording], &FitOptions::default()).unwrap()
}

#[test]
fn no_start_on_a_saddle_is_the_end() {
    // between bounds, exactly at zero, nothing known of its size: cos(u w) is even in w
    let found =
        fitted("w = { value = 0, unit = \"1\", fit = true }", "cos(u*w)", curve(|u| (0.35 * u).cos()));
    assert!((value(&found, "w").abs() - 0.35).abs() < 0.01, "{}", value(&found, "w"));
    // an upper bound at which a sine turns
    let angle = "a = { value = 90, unit = \"deg\", fit = true, min = 0, max = 90 }";
    let found = fitted(angle, "sin(a)*u", curve(|u| 60f64.to_radians().sin() * u));
    assert!((value(&found, "a").to_degrees() - 60.0).abs() < 0.5, "{}", value(&found, "a").to_degrees());
    // two at once, both at their lower bounds
    let two = "s = { value = 0, unit = \"1\", fit = true, min = 0 }\nz = { value = 0, unit = \"1\", fit = true, min = 0 }";
    let found =
        fitted(two, "u/(1 + u^2*s^2) + z^2", curve(|u| u / (1.0 + (0.3 * u).powi(2)) + 0.7f64.powi(2)));
    assert!((value(&found, "s") - 0.3).abs() < 0.01 && (value(&found, "z") - 0.7).abs() < 0.01);
    // two factors that act only together
    let factors = "a = { value = 0, unit = \"1\", fit = true }\nb = { value = 0, unit = \"1\", fit = true }";
    let found = fitted(factors, "a*b*u", curve(|u| -1.7 * u));
    assert!((value(&found, "a") * value(&found, "b") + 1.7).abs() < 0.01);
}

#[test]
fn an_even_effect_that_is_truly_absent_rests_at_its_bound_without_a_call_for_a_wider_one() {
    // what is measured rises with u where T would let it fall
    let t = "T = { value = 1, unit = \"1\", fit = true, min = 0 }";
    let found = fitted(t, "1/(1 + u^2*T^2)", curve(|u| 1.0 + 0.01 * u * u));
    assert_eq!(found.parameters[0].status, Status::AtBound(Side::Lower));
    assert!(found.warnings.iter().all(|w| !w.message.contains("widen")), "{:?}", found.warnings);
    assert!(found.warnings.iter().any(|w| w.message.contains("T rests at its lower bound 0")));
}
