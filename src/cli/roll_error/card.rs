//! The deviation card: which sizes of the motion are its columns.

use super::Arguments;
use super::hints::worded;
use crate::cli::progress::Meter;
use crate::cli::quantity::quantity;
use crate::gyro::range::{self, Range};
use crate::rolling::{Card, Recorded, Request, Source};
use crate::{Error, ErrorKind, Result};

/// Significant heights of the columns where none is said, m.
const HEIGHTS: [f64; 5] = [1.0, 2.0, 3.0, 4.0, 6.0];

/// The card of what the options describe.
pub fn of_options(a: &Arguments, asked: &str, request: &Request) -> Result<Card> {
    let sizes = sizes(a, asked, request)?;
    for one in Card::requests(request, &sizes).map_err(|e| e.about("--card"))? {
        if let Some(obstacle) = one.prepare()?.obstacle()? {
            return Err(worded(&obstacle));
        }
    }
    Card::of(request, &sizes, &Meter)
}

/// The card of a recorded roll: one column.
pub fn of_recorded(asked: &str, recorded: &Recorded) -> Result<Card> {
    if asked.is_empty() {
        return Ok(Card::of_table(recorded.table(&Meter)?));
    }
    Err(Error::usage("a recorded roll has one size, its own").with_hint("say --card alone, behind the files"))
}

/// The sizes asked for and that of the motion where it was said, rising.
fn sizes(a: &Arguments, asked: &str, request: &Request) -> Result<Vec<f64>> {
    let excitation = &request.excitation;
    let range = match excitation.source {
        Source::Sea(_) => &range::WAVE_HEIGHT,
        Source::Regular(_) => &range::ROLL_AMPLITUDE,
        Source::Irregular(_) => &range::ROLL_DEVIATION,
    };
    let mut sizes = read(asked, range)?;
    // a roll has the size of its file, or the paper's where nothing is said
    let of_roll = !a.motion.is_sea() && (request.compass.roll.is_some() || sizes.is_empty());
    if a.motion.is_sized() || of_roll {
        sizes.push(excitation.size());
    }
    if sizes.is_empty() {
        sizes.extend(HEIGHTS);
    }
    sizes.sort_by(f64::total_cmp);
    // said twice, once in other words
    sizes.dedup_by(|b, a| (*b - *a).abs() <= 1e-9 * *a);
    Ok(sizes)
}

fn read(asked: &str, range: &Range) -> Result<Vec<f64>> {
    let parts = asked.split(',').filter(|_| !asked.is_empty());
    parts.map(|part| quantity("card", part, range)).collect::<Result<_>>().map_err(|e| match e.kind() {
        ErrorKind::Usage if e.hint().is_none() => e.with_hint(format!(
            "--card takes {}s with commas between, such as --card {}; files stand before it",
            range.what.trim_start_matches("a ").trim_start_matches("an "),
            if range.unit == "m" { "1m,2m,4m" } else { "2deg,5deg,10deg" }
        )),
        ErrorKind::Units if range.unit == "m" => {
            e.with_hint("the sizes of a sea are heights; angles go with --regular or --irregular")
        }
        ErrorKind::Units if range.unit == "rad" => {
            e.with_hint("the sizes of a roll are angles; heights go with --sea")
        }
        _ => e,
    })
}
