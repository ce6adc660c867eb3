//! Turns or radians: what a unit of dimension 1/s says of something that goes round.
//!
//! Angles count as 1 in a dimension, so that `rad/s`, `1/s`, `Hz` and `1/min` have one dimension. Of a shaft that
//! turns, `1/min` means turns to one reader and radians to the next, which differ by 2π: that is asked, not guessed.

use super::counts::Counts;
use super::{Dimension, Ratio, Unit};
use crate::{Error, ErrorKind, Result};

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

/// The dimensions of an angular speed and of an angular acceleration.
fn is_rate(d: Dimension) -> bool {
    let rate = Dimension::NONE.over(Dimension::TIME);
    [rate, rate.over(Dimension::TIME)].contains(&d)
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
        if !is_rate(self.dimension) {
            Turning::Open
        } else if self.angle != Ratio::ZERO {
            Turning::Angle
        } else if self.counts.turns != Ratio::ZERO {
            Turning::Turns
        } else if self.counts.events != Ratio::ZERO || self.difference_to_si(1.0) != 1.0 {
            Turning::Events
        } else {
            Turning::Open
        }
    }

    /// Whether it is a unit of an angle and of nothing else, in parts of a turn; whole turns are counted.
    ///
    /// ```
    /// use gyrospec::units::Unit;
    /// let of = |text| Unit::parse(text).map(|u| u.is_angle());
    /// assert!(of("deg")? && of("°")? && of("arcmin")? && of("mrad")?);
    /// assert!(!of("1")? && !of("%")? && !of("rad/s")? && !of("rev")? && !of("rad^2")?);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn is_angle(&self) -> bool {
        self.dimension == Dimension::NONE && self.angle == Ratio::ONE && self.counts == Counts::NOTHING
    }

    /// The power of an angle that its names say, `rad` or `rev`; none where they say nothing of an angle.
    ///
    /// ```
    /// use gyrospec::units::{Ratio, Unit};
    /// let of = |text| Unit::parse(text).map(|u| u.angle_power());
    /// assert_eq!(of("N*m*s/rad")?, Ratio::new(-1, 1));
    /// assert_eq!(of("rev/(min*V)")?, Ratio::new(1, 1));
    /// assert_eq!(of("N*m*s")?, None);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn angle_power(&self) -> Option<Ratio> {
        let said = [self.angle, self.counts.turns].iter().any(|p| *p != Ratio::ZERO);
        said.then(|| self.angle.plus(self.counts.turns))
    }

    /// Whether values of a quantity that holds this power of an angle may be meant in turns where the unit says
    /// nothing of an angle: where it counts by `Hz`, or by a clock of minutes, hours or days, in the place of the
    /// angle's time.
    ///
    /// ```
    /// use gyrospec::units::{Ratio, Unit};
    /// let of = |text| Unit::parse(text).map(|u| u.may_count_turns(Ratio::ONE));
    /// assert!(of("1/(min*V)")? && of("Hz/V")?);
    /// assert!(!of("1/(s*V)")? && !of("rad/(min*V)")? && !of("min")?);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn may_count_turns(&self, angle: Ratio) -> bool {
        let against = |p: Ratio| p.to_f64() * angle.to_f64() < 0.0;
        let counted = if is_rate(self.dimension) {
            self.turning() == Turning::Events && angle.to_f64() > 0.0
        } else {
            against(self.counts.clock) || against(self.counts.events.negative())
        };
        counted && self.angle_power().is_none()
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
    /// let gain = Unit::parse("rad/(s*V)")?;
    /// assert!(gain.turns_or_radians(&Unit::parse("rpm/V")?).is_ok());
    /// assert!(gain.turns_or_radians(&Unit::parse("Hz/V")?).is_err());
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn turns_or_radians(&self, given: &Self) -> Result<()> {
        let agrees = if is_rate(self.dimension) {
            let turns = self.turning() == Turning::Turns && given.counts.rpm != Ratio::ZERO;
            turns || self.turning().agrees(given.turning())
        } else {
            !self.angle_power().is_some_and(|p| given.may_count_turns(p))
                && !given.angle_power().is_some_and(|p| self.may_count_turns(p))
        };
        if agrees {
            return Ok(());
        }
        let message = format!("{given} is given where {self} is meant: are these turns or radians?");
        Err(Error::new(ErrorKind::Units, message).with_hint(self.answers(given)))
    }

    /// Whether values in a unit that says nothing of an angle are taken as radians a second for this one, an angular
    /// speed or acceleration: `1/s` for `rpm`.
    ///
    /// ```
    /// use gyrospec::units::Unit;
    /// let speed = Unit::parse("rpm")?;
    /// assert!(speed.takes_as_radians(&Unit::parse("1/s")?));
    /// assert!(!speed.takes_as_radians(&Unit::parse("rad/s")?));
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn takes_as_radians(&self, given: &Self) -> bool {
        is_rate(given.dimension) && self.turning() == Turning::Angle && given.turning() == Turning::Open
    }

    /// Whether `Hz` stands in it.
    pub fn counts_events(&self) -> bool {
        self.counts.events != Ratio::ZERO
    }

    /// The question about a quantity in this unit that holds a power of an angle by its place in a model.
    ///
    /// ```
    /// use gyrospec::units::{Ratio, Unit};
    /// let e = Unit::parse("1/(min*V)")?.asked_by_place(Ratio::ONE);
    /// assert!(e.message().ends_with("are these turns or radians?"));
    /// assert_eq!(e.hint(), Some("for radians write rad/(min*V), for turns rev/(min*V)"));
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn asked_by_place(&self, angle: Ratio) -> Error {
        let message = format!(
            "by its place in the equations this counts an angle, and {self} says nothing of one: are these turns or \
             radians?"
        );
        Error::new(ErrorKind::Units, message).with_hint(self.with_angles(angle))
    }

    /// How to write this unit with radians and with turns.
    fn with_angles(&self, angle: Ratio) -> String {
        if is_rate(self.dimension) {
            return "for radians write rad/s or rad/min, for turns rpm (60 rpm are one turn a second)".into();
        }
        let size = angle.to_f64().abs();
        let power = if size == 1.0 { String::new() } else { format!("^{size}") };
        let spelt = |name: &str| match self.text.strip_prefix("1/") {
            _ if angle.to_f64() < 0.0 => format!("{self}/{name}{power}"),
            Some(rest) => format!("{name}{power}/{rest}"),
            None => format!("{name}{power}*{self}"),
        };
        format!("for radians write {}, for turns {}", spelt("rad"), spelt("rev"))
    }

    /// How to say which of the two is meant.
    fn answers(&self, given: &Self) -> String {
        let clock = given.counts.events == Ratio::ZERO && given.counts.turns == Ratio::ZERO;
        let minutes = clock && given.difference_to_si(60.0) == 1.0;
        match (self.turning(), minutes) {
            _ if !is_rate(self.dimension) => match (self.angle_power(), given.angle_power()) {
                (Some(p), _) => given.with_angles(p),
                (None, p) => self.with_angles(p.unwrap_or(Ratio::ONE)),
            },
            (Turning::Angle, true) => "for turns a minute write rpm, for radians a minute rad/min".into(),
            (Turning::Angle, false) => {
                "for radians a second write rad/s; for turns a second write rev/s in both places, or give turns a \
                 minute as rpm"
                    .into()
            }
            (Turning::Turns, _) if given.angle != Ratio::ZERO => {
                "write a unit of the same sort in both places: rev/s or rpm for turns, rad/s or deg/s for radians".into()
            }
            _ => "write a unit of the same sort in both places: rpm, deg/s or rad/s for the speed of what turns, Hz \
                  or 1/min for how often something happens"
                .into(),
        }
    }
}
