//! What is left over and steps, or hardly ever forgets, is no noise, however well a noise model follows it.

use super::{diagnosed, recording};
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::diagnose::laboratory::Stepper;
use gyrospec::model::{Initial, Model};
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;

/// A vessel that is heated, in a room of known temperature; one sample a second.
const VESSEL: &str = r#"
    name = "heated vessel"
    [inputs]
    power = { unit = "W" }
    [parameters]
    C = { value = 60, unit = "J/K", fit = true, min = 1, max = 1e6 }
    k = { value = 5, unit = "W/K", fit = true, min = 0, max = 1e3 }
    [states]
    T = { rate = "(power - k*T)/C", unit = "K", initial = "fit" }
    [outputs]
    rise = { equals = "T", unit = "K" }
"#;

/// Normal noise of lag-one correlation φ, from a small congruential generator.
fn noise(n: usize, mut seed: u64, phi: f64) -> Vec<f64> {
    let mut uniform = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut e = 0.0;
    let mut next = || {
        e = phi * e + (1.0 - phi * phi).sqrt() * (0..12).map(|_| uniform()).sum::<f64>();
        e
    };
    (0..200).for_each(|_| {
        next();
    });
    (0..n).map(|_| next()).collect()
}

/// The vessel under a heater that is switched, run by another stepper, with noise of 0.05 K of lag-one
/// correlation φ and an error of its sensor in time.
fn vessel(phi: f64, seed: u64, error: impl Fn(f64) -> f64) -> Answer {
    let model = Model::parse(VESSEL).unwrap();
    let mut truth = model.clone();
    truth.states[0].initial = Initial::Number(0.0);
    let time: Vec<f64> = (0..2000).map(f64::from).collect();
    let power = time.iter().map(|t| 100.0 + 60.0 * (t / 37.0).sin() + 50.0 * (t / 11.0).sin()).collect();
    let channel =
        |name: &str, unit: &str, values| Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values);
    let channels = vec![channel("power", "W", power), channel("rise", "K", vec![0.0; time.len()])];
    let mut made = Recording::from_channels("vessel", channels).unwrap();
    let rise = Stepper::new(&truth, &made).unwrap().outputs(&time).remove(0);
    let e = noise(time.len(), seed, phi);
    made.channels[1].values = (0..time.len()).map(|i| rise[i] + 0.05 * e[i] + error(time[i])).collect();
    diagnosed(&model, made).answer
}

fn steps(a: &Answer, output: &str) {
    assert_eq!(a.verdict, Verdict::Unknown, "{}", a.says);
    assert!(a.says.contains("steps by") && a.findings.is_empty(), "{}", a.says);
    assert!(a.detection.p_value < 1e-3, "{:?}", a.detection.p_value);
    assert_eq!(
        (a.located.sites.len(), a.located.sites[0].name.as_str()),
        (1, output),
        "{:?}",
        a.located.sites
    );
}

#[test]
fn a_sensor_whose_zero_goes_to_and_fro_is_no_noise() {
    for (seed, phi) in [(11, 0.0), (12, 0.5)] {
        let a = vessel(phi, seed, |t| if t % 700.0 < 350.0 { 0.0 } else { 0.9 });
        steps(&a, "rise");
    }
}

/// Coloured noise of lag-one correlation 0.9 on an axis of two states; the zero steps by six deviations in the last
/// forty fitted samples.
#[test]
fn a_zero_that_steps_is_named_under_coloured_noise() {
    let (model, mut made) = recording(None);
    let position = made.channels.iter_mut().find(|c| c.name == "position").unwrap();
    let (at, size) = (1400, {
        let square: f64 = position.values.iter().map(|v| v * v).sum();
        0.06 * (square / position.values.len() as f64).sqrt()
    });
    position.values[at..].iter_mut().for_each(|v| *v += size);
    let moment = position.time[at];
    let a = diagnosed(&model, made).answer;
    assert_eq!(a.verdict, Verdict::Named, "{}", a.says);
    let first = &a.findings[0];
    assert_eq!(
        (a.findings.len(), first.code.as_str(), first.site.name.as_str()),
        (1, "output-offset", "position")
    );
    let (b, time) = (&first.parameters[0], &first.parameters[1]);
    assert!((b.value - size).abs() < 0.2 * size && b.low < size && b.high > size, "{b:?} {size}");
    assert!(time.low > moment - 0.03 && time.high < moment + 1e-9, "{time:?} {moment}");
}

#[test]
fn a_sensor_that_warms_up_is_not_told_from_slow_noise() {
    let a = vessel(0.0, 12, |t| 2.0 * (-t / 400.0).exp() - 0.5 * (t / 900.0).sin());
    assert!(!matches!(a.verdict, Verdict::NothingMissing), "{}", a.says);
}

/// One of eight may fail by a test at a level of 1 %.
#[test]
fn noise_of_the_colours_that_are_promised_lacks_nothing() {
    let cases = (0..8).map(|k| (k, [0.0, 0.5, 0.9, 0.95][k as usize % 4]));
    let says: Vec<String> = cases
        .map(|(seed, phi)| vessel(phi, 100 + seed, |_| 0.0))
        .filter(|a| a.verdict != Verdict::NothingMissing)
        .map(|a| a.says)
        .collect();
    assert!(says.len() <= 1, "{says:?}");
}
