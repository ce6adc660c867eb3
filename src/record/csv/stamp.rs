//! Dates and clocks as people write them.

use crate::record::nmea;

/// What a field says of the time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Stamp {
    /// The day, if it says one.
    pub day: Option<Day>,
    /// Hours, minutes, seconds and their fraction as `hh:mm:ss.f`, if it says them.
    pub clock: Option<String>,
    /// What must be taken off for Greenwich, as `Z` or `+hh:mm`; empty if it says nothing.
    pub zone: String,
    /// Whether the clock has two numbers, which may be hours and minutes or minutes and seconds.
    pub is_short: bool,
}

/// A day of the calendar.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Day {
    /// Year, month and day.
    Sure(u32, u32, u32),
    /// Three numbers in an order that is not known.
    Open([u32; 3], Style),
}

/// How the numbers of a day are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// The last is a year of four digits.
    Long,
    /// The same with points between: `03.04.2025` has the day first wherever no row says otherwise.
    Points,
    /// The year has two digits.
    Short,
}

/// The order of the numbers of a day.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// Day, month, year.
    DayMonthYear,
    /// Month, day, year.
    MonthDayYear,
    /// Year of two digits, month, day.
    YearMonthDay,
}

/// All orders.
pub(super) const ORDERS: [Order; 3] = [Order::DayMonthYear, Order::MonthDayYear, Order::YearMonthDay];

impl Day {
    /// As `yyyy-mm-dd`.
    pub(super) fn iso(&self, order: Order) -> String {
        let century = |year: u32| if year < 100 { 2000 + year } else { year };
        let (year, month, day) = match (self, order) {
            (Self::Sure(year, month, day), _) => (*year, *month, *day),
            (Self::Open([a, b, c], _), Order::DayMonthYear) => (century(*c), *b, *a),
            (Self::Open([a, b, c], _), Order::MonthDayYear) => (century(*c), *a, *b),
            (Self::Open([a, b, c], _), Order::YearMonthDay) => (century(*a), *b, *c),
        };
        format!("{year:04}-{month:02}-{day:02}")
    }

    /// Whether the numbers may stand in an order.
    pub(super) fn may_be(&self, order: Order) -> bool {
        let Self::Open([a, b, c], style) = self else { return true };
        let (month, day) = match order {
            Order::DayMonthYear => (b, a),
            Order::MonthDayYear => (a, b),
            Order::YearMonthDay => (b, c),
        };
        (order != Order::YearMonthDay || *style == Style::Short)
            && (1..=12).contains(month)
            && (1..=31).contains(day)
    }

    /// Whether it is written as `03.04.2025`.
    pub(super) fn has_points(&self) -> bool {
        matches!(self, Self::Open(_, Style::Points))
    }
}

/// Reads a date, a clock, or both.
pub(super) fn stamp(text: &str) -> Option<Stamp> {
    let text = text.trim();
    if text.len() < 4 || !text.is_ascii() || !text.bytes().any(|b| b.is_ascii_digit()) {
        return None;
    }
    let split = text.match_indices(['T', 't']).find(|(at, _)| {
        let digit = |i: usize| text.as_bytes().get(i).is_some_and(u8::is_ascii_digit);
        *at > 0 && digit(at - 1) && digit(at + 1)
    });
    let spaced =
        split.map_or_else(|| text.to_owned(), |(at, _)| format!("{} {}", &text[..at], &text[at + 1..]));
    let spaced = basic(&spaced).unwrap_or(spaced);
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let at = words.iter().position(|w| w.contains(':'));
    let (before, behind) = words.split_at(at.unwrap_or(words.len()));
    let day = if before.is_empty() { None } else { Some(day(&before.join("-"))?) };
    let Some((first, more)) = behind.split_first() else {
        return Some(Stamp { day, clock: None, zone: String::new(), is_short: false });
    };
    let is_short = first.matches(':').count() == 1 && !first.contains(['.', ',']) && more.is_empty();
    let (clock, zone) = clock(first, more)?;
    Some(Stamp { day, clock: Some(clock), zone, is_short })
}

/// The basic form of ISO 8601, `20250403 120000.5Z` or in one word, in the extended one.
fn basic(text: &str) -> Option<String> {
    let (day, clock) = text.split_once(' ').or_else(|| Some((text.get(..8)?, text.get(8..)?)))?;
    let digits = |s: &str| s.bytes().all(|b| b.is_ascii_digit());
    let (hms, rest) = (clock.get(..6)?, clock.get(6..)?);
    let is_basic = day.len() == 8 && digits(day) && digits(hms) && day.starts_with(['1', '2']);
    is_basic.then(|| {
        let cut = |s: &str, at: usize| s[at..at + 2].to_owned();
        format!(
            "{}-{}-{} {}:{}:{}{rest}",
            &day[..4],
            cut(day, 4),
            cut(day, 6),
            cut(hms, 0),
            cut(hms, 2),
            cut(hms, 4)
        )
    })
}

/// A day in three parts between hyphens, slashes or points.
fn day(text: &str) -> Option<Day> {
    let text = text.trim_end_matches('.');
    let sign = text.chars().find(|c| !c.is_ascii_alphanumeric())?;
    let parts: Vec<&str> = text.split(sign).map(|p| p.trim_end_matches('.')).collect();
    let [a, b, c] = parts[..] else { return None };
    let number =
        |s: &str| s.parse::<u32>().ok().filter(|_| s.len() <= 4 && s.bytes().all(|b| b.is_ascii_digit()));
    if a.len() == 4 {
        return Some(Day::Sure(number(a)?, number(b).or_else(|| month(b))?, number(c)?));
    }
    let (year, short) = match (c.len(), number(c)?) {
        (2, year) => (year, true),
        (4, year) => (year, false),
        _ => return None,
    };
    let full = if short { 2000 + year } else { year };
    if let Some(month) = month(b) {
        return Some(Day::Sure(full, month, number(a)?));
    }
    if let Some(month) = month(a) {
        return Some(Day::Sure(full, month, number(b)?));
    }
    let (a, b) = (number(a)?, number(b)?);
    let style = match (short, sign) {
        (true, _) => Style::Short,
        (false, '.') => Style::Points,
        (false, _) => Style::Long,
    };
    let day = Day::Open([a, b, year], style);
    ORDERS.iter().any(|o| day.may_be(*o)).then_some(day)
}

/// A month by the first letters of its English or German name.
fn month(text: &str) -> Option<u32> {
    const MONTHS: [[&str; 2]; 12] = [
        ["jan", "jan"],
        ["feb", "feb"],
        ["mar", "mrz"],
        ["apr", "apr"],
        ["may", "mai"],
        ["jun", "jun"],
        ["jul", "jul"],
        ["aug", "aug"],
        ["sep", "sep"],
        ["oct", "okt"],
        ["nov", "nov"],
        ["dec", "dez"],
    ];
    let start = text.get(..3)?.to_lowercase();
    let is_word = text.chars().all(char::is_alphabetic);
    MONTHS.iter().position(|names| is_word && names.contains(&start.as_str())).map(|at| at as u32 + 1)
}

/// A clock with what follows it: `2:05:07.5`, `14:05`, `14:05:07,5+02:00`, `2:05:07 PM`, `14:05:07 UTC`.
fn clock(first: &str, more: &[&str]) -> Option<(String, String)> {
    let cut = first.find(['Z', 'z', '+', '-']).unwrap_or(first.len());
    let (time, mut zone) = (&first[..cut], first[cut..].to_uppercase());
    let mut half = None;
    for word in more {
        match word.to_uppercase().as_str() {
            "AM" | "A.M." if half.is_none() => half = Some(0),
            "PM" | "P.M." if half.is_none() => half = Some(12),
            "UTC" | "GMT" | "Z" if zone.is_empty() => zone = "Z".into(),
            other if zone.is_empty() && other.starts_with(['+', '-']) => other.clone_into(&mut zone),
            word if zone.is_empty() => named_zone(word)?.clone_into(&mut zone),
            _ => return None,
        }
    }
    let parts: Vec<&str> = time.split(':').collect();
    let digits = |s: &str| (1..=9).contains(&s.len()) && s.bytes().all(|b| b.is_ascii_digit());
    let (hour, minute, second, fraction) = match parts[..] {
        // hours have no fraction of a minute behind them
        [m, s] if s.contains(['.', ',']) => {
            let (s, fraction) = s.split_once(['.', ','])?;
            ("00", m, s, fraction)
        }
        [h, m] => (h, m, "00", ""),
        [h, m, s] => {
            let (s, fraction) = s.split_once(['.', ',']).unwrap_or((s, ""));
            (h, m, s, fraction)
        }
        [h, m, s, f] => (h, m, s, f),
        _ => return None,
    };
    let two = |s: &str| digits(s) && s.len() <= 2;
    if !(digits(hour)
        && hour.len() <= 5
        && two(minute)
        && two(second)
        && (fraction.is_empty() || digits(fraction)))
    {
        return None;
    }
    let hour: u32 = match (hour.parse().ok()?, half) {
        (hour @ 1..=12, Some(half)) => hour % 12 + half,
        (_, Some(_)) => return None,
        (hour, None) => hour,
    };
    let fraction = if fraction.is_empty() { String::new() } else { format!(".{fraction}") };
    Some((format!("{hour:02}:{minute:0>2}:{second:0>2}{fraction}"), zone_of(&zone)?))
}

/// Zones that have one meaning, in words; those with several, such as CST and IST, are no zones here.
fn named_zone(word: &str) -> Option<&'static str> {
    Some(match word {
        "WET" => "+00:00",
        "CET" | "MEZ" | "WEST" => "+01:00",
        "CEST" | "MESZ" | "EET" => "+02:00",
        "EEST" | "MSK" => "+03:00",
        "JST" | "KST" => "+09:00",
        "NZST" => "+12:00",
        "EST" => "-05:00",
        "EDT" => "-04:00",
        "PST" => "-08:00",
        "PDT" => "-07:00",
        _ => return None,
    })
}

/// `Z`, `+02`, `+0200` and `+02:00` as the last.
fn zone_of(text: &str) -> Option<String> {
    let digits: String = text.chars().filter(char::is_ascii_digit).collect();
    match (text, digits.len()) {
        ("" | "Z", _) => Some(text.to_owned()),
        (_, 2) => Some(format!("{}{digits}:00", &text[..1])),
        (_, 4) => Some(format!("{}{}:{}", &text[..1], &digits[..2], &digits[2..])),
        _ => None,
    }
}

/// The nanoseconds since 1970, leap seconds included, of a day and a clock.
///
/// # Errors
/// Why there is no such time.
pub(super) fn nanoseconds(day: &str, clock: &str, zone: &str) -> Result<i128, String> {
    let text = format!("{day}T{clock}{zone}");
    nmea::stamp(&text)
        .ok_or_else(|| nmea::why_no_stamp(&text).unwrap_or_else(|| "there is no such time".into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_and_clocks_are_read() {
        for (text, order, wanted) in [
            ("2025-04-03T12:00:00Z", Order::DayMonthYear, "2025-04-03 12:00:00 Z"),
            ("2025-04-03 12:00:00.25+02:00", Order::DayMonthYear, "2025-04-03 12:00:00.25 +02:00"),
            ("2025-04-03 12:00:00,25 +0200", Order::DayMonthYear, "2025-04-03 12:00:00.25 +02:00"),
            ("2025/04/03 1:02", Order::DayMonthYear, "2025-04-03 01:02:00 "),
            ("03.04.2025 12:00:00,5", Order::DayMonthYear, "2025-04-03 12:00:00.5 "),
            ("03-Apr-2025 12:00:00", Order::DayMonthYear, "2025-04-03 12:00:00 "),
            ("03 Dez 2025 12:00:00", Order::DayMonthYear, "2025-12-03 12:00:00 "),
            ("4/3/2025 2:05:07 PM", Order::MonthDayYear, "2025-04-03 14:05:07 "),
            ("4/3/2025 12:05:07 AM", Order::DayMonthYear, "2025-03-04 00:05:07 "),
            ("12:00:00:125", Order::DayMonthYear, " 12:00:00.125 "),
            ("2025-04-03", Order::DayMonthYear, "2025-04-03  "),
            ("20250403T120000.5Z", Order::DayMonthYear, "2025-04-03 12:00:00.5 Z"),
            ("20240213100059", Order::DayMonthYear, "2024-02-13 10:00:59 "),
            ("3.4.25 12:00", Order::DayMonthYear, "2025-04-03 12:00:00 "),
            ("21/03/04 23:58", Order::YearMonthDay, "2021-03-04 23:58:00 "),
            ("59:58.5", Order::DayMonthYear, " 00:59:58.5 "),
            ("31:00:05", Order::DayMonthYear, " 31:00:05 "),
            ("12:00:00 UTC", Order::DayMonthYear, " 12:00:00 Z"),
            ("12:00:00 CET", Order::DayMonthYear, " 12:00:00 +01:00"),
            ("3.4.2025 12:00:00 MESZ", Order::DayMonthYear, "2025-04-03 12:00:00 +02:00"),
        ] {
            let got = stamp(text).unwrap_or_else(|| panic!("{text}"));
            let day = got.day.map(|d| d.iso(order)).unwrap_or_default();
            assert_eq!(format!("{day} {} {}", got.clock.unwrap_or_default(), got.zone), wanted, "{text}");
        }
    }

    #[test]
    fn other_texts_are_no_times() {
        for text in [
            "",
            "calm",
            "1.5",
            "1,5",
            "-3e5",
            "1.2.3.4",
            "12",
            "a:b",
            "1:2:3:4:5",
            "13:00 PM",
            "1-2",
            "v1.2.3",
            "41/3/2025",
        ] {
            assert_eq!(stamp(text), None, "{text}");
        }
    }

    #[test]
    fn orders_that_numbers_allow() {
        let orders = |text: &str| -> Vec<Order> {
            let day = stamp(text).unwrap().day.unwrap();
            ORDERS.into_iter().filter(|o| day.may_be(*o)).collect()
        };
        assert_eq!(orders("13/4/2025"), [Order::DayMonthYear]);
        assert_eq!(orders("4/13/2025"), [Order::MonthDayYear]);
        assert_eq!(orders("4/5/2025"), [Order::DayMonthYear, Order::MonthDayYear]);
        assert_eq!(orders("21/03/04"), [Order::DayMonthYear, Order::YearMonthDay]);
        assert_eq!(orders("04.05.2025"), [Order::DayMonthYear, Order::MonthDayYear]);
        assert_eq!(orders("04.22.2025"), [Order::MonthDayYear]);
        assert_eq!(orders("04.05.25"), ORDERS);
    }
}
