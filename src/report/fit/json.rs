//! The result of a fit as JSON; the schema is documented with the rest of the forms.

use super::FitReport;
use crate::Result;
use crate::estimate::Side;
use crate::estimate::fit::{Combination, Fit, ParameterEstimate, Status};
use crate::estimate::independent_samples;
use crate::report::json::object;
use crate::units::Unit;
use serde_json::{Value, json};

/// A number, or null where it is not finite.
fn number(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { Value::Null }
}

/// The report as JSON, schema `gyrospec.fit/1`.
///
/// # Errors
/// `NotComputed`, should a number not be writable.
pub fn render(told: &FitReport<'_>) -> Result<String> {
    let fit = told.fit;
    let value = json!({
        "schema": "gyrospec.fit/1",
        "model": fit.model.name,
        "parameters": fit.parameters.iter().map(|p| parameter(p, fit)).collect::<Vec<_>>(),
        "initial_states": initial_states(told),
        "outputs": (0..fit.model.outputs.len()).map(|o| output(told, o)).collect::<Vec<_>>(),
        "not_identifiable": fit.unseen.iter().map(|d| json!({
            "direction": d.weights.iter().map(|(name, w)| json!({"name": name, "weight": number(*w)})).collect::<Vec<_>>(),
            "relative_deviation": number(d.deviation),
        })).collect::<Vec<_>>(),
        "determined": fit.determined.iter().map(combination).collect::<Vec<_>>(),
        "warnings": fit.warnings.iter().map(|w| w.message.clone()).collect::<Vec<_>>(),
        "end": end(told),
        "simulations": fit.simulations,
        "made": {
            "program": concat!("gyrospec ", env!("CARGO_PKG_VERSION")),
            "seed": told.seed,
            "inputs": told.inputs().map(|s| json!({
                "file": s.file.display().to_string(), "sha256": s.sha256,
            })).collect::<Vec<_>>(),
        },
    });
    object(&value)
}

fn parameter(p: &ParameterEstimate, fit: &Fit) -> Value {
    let status = match p.status {
        Status::Fitted => "fitted",
        Status::AtBound(Side::Lower) => "at-lower-bound",
        Status::AtBound(Side::Upper) => "at-upper-bound",
        Status::Fixed => "fixed",
        Status::Constant => "constant-of-the-recording",
    };
    let interval = if fit.profiled.contains(&p.name) { "profile" } else { "curvature" };
    let entry = json!({"name": p.name, "status": status, "interval": interval});
    with_interval(entry, [p.value, p.low, p.high], &p.unit)
}

fn combination(c: &Combination) -> Value {
    let unit = c.unit.of_differences();
    with_interval(json!({"expression": c.expression, "parameters": c.names}), [c.value, c.low, c.high], &unit)
}

fn with_interval(mut entry: Value, values: [f64; 3], unit: &Unit) -> Value {
    for (name, x) in ["value", "low", "high"].into_iter().zip(values) {
        entry[name] = number(unit.decimal_from_si(x));
    }
    entry["unit"] = json!(unit.text());
    entry
}

fn initial_states(told: &FitReport<'_>) -> Vec<Value> {
    told.fit
        .initials
        .iter()
        .map(|i| {
            let entry = json!({"recording": told.recordings[i.recording].name, "state": i.state});
            with_interval(entry, [i.value, i.low, i.high], &i.unit)
        })
        .collect()
}

fn output(told: &FitReport<'_>, at: usize) -> Value {
    let output = &told.fit.model.outputs[at];
    let noise = &told.fit.noise[at];
    let unit = |x: f64| number(output.unit.difference_from_si(x));
    let held_out = told.held_out.get(at).map_or(f64::NAN, |h| h.rmse);
    json!({
        "output": output.name,
        "unit": output.unit.text(),
        "rmse_fit": unit(told.fit.rmse[at]),
        "rmse_holdout": unit(held_out),
        "residual": {
            "deviation": unit(noise.autoregression.variance().sqrt()),
            "averaged_samples": noise.decimation,
            "autoregression": noise.autoregression.coefficients(),
            "independent_share": number(independent_samples(noise, 1)),
        },
    })
}

fn end(told: &FitReport<'_>) -> &'static str {
    use crate::estimate::End;
    match told.fit.end {
        End::Converged => "converged",
        End::Stalled => "stalled",
        End::OutOfSteps => "out-of-steps",
        End::OutOfBudget => "out-of-budget",
    }
}
