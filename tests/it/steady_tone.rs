//! One steady tone: an autoregression foretells it as well as any law, and must not hide one for that.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// A sensor that shows 6° sin(2πt/T) so many seconds late, with 0.02° of noise.
fn sensor(period: f64, late: f64, seed: u64) -> Answer {
    let model = r#"
        name = "sensor"
        [inputs]
        u = { unit = "deg" }
        [parameters]
        b = { value = 0.0, unit = "deg", fit = true }
        [outputs]
        y = { equals = "u + b", unit = "deg" }
    "#;
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let time: Vec<f64> = (0..1800).map(|i| 0.5 * f64::from(i)).collect();
    let at = |t: f64| 6f64.to_radians() * (std::f64::consts::TAU * t / period).sin();
    let seen = time.iter().map(|t| at(t - late) + 0.02f64.to_radians() * normal()).collect();
    let unit = Unit::parse("deg").unwrap();
    let channels = vec![
        Channel::new("u", unit.clone(), time.clone(), time.iter().map(|t| at(*t)).collect()),
        Channel::new("y", unit, time, seen),
    ];
    diagnosed(&Model::parse(model).unwrap(), Recording::from_channels("sensor", channels).unwrap()).answer
}

#[test]
fn a_delay_is_named_at_a_single_tone() {
    for (period, late, seed) in [(10.0, 1.0, 1), (20.0, 1.0, 2), (90.0, 3.0, 3)] {
        let told = sensor(period, late, seed);
        let finding = told.findings.first().unwrap_or_else(|| panic!("{period}: {}", told.says));
        assert!(finding.code.ends_with("-delay"), "{period}: {}", told.says);
        assert!((finding.parameters[0].value - late).abs() < 0.01, "{}", told.says);
        assert!(matches!(told.verdict, Verdict::Named | Verdict::Tie), "{}", told.says);
    }
}

#[test]
fn a_tone_in_time_gets_no_name() {
    let told = sensor(20.0, 0.0, 4);
    assert_eq!((told.verdict, told.findings.len()), (Verdict::NothingMissing, 0), "{}", told.says);
}
