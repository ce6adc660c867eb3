//! Time stamps of a log.

/// The seconds since 1970, by a clock that counts none of them, at which the 27 leap seconds up to now were over
/// (IERS Bulletin C; none is announced).
const LEAPS: [i64; 27] = [
    78_796_800,
    94_694_400,
    126_230_400,
    157_766_400,
    189_302_400,
    220_924_800,
    252_460_800,
    283_996_800,
    315_532_800,
    362_793_600,
    394_329_600,
    425_865_600,
    489_024_000,
    567_993_600,
    631_152_000,
    662_688_000,
    709_948_800,
    741_484_800,
    773_020_800,
    820_454_400,
    867_715_200,
    915_148_800,
    1_136_073_600,
    1_230_768_000,
    1_341_100_800,
    1_435_708_800,
    1_483_228_800,
];
const NANO: i128 = 1_000_000_000;

/// A time stamp in nanoseconds that went by since 1970, leap seconds included: ISO 8601 with its zone
/// (`2018-12-06T00:00:00.0117Z`), without one (taken as UTC), or since 1970 in s, ms, µs or ns. The sixtieth second of a
/// minute is one only where there was a leap second.
pub(in super::super) fn stamp(text: &str) -> Option<i128> {
    let text = text.trim();
    let (before, sixtieth) = match text.match_indices(":60").find(|(at, _)| text[..*at].contains(':')) {
        Some((at, _)) => (format!("{}:59{}", &text[..at], &text[at + 3..]), true),
        None => (text.to_owned(), false),
    };
    let nano = civil(&before).or_else(|| seconds(&before))?;
    if !sixtieth {
        return Some(nano + NANO * leaps_until(nano));
    }
    let over = (nano.div_euclid(NANO) + 1) * NANO;
    let leap = LEAPS.iter().any(|at| i128::from(*at) * NANO == over);
    leap.then(|| nano + NANO * (1 + leaps_until(nano)))
}

/// Why a text in the form of a date and a time is none: a day or an hour that there is not.
pub(in super::super) fn why_no_stamp(text: &str) -> Option<String> {
    const LAST: [u8; 12] = [31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let numbers: Vec<u32> = text
        .split(['-', 'T', 't', ' ', ':', '.', ',', 'Z', 'z', '+'])
        .map_while(|n| n.parse().ok())
        .collect();
    let [year, month, day, rest @ ..] = numbers.as_slice() else { return None };
    let Some(last) = LAST.get((*month as usize).wrapping_sub(1)) else {
        return Some(format!("a year has no month {month}"));
    };
    let is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let last = if *month == 2 && !is_leap { 28 } else { u32::from(*last) };
    if !(1..=last).contains(day) {
        return Some(format!("month {month} of {year} has {last} days"));
    }
    let second = rest.get(2).is_some_and(|s| *s == 60).then(|| "there was no leap second then".to_owned());
    let units = [("a day", "hour", 23), ("an hour", "minute", 59), ("a minute", "second", 60)];
    let over = rest.iter().zip(units).find(|(n, (.., most))| *n > most);
    over.map(|(n, (whole, part, _))| format!("there is no {part} {n} in {whole}")).or(second)
}

/// How many leap seconds were over at a time that counts none of them.
fn leaps_until(nano: i128) -> i128 {
    LEAPS.partition_point(|at| i128::from(*at) * NANO <= nano) as i128
}

fn civil(text: &str) -> Option<i128> {
    if let Ok(time) = text.parse::<jiff::Timestamp>() {
        return Some(time.as_nanosecond());
    }
    let time = text.parse::<jiff::civil::DateTime>().ok()?;
    Some(time.to_zoned(jiff::tz::TimeZone::UTC).ok()?.timestamp().as_nanosecond())
}

/// The nanoseconds of one in a count since 1970 of so many digits, between 2001 and 2286: of s, ms, µs or ns.
pub(in super::super) fn nano_of_count(digits: usize) -> Option<i128> {
    [(10, NANO), (13, 1_000_000), (16, 1_000), (19, 1)].into_iter().find(|u| u.0 == digits).map(|u| u.1)
}

/// A count since 1970: in seconds, or, by the number of its digits between 2001 and 2286, in ms, µs or ns.
fn seconds(text: &str) -> Option<i128> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, "0"));
    let digits = |s: &str| !s.is_empty() && s.bytes().all(|b| b.is_ascii_digit());
    if !digits(whole) || !digits(fraction) {
        return None;
    }
    let unit = if whole.len() < 10 { NANO } else { nano_of_count(whole.len())? };
    let share = format!("{fraction:0<9}")[..9].parse::<i128>().ok()?;
    Some(whole.parse::<i128>().ok()? * unit + share * unit / NANO)
}

#[cfg(test)]
mod tests {
    use super::{LEAPS, stamp, why_no_stamp};

    #[test]
    fn leap_seconds_go_by() {
        let at = |text: &str| stamp(text).unwrap();
        let before = at("2016-12-31T23:59:59Z");
        for (text, seconds) in [
            ("2016-12-31T23:59:59.5Z", 0.5),
            ("2016-12-31T23:59:60Z", 1.0),
            ("2016-12-31T23:59:60.25Z", 1.25),
            ("2017-01-01T08:59:60+09:00", 1.0),
            ("2016-12-31 23:59:60", 1.0),
            ("2017-01-01T00:00:00Z", 2.0),
            ("1483228800.5", 2.5),
        ] {
            assert_eq!((at(text) - before) as f64 / 1e9, seconds, "{text}");
        }
        for never in ["2018-06-30T23:59:60Z", "2016-12-31T22:59:60Z", "2016-12-31T23:60:00Z", "1:60", ":60"] {
            assert_eq!(stamp(never), None, "{never}");
        }
    }

    #[test]
    fn a_day_that_there_was_not_is_named() {
        for (text, why) in [
            ("2017-02-29T00:00:00Z", "month 2 of 2017 has 28 days"),
            ("1900-02-29 00:00:00", "month 2 of 1900 has 28 days"),
            ("2016-04-31T00:00:00Z", "month 4 of 2016 has 30 days"),
            ("2016-13-01T00:00:00Z", "a year has no month 13"),
            ("2016-00-01T00:00:00Z", "a year has no month 0"),
            ("2016-01-01T24:00:00Z", "there is no hour 24 in a day"),
            ("2016-01-01T23:60:00.5Z", "there is no minute 60 in an hour"),
            ("2018-06-30T23:59:60Z", "there was no leap second then"),
        ] {
            assert_eq!(stamp(text), None, "{text}");
            assert_eq!(why_no_stamp(text).as_deref(), Some(why), "{text}");
        }
        for other in ["", "yesterday", "12:00", "2016-01", "1.5.3"] {
            assert_eq!(why_no_stamp(other), None, "{other}");
        }
    }

    #[test]
    fn leap_seconds_end_with_june_or_december() {
        for at in LEAPS {
            let day = jiff::Timestamp::from_second(at).unwrap().to_string();
            assert!(day.ends_with("-07-01T00:00:00Z") || day.ends_with("-01-01T00:00:00Z"), "{day}");
        }
        // GPS began in 1980 at 19 s behind TAI, which was 10 s before UTC in 1972: 9 leap seconds (ICD-GPS-200)
        let until = |text: &str| super::leaps_until(super::civil(text).unwrap());
        assert_eq!((until("1980-01-07T00:00:00Z"), until("2018-01-01T00:00:00Z")), (9, 27));
    }

    #[test]
    fn stamps_of_three_forms_agree() {
        let zero = stamp("2018-12-06T00:00:00Z").unwrap();
        assert_eq!(stamp("2018-12-06T00:00:00.0117Z").unwrap() - zero, 11_700_000);
        assert_eq!(stamp("2018-12-06T01:00:00+01:00").unwrap(), zero);
        for count in ["1544054400", "1544054400000", "1544054400000000", "1544054400000000000"] {
            assert_eq!(stamp(count).unwrap(), zero, "{count}");
        }
        assert_eq!(stamp("1544054400000.25").unwrap() - zero, 250_000);
        assert_eq!(stamp("15440544000"), None);
        assert_eq!(stamp("2018-12-06 00:00:00.5").unwrap() - zero, 500_000_000);
        assert_eq!(stamp("1544054400.25").unwrap() - zero, 250_000_000);
        for wrong in ["", "yesterday", "12:00", "1.5.3", "-4"] {
            assert_eq!(stamp(wrong), None, "{wrong}");
        }
    }
}
