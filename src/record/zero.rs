//! The moment that the times of a table count from, where they were dates or clocks.

/// The zero of a table's time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Zero {
    /// Nanoseconds since 1970, leap seconds included, or since midnight.
    pub nano: i128,
    /// Whether it has a date.
    pub is_dated: bool,
    /// Whether it has a zone, where that matters.
    pub zoned: Option<bool>,
    /// Whether day and month of it are not known.
    pub is_open: bool,
    /// The row's own words.
    pub text: String,
}

impl Zero {
    /// Whether a moment with or without a date, and with or without a zone, cannot be counted from it.
    pub(super) fn is_unlike(&self, is_dated: bool, zoned: Option<bool>) -> bool {
        self.is_dated != is_dated || self.zoned.zip(zoned).is_some_and(|(a, b)| a != b)
    }

    /// Seconds from another zero to this one; none where they have no clock in common.
    #[cfg(feature = "diagnose")]
    pub(crate) fn seconds_after(&self, other: &Self) -> Option<f64> {
        let is_unlike = other.is_unlike(self.is_dated, self.zoned) || self.is_open || other.is_open;
        (!is_unlike).then(|| (self.nano - other.nano) as f64 * 1e-9)
    }
}

#[cfg(all(test, feature = "diagnose"))]
mod tests {
    use super::*;

    #[test]
    fn zeros_of_one_kind_lie_their_seconds_apart_and_others_nowhere() {
        let at = |nano, is_dated, zoned| Zero { nano, is_dated, zoned, is_open: false, text: String::new() };
        let noon = at(43_200_000_000_000, true, Some(true));
        let later = at(43_202_500_000_000, true, Some(true));
        assert_eq!((later.seconds_after(&noon), noon.seconds_after(&later)), (Some(2.5), Some(-2.5)));
        assert_eq!(at(0, true, Some(false)).seconds_after(&noon), None);
        assert_eq!(at(0, false, Some(true)).seconds_after(&noon), None);
        // a log says nothing of zones: it is in UTC
        assert_eq!(at(43_200_000_000_000, true, None).seconds_after(&noon), Some(0.0));
        let open = Zero { is_open: true, ..noon.clone() };
        assert_eq!((open.seconds_after(&noon), noon.seconds_after(&open)), (None, None));
    }
}
