//! Dates, clocks and seconds since 1970 turned into seconds since the first row.

use super::field::Field;
use super::stamp::{Day, Stamp, nanoseconds, stamp};
use crate::record::nmea;
use crate::record::request::Zero;
use crate::{Error, Result};

const NANO: i128 = 1_000_000_000;
const DAY: i128 = 86_400 * NANO;
/// Steps up to so many times the usual one are no change of the month.
const GAP: i128 = 1000;

/// Where the time of a table stands, if it is no number in a unit of time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Clock {
    /// The column of the clock, of both, or of the count.
    pub column: usize,
    /// The column of the day, if it is one of its own.
    pub day: Option<usize>,
    /// Nanoseconds of one count since 1970, where it is a count.
    pub count: Option<i128>,
    /// Whether the day comes before the month, where the rows that were looked at tell.
    pub day_first: Option<bool>,
}

/// A clock as it is read row by row.
pub(super) struct Reading {
    clock: Clock,
    zero: Option<Zero>,
    /// Whether the zero is another table's.
    is_shared: bool,
    /// The first day, while it is not known which of its numbers is the month.
    open: Option<Day>,
    last: Option<i128>,
    step: Option<i128>,
    midnights: i128,
}

impl Reading {
    pub(super) fn new(clock: Clock, zero: Option<Zero>) -> Self {
        let is_shared = zero.is_some();
        Self { clock, zero, is_shared, open: None, last: None, step: None, midnights: 0 }
    }

    /// The zero, once a row was read, and whether day and month are told apart by the rows.
    pub(super) fn zero(&self) -> Option<&Zero> {
        self.zero.as_ref()
    }

    /// Seconds since the zero as a decimal; none where the field is empty.
    ///
    /// # Errors
    /// What is no time, with its column.
    pub(super) fn seconds(&mut self, fields: &[Field]) -> Result<Option<String>> {
        let Some(field) = fields.get(self.clock.column) else { return Ok(None) };
        let text = String::from_utf8_lossy(field.text.trim_ascii()).into_owned();
        let day = self.clock.day.and_then(|d| fields.get(d));
        let day = day.map(|d| String::from_utf8_lossy(d.text.trim_ascii()).into_owned());
        if text.is_empty() || day.as_ref().is_some_and(String::is_empty) {
            return Ok(None);
        }
        let whole = || day.iter().map(String::as_str).chain([text.as_str()]).collect::<Vec<_>>().join(" ");
        let read = match self.clock.count {
            Some(count) => {
                counted(&text, count).map(|n| (n, true)).ok_or_else(|| "it is no count since 1970".into())
            }
            None => self.read(&text, day.as_deref()),
        };
        let (nano, is_dated) = read.map_err(|why| {
            Error::bad_input(format!("`{}` is no time here: {why}", whole()))
                .with_column(field.at + 1)
                .with_hint("write the time as seconds in a unit of time, or as 2025-04-03T12:00:00Z")
        })?;
        self.step = self.last.map(|last| nano - last).filter(|step| *step > 0).or(self.step);
        self.last = Some(nano);
        let zero = self.zero.get_or_insert_with(|| Zero { nano, is_dated, text: whole() });
        if zero.is_dated != is_dated {
            return Err(Error::bad_input(format!(
                "the times of this table and those that count from `{}` have no zero in common",
                zero.text
            ))
            .with_column(field.at + 1)
            .with_hint("write the times of all tables with their date, or of none"));
        }
        Ok(Some(decimal(nano - zero.nano)))
    }

    /// Nanoseconds of a date, a clock, or both, and whether there is a date.
    fn read(&mut self, text: &str, day: Option<&str>) -> Result<(i128, bool), String> {
        let Stamp { day: own, clock, zone } = stamp(text).ok_or("write it as 2025-04-03T12:00:00")?;
        let other = day.map(|d| stamp(d).and_then(|s| s.day).ok_or("the day cannot be read")).transpose()?;
        let clock = clock.unwrap_or_else(|| "00:00:00".into());
        match other.or(own) {
            Some(day) => Ok((self.dated(&day, &clock, &zone)?, true)),
            None => Ok((self.of_day(&clock, &zone)?, false)),
        }
    }

    /// A clock alone, which passes midnight where it falls by half a day or more.
    fn of_day(&mut self, clock: &str, zone: &str) -> Result<i128, String> {
        let zero = nanoseconds("2001-01-01", "00:00:00", "")?;
        let mut nano = nanoseconds("2001-01-01", clock, zone)? - zero + self.midnights * DAY;
        if self.last.is_some_and(|last| last - nano >= DAY / 2) {
            self.midnights += 1;
            nano += DAY;
        }
        Ok(nano)
    }

    /// A day and a clock. Where day and month cannot be told apart, any order does as long as the day stays; where
    /// it changes, the order is that which goes on as before.
    fn dated(&mut self, day: &Day, clock: &str, zone: &str) -> Result<i128, String> {
        let at = |day: &Day, first: bool| nanoseconds(&day.iso(first), clock, zone);
        if let Some(first) = self.clock.day_first {
            return at(day, first);
        }
        if !matches!(day, Day::Either(..)) {
            return at(day, true);
        }
        let Some(open) = self.open.clone() else {
            self.open = Some(day.clone());
            return at(day, true);
        };
        if open == *day {
            return at(day, true);
        }
        let shift = |first: bool| -> Result<i128, String> {
            Ok(nanoseconds(&open.iso(first), "00:00:00", "")? - nanoseconds(&open.iso(true), "00:00:00", "")?)
        };
        let goes_on = |first: bool| {
            let (Ok(now), Ok(shift), Some(last), Some(step)) =
                (at(day, first), shift(first), self.last, self.step)
            else {
                return false;
            };
            (1..=GAP * step).contains(&(now - last - shift))
        };
        let order = match (day.order(), goes_on(true), goes_on(false)) {
            (Some(order), ..) => order,
            (None, true, false) => true,
            (None, false, true) => false,
            _ => return Err("which of its numbers is the month, the rows do not tell".into()),
        };
        let moved = shift(order)?;
        self.clock.day_first = Some(order);
        self.last = self.last.map(|last| last + moved);
        if let Some(zero) = self.zero.as_mut().filter(|_| !self.is_shared) {
            zero.nano += moved;
        }
        at(day, order)
    }
}

/// Nanoseconds since 1970, leap seconds included, of a decimal count of so many nanoseconds.
fn counted(text: &str, count: i128) -> Option<i128> {
    let (whole, fraction) = text.split_once(['.', ',']).unwrap_or((text, ""));
    let digits = |s: &str| s.len() <= 20 && s.bytes().all(|b| b.is_ascii_digit());
    if whole.is_empty() || !digits(whole) || !digits(fraction) {
        return None;
    }
    let part = format!("{fraction:0<9}")[..9].parse::<i128>().ok()?;
    nmea::stamp(&decimal(whole.parse::<i128>().ok()? * count + part * count / NANO))
}

/// Nanoseconds as a decimal of seconds.
fn decimal(nano: i128) -> String {
    let sign = if nano < 0 { "-" } else { "" };
    let size = nano.unsigned_abs();
    let (whole, rest) = (size / NANO.unsigned_abs(), size % NANO.unsigned_abs());
    if rest == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{rest:09}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(rows: &[&str], clock: Clock) -> Result<Vec<String>> {
        let mut reading = Reading::new(clock, None);
        let field = |text: &str| vec![Field { at: 0, text: text.as_bytes().to_vec() }];
        rows.iter().map(|r| reading.seconds(&field(r)).map(Option::unwrap_or_default)).collect()
    }

    fn of(day_first: Option<bool>, count: Option<i128>) -> Clock {
        Clock { column: 0, day: None, count, day_first }
    }

    #[test]
    fn rows_tell_day_from_month_or_are_refused() {
        let night = ["3/4/2025 23:59:58", "3/4/2025 23:59:59", "4/4/2025 0:00:00"];
        assert_eq!(read(&night, of(None, None)).unwrap(), ["0", "1", "2"]);
        let american = ["3/4/2025 23:59:58", "3/4/2025 23:59:59", "3/5/2025 0:00:00"];
        assert_eq!(read(&american, of(None, None)).unwrap(), ["0", "1", "2"]);
        // from 12 to 13 December: the shift of the first rows from 3 days to 9 months must not be lost
        let late = ["12/11/2025 12:00:00", "12/11/2025 12:00:01", "12/13/2025 12:00:01"];
        assert_eq!(read(&late, of(None, None)).unwrap(), ["0", "1", "172801"]);
        let daily = ["3/4/2025 12:00:00", "4/4/2025 12:00:00"];
        let error = read(&daily, of(None, None)).unwrap_err().to_string();
        assert!(error.contains("which of its numbers is the month"), "{error}");
        assert_eq!(read(&daily, of(Some(true), None)).unwrap(), ["0", "86400"]);
    }

    #[test]
    fn clocks_pass_midnight_and_leap_seconds_count() {
        let rows = ["23:59:59.5", "0:00:00", "12:00:00", "0:00:00"];
        assert_eq!(
            read(&rows, of(None, None)).unwrap(),
            ["0", "0.500000000", "43200.500000000", "86400.500000000"]
        );
        let leap = ["2016-12-31T23:59:59Z", "2016-12-31T23:59:60Z", "2017-01-01T00:00:00Z"];
        assert_eq!(read(&leap, of(None, None)).unwrap(), ["0", "1", "2"]);
    }

    #[test]
    fn counts_keep_their_last_digits() {
        let rows = ["1700000000123456789", "1700000000123456790"];
        assert_eq!(read(&rows, of(None, Some(1))).unwrap(), ["0", "0.000000001"]);
        let rows = ["1700000000.5", "1700000001,25"];
        assert_eq!(read(&rows, of(None, Some(NANO))).unwrap(), ["0", "0.750000000"]);
    }

    #[test]
    fn what_is_no_time_is_refused_with_its_reason() {
        for (row, why) in
            [("2025-02-30 12:00:00", "28 days"), ("calm", "write it as"), ("25:00:00", "hour 25")]
        {
            let error = read(&[row], of(None, None)).unwrap_err().to_string();
            assert!(error.contains(why), "{error}");
        }
    }
}
