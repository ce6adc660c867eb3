//! Recordings: CSV, NMEA 0183, gaps, rates, angle wrapping, clocks.
//!
//! A [`Recording`] holds [`Channel`]s: named rows of numbers in SI and radians, each with the
//! times at which they were taken. Tables of different rates lie side by side on one clock; a
//! gap is a NaN. A recording of steady trials has row numbers for times.

mod recording;
mod spans;

pub use recording::{Channel, Constant, Hold, Kind, Note, Recording, Source};
pub use spans::{DEFAULT_FIT_SHARE, Span, Spans};
