//! Where the mismatch sits.

use crate::diagnose::{diagnosed, of_no_name, recording};
use gyrospec::diagnose::answer::Verdict;
use gyrospec::model::Model;
use gyrospec::record::Channel;
use gyrospec::units::Unit;

/// A push that nobody measured, over two seconds, seen by two outputs alike: one stretch, told once.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn times_of_several_outputs_are_one_list() {
    let (model, mut made) = recording(Some("8*step(t - 10)*step(12 - t)"));
    let both =
        Model::parse(&(model.to_toml() + "\n[outputs.shown]\nequals = \"2*q\"\nunit = \"m\"\n")).unwrap();
    let position = made.find("position").unwrap().clone();
    let twice = position.values.iter().map(|q| 2.0 * q).collect();
    made.channels.push(Channel::new("shown", Unit::parse("m").unwrap(), position.time, twice));
    let located = diagnosed(&both, made).answer.located;
    assert!(!located.time.is_empty(), "{located:?}");
    assert!(located.time.windows(2).all(|w| w[0].to < w[1].from), "{located:?}");
    assert!(located.time.iter().any(|s| s.from <= 11.0 && s.to >= 11.0), "{located:?}");
    assert!(located.time.iter().all(|s| s.recording.is_none()));
    assert!(located.bands.iter().map(|b| b.share).sum::<f64>() <= 1.0 + 1e-9);
}

/// A law that no name fits acts on the state that it was put into.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn an_unknown_law_sits_where_it_acts() {
    let answer = of_no_name();
    assert_eq!(answer.verdict, Verdict::Unknown, "{}", answer.says);
    let sites: Vec<(&str, &str)> =
        answer.located.sites.iter().map(|s| (s.kind.as_str(), s.name.as_str())).collect();
    assert_eq!(sites.first(), Some(&("state", "v")), "{sites:?}");
    assert!(!answer.located.signals.is_empty() || answer.unexplained.is_some());
}

/// Each recording has its own clock: its stretches say whose they are.
#[test]
#[ignore = "long: GYROSPEC_LONG=1 .ci/run runs it"]
fn times_of_several_recordings_are_told_apart() {
    let (model, made) = recording(Some("8*step(t - 10)*step(12 - t)"));
    let part = |name: &str, from: usize, to: usize| {
        let cut = |c: &Channel| {
            Channel::new(&*c.name, c.unit.clone(), c.time[from..to].to_vec(), c.values[from..to].to_vec())
        };
        gyrospec::record::Recording::from_channels(name, made.channels.iter().map(cut).collect()).unwrap()
    };
    let recordings = [part("first", 0, 1250), part("second", 1250, 2500)];
    let request = gyrospec::diagnose::Request {
        model: &model,
        source: None,
        recordings: &recordings,
        separate: &[],
        time_limit: None,
        seed: 1,
        progress: &gyrospec::estimate::fit::Silent,
    };
    let located = gyrospec::diagnose::diagnose(&request).unwrap().answer.located;
    let first: Vec<_> = located.time.iter().filter(|s| s.recording.as_deref() == Some("first")).collect();
    assert!(first.iter().any(|s| s.from <= 11.0 && s.to >= 11.0), "{located:?}");
    assert!(located.time.iter().all(|s| s.recording.is_some()));
}

/// A single sample far off is a stretch of its own, as long as to the middle between it and its neighbours.
#[test]
fn no_stretch_of_time_is_without_length() {
    let (model, mut made) = recording(None);
    let position = made.channels.iter_mut().find(|c| c.name == "position").unwrap();
    position.values[500] += 5.0;
    let step = position.time[1] - position.time[0];
    let at = position.time[500];
    let a = diagnosed(&model, made).answer;
    assert_eq!(a.verdict, Verdict::DataFault, "{}", a.says);
    assert_eq!(a.located.time.len(), 1, "{:?}", a.located.time);
    let spell = &a.located.time[0];
    assert!((spell.from - (at - 0.5 * step)).abs() < 1e-9 && (spell.to - (at + 0.5 * step)).abs() < 1e-9);
}
