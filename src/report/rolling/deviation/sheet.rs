//! A deviation card as one page that prints on a sheet of A4.

use super::{USE, cells, compass, decimals, heading, is_guide, motion, note, remarks, signed, size, sizes};
use crate::report::page;
use crate::report::svg::escaped;
use crate::rolling::Card;
use std::fmt::Write;

/// The card as an HTML page without scripts or outside parts; with up to 36 headings it prints on one sheet of A4.
pub fn deviation_sheet(card: &Card) -> String {
    let cells = cells(card);
    let mut out = format!(
        "<h1>Deviation card of the gyrocompass</h1>\n<p>Error by rolling, degrees: mean ± standard deviation, \
         by heading and {}.</p>\n<p class=\"blank\">Ship <span></span> Compass <span></span> Date <span></span></p>\n",
        sizes(card)
    );
    for (name, text) in [("Compass", compass(card)), ("Motion", motion(card))] {
        let _ = writeln!(out, "<p><b>{name}:</b> {}.</p>", escaped(&text));
    }
    out.push_str(&rows(card, &cells));
    out.push_str("<p class=\"use\">");
    out.push_str(&USE.map(escaped).join("<br>"));
    out.push_str("</p>\n");
    let remarks = remarks(card, &cells);
    if !remarks.is_empty() {
        let _ = writeln!(out, "<p>{}</p>", escaped(&remarks.join("\n")).replace('\n', "<br>"));
    }
    let note = note(card);
    if !note.is_empty() {
        let _ = writeln!(out, "<p>{}</p>", escaped(note.trim()));
    }
    let _ = writeln!(out, "<p class=\"note\">{}</p>", concat!("gyrospec ", env!("CARGO_PKG_VERSION")));
    page::sheet("Deviation card of the gyrocompass", &out)
}

fn rows(card: &Card, cells: &[Vec<Option<[f64; 2]>>]) -> String {
    let decimals = decimals(cells);
    let points = font(cells, decimals, card.columns.len());
    let mut out = format!("<table style=\"font-size:{points:.1}pt\"><thead><tr><th>heading</th>");
    for column in &card.columns {
        let _ =
            write!(out, "<th>{}{}</th>", escaped(&size(column)), if is_guide(column) { " *" } else { "" });
    }
    out.push_str("</tr></thead><tbody>\n");
    for (k, row) in card.headings.iter().zip(cells) {
        let _ = write!(out, "<tr><th>{}</th>", heading(*k));
        for cell in row {
            match cell {
                Some([mean, spread]) => {
                    let _ = write!(
                        out,
                        "<td><b>{}</b> <span>±{spread:.decimals$}</span></td>",
                        signed(*mean, decimals)
                    );
                }
                None => out.push_str("<td>–</td>"),
            }
        }
        out.push_str("</tr>\n");
    }
    out + "</tbody></table>\n"
}

/// The size of letters, pt, with which all columns stand beside each other on the sheet.
fn font(cells: &[Vec<Option<[f64; 2]>>], decimals: usize, columns: usize) -> f64 {
    let letters =
        |[mean, spread]: [f64; 2]| format!("{} ±{spread:.decimals$}", signed(mean, decimals)).chars().count();
    let longest = cells.iter().flatten().flatten().map(|c| letters(*c)).max().unwrap_or(1);
    // 167 mm beside the headings, 2.8 mm around each cell, 0.21 mm a letter of 1 pt of the widest usual fonts
    let columns = columns as f64;
    ((167.0 - 2.8 * columns) / (columns * longest as f64 * 0.21)).clamp(5.5, 9.5)
}
