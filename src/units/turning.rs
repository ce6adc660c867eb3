//! Turns or radians: what a unit of dimension 1/s says of something that goes round.
//!
//! Angles count as 1 in a dimension, so that `rad/s`, `1/s`, `Hz` and `1/min` have one dimension. Of a shaft that
//! turns, `1/min` means turns to one reader and radians to the next, which differ by 2π: that is asked, not guessed.

use super::{Dimension, Ratio, Unit};
use crate::{Error, ErrorKind, Result};

/// What a unit counts apart from its dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Counts {
    Nothing,
    /// `Hz`.
    Events,
    /// `rev`.
    Turns,
}

impl Counts {
    /// What a name of the list counts.
    pub(super) fn of(name: &str) -> Self {
        match name {
            "rev" => Self::Turns,
            _ if name.ends_with("Hz") => Self::Events,
            _ => Self::Nothing,
        }
    }

    /// What a product counts.
    pub(super) fn with(self, other: Self) -> Self {
        if self == Self::Nothing { other } else { self }
    }
}

/// What a unit of an angular speed or acceleration, or of a frequency, counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turning {
    /// An angle: `rad/s`, `deg/s`, `rpm`.
    Angle,
    /// Events, or nobody knows what: `Hz`, `1/min`.
    Events,
    /// Turns: `rev/s`.
    Turns,
    /// Every other unit, and `1/s`, which is `rad/s` in SI and the unit of a rate constant as well.
    Open,
}

impl Turning {
    /// Whether values of the one may stand for values of the other without a question.
    pub fn agrees(self, other: Self) -> bool {
        self == other || [self, other].contains(&Self::Open) && ![self, other].contains(&Self::Turns)
    }
}

impl Unit {
    /// What it counts where it is a unit of an angular speed, an angular acceleration, or a frequency.
    ///
    /// ```
    /// use gyrospec::units::{Turning, Unit};
    /// let of = |text| Unit::parse(text).map(|u| u.turning());
    /// assert_eq!(of("rpm")?, Turning::Angle);
    /// assert_eq!(of("1/min")?, Turning::Events);
    /// assert_eq!(of("1/s")?, Turning::Open);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn turning(&self) -> Turning {
        let rate = Dimension::NONE.over(Dimension::TIME);
        if ![rate, rate.over(Dimension::TIME)].contains(&self.dimension) {
            Turning::Open
        } else if self.angle != Ratio::ZERO {
            Turning::Angle
        } else if self.counts == Counts::Turns {
            Turning::Turns
        } else if self.counts == Counts::Events || self.difference_to_si(1.0) != 1.0 {
            Turning::Events
        } else {
            Turning::Open
        }
    }

    /// Refuses values in a unit that may mean turns where this unit means radians, or the other way round.
    ///
    /// # Errors
    /// `Units`, with the question and how to answer it.
    ///
    /// ```
    /// use gyrospec::units::Unit;
    /// let speed = Unit::parse("rad/s")?;
    /// assert!(speed.turns_or_radians(&Unit::parse("rpm")?).is_ok());
    /// assert!(speed.turns_or_radians(&Unit::parse("1/min")?).is_err());
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn turns_or_radians(&self, given: &Self) -> Result<()> {
        if self.turning().agrees(given.turning()) {
            return Ok(());
        }
        let message = format!("{given} is given where {self} is meant: are these turns or radians?");
        Err(Error::new(ErrorKind::Units, message).with_hint(self.answers(given)))
    }

    /// How to say which of the two is meant.
    fn answers(&self, given: &Self) -> String {
        let minutes = given.counts == Counts::Nothing && given.difference_to_si(60.0) == 1.0;
        match (self.turning(), minutes) {
            (Turning::Angle, true) => "for turns a minute write rpm, for radians a minute rad/min".into(),
            (Turning::Angle, false) => {
                "for radians a second write rad/s; for turns a second write rev/s in both places, or give turns a \
                 minute as rpm"
                    .into()
            }
            _ => "write a unit of the same sort in both places: rpm, deg/s or rad/s for the speed of what turns, Hz \
                  or 1/min for how often something happens"
                .into(),
        }
    }
}
