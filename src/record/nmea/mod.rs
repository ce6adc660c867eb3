//! NMEA 0183 logs as they come from a ship: a time stamp, then a sentence, line by line.
//!
//! Fields count from 1 after the sentence's name, as they stand between the commas; the number
//! of a PSXN sentence is its field 1. Positions (ddmm.mmmm, N/S/E/W) are read as signed degrees,
//! times of day (hhmmss.ss) as seconds. A sentence that the instrument itself marks as not valid
//! is a gap. Bad sentences are counted and noted, never fatal.
//!
//! Reference: IEC 61162-1 (HDT, THS, ROT, VTG, GGA, ZDA, RMC); the PSXN of Seatex and the PASHR
//! attitude sentence as those makers print them.

mod collect;
mod known;
mod mixed;
mod request;
mod sentence;
mod stamp;

use super::input::{self, Input};
use super::request::{Table, finished};
use super::zero::Zero;
use super::{Note, Origin};
use crate::{Error, Result};
use collect::{Collector, Group};
pub(super) use request::{Request, Selection};
pub(super) use stamp::{stamp, why_no_stamp};
use std::sync::Arc;

/// Reads a log.
///
/// # Errors
/// `BadInput` where a wanted sentence is not there, a wanted field holds no numbers, or the
/// stamps of a wanted sentence do not rise.
pub(super) fn read(input: Input, request: &Request) -> Result<Table> {
    let path = &input.path().to_owned();
    let mut collector = Collector::new(request);
    let place = |e: Error| if e.file().is_some() { e } else { e.with_file(path) };
    let (source, note) = input::read_lines(input, &mut collector).map_err(place)?;
    let zero = collector.zero().map(|nano| Zero {
        nano,
        is_dated: true,
        zoned: None,
        is_open: false,
        text: "its first stamp".into(),
    });
    let (groups, mut notes) = collector.finish().map_err(place)?;
    notes.extend(note.map(|text| (None, text)));
    let mut channels: Vec<_> = groups.into_iter().flat_map(|g| finish_group(g, request.table)).collect();
    // In the order of the request, which names each channel once.
    let order = |name: &str| request.wanted.iter().position(|s| s.wanted.name == name);
    channels.sort_by_key(|c| order(&c.name));
    let notes =
        notes.into_iter().map(|(line, message)| Note { file: path.to_owned(), line, message }).collect();
    let origin = Origin { source, first_row: 0, is_table: false };
    Ok(Table { channels, origin, notes, left_out: Vec::new(), zero, time_unit: None })
}

fn finish_group(group: Group, table: usize) -> Vec<super::Channel> {
    let time: Arc<[f64]> = group.time.into();
    let columns = group.selections.into_iter().zip(group.values);
    columns.map(|(s, values)| finished(&s.wanted, s.unit, table, &time, values)).collect()
}

/// Whether a file holds sentences alone, without a time stamp before them.
pub(super) fn lacks_stamps(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start);
    let mut lines = text.lines().map(str::trim).filter(|l| !l.is_empty()).take(5).peekable();
    let bare = |l: &str| {
        let sum = l.rsplit_once('*').is_some_and(|(_, sum)| u8::from_str_radix(sum, 16).is_ok());
        l.starts_with(['$', '!']) && sum
    };
    lines.peek().is_some() && lines.all(bare)
}

/// Whether the first lines of a file look like such a log.
pub(super) fn looks_like_log(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start);
    text.lines().take(5).any(|line| sentence::parse(line).is_ok())
}
