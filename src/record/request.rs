//! What a recording asks of one of its files.

use super::zero::Zero;
use super::{Channel, Hold, LeftOut, Note, Origin};
use crate::units::Unit;
use std::sync::Arc;

/// Where the times of a table come from.
#[derive(Debug, Clone)]
pub(super) enum Clock {
    /// The first column, whose unit stands in the header.
    FirstColumn,
    /// A column by name; its unit if it is not in the header.
    Column { name: String, unit: Option<Unit> },
    /// The first used row is at `start`, the others follow each `step`; s.
    Regular { start: f64, step: f64 },
    /// The rows are trials: their numbers.
    RowNumbers,
}

/// A channel that is wanted of a table.
#[derive(Debug, Clone)]
pub(super) struct Wanted {
    pub name: String,
    pub column: String,
    pub unit: Option<Unit>,
    pub wraps: bool,
    pub hold: Hold,
}

/// What a table gives.
pub(super) struct Table {
    pub channels: Vec<Channel>,
    pub origin: Origin,
    pub notes: Vec<Note>,
    /// Columns that are no channels though every column is wanted.
    pub left_out: Vec<LeftOut>,
    /// The zero of its dates and clocks.
    pub zero: Option<Zero>,
    /// The unit of its column of time, where that counts from a zero of its own.
    pub time_unit: Option<Unit>,
}

impl Table {
    /// Its origin, once for each clock that stands in it.
    pub fn origins(&self) -> Vec<Origin> {
        let of = |number: fn(usize, usize) -> usize| self.channels.iter().map(|c| c.table).reduce(number);
        let clocks = of(usize::max).zip(of(usize::min)).map_or(1, |(last, first)| last - first + 1);
        vec![self.origin.clone(); clocks]
    }
}

/// What is wanted of a table of text.
#[derive(Debug, Clone)]
pub(super) struct Request {
    pub clock: Clock,
    /// Nothing means every column but the time.
    pub wanted: Vec<Wanted>,
    /// First and last data row, from 0.
    pub rows: Option<(usize, usize)>,
    /// Number of the table in the recording.
    pub table: usize,
    /// Where dates and clocks count from, if another table says so.
    pub zero: Option<Zero>,
    /// Whether commas are decimal, or points, if the recording says so.
    pub comma: Option<bool>,
}

/// Turns numbers as read into a channel in SI, unwrapped where its angle wraps.
pub(super) fn finished(
    wanted: &Wanted,
    unit: Unit,
    table: usize,
    time: &Arc<[f64]>,
    mut values: Vec<f64>,
) -> Channel {
    for value in &mut values {
        *value = unit.to_si(*value);
    }
    if wanted.wraps {
        super::wrap::unwrap(&mut values);
    }
    values.shrink_to_fit();
    let (name, wraps, hold) = (wanted.name.clone(), wanted.wraps, wanted.hold);
    Channel { name, unit, wraps, hold, table, time: Arc::clone(time), values }
}
