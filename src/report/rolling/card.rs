//! The table around the compass card.

use super::words;
use crate::report::polar::{Point, Polar};
use crate::rolling::{Against, Table};

/// The compass card of a table whose rows run over headings; `None` for any other.
pub fn card(table: &Table) -> Option<Polar> {
    if !matches!(table.against, Against::Heading(_)) {
        return None;
    }
    let points = table.rows.iter().map(|r| Point {
        heading: r.heading,
        mean: table.mean(r).to_degrees(),
        spread: r.error.deviation.to_degrees(),
    });
    let by = match (table.is_by_spectrum(), table.is_by_sums()) {
        (true, _) => "; the mean is that by the measured spectrum",
        (_, true) => "; the mean is that by sums over the sea's own spectrum",
        _ => "",
    };
    Some(Polar {
        title: format!("Heading error, {}", words::part(table.compass.part.name())),
        subtitle: format!("{}{by}", words::motion(table)),
        warning: words::beyond(&table.smallness),
        points: points.collect(),
    })
}
