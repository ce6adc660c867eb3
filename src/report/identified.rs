//! T and C₀ from a table of trials, as text and as JSON.

use crate::Result;
use crate::gyro::SIGN;
use crate::report::json::object;
use crate::report::page::estimate;
use crate::rolling::{Identification, TrialRow};
use crate::spectrum::Interval;
use crate::units::{counted, figure, significant};
use serde_json::{Value, json};
use std::fmt::Write;

/// What was found, in words.
pub fn text(told: &Identification) -> String {
    let mut out = format!("T and C₀ of the lag (2.3) from {} trials, by (2.4)", told.rows.len());
    if told.left_out > 0 {
        let (rows, are) = (counted(told.left_out, "row"), if told.left_out == 1 { "is" } else { "are" });
        let _ = write!(out, "; {rows} with gaps {are} left out");
    }
    out.push_str("\n\n");
    for (name, unit, i) in [("T", "s", told.found.lag), ("C₀", "N/m", told.found.stiffness)] {
        let (value, interval) = estimate(i.value, i.low, i.high);
        let _ = writeln!(out, "  {name:<3} {value} {unit}, 95 % interval {interval} {unit}");
    }
    let _ = writeln!(
        out,
        "\nWhat is left has a standard deviation of {}°",
        significant(told.found.residual.to_degrees(), 3)
    );
    if let Some(worst) = worst(told) {
        let left = worst.trial.error - worst.fitted;
        let _ = writeln!(
            out,
            "and is largest in row {}: measured {}°, by (2.4) {}°, left {}°",
            worst.number,
            significant(worst.trial.error.to_degrees(), 4),
            significant(worst.fitted.to_degrees(), 4),
            significant(left.to_degrees(), 3)
        );
    }
    if told.found.lag.low == 0.0 {
        out.push_str("The trials do not show that T is above 0: more at high frequencies would.\n");
    }
    let _ = writeln!(
        out,
        "\nIn a file for `gyrospec roll-error`:\n[parameters]\nT = {{ value = {}, unit = \"s\" }}\n\
         C0 = {{ value = {}, unit = \"N/m\" }}\n\nsign: {SIGN}",
        figure(told.found.lag.value),
        figure(told.found.stiffness.value)
    );
    out
}

fn worst(told: &Identification) -> Option<&TrialRow> {
    let size = |r: &TrialRow| (r.trial.error - r.fitted).abs();
    told.rows.iter().max_by(|a, b| size(a).total_cmp(&size(b)))
}

/// The same as one JSON object, by `docs/schemas/identified.json`.
///
/// # Errors
/// `NotComputed` for what JSON cannot hold.
pub fn json(told: &Identification) -> Result<String> {
    let interval = |i: Interval| json!({ "value": i.value, "low": i.low, "high": i.high });
    let row = |r: &TrialRow| -> Value {
        json!({
            "row": r.number, "heading_deg": r.trial.heading.to_degrees(), "amplitude_m": r.trial.amplitude,
            "frequency_rad_per_s": r.trial.frequency, "lat_deg": r.trial.latitude.to_degrees(),
            "error_deg": r.trial.error.to_degrees(), "fitted_deg": r.fitted.to_degrees(),
        })
    };
    let value = json!({
        "schema": "gyrospec.identified/1",
        "T_s": interval(told.found.lag),
        "C0_N_per_m": interval(told.found.stiffness),
        "residual_deg": told.found.residual.to_degrees(),
        "rows_left_out": told.left_out,
        "rows": told.rows.iter().map(row).collect::<Vec<_>>(),
        "sign": SIGN,
    });
    object(&value)
}
