//! Quantities as options take them: `3m`, `3 m` or `3`.

use crate::gyro::range::Range;
use crate::{Error, Result};

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
    let value: f64 = number.trim().parse().map_err(|_| wrong())?;
    if !value.is_finite() {
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

/// A list of quantities, each in its range.
pub fn quantities(option: &str, text: &str, ranges: &[&Range]) -> Result<Vec<f64>> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() != ranges.len() {
        return Err(Error::usage(format!("--{option} takes {} numbers with commas between", ranges.len())));
    }
    parts.iter().zip(ranges).map(|(p, r)| quantity(option, p, r)).collect()
}
