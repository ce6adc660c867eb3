//! Lines of any dialect in the plain one: commas between columns, decimal points, seconds since the first row.

use super::clock::Reading;
use super::dialect::Dialect;
use super::field::{self, Field};
use super::figures::{self, Form, ONE_WAY, two_ways};
use super::header::Cell;
use super::sample::is_comment;
use crate::record::label::{label, unit};
use crate::record::zero::Zero;
use crate::{Error, Result};

/// Turns line after line.
pub(super) struct Translator {
    dialect: Dialect,
    reading: Option<Reading>,
    /// Whether a row was met.
    is_begun: bool,
    /// Whether the decimal sign was not known at the beginning.
    is_open: bool,
    /// Columns that are read.
    used: Vec<bool>,
    plain: Vec<u8>,
}

impl Translator {
    /// For a table whose time may count from the zero of another.
    pub(super) fn new(dialect: Dialect, zero: Option<Zero>) -> Self {
        let reading = dialect.clock.clone().map(|clock| Reading::new(clock, zero));
        Self {
            is_begun: false,
            is_open: dialect.comma.is_none(),
            dialect,
            reading,
            used: Vec::new(),
            plain: Vec::new(),
        }
    }

    /// Tells which columns are read.
    pub(super) fn reads(&mut self, used: Vec<bool>) {
        self.used = used;
    }

    /// The line of the header, from 1.
    pub(super) fn header(&self) -> usize {
        self.dialect.header
    }

    /// The column of time, where it is no number in a unit of time.
    pub(super) fn clock(&self) -> Option<usize> {
        self.dialect.clock.as_ref().map(|c| c.column)
    }

    /// The labels of the columns.
    pub(super) fn cells(&self) -> Vec<Cell> {
        let clock = self.dialect.clock.as_ref();
        let of = |(index, (at, text)): (usize, &(usize, String))| {
            if clock.is_some_and(|c| c.column == index) {
                return Cell {
                    at: *at,
                    name: label(text).name,
                    unit: Some("s".into()),
                    whole: text.clone(),
                    is_guessed: false,
                };
            }
            let mut cell = Cell::of(*at, text);
            if let Some(unit) = self.dialect.units.get(index).filter(|u| !u.is_empty()) {
                cell = Cell {
                    at: *at,
                    name: text.clone(),
                    unit: of_row(unit),
                    whole: text.clone(),
                    is_guessed: false,
                };
            }
            cell
        };
        self.dialect.labels.iter().enumerate().map(of).collect()
    }

    /// Whether commas were found to be decimal only beyond the lines that were looked at.
    pub(super) fn found_commas(&self) -> bool {
        self.is_open && self.dialect.comma == Some(true)
    }

    /// The zero of time, once a row was read.
    pub(super) fn zero(&self) -> Option<Zero> {
        self.reading.as_ref()?.zero()
    }

    /// What is to be said of the order of day and month.
    pub(super) fn order(&self) -> Option<String> {
        self.reading.as_ref()?.order()
    }

    /// A line of the body in the plain dialect; none for a comment and for what stands above the rows.
    ///
    /// # Errors
    /// A time that there is not, with its column.
    pub(super) fn line(&mut self, line: &[u8], number: usize) -> Result<Option<&[u8]>> {
        if number < self.dialect.body || is_comment(line) {
            return Ok(None);
        }
        self.plain.clear();
        if line.trim_ascii().is_empty() {
            // below the names a line may be empty before the first row
            return Ok(self.is_begun.then_some(&self.plain));
        }
        self.is_begun = true;
        let Some(mut fields) = field::split(line, self.dialect.separator) else {
            return Err(Error::bad_input("a double quote is not closed in this line")
                .with_column(1)
                .with_hint("close it; a cell of several lines must be made one of one line"));
        };
        let width = self.dialect.labels.len();
        while fields.len() > width && fields.last().is_some_and(|f| f.text.trim_ascii().is_empty()) {
            fields.pop();
        }
        let seconds = self.reading.as_mut().map(|r| r.seconds(&fields)).transpose()?;
        let clock = self.dialect.clock.as_ref().map(|c| c.column);
        for (index, field) in fields.iter().enumerate() {
            if index > 0 {
                self.plain.push(b',');
            }
            if clock == Some(index) {
                let seconds = seconds.as_ref().and_then(Option::as_deref);
                self.plain.extend_from_slice(seconds.unwrap_or_default().as_bytes());
            } else if self.used.get(index).is_none_or(|used| *used) {
                put(field, &mut self.dialect, &mut self.plain)?;
            }
        }
        Ok(Some(&self.plain))
    }
}

/// A unit in a row of its own, as it stands where the list does not have it, so that it is told; loggers number records and
/// times there by two letters.
fn of_row(text: &str) -> Option<String> {
    let is_none = ["TS", "RN", "n/a", "unitless"].contains(&text);
    unit(text).or_else(|| (!is_none).then(|| text.to_owned()))
}

/// A field with a decimal point; what is no number stays as it is, in quotes. The first number that tells the decimal
/// sign settles it for all that follow.
fn put(field: &Field, dialect: &mut Dialect, out: &mut Vec<u8>) -> Result<()> {
    let Dialect { comma, is_grouped, .. } = dialect;
    let text = String::from_utf8_lossy(field.text.trim_ascii()).into_owned();
    let error = |what: &str| {
        Err(Error::bad_input(format!("`{text}` {what}")).with_column(field.at + 1).with_hint(ONE_WAY))
    };
    let form = figures::form(&text);
    let own = match form {
        Form::Missing => return Ok(()),
        Form::Text => {
            out.extend_from_slice(format!("\"{}\"", text.replace('"', " ")).as_bytes());
            return Ok(());
        }
        Form::GroupedByPoints | Form::GroupedByCommas => {
            *is_grouped = true;
            Some(form == Form::GroupedByPoints)
        }
        Form::Comma => Some(true),
        Form::Point => Some(false),
        // a sign between thousands is taken for one only beside numbers that have both signs
        Form::EitherComma | Form::EitherPoint
            if comma.is_none() || !*is_grouped && *comma != Some(form == Form::EitherComma) =>
        {
            return Err(two_ways(&text, field.at));
        }
        Form::Whole | Form::EitherComma | Form::EitherPoint => None,
    };
    *comma = comma.or(own);
    if own.is_some_and(|own| *comma != Some(own)) {
        return error("has another decimal sign than the numbers above it, or than the recording says");
    }
    // an infinity has no digits and is told by the rows
    out.extend_from_slice(figures::plain(&text, *comma == Some(true)).unwrap_or(text).as_bytes());
    Ok(())
}
