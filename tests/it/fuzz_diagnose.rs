//! Small recordings and models at random, through the whole of a diagnosis: an answer with its reports, or an
//! error that the program ends with 2 or 3 for, never a panic.
//!
//! GYROSPEC_FUZZ sets the number of cases (6 by default).

use gyrospec::diagnose::{Request, diagnose};
use gyrospec::estimate::fit::Silent;
use gyrospec::model::Model;
use gyrospec::record::{Channel, Hold, Kind, Recording, Span};
use gyrospec::report::diagnosis;
use gyrospec::units::Unit;
use gyrospec::{Error, ErrorKind};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::time::{Duration, Instant};

/// Parts of equations that are joined at random; `STATE` and `INPUT` stand for names.
const TERMS: [&str; 12] = [
    "-a*STATE",
    "b*INPUT",
    "c",
    "a*INPUT*STATE",
    "-b*STATE^3",
    "c*sin(STATE)",
    "-a*sign(STATE)",
    "b*cos(INPUT)",
    "-c*abs(STATE)*STATE",
    "a*sqrt(abs(INPUT))",
    "d1",
    "b*INPUT/(1 + a*abs(STATE))",
];

struct Maker {
    rng: ChaCha8Rng,
}

impl Maker {
    fn one_of<'a>(&mut self, all: &[&'a str]) -> &'a str {
        all[self.rng.random_range(0..all.len())]
    }

    fn chance(&mut self, share: f64) -> bool {
        self.rng.random_range(0.0..1.0) < share
    }

    /// A sum of terms in some names.
    fn sum(&mut self, states: &[String], terms: usize) -> String {
        let mut sum = String::from("0");
        for _ in 0..terms {
            let term = self.one_of(&TERMS);
            let state = if states.is_empty() {
                "u0".into()
            } else {
                states[self.rng.random_range(0..states.len())].clone()
            };
            let input = self.one_of(&["u0", "u1"]);
            sum += &format!(" + {}", term.replace("STATE", &state).replace("INPUT", input));
        }
        sum
    }

    fn parameter(&mut self, name: &str) -> String {
        let value = self.one_of(&["0.5", "1", "-0.3", "2", "0", "40"]);
        let bounds = self.one_of(&[
            "",
            ", min = -1",
            ", min = 0.001, max = 100",
            ", max = 50",
            ", min = -50, max = 50",
        ]);
        let fit = if self.chance(0.7) { ", fit = true" } else { "" };
        let inside = !(bounds.contains("0.001") && (value == "0" || value == "-0.3"));
        format!("{name} = {{ value = {value}, unit = \"1\"{fit}{} }}\n", if inside { bounds } else { "" })
    }

    /// A model of 0 to 4 states. One that is the rate of the one before has the unit of a rate.
    fn model(&mut self, dynamic: bool) -> String {
        let count = if dynamic { self.rng.random_range(0..5) } else { 0 };
        let chained: Vec<bool> = (0..count).map(|i| i + 1 < count && self.chance(0.4)).collect();
        let is_rate = |i: usize| i > 0 && chained[i - 1] && (i < 2 || !chained[i - 2]);
        let name = |i: usize| if is_rate(i) { format!("(x{i}*s1)") } else { format!("x{i}") };
        let states: Vec<String> = (0..count).map(name).collect();
        let unit = "{ unit = \"1\" }";
        let mut text = format!("name = \"m\"\n[inputs]\nu0 = {unit}\nu1 = {unit}\n[parameters]\n");
        text += "s1 = { value = 1, unit = \"s\" }\n";
        for name in ["a", "b", "c"] {
            text += &self.parameter(name);
        }
        let sum = self.sum(&[], 2).replace("d1", "c");
        text += &format!("[definitions]\nd0 = {{ equals = \"{sum}\", unit = \"1\" }}\n");
        text += "d1 = { equals = \"(d0 + d0)/2\", unit = \"1\" }\n";
        text += if count > 0 { "[states]\n" } else { "" };
        for i in 0..count {
            let (own, over) = if is_rate(i) { ("1/s", "s1^2") } else { ("1", "s1") };
            let next = i + 1 < count && is_rate(i + 1);
            let rate =
                if next { format!("x{}", i + 1) } else { format!("({})/{over}", self.sum(&states, 3)) };
            let initial = self.one_of(&["\"fit\"", "0", "1.5", "\"fit\"", "\"steady\""]);
            text += &format!("x{i} = {{ rate = \"{rate}\", unit = \"{own}\", initial = {initial} }}\n");
        }
        text += "[outputs]\n";
        for k in 0..self.rng.random_range(1..3) {
            let shown = if count > 0 && self.chance(0.7) { "x0".into() } else { self.sum(&states, 2) };
            text += &format!("y{k} = {{ equals = \"{shown}\", unit = \"1\" }}\n");
        }
        text
    }

    /// The clock of a table: even or not, with gaps anywhere.
    fn clock(&mut self, kind: Kind) -> Vec<f64> {
        let rows = self.rng.random_range(5..120);
        if kind == Kind::Trials {
            return (0..rows).map(f64::from).collect();
        }
        let step = [0.01, 0.1, 0.37, 2.0][self.rng.random_range(0..4)];
        let uneven = self.chance(0.3);
        let (mut t, mut time) =
            (if self.chance(0.3) { self.rng.random_range(-3.0..3.0) } else { 0.0 }, Vec::new());
        for _ in 0..rows {
            time.push(t);
            let gap = if self.chance(0.02) { self.rng.random_range(2.0..40.0) } else { 1.0 };
            t += step * gap * if uneven { self.rng.random_range(0.3..1.7) } else { 1.0 };
        }
        time
    }

    fn channel(&mut self, name: &str, time: &[f64]) -> Channel {
        let (level, size): (f64, f64) = (self.rng.random_range(-3.0..3.0), self.rng.random_range(0.0..3.0));
        let (w, noise): (f64, f64) = (self.rng.random_range(0.05..6.0), self.rng.random_range(0.0..0.3));
        let (steps, still) = (self.chance(0.2), self.chance(0.05));
        let mut values: Vec<f64> = Vec::new();
        for t in time {
            let wave =
                if still { 0.0 } else { size * (w * t).sin() + noise * self.rng.random_range(-1.0..1.0) };
            values.push(if steps { (level + wave).round() } else { level + wave });
        }
        let share = if self.chance(0.5) { 0.0 } else { self.rng.random_range(0.0..0.2) };
        for v in &mut values {
            if self.chance(share) {
                *v = if self.chance(0.7) { f64::NAN } else { *v * 1e3 };
            }
        }
        let mut c = Channel::new(name, Unit::one(), time.to_vec(), values);
        c.hold = if self.chance(0.2) { Hold::Previous } else { Hold::Linear };
        c
    }

    fn recording(&mut self, kind: Kind) -> Option<Recording> {
        let mut clock = self.clock(kind);
        let mut channels = Vec::new();
        for name in ["u0", "u1", "y0", "y1", "extra"] {
            if kind == Kind::Time && self.chance(0.25) {
                clock = self.clock(kind);
            }
            channels.push(self.channel(name, &clock));
        }
        let recording = Recording::from_channels("r", channels).ok()?.with_kind(kind);
        let (first, last) = (clock[0], clock[clock.len() - 1]);
        let cut = first + self.rng.random_range(0.0..1.0) * (last - first);
        Some(match self.rng.random_range(0..4) {
            0 => recording.with_spans(vec![Span::new(first, cut)], vec![Span::new(cut, last)]),
            1 => recording.with_spans(vec![Span::new(cut, last)], vec![Span::new(first, cut)]),
            _ => recording,
        })
    }

    /// One diagnosis; what went wrong, if it is more than an honest refusal.
    fn case(&mut self) -> Result<(), String> {
        let kind = if self.chance(0.2) { Kind::Trials } else { Kind::Time };
        let text = self.model(kind == Kind::Time);
        let model = Model::parse(&text).map_err(|e| format!("{e}\n{text}"))?;
        let count = self.rng.random_range(1..3);
        let recordings: Vec<Recording> = (0..count).filter_map(|_| self.recording(kind)).collect();
        let separate: Vec<Recording> =
            if self.chance(0.25) { self.recording(kind).into_iter().collect() } else { Vec::new() };
        // most are ended early: so is a search at any place, and thousands of cases take an hour, not a day
        let time_limit = self.chance(0.9).then(|| Duration::from_millis(self.rng.random_range(1..400)));
        let request = Request {
            model: &model,
            source: None,
            recordings: &recordings,
            separate: &separate,
            seed: 1,
            time_limit,
            progress: &Silent,
        };
        match diagnose(&request) {
            Ok(d) => {
                let json = serde_json::to_string(&d.answer).map_err(|e| e.to_string())?;
                let ok = !diagnosis::text(&d).is_empty()
                    && diagnosis::html(&d).contains("</html>")
                    && !json.is_empty();
                if ok { Ok(()) } else { Err("an empty report".into()) }
            }
            Err(e) if is_honest(&e) => Ok(()),
            Err(e) => Err(format!("{:?}: {e}\n{text}", e.kind())),
        }
    }
}

/// Whether the program ends with 2 or 3 for it, with a message.
fn is_honest(e: &Error) -> bool {
    let known = [ErrorKind::BadInput, ErrorKind::Units, ErrorKind::NotComputed, ErrorKind::Usage];
    known.contains(&e.kind()) && !e.to_string().is_empty()
}

#[test]
fn small_recordings_and_models_at_random_end_with_an_answer_or_a_reason() {
    let number = |name: &str, or: u64| std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(or);
    let (first, cases) = (number("GYROSPEC_FUZZ_FIRST", 0), number("GYROSPEC_FUZZ", 6));
    let mut slowest = (Duration::ZERO, 0);
    for seed in first..first + cases {
        if std::env::var_os("GYROSPEC_FUZZ_TELL").is_some() {
            eprintln!("case {seed}");
        }
        let begun = Instant::now();
        let result = Maker { rng: ChaCha8Rng::seed_from_u64(seed) }.case();
        slowest = slowest.max((begun.elapsed(), seed));
        result.unwrap_or_else(|e| panic!("case {seed}: {e}"));
    }
    eprintln!("slowest of {cases}: {slowest:?}");
}
