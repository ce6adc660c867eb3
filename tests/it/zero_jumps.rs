//! The zero of a sensor that jumps by two deviations of its noise, on a plant that settles within a few samples.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const WEB: &str = r#"
    name = "web between two rollers"
    [inputs]
    slip = { unit = "mm/s" }
    [parameters]
    k = { value = 30.0, unit = "N*s/mm", fit = true, min = 1.0, max = 1000.0 }
    T0 = { value = 140.0, unit = "N", fit = true }
    tau = { value = 0.7, unit = "s", fit = true, min = 0.05, max = 20.0 }
    [states]
    T = { rate = "(T0 + k*slip - T)/tau", unit = "N", initial = "fit" }
    [outputs]
    tension = { equals = "T", unit = "N" }
"#;
const STEP: f64 = 0.1;

/// What is said of 200 s of 0.9 T' = 150 + 24 s − T, the sensor's zero moved by a jump, N, at 68 s.
fn found(jump: f64) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(97);
    let mut drawn = || -> f64 { StandardNormal.sample(&mut rng) };
    let (mut slip, mut tension) = (0.0, 150.0);
    let (mut slips, mut shown) = (Vec::new(), Vec::new());
    for i in 0..2000usize {
        let next = 0.97 * slip + 0.1 * drawn();
        let zero = if i >= 680 { jump } else { 0.0 };
        slips.push(1e-3 * slip);
        shown.push(tension + zero + 2.0 * drawn());
        // the lag of a straight line: x(h) = r(h) − a τ + (x − r(0) + a τ) e^(−h/τ)
        let (from, to) = (150.0 + 24.0 * slip, 150.0 + 24.0 * next);
        let late = 0.9 * (to - from) / STEP;
        tension = to - late + (tension - from + late) * (-STEP / 0.9f64).exp();
        slip = next;
    }
    let time: Vec<f64> = (0..slips.len()).map(|i| STEP * i as f64).collect();
    let channel = |name: &str, unit: &str, values: Vec<f64>| {
        Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
    };
    let channels = vec![channel("slip", "mm/s", slips), channel("tension", "N", shown)];
    let recording = Recording::from_channels("press", channels).unwrap();
    diagnosed(&Model::parse(WEB).unwrap(), recording).answer
}

#[test]
fn a_zero_that_jumps_is_named_or_ties_with_what_jumps_before_it() {
    let answer = found(4.5);
    assert!(matches!(answer.verdict, Verdict::Named | Verdict::Tie), "{}", answer.says);
    let jump = &answer.findings[0];
    assert!(["output-offset", "parameter-change"].contains(&jump.code.as_str()), "{}", answer.says);
    let at = jump.parameters.iter().find(|p| p.unit == "s").unwrap();
    assert!((at.value - 68.0).abs() < 1.0, "{at:?}");
    assert!((answer.proof[0].holdout_after / 2.0 - 1.0).abs() < 0.1, "{:?}", answer.proof);
}

#[test]
fn a_zero_that_stays_lacks_nothing() {
    let answer = found(0.0);
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
}
