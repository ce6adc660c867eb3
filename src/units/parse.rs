//! Reads a unit text: names joined by `*` and `/`, whole or half powers by `^`, parentheses.

use super::counts::Counts;
use super::{Dimension, Ratio, Unit, names, spelling};
use crate::error::nearest;
use crate::{Error, ErrorKind, Result};

/// Reads the whole text.
pub(super) fn unit(text: &str) -> Result<Unit> {
    let text = &spelling::plain(text);
    let mut reader = Reader { text, at: 0 };
    reader.spaces();
    if reader.rest().is_empty() {
        return Err(Error::new(ErrorKind::Units, "the unit is empty").with_hint("write 1 for no unit"));
    }
    let mut unit = reader.product()?;
    if !reader.rest().is_empty() {
        return Err(reader.error("expected * or / here"));
    }
    let trimmed = text.trim();
    unit.offset = names::find(trimmed).map_or(0.0, |n| n.offset);
    unit.text = trimmed.to_string();
    Ok(unit)
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn spaces(&mut self) {
        self.at += self.rest().len() - self.rest().trim_start().len();
    }

    fn takes(&mut self, c: char) -> bool {
        let found = self.rest().starts_with(c);
        if found {
            self.at += c.len_utf8();
            self.spaces();
        }
        found
    }

    fn error(&self, message: &str) -> Error {
        self.error_at(self.at, 1, format!("the unit {:?}: {message}", self.text))
    }

    fn error_at(&self, at: usize, length: usize, message: String) -> Error {
        let column = self.text[..at].chars().count();
        Error::new(ErrorKind::Units, message).with_column(column + 1).with_excerpt(self.text, column, length)
    }

    fn product(&mut self) -> Result<Unit> {
        let mut left = self.power()?;
        loop {
            if self.takes('*') {
                left = times(&left, &self.power()?, Ratio::ONE);
            } else if self.takes('/') {
                left = times(&left, &self.power()?, Ratio::ONE.negative());
            } else {
                return Ok(left);
            }
        }
    }

    fn power(&mut self) -> Result<Unit> {
        let base = self.factor()?;
        if !self.takes('^') {
            return Ok(base);
        }
        let exponent = self.exponent()?;
        Ok(times(&Unit::one(), &base, exponent))
    }

    fn factor(&mut self) -> Result<Unit> {
        if self.takes('(') {
            let inner = self.product()?;
            return if self.takes(')') { Ok(inner) } else { Err(self.error("a ) is missing")) };
        }
        let start = self.at;
        let length =
            self.rest().find(|c: char| !c.is_alphanumeric() && c != '%').unwrap_or(self.rest().len());
        let name = &self.rest()[..length];
        if name.is_empty() {
            return Err(self.error("a unit name is missing here"));
        }
        let found = names::find(name).ok_or_else(|| self.unknown(start, name))?;
        self.at += length;
        self.spaces();
        Ok(Unit {
            text: String::new(),
            mantissa: found.mantissa,
            decade: found.decade,
            offset: 0.0,
            dimension: found.dimension,
            angle: Ratio::new(found.angle, 1).unwrap_or(Ratio::ZERO),
            counts: Counts::of(&found.name),
        })
    }

    fn unknown(&self, start: usize, name: &str) -> Error {
        let known: Vec<String> = names::all().map(|n| n.name).collect();
        let message = format!("unknown unit {name:?}");
        let e = self.error_at(start, name.chars().count(), message);
        if ["degf", "fahrenheit"].contains(&name.to_lowercase().as_str()) {
            // its differences are no K, as those of degC are
            return e.with_hint("convert the numbers to degC: (x - 32)/1.8");
        }
        // of two that are as near, the last is taken: plain names before those with prefixes
        if let Some(near) =
            spelled_out(name).or_else(|| nearest(name, known.iter().rev().map(String::as_str)))
        {
            return e.with_hint(format!("the nearest known unit is {near}"));
        }
        let plain: Vec<&str> = names::families().map(|f| f.0).collect();
        e.with_hint(format!("known are {}, with prefixes", plain.join(" ")))
    }

    /// A whole or half power: `2`, `-1`, `0.5`, `1.5`, `(1/2)`.
    fn exponent(&mut self) -> Result<Ratio> {
        let start = self.at;
        let closed = self.takes('(');
        let top = self.number()?;
        let bottom = if closed && self.takes('/') { self.number()? } else { 1.0 };
        if closed && !self.takes(')') {
            return Err(self.error("a ) is missing"));
        }
        if top == 0.0 {
            let message = "a power of 0 leaves no unit: write 1 for none".to_string();
            return Err(self.error_at(start, self.at - start, message));
        }
        let ratio =
            Ratio::from_f64(top / bottom).filter(|r| r.denominator() <= 2 && r.to_f64().abs() <= 24.0);
        ratio.ok_or_else(|| {
            let message = "powers of units are whole or half numbers".to_string();
            self.error_at(start, self.at - start, message)
        })
    }

    fn number(&mut self) -> Result<f64> {
        let rest = self.rest();
        let sign = usize::from(rest.starts_with(['-', '+']));
        let length =
            sign + rest[sign..].find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len() - sign);
        let value = rest[..length].parse().map_err(|_| self.error("a number is missing after ^"))?;
        self.at += length;
        self.spaces();
        Ok(value)
    }
}

/// Words people write for units of the list.
fn spelled_out(name: &str) -> Option<&'static str> {
    Some(match name.to_lowercase().as_str() {
        "metre" | "meter" | "metres" | "meters" => "m",
        "sec" | "secs" | "second" | "seconds" => "s",
        "degree" | "degrees" | "grad" => "deg",
        "radian" | "radians" => "rad",
        "mole" | "moles" => "mol",
        "newton" | "newtons" => "N",
        "volt" | "volts" => "V",
        "knot" | "kt" | "kts" => "kn",
        "celsius" | "degc" | "c" => "degC",
        "ohms" => "ohm",
        "day" | "days" => "d",
        "revs" | "revolution" | "revolutions" | "turn" | "turns" => "rev",
        "percent" => "%",
        "l" | "lt" | "ltr" | "litre" | "liter" | "litres" | "liters" => "l",
        "foot" | "feet" => "ft",
        "minute" | "minutes" => "min",
        "hour" | "hours" | "hr" => "h",
        "kilogram" | "kilograms" => "kg",
        "none" => "1",
        _ => return None,
    })
}

/// a·bᵉ, with the power of ten kept apart while it is whole.
fn times(a: &Unit, b: &Unit, e: Ratio) -> Unit {
    let decade = Ratio::new(b.decade, 1).unwrap_or(Ratio::ZERO).times(e);
    let (whole, extra) =
        if decade.denominator() == 1 { (decade.numerator(), 1.0) } else { (0, 10f64.powf(decade.to_f64())) };
    let mantissa = if e == Ratio::ONE {
        a.mantissa * b.mantissa
    } else if e == Ratio::ONE.negative() {
        a.mantissa / b.mantissa
    } else {
        a.mantissa * b.mantissa.powf(e.to_f64())
    };
    Unit {
        text: String::new(),
        mantissa: mantissa * extra,
        decade: a.decade + whole,
        offset: 0.0,
        dimension: a.dimension.times(Dimension::power(b.dimension, e)),
        angle: a.angle.plus(b.angle.times(e)),
        counts: a.counts.with(b.counts, e),
    }
}
