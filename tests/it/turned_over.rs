//! An input of the wrong sign beside a stronger one, and a coupling that is no sign.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// A mass on a spring, its laws in definitions of their own or written where they act.
const NAMED: &str = r#"
    name = "mass on a shaking base"
    [inputs]
    F = { unit = "N" }
    a = { unit = "m/s^2" }
    [parameters]
    m = { value = 1.8, unit = "kg", fit = true, min = 0.1, max = 20.0 }
    c = { value = 2.5, unit = "N*s/m", fit = true, min = 0.0, max = 100.0 }
    k = { value = 70.0, unit = "N/m", fit = true, min = 1.0, max = 1000.0 }
    [definitions]
    spring = { equals = "k*q", unit = "N" }
    damp = { equals = "c*w", unit = "N" }
    [states]
    q = { rate = "w", unit = "m", initial = "fit" }
    w = { rate = "(F - damp - spring)/m - a", unit = "m/s", initial = "fit" }
    [outputs]
    x = { equals = "q", unit = "mm" }
"#;
const STEP: f64 = 0.02;

fn written_out() -> String {
    let (head, rest) = NAMED.split_once("[definitions]").unwrap();
    let states = rest.split_once("[states]").unwrap().1;
    format!("{head}[states]{}", states.replace("damp - spring", "c*w - k*q"))
}

/// What is said of 2 q'' = F − 3 q' − 80 q − 2 s a, of which a is recorded.
fn found(model: &str, s: f64) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut drawn = || -> f64 { StandardNormal.sample(&mut rng) };
    let (mut q, mut w, mut force, mut base) = (0.0f64, 0.0f64, 0.0, 0.0);
    let (mut forces, mut bases, mut shown) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..2000 {
        let ends = (0.9 * force + 8.0 * drawn(), 0.85 * base + 0.8 * drawn());
        forces.push(force);
        bases.push(base);
        shown.push(q + 0.004 * drawn());
        let steps = 40;
        let h = STEP / f64::from(steps);
        for i in 0..steps {
            let at = |share: f64| {
                let f = (f64::from(i) + share) / f64::from(steps);
                (force + f * (ends.0 - force), base + f * (ends.1 - base))
            };
            let rate = |(f, a): (f64, f64), q: f64, w: f64| (f - 3.0 * w - 80.0 * q) / 2.0 - s * a;
            let (dq, dw) = (w, rate(at(0.0), q, w));
            let (hq, hw) = (q + 0.5 * h * dq, w + 0.5 * h * dw);
            (q, w) = (q + h * hw, w + h * rate(at(0.5), hq, hw));
        }
        (force, base) = ends;
    }
    let time: Vec<f64> = (0..shown.len()).map(|i| STEP * i as f64).collect();
    let channel = |name: &str, unit: &str, values: Vec<f64>| {
        Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
    };
    let channels = vec![channel("F", "N", forces), channel("a", "m/s^2", bases), channel("x", "mm", shown)];
    let recording = Recording::from_channels("mass", channels).unwrap();
    diagnosed(&Model::parse(model).unwrap(), recording).answer
}

#[test]
fn an_input_of_the_wrong_sign_is_that_however_the_model_is_written() {
    for model in [NAMED.to_owned(), written_out()] {
        let answer = found(&model, -1.0);
        let [fault] = &answer.faults[..] else { panic!("{}", answer.says) };
        let (code, name) = (fault.finding.code.as_str(), fault.finding.site.name.as_str());
        assert_eq!((code, name, fault.masked), ("wrong-sign", "a", true), "{}", answer.says);
        assert!(answer.findings.iter().all(|f| f.code == "wrong-sign"), "{:?}", answer.findings);
        assert_eq!(answer.verdict, Verdict::DataFault, "{}", answer.says);
        assert!((answer.proof[0].holdout_after / 4.0 - 1.0).abs() < 0.1, "{:?}", answer.proof);
    }
}

/// Turned over and of another size it is a law that acts by 1.4 m/m, no sign.
#[test]
fn a_base_that_acts_the_other_way_by_another_size_is_a_coupling() {
    let answer = found(NAMED, -0.4);
    assert!(answer.faults.is_empty(), "{}", answer.says);
    assert_eq!(answer.findings.len(), 1, "{}", answer.says);
    assert!(matches!(answer.verdict, Verdict::Named | Verdict::Tie), "{}", answer.says);
    assert_eq!(answer.findings[0].code, "cross-coupling", "{}", answer.says);
}

#[test]
fn a_base_that_acts_as_recorded_lacks_nothing() {
    let answer = found(NAMED, 1.0);
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
}
