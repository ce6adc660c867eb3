//! Nothing is called missing for what a fit does not know, nor for a little noise of an input.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const STEP: f64 = 0.5;
const COUNT: usize = 3000;

/// y′ = (K u − y)/T, T known; a part R of u goes straight through.
const LAG: &str = r#"
    name = "lag"
    [inputs]
    u = { unit = "V" }
    [parameters]
    T = { value = 2.5, unit = "s", min = 0.1, max = 1e3 }
    K = { value = 1, unit = "1", fit = true }
    R = { value = 0.8, unit = "1", fit = true }
    [states]
    y = { rate = "(K*u - y)/T", unit = "V", initial = "fit" }
    [outputs]
    volt = { equals = "y + R*u", unit = "V" }
"#;

/// The lag with T = 2.5 s, K = 1.2 and R = 1, exact for a voltage that runs straight between samples; both recorded
/// with noise.
fn lag(voltage: &[f64], noise: (f64, f64), seed: u64) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    let (constant, gain) = (2.5, 1.2);
    let decay = f64::exp(-STEP / constant);
    let mut y = vec![0.0];
    for u in voltage.windows(2) {
        let ramp = gain * (u[1] - u[0]) / STEP;
        let settled = |t: f64| gain * u[0] + ramp * (t - constant);
        y.push((y[y.len() - 1] - settled(0.0)) * decay + settled(STEP));
    }
    let time: Vec<f64> = (0..voltage.len()).map(|i| STEP * i as f64).collect();
    let volt = || Unit::parse("V").unwrap();
    let input: Vec<f64> = voltage.iter().map(|u| u + noise.0 * normal()).collect();
    let output: Vec<f64> = y.iter().zip(voltage).map(|(y, u)| y + u + noise.1 * normal()).collect();
    let channels =
        vec![Channel::new("u", volt(), time.clone(), input), Channel::new("volt", volt(), time, output)];
    let made = Recording::from_channels("lag", channels).unwrap();
    diagnosed(&Model::parse(LAG).unwrap(), made).answer
}

/// The sea gets rougher where nothing is fitted: a gain that is known to 6 % there leaves as much of the signal as the
/// noise is, slow and with a level of its own.
#[test]
fn a_held_out_part_that_asks_more_of_the_fit_is_no_step() {
    for seed in 0..4 {
        let voltage: Vec<f64> = (0..COUNT)
            .map(|i| {
                let t = STEP * i as f64;
                let size = if i < COUNT * 3 / 5 { 0.02 } else { 0.6 };
                size * ((0.02 * t).sin() + (0.033 * t).cos())
            })
            .collect();
        let told = lag(&voltage, (0.0, 0.05), seed);
        assert_eq!(told.verdict, Verdict::NothingMissing, "{seed} {}", told.says);
    }
}

#[test]
fn a_little_noise_of_an_input_is_nothing_missing() {
    let mut traces = 0;
    for seed in 10..14 {
        let mut rng = ChaCha8Rng::seed_from_u64(1000 + seed);
        let mut u = 0.0;
        let next = |_| {
            let e: f64 = StandardNormal.sample(&mut rng);
            u = 0.95 * u + e;
            u
        };
        let voltage: Vec<f64> = (0..COUNT).map(next).collect();
        // 5 % of the voltage's own deviation of 3.2 V: a delay would take 2 % of the squares away, for sure
        let told = lag(&voltage, (0.15, 0.05), seed);
        assert_eq!(told.verdict, Verdict::NothingMissing, "{seed} {}", told.says);
        assert!(told.findings.is_empty());
        assert_eq!(told.detection.p_value < 1e-3, told.says.contains("2 %"), "{seed} {}", told.says);
        traces += usize::from(told.detection.p_value < 1e-3);
    }
    assert!(traces > 0);
}
