//! Forces that repeat with a position are named at any number of periods.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const STEP: f64 = 0.01;
const COUNT: usize = 4000;

/// A shaft of J = 0.004 kg m² and b = 0.1 N m s/rad, with a torque of so many periods a turn on it, whose angle alone
/// is measured; by the rule of Runge and Kutta at a tenth of a sample.
fn shaft(teeth: f64, size: f64, seed: u64) -> Answer {
    let model = r#"
        name = "shaft"
        [inputs]
        torque = { unit = "N*m" }
        [parameters]
        J = { value = 0.005, unit = "kg*m^2", fit = true, min = 1e-5 }
        b = { value = 0.12, unit = "N*m*s/rad", fit = true, min = 0.0 }
        [states]
        q = { rate = "w", unit = "rad", initial = "fit" }
        w = { rate = "(torque - b*w)/J", unit = "rad/s", initial = "fit" }
        [outputs]
        angle = { equals = "q", unit = "rad" }
    "#;
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
    // torques that wander between 0.1 and 0.7 N m, straight between the samples
    let (mut slow, mut torque) = (0.0, Vec::new());
    for _ in 0..COUNT {
        slow += -0.01 * slow + 0.14 * normal();
        torque.push(0.4 + 0.3 * f64::tanh(slow));
    }
    let rate = |x: [f64; 2], u: f64| [x[1], (u - 0.1 * x[1] - size * f64::sin(teeth * x[0])) / 0.004];
    let (mut x, mut angle) = ([0.0, 3.0], Vec::new());
    for i in 0..COUNT {
        angle.push(x[0] + 0.003 * normal());
        let next = torque[(i + 1).min(COUNT - 1)];
        for k in 0..10 {
            let at = |part: f64| torque[i] + (next - torque[i]) * (f64::from(k) + part) / 10.0;
            let h = STEP / 10.0;
            let plus = |x: [f64; 2], k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
            let a = rate(x, at(0.0));
            let b = rate(plus(x, a, 0.5 * h), at(0.5));
            let c = rate(plus(x, b, 0.5 * h), at(0.5));
            let d = rate(plus(x, c, h), at(1.0));
            x = [0, 1].map(|j| x[j] + h / 6.0 * (a[j] + 2.0 * b[j] + 2.0 * c[j] + d[j]));
        }
    }
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let channels = vec![
        Channel::new("torque", Unit::parse("N*m").unwrap(), time.clone(), torque),
        Channel::new("angle", Unit::parse("rad").unwrap(), time, angle),
    ];
    diagnosed(&Model::parse(model).unwrap(), Recording::from_channels("shaft", channels).unwrap()).answer
}

#[test]
fn a_torque_of_many_teeth_is_named() {
    for (teeth, seed) in [(11.0, 1), (5.0, 2)] {
        let told = shaft(teeth, 0.03, seed);
        assert_eq!(told.verdict, Verdict::Named, "{teeth}: {}", told.says);
        let finding = &told.findings[0];
        assert_eq!((finding.code.as_str(), told.findings.len()), ("periodic-force", 1), "{}", told.says);
        let value = |name: &str| finding.parameters.iter().find(|p| p.name == name).unwrap().clone();
        let (n, sine, cosine) = (value("n"), value("A_sin"), value("A_cos"));
        assert!((n.value - teeth).abs() < 0.01, "{}", n.value);
        assert!((sine.value.hypot(cosine.value) - 0.03).abs() < 0.002, "{} {}", sine.value, cosine.value);
    }
}

#[test]
fn a_smooth_shaft_gets_no_name() {
    let told = shaft(11.0, 0.0, 3);
    assert_eq!((told.verdict, told.findings.len()), (Verdict::NothingMissing, 0), "{}", told.says);
}
