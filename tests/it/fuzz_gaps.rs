//! Random recordings with gaps: whatever is missing, the record room reads the rest, judges it and parts it.
//!
//! GYROSPEC_FUZZ sets the number of recordings (500 by default).

use gyrospec::record::{Channel, Kind, Recording, Span, quality, summaries};
use rand::RngExt;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::fmt::Write;
use std::fs;
use std::panic::catch_unwind;
use std::path::Path;

const UNITS: [&str; 6] = ["m", "deg", "rad", "degC", "rpm", "1"];

/// A table as text, its columns' names and units, and how many numbers each holds.
struct Made {
    text: String,
    channels: Vec<(String, &'static str, usize)>,
    ends: (f64, f64),
}

/// What a channel does, at row i of n.
fn value(kind: u32, i: usize, r: &mut ChaCha8Rng, last: f64) -> f64 {
    let x = i as f64;
    match kind {
        0 => 3.25,
        1 => (0.3 * x).sin(),
        2 => last + r.random_range(-1.0..1.0),
        3 => f64::from(i32::try_from(i / 7).unwrap_or(0) % 3),
        4 => (x * 17.0) % 360.0,
        5 => 1e300 * r.random_range(-1.0..1.0),
        6 => 1e-300 * r.random_range(-1.0..1.0),
        7 if r.random_bool(0.03) => 1e6,
        8 if i % 40 > 10 => last,
        _ => r.random_range(-1.0..1.0),
    }
}

/// Rows on an uneven clock with holes of all sizes, and cells that are empty one by one or in a row.
fn table(r: &mut ChaCha8Rng, first: char, regular: bool) -> Made {
    let rows = if r.random_bool(0.05) { r.random_range(0..1500) } else { r.random_range(0..60) };
    let names: Vec<String> = (0..r.random_range(1..4)).map(|k| format!("{first}{k}")).collect();
    let units: Vec<&str> = names.iter().map(|_| UNITS[r.random_range(0..UNITS.len())]).collect();
    let kinds: Vec<u32> = names.iter().map(|_| r.random_range(0..10)).collect();
    let empty: Vec<f64> = names.iter().map(|_| [0.0, 0.02, 0.5, 1.0][r.random_range(0..4)]).collect();
    let step = 10_f64.powf(r.random_range(-4.0..4.0));
    let mut t = [0.0, -7.5, 1e9][r.random_range(0..3)];
    let (jitter, hole) = ([0.0, 0.4][r.random_range(0..2)], [0.0, 0.01, 0.2][r.random_range(0..3)]);
    let mut text = if regular { String::new() } else { String::from("t [s],") };
    text += &names.iter().zip(&units).map(|(n, u)| format!("{n} [{u}]")).collect::<Vec<_>>().join(",");
    let (mut counts, mut last, mut missing) =
        (vec![0; names.len()], vec![0.0; names.len()], vec![0; names.len()]);
    let mut ends = (t, t);
    for i in 0..rows {
        text.push('\n');
        t += step * (1.0 + jitter * r.random_range(-1.0..1.0));
        if r.random_bool(hole) {
            t += step * f64::from(r.random_range(1..40));
        }
        if !regular {
            let _ = write!(text, "{t},");
        }
        ends.1 = t;
        for k in 0..names.len() {
            last[k] = value(kinds[k], i, r, last[k]);
            if r.random_bool(empty[k] / 4.0) {
                missing[k] = r.random_range(1..30);
            }
            let comma = if k + 1 < names.len() { "," } else { "" };
            if missing[k] > 0 || r.random_bool(empty[k]) {
                missing[k] = missing[k].max(1) - 1;
                let _ = write!(text, "{}{comma}", ["", "NaN"][r.random_range(0..2)]);
            } else {
                counts[k] += 1;
                let _ = write!(text, "{}{comma}", last[k]);
            }
        }
    }
    text.push('\n');
    let channels = names.into_iter().zip(units).zip(counts).map(|((n, u), c)| (n, u, c)).collect();
    Made { text, channels, ends }
}

/// Spans that may lie in the data, across their ends, beside them, or, of some, on one another.
fn spans(r: &mut ChaCha8Rng, (from, to): (f64, f64)) -> String {
    let mut list = || {
        let mut ends: Vec<f64> = (0..4).map(|_| from + (to - from) * r.random_range(-0.3..1.3)).collect();
        // apart from one another, but for some
        if r.random_bool(0.8) {
            ends.sort_by(f64::total_cmp);
        }
        let spans = ends.chunks(2).map(|s| format!("[{:?}, {:?}]", s[0].min(s[1]), s[0].max(s[1])));
        spans.collect::<Vec<_>>().join(", ")
    };
    let (fit, holdout) = (list(), list());
    match r.random_range(0..4) {
        0 => format!("[spans]\nfit = [{fit}]\n"),
        1 => format!("[spans]\nholdout = [{holdout}]\n"),
        2 => format!("[spans]\nfit = [{fit}]\nholdout = [{holdout}]\n"),
        _ => String::new(),
    }
}

/// A recording of one table, of two with their own clocks and spans, or of trials.
fn recording(r: &mut ChaCha8Rng, folder: &Path) -> (gyrospec::Result<Recording>, Vec<Made>) {
    let write = |name: &str, made: &Made| fs::write(folder.join(name), &made.text).unwrap();
    if r.random_bool(0.4) {
        let made = table(r, 'a', false);
        write("a.csv", &made);
        return (Recording::read(folder.join("a.csv")), vec![made]);
    }
    let trials = r.random_bool(0.1);
    let regular = trials || r.random_bool(0.2);
    let made = [table(r, 'a', regular), table(r, 'b', regular)];
    let mut text = String::from(if trials { "kind = \"trials\"\n" } else { "" });
    for (name, made) in ["a.csv", "b.csv"].iter().zip(&made).take(if trials { 1 } else { 2 }) {
        write(name, made);
        let _ = writeln!(text, "[[tables]]\nfile = \"{name}\"");
        if regular && !trials {
            text += "time = { start = -3.0, step = 0.01, unit = \"min\" }\n";
        }
        text += "[tables.channels]\n";
        for (channel, unit, _) in &made.channels {
            let wraps = ["deg", "rad"].contains(unit) && r.random_bool(0.5);
            let hold = if r.random_bool(0.3) { ", hold = \"previous\"" } else { "" };
            let _ = writeln!(text, "{channel} = {{ column = \"{channel}\", wraps = {wraps}{hold} }}");
        }
    }
    let ends = if trials { (0.0, 20.0) } else { made[0].ends };
    text += &spans(r, ends);
    let all = if trials { made.into_iter().take(1).collect() } else { made.into() };
    (Recording::parse(&text, folder.join("r.toml")), all)
}

/// What every channel promises.
fn judge_channel(c: &Channel, count: usize) {
    assert_eq!(c.time.len(), c.values.len());
    assert!(c.time.windows(2).all(|w| w[0] < w[1]) && c.values.iter().all(|v| !v.is_infinite()));
    assert_eq!(c.samples().count(), count, "{}: every number is there, and every gap", c.name);
    let Some(range) = c.range() else { return };
    let (low, high) =
        c.samples().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), (_, v)| (a.min(v), b.max(v)));
    for k in 0..=20 {
        let at = range.from + range.length() * (f64::from(k) / 18.0 - 0.05);
        if let Some(v) = c.value_at(at) {
            let slack = 1e-12 * (high - low).abs().max(high.abs()).max(low.abs());
            assert!(v >= low - slack && v <= high + slack, "{} at {at}: {v}", c.name);
            assert!(range.contains(at), "nothing is known outside");
        }
    }
    assert!(c.median_step().is_none_or(|step| step > 0.0) && c.levels().windows(2).all(|w| w[0] < w[1]));
}

/// What every recording promises, with what the program does to each.
fn judge(recording: &Recording, made: &[Made]) {
    let wanted: usize = made.iter().map(|m| m.channels.len()).sum();
    assert_eq!(recording.channels.len(), wanted);
    for (name, _, count) in made.iter().flat_map(|m| &m.channels) {
        judge_channel(recording.channel(name).unwrap(), *count);
    }
    for separate in [false, true] {
        let spans = recording.spans_for(&[], separate);
        assert!(spans.fit.iter().chain(&spans.holdout).all(|s| s.from <= s.to));
        let both = |f: &Span| spans.holdout.iter().any(|h| h.overlap(f).is_some());
        assert!(!spans.fit.iter().any(both), "{spans:?}");
    }
    let faults = quality::faults(recording);
    let clean = quality::masked(recording, &faults);
    for (a, b) in clean.channels.iter().zip(&recording.channels) {
        assert!(a.len() > 60 || a.samples().all(|one| b.samples().any(|other| one == other)));
    }
    for (fault, c) in faults.iter().filter_map(|f| Some((f, recording.find(&f.channel)?))) {
        let range = c.range().unwrap();
        let inside = |s: &Span| s.from <= s.to && range.contains(s.from) && range.contains(s.to);
        assert!(fault.spans.iter().all(inside), "{fault:?} in {range:?}");
    }
    for (s, c) in summaries(recording).iter().zip(&recording.channels) {
        assert!(s.samples <= c.len() && s.peaks.iter().all(|p| p.omega > 0.0 && p.omega.is_finite()));
        assert!(recording.kind == Kind::Time || s.sampling.is_none());
    }
}

#[test]
fn random_recordings_with_gaps() {
    let cases = std::env::var("GYROSPEC_FUZZ").ok().and_then(|n| n.parse().ok()).unwrap_or(500);
    let folder = tempfile::tempdir().unwrap();
    let (mut read, mut refused) = (0, 0);
    for case in 0..cases {
        let mut r = ChaCha8Rng::seed_from_u64(case);
        let (result, made) = recording(&mut r, folder.path());
        match result {
            Ok(recording) => {
                read += 1;
                let judged = catch_unwind(|| judge(&recording, &made));
                assert!(judged.is_ok(), "case {case}");
            }
            Err(e) => {
                refused += 1;
                let says = e.to_string();
                let twice = ["both fitted and held out", "would be fitted twice", "would be held out twice"];
                let known = ["no rows", "occurs twice"].into_iter().chain(twice);
                assert!(
                    e.file().is_some() && known.into_iter().any(|k| says.contains(k)),
                    "case {case}: {says}"
                );
            }
        }
    }
    println!("{read} recordings with gaps read, {refused} refused");
    assert!(read > refused);
}
