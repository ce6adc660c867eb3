//! Forces that repeat with a position are named at any number of periods.

use crate::diagnose::{diagnosed, noise};
use crate::laws_met::runge_kutta;
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
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
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

/// A motor with seven teeth of 0.006 N m, whose angle is read to a twelfth of a radian only, in four seconds: had been found to lack nothing.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn teeth_of_a_motor_whose_angle_is_read_coarsely() {
    const COUNT: usize = 3500;
    let model = r#"
        name = "motor"
        [inputs]
        voltage = { unit = "V" }
        [parameters]
        R = { value = 1.3, unit = "V/A", fit = true, min = 0.05 }
        L = { value = 0.0023, unit = "V*s/A", fit = true, min = 1e-4 }
        k = { value = 0.055, unit = "N*m/A", fit = true, min = 1e-3 }
        J = { value = 3.3e-4, unit = "kg*m^2", fit = true, min = 1e-5 }
        b = { value = 2.7e-4, unit = "N*m*s", fit = true, min = 1e-6 }
        [definitions]
        ke = { equals = "k", unit = "V*s" }
        [states]
        cur = { rate = "(voltage - R*cur - ke*w)/L", unit = "A", initial = 0.0 }
        w = { rate = "(k*cur - b*w)/J", unit = "rad/s", initial = 0.0 }
        th = { rate = "w", unit = "rad", initial = 0.0 }
        [outputs]
        current = { equals = "cur", unit = "A" }
        angle = { equals = "th", unit = "rad" }
    "#;
    let time: Vec<f64> = (0..COUNT).map(|i| 0.002 * i as f64).collect();
    let volts = |t: f64| 1.1 + 0.7 * (2.3 * t).sin() + 0.5 * (5.9 * t + 1.0).sin() + 0.2 * (17.0 * t).sin();
    let states = runge_kutta(
        (0.002, COUNT, 10),
        |t| [volts(t)],
        |[i, w, th]: [f64; 3], [u]| {
            let teeth = 0.006 * (7.0 * th + 0.4).sin();
            [(u - 1.2 * i - 0.05 * w) / 0.002, (0.05 * i - 3e-4 * w - teeth) / 4e-4, w]
        },
    );
    let read = |of: usize, size: f64, seed: u64| -> Vec<f64> {
        states.iter().zip(noise(COUNT, seed)).map(|(x, e)| x[of] + size * e).collect()
    };
    let channel =
        |name: &str, unit: &str, values| Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values);
    let channels = vec![
        channel("voltage", "V", time.iter().map(|t| volts(*t)).collect()),
        channel("current", "A", read(0, 0.0025, 8)),
        channel("angle", "rad", read(2, 0.085, 9)),
    ];
    let told =
        diagnosed(&Model::parse(model).unwrap(), Recording::from_channels("motor", channels).unwrap()).answer;
    assert_eq!(told.verdict, Verdict::Named, "{}", told.says);
    let finding = &told.findings[0];
    assert_eq!((finding.code.as_str(), told.findings.len()), ("periodic-force", 1), "{}", told.says);
    let value = |name: &str| finding.parameters.iter().find(|p| p.name == name).unwrap().value;
    assert!((value("n") - 7.0).abs() < 0.02, "{}", value("n"));
    assert!((value("A_sin").hypot(value("A_cos")) - 0.006).abs() < 6e-4, "{}", told.says);
}
