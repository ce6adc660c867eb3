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
mod sentence;
mod stamp;

use super::csv::Table;
use super::input::{self, Input};
use super::request::{Wanted, finished};
use super::{Note, Origin};
use crate::units::Unit;
use crate::{Error, ErrorKind, Result};
use collect::{Collector, Group};
pub(super) use stamp::{stamp, why_no_stamp};
use std::sync::Arc;

/// What is wanted of a log.
pub(super) struct Request {
    /// The zero of time in nanoseconds since 1970; without it the first stamp is zero.
    pub zero: Option<i128>,
    /// Nothing means every field that is known here.
    pub wanted: Vec<Selection>,
    /// Number of the table in the recording.
    pub table: usize,
}

/// One field of one sort of sentence.
#[derive(Debug, Clone)]
pub(super) struct Selection {
    wanted: Wanted,
    unit: Unit,
    field: usize,
    id: Option<u32>,
    form: known::Form,
}

impl Selection {
    /// A selection, checked against what is known of its sentence.
    pub(super) fn new(wanted: Wanted, field: usize, id: Option<u32>) -> Result<Self> {
        let sentence = wanted.column.clone();
        if field == 0 {
            return Err(Error::bad_input("fields count from 1, after the sentence's name"));
        }
        if let (true, None) = (known::is_numbered(&sentence), id) {
            return Err(Error::bad_input(format!("{sentence} comes in several sorts, by its number"))
                .with_hint("write id = 20, 22 or 23"));
        }
        if let (true, Some(id)) = (field == 1, id) {
            return Err(Error::bad_input(format!("field 1 of {sentence} is its number, {id}"))
                .with_hint("the first value after it is field 2"));
        }
        let known = known::field(&sentence, id, field);
        let own = known.map(|k| Unit::parse(k.unit)).transpose()?;
        if let (Some(given), Some(own)) = (&wanted.unit, &own) {
            own.turns_or_radians(given).map_err(|e| e.about(&format!("field {field} of {sentence}")))?;
        }
        let unit = match (wanted.unit.clone(), own) {
            (Some(unit), Some(own)) if unit.dimension() != own.dimension() => {
                return Err(Error::new(
                    ErrorKind::Units,
                    format!("field {field} of {sentence} is in {own}, not in {unit}"),
                )
                .with_hint(known::listing(&sentence, id)));
            }
            (Some(unit), _) | (None, Some(unit)) => unit,
            (None, None) => {
                return Err(Error::bad_input(format!("channel `{}` has no unit", wanted.name))
                    .with_hint("write unit = \"deg\", or \"1\" for none"));
            }
        };
        let form = known.map_or(known::Form::Number, |k| k.form);
        if let Some(fixed) = form.unit()
            && unit.to_si(1.0) != Unit::parse(fixed)?.to_si(1.0)
        {
            return Err(Error::new(
                ErrorKind::Units,
                format!("field {field} of {sentence} is read in {fixed}"),
            )
            .with_hint(format!("write unit = \"{fixed}\"")));
        }
        if wanted.wraps && !unit.dimension().is_none() {
            return Err(Error::bad_input(format!("`{}` in [{unit}] cannot wrap at a turn", wanted.name))
                .with_hint("wraps = true is for angles"));
        }
        Ok(Self { wanted, unit, field, id, form })
    }
}

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
    let (groups, mut notes) = collector.finish().map_err(place)?;
    notes.extend(note.map(|says| (None, says)));
    let mut channels: Vec<_> = groups.into_iter().flat_map(|g| finish_group(g, request.table)).collect();
    // In the order of the request, which names each channel once.
    let order = |name: &str| request.wanted.iter().position(|s| s.wanted.name == name);
    channels.sort_by_key(|c| order(&c.name));
    let notes = notes.into_iter().map(|(line, says)| Note { file: path.to_owned(), line, says }).collect();
    Ok(Table { channels, origin: Origin { source, first_row: 0, is_table: false }, notes })
}

fn finish_group(group: Group, table: usize) -> Vec<super::Channel> {
    let time: Arc<[f64]> = group.time.into();
    let columns = group.selections.into_iter().zip(group.values);
    columns.map(|(s, values)| finished(&s.wanted, s.unit, table, &time, values)).collect()
}

/// Whether the first lines of a file look like such a log.
pub(super) fn looks_like_log(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start);
    text.lines().take(5).any(|line| sentence::parse(line).is_ok())
}
