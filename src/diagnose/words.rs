//! Sentences for people.

use super::catalogue::Proposal;
use crate::estimate::Fit;
use crate::units::figure;

/// A mechanism's sentence with the fitted values in it.
pub fn sentence(p: &Proposal, fit: &Fit) -> String {
    let mut says = p.says.clone();
    for (i, a) in p.added.iter().enumerate() {
        let value = fit.model.parameters.iter().find(|q| q.name == a.name).map_or(f64::NAN, |q| q.value);
        let unit = if a.unit.text() == "1" { String::new() } else { format!(" {}", a.unit.text()) };
        says =
            says.replace(&format!("{{{i}}}"), &format!("{}{unit}", figure(a.unit.difference_from_si(value))));
    }
    says
}
