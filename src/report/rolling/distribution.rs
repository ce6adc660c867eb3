//! What is said of the distribution of an error.

use crate::gyro::{Quantile, Shape};
use crate::rolling::{Row, Table};
use serde_json::{Map, Value, json};

/// Skewness below which an error is nearly Gaussian: up to the 95th its percentiles move by less than a twentieth of the
/// deviation, γ₁(z² − 1)/6.
const HARDLY: f64 = 0.15;

/// Percentiles, rad, as an object of degrees; null where there is none.
pub fn of(percentiles: [f64; 4]) -> Value {
    let named = Shape::TOLD.iter().zip(percentiles);
    let entry = |((part, _), x): (&(f64, f64), f64)| {
        let value = if x.is_finite() { json!(x.to_degrees()) } else { Value::Null };
        (format!("p{:.0}", 100.0 * part), value)
    };
    Value::Object(named.map(entry).collect::<Map<_, _>>())
}

/// Where the error lies how often, in lines, for the row of the largest mean; empty where nothing is known of it.
pub fn words(table: &Table) -> String {
    let told = table.rows.iter().filter(|r| r.shape.is_some());
    let Some(row) = told.max_by(|a, b| a.error.mean().abs().total_cmp(&b.error.mean().abs())) else {
        return String::new();
    };
    let Some(shape) = row.shape else { return String::new() };
    let list = |values: [f64; 4]| {
        let named = Shape::TOLD.iter().zip(values);
        let each = named.map(|((part, _), x)| format!("{:.3}° (P{:.0})", x.to_degrees(), 100.0 * part));
        each.collect::<Vec<_>>().join(", ")
    };
    let form = if shape.skewness.abs() < HARDLY { "nearly Gaussian" } else { "not Gaussian" };
    let by = if table.is_by_spectrum() {
        "By the fit of the roll, whose mean is not the one to trust, the"
    } else {
        "Where the mean is largest the"
    };
    format!(
        "{by} error lies below {};\nits distribution is {form}: skewness {:+.2}, excess {:+.2}.\n{}",
        list(shape.percentiles(&row.error)),
        shape.skewness,
        shape.excess,
        simulated(row)
    )
}

/// The same of the simulation.
fn simulated(row: &Row) -> String {
    let Some(m) = &row.simulated else { return String::new() };
    let end = |x: f64| if x.is_finite() { format!("{:.3}", x.to_degrees()) } else { "?".to_owned() };
    let each = |q: &Quantile| format!("{}° ({} … {})", end(q.value), end(q.low), end(q.high));
    let all: Vec<String> = m.percentiles.iter().map(each).collect();
    format!("Simulated, with 99 % intervals: {}.\n", all.join(", "))
}
