//! Tables of text: one header line, then one row a sample, fields between commas.

mod field;
mod header;
mod look;
mod rows;

use super::input::{self, Input, Sink};
use super::request::{Clock, Request, finished};
use super::{Channel, Note, Origin};
use crate::{Error, Result};
use header::Header;
pub use look::{Raw, columns};
use rows::{Notes, Rows};
use std::path::Path;
use std::sync::Arc;

/// What a table gives.
pub(super) struct Table {
    pub channels: Vec<Channel>,
    pub origin: Origin,
    pub notes: Vec<Note>,
}

/// Reads a table (plain or gzip).
///
/// # Errors
/// `BadInput` or `Units` with file, line and column for whatever is no such table.
pub(super) fn read(input: Input, request: &Request) -> Result<Table> {
    let path = &input.path().to_owned();
    let mut reader = Reader { request, line: 0, header: None, rows: None };
    let (source, note) = input::read_lines(input, &mut reader).map_err(|e| place(e, path))?;
    let (channels, mut notes) = reader.finish().map_err(|e| place(e, path))?;
    notes.extend(note.map(|says| (None, says)));
    let notes =
        notes.into_iter().map(|(line, message)| Note { file: path.to_owned(), line, message }).collect();
    let first_row = request.rows.map_or(0, |r| r.0);
    Ok(Table { channels, origin: Origin { source, first_row, is_table: true }, notes })
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
    header: Option<Header>,
    rows: Option<Rows>,
}

impl Sink for Reader<'_> {
    fn take(&mut self, block: &[u8]) -> Result<()> {
        let mut rest = block;
        while !rest.is_empty() {
            let end = rest.iter().position(|b| *b == b'\n');
            let line = &rest[..end.unwrap_or(rest.len())];
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            self.line += 1;
            match &mut self.rows {
                None => self.begin(line)?,
                Some(rows) => rows.line(line, self.line, end.is_some())?,
            }
            rest = &rest[end.map_or(rest.len(), |at| at + 1)..];
        }
        if let Some(rows) = &mut self.rows {
            rows.remember_shape(block);
        }
        Ok(())
    }

    fn lines(&self) -> usize {
        self.line
    }
}

impl Reader<'_> {
    fn begin(&mut self, line: &[u8]) -> Result<()> {
        let header = Header::parse(line, self.request).map_err(|e| e.with_line(1))?;
        self.rows = Some(Rows::new(&header, self.request.rows));
        self.header = Some(header);
        Ok(())
    }

    fn finish(self) -> Result<(Vec<Channel>, Notes)> {
        let (Some(header), Some(rows)) = (self.header, self.rows) else {
            return Err(empty());
        };
        let (mut columns, mut notes) = rows.finish()?;
        notes.extend(header.notes.iter().map(|says| (Some(1), says.clone())));
        let first = self.request.rows.map_or(0, |r| r.0);
        let count = columns.first().map_or(0, Vec::len);
        let time: Arc<[f64]> = match (&header.time, &self.request.clock) {
            (Some(time), _) => columns.remove(0).into_iter().map(|t| time.unit.to_si(t)).collect(),
            (None, Clock::Regular { start, step }) => (0..count).map(|i| start + i as f64 * step).collect(),
            (None, _) => (first..first + count).map(|i| i as f64).collect(),
        };
        let pairs = header.channels.iter().zip(columns);
        let table = self.request.table;
        let channels = pairs.map(|(c, v)| finished(&c.wanted, c.unit.clone(), table, &time, v)).collect();
        Ok((channels, notes))
    }
}
