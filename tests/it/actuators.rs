//! An actuator that the model has as a lag and whose rate is limited, or that is slower one way; a well behind an orifice;
//! a capsule whose pressure an output has under a logarithm.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// Samples of x' = rate(t, x) in fine Euler steps, so many to a sample.
fn stepped(times: &[f64], begins: f64, fine: u32, rate: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let mut x = begins;
    let mut course = vec![x];
    for pair in times.windows(2) {
        let h = (pair[1] - pair[0]) / f64::from(fine);
        for k in 0..fine {
            x += h * rate(pair[0] + h * f64::from(k), x);
        }
        course.push(x);
    }
    course
}

/// Values and white noise of a size.
pub fn noisy(values: &[f64], noise: f64, seed: u64) -> Vec<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    values.iter().map(|v| v + noise * normal()).collect()
}

/// Channels, name, unit and values, beside one time.
pub fn recording(time: &[f64], channels: &[(&str, &str, Vec<f64>)]) -> Recording {
    let one = |(name, unit, values): &(&str, &str, Vec<f64>)| {
        let unit = Unit::parse(unit).unwrap();
        let si = values.iter().map(|v| unit.to_si(*v)).collect();
        Channel::new(*name, unit, time.to_vec(), si)
    };
    Recording::from_channels("made", channels.iter().map(one).collect()).unwrap()
}

/// A straight line through samples.
fn line(times: &[f64], values: &[f64], t: f64) -> f64 {
    let i = times.partition_point(|s| *s <= t).clamp(1, times.len() - 1);
    let share = (t - times[i - 1]) / (times[i] - times[i - 1]);
    values[i - 1] + share * (values[i] - values[i - 1])
}

#[test]
fn the_rate_of_an_actuator_of_the_model_is_limited() {
    let time: Vec<f64> = (0..1500).map(|i| 0.1 * f64::from(i)).collect();
    let order: Vec<f64> = time.iter().map(|t| 15.0 * (0.31 * t).sin() + 8.0 * (0.83 * t).sin()).collect();
    let rudder = stepped(&time, 0.0, 100, |t, x| ((line(&time, &order, t) - x) / 0.8).clamp(-4.0, 4.0));
    let model = Model::parse(
        "name = \"steering gear\"\n[inputs]\norder = { unit = \"deg\" }\n[parameters]\n\
         T = { value = 1.0, unit = \"s\", fit = true, min = 0.01, max = 100 }\n\
         [states]\nr = { rate = \"(order - r)/T\", unit = \"deg\", initial = \"fit\" }\n\
         [outputs]\nrudder = { equals = \"r\", unit = \"deg\" }\n",
    )
    .unwrap();
    let made = recording(&time, &[("order", "deg", order), ("rudder", "deg", noisy(&rudder, 0.1, 3))]);
    let told = diagnosed(&model, made).answer;
    let first = &told.findings[0];
    assert_eq!((told.verdict, told.findings.len()), (Verdict::Named, 1), "{}", told.says);
    assert_eq!((first.code.as_str(), first.site.name.as_str()), ("input-rate-limit", "r"), "{}", told.says);
    let limit = &first.parameters[0];
    let rate = Unit::parse(&limit.unit).unwrap().to_si(limit.value).to_degrees();
    assert!((rate - 4.0).abs() < 0.02, "{rate}: {}", told.says);
}

/// A valve that fills a chamber faster than it vents it.
#[test]
fn an_actuator_is_slower_one_way_than_the_other() {
    let time: Vec<f64> = (0..3000).map(|i| 0.02 * f64::from(i)).collect();
    let asked = |t: f64| 300.0 + 110.0 * (0.9 * t).sin() + 70.0 * (3.7 * t).sin() + 40.0 * (0.31 * t).cos();
    let order: Vec<f64> = time.iter().map(|t| asked(*t)).collect();
    let pressure = stepped(&time, 300.0, 100, |t, p| {
        let over = line(&time, &order, t) - p;
        over / if over > 0.0 { 0.20 } else { 0.30 }
    });
    let model = Model::parse(
        "name = \"chamber\"\n[inputs]\norder = { unit = \"kPa\" }\n[parameters]\n\
         tau = { value = 0.2, unit = \"s\", fit = true, min = 0.001, max = 10 }\n\
         [states]\np = { rate = \"(order - p)/tau\", unit = \"kPa\", initial = \"fit\" }\n\
         [outputs]\ngauge = { equals = \"p\", unit = \"kPa\" }\n",
    )
    .unwrap();
    let made = recording(&time, &[("order", "kPa", order), ("gauge", "kPa", noisy(&pressure, 1.0, 4))]);
    let told = diagnosed(&model, made).answer;
    let first = &told.findings[0];
    assert_eq!((told.verdict, told.findings.len()), (Verdict::Named, 1), "{}", told.says);
    assert_eq!(
        (first.code.as_str(), first.site.name.as_str()),
        ("parameter-dependence", "tau"),
        "{}",
        told.says
    );
    // tau (1 + a) upwards and tau (1 - a) downwards
    let (tau, a) = (told.parameters[0].after, first.parameters[0].value);
    let [up, down] = [tau * (1.0 + a), tau * (1.0 - a)];
    assert!((up - 0.20).abs() < 0.004 && (down - 0.30).abs() < 0.004, "{up} {down}: {}", told.says);
}

/// Where the difference of two levels passes through 0 its root is so steep that steps for the rate itself are none.
#[test]
fn a_well_fills_through_an_orifice() {
    let time: Vec<f64> = (0..2500).map(|i| 30.0 * f64::from(i)).collect();
    let sea: Vec<f64> =
        time.iter().map(|t| 3.0 + 1.1 * (2.4e-4 * t).sin() + 0.06 * (0.011 * t).sin()).collect();
    let well = stepped(&time, 3.0, 200, |t, h| {
        let over = line(&time, &sea, t) - h;
        9.3e-4 * over.signum() * over.abs().sqrt()
    });
    let model = Model::parse(
        "name = \"tide gauge\"\n[inputs]\nsea = { unit = \"m\" }\n[parameters]\nA = { value = 0.2, unit = \"m^2\" }\n\
         k = { value = 4e-4, unit = \"m^2/s\", fit = true }\n\
         [states]\nh = { rate = \"k*(sea - h)/A\", unit = \"m\", initial = \"fit\" }\n\
         [outputs]\nlevel = { equals = \"h\", unit = \"m\" }\n",
    )
    .unwrap();
    let made = recording(&time, &[("sea", "m", sea), ("level", "m", noisy(&well, 1.5e-3, 2))]);
    let told = diagnosed(&model, made).answer;
    let first = &told.findings[0];
    assert_eq!((told.verdict, first.code.as_str()), (Verdict::Named, "power-law"), "{}", told.says);
    assert!((first.parameters[0].value + 0.5).abs() < 0.02, "{}", told.says);
}

/// ln(p₀/p) has no value where the hidden pressure begins at 0: it begins near the one outside.
#[test]
fn a_hidden_state_begins_near_an_input_of_its_kind() {
    let time: Vec<f64> = (0..800).map(f64::from).collect();
    let outside: Vec<f64> = time.iter().map(|t| 80.0 + 6.0 * (0.05 * t).sin()).collect();
    let inside = stepped(&time, 80.0, 100, |t, p| (line(&time, &outside, t) - p) / 6.0);
    let height: Vec<f64> = inside.iter().map(|p| 8400.0 * (101.325 / p).ln()).collect();
    let model = Model::parse(
        "name = \"altimeter\"\n[inputs]\np = { unit = \"kPa\" }\n[parameters]\np0 = { value = 101.325, unit = \"kPa\" }\n\
         H = { value = 9000, unit = \"m\", fit = true }\ntau = { value = 8, unit = \"s\", fit = true, min = 0.1 }\n\
         [states]\nc = { rate = \"(p - c)/tau\", unit = \"kPa\", initial = \"fit\" }\n\
         [outputs]\nalt = { equals = \"H*ln(p0/c)\", unit = \"m\" }\n",
    )
    .unwrap();
    let made = recording(&time, &[("p", "kPa", outside), ("alt", "m", noisy(&height, 2.0, 4))]);
    let told = diagnosed(&model, made).answer;
    assert_eq!(told.verdict, Verdict::NothingMissing, "{}", told.says);
    let height = told.parameters.iter().find(|p| p.name == "H").unwrap();
    assert!((height.after - 8400.0).abs() < 10.0, "{}", height.after);
}
