//! A model that begins with a Functional Mock-up Unit: what its description says, in the place of equations.
//!
//! `fmu = "Axis.fmu"` gives states, inputs, parameters and outputs as an extended model does; what the file says for a
//! name replaces what the description says. Where a section stands, only what it lists of the unit is driven, set or
//! compared; the rest keeps its start.

use super::form::Form;
use super::simulated::ENDING;
use super::{Initial, Input, Model, Output, Parameter, State};
use crate::error::nearest;
use crate::expression::foreign::{Speaking, loaded};
use crate::expression::{Expr, Foreign, Function};
use crate::fmu::{Course, Drive, Exchange, Fmu, Place, Role, Scalar, Variable};
use crate::record::{Channel, Recording, Source};
use crate::units::Unit;
use crate::{Error, Result};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The unit that a model begins with.
#[derive(Clone)]
pub struct Mockup {
    /// Its archive.
    pub file: PathBuf,
    /// The archive with its hash.
    pub source: Source,
    /// The names that the model gives its variables.
    pub(super) names: Vec<String>,
    /// The number of its code, where it is a function.
    pub(super) code: Option<u16>,
    /// What steps it, where it steps itself.
    pub(crate) drive: Option<Arc<Drive>>,
    /// What of it is left out.
    notes: Vec<String>,
    /// Whether the description gives any of its numbers a unit.
    has_units: bool,
    /// Inputs and outputs that a channel of another name holds: section, name, channel.
    pub(super) channels: Vec<(String, String, String)>,
}

impl std::fmt::Debug for Mockup {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Mockup").field("file", &self.file).finish_non_exhaustive()
    }
}

impl PartialEq for Mockup {
    fn eq(&self, other: &Self) -> bool {
        self.file == other.file && self.names == other.names && self.channels == other.channels
    }
}

/// A number of the unit under the name that the model gives it; start and range in SI.
#[derive(Clone)]
struct Entry {
    name: String,
    /// The name in the description.
    own: String,
    scalar: Scalar,
    has_unit: bool,
    meaning: Option<String>,
    start: f64,
    range: (Option<f64>, Option<f64>),
}

impl Entry {
    /// Whether a key of a model file is its name.
    fn goes_by(&self, key: &str) -> bool {
        self.name == key || self.own == key
    }

    fn pair(&self) -> (String, Scalar) {
        (self.name.clone(), self.scalar.clone())
    }
}

/// A name of the expression language for a variable's name.
pub(super) fn plain(name: &str) -> String {
    let mut text: String = name.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    while text.len() > 1 && text.ends_with('_') {
        text.pop();
    }
    if !text.starts_with(|c: char| c.is_alphabetic() || c == '_') {
        text.insert(0, '_');
    }
    if ["t", "pi"].contains(&text.as_str()) || Function::named(&text).is_some() {
        text.push('_');
    }
    text
}

/// The numbers of a variable: itself, or `A[1,2]` as `A_1_2`.
fn entries(variables: &[Variable], at: usize) -> Vec<Entry> {
    let v = &variables[at];
    let of = |element: usize| {
        let (mut name, mut rest, mut places) = (plain(&v.name), element, Vec::new());
        for size in v.sizes.iter().rev() {
            places.push(rest % size + 1);
            rest /= size;
        }
        places.iter().rev().for_each(|p| name += &format!("_{p}"));
        let start = v.start[element];
        let size = if start == 0.0 { 1.0 } else { start.abs() };
        let scalar = Scalar { place: Place { variable: at, element }, unit: v.unit.clone(), size };
        Entry {
            name,
            own: v.name.clone(),
            scalar,
            has_unit: v.has_unit,
            meaning: v.meaning.clone(),
            start,
            range: v.range,
        }
    };
    (0..v.start.len()).map(of).collect()
}

/// Entries with the units that the model file gives where the description gives none; values in SI then.
fn in_units(mut list: Vec<Entry>, root: &Form<'_>, section: &str) -> Result<Vec<Entry>> {
    let form = root.table(section)?;
    for e in &mut list {
        let key = form.iter().flat_map(|f| &f.fields).map(|f| f.key).find(|k| e.goes_by(k));
        let fields = form.as_ref().zip(key).map(|(f, k)| f.table(k)).transpose()?.flatten();
        if let (false, Some(fields)) = (e.has_unit, fields)
            && let Some(text) = fields.string("unit")?
        {
            e.scalar.unit = Unit::parse(text).map_err(|error| fields.error("unit", error))?;
            e.has_unit = true;
        }
        let si = |x: f64| e.scalar.unit.to_si(x);
        (e.start, e.range) = (si(e.start), (e.range.0.map(si), e.range.1.map(si)));
    }
    Ok(list)
}

/// Those that a section of the file names; all without such a section.
fn wanted(list: Vec<Entry>, root: &Form<'_>, section: &str) -> Result<Vec<Entry>> {
    let Some(form) = root.table(section)? else { return Ok(list) };
    Ok(list.into_iter().filter(|e| form.fields.iter().any(|f| e.goes_by(f.key))).collect())
}

/// What a model has of a unit.
struct Parts {
    states: Vec<Entry>,
    inputs: Vec<Entry>,
    parameters: Vec<Entry>,
    /// All outputs, and the names of those that are compared.
    outputs: Vec<Entry>,
    compared: Vec<String>,
}

impl Parts {
    fn of(fmu: &Fmu, root: &Form<'_>) -> Result<Self> {
        let d = &fmu.description;
        let of = |role: Role| -> Vec<Entry> {
            let is = |i: &usize| d.variables[*i].role == role;
            (0..d.variables.len()).filter(is).flat_map(|i| entries(&d.variables, i)).collect()
        };
        let states = if is_function(fmu) { &d.states[..] } else { &[] };
        let states: Vec<Entry> = states.iter().flat_map(|s| entries(&d.variables, s.0)).collect();
        let compared = wanted(of(Role::Output), root, "outputs")?;
        let parts = Self {
            states: in_units(states, root, "states")?,
            inputs: in_units(wanted(of(Role::Input), root, "inputs")?, root, "inputs")?,
            parameters: in_units(wanted(of(Role::Parameter), root, "parameters")?, root, "parameters")?,
            outputs: in_units(of(Role::Output), root, "outputs")?,
            compared: compared.into_iter().map(|e| e.name).collect(),
        };
        known(root, &parts, &d.variables)?;
        Ok(parts)
    }

    /// Names of the arguments behind the time.
    fn names(&self) -> Vec<String> {
        let all = self.states.iter().chain(&self.inputs).chain(&self.parameters);
        all.map(|e| e.name.clone()).collect()
    }

    fn all(&self) -> impl Iterator<Item = &Entry> {
        self.states.iter().chain(&self.inputs).chain(&self.parameters).chain(&self.outputs)
    }

    fn is_compared(&self, e: &Entry) -> bool {
        self.compared.contains(&e.name)
    }
}

/// Whether a unit is a function that a solver calls, rather than something that steps itself.
fn is_function(fmu: &Fmu) -> bool {
    fmu.kind == gyrospec_fmi::Kind::ModelExchange
}

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
    let mut mockup =
        Mockup { file, source, names, code: None, drive: None, notes, has_units, channels: Vec::new() };
    if is_function(&fmu) {
        mockup.code = Some(as_function(&fmu, &parts, &mut model));
    } else {
        mockup.drive = Some(Arc::new(as_course(&fmu, &parts, &mut model)));
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

/// States and outputs that a solver asks the unit for; the number of its code.
fn as_function(fmu: &Arc<Fmu>, parts: &Parts, model: &mut Model) -> u16 {
    let code = code(fmu, parts);
    let n = parts.states.len();
    let names = parts.names();
    let arguments: Vec<Expr> =
        std::iter::once("t").chain(names.iter().map(String::as_str)).map(|n| Expr::Name(n.into())).collect();
    let result = |k: usize| Expr::Call(Function::Foreign(Foreign::of(code, k as u16)), arguments.clone());
    let state = |k: usize| Expr::Name(parts.states[k].name.clone());
    let same = same_as_states(code, parts);
    for (k, e) in parts.states.iter().enumerate() {
        model.states.push(State {
            name: e.name.clone(),
            rate: same[k].map_or_else(|| result(k), state),
            unit: e.scalar.unit.clone(),
            initial: Initial::Number(e.start),
            meaning: e.meaning.clone(),
        });
    }
    for (k, e) in parts.outputs.iter().enumerate().filter(|(_, e)| parts.is_compared(e)) {
        let own = same[n + k].map_or_else(|| result(n + k), state);
        model.outputs.push(output(e, own));
    }
    code
}

/// The number of the unit's code with these arguments.
fn code(fmu: &Arc<Fmu>, parts: &Parts) -> u16 {
    let second = Unit::of(crate::units::Dimension::TIME);
    let rates = parts.states.iter().map(|e| e.scalar.unit.of_differences().over(&second));
    let units = rates.chain(parts.outputs.iter().map(|e| e.scalar.unit.clone())).collect();
    let lists = [&parts.states, &parts.inputs, &parts.parameters, &parts.outputs];
    let spelled = lists
        .map(|l| l.iter().map(|e| format!("{} {}", e.name, e.scalar.unit)).collect::<Vec<_>>().join(","));
    let key = format!("{} {} {}", fmu.source.file.display(), fmu.source.sha256, spelled.join(";"));
    let list = |l: &[Entry]| -> Vec<Scalar> { l.iter().map(|e| e.scalar.clone()).collect() };
    let exchange = Exchange {
        fmu: fmu.clone(),
        key: key.clone(),
        states: list(&parts.states),
        inputs: list(&parts.inputs),
        parameters: list(&parts.parameters),
        outputs: list(&parts.outputs),
        units,
    };
    loaded(&key, || Arc::new(exchange))
}

/// Points at which a result is held against the states.
const TRIALS: usize = 4;

/// For each result the state that it is, bit by bit, wherever one looks: q̇ = v, or a state that is an output.
fn same_as_states(code: u16, parts: &Parts) -> Vec<Option<usize>> {
    let n = parts.states.len();
    let count = n + parts.outputs.len();
    let Some(compute) = Foreign::of(code, 0).compute() else { return vec![None; count] };
    let starts: Vec<f64> =
        parts.states.iter().chain(&parts.inputs).chain(&parts.parameters).map(|e| e.start).collect();
    let mut may: Vec<Vec<usize>> = vec![(0..n).collect(); count];
    for trial in 1..=TRIALS {
        // parameters stay where they are; states and inputs go to places without a pattern
        let moves = n + parts.inputs.len();
        let moved = |(i, x): (usize, &f64)| {
            let shift = (0.37 + 0.61 * (i * TRIALS + trial) as f64).sin();
            if i < moves { x + shift * if *x == 0.0 { 1.0 } else { x.abs() } } else { *x }
        };
        let mut at = vec![0.1 * trial as f64];
        at.extend(starts.iter().enumerate().map(moved));
        for (k, may) in may.iter_mut().enumerate() {
            let value = compute.value(&at, k);
            may.retain(|j| value == at[1 + j]);
        }
    }
    let second = Unit::of(crate::units::Dimension::TIME);
    let is_free = !parts.all().any(|e| e.has_unit);
    let fits = |k: usize, j: usize| {
        let own = &parts.states[j].scalar.unit;
        let wanted = match parts.states.get(k) {
            Some(state) => state.scalar.unit.of_differences().over(&second),
            None => parts.outputs[k - n].scalar.unit.clone(),
        };
        is_free || wanted.dimension() == own.dimension()
    };
    may.into_iter().enumerate().map(|(k, m)| m.into_iter().find(|j| fits(k, *j))).collect()
}

/// Outputs of a unit that steps itself.
fn as_course(fmu: &Arc<Fmu>, parts: &Parts, model: &mut Model) -> Drive {
    let outputs: Vec<&Entry> = parts.outputs.iter().filter(|e| parts.is_compared(e)).collect();
    for e in &outputs {
        let own = format!("{}{ENDING}", e.name);
        let meaning = Some(format!("{} as the FMU has it", e.name));
        model.inputs.push(Input { name: own.clone(), unit: e.scalar.unit.clone(), meaning });
        model.outputs.push(output(e, Expr::Name(own)));
    }
    Drive {
        fmu: fmu.clone(),
        inputs: parts.inputs.iter().map(Entry::pair).collect(),
        parameters: parts.parameters.iter().map(Entry::pair).collect(),
        outputs: outputs.into_iter().map(Entry::pair).collect(),
    }
}

/// Refuses a key that the unit does not have and that brings no equation of its own.
fn known(root: &Form<'_>, parts: &Parts, variables: &[Variable]) -> Result<()> {
    let lists = [
        ("states", &parts.states),
        ("inputs", &parts.inputs),
        ("parameters", &parts.parameters),
        ("outputs", &parts.outputs),
    ];
    for (section, list) in lists {
        let Some(form) = root.table(section)? else { continue };
        for (key, span, fields) in form.tables()? {
            let is_own = match section {
                "states" => fields.field("rate").is_some(),
                "outputs" => fields.field("equals").is_some(),
                _ => spoken_of(root, key)?,
            };
            if is_own || list.iter().any(|e| e.goes_by(key)) {
                continue;
            }
            let e = Error::bad_input(format!("the FMU has no variable {key:?} for [{section}]"));
            let near = nearest(key, variables.iter().map(|v| v.name.as_str()));
            let e = near.map_or(e.clone(), |n| e.with_hint(format!("the nearest of its variables is {n}")));
            return Err(form.at(e, &span));
        }
    }
    Ok(())
}

/// Whether an expression of the file speaks of a name.
fn spoken_of(root: &Form<'_>, name: &str) -> Result<bool> {
    for (section, key) in [("definitions", "equals"), ("states", "rate"), ("outputs", "equals")] {
        let Some(form) = root.table(section)? else { continue };
        for (_, _, fields) in form.tables()? {
            let text = fields.string(key).ok().flatten().unwrap_or_default();
            if text.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|w| w == name) {
                return Ok(true);
            }
        }
    }
    Ok(false)
}

impl Mockup {
    /// The name that the model gives a variable of the unit.
    pub(super) fn name_of(&self, key: &str) -> String {
        let short = plain(key);
        if self.names.contains(&short) { short } else { key.to_owned() }
    }

    /// The channel that holds an input or output.
    pub(super) fn channel(&self, section: &str, name: &str) -> String {
        let own = self.channels.iter().find(|c| c.0 == section && c.1 == name);
        own.map_or_else(|| name.to_owned(), |c| c.2.clone())
    }

    /// The variable that an output of the model is.
    fn variable(&self, output: &str) -> String {
        let own = self.channels.iter().find(|c| c.0 == "outputs" && c.2 == output);
        own.map_or_else(|| output.to_owned(), |c| c.1.clone())
    }

    /// The text of the line that names it.
    pub(super) fn line(&self) -> String {
        format!("fmu = {}\n", crate::text::toml_string(&self.file.to_string_lossy()))
    }
}

/// Whether a file is a unit: an archive.
pub(super) fn is_unit(path: &Path) -> bool {
    let mut first = [0; 4];
    let read = std::fs::File::open(path).and_then(|mut f| std::io::Read::read_exact(&mut f, &mut first));
    read.is_ok() && first == *b"PK\x03\x04"
        || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("fmu")) && path.exists()
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
    let at = compute.starts(&values(None)).map_err(|why| {
        Error::not_computed(format!("the FMU does not start: {why}")).with_file(&mockup.file)
    })?;
    let fitted: Vec<(usize, String)> = model
        .parameters
        .iter()
        .filter(|p| mockup.names.contains(&p.name))
        .enumerate()
        .filter(|(_, p)| p.fit)
        .map(|(k, p)| (k, p.name.clone()))
        .collect();
    for (k, name) in fitted {
        let moved = compute.starts(&values(Some(k))).unwrap_or_else(|_| at.clone());
        let depends = model
            .states
            .iter()
            .zip(at.iter().zip(&moved))
            .find(|(s, (a, b))| free.contains(&s.name) && a != b);
        if let Some((s, _)) = depends {
            let e = Error::bad_input(format!(
                "the FMU's state {} starts where the fitted parameter {name} says",
                s.name
            ));
            return Err(e.with_hint(format!("add [states] with {} = {{ initial = \"fit\" }}", s.name)));
        }
    }
    for (s, value) in model.states.iter_mut().zip(at).filter(|(s, _)| free.contains(&s.name)) {
        s.initial = Initial::Number(value);
    }
    Ok(())
}

/// Gives an input or output the name of the channel that holds it.
fn rename(model: &mut Model, (section, name): (&str, &str), channel: &str) -> Result<()> {
    if !crate::expression::is_name(channel) {
        let e = Error::bad_input(format!("the channel {channel:?} cannot be a name of a model"));
        return Err(e.with_hint("give that column a plain name in a TOML recording"));
    }
    if section == "outputs" {
        model.outputs.iter_mut().filter(|o| o.name == name).for_each(|o| o.name = channel.to_owned());
    } else {
        model.inputs.iter_mut().filter(|i| i.name == name).for_each(|i| i.name = channel.to_owned());
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
    /// Whether an input of the model is what the FMU gives when it steps itself.
    pub(super) fn steps(&self, input: &str) -> bool {
        let drive = self.fmu.as_ref().and_then(|m| m.drive.as_ref());
        let stem = input.strip_suffix(ENDING);
        stem.zip(drive).is_some_and(|(stem, d)| d.outputs.iter().any(|o| o.0 == stem))
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

    /// The line of a model file that names the FMU.
    pub(super) fn unit_line(&self) -> String {
        self.fmu.as_ref().map_or_else(String::new, Mockup::line)
    }

    /// The channel that a key of a section is written with, and the key.
    pub(super) fn key_of(&self, section: &str, name: &str) -> (String, Option<String>) {
        let own = self.fmu.iter().flat_map(|m| &m.channels).find(|c| c.0 == section && c.2 == name);
        own.map_or_else(|| (name.to_owned(), None), |c| (c.1.clone(), Some(c.2.clone())))
    }

    /// What the FMU is stepped over: a recording's times and inputs, at the values of the model's parameters.
    pub(super) fn stepped(&self, recording: &Recording) -> Result<Option<Recording>> {
        let Some((mockup, drive)) = self.fmu.as_ref().and_then(|m| Some((m, m.drive.as_ref()?))) else {
            return Ok(None);
        };
        let own = |o: &Output| format!("{}{ENDING}", mockup.variable(&o.name));
        if self.outputs.iter().all(|o| recording.find(&own(o)).is_some()) {
            return Ok(None);
        }
        let inputs = drive.inputs.iter().map(|(name, _)| recording.channel(&mockup.channel("inputs", name)));
        let inputs: Vec<&Channel> = inputs.collect::<Result<_>>()?;
        let times = self.outputs.iter().find_map(|o| recording.find(&o.name)).or(inputs.first().copied());
        let Some(clock) = times else {
            return Err(Error::bad_input(format!("'{}' has no channel of the FMU", recording.name)));
        };
        let inside = |t: f64| inputs.iter().filter_map(|c| c.range()).all(|r| r.from <= t && t <= r.to);
        let times: Vec<f64> = clock.time.iter().copied().filter(|t| inside(*t)).collect();
        let value = |c: &Channel, t: f64| c.value_at(t).unwrap_or(f64::NAN);
        let at = |t: f64| inputs.iter().map(|c| value(c, t)).collect::<Vec<_>>();
        if let Some(t) = times.iter().find(|t| at(**t).iter().any(|v| v.is_nan())) {
            let e = Error::bad_input(format!(
                "an input of the FMU has a gap at t = {t} s in '{}'",
                recording.name
            ));
            return Err(e.with_hint(
                "an FMU that steps itself cannot wait: cut the recording there, or fill the gap",
            ));
        }
        let value_of =
            |name: &String| self.parameters.iter().find(|p| p.name == *name).map_or(0.0, |p| p.value);
        let parameters: Vec<f64> = drive.parameters.iter().map(|(name, _)| value_of(name)).collect();
        let ran = drive.run(&Course { times: &times, inputs: &at, parameters: &parameters })?;
        let mut joined = recording.clone();
        let table = clock.table;
        let shared: Arc<[f64]> = times.into();
        for ((name, s), values) in drive.outputs.iter().zip(ran) {
            let channel = Channel::new(format!("{name}{ENDING}"), s.unit.clone(), shared.clone(), values);
            joined.channels.push(Channel { table, ..channel });
        }
        Ok(Some(joined))
    }
}
