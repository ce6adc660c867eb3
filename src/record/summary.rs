//! What a channel holds, in figures: range, rate, resolution, faults.

use super::quality::{self, Fault, Sampling};
use super::{Channel, Kind, Recording};
use rayon::prelude::*;

/// A channel in figures; SI.
#[derive(Debug, Clone)]
pub struct Summary {
    /// Samples that are no gaps.
    pub samples: usize,
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub spread: f64,
    /// The step of which values are multiples.
    pub quantum: Option<f64>,
    /// The clock.
    pub sampling: Option<Sampling>,
    /// What is wrong with it.
    pub faults: Vec<Fault>,
}

/// All channels of a recording in figures.
pub fn summaries(recording: &Recording) -> Vec<Summary> {
    recording.channels.par_iter().map(|c| summary(c, recording.kind)).collect()
}

/// One channel in figures.
///
/// ```
/// use gyrospec::record::{Channel, Kind, summary};
/// use gyrospec::units::Unit;
/// let time: Vec<f64> = (0..2000).map(|i| 0.1 * f64::from(i)).collect();
/// let roll = time.iter().map(|t| (0.8 * t).sin()).collect();
/// let s = summary(&Channel::new("roll", Unit::parse("rad")?, time, roll), Kind::Time);
/// assert!((s.spread - 0.5_f64.sqrt()).abs() < 0.01);
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn summary(channel: &Channel, kind: Kind) -> Summary {
    let values = || channel.samples().map(|(_, v)| v);
    let samples = values().count();
    let mean = values().sum::<f64>() / samples as f64;
    let square = values().map(|v| (v - mean) * (v - mean)).sum::<f64>() / samples as f64;
    let trials = kind == Kind::Trials;
    Summary {
        samples,
        min: values().fold(f64::NAN, f64::min),
        max: values().fold(f64::NAN, f64::max),
        mean,
        spread: square.sqrt(),
        quantum: quality::quantum(channel),
        sampling: if trials { None } else { quality::sampling(channel) },
        faults: quality::channel_faults(channel, kind),
    }
}
