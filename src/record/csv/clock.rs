//! Dates, clocks and seconds since 1970 turned into seconds since the first row.

use super::field::Field;
use super::stamp::{Day, Order, Stamp, nanoseconds, stamp};
use crate::record::nmea;
use crate::record::zero::Zero;
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
    /// Orders in which the numbers of its days may stand, by the rows that were looked at.
    pub orders: Vec<Order>,
    /// Whether a clock of two numbers has hours and minutes, or minutes and seconds, if its label says so.
    pub has_hours: Option<bool>,
}

/// A clock as it is read row by row.
pub(super) struct Reading {
    clock: Clock,
    zero: Option<Zero>,
    /// Whether the zero is another table's.
    is_shared: bool,
    /// The first day whose numbers may stand in several orders, and the order in which they are read.
    open: Option<(Day, Order)>,
    /// Whether its day was taken to stand first though the rows allow the month there.
    is_taken: bool,
    last: Option<i128>,
    step: Option<i128>,
    midnights: i128,
}

impl Reading {
    pub(super) fn new(clock: Clock, zero: Option<Zero>) -> Self {
        let is_shared = zero.is_some();
        Self { clock, zero, is_shared, open: None, is_taken: false, last: None, step: None, midnights: 0 }
    }

    /// The zero, once a row was read.
    pub(super) fn zero(&self) -> Option<Zero> {
        let is_open = self.open.as_ref().is_some_and(|o| !o.0.has_points()) && self.clock.orders.len() > 1;
        self.zero.clone().map(|zero| Zero { is_open, ..zero })
    }

    /// What is to be said of days with points: that the day was taken to stand first, or that the month does.
    pub(super) fn order(&self) -> Option<String> {
        let (day, order) = self.open.as_ref().filter(|o| o.0.has_points())?;
        let undecided = self.is_taken || self.clock.orders.len() > 1;
        let such = format!("such as {}", day.iso(*order));
        match order {
            Order::DayMonthYear if undecided => {
                Some(format!("days are read as day.month.year, {such}; no row tells day from month"))
            }
            Order::DayMonthYear => None,
            _ => Some(format!("days are read as month.day.year, {such}, as the rows tell")),
        }
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
        let at = |e: Error| e.with_column(field.at + 1);
        let read = match self.clock.count {
            Some(count) => {
                counted(&text, count).map(|nano| Moment { nano, is_dated: true, zoned: Some(true) })
            }
            None => Some(self.read(&text, day.as_deref()).map_err(|why| {
                at(Error::bad_input(format!("`{}` is no time here: {why}", whole())).with_hint(FORMS))
            })?),
        };
        let moment = read.ok_or_else(|| {
            at(Error::bad_input(format!("`{text}` is no count since 1970")).with_hint(FORMS))
        })?;
        let nano = moment.nano;
        self.step = self.last.map(|last| nano - last).filter(|step| *step > 0).or(self.step);
        self.last = Some(nano);
        let unit = self.clock.count.map(|c| format!(" {} since 1970", unit_of(c))).unwrap_or_default();
        let Moment { is_dated, zoned, .. } = moment;
        let text = || format!("{}{unit}", whole());
        let zero =
            self.zero.get_or_insert_with(|| Zero { nano, is_dated, zoned, text: text(), is_open: false });
        let unlike = zero.is_unlike(is_dated, zoned);
        if unlike || self.is_shared && zero.is_open {
            let what = "the times here and those that count from";
            return Err(at(Error::bad_input(format!("{what} `{}` have no zero in common", zero.text))
                .with_hint(
                    "write all times with their date and zone as 2025-04-03T12:00:00Z, or all without",
                )));
        }
        Ok(Some(decimal(nano - zero.nano)))
    }

    /// The moment of a date, a clock, or both, or of a time that went by.
    fn read(&mut self, text: &str, day: Option<&str>) -> Result<Moment, String> {
        if let Some(nano) = duration(text) {
            return Ok(Moment { nano, is_dated: false, zoned: None });
        }
        let Stamp { day: own, clock, zone, is_short } =
            stamp(text).ok_or("write it as 2025-04-03T12:00:00")?;
        let other = day.map(|d| stamp(d).and_then(|s| s.day).ok_or("the day cannot be read")).transpose()?;
        let clock = clock.unwrap_or_else(|| "00:00:00".into());
        let zoned = Some(!zone.is_empty());
        let (nano, is_dated) = match other.or(own) {
            Some(day) => (self.dated(&day, &clock, &zone)?, true),
            None => (self.of_day(&clock, is_short)?, false),
        };
        Ok(Moment { nano, is_dated, zoned })
    }

    /// A clock alone, which passes midnight where it falls by half a day or more; one of two numbers has hours or
    /// seconds as its label says.
    fn of_day(&mut self, clock: &str, is_short: bool) -> Result<i128, String> {
        let mut parts =
            clock.split([':', '.']).map(|p| p.parse::<i128>().map_err(|_| "it is no clock".to_owned()));
        let mut next = || parts.next().unwrap_or(Ok(0));
        let (hour, minute, second) = (next()?, next()?, next()?);
        if minute > 59 || second > 60 {
            return Err("an hour has 60 minutes, and a minute 60 seconds".into());
        }
        let fraction = clock.split_once('.').map_or("", |f| f.1);
        let part = format!("{fraction:0<9}")[..9].parse::<i128>().map_err(|_| "it is no clock".to_owned())?;
        let minutes = match (is_short, self.clock.has_hours) {
            (true, None) => {
                return Err(
                    "hours and minutes, or minutes and seconds? End its label with (hh:mm) or (mm:ss)".into(),
                );
            }
            (true, Some(false)) => return Ok((60 * hour + minute) * NANO),
            _ => 60 * hour + minute,
        };
        let mut nano = (60 * minutes + second) * NANO + part + self.midnights * DAY;
        if hour < 24 && self.last.is_some_and(|last| last - nano >= DAY / 2) {
            self.midnights += 1;
            nano += DAY;
        }
        Ok(nano)
    }

    /// A day and a clock. Where the order of a day's numbers is not known, any does as long as the day stays; where it
    /// changes, the order is that which goes on as before.
    fn dated(&mut self, day: &Day, clock: &str, zone: &str) -> Result<i128, String> {
        let at = |day: &Day, order: Order| nanoseconds(&day.iso(order), clock, zone);
        if !matches!(day, Day::Open(..)) {
            return at(day, Order::DayMonthYear);
        }
        self.clock.orders.retain(|o| day.may_be(*o));
        self.is_taken &= day.may_be(Order::MonthDayYear);
        let Some(first) = self.clock.orders.first().copied() else {
            return Err("day and month stand in another order than above it".into());
        };
        let Some((open, used)) = self.open.clone() else {
            if self.is_shared && self.clock.orders.len() > 1 {
                self.take_day_first(day)?;
            }
            self.open = Some((day.clone(), first));
            return at(day, first);
        };
        if open == *day && self.clock.orders.contains(&used) {
            return at(day, used);
        }
        let midnight = |order: Order| nanoseconds(&open.iso(order), "00:00:00", "");
        let shift = |order: Order| -> Result<i128, String> { Ok(midnight(order)? - midnight(used)?) };
        let goes_on = |order: &Order| {
            let (Ok(now), Ok(shift), Some(last), Some(step)) =
                (at(day, *order), shift(*order), self.last, self.step)
            else {
                return false;
            };
            (1..=GAP * step).contains(&(now - last - shift))
        };
        let mut orders = self.clock.orders.clone();
        if orders.len() > 1 {
            orders.retain(goes_on);
        }
        let order = match orders[..] {
            [order] => order,
            _ => self.take_day_first(day)?,
        };
        let moved = shift(order)?;
        self.clock.orders = vec![order];
        self.open = Some((day.clone(), order));
        self.last = self.last.map(|last| last + moved);
        if let Some(zero) = self.zero.as_mut().filter(|_| !self.is_shared) {
            zero.nano += moved;
        }
        at(day, order)
    }

    /// Settles that the day stands first, where the rows do not tell; nobody means anything else by points, mostly.
    fn take_day_first(&mut self, day: &Day) -> Result<Order, String> {
        if !day.has_points() {
            return Err(ORDER.into());
        }
        self.is_taken = true;
        self.clock.orders = vec![Order::DayMonthYear];
        Ok(Order::DayMonthYear)
    }
}

/// What the rows do not tell.
const ORDER: &str = "which of its numbers is the month, the rows do not tell";
const FORMS: &str = "write the time as seconds in a unit of time, or as 2025-04-03T12:00:00Z";

/// What a row says of the time.
struct Moment {
    /// Nanoseconds since 1970, since midnight, or since a beginning.
    nano: i128,
    is_dated: bool,
    /// Whether it has a zone, where it is one of the clock.
    zoned: Option<bool>,
}

/// A time that went by, as `0.5 sec`; nanoseconds.
pub(super) fn duration(text: &str) -> Option<i128> {
    let (number, word) = text.trim().split_once(' ')?;
    let unit = match word.trim() {
        "sec" | "s" | "seconds" => NANO,
        "min" | "minutes" => 60 * NANO,
        "hr" | "h" | "hours" => 3600 * NANO,
        "ms" => NANO / 1000,
        _ => return None,
    };
    let (sign, size) = number.strip_prefix('-').map_or((1, number), |n| (-1, n));
    let (whole, fraction) = size.split_once(['.', ',']).unwrap_or((size, ""));
    let digits = |s: &str| s.len() <= 12 && s.bytes().all(|b| b.is_ascii_digit());
    if whole.is_empty() || !digits(whole) || !digits(fraction) {
        return None;
    }
    let part = format!("{fraction:0<9}")[..9].parse::<i128>().ok()?;
    Some(sign * (whole.parse::<i128>().ok()? * unit + part * unit / NANO))
}

/// The unit of a count.
fn unit_of(count: i128) -> &'static str {
    match count {
        1 => "ns",
        1_000 => "us",
        1_000_000 => "ms",
        _ => "s",
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
    use super::super::stamp::ORDERS;
    use super::*;

    fn read(rows: &[&str], clock: Clock) -> Result<Vec<String>> {
        let mut reading = Reading::new(clock, None);
        let field = |text: &str| vec![Field { at: 0, text: text.as_bytes().to_vec() }];
        rows.iter().map(|r| reading.seconds(&field(r)).map(Option::unwrap_or_default)).collect()
    }

    fn of(order: Option<Order>, count: Option<i128>) -> Clock {
        let orders = order.map_or(ORDERS.to_vec(), |o| vec![o]);
        Clock { column: 0, day: None, count, orders, has_hours: None }
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
        assert_eq!(read(&daily, of(Some(Order::DayMonthYear), None)).unwrap(), ["0", "86400"]);
    }

    #[test]
    fn days_with_points_begin_with_the_day_unless_the_rows_say_otherwise() {
        let of_rows = |rows: &[&str]| {
            let mut reading = Reading::new(of(None, None), None);
            let field = |text: &str| vec![Field { at: 0, text: text.as_bytes().to_vec() }];
            let read: Result<Vec<String>> =
                rows.iter().map(|r| reading.seconds(&field(r)).map(Option::unwrap_or_default)).collect();
            (read, reading.order().unwrap_or_default())
        };
        let night = |last| ["03.12.2025 23:59:58", "03.12.2025 23:59:59", last];
        for (last, wanted, says) in [
            ("03.12.2025 23:59:59.5", "1.500000000", "day.month.year, such as 2025-12-03; no row"),
            ("04.12.2025 00:00:00", "2", ""),
            ("03.13.2025 00:00:00", "2", "month.day.year, such as 2025-03-13"),
            // neither goes on in steps: months and more between
            ("05.01.2027 00:00:00", "34300802", "day.month.year, such as 2027-01-05; no row"),
        ] {
            let (read, order) = of_rows(&night(last));
            assert_eq!(read.unwrap()[2], wanted, "{last}");
            assert!(order.contains(says) && order.is_empty() == says.is_empty(), "{last}: {order}");
        }
        let (read, _) = of_rows(&["22.04.2025 12:00:00", "04.22.2025 12:00:01"]);
        assert!(read.unwrap_err().to_string().contains("another order"));
    }

    #[test]
    fn a_year_of_two_digits_may_stand_first() {
        let rows = ["21/03/04 23:58:00", "21/03/04 23:59:00", "21/03/05 00:00:00"];
        assert_eq!(read(&rows, of(None, None)).unwrap(), ["0", "60", "120"]);
        let logger = ["04/03/25 11:59:59 PM", "04/03/25 11:59:59.5 PM", "04/04/25 12:00:00 AM"];
        assert_eq!(read(&logger, of(None, None)).unwrap(), ["0", "0.500000000", "1"]);
    }

    #[test]
    fn clocks_of_two_numbers_say_which() {
        let clock = |has_hours| Clock { has_hours, ..of(None, None) };
        let rows = ["00:00", "00:01", "01:00"];
        assert_eq!(read(&rows, clock(Some(true))).unwrap(), ["0", "60", "3600"]);
        assert_eq!(read(&rows, clock(Some(false))).unwrap(), ["0", "1", "60"]);
        assert!(read(&rows, clock(None)).unwrap_err().to_string().contains("(mm:ss)"));
        assert_eq!(read(&["59:58.5", "59:59.0"], clock(None)).unwrap(), ["0", "0.500000000"]);
        assert_eq!(read(&["23:59:59", "24:00:00", "25:00:00"], clock(None)).unwrap(), ["0", "1", "3601"]);
        assert_eq!(read(&["0 sec", "0.5 sec", "1 min"], clock(None)).unwrap(), ["0", "0.500000000", "60"]);
    }

    #[test]
    fn with_and_without_a_zone_is_asked() {
        let error = read(&["2025-04-03T12:00:00Z", "2025-04-03T12:00:05"], of(None, None)).unwrap_err();
        assert!(error.to_string().contains("no zero in common"), "{error}");
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
        for (row, why) in [
            ("2025-02-30 12:00:00", "28 days"),
            ("calm", "write it as"),
            ("2025-02-03 25:00:00", "hour 25"),
            ("12:61:00", "60 minutes"),
        ] {
            let error = read(&[row], of(None, None)).unwrap_err().to_string();
            assert!(error.contains(why), "{error}");
        }
    }
}
