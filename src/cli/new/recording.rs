//! A recording file guessed from a CSV, or written for an NMEA 0183 log.
//!
//! The record room looks at the table; this guesses what its columns mean, writes that down, and has the
//! record room read the result: what comes out is a recording, or the reason why it is none.

use super::identifier::identifier;
use super::log;
use crate::cli::input::Held;
use crate::cli::record::tell_notes;
use crate::record::{self, Raw, Recording};
use crate::text::{in_line, toml_string};
use crate::units::{Dimension, Unit};
use crate::{Error, Result};
use std::collections::BTreeSet;
use std::path::Path;

/// First words of names that mean the time.
const TIMES: [&str; 9] = ["t", "time", "timestamp", "seconds", "clock", "date", "datetime", "utc", "epoch"];

/// What a column is taken for, and why.
struct Guess {
    name: String,
    unit: String,
    wraps: bool,
    because: String,
}

/// The text of a recording file; every guess is marked.
///
/// # Errors
/// What the record room says of a table or log that it cannot read, with file, line and column.
pub fn guessed(csv: &Path) -> Result<String> {
    let held = Held::of(csv)?;
    guessed_of(&held).map_err(|e| held.place(e))
}

fn guessed_of(held: &Held) -> Result<String> {
    let csv = held.path();
    if record::is_log(csv)? {
        return written(held, log::HEAD, &log::body(&record::contents_of_log(csv)?));
    }
    let columns = record::columns(csv)?;
    let time = time_of(&columns);
    let whole = || vec![(time, 0..columns.len())];
    let of_clocks =
        |first| record::clocks_of(&columns, first, like_time).into_iter().map(|s| (s.clock, s.columns));
    let (mut out, mut taken) = (String::new(), BTreeSet::new());
    for (n, (time, side)) in time.map_or_else(whole, |t| of_clocks(t).collect()).into_iter().enumerate() {
        if n > 0 {
            out += &format!("\n# GUESS: its own clock\n[[tables]]\nfile = {}\n", file_of(csv));
        }
        out += &clock(time.map(|i| (i, &columns[i])));
        out.push_str("[tables.channels]\n");
        for i in side.filter(|i| Some(*i) != time) {
            out += &channel(i, &columns[i], &mut taken);
        }
    }
    if taken.is_empty() {
        return Err(Error::bad_input("no column beside the time holds numbers")
            .with_file(csv)
            .with_line(1)
            .with_hint("channels need numbers below their names"));
    }
    written(held, HEAD, &out)
}

/// The first line of a file for a table.
const HEAD: &str = "Guessed from the header and the rows: look at every line marked GUESS.";
const SPANS: &str = "\n# What is held out; without this the last 40 % of the time.\n# [spans]\n# fit = [[0.0, 600.0]]\n# holdout = [[600.0, 1000.0]]\n";

/// The whole file, once it was read for a trial.
fn written(held: &Held, first: &str, table: &str) -> Result<String> {
    let text = |file: &Path, comment: &str| head(first, file, comment) + table + SPANS;
    let read = Recording::parse(&text(held.path(), ""), "recording.toml")?;
    tell_notes([&held.named(read)]);
    if held.path() == held.given() {
        return Ok(text(held.path(), ""));
    }
    let save = "  # GUESS: what came through a pipe has no name; save it under this one, or set another";
    let named = Path::new("recording.csv");
    Ok(text(named, save).replace(&file_of(held.path()), &file_of(named)))
}

/// The first lines of the file, which name the table.
fn head(first: &str, file: &Path, comment: &str) -> String {
    let stem = file.file_name().unwrap_or_default().to_string_lossy();
    format!(
        "# {first}\nname = {}\n\n[[tables]]\nfile = {}{comment}\n",
        toml_string(stem.split('.').next().unwrap_or_default()),
        file_of(file)
    )
}

fn file_of(file: &Path) -> String {
    toml_string(&file.display().to_string())
}

/// The line of the file that says where the time is.
fn clock(time: Option<(usize, &Raw)>) -> String {
    let Some((index, c)) = time else {
        return "time = { start = 0.0, step = 1.0, unit = \"s\" }  # GUESS: no column rises like time; set the step, or write kind = \"trials\" above and drop this line where each row is a steady trial\n".into();
    };
    if let Some(since) = &c.since {
        return format!(
            "time = {{ column = {}, unit = \"s\" }}  # it counts from {}\n",
            toml_string(&c.name),
            in_line(since)
        );
    }
    let g = guess(index, c, &mut BTreeSet::new());
    let (unit, because) = match Unit::parse(&g.unit) {
        Ok(u) if u.dimension() == Dimension::TIME => (g.unit, g.because),
        _ => ("s".into(), "GUESS: seconds, as the header names no unit of time".into()),
    };
    format!("time = {{ column = {}, unit = \"{unit}\" }}  # {because}\n", toml_string(&c.name))
}

/// The line of the file that makes a column a channel; a comment where it holds no numbers.
fn channel(index: usize, c: &Raw, taken: &mut BTreeSet<String>) -> String {
    if c.values.iter().all(|v| v.is_nan()) {
        let holds = c
            .text
            .as_ref()
            .map_or_else(|| "nothing".to_owned(), |(_, text)| format!("text, such as {text:?}"));
        return format!("# {}: left out, as it holds {holds}\n", toml_string(&c.name));
    }
    let g = guess(index, c, taken);
    let wraps = if g.wraps { ", wraps = true" } else { "" };
    let is_held = !g.wraps && record::looks_held(&c.values);
    let hold = if is_held { ", hold = \"previous\"" } else { "" };
    let because = if is_held { "; GUESS: it stays and leaps, so it is held between its changes" } else { "" };
    format!(
        "{} = {{ column = {}, unit = \"{}\"{wraps}{hold} }}  # {}{because}\n",
        g.name,
        toml_string(&c.name),
        g.unit,
        g.because
    )
}

/// The column of time: named like it or in a unit of time, and rising if there is such a one; else, whatever the language
/// of its name, the only one that rises and has a unit of time, or the first if it does, or rises in even steps.
fn time_of(columns: &[Raw]) -> Option<usize> {
    let rises = |c: &Raw| {
        let end = c.values.iter().rposition(|v| !v.is_nan()).map_or(0, |last| last + 1);
        c.values[..end].windows(2).all(|w| w[0] < w[1]) || c.since.is_some()
    };
    let candidates = || columns.iter().enumerate().filter(|(_, c)| like_time(c));
    let rising = candidates().find(|(_, c)| rises(c));
    // a clock that stands or falls is still the clock: whoever reads it says what is wrong
    let named = rising.or_else(|| candidates().next()).map(|(i, _)| i);
    let is_of_time = |c: &Raw| unit_of(c).is_some_and(|u| u.dimension() == Dimension::TIME);
    let is_first = columns.first().is_some_and(|c| counts(&c.values) || is_of_time(c) && rises(c));
    let mut of_time = (0..columns.len()).filter(|i| is_of_time(&columns[*i]) && rises(&columns[*i]));
    let only = of_time.next().filter(|_| of_time.next().is_none());
    named.or(only).or(is_first.then_some(0))
}

/// Whether values rise in even steps, as a counter or a clock does.
fn counts(values: &[f64]) -> bool {
    let [first, .., last] = *values else { return false };
    let step = (last - first) / (values.len() - 1) as f64;
    values.len() > 3 && step > 0.0 && values.windows(2).all(|w| (w[1] - w[0] - step).abs() <= 0.01 * step)
}

fn like_time(c: &Raw) -> bool {
    let (name, _, in_brackets) = parted(c);
    let unit = unit_of(c).map(|u| u.dimension());
    let whole = name.to_lowercase();
    let first = whole.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
    if c.since.is_some() {
        return true;
    }
    match unit {
        Some(Dimension::TIME) => in_brackets && whole.starts_with('t') || TIMES.contains(&first),
        Some(_) => false,
        None => first != "t" && TIMES.contains(&first) || whole == "t" || whole.ends_with("time"),
    }
}

fn unit_of(c: &Raw) -> Option<Unit> {
    c.unit.as_ref().and_then(|u| Unit::parse(u).ok())
}

/// A header's name, its unit, and whether the unit stands apart from the name.
fn parted(c: &Raw) -> (String, Option<String>, bool) {
    let name = if c.name.ends_with(']') { c.name.clone() } else { record::label(&c.name).name };
    (name, c.unit.clone(), !c.is_guessed)
}

fn guess(index: usize, c: &Raw, taken: &mut BTreeSet<String>) -> Guess {
    let (name, unit, in_brackets) = parted(c);
    let read = unit.clone().filter(|u| Unit::parse(u).is_ok());
    let mut because = match (&unit, &read) {
        (Some(_), Some(_)) if in_brackets => "unit from the header".to_string(),
        (_, Some(_)) => "GUESS: unit from the column's name".to_string(),
        (Some(u), None) => format!("GUESS: the header's unit {u:?} is not known; set it"),
        (None, None) => "GUESS: no unit in the header; set it".to_string(),
    };
    let unit = read.unwrap_or_else(|| "1".into());
    let wraps = turns(&unit, &c.values);
    if wraps {
        because += "; GUESS: it jumps by a turn, so it wraps";
    }
    let name = if name.chars().any(char::is_alphanumeric) { name } else { format!("column {}", index + 1) };
    Guess { name: identifier(&name, taken), unit, wraps, because }
}

/// Whether an angle jumps by nearly a turn somewhere.
fn turns(unit: &str, values: &[f64]) -> bool {
    let Ok(unit) = Unit::parse(unit) else { return false };
    if !unit.is_angle() {
        return false;
    }
    let turn = unit.from_si(std::f64::consts::TAU);
    let known: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    known.windows(2).any(|w| (w[1] - w[0]).abs() > 0.9 * turn)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Recording;

    /// What is guessed of a table, and the recording that it then is.
    fn guess_of(text: &str) -> Result<(String, Recording)> {
        let folder = tempfile::tempdir().unwrap();
        let csv = folder.path().join("ship.csv");
        std::fs::write(&csv, text).unwrap();
        let text = guessed(&csv)?;
        let toml = folder.path().join("ship.toml");
        std::fs::write(&toml, &text).unwrap();
        let recording = Recording::read(&toml).unwrap_or_else(|e| panic!("{e}\n{text}"));
        Ok((text, recording))
    }

    #[test]
    fn a_guessed_recording_reads() {
        let rows: String = (0..50)
            .map(|i| format!("{},{},{},{},{}\n", f64::from(i) * 0.1, (355 + i) % 360, i, i, 2 * i))
            .collect();
        let (text, recording) =
            guess_of(&format!("t_s,heading_deg,roll [deg],Load (kg),odd one\n{rows}")).unwrap();
        let heading = recording.channel("heading").unwrap();
        assert!(heading.wraps && heading.unit.text() == "deg");
        assert_eq!(recording.channel("Load").unwrap().unit.text(), "kg");
        assert_eq!(recording.channel("odd_one").unwrap().unit.text(), "1");
        let guesses = text.lines().filter(|l| l.contains("GUESS") && !l.starts_with('#')).count();
        assert_eq!(guesses, 3, "{text}");
    }

    #[test]
    fn a_heading_under_the_sign_of_degrees_wraps() {
        let rows: String =
            (0..50).map(|i| format!("{i},{},{i},{1},{1}\n", (355 + i) % 360, 400 * i)).collect();
        let (_, recording) = guess_of(&format!("t_s,Kurs °,Krängung °,Tropfen,Last [%]\n{rows}")).unwrap();
        let wraps: Vec<bool> = recording.channels.iter().map(|c| c.wraps).collect();
        // what has no unit counts no angle, however it jumps
        assert_eq!(wraps, [true, false, false, false]);
    }

    /// A gap leaves no even steps.
    #[test]
    fn a_first_column_in_seconds_is_the_time_in_any_language_and_with_a_gap() {
        let rows: String = (0..50).map(|i| format!("{},{i}\n", if i < 20 { i } else { i + 7 })).collect();
        for name in ["Zeit [s]", "Aika [min]", "Tempo [s]"] {
            let (text, recording) = guess_of(&format!("{name},x [m]\n{rows}")).unwrap();
            assert!(text.contains("time = { column = ") && !text.contains("GUESS: no column"), "{text}");
            assert_eq!(recording.channels.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(), ["x"]);
        }
        let back: String =
            rows.lines().filter_map(|l| l.split_once(',')).map(|(t, x)| format!("{x},{t}\n")).collect();
        let (text, _) = guess_of(&format!("x [m],Zeit [s]\n{back}")).unwrap();
        assert!(text.contains("time = { column = \"Zeit\""), "{text}");
        let (text, _) = guess_of(&format!("Reise [s],x [m]\n{}", rows.replace("30,", "3,"))).unwrap();
        assert!(text.contains("GUESS: no column rises like time"), "{text}");
    }

    #[test]
    fn quoted_names_texts_and_dates_become_a_recording() {
        let (text, recording) = guess_of(
            "\"date, UTC\",\"roll, port [deg]\",state,\n2026-01-02T03:04:05Z,1.5,calm,7\n2026-01-02T03:04:05.5Z,2.5,calm,8\n2026-01-02T03:04:06Z,,rough,9\n",
        )
        .unwrap();
        let roll = recording.channel("roll__port").unwrap();
        assert_eq!(roll.time.to_vec(), [0.0, 0.5, 1.0]);
        assert_eq!(roll.values[1], 2.5_f64.to_radians());
        assert_eq!(recording.channel("column_4").unwrap().values, [7.0, 8.0, 9.0]);
        assert!(text.contains("# \"state\": left out") && recording.channels.len() == 2, "{text}");
    }

    #[test]
    fn what_stays_and_leaps_is_held() {
        let rows: String = (0..200)
            .map(|i| {
                let t = f64::from(i) * 0.01;
                let command = (1.0 + f64::from(i / 10 * 7 % 11)) * 0.1;
                let valve = f64::from(i / 25 % 2);
                // a slow signal read in steps of 0.1 goes on by one step at a time
                let coarse = (30.0 * (0.5 * t).sin()).round() * 0.1;
                format!("{t:.2},{command},{valve},{coarse},{}\n", (7.0 * t).sin())
            })
            .collect();
        let (text, recording) = guess_of(&format!("t [s],u [V],valve [1],slow [m],q [m]\n{rows}")).unwrap();
        let held = |name: &str| recording.channel(name).unwrap().hold == crate::record::Hold::Previous;
        assert_eq!(["u", "valve", "slow", "q"].map(held), [true, true, false, false], "{text}");
    }

    #[test]
    fn a_clock_without_a_known_name_is_still_the_clock() {
        for header in ["unixtime,temp,rpm", "n,temp,rpm"] {
            let (text, recording) = guess_of(&format!(
                "{header}\n1700000000.0,1,600\n1700000000.5,2,610\n1700000001.0,4,620\n1700000001.5,3,630\n"
            ))
            .unwrap();
            let rpm = recording.channel("rpm").unwrap();
            assert_eq!((rpm.time[1] - rpm.time[0], rpm.unit.text()), (0.5, "rpm"), "{text}");
            assert_eq!(recording.channels.len(), 2, "{text}");
        }
    }

    #[test]
    fn what_is_no_recording_is_refused_with_its_place() {
        for (text, line, column, says) in [
            ("t [s];roll [deg]\n0,1\n", 1, 6, "semicolons"),
            ("t [s]\troll [deg]\n0,1\n", 1, 6, "tabs"),
            ("PK\u{3}\u{4}\u{0}\u{0}\n0,1\n", 1, 1, "spreadsheet"),
            ("t,roll,roll\n0,1,2\n", 1, 8, "both named"),
            ("t,roll\n0,1\n2,1\n1,1\n", 4, 1, "backwards"),
            ("t,roll\n0,1\n1,two\n", 3, 3, "no number"),
            ("t,roll\n0,1\n1\n", 3, 1, "fields"),
            ("time,roll\n2026-01-02 00:00:00,1\n2026-02-30 00:00:01,1\n", 3, 1, "28 days"),
            ("t,state\n0,calm\n1,calm\n", 1, 0, "no column beside the time"),
        ] {
            let error = guess_of(text).expect_err(text);
            let place = (error.line().unwrap_or(0), error.column().unwrap_or(0));
            assert_eq!(place, (line, column), "{error}");
            assert!(error.to_string().contains(says) && error.file().is_some(), "{error}");
        }
    }
}
