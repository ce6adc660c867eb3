//! An input of a slow instrument whose last value stands in every row of a quick table, beside one that is held in truth.

use crate::diagnose::{diagnosed, noise};
use crate::laws_met::runge_kutta;
use gyrospec::diagnose::answer::{Answer, Verdict};
use gyrospec::diagnose::{Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::record::Channel;
use gyrospec::{Model, Recording, Unit};
use std::f64::consts::TAU;

const ROOM: &str = r#"
    name = "room"
    [inputs]
    P = { unit = "W" }
    outside = { unit = "K" }
    [parameters]
    R = { value = 0.018, unit = "K/W", fit = true, min = 0 }
    tau = { value = 130, unit = "s", fit = true, min = 1 }
    [states]
    T = { rate = "(R*P + outside - T)/tau", unit = "K", initial = "fit" }
    [outputs]
    inside = { equals = "T", unit = "K" }
"#;
const STEP: f64 = 5.0;
const COUNT: usize = 2400;
/// Rows in which one value of the slow instrument stands.
const ROWS: f64 = 8.0;

fn outside(t: f64) -> f64 {
    280.0 + 4.0 * (TAU * t / 4900.0).sin() + 3.0 * (TAU * t / 1300.0 + 1.0).sin()
}

/// The last of the times at which the slow instrument reads.
fn last_read(t: f64) -> f64 {
    ((t / (ROWS * STEP) + 1e-9).floor()) * ROWS * STEP
}

/// A room beside air that is as it is, or that a machine holds between readings.
fn room(is_held: bool) -> Recording {
    let power = |t: f64| if (t / 400.0).sin() + (t / 170.0).sin() > 0.3 { 900.0 } else { 100.0 };
    let air = |t: f64| if is_held { outside(last_read(t)) } else { outside(t) };
    let states = runge_kutta(
        (STEP, COUNT, 10),
        |t| [power(STEP * (t / STEP + 1e-9).floor()), air(t)],
        |[x]: [f64; 1], [p, a]| [(0.02 * p + a - x) / 120.0],
    );
    let time: Vec<f64> = (0..COUNT).map(|i| STEP * i as f64).collect();
    let unit = |text: &str| Unit::parse(text).unwrap();
    let inside = states.iter().zip(noise(COUNT, 5)).map(|([x], e)| x + 0.1 * e).collect();
    let power =
        Channel::new("P", unit("W"), time.clone(), time.iter().map(|t| power(*t)).collect::<Vec<_>>());
    let read = time.iter().map(|t| outside(last_read(*t))).collect();
    let channels = vec![
        power,
        Channel::new("outside", unit("K"), time.clone(), read),
        Channel::new("inside", unit("K"), time, inside),
    ];
    Recording::from_channels("week", channels).unwrap()
}

/// The rows of a recording that are kept.
fn rows(whole: &Recording, is_kept: impl Fn(usize) -> bool) -> Recording {
    let kept: Vec<usize> = (0..COUNT).filter(|i| is_kept(*i)).collect();
    let time: Vec<f64> = kept.iter().map(|i| STEP * *i as f64).collect();
    let cut = |c: &Channel| {
        Channel::new(&c.name, c.unit.clone(), time.clone(), kept.iter().map(|i| c.values[*i]).collect())
    };
    Recording::from_channels(&whole.name, whole.channels.iter().map(cut).collect()).unwrap()
}

fn is_told(a: &Answer) -> bool {
    a.notes.iter().any(|n| n.contains("outside was recorded every 40 s and repeated in between"))
}

#[test]
fn a_slow_input_that_is_repeated_in_a_quick_table_runs_straight() {
    let model = Model::parse(ROOM).unwrap();
    let a = diagnosed(&model, room(false)).answer;
    assert_eq!(a.verdict, Verdict::NothingMissing, "{}", a.says);
    assert!(is_told(&a), "{:?}", a.notes);
    let a = diagnosed(&model, room(true)).answer;
    assert!(a.findings.is_empty() && !is_told(&a), "{} {:?}", a.says, a.notes);
}

#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_repeated_input_runs_straight_beside_lost_rows_and_in_what_is_held_out() {
    let (model, whole) = (Model::parse(ROOM).unwrap(), room(false));
    let a =
        diagnosed(&model, rows(&whole, |i| !(700..760).contains(&i) && !(1303..1309).contains(&i))).answer;
    assert_eq!(a.verdict, Verdict::NothingMissing, "{}", a.says);
    assert!(is_told(&a), "{:?}", a.notes);
    // too short for a grid of its own
    let short = rows(&whole, |i| i >= COUNT - 140);
    let request = Request {
        model: &model,
        source: None,
        recordings: &[rows(&whole, |i| i < COUNT - 140)],
        separate: &[short],
        time_limit: None,
        seed: 1,
        progress: &Silent,
    };
    let a = diagnose(&request).unwrap().answer;
    assert!(is_told(&a) && a.findings.is_empty(), "{} {:?}", a.says, a.notes);
    // the noise is 0.1 K, and what the steps of a repeated input leave is 0.05
    assert!(a.proof[0].holdout_before < 0.105, "{:?}", a.proof[0]);
}
