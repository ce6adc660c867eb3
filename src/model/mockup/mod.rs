//! A model that begins with a Functional Mock-up Unit: what its description says, in the place of equations.
//!
//! `fmu = "Axis.fmu"` gives states, inputs, parameters and outputs as an extended model does; what the file says for a
//! name replaces what the description says. Where a section stands, only what it lists of the unit is driven, set or
//! compared; the rest keeps its start.

mod course;
mod function;
mod parts;

use super::begun::Mockup;
use super::form::Form;
use super::{Initial, Input, Model, Output, Parameter};
use crate::expression::foreign::Speaking;
use crate::expression::{Expr, Foreign};
use crate::fmu::Fmu;
use crate::record::Source;
use crate::{Error, Result};
use parts::{Entry, Parts, is_function, plain};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Rate of a state, as a share of its size or of 1, by which it stands still.
const STANDS: f64 = 1e-6;

/// What a file's line `fmu = "…"` begins with.
pub(super) fn start(root: &Form<'_>, file: &Path) -> Result<Model> {
    let fmu = Fmu::load(file)?;
    let parts = Parts::of(&fmu, root)?;
    let names = parts.names();
    let mut seen = BTreeSet::new();
    if let Some(twice) = names.iter().find(|n| !seen.insert(n.as_str())) {
        let e = Error::bad_input(format!("two variables of the FMU would both have the name {twice:?} here"));
        return Err(e.with_file(file).with_hint("name the one that is meant in [inputs] or [parameters]"));
    }
    let mut model = Model { name: fmu.description.name.clone(), ..Model::empty() };
    model.inputs = parts.inputs.iter().map(input).collect();
    model.parameters = parts.parameters.iter().map(parameter).collect();
    let (file, source) = (fmu.source.file.clone(), fmu.source.clone());
    let notes = fmu.description.notes.clone();
    let has_units = parts.all().any(|e| e.has_unit);
    let mut mockup = Mockup {
        file,
        source,
        names,
        code: None,
        drive: None,
        fitted: Vec::new(),
        notes,
        has_units,
        channels: Vec::new(),
    };
    if is_function(&fmu) {
        mockup.code = Some(function::as_function(&fmu, &parts, &mut model));
    } else {
        mockup.drive = Some(Arc::new(course::as_course(&fmu, &parts, &mut model)));
    }
    model.fmu = Some(mockup);
    Ok(model)
}

fn input(e: &Entry) -> Input {
    Input { name: e.name.clone(), unit: e.scalar.unit.clone(), meaning: e.meaning.clone() }
}

fn parameter(e: &Entry) -> Parameter {
    Parameter {
        name: e.name.clone(),
        value: e.start,
        unit: e.scalar.unit.clone(),
        fit: false,
        min: e.range.0.filter(|m| *m <= e.start),
        max: e.range.1.filter(|m| *m >= e.start),
        meaning: e.meaning.clone(),
    }
}

fn output(e: &Entry, equals: Expr) -> Output {
    Output { name: e.name.clone(), equals, unit: e.scalar.unit.clone(), meaning: e.meaning.clone() }
}

impl Mockup {
    /// The name that the model gives a variable of the unit.
    pub(super) fn name_of(&self, key: &str) -> String {
        let short = plain(key);
        if self.names.contains(&short) { short } else { key.to_owned() }
    }

    /// The text of the line that names it.
    pub(super) fn line(&self) -> String {
        format!("fmu = {}\n", crate::text::toml_string(&self.file.to_string_lossy()))
    }
}

/// Whether a file is a unit: an archive.
pub(super) fn is_unit(path: &Path) -> bool {
    // what comes through a pipe can be read only once
    if !path.metadata().is_ok_and(|m| m.is_file()) {
        return false;
    }
    let mut first = [0; 4];
    let read = std::fs::File::open(path).and_then(|mut f| std::io::Read::read_exact(&mut f, &mut first));
    read.is_ok() && first == *b"PK\x03\x04" || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("fmu"))
}

/// The model of a unit alone, without a file beside it.
pub(super) fn read_whole(path: &Path) -> Result<(Model, Source)> {
    let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let text = format!("fmu = {}\n", crate::text::toml_string(&whole.to_string_lossy()));
    let model = Model::parse(&text).map_err(|e| if e.file().is_some() { e } else { e.with_file(path) })?;
    let source = model.fmu.as_ref().map(|m| m.source.clone());
    source.map(|source| (model, source)).ok_or_else(|| Error::bad_input("no unit").with_file(path))
}

/// What the line `fmu = "…"` begins with, where it stands.
pub(super) fn begun(root: &Form<'_>, folder: Option<&Path>) -> Result<Option<Model>> {
    let Some(file) = root.string("fmu")? else { return Ok(None) };
    if root.field("extends").is_some() || root.field("simulated").is_some() {
        let e = Error::bad_input("a model begins with one of fmu, extends and simulated");
        return Err(root.error("fmu", e));
    }
    let path = folder.unwrap_or(Path::new("")).join(file);
    let at = |e: Error| if e.file().is_some() { e } else { root.error("fmu", e) };
    start(root, &path).map(Some).map_err(at)
}

/// While it lives, expressions may speak of the unit's results.
pub(super) fn speaking(model: &Model) -> Speaking {
    Speaking::of(model.fmu.as_ref().and_then(|m| m.code))
}

/// Whether a model begins with a unit whose description gives units.
pub(super) fn has_units(model: &Model) -> bool {
    model.fmu.as_ref().is_some_and(|m| m.has_units)
}

/// Whether a model begins with a unit.
pub(super) fn has(model: &Model) -> bool {
    model.fmu.is_some()
}

/// The name that the model gives what a key of its file means.
pub(super) fn name_of(model: &Model, key: &str) -> String {
    model.fmu.as_ref().map_or_else(|| key.to_owned(), |m| m.name_of(key))
}

/// Starts of states as the unit has them at the parameters of the file, and channels by other names.
pub(super) fn finish(model: &mut Model, root: &Form<'_>) -> Result<()> {
    let Some(mockup) = model.fmu.clone() else { return Ok(()) };
    let given = root.table("states")?;
    let is_given = |name: &str| {
        let own = given.iter().flat_map(|f| &f.fields).find(|f| mockup.name_of(f.key) == name);
        let fields = own.and_then(|f| given.as_ref()?.table(f.key).ok().flatten());
        fields.is_some_and(|f| f.field("initial").is_some())
    };
    let free: Vec<String> = model
        .states
        .iter()
        .map(|s| s.name.clone())
        .filter(|n| mockup.names.contains(n) && !is_given(n))
        .collect();
    if !free.is_empty() {
        starts(model, &mockup, &free)?;
    }
    course::linearise(model);
    for section in ["inputs", "outputs"] {
        let Some(form) = root.table(section)? else { continue };
        for (key, span, fields) in form.tables()? {
            if let Some(channel) = fields.string("channel")? {
                rename(model, (section, &mockup.name_of(key)), channel).map_err(|e| form.at(e, &span))?;
            }
        }
    }
    Ok(())
}

/// The states that the unit starts with at the values of the model's parameters.
fn starts(model: &mut Model, mockup: &Mockup, free: &[String]) -> Result<()> {
    let Some(compute) = mockup.code.and_then(|c| Foreign::of(c, 0).compute()) else { return Ok(()) };
    let values = |moved: Option<usize>| -> Vec<f64> {
        let own = model.parameters.iter().filter(|p| mockup.names.contains(&p.name));
        own.enumerate().map(|(k, p)| if moved == Some(k) { p.value * 1.01 + 1e-3 } else { p.value }).collect()
    };
    let at = compute.starts(&values(None), false).map_err(|why| {
        Error::not_computed(format!("the FMU does not start: {why}")).with_file(&mockup.file)
    })?;
    let moved = compute.starts(&values(None), true).unwrap_or_else(|_| at.clone());
    if let Some(s) = follower(model, (&at, &moved), free) {
        let stands = |x: &[f64], is_moved: bool| {
            let rates = compute.rates(x, &values(None), is_moved);
            rates.iter().zip(x).all(|(r, x)| r.abs() <= STANDS * x.abs().max(1.0))
        };
        if !stands(&at, false) || !stands(&moved, true) {
            let e =
                Error::bad_input(format!("the FMU's state {s} starts where its inputs say, and not at rest"));
            return Err(e.with_hint(format!("add [states] with {s} = {{ initial = \"fit\" }}")));
        }
        model.states.iter_mut().filter(|s| free.contains(&s.name)).for_each(|s| s.initial = Initial::Steady);
        return Ok(());
    }
    let fitted: Vec<(usize, String)> = model
        .parameters
        .iter()
        .filter(|p| mockup.names.contains(&p.name))
        .enumerate()
        .filter(|(_, p)| p.fit)
        .map(|(k, p)| (k, p.name.clone()))
        .collect();
    for (k, name) in fitted {
        let moved = compute.starts(&values(Some(k)), false).unwrap_or_else(|_| at.clone());
        if let Some(s) = follower(model, (&at, &moved), free) {
            let e = Error::bad_input(format!(
                "the FMU's state {s} starts where the fitted parameter {name} says"
            ));
            return Err(e.with_hint(format!("add [states] with {s} = {{ initial = \"fit\" }}")));
        }
    }
    for (s, value) in model.states.iter_mut().zip(at).filter(|(s, _)| free.contains(&s.name)) {
        s.initial = Initial::Number(value);
    }
    Ok(())
}

/// The first of the free states that starts elsewhere.
fn follower(model: &Model, (at, moved): (&[f64], &[f64]), free: &[String]) -> Option<String> {
    let both = model.states.iter().zip(at.iter().zip(moved));
    both.into_iter().find(|(s, (a, b))| free.contains(&s.name) && a != b).map(|(s, _)| s.name.clone())
}

/// Gives an input or output the name of the channel that holds it.
fn rename(model: &mut Model, (section, name): (&str, &str), channel: &str) -> Result<()> {
    if !crate::expression::is_name(channel) {
        let e = Error::bad_input(format!("the channel {channel:?} cannot be a name of a model"));
        return Err(e.with_hint("give that column a plain name in a TOML recording"));
    }
    if section == "outputs" {
        model.outputs.iter_mut().filter(|o| o.name == name).for_each(|o| channel.clone_into(&mut o.name));
    } else {
        model.inputs.iter_mut().filter(|i| i.name == name).for_each(|i| channel.clone_into(&mut i.name));
        let by = Expr::Name(channel.to_owned());
        model.states.iter_mut().for_each(|s| s.rate = s.rate.substitute(name, &by));
        model.definitions.iter_mut().for_each(|d| d.equals = d.equals.substitute(name, &by));
        model.outputs.iter_mut().for_each(|o| o.equals = o.equals.substitute(name, &by));
    }
    if let Some(m) = &mut model.fmu {
        m.channels.push((section.to_owned(), name.to_owned(), channel.to_owned()));
    }
    Ok(())
}

impl Model {
    /// The error of a value that the FMU refused, since this was asked last.
    pub(crate) fn refusal(&self) -> Option<Error> {
        let mockup = self.fmu.as_ref()?;
        let why = mockup.code.and_then(|c| Foreign::of(c, 0).compute())?.refusal()?;
        let error = Error::not_computed(format!("the FMU refuses to go on: {why}")).with_file(&mockup.file);
        Some(error.with_hint(
            "a parameter or an input may be out of its range, or modelDescription.xml and the library come from two exports: \
             try it in the tool that made it",
        ))
    }

    /// The archive of the FMU.
    pub(super) fn unit_source(&self) -> Option<&Source> {
        self.fmu.as_ref().map(|m| &m.source)
    }

    /// What a user should know of the FMU.
    pub(super) fn unit_notes(&self) -> Vec<String> {
        let Some(m) = &self.fmu else { return Vec::new() };
        let says = format!("'{}' brings foreign code, which runs with your rights", m.file.display());
        std::iter::once(says).chain(m.notes.iter().cloned()).collect()
    }

    pub(super) fn unit_file_mut(&mut self) -> Option<&mut PathBuf> {
        self.fmu.as_mut().map(|m| &mut m.file)
    }

    /// The line of a model file that names the FMU.
    pub(super) fn unit_line(&self) -> String {
        self.fmu.as_ref().map_or_else(String::new, Mockup::line)
    }

    /// The channel that a key of a section is written with, and the key.
    pub(super) fn key_of(&self, section: &str, name: &str) -> (String, Option<String>) {
        let own = self.fmu.iter().flat_map(|m| &m.channels).find(|c| c.0 == section && c.2 == name);
        own.map_or_else(|| (name.to_owned(), None), |c| (c.1.clone(), Some(c.2.clone())))
    }
}
