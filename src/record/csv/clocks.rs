//! Clocks side by side in one table: `t1,F,t2,x`, where each signal stands behind times of its own.
//!
//! Loggers and scopes write so what they sampled apart. A row is then no moment: what stands in one line happened at
//! different times. A column of time with channels before and behind it, which rises where it has numbers and does not
//! go with the first clock, is the clock of what follows it.

use super::header::Column;
#[cfg(feature = "diagnose")]
use super::look::Raw;
use crate::units::Dimension;
#[cfg(feature = "diagnose")]
use crate::units::Unit;
use crate::{Error, Result};
use std::ops::Range;

/// So many times make a clock.
const FEWEST: usize = 3;

/// A clock and the columns that stand on it.
pub(crate) struct Side {
    /// The column that is its clock; none for the first clock of the table.
    pub clock: Option<usize>,
    pub columns: Range<usize>,
}

/// Which channels may be clocks of what follows them, by their units alone.
pub(super) fn may_be(channels: &[Column]) -> impl Iterator<Item = usize> + '_ {
    let inner = 1..channels.len().saturating_sub(1);
    inner.filter(|i| channels[*i].unit.dimension() == Dimension::TIME)
}

/// The clocks of so many columns behind that of time: `time` itself and, of the columns that `may_be` one, what is.
/// Times in s.
pub(super) fn sides(
    time: &[f64],
    count: usize,
    may_be: impl Iterator<Item = usize>,
    own: impl Fn(usize) -> Vec<f64>,
) -> Vec<Side> {
    let mut sides = vec![Side { clock: None, columns: 0..count }];
    for i in may_be {
        let begun = sides.last().map_or(0, |s| s.columns.start);
        let times = own(i);
        if begun < i && i + 1 < count && is_clock(&times) && !go_together(time, &times) {
            if let Some(last) = sides.last_mut() {
                last.columns.end = i;
            }
            sides.push(Side { clock: Some(i), columns: i + 1..count });
        }
    }
    sides
}

/// The clocks of a table that nobody has told of: that of column `first`, and those of its name (`t1`, `t2`) or that
/// `is_time` takes for one. The numbers of columns are those of the table.
#[cfg(feature = "diagnose")]
pub(crate) fn of_raw(columns: &[Raw], first: usize, is_time: impl Fn(&Raw) -> bool) -> Vec<Side> {
    let seconds = |i: usize| {
        let unit = columns[i].unit.as_ref().and_then(|u| Unit::parse(u).ok());
        let si = |t: &f64| unit.as_ref().map_or(*t, |u| u.to_si(*t));
        columns[i].values.iter().map(si).collect::<Vec<f64>>()
    };
    if columns[first].since.is_some() {
        return vec![Side { clock: Some(first), columns: 0..columns.len() }];
    }
    let stem = |c: &Raw| c.name.trim_end_matches(|c: char| !c.is_alphabetic()).to_lowercase();
    let may_be = |i: &usize| stem(&columns[*i]) == stem(&columns[first]) || is_time(&columns[*i]);
    let mut sides = sides(&seconds(first), columns.len(), (first + 2..columns.len()).filter(may_be), seconds);
    sides[0].clock = Some(first);
    sides
}

/// Whether numbers rise wherever there are any.
fn is_clock(own: &[f64]) -> bool {
    let mut there = own.iter().filter(|t| !t.is_nan());
    let count = there.clone().count();
    let mut last = there.next();
    let rises = there.all(|t| last.replace(t).is_some_and(|l| l < t));
    rises && count >= FEWEST
}

/// Whether two clocks tell the same moments from two zeros: half a usual step apart at most.
fn go_together(one: &[f64], other: &[f64]) -> bool {
    let both = || one.iter().zip(other).filter(|(a, b)| !a.is_nan() && !b.is_nan());
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for (a, b) in both() {
        (low, high) = (low.min(b - a), high.max(b - a));
    }
    let alone = one.iter().zip(other).any(|(a, b)| a.is_nan() != b.is_nan());
    let mut steps: Vec<f64> =
        both().map(|(a, _)| *a).collect::<Vec<_>>().windows(2).map(|w| w[1] - w[0]).collect();
    if alone || steps.is_empty() {
        return false;
    }
    let middle = steps.len() / 2;
    high - low <= 0.5 * *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// The rows of a side that have a time.
///
/// # Errors
/// `BadInput` where a value has none.
pub(super) fn rows(name: &str, time: &[f64], columns: &[Vec<f64>]) -> Result<Vec<usize>> {
    let untimed = |i: &usize| time[*i].is_nan() && columns.iter().any(|c| !c[*i].is_nan());
    if let Some(row) = (0..time.len()).find(untimed) {
        return Err(Error::bad_input(format!(
            "row {} below the header has values and no time in `{name}`",
            row + 1
        ))
        .with_hint("remove rows without a time; values may be empty, times may not"));
    }
    Ok((0..time.len()).filter(|i| !time[*i].is_nan()).collect())
}
