//! A table whose units and channels nobody has told yet: its header and its columns as they stand.

use super::translate::Translator;
use super::{dialect, field, header};
use crate::record::input::{self, Input, Sink};
use crate::{Error, Result};
use std::path::Path;

/// A column of a table as the file has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Raw {
    /// Name in the header, without a unit in square brackets.
    pub name: String,
    /// The unit that the header or a row of units gives.
    pub unit: Option<String>,
    /// Whether that is only the last word of the name.
    pub is_guessed: bool,
    /// Numbers as written; NaN where the field is empty, no number, or not there.
    pub values: Vec<f64>,
    /// First field that is no number, with its line from 1.
    pub text: Option<(usize, String)>,
    /// Where it holds dates, clocks or counts since 1970: its first one, and `values` are seconds since then.
    pub since: Option<String>,
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
    let place = |e: Error| if e.file().is_some() { e } else { e.with_file(path) };
    let input = Input::open(path)?.into_table()?;
    let dialect = dialect::of((input.start(), input.is_whole()), None, None).map_err(place)?;
    let translator = dialect.filter(|d| !d.is_plain).map(|d| Translator::new(d, None));
    let mut look = Look { line: 0, columns: Vec::new(), translator };
    input::read_lines(input, &mut look).map_err(place)?;
    match look.line {
        0 => Err(place(super::empty())),
        _ => Ok(look.columns),
    }
}

struct Look {
    line: usize,
    columns: Vec<Raw>,
    translator: Option<Translator>,
}

impl Sink for Look {
    fn take(&mut self, block: &[u8]) -> Result<()> {
        let block = block.strip_suffix(b"\n").unwrap_or(block);
        for line in block.split(|b| *b == b'\n') {
            self.line += 1;
            let line = line.strip_suffix(b"\r").unwrap_or(line);
            match self.translator.take() {
                Some(mut by) => {
                    if self.columns.is_empty() {
                        self.columns = raw(by.cells()).map_err(|e| e.with_line(by.header()))?;
                    }
                    if let Some(plain) = by.line(line, self.line).map_err(|e| e.with_line(self.line))? {
                        self.row(plain);
                    }
                    self.translator = Some(by);
                }
                None if self.line == 1 => {
                    let cells = header::cells(line).map_err(|e| e.with_line(1))?;
                    self.columns = raw(cells).map_err(|e| e.with_line(1))?;
                }
                None => self.row(line),
            }
        }
        let clock = self.translator.as_ref().and_then(|by| by.clock().zip(by.zero()));
        if let Some((column, zero)) = clock {
            self.columns[column].since = Some(zero.text);
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
        let fields = field::split(line, b',').unwrap_or_default();
        for (c, f) in self.columns.iter_mut().zip(&fields) {
            let number = field::number(&f.text);
            c.values.push(number.unwrap_or(f64::NAN));
            if number.is_none() {
                c.text.get_or_insert_with(|| (self.line, f.shown()));
            }
        }
    }
}

fn raw(mut cells: Vec<header::Cell>) -> Result<Vec<Raw>> {
    header::tell_apart(&mut cells);
    header::refuse_twins(&cells)?;
    let raw = |c: header::Cell| {
        let in_brackets = c.whole.ends_with(']');
        let name = if in_brackets { c.name } else { c.whole };
        Raw { name, unit: c.unit, is_guessed: c.is_guessed, values: Vec::new(), text: None, since: None }
    };
    Ok(cells.into_iter().map(raw).collect())
}
