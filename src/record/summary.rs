//! What a channel holds, in figures: range, rate, resolution, spectral peaks, faults.

use super::quality::{self, Fault, Sampling};
use super::{Channel, Kind, Recording};
use crate::spectrum;
use rayon::prelude::*;
use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::f64::consts::TAU;

/// Of longer channels, so many samples in the middle are looked at.
const LONGEST: usize = 1 << 19;
const MOST_PEAKS: usize = 3;
/// Peaks nearer to a larger one than this ratio are its own unevenness.
const APART: f64 = 1.4;
/// The chance that noise alone shows a peak anywhere in a spectrum.
const CHANCE: f64 = 0.001;
/// A peak stands out from the median of the frequencies from ω/WIDE to ω·WIDE.
const WIDE: f64 = 1.6;
/// Of overlapping segments under a Hann window, so many count as independent.
const INDEPENDENT: f64 = 0.65;

/// A channel in figures; SI.
#[derive(Debug, Clone)]
pub struct Summary {
    /// Samples that are no gaps.
    pub samples: usize,
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Mean of the samples that are there.
    pub mean: f64,
    /// Standard deviation.
    pub spread: f64,
    /// The step of which values are multiples.
    pub quantum: Option<f64>,
    /// How it is sampled; none of trials.
    pub sampling: Option<Sampling>,
    /// Peaks of the spectrum, largest first.
    pub peaks: Vec<Peak>,
    /// What is wrong with it.
    pub faults: Vec<Fault>,
}

/// A peak of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// rad/s.
    pub omega: f64,
    /// Its share of the variance about the trend.
    pub share: f64,
}

impl Peak {
    /// Length of one period 2π/ω, s.
    pub fn period(&self) -> f64 {
        TAU / self.omega
    }
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
/// assert!((s.peaks[0].omega - 0.8).abs() < 0.1);
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
        peaks: if trials { Vec::new() } else { peaks(channel) },
        faults: quality::channel_faults(channel, kind),
    }
}

/// Peaks of the spectrum that noise of the level around them would hardly show.
fn peaks(channel: &Channel) -> Vec<Peak> {
    let middle = channel.len().saturating_sub(LONGEST) / 2;
    let part = middle..(middle + LONGEST).min(channel.len());
    let Ok(even) = spectrum::even_samples(&channel.time[part.clone()], &channel.values[part]) else {
        return Vec::new();
    };
    let length = (even.values.len() / 8).clamp(64, 8192).min(even.values.len());
    let Ok(measured) = spectrum::welch(&even.values, even.step, length) else { return Vec::new() };
    let density = &measured.density;
    let total: f64 = density.iter().skip(1).sum();
    if total.is_nan() || total <= 0.0 {
        return Vec::new();
    }
    let limit = limit(measured.segments, density.len());
    let mut found: Vec<Peak> = (2..density.len().saturating_sub(2))
        .filter(|k| (k - 2..=k + 2).all(|j| density[j] <= density[*k]))
        .filter(|k| density[*k] > limit * around(density, *k))
        .map(|k| {
            let share = (density[k - 2..=k + 2].iter().sum::<f64>() / total).min(1.0);
            Peak { omega: measured.omega[k], share }
        })
        .filter(|p| p.share >= 0.01)
        .collect();
    found.sort_by(|a, b| b.share.total_cmp(&a.share));
    let mut apart: Vec<Peak> = Vec::new();
    for peak in found {
        let beside = |p: &Peak| (p.omega / peak.omega).ln().abs() < APART.ln();
        if !apart.iter().any(beside) {
            apart.push(peak);
        }
    }
    apart.truncate(MOST_PEAKS);
    apart
}

/// How far above the median one of many densities of noise may come: mean of χ² deviates.
fn limit(segments: usize, frequencies: usize) -> f64 {
    let freedom = (2.0 * (INDEPENDENT * segments as f64)).max(2.0);
    let Ok(law) = ChiSquared::new(freedom) else { return f64::INFINITY };
    law.inverse_cdf(1.0 - CHANCE / frequencies as f64) / law.inverse_cdf(0.5)
}

/// The median density around a frequency, its own peak left out.
fn around(density: &[f64], k: usize) -> f64 {
    let reach = |f: f64| (k as f64 * f).round() as usize;
    let (from, to) = (reach(1.0 / WIDE).min(k.saturating_sub(6)).max(1), reach(WIDE).max(k + 6));
    let mut beside: Vec<f64> =
        (from..=to.min(density.len() - 1)).filter(|j| j.abs_diff(k) > 2).map(|j| density[j]).collect();
    beside.sort_unstable_by(f64::total_cmp);
    beside.get(beside.len() / 2).copied().unwrap_or(f64::INFINITY)
}
