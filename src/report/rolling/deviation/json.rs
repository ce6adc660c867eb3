//! A deviation card as JSON.

use super::{is_guide, sizes};
use crate::Result;
use crate::gyro::SIGN;
use crate::report::json::object;
use crate::report::rolling::words;
use crate::rolling::{Card, Column, Source};
use serde_json::{Value, json};

/// The card as JSON, by `docs/schemas/deviation-card.json`.
///
/// # Errors
/// `NotComputed` for what JSON cannot hold.
pub fn deviation_json(card: &Card) -> Result<String> {
    object(&json!({
        "schema": "gyrospec.deviation-card/1",
        "instrument": card.compass.part.name(),
        "lat_deg": card.compass.sphere.latitude.to_degrees(),
        "sizes": sizes(card),
        "columns": (0..card.columns.len()).map(|k| column(card, k)).collect::<Vec<_>>(),
        "sign": SIGN,
    }))
}

/// A size with its unit; null where the roll was recorded.
fn size(column: &Column) -> [Value; 2] {
    let Some(excitation) = &column.excitation else { return [Value::Null, Value::Null] };
    match excitation.source {
        Source::Sea(_) => [json!(excitation.size()), Value::Null],
        Source::Regular(_) | Source::Irregular(_) => [Value::Null, json!(excitation.size().to_degrees())],
    }
}

fn column(card: &Card, at: usize) -> Value {
    let column = &card.columns[at];
    let row = |heading: &f64| {
        let cell = card.cell(*heading, at);
        json!({
            "heading_deg": (heading.to_degrees() * 1e9).round() / 1e9,
            "mean_deg": cell.map(|c| c.0.to_degrees()),
            "spread_deg": cell.map(|c| c.1.to_degrees()),
        })
    };
    let [height, roll] = size(column);
    json!({
        "significant_height_m": height,
        "roll_deg": roll,
        "motion": words::motion(&column.table),
        "guide_at_best": is_guide(column),
        "rows": card.headings.iter().map(row).collect::<Vec<_>>(),
    })
}
