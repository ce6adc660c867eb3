//! NMEA 0183 logs as they come from a ship: a time stamp, then a sentence, line by line; or sentences alone, ZDA among
//! them, which is then the clock.
//!
//! Fields count from 1 after the sentence's name, as they stand between the commas; the number
//! of a PSXN sentence is its field 1. Positions (ddmm.mmmm, N/S/E/W) are read as signed degrees,
//! times of day (hhmmss.ss) as seconds. A sentence that the instrument itself marks as not valid
//! is a gap. Bad sentences are counted and noted, never fatal.
//!
//! Reference: IEC 61162-1 (HDT, THS, ROT, VTG, GGA, ZDA, RMC); the PSXN of Seatex and the PASHR
//! attitude sentence as those makers print them.

mod clock;
mod collect;
#[cfg(feature = "cli")]
mod contents;
mod group;
mod known;
mod mixed;
mod request;
mod sentence;
mod stamp;

use super::input::{self, Input};
use super::request::{Table, finished};
use super::zero::Zero;
use super::{Note, Origin, Source};
use crate::{Error, Result};
use clock::{Clock, Ticks};
use collect::Collector;
#[cfg(feature = "cli")]
pub(crate) use contents::{Contents, Listed};
use group::Group;
pub(super) use request::{Request, Selection};
use sentence::Fault;
pub(super) use stamp::{nano_of_count, stamp, why_no_stamp};
use std::sync::Arc;

/// Lines that tell whether a file is a log.
const LOOKED_AT: usize = 5;

/// Reads a log.
///
/// # Errors
/// `BadInput` where a wanted sentence is not there, a wanted field holds no numbers, the
/// stamps of a wanted sentence do not rise, or there is neither a stamp nor a ZDA sentence.
pub(super) fn read(input: Input, request: &Request) -> Result<Table> {
    let path = &input.path().to_owned();
    let place = |e: Error| if e.file().is_some() { e } else { e.with_file(path) };
    let (collector, source, note) = collected(input, request).map_err(place)?;
    let zero = collector.zero().map(|nano| Zero {
        nano,
        is_dated: true,
        zoned: None,
        is_open: false,
        text: "its first time".into(),
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

/// All lines of a log.
fn collected(input: Input, request: &Request) -> Result<(Collector, Source, Option<String>)> {
    let clock = if lacks_stamps(input.start()) { Clock::Ticks(Ticks::default()) } else { Clock::Stamps };
    let mut collector = Collector::new(request, clock);
    let (source, note) = input::read_lines(input, &mut collector)?;
    Ok((collector, source, note))
}

/// What a log holds.
///
/// # Errors
/// As [`read`] of all that is known.
#[cfg(feature = "cli")]
pub(super) fn contents(input: Input) -> Result<Contents> {
    let path = &input.path().to_owned();
    let request = Request { zero: None, wanted: Vec::new(), table: 0 };
    let place = |e: Error| if e.file().is_some() { e } else { e.with_file(path) };
    let (collector, ..) = collected(input, &request).map_err(place)?;
    let start = collector.first().unwrap_or_default().to_owned();
    let unknown = collector.left_out().map(|(_, says)| says);
    let (groups, _) = collector.finish().map_err(place)?;
    let fields = groups.iter().flat_map(Group::contents).collect();
    Ok(Contents { start, fields, unknown })
}

fn finish_group(group: Group, table: usize) -> Vec<super::Channel> {
    let time: Arc<[f64]> = group.time.into();
    let columns = group.selections.into_iter().zip(group.values);
    columns.map(|(s, values)| finished(&s.wanted, s.unit, table, &time, values)).collect()
}

/// Whether a file holds sentences alone, without a time stamp before them: one of its first lines begins with a sentence,
/// which a checksum ends, and none has something before.
fn lacks_stamps(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start);
    let mut lines = text.lines().take(LOOKED_AT).filter_map(has_something_before).peekable();
    lines.peek().is_some() && lines.all(|has| !has)
}

/// Whether something stands before the sentence of a line, if there is one.
fn has_something_before(line: &str) -> Option<bool> {
    match sentence::parse(line) {
        Ok(sentence) => Some(!sentence.stamp().is_empty()),
        Err(Fault::WrongChecksum) => Some(!line.trim_start().starts_with(['$', '!'])),
        Err(_) => None,
    }
}

/// Whether the first lines of a file look like a log.
pub(super) fn looks_like_log(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start);
    let has_stamp = |line: &str| sentence::parse(line).is_ok_and(|s| stamp(s.stamp()).is_some());
    lacks_stamps(start) || text.lines().take(LOOKED_AT).any(has_stamp)
}
