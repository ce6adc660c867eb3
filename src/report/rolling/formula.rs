//! The closed form of the mean error, with its values.

use super::json::smallness;
use super::words;
use crate::gyro::{SIGN, side};
use crate::rolling::{ClosedForm, ClosedValues, Compass, Excitation, Source};
use std::fmt::Write;

/// The closed form and its values as text.
pub fn formula_text(
    compass: &Compass,
    excitation: &Excitation,
    closed: &ClosedForm,
    values: &ClosedValues,
) -> String {
    let mut out = format!(
        "Mean heading error on {}:\n\n{}\n\n\
         {}\n\n\
         Here ({}; {}; latitude {:.1}°, h = {} m):\n",
        moved(excitation),
        closed.text(),
        derived(closed),
        words::origin(&compass.origin),
        words::excitation(excitation, values.sea.as_ref(), false),
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

/// The motion in symbols.
fn moved(excitation: &Excitation) -> String {
    let roll = match &excitation.source {
        Source::Irregular(_) => "irregular roll K(τ) = A e^(−μ|τ|)(cos ετ + (μ/ε) sin ε|τ|), b² = μ² + ε²",
        Source::Regular(_) => "regular roll θ₀ sin pt",
        Source::Sea(_) => {
            return "roll in a sea, white noise of density N through W(s)/s² (numbers in s and m)".into();
        }
    };
    let band = if excitation.band.is_some() { ",\nbehind two low-passes at ω_c" } else { "" };
    format!("{roll}{band}")
}

/// Where a closed form comes from.
fn derived(closed: &ClosedForm) -> String {
    let order = closed.order();
    match closed {
        ClosedForm::Written(_) if order == 0 => {
            format!(
                "the mean product of two sines; agrees with complex arithmetic at {} random points",
                closed.points()
            )
        }
        ClosedForm::Integral { .. } if order == 0 => "a ratio of polynomials in these symbols".into(),
        ClosedForm::Written(_) => {
            format!(
                "derived from I_{order}; agrees with the numeric engine at {} random points",
                closed.points()
            )
        }
        ClosedForm::Integral { .. } => {
            format!(
                "a ratio of polynomials in these symbols, which written out fills pages: I_{order} gives its value"
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
        "motion": words::excitation(excitation, values.sea.as_ref(), false),
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
