//! A deviation card as text.

use super::{USE, cells, compass, decimals, heading, is_guide, motion, note, remarks, signed, size, sizes};
use crate::rolling::Card;
use std::fmt::Write;

/// The card as text, to be printed in symbols of one width.
///
/// ```
/// use gyrospec::rolling::{Against, Card, Compass, Excitation, Request};
/// let excitation = Excitation::irregular(gyrospec::Roll::new(0.003, 0.1, 0.8)?);
/// let asked = Request { compass: Compass::paper(), excitation, against: Against::card(45), days: None };
/// let text = gyrospec::report::rolling::deviation_text(&Card::of(&asked, &[0.02, 0.05], &gyrospec::Silent)?);
/// assert!(text.contains("315°") && text.contains("true heading = reading − figure"));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn deviation_text(card: &Card) -> String {
    let cells = cells(card);
    let decimals = decimals(&cells);
    let mut out = format!(
        "Deviation card: error of the gyrocompass by rolling, degrees: mean ± standard deviation\n\
         compass: {}\nmotion: {}\n\n{:>10}  {}\n{:>10}",
        compass(card),
        motion(card),
        "",
        sizes(card),
        "heading"
    );
    for column in &card.columns {
        let head = size(column) + if is_guide(column) { " *" } else { "" };
        let _ = write!(out, "{head:>17}");
    }
    out.push('\n');
    for (k, row) in card.headings.iter().zip(&cells) {
        let _ = write!(out, "{:>10}", heading(*k));
        for cell in row {
            let told = cell.map_or("–".into(), |[m, s]| format!("{} ±{s:.decimals$}", signed(m, decimals)));
            let _ = write!(out, "{told:>17}");
        }
        out.push('\n');
    }
    out.push('\n');
    for line in USE.iter().map(ToString::to_string).chain(remarks(card, &cells)) {
        let _ = writeln!(out, "{line}");
    }
    match note(card) {
        text if text.is_empty() => out,
        text => format!("{out}\n{text}"),
    }
}
