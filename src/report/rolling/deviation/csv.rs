//! A deviation card as CSV.

use super::{is_guide, size};
use crate::rolling::{Card, Column};
use std::fmt::Write;

/// The card as CSV: a row a heading, mean and standard deviation a column in degrees with all their digits; cells beyond
/// the linear theory are empty.
pub fn deviation_csv(card: &Card) -> String {
    let mut out = String::from("heading [deg]");
    for column in &card.columns {
        let (size, guide) = (size(column), guide(column));
        let _ = write!(out, ",mean at {size} (+ reads high{guide}) [deg],spread at {size} [deg]");
    }
    out.push('\n');
    for k in &card.headings {
        // the headings that were asked for, without what the turn to radians and back adds
        let _ = write!(out, "{}", (k.to_degrees() * 1e9).round() / 1e9);
        for column in 0..card.columns.len() {
            match card.cell(*k, column) {
                Some((mean, spread)) => {
                    let _ = write!(out, ",{},{}", mean.to_degrees(), spread.to_degrees());
                }
                None => out.push_str(",,"),
            }
        }
        out.push('\n');
    }
    out
}

fn guide(column: &Column) -> &'static str {
    if is_guide(column) { "; a guide at best" } else { "" }
}
