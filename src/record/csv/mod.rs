//! Tables of text: one header line, then one row a sample, fields between commas.

mod clock;
mod clocks;
mod dialect;
mod field;
mod figures;
mod header;
mod look;
mod rows;
mod sample;
mod stamp;
mod translate;

use super::input::{self, Input, Sink};
use super::request::{Clock, Request, Table, finished};
use super::{Channel, LeftOut, Note, Origin, at_its_pace};
use crate::units::Unit;
use crate::{Error, Result};
#[cfg(feature = "diagnose")]
pub(crate) use clocks::of_raw;
use dialect::Dialect;
use header::{Cell, Header, Seen};
pub use look::{Raw, columns};
use rows::{Notes, Rows};
use std::path::Path;
use std::sync::Arc;
use translate::Translator;

/// Reads a table (plain or gzip).
///
/// # Errors
/// `BadInput` or `Units` with file, line and column for whatever is no such table.
pub(super) fn read(input: Input, request: &Request) -> Result<Table> {
    let input = input.into_table()?;
    let path = &input.path().to_owned();
    let named = match &request.clock {
        Clock::Column { name, unit } => Some((name.as_str(), unit.as_ref())),
        _ => None,
    };
    let dialect =
        dialect::of((input.start(), input.is_whole()), named, request.comma).map_err(|e| place(e, path))?;
    let mut reader = Reader::new(request, dialect);
    let coded = input.coded();
    let (source, note) = input::read_lines(input, &mut reader).map_err(|e| place(e, path))?;
    let zero = reader.translator.as_ref().and_then(Translator::zero);
    let time_unit = reader.time_unit().filter(|_| zero.is_none());
    let (channels, left_out, mut notes) = reader.finish().map_err(|e| place(e, path))?;
    notes.extend(note.into_iter().chain(coded).map(|says| (None, says)));
    let notes =
        notes.into_iter().map(|(line, message)| Note { file: path.to_owned(), line, message }).collect();
    let left_out = left_out.into_iter().map(|l| l.in_file(path)).collect();
    let first_row = request.rows.map_or(0, |r| r.0);
    let origin = Origin { source, first_row, is_table: true };
    Ok(Table { channels, origin, notes, left_out, zero, time_unit })
}

fn place(e: Error, path: &Path) -> Error {
    if e.file().is_some() { e } else { e.with_file(path) }
}

fn empty() -> Error {
    Error::bad_input("the file is empty")
        .with_hint("a recording begins with a header line such as `t [s],roll [deg]`")
}

struct Reader<'a> {
    request: &'a Request,
    line: usize,
    seen: Seen,
    /// For a table that is not written in the plain way.
    translator: Option<Translator>,
    header: Option<Header>,
    rows: Option<Rows>,
    notes: Notes,
}

impl Sink for Reader<'_> {
    fn take(&mut self, block: &[u8]) -> Result<()> {
        let mut rest = block;
        let mut plain = Vec::new();
        while !rest.is_empty() {
            let end = rest.iter().position(|b| *b == b'\n');
            let line = &rest[..end.unwrap_or(rest.len())];
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            self.line += 1;
            match self.translator.take() {
                None => self.one(line, end.is_some())?,
                Some(mut translator) => {
                    let turned = self.turned(&mut translator, line, end.is_some(), &mut plain);
                    self.translator = Some(translator);
                    turned?;
                }
            }
            rest = &rest[end.map_or(rest.len(), |at| at + 1)..];
        }
        if let Some(rows) = &mut self.rows {
            rows.remember_shape(if self.translator.is_some() { &plain } else { block });
        }
        Ok(())
    }

    fn lines(&self) -> usize {
        self.line
    }
}

impl<'a> Reader<'a> {
    fn new(request: &'a Request, dialect: Option<Dialect>) -> Self {
        let seen = dialect.as_ref().map(Dialect::seen).unwrap_or_default();
        let notes = dialect.as_ref().map(Dialect::notes).unwrap_or_default();
        let translator = dialect.filter(|d| !d.is_plain).map(|d| Translator::new(d, request.zero.clone()));
        Self { request, line: 0, seen, translator, header: None, rows: None, notes }
    }

    /// A line of the plain dialect.
    fn one(&mut self, line: &[u8], ended: bool) -> Result<()> {
        match &mut self.rows {
            None => {
                let cells = header::cells(line).map_err(|e| e.with_line(self.line))?;
                self.begin(&cells, self.line)
            }
            Some(rows) => rows.line(line, self.line, ended),
        }
    }

    /// A line of another dialect; the plain one is added to `plain`.
    fn turned(&mut self, by: &mut Translator, line: &[u8], ended: bool, plain: &mut Vec<u8>) -> Result<()> {
        if self.rows.is_none() {
            let mut cells = by.cells();
            header::tell_apart(&mut cells);
            self.begin(&cells, by.header())?;
            by.reads(self.rows.as_ref().map(Rows::used).unwrap_or_default());
            // what is kept to judge a last line begins behind a line
            plain.push(b'\n');
        }
        let cut = |e: Error| if ended { e } else { e.with_hint(rows::CUT_SHORT) };
        let Some(turned) = by.line(line, self.line).map_err(|e| cut(e.with_line(self.line)))? else {
            return Ok(());
        };
        plain.extend_from_slice(turned);
        plain.extend_from_slice(if ended { b"\n" } else { b"" });
        let Some(rows) = &mut self.rows else { return Ok(()) };
        rows.line(turned, self.line, ended)
    }

    fn begin(&mut self, cells: &[Cell], line: usize) -> Result<()> {
        let mut header = Header::of(cells, self.request, &self.seen).map_err(|e| e.with_line(line))?;
        header.left_out.iter_mut().for_each(|l| l.line = Some(line));
        self.notes.extend(header.notes.iter().map(|says| (Some(line), says.clone())));
        let is_open = has_clocks(&header, self.request, &self.seen);
        self.rows = Some(Rows::new(&header, self.request.rows, is_open));
        self.header = Some(header);
        Ok(())
    }

    fn time_unit(&self) -> Option<Unit> {
        self.header.as_ref()?.time.as_ref().map(|t| t.unit.clone())
    }

    fn finish(self) -> Result<(Vec<Channel>, Vec<LeftOut>, Notes)> {
        let (Some(header), Some(rows)) = (self.header, self.rows) else {
            return Err(empty());
        };
        let has_clocks = has_clocks(&header, self.request, &self.seen);
        let (mut columns, mut notes) = rows.finish()?;
        notes.extend(self.notes);
        let zero = self.translator.as_ref().and_then(Translator::zero);
        notes.extend(zero.map(|z| (None, format!("time counts from {}", z.text))));
        notes.extend(self.translator.as_ref().and_then(Translator::order).map(|says| (None, says)));
        if self.translator.as_ref().is_some_and(Translator::found_commas) {
            notes.push((None, "commas are decimal".into()));
        }
        let line = |l: &LeftOut| (l.line, format!("`{}` is left out: {}", l.label, l.why));
        notes.extend(header.left_out.iter().map(line));
        let first = self.request.rows.map_or(0, |r| r.0);
        let count = columns.first().map_or(0, Vec::len);
        let time: Arc<[f64]> = match (&header.time, &self.request.clock) {
            (Some(time), _) => columns.remove(0).into_iter().map(|t| time.unit.to_si(t)).collect(),
            (None, Clock::Regular { start, step }) => (0..count).map(|i| start + i as f64 * step).collect(),
            (None, _) => (first..first + count).map(|i| i as f64).collect(),
        };
        let channels = if has_clocks {
            side_by_side(&header, self.request.table, (&time, columns), &mut notes)?
        } else {
            on_one_clock(&header, self.request.table, (&time, columns))
        };
        let are_trials = matches!(self.request.clock, Clock::RowNumbers);
        let channels = channels.into_iter().map(|c| if are_trials { c } else { at_its_pace(c) }).collect();
        Ok((channels, header.left_out, notes))
    }
}

/// Whether columns may be clocks of those that follow them, where nobody said which column is the time.
fn has_clocks(header: &Header, request: &Request, seen: &Seen) -> bool {
    let untold = request.wanted.is_empty() && matches!(request.clock, Clock::FirstColumn);
    untold && seen.time.is_none() && clocks::may_be(&header.channels).next().is_some()
}

fn on_one_clock(
    header: &Header,
    table: usize,
    (time, columns): (&Arc<[f64]>, Vec<Vec<f64>>),
) -> Vec<Channel> {
    let pairs = header.channels.iter().zip(columns);
    pairs.map(|(c, v)| finished(&c.wanted, c.unit.clone(), table, time, v)).collect()
}

/// The channels, each on the clock that it stands behind.
fn side_by_side(
    header: &Header,
    table: usize,
    (time, columns): (&[f64], Vec<Vec<f64>>),
    notes: &mut Notes,
) -> Result<Vec<Channel>> {
    let first = header.time.as_ref().map_or("", |t| t.wanted.name.as_str());
    let seconds = |at: usize| columns[at].iter().map(|t| header.channels[at].unit.to_si(*t)).collect();
    let may_be = clocks::may_be(&header.channels);
    let sides = clocks::sides(time, header.channels.len(), may_be, seconds);
    let mut channels: Vec<Channel> = Vec::new();
    for (i, side) in sides.into_iter().enumerate() {
        let clock = side.clock.map(|c| &header.channels[c]);
        let times = side.clock.map_or_else(|| time.to_vec(), seconds);
        let name = clock.map_or(first, |c| c.wanted.name.as_str());
        let rows = clocks::rows(name, &times, &columns[side.columns.clone()])?;
        let kept = |of: &[f64]| rows.iter().map(|row| of[*row]).collect::<Vec<f64>>();
        let times: Arc<[f64]> = kept(&times).into();
        for at in side.columns {
            let c = &header.channels[at];
            if c.wanted.name == first || channels.iter().any(|other| other.name == c.wanted.name) {
                return Err(header::twins(&c.wanted.name));
            }
            channels.push(finished(&c.wanted, c.unit.clone(), table + i, &times, kept(&columns[at])));
        }
        if let Some(clock) = clock {
            let on: Vec<String> =
                channels.iter().filter(|c| c.table == table + i).map(|c| format!("`{}`", c.name)).collect();
            let says = format!("column {}, `{name}`, is the clock of {}", clock.index + 1, on.join(", "));
            notes.push((None, says));
        }
    }
    Ok(channels)
}
