//! The closed list of units: parse, convert, check dimensions.
//!
//! Inside the program everything is SI and radians; a [`Unit`] stands only where text comes in
//! or goes out.

mod combine;
mod counts;
mod dimension;
mod figure;
mod list;
mod names;
mod parse;
mod spelling;
mod turning;

pub use dimension::{Dimension, Ratio};
pub use figure::{counted, digits_within, figure, figure_of, significant, without_needless_zeros};
pub use list::list;
pub use turning::Turning;

use crate::Result;
use counts::Counts;
use std::fmt;

/// A unit as written, with its factor and offset to SI.
///
/// ```
/// use gyrospec::units::Unit;
/// let moment = Unit::parse("g*cm^2/s")?;
/// assert_eq!(moment.to_si(1.55e8), 15.5);
/// let warm = Unit::parse("degC")?;
/// assert_eq!(warm.to_si(20.0), 293.15);
/// assert_eq!(warm.difference_to_si(20.0), 20.0);
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Unit {
    text: String,
    /// Factor without its power of ten, which is kept apart so that decimal values stay exact.
    mantissa: f64,
    decade: i32,
    offset: f64,
    dimension: Dimension,
    /// The power of an angle, which the dimension leaves out.
    angle: Ratio,
    /// The names in it that count something.
    counts: Counts,
}

impl Unit {
    /// The unit of pure numbers, `1`.
    pub fn one() -> Self {
        Self::of(Dimension::NONE)
    }

    /// Reads a unit such as `g*cm^2/s`, `rad/s^2`, `V/Hz^0.5` or `1`; `°C`, `m³/h` and the like are read as
    /// `degC`, `m^3/h`.
    ///
    /// # Errors
    /// An unknown unit is an error that names the nearest known one and its place in the text.
    pub fn parse(text: &str) -> Result<Self> {
        parse::unit(text)
    }

    /// The SI unit of a dimension, with a readable name (`N`, `m/s^2`, `V/s`).
    pub fn of(dimension: Dimension) -> Self {
        let (angle, counts) = (Ratio::ZERO, Counts::NOTHING);
        Self { text: dimension.to_string(), mantissa: 1.0, decade: 0, offset: 0.0, dimension, angle, counts }
    }

    /// A value in this unit, in SI; `degC` includes its offset.
    pub fn to_si(&self, value: f64) -> f64 {
        self.difference_to_si(value) + self.offset
    }

    /// An SI value in this unit; `degC` includes its offset.
    pub fn from_si(&self, value: f64) -> f64 {
        self.difference_from_si(value - self.offset)
    }

    /// A difference of two values in this unit, in SI (a difference in degC is one in K).
    pub fn difference_to_si(&self, value: f64) -> f64 {
        shift(value * self.mantissa, self.decade)
    }

    /// An SI difference in this unit.
    pub fn difference_from_si(&self, value: f64) -> f64 {
        shift(value, -self.decade) / self.mantissa
    }

    /// An SI value in this unit, as the shortest decimal that reads back to the same SI value.
    ///
    /// ```
    /// use gyrospec::units::Unit;
    /// let unit = Unit::parse("deg")?;
    /// assert_eq!(unit.decimal_from_si(unit.to_si(46.7)), 46.7);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn decimal_from_si(&self, value: f64) -> f64 {
        let near = self.from_si(value);
        let digits = [14, 15, 16];
        let candidates = digits.iter().filter_map(|d| format!("{near:.d$e}").parse::<f64>().ok());
        candidates.into_iter().find(|c| self.to_si(*c) == value).unwrap_or(near)
    }

    /// The dimension; angles count as 1.
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// The lowest value in SI that means anything: absolute zero of a temperature scale with a zero of its own,
    /// else none.
    ///
    /// ```
    /// use gyrospec::units::Unit;
    /// assert_eq!(Unit::parse("degC")?.lowest(), 0.0);
    /// assert_eq!(Unit::parse("K")?.lowest(), f64::NEG_INFINITY, "a difference may be meant");
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn lowest(&self) -> f64 {
        if self.offset == 0.0 { f64::NEG_INFINITY } else { 0.0 }
    }

    /// The unit of differences of values in this unit: K for degC, else the unit itself.
    #[must_use]
    pub fn of_differences(&self) -> Self {
        if self.offset == 0.0 { self.clone() } else { Self::of(self.dimension) }
    }

    /// The text as written, in the names of the list.
    pub fn text(&self) -> &str {
        &self.text
    }
}

/// x·10ᵈ with a single rounding where 10^|d| is exact.
fn shift(x: f64, decade: i32) -> f64 {
    if decade < 0 { x / 10f64.powi(-decade) } else { x * 10f64.powi(decade) }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl std::str::FromStr for Unit {
    type Err = crate::Error;
    fn from_str(text: &str) -> Result<Self> {
        Self::parse(text)
    }
}

#[cfg(test)]
mod tests;
