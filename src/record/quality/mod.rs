//! What is wrong with a recording by itself, before any model looks at it.
//!
//! The tests here are meant for few false alarms: a signal that rests, is switched between
//! levels, decays, or is simply noisy has no fault. What could also be honest is a suspicion
//! ([`Fault::sure`] is false) and is for people to look at.

mod frozen;
mod gaps;
mod outliers;
mod quantum;
mod sampling;
mod wrapped;

pub use frozen::{frozen, still};
pub use gaps::gaps;
pub use outliers::{coded_outliers, outliers};
pub use quantum::{coarse_steps, quantum};
pub use sampling::{Sampling, sampling};
pub use wrapped::wrapped_angle;

use super::{Channel, Kind, Recording, Span};
use rayon::prelude::*;
use std::borrow::Cow;

/// What sort of fault it is; the codes are those of the diagnosis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaultKind {
    /// The channel repeats one value while it should move.
    Frozen,
    /// Single samples far off.
    Outliers,
    /// Samples are missing.
    Gap,
    /// The steps of the channel are large against its motion.
    Quantisation,
    /// An angle jumps by a turn and is not marked as wrapping.
    WrappedAngle,
    /// The step between samples changes for good.
    ClockDrift,
}

impl FaultKind {
    /// The code of the diagnosis' catalogue.
    pub const fn code(self) -> &'static str {
        match self {
            Self::Frozen => "frozen-channel",
            Self::Outliers => "outliers",
            Self::Gap => "gap",
            Self::Quantisation => "quantisation",
            Self::WrappedAngle => "wrapped-angle",
            Self::ClockDrift => "clock-drift",
        }
    }

    /// Whether its samples are no measurements.
    pub(crate) const fn spoils(self) -> bool {
        matches!(self, Self::Frozen | Self::Outliers)
    }
}

/// One fault of one channel.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// What it is.
    pub kind: FaultKind,
    /// The channel that it stands in, by name.
    pub channel: String,
    /// Where it lies, s (rows of trials); empty means everywhere.
    pub spans: Vec<Span>,
    /// How many samples it spoils; for gaps, how many are missing.
    pub samples: usize,
    /// Its size in SI: of the largest outlier, of a step of quantisation, of the longest gap (s),
    /// of the held value, of a turn; the relative change of the step of time.
    pub size: f64,
    /// Whether nothing honest is likely to look so.
    pub sure: bool,
    /// Whether a command that is held looks so too: without a model nobody knows which it is.
    pub may_be_held: bool,
}

impl Fault {
    /// Whether it is a fault whatever the channel is, a command too.
    pub const fn is_sure_of_any(&self) -> bool {
        self.sure && !self.may_be_held
    }
}

impl Fault {
    fn of(kind: FaultKind, channel: &Channel, spans: Vec<Span>) -> Self {
        Self {
            kind,
            channel: channel.name.clone(),
            spans,
            samples: 0,
            size: 0.0,
            sure: true,
            may_be_held: false,
        }
    }
}

/// All faults of all channels, in the order of the channels.
///
/// ```
/// use gyrospec::record::{Channel, Recording, quality};
/// use gyrospec::units::Unit;
/// let time: Vec<f64> = (0..500).map(|i| 0.1 * f64::from(i)).collect();
/// let mut heading: Vec<f64> = time.iter().map(|t| (0.3 * t).sin()).collect();
/// heading[250] += 40.0;
/// let c = Channel::new("heading", Unit::parse("rad")?, time, heading);
/// let faults = quality::faults(&Recording::from_channels("made", vec![c])?);
/// assert_eq!((faults.len(), faults[0].kind.code()), (1, "outliers"));
/// assert_eq!(faults[0].spans[0].from, 25.0);
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn faults(recording: &Recording) -> Vec<Fault> {
    let each: Vec<_> = recording.channels.par_iter().map(|c| channel_faults(c, recording.kind)).collect();
    each.into_iter().flatten().collect()
}

/// The faults of one channel. Rows of trials have no neighbours, so that only their gaps are
/// looked at.
pub fn channel_faults(channel: &Channel, kind: Kind) -> Vec<Fault> {
    if kind == Kind::Trials {
        return gaps(channel).into_iter().collect();
    }
    let found = [
        gaps(channel),
        frozen(channel),
        outliers(channel),
        coarse_steps(channel),
        wrapped_angle(channel),
        sampling::drift(channel),
    ];
    found.into_iter().flatten().collect()
}

/// The recording with the samples of sure frozen spans and outliers made gaps.
#[must_use]
pub fn masked(recording: &Recording, faults: &[Fault]) -> Recording {
    let mut clean = recording.clone();
    for fault in faults.iter().filter(|f| f.sure && f.kind.spoils()) {
        for channel in clean.channels.iter_mut().filter(|c| c.name == fault.channel) {
            let samples = channel.time.iter().zip(&mut channel.values);
            for (_, value) in samples.filter(|(t, _)| fault.spans.iter().any(|s| s.contains(**t))) {
                *value = f64::NAN;
            }
        }
    }
    clean
}

/// So many numbers are enough for a quantile.
const LOOKED_AT: usize = 50_000;

/// The value below which a share of the numbers lies; of very many, every so-manieth counts.
fn quantile(values: impl ExactSizeIterator<Item = f64>, share: f64) -> Option<f64> {
    let every = values.len().div_ceil(LOOKED_AT).max(1);
    let mut some: Vec<f64> = values.step_by(every).collect();
    let at = (some.len().checked_sub(1)? as f64 * share).round() as usize;
    Some(*some.select_nth_unstable_by(at, f64::total_cmp).1)
}

/// The steps between times.
fn steps(time: &[f64]) -> impl ExactSizeIterator<Item = f64> + Clone {
    time.windows(2).map(|w| w[1] - w[0])
}

/// Times and values of a channel without its gaps.
struct Samples<'a> {
    time: Cow<'a, [f64]>,
    values: Cow<'a, [f64]>,
}

impl<'a> Samples<'a> {
    fn of(channel: &'a Channel) -> Self {
        if channel.values.iter().any(|v| v.is_nan()) {
            let (time, values): (Vec<f64>, Vec<f64>) = channel.samples().unzip();
            return Self { time: time.into(), values: values.into() };
        }
        Self { time: Cow::Borrowed(&channel.time), values: Cow::Borrowed(&channel.values) }
    }
}

/// Smallest and largest.
fn ends(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)))
}
