//! A room whose loss goes with a power of the wind, and one with a small second gain beside a large one.

use crate::diagnose::diagnosed;
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
