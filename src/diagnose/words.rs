//! Sentences for people.

use super::catalogue::Proposal;
use crate::estimate::Fit;
use crate::model::Model;
use crate::units::figure;

/// A number with its unit; pure numbers have none.
pub fn quantity(value: f64, unit: &str) -> String {
    if unit == "1" { figure(value) } else { format!("{} {unit}", figure(value)) }
}

/// Words for a signal or parameter: its meaning where the model gives one, else its name.
pub fn signal(m: &Model, name: &str) -> String {
    let state = m.states.iter().find(|s| s.name == name).and_then(|s| s.meaning.clone());
    let input = || m.inputs.iter().find(|i| i.name == name).and_then(|i| i.meaning.clone());
    let output = || m.outputs.iter().find(|o| o.name == name).and_then(|o| o.meaning.clone());
    let parameter = || m.parameters.iter().find(|p| p.name == name).and_then(|p| p.meaning.clone());
    let definition = || m.definitions.iter().find(|d| d.name == name).and_then(|d| d.meaning.clone());
    let meaning = state.or_else(input).or_else(output).or_else(parameter).or_else(definition);
    meaning.map_or_else(|| name.to_string(), |words| format!("{words} ({name})"))
}

/// A mechanism's sentence with the fitted values in it.
pub fn sentence(p: &Proposal, fit: &Fit) -> String {
    let mut says = p.says.clone();
    for (i, a) in p.added.iter().enumerate() {
        let value = fit.model.parameters.iter().find(|q| q.name == a.name).map_or(f64::NAN, |q| q.value);
        says = says.replace(&format!("{{{i}}}"), &quantity(a.unit.difference_from_si(value), a.unit.text()));
    }
    says
}
