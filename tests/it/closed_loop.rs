//! A ship under autopilot: what nobody recorded goes round the loop and looks like a law of the rudder.

use crate::diagnose::diagnosed;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Recording};
use gyrospec::units::Unit;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// K. Nomoto's ship of one time constant.
const SHIP: &str = r#"
    name = "turn rate follows the rudder"
    [inputs]
    rudder = { unit = "deg" }
    [parameters]
    K = { value = 0.1, unit = "1/s", fit = true, min = 0.001, max = 1.0 }
    T = { value = 12.0, unit = "s", fit = true, min = 1.0, max = 200.0 }
    [states]
    psi = { rate = "r", unit = "rad", initial = "fit" }
    r = { rate = "(K*rudder - r)/T", unit = "rad/s", initial = "fit" }
    [outputs]
    heading = { equals = "psi", unit = "deg" }
"#;
const STEERED: &str = "follows what the model leaves of “heading”";

/// How the rudder is moved.
#[derive(Clone, Copy, PartialEq)]
enum Steering {
    Autopilot,
    Plan,
}

/// Half an hour of 15 r' + r = 0.08 δ − q r|r| in waves of so many deg/s² around 0.6 rad/s, the rudder set each second.
fn found(steering: Steering, waves: f64, q: f64) -> Answer {
    let mut rng = ChaCha8Rng::seed_from_u64(23);
    let (mut psi, mut r, mut course, mut rudder) = (0.0, 0.0, 0.0, 0.0);
    let mut wave = [0.0, 0.0];
    let (mut set, mut shown) = (Vec::new(), Vec::new());
    for second in 0..1800usize {
        if second.is_multiple_of(120) {
            course += rng.random_range(-30.0..30.0);
        }
        let mut drawn = || -> f64 { StandardNormal.sample(&mut rng) };
        let seen = psi + 0.05 * drawn();
        rudder = match steering {
            Steering::Autopilot => (1.2 * (course - seen) - 12.0 * r).clamp(-25.0, 25.0),
            Steering::Plan if second.is_multiple_of(20) => 10.0 * drawn(),
            Steering::Plan => rudder,
        };
        set.push(rudder);
        shown.push(seen);
        let steps = 50;
        let h = 1.0 / f64::from(steps);
        for _ in 0..steps {
            // white noise through a lightly damped swing
            let push = drawn() / h.sqrt();
            wave[1] += h * (push - 0.36 * wave[0] - 0.1 * wave[1]);
            wave[0] += h * wave[1];
            psi += h * r;
            r += h * ((0.08 * rudder - r - q * r * f64::abs(r)) / 15.0 + waves * wave[0]);
        }
    }
    let time: Vec<f64> = (0..shown.len()).map(|i| i as f64).collect();
    let channel = |name: &str, values: Vec<f64>, hold| {
        let unit = Unit::parse("deg").unwrap();
        let values = values.into_iter().map(|x| unit.to_si(x)).collect();
        Channel { hold, ..Channel::new(name, unit, time.clone(), values) }
    };
    let channels = vec![channel("rudder", set, Hold::Previous), channel("heading", shown, Hold::Linear)];
    let recording = Recording::from_channels("voyage", channels).unwrap();
    diagnosed(&Model::parse(SHIP).unwrap(), recording).answer
}

fn is_named(answer: &Answer) -> bool {
    matches!(answer.verdict, Verdict::Named | Verdict::Tie)
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn waves_that_an_autopilot_answers_are_no_law_of_the_rudder() {
    for waves in [0.002, 0.005, 0.01] {
        let answer = found(Steering::Autopilot, waves, 0.0);
        assert!(!is_named(&answer), "{waves}: {}", answer.says);
        let is_told = answer.notes.iter().any(|n| n.contains(STEERED)) || answer.unexplained.is_some();
        assert!(is_told || waves < 0.005, "{waves}: {:?}", answer.notes);
    }
}

#[test]
fn on_a_rudder_moved_by_a_plan_they_are_no_law_either_and_nobody_steers_by_them() {
    let answer = found(Steering::Plan, 0.005, 0.0);
    assert!(!is_named(&answer), "{}", answer.says);
    assert!(!answer.notes.iter().any(|n| n.contains(STEERED)), "{:?}", answer.notes);
}

/// In still water the loop is closed by the noise of the compass alone.
#[test]
fn a_damping_in_a_closed_loop_keeps_its_name() {
    let answer = found(Steering::Autopilot, 0.0, 3.0);
    assert!(is_named(&answer), "{}", answer.says);
    assert_eq!(answer.findings[0].code, "quadratic-damping", "{}", answer.says);
    assert!(!answer.notes.iter().any(|n| n.contains(STEERED)), "{:?}", answer.notes);
}

#[test]
fn a_closed_loop_from_which_nothing_is_missing_lacks_nothing() {
    let answer = found(Steering::Autopilot, 0.0, 0.0);
    assert_eq!(answer.verdict, Verdict::NothingMissing, "{}", answer.says);
}
