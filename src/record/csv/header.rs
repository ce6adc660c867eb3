//! The header line, and which of its columns are wanted.

use super::super::recording::NO_UNIT;
use super::super::request::{Clock, Request, Wanted};
use super::super::{Hold, LeftOut};
use super::field::{self, Field};
use crate::error::nearest;
use crate::record::label::label;
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
    /// Columns that are left out where every column is wanted.
    pub left_out: Vec<LeftOut>,
    pub notes: Vec<String>,
}

/// What the first rows were seen to hold.
#[derive(Debug, Clone, Default)]
pub(super) struct Seen {
    /// The column of time, where it holds dates, clocks or counts since 1970.
    pub time: Option<usize>,
    /// The column of the day, if it is one of its own.
    pub day: Option<usize>,
    /// Columns of words, with one of them.
    pub words: Vec<(usize, String)>,
    /// The first field of each column.
    pub firsts: Vec<String>,
}

/// The label of one column.
pub(super) struct Cell {
    pub at: usize,
    pub name: String,
    pub unit: Option<String>,
    /// The label as it stands.
    pub whole: String,
    /// Whether the unit is only the last word of the name.
    pub is_guessed: bool,
}

impl Header {
    /// The header of these labels, by what the rows were seen to hold.
    pub(super) fn of(cells: &[Cell], request: &Request, seen: &Seen) -> Result<Self> {
        let mut header = Self {
            names: cells.iter().map(|c| c.name.clone()).collect(),
            time: None,
            channels: Vec::new(),
            left_out: Vec::new(),
            notes: Vec::new(),
        };
        header.time = header.time_column(cells, &request.clock, seen)?;
        if request.wanted.is_empty() {
            header.channels = header.every_column(cells, seen)?;
        } else {
            for wanted in &request.wanted {
                let index = find(cells, &wanted.column)?;
                let column = header.column(&cells[index], index, wanted.clone())?;
                header.channels.push(column);
            }
        }
        Ok(header)
    }

    fn time_column(&mut self, cells: &[Cell], clock: &Clock, seen: &Seen) -> Result<Option<Column>> {
        // a column without a label numbers the rows
        let first = || cells.iter().position(|c| !c.whole.is_empty()).unwrap_or(0);
        let (index, unit) = match clock {
            Clock::Regular { .. } | Clock::RowNumbers => return Ok(None),
            Clock::FirstColumn => (seen.time.unwrap_or_else(first), None),
            // what is no number has no unit that could be read otherwise
            Clock::Column { name, unit } => {
                let index = find(cells, name)?;
                (index, unit.clone().filter(|_| seen.time != Some(index)))
            }
        };
        let cell = &cells[index];
        if unit.is_none() && seen.time != Some(index) {
            refuse_days(cell, seen.firsts.get(index).map_or("", String::as_str))?;
        }
        let wanted = plain(&cell.name, unit);
        let unitless = |e: Error| {
            let hint = format!(
                "write it in the header as `{} [s]`; or give units in a TOML recording, which `gyrospec new recording FILE` \
                 writes",
                cell.name
            );
            if e.message().ends_with(NO_UNIT) { e.with_hint(hint) } else { e }
        };
        let column = self.column(cell, index, wanted).map_err(unitless)?;
        if column.unit.dimension() != Dimension::TIME {
            let unit = |c: &Cell| c.unit.as_deref().and_then(|u| Unit::parse(u).ok());
            let is_time = |c: &&Cell| unit(c).is_some_and(|u| u.dimension() == Dimension::TIME);
            let elsewhere = cells.iter().find(is_time).map_or_else(String::new, |c| {
                format!(", which may be `{}`: `gyrospec new recording FILE` writes it", c.name)
            });
            return Err(Error::new(
                crate::ErrorKind::Units,
                format!("`{}` in [{}] is no column of time", cell.name, column.unit),
            )
            .with_column(cell.at + 1)
            .with_hint(format!(
                "the first column is time, such as `t [s]`; or write a TOML recording that says where the time \
                 is{elsewhere} (kind = \"trials\" where rows are steady trials)"
            )));
        }
        Ok(Some(column))
    }

    /// Every column that has a unit and numbers; the others are left out, and said.
    fn every_column(&mut self, cells: &[Cell], seen: &Seen) -> Result<Vec<Column>> {
        let time = self.time.as_ref().map(|t| t.index);
        let is_time = |index: usize| time == Some(index) || seen.day == Some(index);
        refuse_twins(cells)?;
        let (mut channels, mut failed) = (Vec::new(), None);
        for (index, cell) in cells.iter().enumerate().filter(|(i, c)| !is_time(*i) && !c.whole.is_empty()) {
            let word = seen.words.iter().find(|(i, _)| *i == index).map(|(_, word)| word);
            let column = match word {
                Some(word) => Err(of_words(index, cell, word)),
                None => self.column(cell, index, plain(&cell.name, None)),
            };
            match column {
                Ok(column) => channels.push(column),
                Err(e) => {
                    self.left_out.push(LeftOut::of(&cell.whole, &e));
                    failed.get_or_insert(e);
                }
            }
        }
        match failed {
            Some(e) if channels.is_empty() => Err(e),
            _ if channels.is_empty() => Err(Error::bad_input("there is no column beside the time")),
            _ => Ok(channels),
        }
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
            (None, Ok(Some(own))) => {
                if cell.is_guessed {
                    self.notes.push(format!("`{}` is read as {} in [{own}]", cell.whole, cell.name));
                }
                own
            }
            (None, Err(e)) => return Err(e.with_column(cell.at + 1)),
            (None, Ok(None)) => {
                let likely = if index == 0 { "s" } else { "deg" };
                return Err(Error::bad_input(format!("column {} `{}` {NO_UNIT}", index + 1, cell.name))
                    .with_column(cell.at + 1)
                    .with_hint(format!(
                        "write it in the header as `{} [{likely}]` ([1] for none), or give units in a TOML recording, \
                         which `gyrospec new recording FILE` writes",
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

/// Days since the end of 1899, in a column that is named as a date and has no unit of days: from 1954 to 2119.
fn refuse_days(cell: &Cell, first: &str) -> Result<()> {
    let name = cell.name.to_lowercase();
    let days = first.replace(',', ".").parse().ok().filter(|d: &f64| (20_000.0..80_000.0).contains(d));
    let in_days = cell.unit.as_ref().is_some_and(|u| Unit::parse(u).is_ok_and(|u| u.to_si(1.0) == 86_400.0));
    let words: &[&str] =
        if cell.unit.is_some() { &["date", "datum"] } else { &["date", "datum", "time", "zeit", "stamp"] };
    if days.is_none() || in_days || !words.iter().any(|d| name.contains(d)) {
        return Ok(());
    }
    let what = format!(
        "`{}` begins with {first}: these look like the days of a spreadsheet, not like seconds",
        cell.name
    );
    let hint = format!(
        "name it `{} [d]` if they are days, or save the dates as text, such as 2025-04-03T12:00:00; where they are \
         seconds, say so in a TOML recording, time = {{ column = {:?}, unit = \"s\" }}",
        cell.name, cell.name
    );
    Err(Error::bad_input(what).with_column(cell.at + 1).with_hint(hint))
}

/// Whether words are several numbers.
fn is_list(words: &str) -> bool {
    let bare = words.trim_matches(['[', ']', '(', ')', '{', '}']);
    let mut all = bare.split([' ', ',', ';']).filter(|w| !w.is_empty()).peekable();
    all.peek().is_some() && all.all(|w| w.parse::<f64>().is_ok())
}

fn of_words(index: usize, cell: &Cell, word: &str) -> Error {
    Error::bad_input(format!("column {} `{}` holds words, such as `{word}`", index + 1, cell.name))
        .with_column(cell.at + 1)
        .with_hint(if is_list(word) {
            "give each of these numbers a column of its own"
        } else {
            "channels need numbers below their names"
        })
}

fn plain(name: &str, unit: Option<Unit>) -> Wanted {
    let (name, column) = (name.to_owned(), name.to_owned());
    Wanted { name, column, unit, wraps: false, hold: Hold::Linear }
}

/// First bytes of what is no table of text, what it is, and what to do.
const NO_TEXT: [(&[u8], &str, &str); 8] = [
    (&[0xFF, 0xFE, 0, 0], "the file begins with a byte-order mark of UTF-32", FROM_UTF_32),
    (&[0, 0, 0xFE, 0xFF], "the file begins with a byte-order mark of UTF-32", FROM_UTF_32),
    (&[0xFF, 0xFE], "the file begins with a byte-order mark of UTF-16", UTF_8),
    (&[0xFE, 0xFF], "the file begins with a byte-order mark of UTF-16", UTF_8),
    (&[0x1F, 0x8B], "the file is packed by gzip twice", "unpack it once, with `gzip -d`"),
    (b"BZh", "the file is packed by bzip2", "unpack it, or pack it by gzip"),
    (&[0xFD, b'7', b'z', b'X', b'Z'], "the file is packed by xz", "unpack it, or pack it by gzip"),
    (&[0x28, 0xB5, 0x2F, 0xFD], "the file is packed by zstd", "unpack it, or pack it by gzip"),
];
const UTF_8: &str = "save it as UTF-8, for instance with `iconv -f UTF-16 -t UTF-8`";
const FROM_UTF_32: &str = "save it as UTF-8, for instance with `iconv -f UTF-32 -t UTF-8`";

/// Whether bytes are no text at all.
pub(super) fn is_no_text(start: &[u8]) -> bool {
    NO_TEXT.iter().any(|(mark, ..)| start.starts_with(mark)) || start.contains(&0)
}

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
    Err(Error::bad_input(format!("no row of as many numbers follows these columns, which {name} separate"))
        .with_column(at + 1)
        .with_hint("every row needs the same separators as the header; words stand in columns of their own"))
}

/// Refuses two columns of the same name; clocks that stand side by side may have one.
pub(super) fn refuse_twins(cells: &[Cell]) -> Result<()> {
    let is_time = |c: &Cell| {
        c.unit.as_ref().is_some_and(|u| Unit::parse(u).is_ok_and(|u| u.dimension() == Dimension::TIME))
    };
    for (index, cell) in cells.iter().enumerate() {
        let twin = |c: &Cell| c.name == cell.name && !(is_time(c) && is_time(cell));
        if let Some(first) = cells[..index].iter().position(twin) {
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

/// Two columns of one name.
pub(super) fn twins(name: &str) -> Error {
    Error::bad_input(format!("two columns are named `{name}`")).with_hint("rename one of them in the header")
}

/// The cells of a header line, which is text between commas.
pub(super) fn cells(line: &[u8]) -> Result<Vec<Cell>> {
    refuse_what_is_no_text(line)?;
    refuse_other_separators(line)?;
    let fields = field::split(line, b',')
        .ok_or_else(|| Error::bad_input("a double quote in the header is not closed").with_column(1))?;
    if fields.iter().all(|f| !f.text.is_empty() && field::number(&f.text).is_some_and(|v| !v.is_nan())) {
        return Err(Error::bad_input("the first line holds numbers; a header with names is missing")
            .with_column(1)
            .with_hint("put a line such as `t [s],roll [deg]` before the first row"));
    }
    let mut cells: Vec<Cell> = fields.iter().map(cell).collect::<Result<_>>()?;
    tell_apart(&mut cells);
    Ok(cells)
}

fn cell(field: &Field) -> Result<Cell> {
    let text = std::str::from_utf8(&field.text)
        .map_err(|_| Error::bad_input("the header is no UTF-8 text").with_column(field.at + 1))?;
    Ok(Cell::of(field.at, text))
}

impl Cell {
    /// A label as it stands.
    pub(super) fn of(at: usize, text: &str) -> Self {
        let label = label(text);
        Self {
            at,
            name: label.name,
            unit: label.unit,
            whole: text.trim().to_owned(),
            is_guessed: label.is_guessed,
        }
    }
}

/// Where taking the unit off leaves two columns with one name, guessed units stay with their names; a letter that others
/// of the same name have too is no unit (`vel_N`, `vel_E`).
pub(super) fn tell_apart(cells: &mut [Cell]) {
    let letter = |cell: &Cell, stem: &str| {
        let rest = cell.whole.strip_prefix(stem).and_then(|r| r.strip_prefix('_'));
        rest.is_some_and(|r| r.chars().count() == 1)
    };
    let is_index = |c: &Cell| {
        c.is_guessed && letter(c, &c.name) && cells.iter().any(|o| o.unit.is_none() && letter(o, &c.name))
    };
    let indices: Vec<bool> = cells.iter().map(is_index).collect();
    for (cell, _) in cells.iter_mut().zip(indices).filter(|(_, is_index)| *is_index) {
        cell.name.clone_from(&cell.whole);
        (cell.unit, cell.is_guessed) = (None, false);
    }
    let names: Vec<String> = cells.iter().map(|c| c.name.clone()).collect();
    for cell in cells.iter_mut().filter(|c| c.is_guessed) {
        if names.iter().filter(|n| **n == cell.name).count() > 1 {
            cell.name.clone_from(&cell.whole);
        }
    }
}

/// The column of a name, with or without its unit.
fn find(cells: &[Cell], name: &str) -> Result<usize> {
    let same =
        |c: &Cell| c.name == name || c.unit.as_ref().is_some_and(|u| name == format!("{} [{u}]", c.name));
    let whole = cells.iter().filter(|c| c.whole == name).count() == 1;
    let same = |c: &Cell| if whole { c.whole == name } else { same(c) };
    let mut places = cells.iter().enumerate().filter(|(_, c)| same(c)).map(|(i, _)| i);
    match (places.next(), places.next()) {
        (Some(index), None) => Ok(index),
        (Some(a), Some(b)) => {
            Err(Error::bad_input(format!("columns {} and {} are both named `{name}`", a + 1, b + 1))
                .with_column(cells[b].at + 1)
                .with_hint("rename one of them in the header"))
        }
        (None, _) => {
            let names = || cells.iter().map(|c| c.whole.as_str());
            let meant = nearest(name, names()).map(|n| format!("did you mean `{n}`? "));
            let all = names().collect::<Vec<_>>().join(", ");
            Err(Error::bad_input(format!("the file has no column `{name}`"))
                .with_column(1)
                .with_hint(format!("{}its columns are {all}", meant.unwrap_or_default())))
        }
    }
}
