//! Fit and proof change places where the earlier part does not show what the later one does.

use crate::diagnose::diagnosed;
use crate::held_inputs::AXIS;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording, Span};
use gyrospec::units::Unit;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const STEP: f64 = 0.02;
const COUNT: usize = 6000;

/// The force, straight between samples, with its size after the first 60 % of the time.
fn force(t: f64, later: f64) -> f64 {
    let before = (t / STEP + 1e-9).floor() * STEP;
    let at = |t| sampled(t, later);
    at(before) + (at(before + STEP) - at(before)) * ((t - before) / STEP)
}

/// The force at a sample.
fn sampled(t: f64, later: f64) -> f64 {
    let size = if t < 0.6 * STEP * COUNT as f64 { 0.2 } else { later };
    size * ((1.3 * t).sin() + (3.1 * t).sin() + (5.3 * t).cos())
}

/// The axis with a spring that stiffens by k3·q³, solved by Runge and Kutta's method at a tenth of a sample; M = 2.2,
/// b = 2.5, k = 70, noise of 50 um, in the later part as many times that.
fn recorded(k3: f64, spans: Option<[Span; 2]>, sizes: (f64, f64)) -> Answer {
    recorded_of(|force, q| force - k3 * q.powi(3), spans, sizes)
}

/// The same with what acts on it beside damping and spring, of force and position.
fn recorded_of(
    acts: impl Fn(f64, f64) -> f64,
    spans: Option<[Span; 2]>,
    (later, noisier): (f64, f64),
) -> Answer {
    let force = |t| force(t, later);
    let rate = |t: f64, [q, v]: [f64; 2]| [v, (acts(force(t), q) - 2.5 * v - 70.0 * q) / 2.2];
    let add = |[q, v]: [f64; 2], h: f64, [a, b]: [f64; 2]| [q + h * a, v + h * b];
    let (mut state, mut position, h) = ([0.0, 0.0], Vec::new(), STEP / 10.0);
    for i in 0..10 * COUNT {
        if i % 10 == 0 {
            position.push(state[0]);
        }
        let t = h * i as f64;
        let a = rate(t, state);
        let b = rate(t + h / 2.0, add(state, h / 2.0, a));
        let c = rate(t + h / 2.0, add(state, h / 2.0, b));
        let d = rate(t + h, add(state, h, c));
        let mean = |k: usize| (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]) / 6.0;
        state = add(state, h, [mean(0), mean(1)]);
    }
    let mut rng = ChaCha8Rng::seed_from_u64(81);
    let mut noise = || -> f64 { 5e-5 * Distribution::<f64>::sample(&StandardNormal, &mut rng) };
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let unit = |text| Unit::parse(text).unwrap();
    let input = Channel::new("F", unit("N"), time.clone(), time.iter().map(|t| force(*t)).collect());
    let times = |i: usize| if i < COUNT * 6 / 10 { 1.0 } else { noisier };
    let measured = position.iter().enumerate().map(|(i, q)| q + times(i) * noise()).collect();
    let output = Channel::new("position", unit("m"), time, measured);
    let made = Recording::from_channels("axis", vec![input, output]).unwrap();
    let made = match spans {
        Some([fit, holdout]) => made.with_spans(vec![fit], vec![holdout]),
        None => made,
    };
    diagnosed(&Model::parse(AXIS).unwrap(), made).answer
}

/// A force 40 times larger in the later part, with the same noise.
const LARGE: (f64, f64) = (8.0, 1.0);

fn says_so(told: &Answer) -> bool {
    told.notes.iter().any(|n| n.contains("changed places"))
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn what_only_the_later_part_shows_is_named_there_and_proved_on_the_earlier() {
    let told = recorded(400.0, None, LARGE);
    assert_eq!(told.verdict, Verdict::Named, "{}", told.says);
    let first = &told.findings[0];
    assert_eq!(first.code, "cubic-stiffness", "{}", told.says);
    assert!(says_so(&told), "{:?}", told.notes);
    let k3 = first.parameters.iter().find(|p| p.unit.starts_with("N/m^3")).unwrap();
    assert!(k3.low < 400.0 && 400.0 < k3.high, "{k3:?}");
    assert!(told.proof[0].improvement_low > 0.0, "{:?}", told.proof);
}

#[test]
fn spans_that_are_given_stay() {
    let end = STEP * COUNT as f64;
    let told = recorded(400.0, Some([Span::new(0.0, 0.6 * end), Span::new(0.6 * end, end)]), LARGE);
    assert!(!says_so(&told));
    assert!(told.findings.is_empty() && told.verdict == Verdict::NotIdentifiable, "{}", told.says);
}

#[test]
fn nothing_changes_places_where_nothing_is_missing() {
    let told = recorded(0.0, None, LARGE);
    assert_eq!((told.verdict, says_so(&told)), (Verdict::NothingMissing, false), "{}", told.says);
}

#[test]
fn what_the_later_part_shows_about_its_noise_is_named_there() {
    let told = recorded(4.0, None, (1.6, 1.0));
    assert!(matches!(told.verdict, Verdict::Named | Verdict::Tie), "{}", told.says);
    let first = &told.findings[0];
    assert!(
        first.code == "cubic-stiffness" || first.ties.iter().any(|t| t == "cubic-stiffness"),
        "{}",
        told.says
    );
    assert!(says_so(&told), "{:?}", told.notes);
}

#[test]
fn a_later_part_with_more_noise_misses_nothing() {
    let told = recorded(0.0, None, (1.6, 3.0));
    assert_eq!((told.verdict, says_so(&told)), (Verdict::NothingMissing, false), "{}", told.says);
}

/// What the earlier part names stays, and what only the later one shows comes to it.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_limit_that_only_the_later_part_reaches_stands_beside_what_acts_all_the_time() {
    let told = recorded_of(|force, _| force.clamp(-1.2, 1.2) + 0.1, None, (0.8, 1.0));
    let names: Vec<&str> = told.findings.iter().map(|f| &*f.code).collect();
    assert!(matches!(told.verdict, Verdict::Named | Verdict::Tie) && says_so(&told), "{}", told.says);
    assert_eq!(names.len(), 2, "{}", told.says);
    let limit = told.findings.iter().find(|f| f.code == "input-saturation").unwrap();
    assert!(limit.parameters[0].low < 1.2 && 1.2 < limit.parameters[0].high, "{}", told.says);
    assert!(
        ["constant-force", "input-offset", "output-offset"].iter().any(|n| names.contains(n)),
        "{names:?}"
    );
}
