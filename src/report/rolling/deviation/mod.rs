//! A deviation card as text, as CSV and as a sheet of paper.

mod csv;
mod json;
mod sheet;
mod text;

pub use csv::deviation_csv;
pub use json::deviation_json;
pub use sheet::deviation_sheet;
pub use text::deviation_text;

use super::words;
use crate::rolling::{Card, Column, Source, Table};
use crate::units::figure;

/// How a figure is to be used, below the card.
const USE: [&str; 2] = [
    "+  the compass reads high (its north lies west): true heading = reading − figure",
    "−  the compass reads low (its north lies east): true heading = reading + figure without its sign",
];

/// What no figure stands for.
const NONE: &str = "–  beyond the linear theory: no figure";

/// What a starred column is.
const GUIDE: &str = "*  beyond the linear theory where its mean is largest: a guide at best";

/// What a column is headed by: the size of its motion.
fn size(column: &Column) -> String {
    let Some(excitation) = &column.excitation else { return "recorded".into() };
    let size = excitation.size();
    match excitation.source {
        Source::Sea(_) => format!("{} m", figure(size)),
        Source::Regular(_) | Source::Irregular(_) => format!("{}°", figure(size.to_degrees())),
    }
}

/// What the sizes are.
fn sizes(card: &Card) -> &'static str {
    match card.columns.first().and_then(|c| c.excitation.as_ref()).map(|e| &e.source) {
        Some(Source::Sea(_)) => "significant wave height",
        Some(Source::Regular(_)) => "amplitude of the roll",
        Some(Source::Irregular(_)) => "standard deviation of the roll",
        None => "roll",
    }
}

/// Whether the linear theory no longer holds where the column's mean is largest.
fn is_guide(column: &Column) -> bool {
    !words::beyond(&column.table.smallness).is_empty()
}

/// A heading as the compass card has it.
fn heading(rad: f64) -> String {
    let degrees = (rad.to_degrees() * 1e6).round() / 1e6;
    let around = degrees.rem_euclid(360.0);
    if around.fract() == 0.0 { format!("{around:03.0}°") } else { format!("{around:05.1}°") }
}

/// All means and standard deviations, degrees, row by row.
fn cells(card: &Card) -> Vec<Vec<Option<[f64; 2]>>> {
    let cell = |k: f64, column| card.cell(k, column).map(|(m, s)| [m.to_degrees(), s.to_degrees()]);
    card.headings.iter().map(|k| (0..card.columns.len()).map(|c| cell(*k, c)).collect()).collect()
}

/// So many decimals that the largest figure has two digits, hundredths at least.
fn decimals(cells: &[Vec<Option<[f64; 2]>>]) -> usize {
    let all = cells.iter().flatten().flatten().flatten();
    let largest = all.fold(0.0f64, |m, x| m.max(x.abs()));
    if largest > 0.0 { (1 - largest.log10().floor() as i32).clamp(2, 8) as usize } else { 2 }
}

/// A mean with its sign, none on a figure that rounds to zero.
fn signed(degrees: f64, decimals: usize) -> String {
    let size = format!("{:.decimals$}", degrees.abs());
    let is_zero = size.bytes().all(|b| matches!(b, b'0' | b'.'));
    let sign = if is_zero {
        ""
    } else if degrees < 0.0 {
        "−"
    } else {
        "+"
    };
    format!("{sign}{size}")
}

/// The motion, of each size in turn where there are several.
fn motion(card: &Card) -> String {
    let Some(first) = card.columns.first() else { return String::new() };
    match &first.excitation {
        Some(e) => words::excitation(
            e,
            first.table.sea.as_ref().filter(|_| card.columns.len() == 1),
            card.columns.len() > 1,
        ),
        None => recorded(&first.table),
    }
}

fn recorded(table: &Table) -> String {
    let name = table.recorded.as_ref().map_or("", |r| &r.analysis.name);
    let followed = table.recorded.as_ref().is_some_and(|r| r.mean.is_none());
    let by = match (followed, table.is_by_spectrum()) {
        (true, _) => "following it in time",
        (_, true) => "its measured spectrum",
        _ => "the fit of its correlation",
    };
    format!("the recorded roll “{name}”, means by {by}")
}

/// The compass: where its numbers come from, its elastic part, where it stands.
fn compass(card: &Card) -> String {
    let s = &card.compass.sphere;
    let speed = match card.compass.speed {
        0.0 => String::new(),
        v => format!(
            ", at {} kn over the ground (the error of course and speed is in the mean)",
            figure(v * 3600.0 / 1852.0)
        ),
    };
    format!(
        "{}; elastic part: {}; {} m above the roll axis; latitude {}°{speed}",
        words::origin(&card.compass.origin),
        words::part(card.compass.part.name()),
        figure(s.lever),
        figure(s.latitude.to_degrees())
    )
}

/// What is to be known of the figures, a line each: the marks that stand on the card, and what to trust.
fn remarks(card: &Card, cells: &[Vec<Option<[f64; 2]>>]) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for column in card.columns.iter().filter(|c| is_guide(c)) {
        let broken = column.table.smallness.iter().filter(|s| s.is_judged() && !s.holds());
        let told = broken.map(crate::gyro::validity::Smallness::told).collect::<Vec<_>>().join(", ");
        if out.is_empty() {
            out.push(GUIDE.into());
        }
        out.push(format!("   {}: {told}", size(column)));
    }
    if cells.iter().flatten().any(Option::is_none) {
        out.push(NONE.into());
    }
    let margin = |c: &Column| c.table.rows.iter().map(|r| r.error.rectified_margin).fold(0.0, f64::max);
    let margin = card.columns.iter().map(margin).fold(0.0, f64::max);
    if margin > 0.0 {
        out.push(format!("Each mean is right within ±{}° (99 %).", figure(margin.to_degrees())));
    }
    out
}

/// What of the column with the largest mean to trust.
fn note(card: &Card) -> String {
    let largest = |c: &&Column| c.table.rows.iter().map(|r| c.table.mean(r).abs()).fold(0.0, f64::max);
    let worst = card.columns.iter().max_by(|a, b| largest(a).total_cmp(&largest(b)));
    worst.map_or_else(String::new, |c| words::trust(&c.table, "the means here are its own"))
}
