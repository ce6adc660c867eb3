//! Answers that say no more than the recording tells: ties, strays, a sensor's jump, a moment that is not known.
//! The recordings come from the exact solution of T y' = g u − y between samples, with u held straight.

use super::{diagnosed, noise as coloured};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;

/// Step of the samples, s.
const STEP: f64 = 0.1;

/// Normal white noise, from the coloured one: e_i − 0.9 e_(i−1) over its deviation.
fn white(n: usize, seed: u64) -> Vec<f64> {
    let all = coloured(n + 1, seed);
    all.windows(2).map(|w| (w[1] - 0.9 * w[0]) / (1.0_f64 - 0.81).sqrt()).collect()
}

/// Numbers in 0 to 1.
fn uniform(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Levels between two values, each held for 20 to 100 samples.
fn levels(n: usize, (low, high): (f64, f64), seed: u64) -> Vec<f64> {
    let mut draw = uniform(seed);
    let mut all = Vec::new();
    while all.len() < n {
        let (level, length) = (low + (high - low) * draw(), 20 + (80.0 * draw()) as usize);
        all.extend(vec![level; length]);
    }
    all.truncate(n);
    all
}

/// y of T y' = g u − y from a start; T as it is in each step, u straight from sample to sample.
fn response(u: &[f64], start: f64, gain: f64, time: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut y = vec![start];
    for (i, w) in u.windows(2).enumerate() {
        let lag = time((i as f64 + 0.5) * STEP);
        let (a, slope) = (gain * w[0], gain * (w[1] - w[0]) / STEP);
        // y = a + s (t − T) + (y₀ − a + s T) e^(−t/T)
        let end = a + slope * (STEP - lag) + (y[i] - a + slope * lag) * (-STEP / lag).exp();
        y.push(end);
    }
    y
}

/// What is said of a model by a recording of one input and one output.
fn answer(model: &str, input: (&str, &[f64]), output: (&str, &[f64])) -> Answer {
    let model = Model::parse(model).unwrap();
    let time: Vec<f64> = (0..input.1.len()).map(|i| STEP * i as f64).collect();
    let units = (model.inputs[0].unit.text(), model.outputs[0].unit.text());
    let channel = |(name, values): (&str, &[f64]), unit: &str| {
        Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values.to_vec())
    };
    let made = Recording::from_channels("made", vec![channel(input, units.0), channel(output, units.1)]);
    diagnosed(&model, made.unwrap()).answer
}

fn covered(y: &[f64], deviation: f64, seed: u64) -> Vec<f64> {
    y.iter().zip(white(y.len(), seed)).map(|(y, e)| y + deviation * e).collect()
}

const TANK: &str = r#"
    name = "tank"
    [inputs]
    q = { unit = "m^3/s" }
    [parameters]
    A = { value = 1.5, unit = "m^2", fit = true, min = 0.01, max = 100 }
    k = { value = 0.5, unit = "m^2/s", FREE }
    [states]
    h = { rate = "(q - k*h)/A", unit = "m", initial = "fit" }
    [outputs]
    level = { equals = "h", unit = "m" }
"#;

fn tank(is_free: bool) -> String {
    let free = if is_free { "fit = true, min = 0.001, max = 100" } else { "fit = false" };
    TANK.replace("FREE", free)
}

/// The tank with A = 2, k = 0.5: gain 1/k, time A/k.
fn level(q: &[f64], k: f64) -> Vec<f64> {
    response(q, 1.0, 1.0 / k, |_| 2.0 / k)
}

/// Only R C acts, so that nobody can tell which of them changed.
#[test]
fn a_change_of_one_factor_of_a_product_ties_with_the_other() {
    let model = r#"
        name = "low pass"
        [inputs]
        u = { unit = "V" }
        [parameters]
        R = { value = 1, unit = "V/A", fit = true, min = 0.01, max = 100 }
        C = { value = 4, unit = "A*s/V" }
        [states]
        v = { rate = "(u - v)/(R*C)", unit = "V", initial = "fit" }
        [outputs]
        v = { equals = "v", unit = "V" }
    "#;
    let u = levels(1200, (-5.0, 5.0), 3);
    for (code, time) in [
        ("parameter-change", &(|t: f64| if t < 40.0 { 4.0 } else { 5.6 }) as &dyn Fn(f64) -> f64),
        ("parameter-drift", &|t: f64| 4.0 * (0.8 + t / 150.0)),
    ] {
        let v = covered(&response(&u, 0.0, 1.0, time), 0.08, 4);
        let a = answer(model, ("u", &u), ("v", &v));
        assert_eq!(a.verdict, Verdict::Tie, "{}", a.says);
        assert_eq!((a.findings[0].code.as_str(), &a.findings[0].ties[..]), (code, &[code.to_string()][..]));
        let mut sites: Vec<&str> = a.located.sites.iter().map(|s| s.name.as_str()).collect();
        sites.sort_unstable();
        assert_eq!(sites, ["C", "R"]);
        let other = if a.findings[0].site.name == "R" { "C" } else { "R" };
        assert!(a.says.contains(&format!("{code} of {other} would fit as well")), "{}", a.says);
    }
}

/// A h' = q − (k + c) h with A free, or a sensor that shows k/(k + c) of the level: the same recording.
#[test]
fn a_leak_where_the_capacity_is_free_ties_with_the_scale_of_the_sensor() {
    let q = levels(1200, (0.2, 2.0), 5);
    let h = covered(&level(&q, 0.65), 0.03, 6);
    let a = answer(&tank(false), ("q", &q), ("level", &h));
    assert_eq!(a.verdict, Verdict::Tie, "{}", a.says);
    let mut codes = vec![a.findings[0].code.as_str()];
    codes.extend(a.findings[0].ties.iter().map(String::as_str));
    assert!(codes.contains(&"linear-damping") && codes.contains(&"output-scale"), "{codes:?}");
}

/// Strays of 10 deviations, two of them side by side, which the channel alone does not show.
#[test]
fn strays_that_only_the_fit_shows_are_faults_and_nothing_is_missing() {
    let q = levels(1200, (0.2, 2.0), 7);
    let clean = covered(&level(&q, 0.5), 0.03, 8);
    let rows: Vec<usize> = (0..20).map(|k| 37 + 58 * k).chain([38]).collect();
    let mut h = clean;
    rows.iter().enumerate().for_each(|(n, i)| h[*i] += if n % 2 == 0 { 0.3 } else { -0.3 });
    let a = answer(&tank(true), ("q", &q), ("level", &h));
    assert_eq!(a.verdict, Verdict::DataFault, "{}", a.says);
    let codes: Vec<&str> = a.faults.iter().map(|f| f.finding.code.as_str()).collect();
    assert!(codes == ["outliers"] && a.says.contains("nothing is missing"), "{}", a.says);
    assert!(a.says.contains("21 samples") || a.says.contains("20 samples"), "{}", a.says);
}

#[test]
fn a_zero_that_jumps_once_is_named_with_its_moment() {
    let q = levels(1200, (0.2, 2.0), 9);
    let mut h = covered(&level(&q, 0.5), 0.03, 11);
    h[420..].iter_mut().for_each(|h| *h += 0.15);
    let a = answer(&tank(true), ("q", &q), ("level", &h));
    assert_eq!(a.verdict, Verdict::Named, "{}", a.says);
    assert_eq!((a.findings.len(), a.findings[0].code.as_str()), (1, "output-offset"), "{}", a.says);
    let (b, moment) = (&a.findings[0].parameters[0], &a.findings[0].parameters[1]);
    assert!(b.low < 0.15 && b.high > 0.15 && (b.value - 0.15).abs() < 0.02, "{b:?}");
    assert!(moment.low >= 41.89 && moment.high <= 42.01, "{moment:?}");
}
