//! A sensor that wanders slowly hides a resonance from least squares, and nothing is missing.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording};
use gyrospec::units::Unit;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const MOUNT: &str = r#"
    name = "mount of a telescope"
    [inputs]
    current = { unit = "A" }
    [parameters]
    Jm = { value = 38, unit = "kg*m^2" }
    Jt = { value = 230, unit = "kg*m^2", fit = true, min = 10 }
    k = { value = 36000, unit = "N*m/rad", fit = true, min = 1000 }
    c = { value = 150, unit = "N*m*s/rad", fit = true, min = 0 }
    b = { value = 220, unit = "N*m*s/rad", fit = true, min = 0 }
    kt = { value = 11.5, unit = "N*m/A" }
    [states]
    am = { rate = "wm", unit = "rad", initial = "fit" }
    wm = { rate = "(kt*current - b*wm - k*(am - at) - c*(wm - wt))/Jm", unit = "rad/s", initial = 0 }
    at = { rate = "wt", unit = "rad", initial = "fit" }
    wt = { rate = "(k*(am - at) + c*(wm - wt))/Jt", unit = "rad/s", initial = 0 }
    [outputs]
    encoder = { equals = "at", unit = "arcsec" }
"#;
const STEP: f64 = 0.02;
const COUNT: usize = 4000;
const FINE: usize = 10;

/// Angle of the tube, rad, of Jt = 210, k = 42000, c = 120, b = 260, by Runge and Kutta's method, the current held.
fn angles(current: &[f64]) -> Vec<f64> {
    let rates = |[am, wm, at, wt]: [f64; 4], i: f64| {
        let twist = 42e3 * (am - at) + 120.0 * (wm - wt);
        [wm, (11.5 * i - 260.0 * wm - twist) / 38.0, wt, twist / 210.0]
    };
    let plus = |x: [f64; 4], h: f64, r: [f64; 4]| std::array::from_fn(|k| x[k] + h * r[k]);
    let (h, mut x, mut seen) = (STEP / FINE as f64, [0.0; 4], Vec::new());
    for i in current {
        seen.push(x[2]);
        for _ in 0..FINE {
            let r1 = rates(x, *i);
            let r2 = rates(plus(x, h / 2.0, r1), *i);
            let r3 = rates(plus(x, h / 2.0, r2), *i);
            let r4 = rates(plus(x, h, r3), *i);
            x = std::array::from_fn(|k| x[k] + h / 6.0 * (r1[k] + 2.0 * r2[k] + 2.0 * r3[k] + r4[k]));
        }
    }
    seen
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_sensor_that_wanders_hides_no_resonance() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut level = 0.0;
    let mut current = Vec::new();
    for i in 0..COUNT {
        if i % 25 == 0 {
            level = rng.random_range(-1.0..1.0);
        }
        current.push(level);
    }
    let arcsec = 180.0 * 3600.0 / std::f64::consts::PI;
    let (memory, spread): (f64, f64) = (0.985, 40.0);
    let mut wander = 0.0;
    let mut measured = Vec::new();
    for angle in angles(&current) {
        let step: f64 = StandardNormal.sample(&mut rng);
        wander = memory * wander + (1.0 - memory * memory).sqrt() * spread * step;
        measured.push(angle + wander / arcsec);
    }
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let unit = |text| Unit::parse(text).unwrap();
    let current =
        Channel { hold: Hold::Previous, ..Channel::new("current", unit("A"), time.clone(), current) };
    let encoder = Channel::new("encoder", unit("arcsec"), time, measured);
    let recording = Recording::from_channels("made", vec![current, encoder]).unwrap();
    let answer = diagnosed(&Model::parse(MOUNT).unwrap(), recording).answer;
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
    for (name, truth) in [("Jt", 210.0), ("k", 42e3), ("c", 120.0), ("b", 260.0)] {
        let p = answer.parameters.iter().find(|p| p.name == name).unwrap();
        let wide = 2.0 * (p.high - p.low);
        assert!(
            p.low - wide < truth && truth < p.high + wide,
            "{name}: {} ({} to {})",
            p.after,
            p.low,
            p.high
        );
    }
}
