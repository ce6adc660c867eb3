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
}

/// A day of the calendar.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Day {
    /// Year, month and day.
    Sure(u32, u32, u32),
    /// Two numbers of which one is the month, and the year.
    Either(u32, u32, u32),
}

impl Day {
    /// As `yyyy-mm-dd`, the day before the month or behind it.
    pub(super) fn iso(&self, day_first: bool) -> String {
        let (year, month, day) = match *self {
            Self::Either(day, month, year) if day_first => (year, month, day),
            Self::Sure(year, month, day) | Self::Either(month, day, year) => (year, month, day),
        };
        format!("{year:04}-{month:02}-{day:02}")
    }

    /// Whether the numbers themselves tell that the day, or the month, comes first.
    pub(super) fn order(&self) -> Option<bool> {
        match *self {
            Self::Either(first, _, _) if first > 12 => Some(true),
            Self::Either(_, second, _) if second > 12 => Some(false),
            _ => None,
        }
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
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let at = words.iter().position(|w| w.contains(':'));
    let (before, behind) = words.split_at(at.unwrap_or(words.len()));
    let day = if before.is_empty() { None } else { Some(day(&before.join("-"))?) };
    let Some((first, more)) = behind.split_first() else {
        return Some(Stamp { day, clock: None, zone: String::new() });
    };
    let (clock, zone) = clock(first, more)?;
    Some(Stamp { day, clock: Some(clock), zone })
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
    let year = match (c.len(), number(c)?) {
        (2, year) => 2000 + year,
        (4, year) => year,
        _ => return None,
    };
    if let Some(month) = month(b) {
        return Some(Day::Sure(year, month, number(a)?));
    }
    if let Some(month) = month(a) {
        return Some(Day::Sure(year, month, number(b)?));
    }
    let (a, b) = (number(a).filter(|a| (1..=31).contains(a))?, number(b).filter(|b| (1..=31).contains(b))?);
    Some(if sign == '.' { Day::Sure(year, b, a) } else { Day::Either(a, b, year) })
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
            _ => return None,
        }
    }
    let parts: Vec<&str> = time.split(':').collect();
    let digits = |s: &str| (1..=9).contains(&s.len()) && s.bytes().all(|b| b.is_ascii_digit());
    let (hour, minute, second, fraction) = match parts[..] {
        [h, m] => (h, m, "00", ""),
        [h, m, s] => {
            let (s, fraction) = s.split_once(['.', ',']).unwrap_or((s, ""));
            (h, m, s, fraction)
        }
        [h, m, s, f] => (h, m, s, f),
        _ => return None,
    };
    let two = |s: &str| digits(s) && s.len() <= 2;
    if !(two(hour) && two(minute) && two(second) && (fraction.is_empty() || digits(fraction))) {
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
        for (text, day_first, wanted) in [
            ("2025-04-03T12:00:00Z", None, "2025-04-03 12:00:00 Z"),
            ("2025-04-03 12:00:00.25+02:00", None, "2025-04-03 12:00:00.25 +02:00"),
            ("2025-04-03 12:00:00,25 +0200", None, "2025-04-03 12:00:00.25 +02:00"),
            ("2025/04/03 1:02", None, "2025-04-03 01:02:00 "),
            ("03.04.2025 12:00:00,5", None, "2025-04-03 12:00:00.5 "),
            ("3.4.25 12:00", None, "2025-04-03 12:00:00 "),
            ("03-Apr-2025 12:00:00", None, "2025-04-03 12:00:00 "),
            ("03 Dez 2025 12:00:00", None, "2025-12-03 12:00:00 "),
            ("4/3/2025 2:05:07 PM", Some(false), "2025-04-03 14:05:07 "),
            ("4/3/2025 12:05:07 AM", Some(true), "2025-03-04 00:05:07 "),
            ("12:00:00:125", None, " 12:00:00.125 "),
            ("2025-04-03", None, "2025-04-03  "),
            ("12:00:00 UTC", None, " 12:00:00 Z"),
        ] {
            let got = stamp(text).unwrap_or_else(|| panic!("{text}"));
            let day = got.day.map(|d| d.iso(day_first.unwrap_or(true))).unwrap_or_default();
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
    fn order_is_told_by_numbers_above_twelve() {
        let order = |text: &str| stamp(text).unwrap().day.unwrap().order();
        assert_eq!(
            (order("13/4/2025"), order("4/13/2025"), order("4/5/2025")),
            (Some(true), Some(false), None)
        );
        assert_eq!(order("04.05.2025"), None);
    }
}
