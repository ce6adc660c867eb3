//! What comes again each day and was not recorded: the sun in a room, over days too few to read its period from.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{PI, TAU};

const ROOM: &str = r#"
    name = "room"
    [inputs]
    P = { unit = "W" }
    outside = { unit = "degC" }
    [parameters]
    C = { value = 8e6, unit = "J/K", fit = true, min = 1e5 }
    G = { value = 100, unit = "W/K", fit = true, min = 1 }
    [states]
    T = { rate = "(P - G*(T - outside))/C", unit = "K", initial = "fit" }
    [outputs]
    inside = { equals = "T", unit = "degC" }
"#;
const STEP: f64 = 600.0;
const DAYS: f64 = 6.0;

/// What is said of a room of 7 MJ/K and 120 W/K with the sun of a peak, W, at noon.
fn found(sun: f64) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(29);
    let mut drawn = || -> f64 { StandardNormal.sample(&mut rng) };
    let time: Vec<f64> = (0..(DAYS * 86_400.0 / STEP) as usize).map(|i| STEP * i as f64).collect();
    let mut power = 1000.0;
    let (mut t, mut weather) = (291.0, 0.0);
    let (mut heat, mut outside, mut inside) = (Vec::new(), Vec::new(), Vec::new());
    for (i, at) in time.iter().enumerate() {
        if i.is_multiple_of(9) {
            power = (1000.0 + 700.0 * drawn()).clamp(0.0, 2500.0);
        }
        weather = 0.995 * weather + 0.2 * drawn();
        let day = TAU * at / 86_400.0;
        let (out, shines) = (278.0 + 4.0 * (day - 2.4).sin() + weather, sun * (-day.cos()).max(0.0));
        heat.push(power);
        outside.push(out);
        inside.push(t + 0.05 * drawn());
        // T(t + h) = T∞ + (T − T∞) e^{−h G/C}
        let end = out + (power + shines) / 120.0;
        t = end + (t - end) * (-STEP * 120.0 / 7e6).exp();
    }
    let channel = |name: &str, unit: &str, values: Vec<f64>, hold| Channel {
        hold,
        ..Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
    };
    let channels = vec![
        channel("P", "W", heat, Hold::Previous),
        channel("outside", "degC", outside, Hold::Previous),
        channel("inside", "degC", inside, Hold::Linear),
    ];
    let recording = Recording::from_channels("room", channels).unwrap();
    diagnosed(&Model::parse(ROOM).unwrap(), recording).answer
}

/// S max(0, −cos w t) = S/π − S/2 cos w t + 2 S/(3 π) cos 2 w t − …
#[test]
fn the_sun_in_a_room_is_a_heat_that_comes_each_day() {
    let answer = found(900.0);
    let [sun] = &answer.findings[..] else { panic!("{}", answer.says) };
    assert_eq!((sun.code.as_str(), sun.site.name.as_str()), ("periodic-force", "T"), "{}", answer.says);
    assert!(matches!(answer.verdict, Verdict::Named | Verdict::Tie), "{}", answer.says);
    let value = |name: &str| sun.parameters.iter().find(|p| p.name == name).unwrap().value;
    assert!((value("A_0") - 900.0 / PI).abs() < 40.0, "{}", answer.says);
    assert!(value("A_sin").abs() < 30.0 && (value("A_cos") + 450.0).abs() < 30.0, "{}", answer.says);
    assert!((value("A_cos_2") - 600.0 / PI).abs() < 30.0, "{}", answer.says);
    let proof = &answer.proof[0];
    assert!(proof.holdout_after < 0.2 * proof.holdout_before, "{}", answer.says);
}

#[test]
fn a_room_without_sun_lacks_nothing() {
    let answer = found(0.0);
    assert!(answer.findings.iter().all(|f| f.code == "input-hold"), "{}", answer.says);
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
}
