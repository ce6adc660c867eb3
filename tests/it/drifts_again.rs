//! What drifts after every start, which a recording that was held out apart and begins anew confirms, and what drifted once.

use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::diagnose::{Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::units::Unit;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const STEP: f64 = 20.0;
const ROWS: usize = 1600;

/// A heated store, C T' = P − k (1 + a t) (T − Ta), whose loss changes by a a second, with 0.05 K of noise.
fn store(a: f64, seed: u64) -> Recording {
    changing(|t| a * t, seed)
}

/// The same with any change of its loss in time.
fn changing(a: impl Fn(f64) -> f64, seed: u64) -> Recording {
    let (c, k, around) = (4e5, 90.0, 288.15);
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let time: Vec<f64> = (0..ROWS).map(|i| STEP * i as f64).collect();
    let mut level = 2000.0;
    let power: Vec<f64> = (0..ROWS)
        .map(|i| {
            if i % 60 == 0 {
                level = rng.random_range(500.0..4000.0);
            }
            level
        })
        .collect();
    let mut now = 305.0;
    let mut shown = Vec::with_capacity(ROWS);
    for i in 0..ROWS {
        let noise: f64 = StandardNormal.sample(&mut rng);
        shown.push(now + 0.05 * noise);
        let next = power[(i + 1).min(ROWS - 1)];
        // a hundred steps of Euler's method, inputs on the line between samples
        for s in 0..100 {
            let share = f64::from(s) / 100.0;
            let heat = power[i] + (next - power[i]) * share;
            let loss = k * (1.0 + a(time[i] + share * STEP));
            now += STEP / 100.0 * (heat - loss * (now - around)) / c;
        }
    }
    let channel =
        |name: &str, unit: &str, values| Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values);
    let channels = vec![channel("P", "W", power), channel("T", "K", shown)];
    Recording::from_channels("store", channels).unwrap()
}

fn told(fitted: f64, held_out: f64, seed: u64) -> Answer {
    told_of(store(fitted, seed), store(held_out, seed + 1000))
}

fn told_of(fitted: Recording, held_out: Recording) -> Answer {
    let model = Model::parse(
        r#"
        name = "store"
        [inputs]
        P = { unit = "W" }
        [parameters]
        C = { value = 3e5, unit = "J/K", fit = true, min = 0 }
        k = { value = 70, unit = "W/K", fit = true, min = 0 }
        Ta = { value = 288.15, unit = "K" }
        [states]
        theta = { rate = "(P - k*(theta - Ta))/C", unit = "K", initial = "fit" }
        [outputs]
        T = { equals = "theta", unit = "K" }
        "#,
    )
    .unwrap();
    let (recordings, separate) = ([fitted], [held_out]);
    let request = Request {
        model: &model,
        source: None,
        recordings: &recordings,
        separate: &separate,
        seed: 1,
        time_limit: None,
        progress: &Silent,
    };
    diagnose(&request).unwrap().answer
}

/// −20 % in the 32 000 s of a recording.
const FALL: f64 = -0.2 / 32_000.0;

#[test]
fn what_drifts_after_every_start_is_named() {
    let told = told(FALL, FALL, 1);
    assert!(matches!(told.verdict, Verdict::Named | Verdict::Tie), "{}", told.says);
    let [one] = told.findings.as_slice() else { panic!("{}", told.says) };
    assert_eq!((one.code.as_str(), one.site.name.as_str()), ("parameter-drift", "k"), "{}", told.says);
    // the middle of what was recorded is where the drift is told
    let wanted = FALL / (1.0 + FALL * 0.5 * STEP * ROWS as f64);
    let a = &one.parameters[0];
    assert!((a.value / wanted - 1.0).abs() < 0.05, "{} for {wanted}", a.value);
    assert!(told.proof[0].holdout_after < 0.2 * told.proof[0].holdout_before, "{}", told.says);
}

#[test]
fn what_drifted_once_is_not() {
    let told = told(FALL, 0.0, 2);
    assert_ne!(told.verdict, Verdict::NothingMissing, "{}", told.says);
    let is_named = matches!(told.verdict, Verdict::Named | Verdict::Tie);
    assert!(!is_named || told.findings.iter().all(|f| f.code != "parameter-drift"), "{}", told.says);
}

/// A loss that is larger by a quarter from 17 000 s of the fitted recording on, and all along in what was made after it, or not
/// yet in what was made before.
#[test]
fn what_changed_at_a_moment_is_shown_by_what_was_made_after_and_before() {
    let changed = |t: f64| if t > 17_000.0 { 0.25 } else { 0.0 };
    for (after, words) in [(0.25, "as after tc"), (0.0, "as before tc")] {
        let answer = told_of(changing(changed, 5), changing(move |_| after, 1005));
        assert_eq!(answer.verdict, Verdict::Named, "{}", answer.says);
        assert_eq!(answer.findings.len(), 1, "{}", answer.says);
        let finding = &answer.findings[0];
        assert_eq!((finding.code.as_str(), finding.site.name.as_str()), ("parameter-change", "k"));
        let value = |name: &str| finding.parameters.iter().find(|p| p.name == name).unwrap().value;
        assert!(
            (value("a") - 0.25).abs() < 0.01 && (value("tc") - 17_000.0).abs() < 200.0,
            "{}",
            answer.says
        );
        assert!(answer.notes.iter().any(|n| n.contains(words)), "{:?}", answer.notes);
    }
}

/// What changed in the fitted recording and is neither as before nor as after in the other is confirmed by nothing.
#[test]
fn what_changed_once_and_has_gone_another_way_since_is_no_name() {
    let changed = |t: f64| if t > 17_000.0 { 0.25 } else { 0.0 };
    let answer = told_of(changing(changed, 7), changing(|_| -0.3, 1007));
    assert_ne!(answer.verdict, Verdict::Named, "{}", answer.says);
}
