//! Figures and sentences for people.

use super::catalogue::Proposal;
use crate::estimate::Fit;

/// Four significant digits, without needless zeros.
pub fn figure(x: f64) -> String {
    if !x.is_finite() {
        return "?".into();
    }
    let size = x.abs();
    if size != 0.0 && !(1e-3..1e6).contains(&size) {
        return format!("{x:.3e}");
    }
    let decimals = if size == 0.0 { 0 } else { (3 - size.log10().floor() as i32).max(0) as usize };
    let text = format!("{x:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_string() } else { text }
}

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
