//! A simulation of which only the output is known: its table stands in the place of equations.
//!
//! `simulated = "sim.csv"` brings a column `x` of that table into expressions as `x_simulated`; an output without
//! `equals` is the column of its own name.

use super::begun::Simulated;
use super::clocks;
use super::form::Form;
use super::{Input, Model, Output, bare};
use crate::error::nearest;
use crate::expression::Expr;
use crate::record::{Channel, Kind, Recording, Source};
use crate::text::toml_string;
use crate::{Error, Result};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// What stands behind the name of a column in expressions.
pub(super) const ENDING: &str = "_simulated";

impl Model {
    /// Whether an input is what a simulation computed, rather than what was measured.
    pub(crate) fn is_simulated(&self, input: &str) -> bool {
        self.simulated.as_ref().is_some_and(|s| s.gives(input)) || self.steps(input)
    }

    /// A recording with the series that come with the model.
    ///
    /// # Errors
    /// `BadInput` where the recording has a channel of the name of such a series, or holds steady trials.
    pub(crate) fn joined<'r>(&self, recording: &'r Recording) -> Result<Cow<'r, Recording>> {
        let Some(plain) = self.plainly(recording) else { return self.with_simulated(recording) };
        self.with_simulated(&plain).map(|c| Cow::Owned(c.into_owned()))
    }

    fn with_simulated<'r>(&self, recording: &'r Recording) -> Result<Cow<'r, Recording>> {
        if let Some(stepped) = self.stepped(recording)? {
            return Ok(Cow::Owned(stepped));
        }
        let Some(simulated) = &self.simulated else { return Ok(Cow::Borrowed(recording)) };
        let file = simulated.file.display();
        if recording.sources.contains(&simulated.source)
            && simulated.channels.iter().all(|c| recording.find(&c.name).is_some())
        {
            return Ok(Cow::Borrowed(recording));
        }
        if recording.kind == Kind::Trials {
            let e = Error::bad_input(format!(
                "'{}' holds steady trials, '{file}' a course of time",
                recording.name
            ));
            return Err(e.with_hint("give a recording on a clock"));
        }
        if let Some(c) = simulated.channels.iter().find(|c| recording.find(&c.name).is_some()) {
            let e = Error::bad_input(format!(
                "'{}' has a channel {:?}, which is what '{file}' gives",
                recording.name, c.name
            ));
            return Err(e.with_hint("rename that channel of the recording"));
        }
        let mut joined = recording.clone();
        let table = joined.channels.iter().map(|c| c.table + 1).max().unwrap_or(0);
        let later = clocks::seconds_later(simulated, recording)?;
        joined.channels.extend(simulated.channels.iter().map(|c| clocks::moved(c, table, later)));
        joined.sources.push(simulated.source.clone());
        Ok(Cow::Owned(joined))
    }

    /// Recordings with the series that come with the model.
    ///
    /// # Errors
    /// As for one.
    pub(crate) fn all_joined<'r>(&self, recordings: &'r [Recording]) -> Result<Cow<'r, [Recording]>> {
        if !self.is_free && self.inputs.iter().all(|i| !self.is_simulated(&i.name)) {
            return Ok(Cow::Borrowed(recordings));
        }
        recordings
            .iter()
            .map(|r| self.joined(r).map(Cow::into_owned))
            .collect::<Result<Vec<_>>>()
            .map(Cow::Owned)
    }

    /// The file that the model begins with: what was simulated, or a Functional Mock-up Unit.
    pub fn begun_with(&self) -> Option<&Source> {
        self.simulated.as_ref().map(|s| &s.source).or_else(|| self.unit_source())
    }

    /// Where samples lie that cannot be compared.
    pub(crate) fn uncompared(&self) -> &'static str {
        let all_simulated = self.inputs.iter().all(|i| self.is_simulated(&i.name));
        if self.simulated.is_some() && all_simulated {
            "outside what was simulated, in a gap of it, or too soon after one"
        } else {
            "outside the inputs, in a gap of theirs, or too soon after one"
        }
    }

    /// What a user should know of what the model begins with.
    pub(crate) fn cautions(&self) -> Vec<String> {
        self.unit_notes().into_iter().chain(self.free_note()).chain(self.kelvin_notes()).collect()
    }

    /// What a user should know of a recording beside what the model begins with.
    pub(crate) fn caution_of(&self, recording: &Recording) -> Option<String> {
        self.simulated.as_ref().and_then(|s| clocks::caution(s, recording))
    }

    /// The text of the model's file as [`Model::to_toml`] gives it, for a file in a folder: what the model begins with is
    /// named from there where it lies in it, so that both can be moved together.
    pub fn to_toml_in(&self, folder: &Path) -> String {
        let mut model = self.clone();
        if let Some(file) = model.begun_mut()
            && let Ok(whole) = file.canonicalize()
            && let Ok(short) = whole.strip_prefix(folder)
        {
            short.clone_into(file);
        }
        model.to_toml()
    }

    fn begun_mut(&mut self) -> Option<&mut PathBuf> {
        if self.simulated.is_none() {
            return self.unit_file_mut();
        }
        self.simulated.as_mut().map(|s| &mut s.file)
    }

    /// The line of a model file that names the table, or the FMU.
    pub(super) fn begun_line(&self) -> String {
        let mut out = self.unit_line();
        if let Some(s) = &self.simulated {
            let _ = writeln!(out, "simulated = {}", toml_string(&s.file.to_string_lossy()));
        }
        out
    }
}

/// Where a table that a model file names lies: beside the file.
pub(super) fn place(root: &Form<'_>, folder: Option<&Path>) -> Result<Option<PathBuf>> {
    let Some(file) = root.string("simulated")? else { return Ok(None) };
    let path = folder.unwrap_or(Path::new("")).join(file);
    let whole = std::path::absolute(&path).unwrap_or(path);
    if whole.is_file() {
        return Ok(Some(whole));
    }
    let e = Error::bad_input(format!("there is no file '{}' with what was simulated", whole.display()));
    Err(root.error("simulated", e.with_hint("simulated = \"…\" names a table, beside the model file")))
}

/// The expression of an output that gives none.
pub(super) fn own_column(output: &str) -> Expr {
    Expr::Name(format!("{output}{ENDING}"))
}

/// Reads the columns that the model speaks of, and makes each an input.
pub(super) fn attach(model: &mut Model, root: &Form<'_>, file: PathBuf) -> Result<()> {
    let at = |e: Error| root.error("simulated", e);
    let names = spoken_of(model);
    if names.is_empty() {
        let e = Error::bad_input("no output speaks of what was simulated");
        return Err(at(e.with_hint("an output without `equals` is the column of its own name")));
    }
    let read = read(&file, names.iter().map(String::as_str), model)?;
    let mut channels = Vec::new();
    for name in &names {
        let stem = name.strip_suffix(ENDING).unwrap_or(name);
        let output = model.outputs.iter().find(|o| o.name == stem && o.equals == own_column(stem));
        let unit = output.map(|o| &o.unit);
        let channel = column(&file, &read, stem);
        let channel = channel.map_err(|e| if e.file().is_some() { e } else { at(e) })?;
        if let Some(unit) = unit.filter(|u| u.dimension() != channel.unit.dimension()) {
            let e = Error::new(
                crate::ErrorKind::Units,
                format!(
                    "{stem} has the unit {unit} in the model, but {} in '{}'",
                    channel.unit,
                    file.display()
                ),
            );
            return Err(at(e));
        }
        model.inputs.push(Input {
            name: name.clone(),
            unit: channel.unit.clone(),
            meaning: Some(format!("{stem} as it was simulated")),
        });
        channels.push(Channel { name: name.clone(), ..channel });
    }
    let source = read.sources.last().cloned().unwrap_or_else(|| Source::of(&file, &[]));
    model.simulated = Some(Simulated { file, channels: channels.into(), source, zero: read.zero });
    Ok(())
}

/// The names in expressions that end as what was simulated does and that nothing else in the model has.
fn spoken_of(model: &Model) -> BTreeSet<String> {
    let rates = model.states.iter().map(|s| &s.rate);
    let all = rates
        .chain(model.definitions.iter().map(|d| &d.equals))
        .chain(model.outputs.iter().map(|o| &o.equals));
    let scope = model.scope();
    let mut names = BTreeSet::new();
    for e in all {
        let mut known = e.names();
        known.retain(|n| n.len() > ENDING.len() && n.ends_with(ENDING) && !scope.contains_key(*n));
        names.extend(known.into_iter().map(str::to_owned));
    }
    names
}

/// Reads the table. Simulations seldom write units: a column is then in the unit of the output of its name.
fn read<'n>(file: &Path, names: impl Iterator<Item = &'n str>, model: &Model) -> Result<Recording> {
    let wanted: Vec<bare::Wanted> = names
        .map(|name| {
            let stem = name.strip_suffix(ENDING).unwrap_or(name);
            bare::Wanted { name: stem.into(), unit: unit_of_column(model, name) }
        })
        .collect();
    bare::read(file, &wanted, |there, name| Some(absent(file, name, there)))
}

/// The unit of the output of a column's name, else of one that is that column and nothing more.
fn unit_of_column(model: &Model, name: &str) -> Option<String> {
    let is_own = |o: &&Output| o.name == name.strip_suffix(ENDING).unwrap_or(name);
    let is_it = |o: &&Output| matches!(&o.equals, Expr::Name(n) if n == name);
    let output = model.outputs.iter().find(is_own).or_else(|| model.outputs.iter().find(is_it));
    output.map(|o| o.unit.text().to_owned())
}

/// A column of the table.
fn column(file: &Path, read: &Recording, name: &str) -> Result<Channel> {
    if let Some(channel) = read.find(name) {
        return Ok(channel.clone());
    }
    if let (Some(_), Err(error)) = (read.left_out.iter().find(|l| l.is_named(name)), read.channel(name)) {
        return Err(error);
    }
    let names: Vec<&str> = read.channels.iter().map(|c| c.name.as_str()).collect();
    Err(absent(file, name, &names))
}

/// The error of a column that the table does not have.
fn absent(file: &Path, name: &str, there: &[&str]) -> Error {
    let error = Error::bad_input(format!("'{}' has no column {name:?}", file.display()));
    let meant = nearest(name, there.iter().copied()).or(there.first().copied()).unwrap_or("x");
    error.with_hint(format!("it has {}; `equals = \"{meant}{ENDING}\"` takes {meant}", there.join(", ")))
}
