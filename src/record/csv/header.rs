//! The header line, and which of its columns are wanted.

use super::super::Hold;
use super::super::request::{Clock, Request, Wanted};
use super::field::{self, Field};
use crate::error::nearest;
use crate::units::{Dimension, Unit};
use crate::{Error, Result};

/// A column that is read.
pub(super) struct Column {
    pub index: usize,
    pub unit: Unit,
    pub wanted: Wanted,
}

/// The header, understood.
pub(super) struct Header {
    /// Names of all columns.
    pub names: Vec<String>,
    /// The column of time, if times come from one.
    pub time: Option<Column>,
    /// The channels in their order in the recording.
    pub channels: Vec<Column>,
    pub notes: Vec<String>,
}

/// `name [unit]` of one column.
pub(super) struct Cell {
    pub at: usize,
    pub name: String,
    pub unit: Option<String>,
}

impl Header {
    pub(super) fn parse(line: &[u8], request: &Request) -> Result<Self> {
        let cells = cells(line)?;
        let mut header = Self {
            names: cells.iter().map(|c| c.name.clone()).collect(),
            time: None,
            channels: Vec::new(),
            notes: Vec::new(),
        };
        header.time = header.time_column(&cells, &request.clock)?;
        if request.wanted.is_empty() {
            header.channels = header.every_column(&cells)?;
        } else {
            for wanted in &request.wanted {
                let index = find(&cells, &wanted.column)?;
                let column = header.column(&cells[index], index, wanted.clone())?;
                header.channels.push(column);
            }
        }
        Ok(header)
    }

    fn time_column(&mut self, cells: &[Cell], clock: &Clock) -> Result<Option<Column>> {
        let (index, unit) = match clock {
            Clock::Regular { .. } | Clock::RowNumbers => return Ok(None),
            Clock::FirstColumn => (0, None),
            Clock::Column { name, unit } => (find(cells, name)?, unit.clone()),
        };
        let cell = &cells[index];
        let wanted = plain(&cell.name, unit);
        let column = self.column(cell, index, wanted)?;
        if column.unit.dimension() != Dimension::TIME {
            return Err(Error::new(
                crate::ErrorKind::Units,
                format!("`{}` in [{}] is no column of time", cell.name, column.unit),
            )
            .with_column(cell.at + 1)
            .with_hint(
                "the first column is time, such as `t [s]`; or write a TOML recording that says \
                 where the time is (kind = \"trials\" where rows are steady trials)",
            ));
        }
        Ok(Some(column))
    }

    fn every_column(&mut self, cells: &[Cell]) -> Result<Vec<Column>> {
        let time = self.time.as_ref().map(|t| t.index);
        refuse_twins(cells)?;
        let mut channels = Vec::new();
        for (index, cell) in cells.iter().enumerate().filter(|(i, _)| Some(*i) != time) {
            channels.push(self.column(cell, index, plain(&cell.name, None))?);
        }
        if channels.is_empty() {
            return Err(Error::bad_input("there is no column beside the time"));
        }
        Ok(channels)
    }

    /// Settles the unit of a column: the recording's word, else the header's.
    fn column(&mut self, cell: &Cell, index: usize, wanted: Wanted) -> Result<Column> {
        let own = cell.unit.as_deref().map(Unit::parse).transpose();
        let unit = match (&wanted.unit, own) {
            (Some(unit), own) => {
                if let Ok(Some(own)) = own
                    && (own.dimension() != unit.dimension() || own.to_si(1.0) != unit.to_si(1.0))
                {
                    self.notes.push(format!(
                        "the header gives `{}` in [{own}], the recording in [{unit}]; [{unit}] is used",
                        cell.name
                    ));
                }
                unit.clone()
            }
            (None, Ok(Some(own))) => own,
            (None, Err(e)) => return Err(e.with_line(1).with_column(cell.at + 1)),
            (None, Ok(None)) => {
                let is_time = index == 0 && cell.name.to_lowercase().starts_with('t');
                let likely = if is_time { "s" } else { "deg" };
                return Err(Error::bad_input(format!("column {} `{}` has no unit", index + 1, cell.name))
                    .with_column(cell.at + 1)
                    .with_hint(format!(
                        "write it in the header as `{} [{likely}]` ([1] for none), or give units in a TOML recording",
                        cell.name
                    )));
            }
        };
        if wanted.wraps && unit.dimension() != Dimension::NONE {
            return Err(Error::bad_input(format!("`{}` in [{unit}] cannot wrap at a turn", wanted.name))
                .with_column(cell.at + 1)
                .with_hint("wraps = true is for angles"));
        }
        Ok(Column { index, unit, wanted })
    }
}

fn plain(name: &str, unit: Option<Unit>) -> Wanted {
    let (name, column) = (name.to_owned(), name.to_owned());
    Wanted { name, column, unit, wraps: false, hold: Hold::Linear }
}

/// First bytes of what is no table of text, what it is, and what to do.
const NO_TEXT: [(&[u8], &str, &str); 9] = [
    (&[0xFF, 0xFE, 0, 0], "the file begins with a byte-order mark of UTF-32", FROM_UTF_32),
    (&[0, 0, 0xFE, 0xFF], "the file begins with a byte-order mark of UTF-32", FROM_UTF_32),
    (&[0xFF, 0xFE], "the file begins with a byte-order mark of UTF-16", UTF_8),
    (&[0xFE, 0xFF], "the file begins with a byte-order mark of UTF-16", UTF_8),
    (b"PK\x03\x04", "this is a zip archive, or a table of a spreadsheet program", "save the table as CSV"),
    (&[0x1F, 0x8B], "the file is packed by gzip twice", "unpack it once, with `gzip -d`"),
    (b"BZh", "the file is packed by bzip2", "unpack it, or pack it by gzip"),
    (&[0xFD, b'7', b'z', b'X', b'Z'], "the file is packed by xz", "unpack it, or pack it by gzip"),
    (&[0x28, 0xB5, 0x2F, 0xFD], "the file is packed by zstd", "unpack it, or pack it by gzip"),
];
const UTF_8: &str = "save it as UTF-8, for instance with `iconv -f UTF-16 -t UTF-8`";
const FROM_UTF_32: &str = "save it as UTF-8, for instance with `iconv -f UTF-32 -t UTF-8`";

fn refuse_what_is_no_text(line: &[u8]) -> Result<()> {
    let known = NO_TEXT.iter().find(|(start, ..)| line.starts_with(start));
    let zero = ("the header holds bytes of zero: this is UTF-16 without its mark, or no text", UTF_8);
    let found = known.map(|(_, what, remedy)| (*what, *remedy)).or(line.contains(&0).then_some(zero));
    match found {
        Some((what, remedy)) => Err(Error::bad_input(what).with_column(1).with_hint(remedy)),
        None => Ok(()),
    }
}

fn refuse_other_separators(line: &[u8]) -> Result<()> {
    let found = |byte: u8| line.iter().position(|b| *b == byte);
    let (name, at) = match (found(b','), found(b';'), found(b'\t')) {
        (None, Some(at), _) => ("semicolons", at),
        (None, None, Some(at)) => ("tabs", at),
        _ => return Ok(()),
    };
    Err(Error::bad_input(format!("the columns are separated by {name}"))
        .with_column(at + 1)
        .with_hint("save the table with commas between columns and decimal points in the numbers"))
}

/// Refuses two columns of the same name.
pub(super) fn refuse_twins(cells: &[Cell]) -> Result<()> {
    for (index, cell) in cells.iter().enumerate() {
        if let Some(first) = cells[..index].iter().position(|c| c.name == cell.name) {
            return Err(Error::bad_input(format!(
                "columns {} and {} are both named `{}`",
                first + 1,
                index + 1,
                cell.name
            ))
            .with_column(cell.at + 1)
            .with_hint("rename one of them in the header"));
        }
    }
    Ok(())
}

/// The cells of a header line, which is text between commas.
pub(super) fn cells(line: &[u8]) -> Result<Vec<Cell>> {
    refuse_what_is_no_text(line)?;
    refuse_other_separators(line)?;
    let fields = field::split(line)
        .ok_or_else(|| Error::bad_input("a double quote in the header is not closed").with_column(1))?;
    if fields.iter().all(|f| !f.text.is_empty() && field::number(&f.text).is_some_and(|v| !v.is_nan())) {
        return Err(Error::bad_input("the first line holds numbers; a header with names is missing")
            .with_column(1)
            .with_hint("put a line such as `t [s],roll [deg]` before the first row"));
    }
    fields.iter().map(cell).collect()
}

fn cell(field: &Field) -> Result<Cell> {
    let text = std::str::from_utf8(&field.text)
        .map_err(|_| Error::bad_input("the header is no UTF-8 text").with_column(field.at + 1))?
        .trim();
    let (name, unit) = match text.strip_suffix(']').and_then(|t| t.rsplit_once('[')) {
        Some((name, unit)) => (name.trim_end(), Some(unit.trim().to_owned())),
        None => (text, None),
    };
    Ok(Cell { at: field.at, name: name.to_owned(), unit })
}

/// The column of a name, with or without its unit.
fn find(cells: &[Cell], name: &str) -> Result<usize> {
    let same =
        |c: &Cell| c.name == name || c.unit.as_ref().is_some_and(|u| name == format!("{} [{u}]", c.name));
    let mut places = cells.iter().enumerate().filter(|(_, c)| same(c)).map(|(i, _)| i);
    match (places.next(), places.next()) {
        (Some(index), None) => Ok(index),
        (Some(a), Some(b)) => {
            Err(Error::bad_input(format!("columns {} and {} are both named `{name}`", a + 1, b + 1))
                .with_column(cells[b].at + 1)
                .with_hint("rename one of them in the header"))
        }
        (None, _) => {
            let names = || cells.iter().map(|c| c.name.as_str());
            let meant = nearest(name, names()).map(|n| format!("did you mean `{n}`? "));
            let all = names().collect::<Vec<_>>().join(", ");
            Err(Error::bad_input(format!("the file has no column `{name}`"))
                .with_column(1)
                .with_hint(format!("{}its columns are {all}", meant.unwrap_or_default())))
        }
    }
}
