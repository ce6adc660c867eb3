//! Quantities as options take them: `3m`, `3 m` or `3`.

use crate::gyro::range::Range;
use crate::text::is_lost;
use crate::units::{Dimension, Unit, significant};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// A number and its unit.
fn parted<'a>(option: &str, text: &'a str, si: &str) -> Result<(f64, Option<&'a str>)> {
    let text = text.trim();
    // the longest head that is a number
    let cut = (1..=text.len())
        .rev()
        .filter(|i| text.is_char_boundary(*i))
        .find(|i| text[..*i].trim().parse::<f64>().is_ok());
    let wrong = || Error::usage(format!("--{option}: `{text}` is no quantity, such as 3{si}"));
    let (number, unit) = text.split_at(cut.ok_or_else(wrong)?);
    if unit.starts_with(',') && unit[1..].starts_with(|c: char| c.is_ascii_digit()) {
        return Err(Error::usage(format!("--{option}: `{text}` has a comma in its number"))
            .with_hint(format!("write it with a point: {}", text.replacen(',', ".", 1))));
    }
    let value: f64 = number.trim().parse().map_err(|_| wrong())?;
    if !value.is_finite() || is_lost(number.trim()) {
        return Err(wrong());
    }
    Ok((value, Some(unit.trim()).filter(|u| !u.is_empty())))
}

/// A number with a unit of the range's dimension, or in SI without one, within the range.
pub fn quantity(option: &str, text: &str, range: &Range) -> Result<f64> {
    let (value, unit) = parted(option, text, range.unit)?;
    range.read(value, unit).map_err(|e| e.about(&format!("--{option}")))
}

/// An angle on the compass card: a bare number is in degrees; rad.
pub fn angle(option: &str, text: &str, range: &Range) -> Result<f64> {
    let (value, unit) = parted(option, text, range.unit)?;
    range.read(value, unit.or(Some("deg"))).map_err(|e| e.about(&format!("--{option}")))
}

/// A latitude, rad: `60.2`, `60.2deg`, or as a chart has it, `60°12'N`, `N 60 12.5`, `33°52'10"S`.
pub fn latitude(option: &str, text: &str, range: &Range) -> Result<f64> {
    let Some((marks, south)) = hemisphere(text.trim()) else {
        return angle(option, text, range).map_err(|e| meant(option, text.trim(), e));
    };
    let wrong = || {
        let e = Error::usage(format!("--{option}: `{text}` is no latitude"))
            .with_hint("write 60.2, 60.2N, 60°12'N or 33 52 10 S: degrees, minutes and seconds below 60");
        meant(option, text.trim(), e)
    };
    let parts: Vec<f64> = marks
        .split(is_mark)
        .filter(|p| !p.is_empty())
        .map(|p| p.parse().map_err(|_| wrong()))
        .collect::<Result<_>>()?;
    let [degrees, ref smaller @ ..] = parts[..] else { return Err(wrong()) };
    // only the last may be broken, and none but the hemisphere has a sign
    let whole = parts[..parts.len() - 1].iter().all(|p| p.fract() == 0.0);
    let signed = parts.iter().any(|p| !p.is_finite() || p.is_sign_negative());
    if smaller.len() > 2 || !whole || signed || smaller.iter().any(|p| *p >= 60.0) {
        return Err(wrong());
    }
    let value = smaller.iter().rev().fold(0.0, |sum, part| (sum + part) / 60.0) + degrees;
    let value = if south { -value } else { value };
    range.read(value, Some("deg")).map_err(|e| e.about(&format!("--{option}")))
}

/// What stands between degrees, minutes and seconds.
fn is_mark(c: char) -> bool {
    c.is_whitespace() || "°ºd'′’\"″”m".contains(c)
}

/// What stands beside one `N` or `S`, before or behind, and whether it is `S`.
fn hemisphere(text: &str) -> Option<(&str, bool)> {
    let beside = |letters: [char; 2]| text.strip_suffix(letters).or_else(|| text.strip_prefix(letters));
    match (beside(['N', 'n']), beside(['S', 's'])) {
        (Some(marks), _) => Some((marks, false)),
        (_, Some(marks)) => Some((marks, true)),
        _ => None,
    }
}

/// A refused latitude with what was probably meant.
fn meant(option: &str, text: &str, e: Error) -> Error {
    let no = |hint: String| Error::usage(format!("--{option}: `{text}` is no latitude")).with_hint(hint);
    let east_or_west = |c: char| "EeWwOo".contains(c);
    let has_digits = text.contains(|c: char| c.is_ascii_digit());
    if has_digits && (text.ends_with(east_or_west) || text.starts_with(east_or_west)) {
        return no("E and W are of longitudes; a latitude goes with N or S, as 60°12'N".into());
    }
    if text.contains(',') {
        return no(format!("write it with a point: {}", text.replacen(',', ".", 1)));
    }
    if text.contains(['°', 'º', '\'', '′', '’']) && hemisphere(text).is_none() {
        return no(format!("say whether it is north or south: {text}N or {text}S"));
    }
    e
}

/// A frequency above which a bare number is rather a period: it would be one of two seconds and less, rad/s.
const FASTEST: f64 = 3.0;

/// A frequency, rad/s, or the period that it has, as `12s`.
pub fn frequency(option: &str, text: &str, range: &Range) -> Result<f64> {
    let (value, unit) = parted(option, text, range.unit)?;
    if unit.is_none() && value > FASTEST && range.check(TAU / value).is_ok() {
        let text = text.trim();
        return Err(Error::usage(format!(
            "--{option}: {text} without a unit is {text} rad/s, a period of {} s, and no ship moves so fast",
            significant(TAU / value, 2)
        ))
        .with_hint(format!("did you mean the period {text}s? Else say {text}rad/s")));
    }
    let Some(time) = unit.and_then(|u| Unit::parse(u).ok()).filter(|u| u.dimension() == Dimension::TIME)
    else {
        return quantity(option, text, range);
    };
    let period = time.to_si(value);
    if period <= 0.0 {
        return Err(Error::usage(format!("--{option}: a period is above 0, not {text}")));
    }
    // p = 2π/period
    range.read(TAU / period, None).map_err(|e| e.about(&format!("--{option}")))
}

/// The parts of a list with commas between.
pub fn listed<'a, const N: usize>(option: &str, text: &'a str) -> Result<[&'a str; N]> {
    let parts: Vec<&str> = text.split(',').collect();
    parts.try_into().map_err(|_| Error::usage(format!("--{option} takes {N} numbers with commas between")))
}

/// A list of quantities, each in its range.
pub fn quantities(option: &str, text: &str, ranges: &[&Range]) -> Result<Vec<f64>> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() != ranges.len() {
        return Err(Error::usage(format!("--{option} takes {} numbers with commas between", ranges.len())));
    }
    parts.iter().zip(ranges).map(|(p, r)| quantity(option, p, r)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gyro::range::{LATITUDE, LEVER, ROLL_FREQUENCY};

    #[test]
    fn latitudes_as_a_chart_has_them() {
        for (text, wanted) in [
            ("60.2", 60.2),
            ("-33deg", -33.0),
            ("1rad", 1f64.to_degrees()),
            ("55N", 55.0),
            ("55 s", -55.0),
            ("60°12'N", 60.2),
            ("60 12.6 N", 60.21),
            ("33°52'12\"S", -33.87),
            ("0°30′N", 0.5),
            ("N60°12'", 60.2),
            ("s 33 52 12", -33.87),
        ] {
            let found = latitude("latitude", text, &LATITUDE).unwrap().to_degrees();
            assert!((found - wanted).abs() < 1e-12, "{text}: {found}");
        }
        for text in ["N", "60°72'N", "-60N", "60.5°10'N", "95N", "60°12'E", "1 2 3 4 N", "60°12'", "infN"]
        {
            assert!(latitude("latitude", text, &LATITUDE).is_err(), "{text}");
        }
        for (text, says) in [
            ("60°12'E", "E and W are of longitudes"),
            ("W20", "E and W are of longitudes"),
            ("60,5", "write it with a point: 60.5"),
            ("60,5N", "write it with a point: 60.5N"),
            ("60°12,5'N", "write it with a point: 60°12.5'N"),
            ("60°12'", "60°12'N or 60°12'S"),
            ("N60N", "is no latitude"),
        ] {
            let e = latitude("latitude", text, &LATITUDE).unwrap_err().to_string();
            assert!(e.contains(says), "{text}: {e}");
        }
        let e = quantity("lever", "3,5m", &LEVER).unwrap_err().to_string();
        assert!(e.contains("write it with a point: 3.5m"), "{e}");
    }

    #[test]
    fn a_frequency_by_its_period() {
        let read = |text| frequency("regular", text, &ROLL_FREQUENCY);
        assert_eq!(read("12s").unwrap(), TAU / 12.0);
        assert_eq!(read("0.2min").unwrap(), TAU / 12.0);
        assert_eq!(read("0.5").unwrap(), 0.5);
        assert_eq!(read("0.5rad/s").unwrap(), 0.5);
        for text in ["0s", "-3s", "infs", "2h", "3m", "0.1Hz"] {
            assert!(read(text).is_err(), "{text}");
        }
        let e = read("12").unwrap_err().to_string();
        assert!(
            e.contains("12 rad/s, a period of 0.52 s") && e.contains("did you mean the period 12s?"),
            "{e}"
        );
        assert_eq!(read("12rad/s").unwrap(), 12.0);
    }
}
