//! The diagnosis where recordings have gaps, where candidates cannot be run, and where a fit turns stiff.

use super::diagnose::{diagnosed, noise};
use gyrospec::ErrorKind;
use gyrospec::diagnose::answer::Verdict;
use gyrospec::diagnose::laboratory::Stepper;
use gyrospec::diagnose::{Diagnosis, Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::expression::Expr;
use gyrospec::model::{Initial, Model};
use gyrospec::record::{Channel, Recording};
use gyrospec::simulate::Early;
use gyrospec::units::Unit;
use std::time::Duration;

const MOTOR: &str = r#"
    name = "motor"
    [inputs]
    u = { unit = "V" }
    [parameters]
    T = { value = 0.1, unit = "s", fit = true, min = 1e-3, max = 1e2 }
    K = { value = 5, unit = "rad/s/V", fit = true }
    [states]
    w = { rate = "(K*u - w)/T", unit = "rad/s", initial = 30 }
    [outputs]
    speed = { equals = "w", unit = "rpm" }
"#;

fn channel(name: &str, unit: &str, time: &[f64], of: impl Fn(f64) -> f64) -> Channel {
    let values = time.iter().map(|t| of(*t)).collect();
    Channel::new(name, Unit::parse(unit).unwrap(), time.to_vec(), values)
}

fn clock(step: f64, samples: i32) -> Vec<f64> {
    (0..samples).map(|i| step * f64::from(i)).collect()
}

fn voltage(t: f64) -> f64 {
    8.0 + 2.0 * (0.9 * t).sin() + 1.5 * (7.0 * t).sin() + (2.3 * t).cos()
}

/// The motor, run by another stepper, with noise of 1 % of its speed; then a model that is fitted to it from
/// a time constant thirty times too long.
fn motor(time: &[f64]) -> (Model, Vec<Channel>) {
    let mut model = Model::parse(MOTOR).unwrap();
    let channels = vec![channel("u", "V", time, voltage), channel("speed", "rpm", time, |_| 0.0)];
    let mut made = Recording::from_channels("motor", channels).unwrap();
    let speed = Stepper::new(&model, &made).unwrap().outputs(time).remove(0);
    for ((v, y), e) in made.channels[1].values.iter_mut().zip(speed).zip(noise(time.len(), 3)) {
        *v = y + 0.4 * e;
    }
    model.parameters[0].value = 3.0;
    model.states[0].initial = Initial::Fit;
    (model, made.channels)
}

/// A channel without the rows that are not wanted.
fn without_rows(c: &Channel, wanted: &dyn Fn(f64) -> bool) -> Channel {
    let kept = c.time.iter().zip(&c.values).filter(|(t, _)| wanted(**t));
    let (time, values): (Vec<f64>, Vec<f64>) = kept.map(|(t, v)| (*t, *v)).unzip();
    Channel::new(c.name.clone(), c.unit.clone(), time, values)
}

fn with_gaps(channels: &[Channel], gaps: &[(f64, f64)]) -> Recording {
    let wanted = |t: f64| !gaps.iter().any(|g| t >= g.0 && t < g.1);
    let channels = channels.iter().map(|c| without_rows(c, &wanted)).collect();
    Recording::from_channels("motor", channels).unwrap()
}

/// What is known of the motor comes out, and no physics beside it.
fn tells_of_the_gaps_alone(d: &Diagnosis) {
    let physics: Vec<&str> =
        d.answer.findings.iter().filter(|f| !f.is_fault()).map(|f| f.code.as_str()).collect();
    assert!(physics.is_empty(), "{physics:?} in {}", d.answer.says);
    let time = &d.after.parameters[0];
    assert!((time.value - 0.1).abs() < 0.01, "{time:?}");
}

#[test]
fn a_gap_of_inputs_and_outputs_does_not_end_a_diagnosis() {
    let (model, channels) = motor(&clock(0.01, 1150));
    tells_of_the_gaps_alone(&diagnosed(&model, with_gaps(&channels, &[(3.0, 3.5)])));
    let (model, channels) = motor(&clock(0.01, 4000));
    tells_of_the_gaps_alone(&diagnosed(&model, with_gaps(&channels, &[(10.0, 12.5)])));
}

#[test]
fn gaps_at_the_ends_over_the_border_and_around_single_samples_do_not_either() {
    let (model, channels) = motor(&clock(0.01, 1500));
    for gaps in [&[(-1.0, 0.7), (14.0, 16.0)][..], &[(8.8, 9.3)], &[(2.0, 2.4), (2.41, 2.9), (2.91, 3.3)]] {
        tells_of_the_gaps_alone(&diagnosed(&model, with_gaps(&channels, gaps)));
    }
}

const AXIS: &str = r#"
    name = "axis"
    [inputs]
    force = { unit = "N" }
    [parameters]
    M = { value = 3, unit = "kg", fit = true, min = 0.1, max = 100 }
    Fv = { value = 3, unit = "N*s/m", fit = true, min = 0, max = 1000 }
    k = { value = 100, unit = "N/m", fit = true, min = 0, max = 1e5 }
    [states]
    q = { rate = "v", unit = "m", initial = "fit" }
    v = { rate = "(force - Fv*v - k*q)/M", unit = "m/s", initial = "fit" }
    [outputs]
    position = { equals = "q", unit = "m" }
"#;

/// The axis under a force of three waves, run by another stepper, with noise of some size in m.
fn axis(model: &Model, size: f64, seed: u64) -> Recording {
    let time = clock(0.02, 1500);
    let force = |t: f64| 20.0 * (1.3 * t).sin() + 12.0 * (5.1 * t).sin() + 9.0 * (8.7 * t).cos();
    let mut truth = model.clone();
    truth.states.iter_mut().for_each(|s| s.initial = Initial::Number(0.0));
    let channels = vec![channel("force", "N", &time, force), channel("position", "m", &time, |_| 0.0)];
    let mut recording = Recording::from_channels("axis", channels).unwrap();
    let position = Stepper::new(&truth, &recording).unwrap().outputs(&time).remove(0);
    for ((v, y), e) in recording.channels[1].values.iter_mut().zip(position).zip(noise(time.len(), seed)) {
        *v = y + size * e;
    }
    recording
}

/// Under noise of 0.01 % a resonance that is not there is tried at a frequency that asks for fine steps, and
/// spends what one fit may: a name that has fallen out of the race, and no early end of the search.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn a_candidate_that_alone_spends_its_share_does_not_end_the_search() {
    let model = Model::parse(AXIS).unwrap();
    for (size, seed) in [(2e-5, 1), (1e-4, 1), (2e-5, 18), (2e-5, 22)] {
        let d = diagnosed(&model, axis(&model, size, seed));
        assert_eq!(d.answer.made.ended_early, None, "{:?}", d.answer.notes);
        assert_eq!(d.answer.verdict, Verdict::NothingMissing, "{}", d.answer.says);
    }
}

/// An axis on a spring whose force was not recorded for a while: its swing remembers the force that nobody
/// knows for many periods. Noise of 2 mm.
#[test]
fn what_remembers_a_gap_of_an_input_is_not_compared_and_no_law_is_seen_in_it() {
    let model = Model::parse(AXIS).unwrap();
    let mut recording = axis(&model, 0.002, 4);
    recording.channels[0] = without_rows(&recording.channels[0], &|t| !(4.0..4.6).contains(&t));
    let d = diagnosed(&model, recording);
    let physics: Vec<&str> =
        d.answer.findings.iter().filter(|f| !f.is_fault()).map(|f| f.code.as_str()).collect();
    assert!(physics.is_empty(), "{physics:?} in {}", d.answer.says);
    assert!((d.before.rmse[0] / 0.002 - 1.0).abs() < 0.1, "rmse {}", d.before.rmse[0]);
    assert!(d.answer.notes.iter().any(|n| n.contains("gap")), "{:?}", d.answer.notes);
    for (p, truth) in d.after.parameters.iter().zip([3.0, 3.0, 100.0]) {
        assert!((p.value / truth - 1.0).abs() < 0.03, "{p:?}");
    }
}

/// Of a second table that begins late, ends early and has a gap no sample may be compared by the one model
/// and not by the other.
#[test]
fn tables_of_other_rates_and_ends_are_compared_on_the_same_samples() {
    let (model, mut channels) = motor(&clock(0.01, 3000));
    let late: Vec<f64> = (0..144).map(|i| 0.6 + 0.2 * f64::from(i)).collect();
    let temperature = channel("temp", "K", &late, |t| 300.0 + 4.0 * (0.4 * t).sin());
    channels.push(without_rows(&temperature, &|t| !(5.0..6.3).contains(&t)));
    let recording = Recording::from_channels("motor", channels).unwrap();
    let d = diagnosed(&model, recording);
    tells_of_the_gaps_alone(&d);
    let first = d.before.records[0].series[0].time[0];
    assert!(first >= 0.6, "compared from {first} s on");
    let in_the_gap = |t: &&f64| (4.9..6.2).contains(*t);
    assert_eq!(d.before.records[0].series[0].time.iter().filter(in_the_gap).count(), 0);
}

/// A time constant that falls as the motor warms: the law is linear where it is fitted, but its straight line
/// crosses zero where it is held out.
#[test]
fn a_law_that_blows_up_where_it_is_held_out_is_no_finding() {
    let time = clock(0.02, 3000);
    let (mut model, mut channels) = motor(&time);
    let warm = |t: f64| if t < 36.0 { 4.0 + 4.0 * (0.5 * t).sin() } else { 8.0 + 10.0 * (t - 36.0) / 24.0 };
    channels.push(channel("temp", "K", &time, warm));
    let mut truth = Model::parse(MOTOR).unwrap();
    truth.inputs.push(gyrospec::model::Input {
        name: "temp".into(),
        unit: Unit::parse("K").unwrap(),
        meaning: None,
    });
    truth.parameters[0].value = 2.0;
    truth.states[0].rate = Expr::parse("(K*u - w)/(T*max(0.1, 1 - 0.1*temp))").unwrap();
    let made = Recording::from_channels("motor", channels).unwrap();
    let speed = Stepper::new(&truth, &made).unwrap().outputs(&time).remove(0);
    let mut recording = made.clone();
    for ((v, y), e) in recording.channels[1].values.iter_mut().zip(speed).zip(noise(time.len(), 9)) {
        *v = y + 0.02 * e;
    }
    model.parameters[0].value = 1.0;
    let d = diagnosed(&model, recording);
    let held = &d.answer.proof[0];
    assert!(held.holdout_before.is_finite() && held.holdout_after.is_finite(), "{held:?}");
    assert_ne!(d.answer.verdict, Verdict::NothingMissing, "{}", d.answer.says);
    let straight =
        |f: &gyrospec::diagnose::answer::Finding| f.code == "parameter-dependence" && f.site.name == "T";
    assert!(!d.answer.findings.iter().any(straight), "{}", d.answer.says);
}

/// The same where the straight line crosses zero far from what the outputs allow; the model's other laws do not
/// reach so far.
#[test]
fn a_law_that_cannot_be_run_where_it_is_held_out_is_said_and_not_taken_for_an_explanation() {
    let time = clock(0.02, 1500);
    let warm = |t: f64| if t < 18.0 { 2.0 * (0.7 * t).sin() } else { 7.0 * (18.0 - t) };
    let mut channels = vec![channel("u", "V", &time, voltage), channel("speed", "rpm", &time, |_| 0.0)];
    channels.push(channel("warm", "K", &time, warm));
    let mut model = Model::parse(MOTOR).unwrap();
    let mut truth = model.clone();
    truth.inputs.push(gyrospec::model::Input {
        name: "warm".into(),
        unit: Unit::parse("K").unwrap(),
        meaning: None,
    });
    truth.parameters[0].value = 0.5;
    truth.states[0].rate = Expr::parse("(K*u - w)/(T*max(0.1, 1 + 0.1*warm))").unwrap();
    let mut recording = Recording::from_channels("motor", channels).unwrap();
    let speed = Stepper::new(&truth, &recording).unwrap().outputs(&time).remove(0);
    for ((v, y), e) in recording.channels[1].values.iter_mut().zip(speed).zip(noise(time.len(), 10)) {
        *v = y + 0.02 * e;
    }
    model.parameters[0].value = 0.6;
    model.states[0].initial = Initial::Fit;
    let a = diagnosed(&model, recording).answer;
    assert_eq!(a.verdict, Verdict::Unknown, "{}", a.says);
    assert!(a.says.contains("goes with warm") && a.says.contains("cannot be run"), "{}", a.says);
    assert!(!a.says.contains("is explained") && a.findings.is_empty(), "{}", a.says);
    assert!(a.located.signals.iter().any(|s| s.name == "warm"), "{:?}", a.located);
    assert!(a.detection.p_value < 1e-3 && a.next_experiment.is_some_and(|n| n.contains("warm")));
}

const ROOM: &str = r#"
    name = "room"
    [inputs]
    power = { unit = "W" }
    outside = { unit = "degC" }
    [parameters]
    Ca = { value = 6e4, unit = "J/K" }
    Ch = { value = 2e3, unit = "J/K", fit = true, min = 1e-3, max = 1e8 }
    Cs = { value = 3e3, unit = "J/K", fit = true, min = 1e-3, max = 1e8 }
    Cw = { value = 4e5, unit = "J/K" }
    Co = { value = 9e5, unit = "J/K" }
    Cf = { value = 1e5, unit = "J/K" }
    Ghs = { value = 4, unit = "W/K" }
    Gsa = { value = 6, unit = "W/K" }
    Gaw = { value = 60, unit = "W/K" }
    Gwo = { value = 40, unit = "W/K" }
    Goe = { value = 30, unit = "W/K" }
    Gaf = { value = 20, unit = "W/K" }
    [states]
    air = { rate = "(Gsa*(shell - air) + Gaw*(wall - air) + Gaf*(goods - air))/Ca", unit = "degC", initial = "fit" }
    heater = { rate = "(power - Ghs*(heater - shell))/Ch", unit = "degC", initial = "fit" }
    shell = { rate = "(Ghs*(heater - shell) - Gsa*(shell - air))/Cs", unit = "degC", initial = "fit" }
    wall = { rate = "(Gaw*(air - wall) - Gwo*(wall - outer))/Cw", unit = "degC", initial = "fit" }
    outer = { rate = "(Gwo*(wall - outer) - Goe*(outer - outside))/Co", unit = "degC", initial = "fit" }
    goods = { rate = "Gaf*(air - goods)/Cf", unit = "degC", initial = "fit" }
    [outputs]
    room = { equals = "air", unit = "degC" }
    inner = { equals = "wall", unit = "degC" }
"#;

/// A room whose heater's heat has another way, with noise of a few hundredths of a kelvin; and a model of it
/// that starts far off.
fn room() -> (Model, Recording) {
    let mut model = Model::parse(ROOM).unwrap();
    let time = clock(180.0, 200);
    let on = |t: f64| if (t / 5400.0).floor() as i64 % 2 == 0 { 1500.0 } else { 200.0 };
    let outside = |t: f64| 278.15 + 5.0 * (t / 14_000.0).sin();
    let start = |x: f64| Initial::Number(x + 273.15);
    let mut truth = model.clone();
    for (state, x) in truth.states.iter_mut().zip([19.0, 60.0, 40.0, 17.0, 9.0, 18.5]) {
        state.initial = start(x);
    }
    truth.states[0].rate =
        Expr::parse("(Gsa*(shell - air) + 0.5*power + Gaw*(wall - air) + Gaf*(goods - air))/Ca").unwrap();
    let zero = |name: &str| channel(name, "degC", &time, |_| 0.0);
    let channels = vec![
        channel("power", "W", &time, on),
        channel("outside", "degC", &time, outside),
        zero("room"),
        zero("inner"),
    ];
    let mut recording = Recording::from_channels("room", channels).unwrap();
    let outputs = Stepper::new(&truth, &recording).unwrap().outputs(&time);
    for (k, y) in outputs.into_iter().enumerate() {
        for ((v, y), e) in
            recording.channels[2 + k].values.iter_mut().zip(y).zip(noise(time.len(), 5 + k as u64))
        {
            *v = y + 0.03 * e;
        }
    }
    model.parameters[1].value = 1.0;
    model.parameters[2].value = 1.0;
    (model, recording)
}

/// Hidden starts stay where the recording lets a room be, what ends at a bound is said, and an answer comes.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn hidden_starts_do_not_run_away_from_what_the_outputs_allow() {
    let (model, recording) = room();
    let d = diagnosed(&model, recording);
    for i in d.before.initials.iter().chain(&d.after.initials) {
        assert!((0.0..3000.0).contains(&i.value), "{} starts at {} K", i.state, i.value);
    }
    for p in d.after.parameters.iter().filter(|p| d.after.is_at_bound(&p.name)) {
        assert!(d.answer.notes.iter().any(|n| n.contains(&p.name)), "{} in {:?}", p.name, d.answer.notes);
    }
}

/// With no time at all there is no answer; with a little there is one that claims nothing.
#[test]
fn a_time_that_is_up_is_said_and_never_means_that_nothing_is_missing() {
    let (model, recording) = room();
    let recordings = [recording];
    let limited = |time: Duration| {
        diagnose(&Request {
            model: &model,
            source: None,
            recordings: &recordings,
            separate: &[],
            seed: 1,
            time_limit: Some(time),
            progress: &Silent,
        })
    };
    if let Err(e) = limited(Duration::from_nanos(1)) {
        assert_eq!(e.kind(), ErrorKind::NotComputed, "{e}");
        assert!(e.to_string().contains("time"), "{e}");
    }
    let mut times = (0..16).map(|k| Duration::from_millis(1 << k));
    let d = times.find_map(|time| limited(time).ok()).unwrap();
    if d.answer.made.ended_early == Some(Early::Time) {
        assert_ne!(d.answer.verdict, Verdict::NothingMissing);
        assert!(d.answer.notes.iter().any(|n| n.contains("ended early")), "{:?}", d.answer.notes);
        let json = serde_json::to_value(&d.answer).unwrap();
        assert_eq!(json["made"]["ended_early"], "time");
    }
}
