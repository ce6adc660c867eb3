//! The result of a fit in words and a table.

use super::{FitReport, remark, untold};
use crate::estimate::fit::ParameterEstimate;
use crate::units::{Unit, digits_within, significant};
use std::fmt::Write;

/// The report in words.
pub fn render(told: &FitReport<'_>) -> String {
    let mut text = String::new();
    let fit = told.fit;
    let names: Vec<&str> = told.recordings.iter().map(|r| r.name.as_str()).collect();
    let _ = writeln!(text, "{}, fitted to {}\n", fit.model.name, names.join(", "));
    let _ = writeln!(text, "  {:<16} {:>14}   {:<28} unit", "parameter", "value", "95 % interval");
    for p in &fit.parameters {
        text.push_str(&parameter(p));
    }
    for i in &fit.initials {
        let several = told.recordings.len() > 1;
        let of = if several { format!(" of {}", told.recordings[i.recording].name) } else { String::new() };
        text.push_str(&row(&format!("{}(0){of}", i.state), [i.value, i.low, i.high], &i.unit, None));
    }
    text.push_str("\nRoot mean square of measured less simulated, free run:\n");
    for (at, output) in fit.model.outputs.iter().enumerate() {
        let unit = |x: f64| significant(output.unit.difference_from_si(x), 4);
        let _ = write!(text, "  {:<16} {} {} fitted", output.name, unit(fit.rmse[at]), output.unit.text());
        match told.held_out.get(at).map(|h| h.rmse) {
            Some(rmse) if rmse.is_finite() => {
                let _ = writeln!(text, ", {} {} held out", unit(rmse), output.unit.text());
            }
            _ => text.push_str(", nothing held out\n"),
        }
    }
    text.push_str(&untold(&told.fit.unseen, &told.fit.determined));
    text
}

fn parameter(p: &ParameterEstimate) -> String {
    row(&p.name, [p.value, p.low, p.high], &p.unit, remark(p.status))
}

fn row(name: &str, values: [f64; 3], unit: &Unit, remark: Option<&str>) -> String {
    let [value, low, high] = values.map(|x| unit.from_si(x));
    let width = high - low;
    let digits = digits_within(value, width);
    let known = match (low.is_finite(), high.is_finite()) {
        (true, true) => format!("{} to {}", significant(low, digits), significant(high, digits)),
        (true, false) => format!("from {}", significant(low, 4)),
        (false, true) => format!("up to {}", significant(high, 4)),
        (false, false) => "cannot be told from this data".to_owned(),
    };
    let interval = match remark {
        Some("at its bound") if low.is_finite() || high.is_finite() => format!("{known}, at its bound"),
        Some(remark) => remark.to_owned(),
        None => known,
    };
    let shown = match remark {
        Some("fixed") => format!("{value}"),
        _ if value.is_nan() => "several".to_owned(),
        _ => significant(value, digits),
    };
    format!("  {name:<16} {shown:>14}   {interval:<28} {}\n", unit.text())
}
