//! Purpose: the data rows of a table of text, checked as they come.
//!
//! Method: fields between commas are parsed straight from the block into growing columns;
//! whatever is wrong is looked at again, slowly, to say what and where.
//!
//! Numerical aspects: decimal to double by the standard library, correctly rounded.

use super::field::{self, Field, number};
use super::header::Header;
use crate::{Error, Result};

/// What to do about a last line that is wrong and has no end.
pub(super) const CUT_SHORT: &str = "the file seems to be cut short: copy it again from where it was made";
/// Bytes of the last whole lines that are kept to judge a last line without its end.
const SHAPE_BYTES: usize = 4096;
/// So many numbers above with equal decimals make a fixed format.
const NUMBERS_FOR_SHAPE: usize = 2;

/// What should be known of a table, by line.
pub(super) type Notes = Vec<(Option<usize>, String)>;

pub(super) struct Rows {
    names: Vec<String>,
    /// For each column of the file, the columns of `data` that want it.
    slots: Vec<Vec<usize>>,
    /// The file's column of time; it is column 0 of `data`.
    time: Option<usize>,
    /// Whether rows may have no time, since other columns may be clocks too.
    is_open: bool,
    data: Vec<Vec<f64>>,
    previous: f64,
    /// Number of the next data row.
    row: usize,
    first: usize,
    last: usize,
    blank: Option<usize>,
    shape: Vec<u8>,
    notes: Notes,
}

impl Rows {
    pub(super) fn new(header: &Header, rows: Option<(usize, usize)>, is_open: bool) -> Self {
        let columns = header.time.iter().chain(&header.channels);
        let mut slots = vec![Vec::new(); header.names.len()];
        for (slot, column) in columns.enumerate() {
            slots[column.index].push(slot);
        }
        let (first, last) = rows.unwrap_or((0, usize::MAX));
        Self {
            names: header.names.clone(),
            data: vec![Vec::new(); header.channels.len() + usize::from(header.time.is_some())],
            time: header.time.as_ref().map(|t| t.index),
            is_open,
            slots,
            previous: f64::NEG_INFINITY,
            row: 0,
            first,
            last,
            blank: None,
            shape: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Which columns are read.
    pub(super) fn used(&self) -> Vec<bool> {
        self.slots.iter().map(|s| !s.is_empty()).collect()
    }

    /// Takes a line without its end; `ended` tells whether it had one.
    pub(super) fn line(&mut self, line: &[u8], number: usize, ended: bool) -> Result<()> {
        // a spreadsheet leaves rows of separators alone below its table
        let is_bare = self.time.is_some() && line.iter().all(|b| matches!(b, b',' | b' '));
        if (line.is_empty() || is_bare) && self.names.len() > 1 {
            self.blank.get_or_insert(number);
            return Ok(());
        }
        if let Some(blank) = self.blank {
            return Err(Error::bad_input("the line is empty, and rows follow it")
                .with_line(blank)
                .with_column(1)
                .with_hint("remove it, or write its commas where the row is a gap"));
        }
        let row = self.row;
        self.row += 1;
        if (self.first..=self.last).contains(&row) {
            let kept = self.data.first().map_or(0, Vec::len);
            if let Err(index) = self.parse(line) {
                if self.is_of_others(line) {
                    self.data.iter_mut().for_each(|d| d.truncate(kept));
                    return Ok(());
                }
                return Err(self.explain(index, line, ended).with_line(number));
            }
            if !ended {
                self.last_line(line, number)?;
            }
        }
        Ok(())
    }

    /// The fast path.
    fn parse(&mut self, line: &[u8]) -> Result<(), usize> {
        if line.contains(&b'"') {
            return self.parse_quoted(line);
        }
        let mut index = 0;
        for text in line.split(|b| *b == b',') {
            self.store(index, text)?;
            index += 1;
        }
        if index == self.names.len() { Ok(()) } else { Err(index) }
    }

    fn parse_quoted(&mut self, line: &[u8]) -> Result<(), usize> {
        let fields = field::split(line, b',').ok_or(0_usize)?;
        for (index, field) in fields.iter().enumerate() {
            self.store(index, &field.text)?;
        }
        if fields.len() == self.names.len() { Ok(()) } else { Err(fields.len()) }
    }

    /// Puts a field where it is wanted; the number of the column where it cannot.
    fn store(&mut self, index: usize, text: &[u8]) -> Result<(), usize> {
        let Some(slots) = self.slots.get(index) else { return Err(index) };
        if slots.is_empty() {
            return Ok(());
        }
        let value = number(text).ok_or(index)?;
        for slot in slots {
            self.data[*slot].push(value);
        }
        if self.time == Some(index) && !(self.is_open && value.is_nan()) {
            if value.is_nan() || value <= self.previous {
                return Err(index);
            }
            self.previous = value;
        }
        Ok(())
    }

    /// Whether a row has neither time nor values here, as where another table beside this one is longer.
    fn is_of_others(&self, line: &[u8]) -> bool {
        let fields = field::split(line, b',').filter(|f| f.len() == self.names.len());
        let is_blank = |f: &Field| number(&f.text).is_some_and(f64::is_nan);
        let wanted = |f: Vec<Field>| f.iter().zip(&self.slots).all(|(f, s)| s.is_empty() || is_blank(f));
        self.time.is_some() && fields.is_some_and(wanted)
    }

    /// Why a line could not be taken.
    fn explain(&self, index: usize, line: &[u8], ended: bool) -> Error {
        let cut = CUT_SHORT;
        let Some(fields) = field::split(line, b',') else {
            let error = Error::bad_input("a double quote is not closed").with_column(1);
            return if ended { error } else { error.with_hint(cut) };
        };
        if let Some(at) = line.iter().position(|b| *b == b'\r') {
            return Error::bad_input("a carriage return stands inside the line").with_column(at + 1).with_hint(
                "the file mixes line ends: end every line in the same way, as `tr '\\r' '\\n'` does for lone \
                 carriage returns",
            );
        }
        let error = if fields.len() == self.names.len() {
            self.explain_field(index, &fields[index.min(fields.len() - 1)])
        } else if !ended && fields.len() < self.names.len() {
            Error::bad_input(format!(
                "the file ends in mid-line: {} of {} fields are there",
                fields.len(),
                self.names.len()
            ))
            .with_column(line.len() + 1)
        } else {
            self.explain_count(&fields)
        };
        if ended { error } else { error.with_hint(cut) }
    }

    fn explain_count(&self, fields: &[Field]) -> Error {
        let (got, want) = (fields.len(), self.names.len());
        let column = fields.get(want).or(fields.last()).map_or(1, |f| f.at + 1);
        let error =
            Error::bad_input(format!("the row has {got} fields, the header {want}")).with_column(column);
        if got > want {
            error.with_hint(
                "numbers need decimal points: a decimal comma (1,5) splits a number into two fields",
            )
        } else {
            error.with_hint("leave the field empty where a value is missing, between its separators")
        }
    }

    fn explain_field(&self, index: usize, field: &Field) -> Error {
        let name = self.names.get(index).map_or("", String::as_str);
        let place = format!("column {} `{name}`", index + 1);
        let shown = field.shown();
        let error = match number(&field.text) {
            None => explain_text(&place, &shown),
            Some(t) if t.is_nan() => Error::bad_input(format!("{place}: the time is empty"))
                .with_hint("remove rows without a time; values may be empty, times may not"),
            Some(t) if t == self.previous => {
                Error::bad_input(format!("{place}: the time {shown} occurs twice")).with_hint(
                    "keep one row for each time; where the clock of the log is too coarse, give \
                     time = { start = …, step = … } in a TOML recording",
                )
            }
            Some(_) => Error::bad_input(format!(
                "{place}: time runs backwards, from {} to {shown}",
                self.previous
            ))
            .with_hint(
                "split the table where its clock was set back, or pick one part by rows = [first, last]",
            ),
        };
        error.with_column(field.at + 1)
    }

    /// Keeps the last whole lines, by which a last line without its end is judged.
    pub(super) fn remember_shape(&mut self, block: &[u8]) {
        if block.ends_with(b"\n") {
            self.shape.extend_from_slice(&block[block.len().saturating_sub(SHAPE_BYTES)..]);
            self.shape.drain(..self.shape.len().saturating_sub(SHAPE_BYTES));
        }
    }

    /// A last line without its end has all its fields; its last number may be cut still. It is where the numbers
    /// above it all have more decimals, or where it is the only one that is not there.
    fn last_line(&mut self, line: &[u8], number: usize) -> Result<()> {
        // The first line kept is the header, or a part of a line.
        let lines = self.shape.split(|b| *b == b'\n').skip(1).map(last_field);
        let above: Vec<&[u8]> = lines.filter(|field| !field.is_empty()).collect();
        let whole = self.shape.split(|b| *b == b'\n').filter(|l| !l.is_empty()).count() == above.len() + 1;
        let usual = above.first().map_or(0, |field| decimals(field));
        let fixed = above.len() >= NUMBERS_FOR_SHAPE && above.iter().all(|field| decimals(field) == usual);
        let last = last_field(line);
        let what = if last == b"-" {
            "its last field is a sign alone, which is no number"
        } else if last.is_empty() && whole && above.len() >= NUMBERS_FOR_SHAPE {
            "the last number is missing, as it is in no line above it"
        } else if !last.is_empty() && fixed && decimals(last) < usual {
            "the last number has fewer decimals than those above it"
        } else {
            self.notes.push((Some(number), doubt(last, &above)));
            return Ok(());
        };
        Err(Error::bad_input(format!("the file ends in mid-line: {what}"))
            .with_line(number)
            .with_column(line.len() + 1)
            .with_hint(
                "the file seems to be cut short: copy it again; if it is whole, end its last line with a line end",
            ))
    }

    /// The columns, time first if it is one, and what was noticed.
    pub(super) fn finish(self) -> Result<(Vec<Vec<f64>>, Notes)> {
        if self.row == 0 {
            return Err(Error::bad_input("there are no rows below the header").with_line(2).with_column(1));
        }
        let wanted = if self.last == usize::MAX { self.first } else { self.last };
        if wanted >= self.row {
            return Err(Error::bad_input(format!(
                "rows = [{}, {}] asks for more than the {} rows that there are",
                self.first, self.last, self.row
            ))
            .with_line(self.row + 1)
            .with_hint(format!("rows count from 0; the last is {}", self.row - 1)));
        }
        Ok((self.data, self.notes))
    }
}

/// Why a field is no number.
fn explain_text(place: &str, shown: &str) -> Error {
    let error = Error::bad_input(format!("{place} holds `{shown}`, which is no number"));
    let comma = shown.split_once(',').is_some_and(|(a, b)| {
        number(a.as_bytes()).is_some() && b.bytes().all(|c| c.is_ascii_digit()) && !b.is_empty()
    });
    if comma {
        error.with_hint("write decimal points, 1.5, not 1,5, and nothing between thousands")
    } else if shown.contains(';') || shown.contains('\t') {
        error.with_hint("separate the columns by commas in every row")
    } else if shown.parse::<f64>().is_ok_and(f64::is_infinite) {
        Error::bad_input(format!("{place} holds `{shown}`, which is no finite number"))
            .with_hint("leave the field empty where the value is missing")
    } else {
        error.with_hint("leave the field empty where the value is missing, and remove words from the column")
    }
}

/// What is to be said of a last number that may be whole.
fn doubt(last: &[u8], above: &[&[u8]]) -> String {
    let (own, text) = (digits(last), String::from_utf8_lossy(last));
    if above.len() >= NUMBERS_FOR_SHAPE && above.iter().all(|field| digits(field) > own) {
        return format!(
            "the last line has no line end, and its last number, `{text}`, has fewer digits than those above it: \
             it is wrong if the file was cut short"
        );
    }
    "the last line has no line end; if the file was cut short, its last number may be too".into()
}

/// The last field of a line, without quotes.
fn last_field(line: &[u8]) -> &[u8] {
    let last = line.trim_ascii_end().rsplit(|b| *b == b',').next().unwrap_or_default().trim_ascii();
    last.strip_prefix(b"\"").map_or(last, |l| l.strip_suffix(b"\"").unwrap_or(l))
}

fn digits(number: &[u8]) -> usize {
    number.iter().filter(|b| b.is_ascii_digit()).count()
}

/// What stands behind the point of a number, a power of ten included.
fn decimals(number: &[u8]) -> usize {
    number.iter().position(|b| *b == b'.').map_or(0, |at| number.len() - at - 1)
}
