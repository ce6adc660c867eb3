//! How a table of text is written: what separates its columns, which sign is decimal, where its header stands, and
//! where its time is. It is told from the first 64 KiB, once, before anything is read.
//!
//! Method: each separator cuts the first lines; the one that makes the most numbers and the fewest texts, in rows of
//! equally many fields, is taken. Commas before semicolons where they tie.

use super::clock::Clock;
use super::figures::{self, Form, ONE_WAY};
use super::header::{Seen, is_no_text};
use super::sample::{Kind, Line, Names, in_comment, is_comment, kinds, names, short, width};
use super::stamp::{ORDERS, Order, Stamp, stamp};
use crate::record::nmea;
use crate::units::{Dimension, Unit};
use crate::{Error, Result};

/// What may separate columns; a blank stands for any number of them.
const SEPARATORS: [u8; 5] = [b',', b';', b'\t', b'|', b' '];
/// Lines that are looked at.
const LINES: usize = 400;
/// Words in names of columns that count since 1970.
const COUNTS: [&str; 5] = ["time", "stamp", "epoch", "unix", "utc"];

/// How a table is written.
#[derive(Debug, Clone)]
pub(super) struct Dialect {
    /// Between columns.
    pub separator: u8,
    /// Whether commas are decimal; none where no number that was looked at tells.
    pub comma: Option<bool>,
    /// Whether a number has signs between thousands for sure, or the recording says which sign is decimal.
    pub is_grouped: bool,
    /// What else is to be said of how it is read.
    remarks: Vec<&'static str>,
    /// Line of the header, from 1.
    pub header: usize,
    /// Its labels.
    pub labels: Vec<(usize, String)>,
    /// Units that stand in a row of their own, or nothing.
    pub units: Vec<String>,
    /// First line of the rows, from 1.
    pub body: usize,
    /// The time, where it is no number in a unit of time.
    pub clock: Option<Clock>,
    /// Columns that hold words, with one of them.
    pub words: Vec<(usize, String)>,
    /// The first field of each column.
    firsts: Vec<String>,
    /// Whether its lines are read as they stand.
    pub is_plain: bool,
}

impl Dialect {
    /// What the header should know of the rows.
    pub(super) fn seen(&self) -> Seen {
        let (time, day) = self.clock.as_ref().map_or((None, None), |c| (Some(c.column), c.day));
        Seen { time, day, words: self.words.clone(), firsts: self.firsts.clone() }
    }

    /// What is to be said of how the table is read.
    pub(super) fn notes(&self) -> Vec<(Option<usize>, String)> {
        let between = match self.separator {
            b';' => Some("semicolons"),
            b'\t' => Some("tabs"),
            b'|' => Some("bars"),
            b' ' => Some("blanks"),
            _ => None,
        };
        let mut says: Vec<String> = between.map(|b| format!("{b} between columns")).into_iter().collect();
        says.extend((self.comma == Some(true)).then(|| "commas for decimals".to_owned()));
        says.extend((self.header > 1).then(|| format!("the header in line {}", self.header)));
        says.extend((!self.units.is_empty()).then(|| "units in a row of their own".to_owned()));
        says.extend(self.remarks.iter().map(|r| (*r).to_owned()));
        let note = (Some(self.header), format!("read with {}", says.join(", ")));
        if says.is_empty() { Vec::new() } else { vec![note] }
    }
}

/// The column of time as a recording names it, and its unit there.
pub(super) type Named<'a> = (&'a str, Option<&'a Unit>);

/// How a table is written; none where nothing in it looks like rows below a header, which is read as it stands and
/// refused with its reason. `time` is the column of time, if the recording names it, and `comma` whether it says that
/// commas are decimal, or points.
///
/// # Errors
/// Numbers that can be read in two ways.
pub(super) fn of(
    (start, is_whole): (&[u8], bool),
    time: Option<Named<'_>>,
    comma: Option<bool>,
) -> Result<Option<Dialect>> {
    if is_no_text(start) {
        return Ok(None);
    }
    let text = String::from_utf8_lossy(start);
    let mut lines: Vec<(usize, &str)> = text
        .split('\n')
        .map(|l| l.strip_suffix('\r').unwrap_or(l))
        .enumerate()
        .map(|(i, l)| (i + 1, l))
        .collect();
    if !is_whole || lines.last().is_some_and(|l| l.1.is_empty()) {
        lines.pop();
    }
    lines.truncate(LINES);
    let mut best: Option<(i64, Layout)> = None;
    for separator in SEPARATORS {
        let Some(layout) = Layout::of(&lines, separator) else { continue };
        let score = layout.score();
        if best.as_ref().is_none_or(|(most, _)| score > *most) {
            best = Some((score, layout));
        }
    }
    best.map(|(_, layout)| layout.dialect(&lines, time, comma)).transpose()
}

/// The lines as one separator cuts them.
struct Layout {
    separator: u8,
    width: usize,
    header: Line,
    units: Vec<String>,
    /// First line below names and units.
    body: usize,
    rows: Vec<Line>,
    /// Whether a line was made shorter by an empty field at its end, or stood between header and rows.
    is_mended: bool,
    /// Whether the rows were, and the header not.
    is_trailed: bool,
}

impl Layout {
    fn of(lines: &[(usize, &str)], separator: u8) -> Option<Self> {
        let plain = lines.iter().filter(|l| !l.1.trim().is_empty() && !is_comment(l.1.as_bytes()));
        let mut all: Vec<Line> = plain.map(|(number, line)| Line::of(*number, line, separator)).collect();
        let width = width(&all)?;
        let longer = all.iter().any(|l| !l.fields.is_empty() && l.fields.len() != width);
        for line in &mut all {
            while line.fields.len() > width && line.fields.last().is_some_and(|f| f.1.is_empty()) {
                line.fields.pop();
                line.is_cut = true;
            }
        }
        let kinds = kinds(&all, width);
        let is_row = |l: &Line| {
            l.fields.len() == width
                && l.forms().any(Kind::is_datum)
                && l.forms().zip(&kinds).all(|(k, usual)| !usual.is_datum() || k != Kind::Words)
        };
        let mut first = all.iter().position(is_row)?;
        let is_gap = |l: &Line| l.fields.len() == width && l.forms().all(|k| k == Kind::Missing);
        while first > 1 && is_gap(&all[first - 1]) {
            first -= 1;
        }
        let rows = all.split_off(first);
        let (header, units, above) = if let Some(Names { at, units, last }) = names(&all, width) {
            (all.swap_remove(at), units, last)
        } else if let Some(header) = short(&mut all, &rows, lines, width) {
            let number = header.number;
            (header, Vec::new(), number)
        } else {
            in_comment(lines, rows[0].number, separator, width)?
        };
        let body = above + 1;
        // one column whose label holds what separates columns elsewhere is no table
        let is_torn = width == 1 && header.fields.iter().any(|f| f.1.contains([',', ';', '\t', '|']));
        let is_trailed = !header.is_cut && rows.iter().any(|l| l.is_cut);
        (!is_torn).then_some(Self {
            separator,
            width,
            header,
            units,
            body,
            rows,
            is_mended: longer,
            is_trailed,
        })
    }

    /// Numbers and times less twice the words.
    fn score(&self) -> i64 {
        let of = |k: Kind| match k {
            Kind::Number(_) | Kind::Time => 1,
            Kind::Missing => 0,
            Kind::Words => -2,
        };
        let wrong = self.rows.iter().filter(|l| l.fields.len() != self.width).count() as i64;
        self.rows.iter().filter(|l| l.fields.len() == self.width).flat_map(Line::forms).map(of).sum::<i64>()
            - 2 * wrong
    }

    fn dialect(
        self,
        lines: &[(usize, &str)],
        time: Option<Named<'_>>,
        stated: Option<bool>,
    ) -> Result<Dialect> {
        let comma = stated.map_or_else(|| self.decimal(), |comma| Ok(Some(comma)))?;
        let is_settled = self.shows_thousands();
        let is_grouped = is_settled || self.find(&[Form::GroupedByPoints, Form::GroupedByCommas]).is_some();
        let clock = self.clock(time);
        let words = self.words(clock.as_ref());
        let body = self.body;
        let has_comments = lines.iter().any(|l| is_comment(l.1.as_bytes()));
        let is_plain = self.separator == b','
            && comma == Some(false)
            && clock.is_none()
            && self.units.is_empty()
            && !self.is_mended
            && !is_settled
            && !has_comments
            && (self.header.number, body) == (1, 2);
        Ok(Dialect {
            separator: self.separator,
            comma,
            is_grouped: is_grouped || stated.is_some(),
            remarks: self.remarks(comma, is_grouped),
            firsts: self.rows.iter().take(1).flat_map(|l| &l.fields).map(|f| f.1.clone()).collect(),
            header: self.header.number,
            labels: self.header.fields,
            units: self.units,
            body,
            clock,
            words,
            is_plain,
        })
    }

    fn remarks(&self, comma: Option<bool>, is_grouped: bool) -> Vec<&'static str> {
        let between =
            if comma == Some(true) { "points between thousands" } else { "commas between thousands" };
        let trailed = self.is_trailed.then_some("nothing behind the last separator of its rows");
        is_grouped.then_some(between).into_iter().chain(trailed).collect()
    }

    /// The first number of one of these forms, with its line.
    fn find(&self, wanted: &[Form]) -> Option<(usize, &(usize, String))> {
        let mut fields = self.rows.iter().flat_map(|l| l.fields.iter().map(move |f| (l.number, f)));
        fields.find(|(_, (_, text))| wanted.contains(&figures::form(text)))
    }

    /// The first numbers that have a decimal comma, and a decimal point, for sure.
    fn sure(&self) -> [Option<(usize, &(usize, String))>; 2] {
        [&[Form::Comma, Form::GroupedByPoints], &[Form::Point, Form::GroupedByCommas]]
            .map(|forms| self.find(forms))
    }

    /// Whether commas are decimal, if any number tells.
    fn decimal(&self) -> Result<Option<bool>> {
        let [commas, points] = self.sure();
        if self.separator == b',' {
            // a comma cannot be both; the rows say so of the number
            return Ok(Some(false));
        }
        if let (Some(comma), Some(point)) = (commas, points) {
            let (first, second) = if comma.0 <= point.0 { (comma, point) } else { (point, comma) };
            let what = format!("and `{}` in line {} cannot have the same decimal sign", first.1.1, first.0);
            let (line, (at, text)) = second;
            let error = Error::bad_input(format!("`{text}` {what}")).with_line(line).with_column(at + 1);
            return Err(error.with_hint(ONE_WAY));
        }
        // one sign with three digits behind it may stand between thousands: the rows ask
        Ok((commas.is_some() || points.is_some()).then_some(commas.is_some()))
    }

    /// Whether a sign with three digits behind it stands between thousands for sure: another sign is decimal, and in one
    /// column `1.050` stands beside `950`. As decimals both would end in zeros there, or neither.
    fn shows_thousands(&self) -> bool {
        let between = match self.sure() {
            [Some(_), None] => Form::EitherPoint,
            [None, Some(_)] => Form::EitherComma,
            _ => return false,
        };
        let texts =
            |c: usize| self.rows.iter().filter_map(move |l| Some(l.fields.get(c)?.1.trim_start_matches('-')));
        let small = |t: &str| figures::form(t) == Form::Whole && (2..=3).contains(&t.len());
        let large = |t: &str| figures::form(t) == between && t.ends_with('0');
        (0..self.width).any(|c| texts(c).any(small) && texts(c).any(large))
    }

    /// The time, where it is no number in a unit of time: the column that is named, or the first with times.
    fn clock(&self, named: Option<Named<'_>>) -> Option<Clock> {
        let usual = kinds(&self.rows, self.width);
        let text = |c: usize| self.rows.iter().filter_map(move |l| l.fields.get(c).map(|f| f.1.as_str()));
        let stamps = |c: usize| -> Vec<Stamp> { text(c).filter_map(stamp).collect() };
        let days = |c: &usize| usual[*c] == Kind::Time && stamps(*c).iter().all(|s| s.clock.is_none());
        let clocks = |c: &usize| usual[*c] == Kind::Time && stamps(*c).iter().any(|s| s.clock.is_some());
        let asked = |c: &usize| named.is_none_or(|(n, _)| self.is_named(*c, n));
        let orders = |c: usize| -> Vec<Order> {
            // a row that contradicts those above it is refused where it is read
            stamps(c).iter().filter_map(|s| s.day.as_ref()).fold(ORDERS.to_vec(), |orders, day| {
                let left: Vec<Order> = orders.iter().copied().filter(|o| day.may_be(*o)).collect();
                if left.is_empty() { orders } else { left }
            })
        };
        let of = |column: usize, day: Option<usize>| Clock {
            column,
            day,
            count: None,
            orders: orders(day.unwrap_or(column)),
            has_hours: self.has_hours(column),
        };
        let mut found = (0..self.width).filter(|c| clocks(c) && asked(c)).peekable();
        if let Some(first) = found.peek().copied() {
            // a table of several times has one of that name
            let is_time = |c: &usize| self.header.fields[*c].1.trim_matches('_').eq_ignore_ascii_case("time");
            let column = found.find(is_time).unwrap_or(first);
            let is_dated = stamps(column).iter().any(|s| s.day.is_some());
            return Some(of(column, (0..self.width).find(days).filter(|_| !is_dated)));
        }
        if let Some(column) = (0..self.width).find(|c| days(c) && asked(c)) {
            return Some(of(column, None));
        }
        let counts = |c: usize| text(c).find_map(since_1970);
        let column =
            (0..self.width).find(|c| asked(c) && self.is_counted(*c, counts(*c), named.and_then(|n| n.1)))?;
        Some(Clock { count: counts(column), ..of(column, None) })
    }

    /// Whether a clock of two numbers has hours, if its label says so.
    fn has_hours(&self, column: usize) -> Option<bool> {
        let label = self.header.fields[column].1.to_lowercase();
        let says = |words: [&str; 3]| words.iter().any(|w| label.contains(w));
        if says(["hh:mm", "h:mm", "h:min"]) {
            return Some(true);
        }
        says(["mm:ss", "min:s", "m:ss"]).then_some(false)
    }

    fn is_named(&self, column: usize, name: &str) -> bool {
        let label = &self.header.fields[column].1;
        label == name || crate::record::label::label(label).name == name
    }

    /// Whether a column counts since 1970: all its numbers do, its name says so, and its unit, if it has one, is that
    /// of the count.
    fn is_counted(&self, column: usize, count: Option<i128>, given: Option<&Unit>) -> bool {
        let whole = &self.header.fields[column].1;
        let own = self.units.get(column).filter(|u| !u.is_empty()).cloned();
        let unit = own.or(crate::record::label::label(whole).unit).map(|u| Unit::parse(&u).ok());
        let unit = given.cloned().map(Some).or(unit);
        let fits = |unit: &Option<Unit>| {
            let time = unit.as_ref().filter(|u| u.dimension() == Dimension::TIME);
            let nanoseconds = time.map(|u| u.to_si(1e9));
            nanoseconds.zip(count).is_some_and(|(n, c)| (n - c as f64).abs() < 1e-6 * n)
        };
        let label = whole.to_lowercase();
        let named = COUNTS.iter().any(|c| label.contains(c));
        let mut texts = self.rows.iter().filter_map(|l| l.fields.get(column));
        unit.as_ref().is_none_or(fits) && named && texts.all(|f| since_1970(&f.1).is_some())
    }

    /// Columns that hold words, with one of them.
    fn words(&self, clock: Option<&Clock>) -> Vec<(usize, String)> {
        let usual = kinds(&self.rows, self.width);
        let is_time = |c: usize| clock.is_some_and(|k| k.column == c || k.day == Some(c));
        let of = |c: usize| {
            let mut texts = self.rows.iter().filter_map(|l| l.fields.get(c));
            Some((c, texts.find(|f| matches!(Kind::of(&f.1), Kind::Words | Kind::Time))?.1.clone()))
        };
        let texts = |c: usize| self.rows.iter().filter_map(move |l| l.fields.get(c));
        let has_numbers = |c: usize| texts(c).any(|f| matches!(Kind::of(&f.1), Kind::Number(_)));
        let is_worded =
            |c: &usize| matches!(usual[*c], Kind::Words | Kind::Time) && !is_time(*c) && !has_numbers(*c);
        (0..self.width).filter(is_worded).filter_map(of).collect()
    }
}

/// The nanoseconds of one count, where a number can be one since 1970 between 2001 and 2096.
fn since_1970(text: &str) -> Option<i128> {
    let whole = text.split(['.', ',']).next()?;
    let is_count = text.bytes().all(|b| b.is_ascii_digit() || b == b'.' || b == b',');
    if !is_count || !matches!(whole.as_bytes().first(), Some(b'1'..=b'3')) {
        return None;
    }
    nmea::nano_of_count(whole.len())
}
