//! The variables of a unit as a model names them.

use super::super::form::Form;
use crate::error::nearest;
use crate::expression::Function;
use crate::fmu::{Fmu, Place, Role, Scalar, Variable};
use crate::units::Unit;
use crate::{Error, Result};

/// A number of the unit under the name that the model gives it; start and range in SI.
#[derive(Clone)]
pub(super) struct Entry {
    pub(super) name: String,
    /// The name in the description.
    pub(super) own: String,
    pub(super) scalar: Scalar,
    pub(super) has_unit: bool,
    pub(super) meaning: Option<String>,
    pub(super) start: f64,
    pub(super) range: (Option<f64>, Option<f64>),
}

impl Entry {
    /// Whether a key of a model file is its name.
    pub(super) fn goes_by(&self, key: &str) -> bool {
        self.name == key || self.own == key
    }

    pub(super) fn pair(&self) -> (String, Scalar) {
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
pub(super) struct Parts {
    pub(super) states: Vec<Entry>,
    pub(super) inputs: Vec<Entry>,
    pub(super) parameters: Vec<Entry>,
    /// All outputs, and the names of those that are compared.
    pub(super) outputs: Vec<Entry>,
    pub(super) compared: Vec<String>,
}

impl Parts {
    pub(super) fn of(fmu: &Fmu, root: &Form<'_>) -> Result<Self> {
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
    pub(super) fn names(&self) -> Vec<String> {
        let all = self.states.iter().chain(&self.inputs).chain(&self.parameters);
        all.map(|e| e.name.clone()).collect()
    }

    pub(super) fn all(&self) -> impl Iterator<Item = &Entry> {
        self.states.iter().chain(&self.inputs).chain(&self.parameters).chain(&self.outputs)
    }

    pub(super) fn is_compared(&self, e: &Entry) -> bool {
        self.compared.contains(&e.name)
    }
}

/// Whether a unit is a function that a solver calls, rather than something that steps itself.
pub(super) fn is_function(fmu: &Fmu) -> bool {
    fmu.kind == gyrospec_fmi::Kind::ModelExchange
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
