//! `gyrospec record`: what is in a recording.

use super::{Outcome, output};
use crate::Result;
use crate::record::quality::{Fault, FaultKind};
use crate::record::{Channel, Kind, Recording, Summary, summaries};
use crate::report::braille;
use crate::text::in_line;
use crate::units::counted;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::PathBuf;

const PICTURE: (usize, usize) = (64, 3);
const SPANS_SHOWN: usize = 4;

const FORM: &str = r#"A CSV file has a header such as `t [s],roll [deg],heading [deg]` (time first); empty cells are gaps.
A TOML recording joins tables of different rates and gives units where headers do not:

  name = "trial 7"
  [[tables]]
  file = "gyro.csv"                            # beside this file; .csv.gz as well
  time = { column = "t_s", unit = "s" }        # or { start = 0.0, step = 0.001, unit = "s" }
  rows = [100, 5000]                           # optional: first and last row, from 0
  decimal = ","                                # optional: the decimal sign, where 1.050 could be 1050
  [tables.channels]
  heading_gyro = { column = "heading_deg", unit = "deg", wraps = true }
  [[tables]]
  file = "ship.nmea"                           # a time stamp, then a sentence, line by line; or no stamps, but ZDA
  format = "nmea0183"
  time = { start = "2018-12-06T00:00:00Z" }    # the zero of time
  [tables.channels]
  heading = { sentence = "HDT", field = 1, unit = "deg", wraps = true }
  roll = { sentence = "PSXN", id = 23, field = 2, unit = "deg" }   # field 1 is the id
  [spans]                                      # optional; else the last 40 % is held out
  fit = [[0.0, 600.0]]
  holdout = [[600.0, 1000.0]]
  [constants]                                  # optional: known parameters
  lat = { value = 46.5, unit = "deg" }

kind = "trials" at the top makes each row a steady trial, without time.
Exit code: 0, or 1 where a fault is sure, or 2 where the file cannot be read.
Examples:
  gyrospec record log.toml
  gyrospec record log.csv --json"#;

/// Shows what is in a recording: channels, units, rates, gaps, faults, spectral peaks.
#[derive(clap::Args)]
#[command(after_help = FORM)]
pub struct Record {
    /// CSV file (.csv, .csv.gz), NMEA 0183 log, or TOML recording; - is standard input
    file: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub fn run(call: &Record) -> Result<Outcome> {
    let recording = Recording::read(&call.file)?;
    let summaries = summaries(&recording);
    let text = if call.json {
        let mut text = serde_json::to_string_pretty(&form(&recording, &summaries)).unwrap_or_default();
        text.push('\n');
        text
    } else {
        words(&recording, &summaries)
    };
    if call.json { output::quoted(&text) } else { output::words(&text) }?;
    let sure = summaries.iter().flat_map(|s| &s.faults).any(Fault::is_sure_of_any);
    Ok(if sure { Outcome::Found } else { Outcome::Done })
}

/// Tells on standard error what the readers noticed.
pub fn tell_notes<'a>(recordings: impl IntoIterator<Item = &'a Recording>) {
    for note in recordings.into_iter().flat_map(|r| &r.notes) {
        super::note(&note.to_string());
    }
}

fn words(recording: &Recording, summaries: &[Summary]) -> String {
    let mut text = headline(recording);
    for note in &recording.notes {
        let _ = writeln!(text, "note: {note}");
    }
    for (channel, summary) in recording.channels.iter().zip(summaries) {
        text.push('\n');
        text.push_str(&channel_words(channel, summary, recording.kind));
    }
    let faults: Vec<&Fault> = summaries.iter().flat_map(|s| &s.faults).collect();
    let sure = faults.iter().filter(|f| f.is_sure_of_any()).count();
    let verdict = match (sure, faults.len() - sure) {
        (0, 0) => "Nothing is wrong with it that can be seen without a model.".to_owned(),
        (0, n) => format!("No fault that is sure; {n} to look at (?)."),
        (n, 0) => format!("{} (!).", counted(n, "fault")),
        (n, m) => format!("{} (!), and {m} to look at (?).", counted(n, "fault")),
    };
    let _ = writeln!(text, "\n{verdict}");
    if faults.iter().any(|f| f.kind.spoils()) {
        text.push_str(
            "An input may hold a value or leap: of a channel that drives a model these are no faults.\n",
        );
    }
    text
}

fn headline(recording: &Recording) -> String {
    let (n, name) = (recording.channels.len(), &recording.name);
    let range = recording.range();
    let extent = match (recording.kind, range) {
        (Kind::Trials, _) => counted(recording.channels.first().map_or(0, Channel::len), "trial"),
        (Kind::Time, Some(r)) => format!("{} s … {} s", short(r.from), short(r.to)),
        (Kind::Time, None) => "no samples".to_owned(),
    };
    let mut text = format!("{name}: {}, {extent}\n", counted(n, "channel"));
    let spans = recording.spans_for(&[], false);
    if recording.kind == Kind::Time && !spans.holdout.is_empty() {
        let list = |spans: &[crate::record::Span]| {
            let each = spans.iter().map(|s| format!("{} … {} s", short(s.from), short(s.to)));
            each.collect::<Vec<_>>().join(", ")
        };
        let why = if spans.given { "" } else { " (the last 40 %)" };
        let _ = writeln!(text, "fitted: {}; held out: {}{why}", list(&spans.fit), list(&spans.holdout));
    }
    for c in &recording.constants {
        let _ = writeln!(text, "constant {} = {} {}", c.name, short(c.unit.from_si(c.value)), c.unit);
    }
    text
}

fn channel_words(channel: &Channel, s: &Summary, kind: Kind) -> String {
    let unit = &channel.unit;
    let marks = [(channel.wraps, ", wraps at a turn"), (channel.hold.is_held(), ", held between samples")];
    let marks: String = marks.iter().filter(|m| m.0).map(|m| m.1).collect();
    let mut text = format!("{} [{unit}]{marks}\n", in_line(&channel.name));
    if s.samples == 0 {
        return text + "  no samples\n" + &fault_lines(channel, s);
    }
    let absent = channel.len() - s.samples;
    let _ = write!(text, "  {}", counted(s.samples, "sample"));
    if absent > 0 {
        let _ = write!(text, ", {absent} empty");
    }
    if let Some(clock) = s.sampling {
        let even = if clock.even { String::new() } else { format!(" ± {} s", short(clock.jitter)) };
        let _ = write!(text, ", every {} s{even} ({} Hz)", short(clock.step), short(1.0 / clock.step));
    }
    let at = |v: f64| short(unit.from_si(v));
    let difference = |v: f64| short(unit.difference_from_si(v));
    if s.min == s.max {
        let _ = writeln!(text, "\n  constant at {}", at(s.min));
    } else {
        let (min, max, mean) = (at(s.min), at(s.max), at(s.mean));
        let _ = write!(text, "\n  {min} … {max}, mean {mean}, standard deviation {}", difference(s.spread));
        if let Some(q) = s.quantum {
            let _ = write!(text, ", resolution {}", difference(q));
        }
        text.push('\n');
    }
    if !s.peaks.is_empty() {
        let each = s.peaks.iter().map(|p| {
            format!("{} rad/s (period {} s, {:.0} %)", short(p.omega), short(p.period()), 100.0 * p.share)
        });
        let _ = writeln!(text, "  spectral peaks: {}", each.collect::<Vec<_>>().join(", "));
    }
    text += &fault_lines(channel, s);
    if kind == Kind::Time && s.min < s.max {
        for line in braille::plot(channel.samples(), PICTURE.0, PICTURE.1) {
            let _ = writeln!(text, "  {line}");
        }
    }
    text
}

fn fault_lines(channel: &Channel, s: &Summary) -> String {
    let mark = |fault: &Fault| if fault.is_sure_of_any() { '!' } else { '?' };
    s.faults.iter().map(|f| format!("  {} {}\n", mark(f), says(f, channel))).collect()
}

/// A fault in a sentence.
fn says(fault: &Fault, channel: &Channel) -> String {
    let unit = &channel.unit;
    let difference = format!("{} {}", short(unit.difference_from_si(fault.size)), unit.of_differences());
    let first = fault.spans.iter().take(SPANS_SHOWN);
    let places: Vec<String> =
        first
            .map(|s| {
                if s.length() == 0.0 {
                    short(s.from)
                } else {
                    format!("{} … {}", short(s.from), short(s.to))
                }
            })
            .collect();
    let more = if fault.spans.len() > SPANS_SHOWN { ", …" } else { "" };
    let at = format!("{}{more} s", places.join(", "));
    let n = fault.samples;
    match fault.kind {
        FaultKind::Frozen => {
            let held = short(unit.from_si(fault.size));
            format!("stands still at {held} {unit} for {} while it should move: {at}", counted(n, "sample"))
        }
        FaultKind::Outliers => format!("{}, up to {difference} off: at {at}", counted(n, "outlier")),
        FaultKind::Gap => {
            format!("{} missing, up to {} s at a time: {at}", counted(n, "sample"), short(fault.size))
        }
        FaultKind::Quantisation => format!("moves in steps of {difference}: coarse against its motion"),
        FaultKind::WrappedAngle => {
            format!("jumps by a turn {}; mark it with wraps = true: {at}", counted(n, "time"))
        }
        FaultKind::ClockDrift => {
            format!("the step of time changes by {} % between the halves", short(100.0 * fault.size))
        }
    }
}

/// Five significant digits.
fn short(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".into() } else { "-".into() };
    }
    let exponent = x.abs().log10().floor() as i32;
    if !(-4..7).contains(&exponent) {
        let text = format!("{x:.4e}");
        let (mantissa, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", trimmed(mantissa));
    }
    trimmed(&format!("{x:.*}", (4 - exponent).max(0) as usize)).to_owned()
}

fn trimmed(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

fn form(recording: &Recording, summaries: &[Summary]) -> Value {
    let channels: Vec<Value> =
        recording.channels.iter().zip(summaries).map(|(c, s)| channel_form(c, s)).collect();
    let span = |s: &crate::record::Span| json!([s.from, s.to]);
    let spans = recording.spans_for(&[], false);
    json!({
        "schema": "gyrospec.recording/1",
        "name": recording.name,
        "kind": if recording.kind == Kind::Trials { "trials" } else { "time" },
        "range": recording.range().map(|r| span(&r)),
        "fit": spans.fit.iter().map(span).collect::<Vec<_>>(),
        "holdout": spans.holdout.iter().map(span).collect::<Vec<_>>(),
        "channels": channels,
        "constants": recording.constants.iter().map(|c| json!({
            "name": c.name, "value": c.unit.from_si(c.value), "unit": c.unit.text(),
        })).collect::<Vec<_>>(),
        "inputs": recording.sources.iter().map(|s| json!({
            "file": s.file.display().to_string(), "sha256": s.sha256,
        })).collect::<Vec<_>>(),
        "notes": recording.notes.iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

fn channel_form(channel: &Channel, s: &Summary) -> Value {
    let unit = &channel.unit;
    let difference = |v: f64| unit.difference_from_si(v);
    json!({
        "name": channel.name,
        "unit": unit.text(),
        "wraps": channel.wraps,
        "table": channel.table,
        "samples": s.samples,
        "empty": channel.len() - s.samples,
        "from": channel.range().map(|r| r.from),
        "to": channel.range().map(|r| r.to),
        "step": s.sampling.map(|c| c.step),
        "jitter": s.sampling.map(|c| c.jitter),
        "min": unit.from_si(s.min),
        "max": unit.from_si(s.max),
        "mean": unit.from_si(s.mean),
        "standard_deviation": difference(s.spread),
        "resolution": s.quantum.map(difference),
        "peaks": s.peaks.iter().map(|p| json!({
            "omega": p.omega, "period": p.period(), "share": p.share,
        })).collect::<Vec<_>>(),
        "faults": s.faults.iter().map(|f| json!({
            "code": f.kind.code(),
            "sure": f.is_sure_of_any(),
            "samples": f.samples,
            "spans": f.spans.iter().map(|s| json!([s.from, s.to])).collect::<Vec<_>>(),
            "says": says(f, channel),
        })).collect::<Vec<_>>(),
    })
}
