//! A table whose units and channels nobody has told yet: its header and its columns as they stand.

use super::field;
use super::header;
use crate::record::input::{self, Input, Sink};
use crate::record::nmea;
use crate::{Error, Result};
use std::path::Path;

/// A column of a table as the file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Raw {
    /// Name in the header, without a unit in square brackets.
    pub name: String,
    /// The unit in square brackets as it is written there.
    pub unit: Option<String>,
    /// Numbers as written; NaN where the field is empty, no number, or not there.
    pub values: Vec<f64>,
    /// First field that is no number, with its line from 1.
    pub text: Option<(usize, String)>,
    /// The fields that are dates and times, in nanoseconds since 1970.
    pub stamps: Vec<i128>,
}

/// Looks at a table of text (plain or gzip) without knowing what its columns mean.
///
/// # Errors
/// `BadInput` with file, line and column where the header cannot be read, two columns have the same
/// name, or no rows follow; `Io`.
///
/// ```
/// let folder = tempfile::tempdir().unwrap();
/// let file = folder.path().join("log.csv");
/// std::fs::write(&file, "t [s],\"roll, port\"\n0,1.5\n1,calm\n").unwrap();
/// let columns = gyrospec::record::columns(&file)?;
/// assert_eq!(columns[0].unit.as_deref(), Some("s"));
/// assert_eq!(columns[1].name, "roll, port");
/// assert_eq!(columns[1].text, Some((3, "calm".to_owned())));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn columns(path: &Path) -> Result<Vec<Raw>> {
    let mut look = Look { line: 0, columns: Vec::new() };
    let place = |e: Error| if e.file().is_some() { e } else { e.with_file(path) };
    input::read_lines(Input::open(path)?, &mut look).map_err(place)?;
    match look.line {
        0 => Err(place(super::empty())),
        _ => Ok(look.columns),
    }
}

struct Look {
    line: usize,
    columns: Vec<Raw>,
}

impl Sink for Look {
    fn take(&mut self, block: &[u8]) -> Result<()> {
        let block = block.strip_suffix(b"\n").unwrap_or(block);
        for line in block.split(|b| *b == b'\n') {
            self.line += 1;
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            if self.line == 1 {
                self.columns = raw(line).map_err(|e| e.with_line(1))?;
            } else {
                self.row(line);
            }
        }
        Ok(())
    }

    fn lines(&self) -> usize {
        self.line
    }
}

impl Look {
    /// Takes what can be taken; whoever reads the table for its numbers judges its lines.
    fn row(&mut self, line: &[u8]) {
        let fields = field::split(line).unwrap_or_default();
        for (c, f) in self.columns.iter_mut().zip(&fields) {
            let number = field::number(&f.text);
            c.values.push(number.unwrap_or(f64::NAN));
            if number.is_none() {
                c.text.get_or_insert_with(|| (self.line, f.shown()));
                c.stamps.extend(std::str::from_utf8(&f.text).ok().and_then(nmea::stamp));
            }
        }
    }
}

fn raw(line: &[u8]) -> Result<Vec<Raw>> {
    let cells = header::cells(line)?;
    header::refuse_twins(&cells)?;
    let raw = |c: header::Cell| Raw {
        name: c.name,
        unit: c.unit,
        values: Vec::new(),
        text: None,
        stamps: Vec::new(),
    };
    Ok(cells.into_iter().map(raw).collect())
}
