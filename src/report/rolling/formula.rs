//! The closed form of the mean error, with its values.

use super::json::smallness;
use super::words;
use crate::gyro::{SIGN, side};
use crate::rolling::{ClosedForm, ClosedValues, Compass, Excitation};
use std::fmt::Write;

/// The closed form and its values as text.
pub fn formula_text(
    compass: &Compass,
    excitation: &Excitation,
    closed: &ClosedForm,
    values: &ClosedValues,
) -> String {
    let mut out = format!(
        "Mean heading error on irregular roll K(τ) = A e^(−μ|τ|)(cos ετ + (μ/ε) sin ε|τ|), b² = μ² + ε²{}:\n\n{}\n\n\
         {}\n\n\
         Here ({}; {}; latitude {:.1}°, h = {} m):\n",
        if excitation.band.is_some() { ",\nbehind two low-passes at ω_c" } else { "" },
        closed.text(),
        derived(closed),
        words::origin(&compass.origin),
        words::excitation(excitation, None, false),
        compass.sphere.latitude.to_degrees(),
        compass.sphere.lever
    );
    for (heading, mean) in &values.means {
        let _ = writeln!(
            out,
            "  heading {:>6.1}°   {:>10.5}°  ({})",
            heading.to_degrees(),
            mean.to_degrees(),
            side(*mean)
        );
    }
    let idle = words::idle(compass.part.idle());
    if !idle.is_empty() {
        let _ = write!(out, "\n{idle}");
    }
    let beyond = words::beyond(&values.smallness);
    if !beyond.is_empty() {
        let _ = writeln!(out, "\n{beyond}");
    }
    let unjudged = words::unjudged(&values.smallness);
    if !unjudged.is_empty() {
        let _ = write!(out, "\n{unjudged}");
    }
    out
}

/// Where a closed form comes from.
fn derived(closed: &ClosedForm) -> String {
    let order = closed.order();
    match closed {
        ClosedForm::Written(_) => {
            format!(
                "derived from I_{order}; agrees with the numeric engine at {} random points",
                closed.points()
            )
        }
        ClosedForm::Integral { .. } => {
            format!(
                "a ratio of polynomials in these letters, which written out fills pages: I_{order} gives its value"
            )
        }
    }
}

/// The same as one JSON object, by `docs/schemas/roll-error-formula.json`.
pub fn formula_json(
    compass: &Compass,
    excitation: &Excitation,
    closed: &ClosedForm,
    values: &ClosedValues,
) -> String {
    let row = |(heading, mean): &(f64, f64)| serde_json::json!({ "heading_deg": heading.to_degrees(), "mean_deg": mean.to_degrees() });
    let mut value = serde_json::json!({
        "schema": "gyrospec.roll-error-formula/1",
        "formula": closed.text(),
        "order": closed.order(),
        "points_checked": closed.points(),
        "motion": words::excitation(excitation, None, false),
        "sign": SIGN,
        "validity": values.smallness.iter().map(smallness).collect::<Vec<_>>(),
        "values": values.means.iter().map(row).collect::<Vec<_>>(),
    });
    let idle = words::idle(compass.part.idle());
    if !idle.is_empty() {
        value["note"] = idle.trim_end().into();
    }
    format!("{value:#}\n")
}
