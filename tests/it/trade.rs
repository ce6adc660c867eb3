//! Parameters that trade: what the data leave open is said, and what they determine is said with a value.

use gyrospec::estimate::fit::{Combination, Fit, FitOptions, ascertain, fit};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording, Span};
use gyrospec::simulate::{Budget, Early};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use std::time::Duration;

const MOTOR: &str = r#"
    name = "motor, speed alone"
    [inputs]
    u = { unit = "V" }
    [parameters]
    Ke = { value = 0.04, unit = "V*s", fit = true, min = 1e-4 }
    b = { value = 1e-5, unit = "N*m*s", fit = true, min = 0 }
    J = { value = 2e-3, unit = "kg*m^2", fit = true, min = 1e-7 }
    R = { value = 1.3, unit = "V/A" }
    [states]
    w = { rate = "(Ke*(u - Ke*w)/R - b*w)/J", unit = "rad/s", initial = 0 }
    [outputs]
    speed = { equals = "w", unit = "rad/s" }
"#;

/// Truth of the motor.
const KE: f64 = 0.05;
const B: f64 = 1.8e-4;
const J: f64 = 1e-3;
const R: f64 = 1.3;

fn scatter(seed: u64, count: usize) -> Vec<f64> {
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    (0..count).map(|_| StandardNormal.sample(&mut rng)).collect()
}

/// τ ω' + ω = g u with u = Σ a sin(p t), solved by hand, and a scatter of 0.5 rad/s.
fn motor(seed: u64) -> Recording {
    let whole = KE * KE / R + B;
    let (gain, tau) = (KE / R / whole, J / whole);
    let tones = [(6.0, 0.8), (4.0, 2.7), (3.0, 7.1)];
    let speed = |t: f64| -> f64 {
        let one = |(a, p): &(f64, f64)| {
            let (s, c) = (p * t).sin_cos();
            a * gain * (s - p * tau * (c - (-t / tau).exp())) / (1.0 + p * p * tau * tau)
        };
        tones.iter().map(one).sum()
    };
    // straight lines between samples of 1 ms stray by less than 1e-5 of the signal
    let fine: Vec<f64> = (0..20_001).map(|i| 1e-3 * f64::from(i)).collect();
    let u = fine.iter().map(|t| tones.iter().map(|(a, p)| a * (p * t).sin()).sum()).collect();
    let time: Vec<f64> = (0..1000).map(|i| 0.02 * f64::from(i)).collect();
    let measured = time.iter().zip(scatter(seed, 1000)).map(|(t, e)| speed(*t) + 0.5 * e).collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let channels =
        vec![Channel::new("u", unit("V"), fine, u), Channel::new("speed", unit("rad/s"), time, measured)];
    let whole = Recording::from_channels("motor", channels).unwrap();
    whole.with_spans(vec![Span::new(0.0, 20.0)], vec![])
}

fn told(model: &str, recording: Recording) -> Fit {
    let options = FitOptions::default();
    let recordings = [recording];
    let mut found = fit(&Model::parse(model).unwrap(), &recordings, &options).unwrap();
    ascertain(&mut found, &recordings, &options).unwrap();
    found
}

/// Profiles that the time cuts off say nothing: the intervals are those of the fit, which tells that it ended early.
#[test]
fn how_far_parameters_may_go_is_not_looked_for_beyond_the_time() {
    let options = FitOptions::default();
    let recordings = [motor(0)];
    let plain = fit(&Model::parse(MOTOR).unwrap(), &recordings, &options).unwrap();
    let bounds = |f: &Fit| f.parameters.iter().map(|p| [p.low, p.high].map(f64::to_bits)).collect::<Vec<_>>();
    let whole = told(MOTOR, motor(0));
    assert_ne!(bounds(&plain), bounds(&whole), "profiles matter here");
    for micros in [0, 300, 3000] {
        let budget = Budget::new(u64::MAX, Some(Duration::from_micros(micros)));
        let mut late = plain.clone();
        ascertain(&mut late, &recordings, &FitOptions { budget, ..options.clone() }).unwrap();
        assert_eq!(late.ended_early, Some(Early::Time), "{micros}");
        assert!(late.warnings.iter().any(|w| w.message.contains("may be far too narrow")), "{micros}");
        assert!(bounds(&late) == bounds(&plain) && late.determined.is_empty(), "{micros}");
    }
}

fn combination<'a>(fit: &'a Fit, expression: &str) -> &'a Combination {
    let found = fit.determined.iter().find(|c| c.expression == expression);
    found.unwrap_or_else(|| panic!("{expression} is not among {:?}", fit.determined))
}

#[test]
fn a_motor_seen_by_its_speed_alone_tells_one_sum_and_one_ratio() {
    for seed in 0..4 {
        let found = told(MOTOR, motor(seed));
        let ke = &found.parameters[0];
        // nothing holds Ke below, and above b = 0 does
        let holds = |low: f64, high: f64, truth: f64| {
            (low.is_nan() || low <= truth) && (high.is_nan() || high >= truth)
        };
        assert!(holds(ke.low, ke.high, KE) && (ke.low.is_nan() || ke.low <= 0.5 * KE), "{ke:?}");
        assert!(holds(found.parameters[1].low, found.parameters[1].high, B), "{:?}", found.parameters[1]);
        assert!(holds(found.parameters[2].low, found.parameters[2].high, J), "{:?}", found.parameters[2]);
        let sum = combination(&found, "Ke + R*b/Ke");
        let truth = KE + B * R / KE;
        assert!((sum.value / truth - 1.0).abs() < 5e-3 && sum.high - sum.low < 0.01 * truth, "{sum:?}");
        let ratio = combination(&found, "Ke/J");
        assert!(
            (ratio.value / (KE / J) - 1.0).abs() < 0.02 && ratio.high - ratio.low < 0.05 * KE / J,
            "{ratio:?}"
        );
        let names: Vec<&str> = found.unseen[0].weights.iter().map(|w| w.0.as_str()).collect();
        assert!(["Ke", "b", "J"].iter().all(|n| names.contains(n)), "{names:?}");
    }
}

/// Of a motor with an inductance only three combinations of four are seen: the resistance, which takes a small part, is
/// known to what the losses may be.
#[test]
fn a_resistance_with_a_small_part_in_what_trades_is_not_surer_than_that() {
    let model = MOTOR
        .replace(
            "R = { value = 1.3, unit = \"V/A\" }",
            "R = { value = 1.5, unit = \"V/A\", fit = true }\nL = { value = 0.05, unit = \"V*s/A\" }",
        )
        .replace("[states]", "[states]\ni = { rate = \"(u - R*i - Ke*w)/L\", unit = \"A\", initial = 0 }")
        .replace("(Ke*(u - Ke*w)/R - b*w)/J", "(Ke*i - b*w)/J");
    // L di/dt = u − R i − K ω, J dω/dt = K i − b ω, exactly from step to step of a small matrix's series
    let time: Vec<f64> = (0..2000).map(|k| 0.01 * f64::from(k)).collect();
    let volts: Vec<f64> = scatter(9, 200).iter().flat_map(|e| [5.0 * e; 10]).collect();
    let (mut i, mut w, mut speed) = (0.0, 0.0, Vec::new());
    for u in &volts {
        speed.push(w);
        for _ in 0..1000 {
            let h = 1e-5;
            let rate = |i: f64, w: f64| ((u - R * i - KE * w) / 0.05, (KE * i - B * w) / J);
            let (a, b) = rate(i, w);
            let (a, b) = rate(i + 0.5 * h * a, w + 0.5 * h * b);
            (i, w) = (i + h * a, w + h * b);
        }
    }
    let measured = speed.iter().zip(scatter(31, 2000)).map(|(w, e)| w + 0.2 * e).collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let input = Channel { hold: Hold::Previous, ..Channel::new("u", unit("V"), time.clone(), volts) };
    let channels = vec![input, Channel::new("speed", unit("rad/s"), time, measured)];
    let whole = Recording::from_channels("motor", channels).unwrap();
    let found = told(&model, whole.with_spans(vec![Span::new(0.0, 20.0)], vec![]));
    let r = found.parameters.iter().find(|p| p.name == "R").unwrap();
    // R/L + b/J is seen: without b, R is larger by b L/J; with more of it, smaller
    let is_wide = r.low.is_nan() || r.low <= R - B * 0.05 / J;
    assert!(is_wide && (R..R + 1.5 * B * 0.05 / J).contains(&r.high), "{r:?}");
}

/// y over 200 samples of u, with a scatter of a hundredth.
fn line(y: impl Fn(f64) -> f64) -> Recording {
    let u: Vec<f64> = (0..200).map(|i| (0.37 * f64::from(i)).sin() + 1.5).collect();
    let time: Vec<f64> = (0..200).map(|i| 0.1 * f64::from(i)).collect();
    let measured = u.iter().zip(scatter(9, 200)).map(|(u, e)| y(*u) + 0.01 * e).collect();
    let one = Unit::parse("1").unwrap();
    let channels =
        vec![Channel::new("u", one.clone(), time.clone(), u), Channel::new("y", one, time, measured)];
    let whole = Recording::from_channels("line", channels).unwrap();
    whole.with_spans(vec![Span::new(0.0, 20.0)], vec![])
}

fn free(names: &[&str], y: &str) -> String {
    let parameters: String =
        names.iter().map(|n| format!("{n} = {{ value = 1, unit = \"1\", fit = true, min = 0 }}\n")).collect();
    format!(
        "name = \"m\"\n[inputs]\nu = {{ unit = \"1\" }}\n[parameters]\n{parameters}[outputs]\ny = {{ equals = \"{y}\", unit = \"1\" }}\n"
    )
}

#[test]
fn products_quotients_powers_and_sums_are_named() {
    let cases: [(&[&str], &str, &str, f64); 5] = [
        (&["a", "b"], "a*b*u", "a*b", 3.0),
        (&["a", "b"], "a/b*u", "a/b", 3.0),
        (&["a", "b"], "a*b^2*u", "a*b^2", 3.0),
        (&["a", "b"], "(a + b)*u", "a + b", 3.0),
        (&["a", "b", "c"], "a*b*c*u", "a*b*c", 3.0),
    ];
    for (names, y, expression, truth) in cases {
        let found = told(&free(names, y), line(|u| 3.0 * u));
        let c = combination(&found, expression);
        assert!(c.low < truth && truth < c.high && c.high - c.low < 0.01, "{y}: {c:?}");
        assert!((c.value - truth).abs() < 0.005, "{y}: {c:?}");
    }
}

#[test]
fn parameters_that_stand_apart_keep_the_intervals_of_the_curvature() {
    let model = free(&["a", "b"], "a*u + b*u^2");
    let found = told(&model, line(|u| 2.0 * u + 0.5 * u * u));
    assert!(found.profiled.is_empty() && found.determined.is_empty() && found.unseen.is_empty());
}

const SETTLING: &str = r#"
    name = "first order, three factors of one time"
    [inputs]
    u = { unit = "V" }
    [parameters]
    g = { value = 10, unit = "rad/s/V", fit = true }
    R = { value = R0, unit = "V/A", fit = true, min = 0 }
    C = { value = C0, unit = "A*s/V", fit = true, min = 0 }
    k = { value = k0, unit = "1", fit = true }
    [states]
    w = { rate = "(g*u - w)/(k*R*C)", unit = "rad/s", initial = "fit" }
    [outputs]
    speed = { equals = "w", unit = "rad/s" }
"#;

/// Any R fits, with C or k to match: no end can be told from any start.
#[test]
fn the_factors_of_a_product_have_no_ends_from_any_start() {
    for [r, c, k] in [["2", "3", "2"], ["20", "0.01", "1"], ["0.5", "0.5", "0.5"]] {
        let found = told(&SETTLING.replace("R0", r).replace("C0", c).replace("k0", k), motor(1));
        for p in found.parameters.iter().filter(|p| p.name != "g") {
            assert!(p.low.is_nan() || p.low == 0.0, "{p:?}");
            assert!(p.high.is_nan(), "{p:?}");
        }
        let tau = J / (KE * KE / R + B);
        let product = combination(&found, "R*C*k");
        assert!((product.value / tau - 1.0).abs() < 0.05, "{product:?}");
        assert_eq!(found.unseen.len(), 1, "{:?}", found.unseen);
    }
}

/// Ke + R b/Ke alone is determined: with b = 0, Ke may be all of it, and Ke may be next to nothing.
#[test]
fn an_interval_holds_all_that_fits_as_well() {
    let loose = MOTOR
        .replace(
            "value = 0.04, unit = \"V*s\", fit = true, min = 1e-4",
            "value = 0.03, unit = \"V*s\", fit = true, min = 0",
        )
        .replace("value = 1e-5", "value = 0")
        .replace(
            "value = 2e-3, unit = \"kg*m^2\", fit = true, min = 1e-7",
            "value = 1e-4, unit = \"kg*m^2\", fit = true",
        );
    for seed in 0..4 {
        let found = told(&loose, motor(seed));
        let whole = combination(&found, "Ke + R*b/Ke").value;
        let [ke, b, j] = [0, 1, 2].map(|i| &found.parameters[i]);
        assert!(ke.low.is_nan() || ke.low < 0.01 * whole, "{ke:?}");
        assert!(ke.high.is_nan() || ke.high > 0.999 * whole, "{ke:?} of {whole}");
        // b = Ke (whole - Ke)/R is largest where Ke is half of the whole
        assert!(b.low.is_nan() || b.low == 0.0, "{b:?}");
        assert!(b.high.is_nan() || b.high > 0.999 * whole * whole / (4.0 * R), "{b:?}");
        let inertia = whole * J / KE;
        assert!(j.low.is_nan() || j.low < 0.01 * inertia, "{j:?}");
        assert!(j.high.is_nan() || j.high > 0.98 * inertia, "{j:?} of {inertia}");
    }
}
