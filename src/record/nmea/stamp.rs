//! Time stamps of a log.

/// A time stamp in nanoseconds since 1970: ISO 8601 with its zone (`2018-12-06T00:00:00.0117Z`),
/// without one (taken as UTC), or seconds since 1970.
pub(in super::super) fn stamp(text: &str) -> Option<i128> {
    let text = text.trim();
    if let Ok(time) = text.parse::<jiff::Timestamp>() {
        return Some(time.as_nanosecond());
    }
    if let Ok(time) = text.parse::<jiff::civil::DateTime>() {
        return Some(time.to_zoned(jiff::tz::TimeZone::UTC).ok()?.timestamp().as_nanosecond());
    }
    seconds(text)
}

fn seconds(text: &str) -> Option<i128> {
    let (whole, fraction) = text.split_once('.').unwrap_or((text, "0"));
    let digits = |s: &str| !s.is_empty() && s.bytes().all(|b| b.is_ascii_digit());
    if !digits(whole) || !digits(fraction) || whole.len() > 15 {
        return None;
    }
    let nano = format!("{fraction:0<9}");
    Some(whole.parse::<i128>().ok()? * 1_000_000_000 + nano[..9].parse::<i128>().ok()?)
}

#[cfg(test)]
mod tests {
    use super::stamp;

    #[test]
    fn stamps_of_three_forms_agree() {
        let zero = stamp("2018-12-06T00:00:00Z").unwrap();
        assert_eq!(stamp("2018-12-06T00:00:00.0117Z").unwrap() - zero, 11_700_000);
        assert_eq!(stamp("2018-12-06T01:00:00+01:00").unwrap(), zero);
        assert_eq!(stamp("2018-12-06 00:00:00.5").unwrap() - zero, 500_000_000);
        assert_eq!(stamp("1544054400.25").unwrap() - zero, 250_000_000);
        for wrong in ["", "yesterday", "12:00", "1.5.3", "-4"] {
            assert_eq!(stamp(wrong), None, "{wrong}");
        }
    }
}
