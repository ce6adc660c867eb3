//! Which part of a recording is fitted and which is held out.

use crate::Error;

/// The share of a recording's time that is fitted where nothing else is said; the rest, at its
/// end, is held out.
pub const DEFAULT_FIT_SHARE: f64 = 0.6;

/// A span of time in seconds of the recording's own clock, or of row numbers in a table of
/// trials; both ends belong to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// First time or row.
    pub from: f64,
    /// Last time or row.
    pub to: f64,
}

impl Span {
    /// The span between two times.
    pub const fn new(from: f64, to: f64) -> Self {
        Self { from, to }
    }

    /// Whether a time lies in the span, ends included.
    ///
    /// ```
    /// use gyrospec::record::Span;
    /// assert!(Span::new(0.0, 2.0).contains(2.0));
    /// assert!(!Span::new(0.0, 2.0).contains(2.1));
    /// ```
    pub fn contains(&self, time: f64) -> bool {
        (self.from..=self.to).contains(&time)
    }

    /// Its length; s, or rows less one.
    pub fn length(&self) -> f64 {
        self.to - self.from
    }

    /// The error of a span that would be `used` twice: "fitted", "held out".
    pub fn twice(&self, used: &str) -> Error {
        Error::bad_input(format!("{} to {} would be {used} twice", self.from, self.to))
            .with_hint("it tells nothing new the second time: give it once")
    }

    /// What two spans share with a positive length.
    pub fn overlap(&self, other: &Self) -> Option<Self> {
        let both = Self::new(self.from.max(other.from), self.to.min(other.to));
        (both.from < both.to).then_some(both)
    }
}

/// The fitted and the held-out spans of a recording, in order of time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Spans {
    /// Spans that are fitted.
    pub fit: Vec<Span>,
    /// Spans that are held out for the proof.
    pub holdout: Vec<Span>,
    /// Whether the recording's file says so; if not, the defaults of
    /// [`Recording::spans_for`](super::Recording::spans_for) hold.
    pub given: bool,
}

impl Spans {
    /// Everything between two times is fitted, nothing held out.
    pub fn whole(range: Span) -> Self {
        Self { fit: vec![range], holdout: Vec::new(), given: false }
    }

    /// The last 40 % of the time is held out.
    ///
    /// ```
    /// use gyrospec::record::{Span, Spans};
    /// let s = Spans::by_default(Span::new(0.0, 100.0));
    /// assert_eq!(s.holdout, [Span::new(60.0, 100.0)]);
    /// ```
    pub fn by_default(range: Span) -> Self {
        let cut = range.from + DEFAULT_FIT_SHARE * range.length();
        Self { fit: vec![Span::new(range.from, cut)], holdout: vec![Span::new(cut, range.to)], given: false }
    }

    /// Whether a time is fitted; an end shared with a held-out span is.
    pub fn fits(&self, time: f64) -> bool {
        self.fit.iter().any(|s| s.contains(time))
    }

    /// Whether a time is held out; an end shared with a fitted span is not.
    pub fn holds_out(&self, time: f64) -> bool {
        !self.fits(time) && self.holdout.iter().any(|s| s.contains(time))
    }
}
