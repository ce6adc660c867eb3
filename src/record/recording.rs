//! What a recording is: channels, spans, constants, sources, notes.

use super::spans::{Span, Spans};
use super::zero::Zero;
use crate::error::nearest;
use crate::units::{Dimension, Unit};
use crate::{Error, Result};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Whether rows follow each other in time.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Kind {
    /// Samples on a clock.
    #[default]
    Time,
    /// A table of steady trials: one row a trial.
    Trials,
}

/// How an input runs between its samples.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Hold {
    /// On the straight line between neighbours.
    #[default]
    Linear,
    /// On the previous sample until the next comes.
    Previous,
    /// As [`Hold::Previous`], and set from what is measured at the moment of the sample: what is measured then was still
    /// under the sample before.
    AfterReading,
}

impl Hold {
    /// Whether it stays on a sample until the next.
    pub fn is_held(self) -> bool {
        self != Self::Linear
    }
}

/// One measured signal.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Its name, by which models speak of it.
    pub name: String,
    /// The unit of the file; `values` are in SI nevertheless.
    pub unit: Unit,
    /// Whether the file's angle wraps at a turn; `values` are unwrapped.
    pub wraps: bool,
    /// How it runs between samples.
    pub hold: Hold,
    /// Number of the table that it comes from; channels of one table share a clock.
    pub table: usize,
    /// s of the recording's clock, strictly rising; row numbers in a table of trials.
    pub time: Arc<[f64]>,
    /// SI and radians, as many as times; NaN = gap.
    pub values: Vec<f64>,
}

impl Channel {
    /// A channel of given times (s) and values (SI); linear between its samples.
    ///
    /// ```
    /// use gyrospec::{record::Channel, units::Unit};
    /// let c = Channel::new("roll", Unit::parse("rad")?, vec![0.0, 0.5, 1.0], vec![0.1, 0.2, 0.1]);
    /// assert_eq!(c.value_at(0.25), Some(0.15000000000000002));
    /// assert_eq!(c.value_at(2.0), None);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn new(name: impl Into<String>, unit: Unit, time: impl Into<Arc<[f64]>>, values: Vec<f64>) -> Self {
        let (name, time) = (name.into(), time.into());
        Self { name, unit, wraps: false, hold: Hold::Linear, table: 0, time, values }
    }

    /// Number of samples, gaps included.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether it has no samples.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// First and last time; `None` for an empty channel.
    pub fn range(&self) -> Option<Span> {
        Some(Span::new(*self.time.first()?, *self.time.last()?))
    }

    /// The samples that are no gaps: (time, value).
    pub fn samples(&self) -> impl Iterator<Item = (f64, f64)> + Clone + '_ {
        self.time.iter().copied().zip(self.values.iter().copied()).filter(|(_, v)| !v.is_nan())
    }

    /// The median step between its times, s; `None` with fewer than two.
    pub fn median_step(&self) -> Option<f64> {
        let mut steps: Vec<f64> = self.time.windows(2).map(|w| w[1] - w[0]).collect();
        if steps.is_empty() {
            return None;
        }
        let middle = steps.len() / 2;
        Some(*steps.select_nth_unstable_by(middle, f64::total_cmp).1)
    }

    /// The longest step between its times that is no gap, s: so many usual ones, or what a clock as uneven as this makes by
    /// chance.
    pub(crate) fn longest_step(&self, usual: f64) -> f64 {
        let mut steps: Vec<f64> = self.time.windows(2).map(|w| w[1] - w[0]).collect();
        let Some(last) = steps.len().checked_sub(1) else { return 0.0 };
        let mut quantile = |i: usize| *steps.select_nth_unstable_by(i, f64::total_cmp).1;
        let [median, long] = [last.div_ceil(2), (0.9 * last as f64).round() as usize].map(&mut quantile);
        // P(step > x) = exp(-(x - median)/s)/2 beyond the median; of n steps the longest is beyond this once in a hundred times
        let s = (long - median) / 5.0f64.ln();
        let by_chance = median + s * (0.5 * steps.len() as f64 / 0.01).max(1.0).ln();
        by_chance.max(usual * median)
    }

    /// The samples on both sides of each stretch without any that is longer than [`Self::longest_step`], s.
    #[cfg(feature = "diagnose")]
    pub(crate) fn gaps(&self, usual: f64) -> Vec<(f64, f64)> {
        let longest = self.longest_step(usual);
        let after = self.samples().skip(1);
        let pairs = self.samples().zip(after).map(|(a, b)| (a.0, b.0));
        pairs.filter(|(from, to)| to - from > longest).collect()
    }

    /// The value at a time between its samples, by its [`Hold`]; `None` in a gap and outside.
    pub fn value_at(&self, time: f64) -> Option<f64> {
        if self.hold == Hold::AfterReading {
            let before = self.time.partition_point(|&t| t < time);
            if before > 0 && self.time.get(before) == Some(&time) {
                return Some(self.values[before - 1]).filter(|v| !v.is_nan());
            }
        }
        self.value_from(time)
    }

    /// The value from a time on: that of a sample at that time.
    pub(crate) fn value_from(&self, time: f64) -> Option<f64> {
        let next = self.time.partition_point(|&t| t <= time);
        let before = next.checked_sub(1)?;
        let (t0, v0) = (self.time[before], self.values[before]);
        let at = if t0 == time || (self.hold.is_held() && next < self.len()) {
            v0
        } else {
            let (t1, v1) = (*self.time.get(next)?, *self.values.get(next)?);
            v0 + (v1 - v0) * ((time - t0) / (t1 - t0))
        };
        (!at.is_nan()).then_some(at)
    }

    /// Its distinct values in rising order: the levels of an input of a table of trials.
    pub fn levels(&self) -> Vec<f64> {
        let mut levels: Vec<f64> = self.values.iter().copied().filter(|v| !v.is_nan()).collect();
        levels.sort_unstable_by(f64::total_cmp);
        levels.dedup();
        levels
    }
}

/// A constant that is known for a recording, by the name of the model's parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Constant {
    /// The parameter of the model, by name.
    pub name: String,
    /// Its value, SI.
    pub value: f64,
    /// The unit of the file.
    pub unit: Unit,
}

/// A file that a recording, or another input, was read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The path as it was opened.
    pub file: PathBuf,
    /// SHA-256 of the file's bytes as they lie on the disk, in hexadecimal.
    pub sha256: String,
}

impl Source {
    /// A file whose bytes were read already.
    pub fn of(path: &Path, bytes: &[u8]) -> Self {
        Self { file: path.to_owned(), sha256: super::packed::sha256(bytes) }
    }
}

/// Where a table's samples come from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Origin {
    /// The file, with the hash of what was read.
    pub source: Source,
    /// The row of the file that is the first sample.
    pub first_row: usize,
    /// Whether people count its rows; those of a log nobody does.
    pub is_table: bool,
}

/// How it is said that a column has no unit.
pub(super) const NO_UNIT: &str = "has no unit";

/// A column that is no channel, though every column was wanted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftOut {
    /// Its label.
    pub label: String,
    /// Why it is none.
    pub why: String,
    /// What to do.
    pub hint: Option<String>,
    /// The file.
    pub file: PathBuf,
    /// The line of the label, from 1.
    pub line: Option<usize>,
    /// Where the label begins in it, from 1.
    pub column: Option<usize>,
}

impl LeftOut {
    pub(super) fn of(label: &str, error: &Error) -> Self {
        Self {
            label: label.to_owned(),
            why: error.message().to_owned(),
            hint: error.hint().map(str::to_owned),
            file: PathBuf::new(),
            line: error.line(),
            column: error.column(),
        }
    }

    pub(super) fn in_file(self, file: &Path) -> Self {
        Self { file: file.to_owned(), ..self }
    }

    /// Whether a model's name means this column.
    pub(crate) fn is_named(&self, name: &str) -> bool {
        self.label == name || super::label::label(&self.label).name == name
    }

    /// Whether all that it lacks is a unit.
    #[cfg(feature = "diagnose")]
    pub(crate) fn has_no_unit(&self) -> bool {
        self.why.ends_with(NO_UNIT)
    }

    fn error(&self) -> Error {
        let error = Error::bad_input(self.why.clone()).with_file(&self.file);
        let error = self.line.map_or(error.clone(), |l| error.with_line(l));
        let error = self.column.map_or(error.clone(), |c| error.with_column(c));
        self.hint.as_ref().map_or(error.clone(), |h| error.with_hint(h.clone()))
    }
}

/// Something that a reader noticed and that did not stop it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// The file that it is about.
    pub file: PathBuf,
    /// The first line that it is about, counted from 1.
    pub line: Option<usize>,
    /// What was noticed, in a sentence.
    pub message: String,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", crate::text::in_line(&crate::error::named(&self.file)))?;
        if let Some(line) = self.line {
            write!(f, "{line}:")?;
        }
        write!(f, " {}", self.message)
    }
}

/// Channels on one clock, with what is known about them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recording {
    /// A name for reports.
    pub name: String,
    /// Time or trials.
    pub kind: Kind,
    /// The channels, in the order of the file; names are distinct.
    pub channels: Vec<Channel>,
    /// What is fitted and what is held out.
    pub spans: Spans,
    /// Known constants.
    pub constants: Vec<Constant>,
    /// The files read, with hashes.
    pub sources: Vec<Source>,
    /// Where the samples come from, by table; empty for what was made in memory.
    pub origins: Vec<Origin>,
    /// What the reader noticed.
    pub notes: Vec<Note>,
    /// Columns that are no channels, and why.
    pub left_out: Vec<LeftOut>,
    /// The moment of its zero of time, where the files tell.
    pub(crate) zero: Option<Zero>,
    /// The unit in which its first table counts time from a zero of its own.
    pub(crate) time_unit: Option<Unit>,
    /// Whether it is a piece of one recording, so that it shares a clock with what it is given beside.
    pub(crate) is_piece: bool,
    /// A parameter that is 1 in it and 0 in every other recording.
    pub(crate) mark: Option<String>,
}

impl Recording {
    /// A recording of given channels.
    ///
    /// # Errors
    /// `BadInput` where two channels have one name, times and values differ in number, or times
    /// do not rise.
    ///
    /// ```
    /// use gyrospec::record::{Channel, Recording};
    /// use gyrospec::units::Unit;
    /// let roll = Channel::new("roll", Unit::parse("deg")?, vec![0.0, 1.0], vec![0.01, 0.02]);
    /// let r = Recording::from_channels("made", vec![roll])?;
    /// assert_eq!(r.channel("roll")?.len(), 2);
    /// assert!(r.channel("rol").unwrap_err().to_string().contains("roll"));
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn from_channels(name: impl Into<String>, channels: Vec<Channel>) -> Result<Self> {
        for (i, c) in channels.iter().enumerate() {
            let wrong = |what: &str| Err(Error::bad_input(format!("channel `{}`: {what}", c.name)));
            if channels[..i].iter().any(|other| other.name == c.name) {
                return wrong("two channels have this name");
            }
            if c.time.len() != c.values.len() {
                return wrong("times and values differ in number");
            }
            let falls = |i: &usize| !c.time[*i].is_finite() || *i > 0 && c.time[*i] <= c.time[i - 1];
            if let Some(row) = (0..c.time.len()).find(falls) {
                let after = row.checked_sub(1).map(|i| format!(" after {} s", c.time[i])).unwrap_or_default();
                return wrong(&format!(
                    "times must be finite and rise: row {row} (from 0) is at {} s{after}",
                    c.time[row]
                ));
            }
        }
        Ok(Self { name: name.into(), channels, ..Self::default() })
    }

    /// The unit in which its file counts time: that of the first table's column of time; s for dates, and where no
    /// column tells. Times are in s nevertheless.
    pub fn time_unit(&self) -> Unit {
        self.time_unit.clone().unwrap_or_else(|| Unit::of(Dimension::TIME))
    }

    /// The same recording as a table of trials.
    #[must_use]
    pub fn with_kind(mut self, kind: Kind) -> Self {
        self.kind = kind;
        self
    }

    /// The same recording with given spans.
    #[must_use]
    pub fn with_spans(mut self, fit: Vec<Span>, holdout: Vec<Span>) -> Self {
        self.spans = Spans { fit, holdout, given: true };
        self
    }

    /// The channel of a name, if there is one; `x_m` is also a channel `x` whose unit is m.
    pub fn find(&self, name: &str) -> Option<&Channel> {
        let own = self.channels.iter().find(|c| c.name == name);
        let with_unit = |c: &&Channel| {
            name.strip_prefix(&c.name).and_then(|n| n.strip_prefix('_')) == Some(c.unit.text())
        };
        own.or_else(|| self.channels.iter().find(with_unit))
    }

    /// The channel of a name.
    ///
    /// # Errors
    /// `BadInput` that names the nearest channel and those that there are.
    pub fn channel(&self, name: &str) -> Result<&Channel> {
        self.find(name).ok_or_else(|| {
            if let Some(left_out) = self.left_out.iter().find(|l| l.is_named(name)) {
                return left_out.error();
            }
            // a channel of gaps alone is what a model would predict
            let is_recorded = |c: &&Channel| c.values.is_empty() || !c.values.iter().all(|v| v.is_nan());
            let names: Vec<&str> =
                self.channels.iter().filter(is_recorded).map(|c| c.name.as_str()).collect();
            let meant = nearest(name, names.iter().copied()).map(|n| format!("did you mean `{n}`? "));
            let e = Error::bad_input(format!("the recording `{}` has no channel `{name}`", self.name));
            match (names.is_empty(), meant) {
                (true, _) => e,
                (false, meant) => {
                    e.with_hint(format!("{}it has {}", meant.unwrap_or_default(), names.join(", ")))
                }
            }
        })
    }

    /// The known constant of a name, SI.
    pub fn constant(&self, name: &str) -> Option<f64> {
        self.constants.iter().find(|c| c.name == name).map(|c| c.value)
    }

    /// From the first time of any channel to the last; `None` without samples.
    pub fn range(&self) -> Option<Span> {
        self.channels
            .iter()
            .filter_map(Channel::range)
            .reduce(|a, b| Span::new(a.from.min(b.from), a.to.max(b.to)))
    }

    /// The time that all the named channels share; names without a channel do not count, and no
    /// names mean all channels. `None` where they share none.
    pub fn common_range(&self, names: &[&str]) -> Option<Span> {
        self.channels
            .iter()
            .filter(|c| names.is_empty() || names.contains(&c.name.as_str()))
            .filter_map(Channel::range)
            .reduce(|a, b| Span::new(a.from.max(b.from), a.to.min(b.to)))
            .filter(|s| s.from <= s.to)
    }

    /// What is fitted and what is held out when the named channels are used: what the file gives;
    /// else everything is fitted where separate records are held out; else the last 40 % of the
    /// time that the channels share is held out. Where the file gives held-out spans alone, the
    /// rest is fitted. Levels of trials are held out by the diagnosis instead.
    pub fn spans_for(&self, names: &[&str], separate_holdout: bool) -> Spans {
        let Some(range) = self.common_range(names) else { return self.spans.clone() };
        if self.spans.given {
            let mut spans = self.spans.clone();
            if spans.fit.is_empty() {
                spans.fit = complement(range, &spans.holdout);
            }
            spans
        } else if separate_holdout || self.kind == Kind::Trials {
            Spans::whole(range)
        } else {
            Spans::by_default(range)
        }
    }
}

fn complement(range: Span, taken: &[Span]) -> Vec<Span> {
    let mut left = Vec::new();
    let mut from = range.from;
    for span in taken {
        left.extend(Span::new(from, span.from).overlap(&range));
        from = from.max(span.to);
    }
    left.extend(Span::new(from, range.to).overlap(&range));
    left
}
