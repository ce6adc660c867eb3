//! The mesh of a run: the times at which an input bends or jumps, with the inputs' values there.
//!
//! Between two mesh times every input is a straight line, so a step of the solver never crosses
//! a kink of the data.

use super::table::Tables;
use crate::record::{Channel, Hold};
use std::sync::Arc;

/// The samples of one input, gaps left out.
#[derive(Debug, Clone)]
pub(super) struct Samples {
    pub time: Arc<[f64]>,
    pub values: Arc<[f64]>,
    pub hold: Hold,
    /// Stretches without samples that are much longer than the usual step, s.
    pub gaps: Vec<(f64, f64)>,
}

/// A gap is a stretch of missing samples longer than this many usual steps, and than an uneven clock makes by chance.
pub const GAP_STEPS: f64 = 3.5;

impl Samples {
    pub fn of(channel: &Channel) -> Self {
        let missing = channel.values.iter().any(|v| v.is_nan());
        let (time, values): (Arc<[f64]>, Arc<[f64]>) = if missing {
            let (t, v): (Vec<f64>, Vec<f64>) = channel.samples().unzip();
            (t.into(), v.into())
        } else {
            (channel.time.clone(), channel.values.as_slice().into())
        };
        Self { time, values, hold: channel.hold, gaps: channel.gaps(GAP_STEPS) }
    }

    pub fn range(&self) -> Option<(f64, f64)> {
        Some((*self.time.first()?, *self.time.last()?))
    }

    /// A sample where a time agrees with its own to rounding, so that a 0 stays 0; else a value
    /// that was found on the line.
    fn exactly(&self, sample: usize, t: f64, on_the_line: f64) -> f64 {
        match self.time.get(sample) {
            Some(own) if (own - t).abs() <= SAME * t.abs() => self.values[sample],
            _ => on_the_line,
        }
    }

    /// Value and slope at a time, just after it where the input jumps there, or just before if it is set after what is
    /// measured then; the end values beyond the ends. `near` is where to look first.
    pub fn at(&self, t: f64, near: &mut usize) -> (f64, f64) {
        let n = self.time.len();
        let mut i = (*near).min(n - 1);
        if self.time[i] > t || (i + 8 < n && self.time[i + 8] <= t) {
            i = self.time.partition_point(|x| *x <= t).saturating_sub(1);
        }
        while i + 1 < n && self.time[i + 1] <= t {
            i += 1;
        }
        *near = i;
        if self.hold == Hold::AfterReading && i > 0 && t - self.time[i] <= SAME * t.abs() {
            return (self.values[i - 1], 0.0);
        }
        if i + 1 == n || t < self.time[0] || self.hold.is_held() {
            return (self.values[i], 0.0);
        }
        let slope = (self.values[i + 1] - self.values[i]) / (self.time[i + 1] - self.time[i]);
        let into = t - self.time[i];
        (if into == 0.0 { self.values[i] } else { self.values[i] + slope * into }, slope)
    }
}

/// Times that agree to this share of their size are the same.
const SAME: f64 = 1e-12;

/// One column of a mesh: an input, shifted by a delay in seconds.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shifted {
    pub input: usize,
    pub delay: f64,
}

/// The mesh, with start value and slope of every column on every interval.
#[derive(Debug, Default)]
pub(super) struct Mesh {
    pub time: Vec<f64>,
    pub columns: usize,
    /// Interval by interval, column by column.
    pub start: Vec<f64>,
    pub end: Vec<f64>,
    pub slope: Vec<f64>,
    /// Whether a held input jumps at the start of the interval.
    pub jumps: Vec<bool>,
    /// Whether what is measured at that moment sees it; one more for the end of the last interval.
    pub shows: Vec<bool>,
    /// What is measured at the end of the last interval sees of the columns.
    pub last: Vec<f64>,
    /// Whether a column is set after what is measured at its samples.
    pub late: Vec<bool>,
    /// The usual length of an interval, s.
    pub usual: f64,
    /// What the inputs alone make, for the programs of the mesh's owner.
    pub tables: Tables,
}

impl Mesh {
    /// The mesh of columns over a span; `others` are further times where steps must end.
    pub fn new(samples: &[Samples], columns: &[Shifted], span: (f64, f64), others: &[f64]) -> Self {
        let mut time: Vec<f64> = vec![span.0, span.1];
        let inside = |t: &f64| *t > span.0 && *t < span.1;
        for c in columns {
            let s = &samples[c.input];
            let shifted = s.time.iter().map(|t| t + c.delay).filter(inside);
            time = merged(&time, &shifted.collect::<Vec<f64>>());
        }
        time = merged(&time, &others.iter().copied().filter(inside).collect::<Vec<f64>>());
        // a time that agrees with the end of the span gives way to it: the last output may lie there
        if let Some(last) = time.last_mut() {
            *last = span.1;
        }
        let late = columns.iter().map(|c| samples[c.input].hold == Hold::AfterReading).collect();
        let mut mesh = Self { columns: columns.len(), time, late, ..Self::default() };
        mesh.fill(samples, columns);
        mesh
    }

    fn fill(&mut self, samples: &[Samples], columns: &[Shifted]) {
        let mut near = vec![0; columns.len()];
        let intervals = self.time.len() - 1;
        self.start.reserve(intervals * columns.len());
        self.end.reserve(intervals * columns.len());
        self.slope.reserve(intervals * columns.len());
        for i in 0..intervals {
            let (mut jumps, mut shows) = (false, false);
            for (c, column) in columns.iter().enumerate() {
                let s = &samples[column.input];
                // Rounding must not put a shifted sample on the wrong side of its own mesh time.
                let t = 0.5 * (self.time[i] + self.time[i + 1]) - column.delay;
                let (middle, slope) = s.at(t, &mut near[c]);
                let half = 0.5 * (self.time[i + 1] - self.time[i]);
                let value = s.exactly(near[c], self.time[i] - column.delay, middle - slope * half);
                let end = s.exactly(near[c] + 1, self.time[i + 1] - column.delay, middle + slope * half);
                let before = self.start.len().checked_sub(columns.len()).map(|k| self.start[k]);
                let leaps = s.hold.is_held() && before.is_some_and(|b| b != value);
                (jumps, shows) = (jumps || leaps, shows || leaps && !self.late[c]);
                self.start.push(value);
                self.end.push(if s.hold.is_held() { value } else { end });
                self.slope.push(slope);
            }
            self.jumps.push(jumps);
            self.shows.push(shows);
        }
        let end = self.time[intervals];
        let seen =
            |(c, column): (usize, &Shifted)| samples[column.input].at(end - column.delay, &mut near[c]).0;
        self.last = columns.iter().enumerate().map(seen).collect();
        let ends = self.end[self.end.len() - columns.len()..].iter().zip(&self.last);
        let leaps =
            |(c, (end, last)): (usize, (&f64, &f64))| samples[columns[c].input].hold.is_held() && end != last;
        self.shows.push(ends.enumerate().any(leaps));
        let mut lengths: Vec<f64> = self.time.windows(2).map(|w| w[1] - w[0]).collect();
        if !lengths.is_empty() {
            let middle = lengths.len() / 2;
            self.usual = *lengths.select_nth_unstable_by(middle, f64::total_cmp).1;
        }
    }

    pub fn intervals(&self) -> usize {
        self.time.len() - 1
    }
}

/// Both rising lists in one, times that agree to rounding once.
fn merged(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut out = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let from_a = j == b.len() || (i < a.len() && a[i] <= b[j]);
        let t = if from_a { a[i] } else { b[j] };
        if from_a {
            i += 1;
        } else {
            j += 1;
        }
        match out.last() {
            Some(last) if t - last <= SAME * f64::abs(t) => {}
            _ => out.push(t),
        }
    }
    out
}
