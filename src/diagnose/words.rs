//! Sentences for people.

use super::catalogue::Proposal;
use crate::estimate::Fit;
use crate::units::figure;

/// A number with its unit; pure numbers have none.
pub fn quantity(value: f64, unit: &str) -> String {
    if unit == "1" { figure(value) } else { format!("{} {unit}", figure(value)) }
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
