//! T and C₀ from a table of trials, as text and as JSON.

use crate::Result;
use crate::gyro::SIGN;
use crate::report::json::object;
use crate::report::page::{Page, Section, estimate, table};
use crate::report::svg::{Layer, Picture, escaped};
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
            significant(worst.fitted.to_degrees() + 0.0, 4),
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

/// The same as one page, with what was measured beside (2.4).
pub fn page(told: &Identification) -> String {
    let (t, c) = (told.found.lag, told.found.stiffness);
    let [t, c] = [t, c].map(|i| estimate(i.value, i.low, i.high));
    let of = |f: fn(&TrialRow) -> [f64; 2]| told.rows.iter().map(f).collect::<Vec<_>>();
    let beside = Picture::new("error by (2.4) and as measured", "by (2.4), °", "measured, °")
        .with(Layer::line("after", "(2.4)", ends(told)))
        .with(Layer::dots("measured", "trials", of(|r| [r.fitted, r.trial.error].map(f64::to_degrees))));
    let left = Picture::new("what (2.4) leaves", "frequency, rad/s", "left, °").with(Layer::dots(
        "measured",
        "",
        of(|r| [r.trial.frequency, (r.trial.error - r.fitted).to_degrees()]),
    ));
    let cells = |r: &TrialRow| {
        let degrees = |x: f64| significant(x.to_degrees(), 4);
        vec![
            r.number.to_string(),
            figure(r.trial.heading.to_degrees()),
            figure(r.trial.amplitude),
            figure(r.trial.frequency),
            degrees(r.trial.error),
            degrees(r.fitted),
            degrees(r.trial.error - r.fitted),
        ]
    };
    let heads = [
        "#row",
        "#heading, °",
        "#amplitude, m",
        "#frequency, rad/s",
        "#measured, °",
        "#by (2.4), °",
        "#left, °",
    ];
    let rows: Vec<Vec<String>> = told.rows.iter().map(cells).collect();
    let page = Page {
        kind: "T and C₀ from trials".into(),
        title: "T and C₀ from trials".into(),
        verdict: format!("T is {} s ({}) and C₀ {} N/m ({}).", t.0, t.1, c.0, c.1),
        lead: format!("By (2.4) from {} trials; intervals of 95 %.", told.rows.len()),
        sections: vec![
            Section::new("trials", "The trials", beside.draw() + &left.draw()),
            Section::new("rows", "Row by row", table(&heads, &rows)),
            Section::new(
                "numbers",
                "The numbers",
                format!("<pre class=\"scroll\">{}</pre>", escaped(&text(told))),
            ),
        ],
    };
    page.html()
}

/// The straight line on which the errors by (2.4) are those measured, from the lowest to the highest, degrees.
fn ends(told: &Identification) -> Vec<[f64; 2]> {
    let all = || told.rows.iter().flat_map(|r| [r.fitted, r.trial.error]);
    let ends = [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)];
    ends.map(|e| [e.to_degrees(), e.to_degrees()]).to_vec()
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
