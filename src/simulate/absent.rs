//! Channels that a model asks for and a recording does not have: which of its columns they may be.

use crate::Result;
use crate::error::nearest;
use crate::model::Model;
use crate::record::Recording;
use crate::text::toml_string;
use crate::units::Unit;
use std::fmt::Write;

/// A signal of a model: input or output, its name, its unit.
type Signal<'a> = (&'static str, &'a str, &'a Unit);

/// Refuses a recording that lacks a channel of a model's inputs or outputs.
///
/// # Errors
/// `BadInput` that says which columns it would take for those that are absent, and how to write that down.
pub fn present(model: &Model, recording: &Recording) -> Result<()> {
    let outputs = model.outputs.iter().map(|o| ("output", o.name.as_str(), &o.unit));
    all_of(recording, &inputs(model).chain(outputs).collect::<Vec<_>>(), &[])
}

/// The same of inputs alone.
///
/// # Errors
/// As [`present`].
pub(super) fn inputs_present(model: &Model, recording: &Recording) -> Result<()> {
    // a column of an output's name holds that output, whatever else is missing
    let outputs: Vec<&str> = model.outputs.iter().map(|o| o.name.as_str()).collect();
    all_of(recording, &inputs(model).collect::<Vec<_>>(), &outputs)
}

fn inputs(model: &Model) -> impl Iterator<Item = Signal<'_>> {
    model.inputs.iter().map(|i| ("input", i.name.as_str(), &i.unit))
}

fn all_of(recording: &Recording, signals: &[Signal<'_>], others: &[&str]) -> Result<()> {
    let Some((what, name, _)) = signals.iter().find(|s| recording.find(s.1).is_none()) else { return Ok(()) };
    let Err(error) = recording.channel(name) else { return Ok(()) };
    let error = error.about(&format!("{what} {name}"));
    if recording.left_out.iter().any(|l| l.is_named(name) && !l.has_no_unit()) {
        return Err(error);
    }
    Err(match advice(recording, signals, others) {
        Some(advice) => error.with_hint(advice),
        None => error,
    })
}

/// The lines of a recording file that give each signal its column; none where no column is likely. Columns with the
/// names of others are not theirs.
fn advice(recording: &Recording, signals: &[Signal<'_>], others: &[&str]) -> Option<String> {
    let named = signals.iter().map(|s| s.1).chain(others.iter().copied());
    let mut taken: Vec<&str> = named.filter_map(|name| Some(recording.find(name)?.name.as_str())).collect();
    let (mut lines, mut is_any) = (String::new(), false);
    for (_, name, unit) in signals {
        let line = if let Some(channel) = recording.find(name) {
            entry(name, &channel.name, channel.unit.text(), "")
        } else if let Some((column, unit, why)) = guess(recording, (name, unit), &taken) {
            is_any = true;
            taken.push(column);
            entry(name, column, unit, &format!("  # GUESS: {why}"))
        } else {
            format!("{}  # which column?\n", entry(&format!("# {name}"), "", unit.text(), "").trim_end())
        };
        lines += &line;
    }
    let [source] = recording.sources.as_slice() else { return None };
    let file = source.file.file_name()?.to_string_lossy();
    is_any.then(|| {
        format!(
            "save these lines beside {file} as a file that ends with .toml, look them over, and give that file \
             instead:\n[[tables]]\nfile = {}\n[tables.channels]\n{}",
            toml_string(&file),
            lines.trim_end()
        )
    })
}

fn entry(name: &str, column: &str, unit: &str, comment: &str) -> String {
    let mut line = String::new();
    let _ = writeln!(
        line,
        "{name} = {{ column = {}, unit = {} }}{comment}",
        toml_string(column),
        toml_string(unit)
    );
    line
}

/// The likeliest column for a signal, its unit, and why: the nearest name, else the only one of that dimension.
fn guess<'a>(
    recording: &'a Recording,
    (name, unit): (&str, &'a Unit),
    taken: &[&str],
) -> Option<(&'a str, &'a str, &'static str)> {
    let fits = |u: &Unit| u.dimension() == unit.dimension();
    let free = || recording.channels.iter().filter(|c| !taken.contains(&c.name.as_str()) && fits(&c.unit));
    let near = nearest(name, free().map(|c| c.name.as_str()));
    let only = || (free().count() == 1).then(|| free().next()).flatten();
    if let Some(column) = near.and_then(|n| free().find(|c| c.name == n)) {
        return Some((&column.name, column.unit.text(), "the nearest name"));
    }
    let labels = || recording.left_out.iter().map(|l| l.label.as_str()).filter(|l| !taken.contains(l));
    if let Some(label) = nearest(name, labels()) {
        return Some((label, unit.text(), "it has no unit there; this is the model's"));
    }
    only().map(|c| (c.name.as_str(), c.unit.text(), "the only one in such a unit"))
}
