//! Tables of a page.

use crate::report::svg::escaped;
use crate::units::{digits_within, figure, significant};
use std::fmt::Write;

/// Rows that may stand as cards.
const CARDS: usize = 6;

/// A table; heads that begin with `#` stand over numbers. Cells are HTML; no rows, no table.
pub fn table(heads: &[&str], rows: &[Vec<String>]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let class = |i: usize| if heads[i].starts_with('#') { " class=\"n\"" } else { "" };
    let word = |i: usize| heads[i].trim_start_matches('#');
    // On a phone the rows of a short, wide table stand as cards, each cell under its head.
    let cards = heads.len() > 3 && rows.len() <= CARDS && heads.iter().all(|h| !h.is_empty());
    let mut out = String::from("<div class=\"scroll\"><table");
    out.push_str(if cards { " class=\"cards\"><thead><tr>" } else { "><thead><tr>" });
    for i in 0..heads.len() {
        let _ = write!(out, "<th{}>{}</th>", class(i), word(i));
    }
    out.push_str("</tr></thead><tbody>");
    for row in rows {
        out.push_str("<tr>");
        for (i, cell) in row.iter().enumerate() {
            let head = if cards { format!(" data-head=\"{}\"", word(i)) } else { String::new() };
            let _ = write!(out, "<td{}{head}>{cell}</td>", class(i));
        }
        out.push_str("</tr>");
    }
    out + "</tbody></table></div>"
}

/// A name with its unit, for the first cell of a row.
pub fn head(name: &str, unit: &str) -> String {
    escaped(&super::with_unit(name, unit))
}

/// A number with its unit.
pub fn quantity(value: f64, unit: &str) -> String {
    if unit == "1" { figure(value) } else { format!("{} {}", figure(value), escaped(unit)) }
}

/// Two ends of an interval; a dash where it has none.
pub fn interval(low: f64, high: f64) -> String {
    if low.is_finite() && high.is_finite() {
        format!("{} to {}", figure(low), figure(high))
    } else {
        "–".into()
    }
}

/// A value and its 95 % interval with the digits that the interval's width deserves.
///
/// ```
/// use gyrospec::report::page::estimate;
/// assert_eq!(estimate(40.017, 39.5, 40.5), ("40.02".into(), "39.50 to 40.50".into()));
/// assert_eq!(estimate(4.0, f64::NAN, 5.0).1, "up to 5");
/// ```
pub fn estimate(value: f64, low: f64, high: f64) -> (String, String) {
    let ([value], interval) = estimates([value], low, high);
    (value, interval)
}

/// Values, the last of which has a 95 % interval, with the digits that its width deserves.
pub fn estimates<const N: usize>(values: [f64; N], low: f64, high: f64) -> ([String; N], String) {
    let last = values.last().copied().unwrap_or(f64::NAN);
    if !(high - low).is_finite() || !last.is_finite() {
        let interval = match (low.is_finite(), high.is_finite()) {
            (true, false) => format!("from {}", figure(low)),
            (false, true) => format!("up to {}", figure(high)),
            _ => "–".into(),
        };
        return (values.map(figure), interval);
    }
    let digits = digits_within(last, high - low);
    let shown = |x: f64| if x.is_finite() { significant(x, digits) } else { figure(x) };
    (values.map(shown), format!("{} to {}", shown(low), shown(high)))
}
