//! A room whose loss goes with a power of the wind, and one with a small second gain beside a large one.

use crate::diagnose::diagnosed;
use crate::fields::{Plant, first, value};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const ROOM: &str = r#"
    name = "room"
    [inputs]
    P = { unit = "W" }
    [parameters]
    C = { value = 300, unit = "kJ/K", fit = true, min = 10, max = 1e4 }
    H = { value = 60, unit = "W/K", fit = true, min = 1, max = 1e3 }
    [states]
    T = { rate = "(P - H*T)/C", unit = "K", initial = "fit" }
    [outputs]
    warm = { equals = "T", unit = "K" }
"#;
const STEP: f64 = 60.0;
const COUNT: usize = 4000;

/// A signal that stays for some steps and leaps, between two values.
fn stairs(rng: &mut ChaCha8Rng, (low, high): (f64, f64), every: usize) -> Vec<f64> {
    let mut value = low;
    let mut one = |i: usize| {
        if i.is_multiple_of(every) {
            let share: f64 = StandardNormal.sample(rng);
            value = low + (high - low) * (0.5 + 0.3 * share).clamp(0.0, 1.0);
        }
        value
    };
    (0..COUNT).map(&mut one).collect()
}

/// What is found of a room with C = 250 kJ/K: T(t + h) = T∞ + (T − T∞)·e^{−hH/C} from step to step, with T∞ = heat/H.
fn found(others: &[(&str, &str, Vec<f64>)], law: impl Fn(usize) -> (f64, f64), noise: f64) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let power = stairs(&mut rng, (0.0, 2000.0), 37);
    let mut warm = 12.0;
    let mut measured = Vec::new();
    for (i, p) in power.iter().enumerate() {
        let error: f64 = StandardNormal.sample(&mut rng);
        measured.push(warm + noise * error);
        let (loss, gain) = law(i);
        let end = (p + gain) / loss;
        warm = end + (warm - end) * (-STEP * loss / 250e3).exp();
    }
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let held = |name: &str, u: &str, values: Vec<f64>| Channel {
        hold: Hold::Previous,
        ..Channel::new(name, unit(u), time.clone(), values)
    };
    let mut channels = vec![held("P", "W", power)];
    channels.extend(others.iter().map(|(name, u, values)| held(name, u, values.clone())));
    channels.push(Channel::new("warm", unit("K"), time.clone(), measured));
    diagnosed(&Model::parse(ROOM).unwrap(), Recording::from_channels("room", channels).unwrap()).answer
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_loss_goes_with_a_power_of_the_wind() {
    let wind = stairs(&mut ChaCha8Rng::seed_from_u64(4), (0.4, 9.0), 23);
    let loss: Vec<f64> = wind.iter().map(|w| 70.0 * w.powf(0.4)).collect();
    let told = found(&[("wind", "m/s", wind)], |i| (loss[i], 0.0), 0.1);
    let finding = &told.findings[0];
    assert_eq!((told.verdict, told.findings.len()), (Verdict::Named, 1), "{}", told.says);
    assert_eq!((finding.code.as_str(), finding.site.name.as_str()), ("parameter-dependence", "H"));
    let n = &finding.parameters[0];
    assert!(n.name == "n" && n.low < 0.4 && 0.4 < n.high && n.high - n.low < 0.05, "{}", told.says);
}

/// People add some hundredths of the noise's square beside a sun that adds many times as much: told, and not named.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_is_sure_and_small_beside_a_finding_is_told() {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let (sun, people) = (stairs(&mut rng, (0.0, 800.0), 61), stairs(&mut rng, (0.0, 30.0), 29));
    let gain = |per: f64, i: usize| 1.5 * sun[i] + per * people[i];
    for (per, is_told) in [(2.0, true), (0.0, false)] {
        let others = [("sun", "W/m^2", sun.clone()), ("people", "1", people.clone())];
        let told = found(&others, |i| (70.0, gain(per, i)), 1.0);
        let codes: Vec<&str> = told.findings.iter().map(|f| f.code.as_str()).collect();
        assert_eq!(codes, ["cross-coupling"], "{per}: {}", told.says);
        let small = told.notes.iter().find(|n| n.starts_with("something small is left for sure"));
        assert_eq!(small.is_some_and(|n| n.contains("people")), is_told, "{:?}", told.notes);
    }
}

const CABINET: Plant<'_> = Plant {
    step: 20.0,
    start: &[9.0],
    inputs: &[("steam", "1"), ("dryer", "1"), ("outside", "g/m^3")],
    states: &[("x", "g/m^3")],
    sizes: &[(0.4, 0.3), (0.5, 0.25), (8.0, 2.5)],
    noise: 0.01,
    measured: 1,
};
const CABINET_MODEL: &str = r#"
    name = "cabinet"
    [inputs]
    steam = { unit = "1" }
    dryer = { unit = "1" }
    [parameters]
    gain = { value = 0.015, unit = "g/m^3/s", fit = true, min = 0 }
    dry = { value = 0.001, unit = "1/s", fit = true, min = 0 }
    [states]
    x = { rate = "gain*steam - dry*dryer*x", unit = "g/m^3", initial = "fit" }
    [outputs]
    x_meas = { equals = "x", unit = "g/m^3" }
"#;

/// A leak to the air outside, whose humidity is recorded, is one law of one size; one into nothing is a loss.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_loss_goes_to_surroundings_that_are_recorded() {
    let of = |leak: f64, share: f64, power: f64| {
        CABINET.diagnosed(CABINET_MODEL, |x, u| {
            let apart = x[0] - share * u[2];
            vec![0.02 * u[0] - 0.0015 * u[1] * x[0] - leak * apart.signum() * apart.abs().powf(power)]
        })
    };
    for (power, term) in [(1.0, "-c*(x - outside)"), (0.5, "sqrt")] {
        let leaking = of(4e-4, 1.0, power);
        assert_eq!((leaking.verdict, leaking.findings.len()), (Verdict::Named, 1), "{}", leaking.says);
        let finding = &leaking.findings[0];
        assert!(finding.code == "exchange" && finding.term.contains(term), "{}", leaking.says);
    }
    let [low, _, high] = value(&of(4e-4, 1.0, 1.0), "c");
    assert!(low < 4e-4 && 4e-4 < high && high - low < 4e-5, "{low} to {high}");
    let lost = of(4e-4, 0.0, 1.0);
    assert_eq!((lost.verdict, first(&lost)), (Verdict::Named, "linear-damping"), "{}", lost.says);
    assert_eq!(of(0.0, 0.0, 1.0).verdict, Verdict::NothingMissing);
}

/// Where the model's own loss is fitted, a loss more to surroundings is what a coupling to them is.
#[test]
fn what_a_fitted_loss_takes_up_is_a_coupling_as_well() {
    let outside = stairs(&mut ChaCha8Rng::seed_from_u64(4), (2.0, 22.0), 53);
    let told = found(&[("Ta", "K", outside.clone())], |i| (60.0 + 25.0, 25.0 * outside[i]), 0.1);
    let [only] = &told.findings[..] else { panic!("{}", told.says) };
    let mut names = [&[only.code.clone()][..], &only.ties].concat();
    names.sort();
    assert_eq!(
        (told.verdict, &names[..]),
        (Verdict::Tie, &["cross-coupling", "exchange"].map(String::from)[..])
    );
}

/// What a sensor follows is no store of its own: a time constant that is wrong is its value, not a flow more.
#[test]
fn a_flow_that_the_model_has_is_none_more() {
    let lag = CABINET_MODEL
        .replace("gain*steam - dry*dryer*x", "(outside - x)/tau")
        .replace("[states]", "tau = { value = 300, unit = \"s\" }\n    [states]");
    let lag = lag.replace("[parameters]", "outside = { unit = \"g/m^3\" }\n    [parameters]");
    let told = CABINET.diagnosed(&lag, |x, u| vec![(u[2] - x[0]) / 200.0]);
    assert_eq!((told.verdict, first(&told)), (Verdict::Named, "parameter-value"), "{}", told.says);
}

/// A room between a cold outside and a warmer boiler house of 45 °C, which nobody recorded.
#[test]
fn a_gain_from_warmer_surroundings_is_a_loss_to_them() {
    let plant = Plant {
        step: 300.0,
        start: &[292.0, 291.0],
        inputs: &[("heating", "W"), ("outdoor", "K")],
        states: &[("T", "K"), ("wall", "K")],
        sizes: &[(900.0, 900.0), (277.0, 8.0)],
        noise: 0.01,
        measured: 1,
    };
    let model = r#"
        name = "room"
        [inputs]
        heating = { unit = "W" }
        outdoor = { unit = "K" }
        [parameters]
        C = { value = 350, unit = "kJ/K", fit = true, min = 10, max = 1e4 }
        Cw = { value = 3000, unit = "kJ/K", fit = true, min = 100, max = 1e5 }
        G = { value = 50, unit = "W/K", fit = true, min = 1, max = 1e3 }
        Gw = { value = 100, unit = "W/K", fit = true, min = 1, max = 1e3 }
        [states]
        T = { rate = "(heating - G*(T - outdoor) - Gw*(T - wall))/C", unit = "K", initial = "fit" }
        wall = { rate = "Gw*(T - wall)/Cw", unit = "K", initial = "fit" }
        [outputs]
        T_meas = { equals = "T", unit = "K" }
    "#;
    let told = plant.diagnosed(model, |x, u| {
        let wall = 90.0 * (x[0] - x[1]);
        let gain = u[0] - 60.0 * (x[0] - u[1]) - wall + 40.0 * (318.15 - x[0]);
        vec![gain / 400e3, wall / 4e6]
    });
    assert_eq!((told.verdict, first(&told)), (Verdict::Named, "linear-damping"), "{}", told.says);
    let (c, [low, _, high]) = (value(&told, "c"), value(&told, "Ta"));
    assert!(c[0] < 40.0 && 40.0 < c[2] && c[2] - c[0] < 10.0, "{c:?} {}", told.says);
    assert!(low < 318.15 && 318.15 < high && high - low < 5.0, "{}", told.says);
}
