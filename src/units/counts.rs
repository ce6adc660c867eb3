//! What the names of a unit count.

use super::Ratio;

/// The powers of what the names of a unit count, which its dimension leaves out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Counts {
    /// Of `Hz`.
    pub(super) events: Ratio,
    /// Of `min`, `h` and `d`: a clock by which people count turns.
    pub(super) clock: Ratio,
    /// Of `rev`.
    pub(super) turns: Ratio,
    /// Of `rpm`, an angular speed that counts turns.
    pub(super) rpm: Ratio,
}

impl Counts {
    /// Of a unit that counts nothing.
    pub(super) const NOTHING: Self =
        Self { events: Ratio::ZERO, clock: Ratio::ZERO, turns: Ratio::ZERO, rpm: Ratio::ZERO };

    /// What a name of the list counts.
    pub(super) fn of(name: &str) -> Self {
        let none = Self::NOTHING;
        match name {
            "rev" => Self { turns: Ratio::ONE, ..none },
            "rpm" => Self { rpm: Ratio::ONE, ..none },
            "min" | "h" | "d" => Self { clock: Ratio::ONE, ..none },
            _ if name.ends_with("Hz") => Self { events: Ratio::ONE, ..none },
            _ => none,
        }
    }

    /// What a product with a power of another unit counts.
    pub(super) fn with(self, other: Self, power: Ratio) -> Self {
        let sum = |a: Ratio, b: Ratio| a.plus(b.times(power));
        Self {
            events: sum(self.events, other.events),
            clock: sum(self.clock, other.clock),
            turns: sum(self.turns, other.turns),
            rpm: sum(self.rpm, other.rpm),
        }
    }
}
