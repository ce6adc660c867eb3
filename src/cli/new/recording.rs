//! A recording file guessed from a CSV.

use crate::units::Unit;
use crate::{Error, Result};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::io::Read;
use std::path::Path;

/// Rows that are looked at.
const ROWS: usize = 20_000;

/// A column as the file has it.
struct Column {
    header: String,
    values: Vec<f64>,
}

/// What a column is taken for, and why.
struct Guess {
    name: String,
    unit: String,
    wraps: bool,
    because: String,
}

/// The text of a recording file; every guess is marked.
pub fn guessed(csv: &Path) -> Result<String> {
    let columns = columns(csv)?;
    let stem = csv.file_name().unwrap_or_default().to_string_lossy();
    let stem = stem.split('.').next().unwrap_or_default();
    let time = columns.iter().position(is_time);
    let mut out = format!(
        "# Guessed from the header and the first rows: look at every line marked GUESS.\nname = {}\n\n[[tables]]\nfile = {}\n",
        quoted(stem),
        quoted(&csv.display().to_string())
    );
    match time.map(|i| (&columns[i], guess(&columns[i], &mut BTreeSet::new()))) {
        Some((c, g)) => {
            let (unit, because) = match Unit::parse(&g.unit) {
                Ok(u) if u.dimension() == crate::units::Dimension::TIME => (g.unit, g.because),
                _ => ("s".into(), "GUESS: seconds, as the header names no unit of time".into()),
            };
            let _ = writeln!(out, "time = {{ column = {}, unit = \"{unit}\" }}  # {because}", quoted(&c.header));
        }
        None => out.push_str(
            "time = { start = 0.0, step = 1.0, unit = \"s\" }  # GUESS: no column rises like time; set the step, or write kind = \"trials\" above and drop this line where each row is a steady trial\n",
        ),
    }
    out.push_str("[tables.channels]\n");
    let mut taken = BTreeSet::new();
    for (_, c) in columns.iter().enumerate().filter(|(i, _)| Some(*i) != time) {
        let g = guess(c, &mut taken);
        let wraps = if g.wraps { ", wraps = true" } else { "" };
        let _ = writeln!(
            out,
            "{} = {{ column = {}, unit = \"{}\"{wraps} }}  # {}",
            g.name,
            quoted(&c.header),
            g.unit,
            g.because
        );
    }
    out.push_str("\n# What is held out; without this the last 40 % of the time.\n# [spans]\n# fit = [[0.0, 600.0]]\n# holdout = [[600.0, 1000.0]]\n");
    Ok(out)
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_string()).to_string()
}

fn columns(path: &Path) -> Result<Vec<Column>> {
    let file = std::fs::File::open(path).map_err(|e| Error::io(path, &e))?;
    let packed = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("gz"));
    let input: Box<dyn Read> =
        if packed { Box::new(flate2::read::MultiGzDecoder::new(file)) } else { Box::new(file) };
    let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(input);
    let wrong = |e: csv::Error| Error::bad_input(format!("{}: {e}", path.display()));
    let header = reader.headers().map_err(wrong)?.clone();
    if header.is_empty() || header.iter().all(|h| h.parse::<f64>().is_ok()) {
        return Err(Error::bad_input(format!("{}: the first line holds no names", path.display()))
            .with_hint("put a line such as `t [s],roll [deg]` before the first row"));
    }
    let mut columns: Vec<Column> =
        header.iter().map(|h| Column { header: h.to_string(), values: Vec::new() }).collect();
    for row in reader.records().take(ROWS) {
        let row = row.map_err(wrong)?;
        for (i, c) in columns.iter_mut().enumerate() {
            c.values.push(row.get(i).and_then(|f| f.parse().ok()).unwrap_or(f64::NAN));
        }
    }
    Ok(columns)
}

/// Whether a column is named like time and rises.
fn is_time(c: &Column) -> bool {
    let (name, _, _) = parted(&c.header);
    let first = name.to_lowercase();
    let first = first.split('_').next().unwrap_or_default().to_string();
    let named = ["t", "time", "timestamp", "seconds", "clock"].contains(&first.as_str());
    named && c.values.windows(2).all(|w| w[0] < w[1])
}

/// A header's name, its unit, and whether the unit stands in brackets.
fn parted(header: &str) -> (String, Option<String>, bool) {
    for (open, close) in [('[', ']'), ('(', ')')] {
        if let Some((name, unit)) = header.strip_suffix(close).and_then(|h| h.rsplit_once(open)) {
            return (name.trim().to_string(), Some(unit.trim().to_string()), true);
        }
    }
    match header.rsplit_once(['_', ' ']) {
        Some((name, unit)) if spelled(unit).is_some() => (name.to_string(), spelled(unit), false),
        _ => (header.to_string(), None, false),
    }
}

/// The unit that a last word of a name means.
fn spelled(word: &str) -> Option<String> {
    let per = |top: &str| format!("{top}/s");
    let known = match word.to_lowercase().as_str() {
        "deg" | "degrees" => "deg".into(),
        "degs" | "dps" => per("deg"),
        "rads" => per("rad"),
        "ms2" | "mss" => "m/s^2".into(),
        "mps" => "m/s".into(),
        "kn" | "kt" | "knots" => "kn".into(),
        "c" | "celsius" => "degC".into(),
        "sec" | "seconds" => "s".into(),
        _ => word.to_string(),
    };
    // A last letter alone is rather an index than a unit, unless it is one of these.
    let doubtful = known.len() == 1 && !["s", "m", "N", "V", "A", "K"].contains(&known.as_str());
    (!doubtful && known != "1" && Unit::parse(&known).is_ok()).then_some(known)
}

fn guess(c: &Column, taken: &mut BTreeSet<String>) -> Guess {
    let (name, unit, in_brackets) = parted(&c.header);
    let read =
        unit.as_deref().and_then(|u| Unit::parse(u).is_ok().then(|| u.to_string()).or_else(|| spelled(u)));
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
    if c.values.iter().all(|v| v.is_nan()) {
        because += "; GUESS: it holds no numbers, leave it out";
    }
    Guess { name: identifier(&name, taken), unit, wraps, because }
}

/// Whether an angle jumps by nearly a turn somewhere.
fn turns(unit: &str, values: &[f64]) -> bool {
    let turn = match unit {
        "deg" => 360.0,
        "rad" => std::f64::consts::TAU,
        _ => return false,
    };
    let known: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    known.windows(2).any(|w| (w[1] - w[0]).abs() > 0.9 * turn)
}

/// A name that expressions can use, and that none before has.
fn identifier(name: &str, taken: &mut BTreeSet<String>) -> String {
    let plain: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let plain = plain.trim_matches('_');
    let starts_well = plain.starts_with(|c: char| c.is_ascii_alphabetic());
    let base = if starts_well { plain.to_string() } else { format!("channel_{plain}") };
    let reserved =
        ["t", "pi"].contains(&base.as_str()) || crate::expression::Function::named(&base).is_some();
    let base = if reserved { format!("{base}_signal") } else { base };
    let mut free = base.clone();
    let mut number = 2;
    while !taken.insert(free.clone()) {
        free = format!("{base}_{number}");
        number += 1;
    }
    free
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Recording;

    #[test]
    fn a_guessed_recording_reads() {
        let folder = tempfile::tempdir().unwrap();
        let csv = folder.path().join("ship.csv");
        let rows: String = (0..50)
            .map(|i| format!("{},{},{},{},{}\n", f64::from(i) * 0.1, (355 + i) % 360, i, i, 2 * i))
            .collect();
        std::fs::write(&csv, format!("t_s,heading_deg,roll [deg],Load (kg),odd one\n{rows}")).unwrap();
        let text = guessed(&csv).unwrap();
        let toml = folder.path().join("ship.toml");
        std::fs::write(&toml, &text).unwrap();
        let recording = Recording::read(&toml).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let heading = recording.channel("heading").unwrap();
        assert!(heading.wraps && heading.unit.text() == "deg");
        assert_eq!(recording.channel("Load").unwrap().unit.text(), "kg");
        assert_eq!(recording.channel("odd_one").unwrap().unit.text(), "1");
        let guesses = text.lines().filter(|l| l.contains("GUESS") && !l.starts_with('#')).count();
        assert_eq!(guesses, 3, "{text}");
    }
}
