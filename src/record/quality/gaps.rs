//! Purpose: where samples are missing.
//!
//! Method: runs of NaN, and steps of time that are long against the others: more than 2.5 times
//! the median and longer than a clock which is merely uneven makes by chance.

use super::{Fault, FaultKind, quantile, steps};
use crate::record::{Channel, Span};

const LONG_AGAINST_MEDIAN: f64 = 2.5;

/// The gaps of a channel: spans from the last sample before to the first after; `size` is the
/// longest, s. Sure where more than a tenth of the samples is lost, or a stretch of more than a
/// thirtieth and twenty samples: less does not harm a fit.
pub fn gaps(channel: &Channel) -> Option<Fault> {
    let time = &channel.time;
    let usual = quantile(steps(time), 0.5)?;
    let long = channel.longest_step(LONG_AGAINST_MEDIAN);
    let mut spans = Vec::new();
    let mut missing = 0;
    let mut last: Option<usize> = None;
    for (i, value) in channel.values.iter().enumerate() {
        if value.is_nan() {
            continue;
        }
        let from = last.map_or(time[0], |l| time[l]);
        let empty = i - last.map_or(0, |l| l + 1);
        if empty > 0 || time[i] - from > long {
            spans.push(Span::new(from, time[i]));
            missing += empty.max(((time[i] - from) / usual).round() as usize - 1);
        }
        last = Some(i);
    }
    let end = last.map_or(0, |l| l + 1);
    if end < time.len() {
        spans.push(Span::new(time[end.saturating_sub(1)], time[time.len() - 1]));
        missing += time.len() - end;
    }
    if spans.is_empty() {
        return None;
    }
    let size = spans.iter().map(Span::length).fold(0.0, f64::max);
    let stretch = size > usual * 20.0 && size * 30.0 > time[time.len() - 1] - time[0];
    let sure = missing * 10 > time.len() || stretch;
    Some(Fault { samples: missing, size, sure, ..Fault::of(FaultKind::Gap, channel, spans) })
}
