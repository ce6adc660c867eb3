//! A channel that is slower than the rows of its table.
//!
//! Loggers write one row for each sample of the fastest sensor, and leave the cells of the others blank until they have a
//! value. Such blanks are no gaps: nothing was lost. The channel keeps the rows that hold its samples, as if it had a
//! table of its own; where it skips more than that, its times are far apart, which is a gap as in any other channel.

use super::Channel;
use std::sync::Arc;

/// So many samples tell a pace; fewer, down to the second, where every step is at it and they fill the table.
const FEWEST: (usize, usize) = (8, 3);
/// The share of the steps, in per cent, that must be at the pace.
const STEADY: usize = 90;

/// The channel, without the blanks between its samples where these come at a pace of two rows or more: nine of ten steps
/// are two rows or longer, and within one row, or a tenth, of the median; of fewer than eight samples all, from the first rows
/// of the table to its last.
///
/// ```
/// use gyrospec::{record::{Channel, at_its_pace}, units::Unit};
/// let time: Vec<f64> = (0..60).map(f64::from).collect();
/// let values = (0..60).map(|i| if i % 3 == 0 { f64::from(i) } else { f64::NAN }).collect();
/// let slower = at_its_pace(Channel::new("level", Unit::parse("m")?, time, values));
/// assert_eq!((slower.len(), slower.time[1], slower.values[1]), (20, 3.0, 3.0));
/// // five samples that fill a table are as slow; five at its beginning are an output that ends
/// let of = |every: usize| {
///     let kept = move |i: usize| if i % every == 0 && i / every < 5 { 1.0 } else { f64::NAN };
///     at_its_pace(Channel::new("level", Unit::one(), (0..60).map(f64::from).collect::<Vec<_>>(), (0..60).map(kept).collect()))
/// };
/// assert_eq!((of(12).len(), of(3).len()), (5, 60));
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[must_use]
pub fn at_its_pace(channel: Channel) -> Channel {
    let rows: Vec<usize> = (0..channel.values.len()).filter(|i| !channel.values[*i].is_nan()).collect();
    if rows.len() < FEWEST.1 || rows.len() * 2 > channel.values.len() + 1 {
        return channel;
    }
    let mut steps: Vec<usize> = rows.windows(2).map(|w| w[1] - w[0]).collect();
    let middle = steps.len() / 2;
    let pace = *steps.select_nth_unstable(middle).1;
    let near = |step: &&usize| **step > 1 && step.abs_diff(pace) <= (pace / 10).max(1);
    let steady = if rows.len() < FEWEST.0 { 100 } else { STEADY };
    let fills = rows.len() >= FEWEST.0 || rows.len() * pace + pace > channel.values.len();
    if pace < 2 || !fills || steps.iter().filter(near).count() * 100 < steps.len() * steady {
        return channel;
    }
    let time: Arc<[f64]> = rows.iter().map(|i| channel.time[*i]).collect();
    let values = rows.iter().map(|i| channel.values[*i]).collect();
    Channel { time, values, ..channel }
}
