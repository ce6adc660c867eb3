//! What a fit leaves, against itself and against what drives the model.
//!
//! # Purpose
//! Show whether the residual remembers, and whether an input explains it: what people know as a residual analysis.
//!
//! # Method
//! Correlations over lags, each stretch without a gap by itself. Residuals of a free run are coloured, and a band for
//! white noise would accuse nearly all of them. The band of the autocorrelation at lag k is Bartlett's for noise whose
//! memory ends before k; the band of a cross-correlation is that of a residual with the measured spectrum and no
//! relation to the input as it was.
//!
//! # Numerical aspects
//! The residual's spectrum is a mean over nine lines. Over white, slow and ringing noise and over white, slow, stepping
//! and periodic inputs of 400 and 3000 samples at most 1.3 % of the lags lay outside such a 99 % band; a mean over more
//! lines is too narrow for slow noise.
//!
//! # References
//! M. S. Bartlett, Supplement to the Journal of the Royal Statistical Society 8 (1946) 27-41.

use super::fit::Fit;
use super::noise::correlation_time;
use crate::record::{Kind, Recording};
use num_complex::Complex64;
use realfft::RealFftPlanner;
use serde::Serialize;

/// Half the width of a 99 % band in standard deviations.
const WIDE: f64 = 2.5758;
/// Lags that are always shown, where the record bears them.
const LEAST: usize = 25;
/// Lags at most.
const MOST: usize = 2000;
/// Times the residual's memory that are shown.
const MEMORIES: f64 = 4.0;
/// Samples of the longest stretch from which on anything is told.
const SAMPLES: usize = 64;
/// Lines to each side over which the residual's spectrum is a mean.
const LINES: f64 = 4.0;

/// A correlation over lags with the band in which 99 % of its values lie by chance, each lag by itself.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Lags {
    /// The first lag, in samples; the others follow in steps of one.
    pub first: isize,
    /// The correlation at each.
    pub values: Vec<f64>,
    /// Half the width of the band at each.
    pub band: Vec<f64>,
}

impl Lags {
    /// The largest part of its band's half width that a value has.
    pub fn reach(&self) -> f64 {
        let shares = self.values.iter().zip(&self.band).map(|(v, b)| v.abs() / b);
        shares.filter(|s| s.is_finite()).fold(0.0, f64::max)
    }
}

/// The autocorrelation of residuals from lag 1 on; none where they are all zero.
///
/// ```
/// use gyrospec::estimate::autocorrelation;
/// let wave: Vec<f64> = (0..1000).map(|i| (0.1 * f64::from(i)).sin()).collect();
/// let lags = autocorrelation(&[&wave], 40).unwrap();
/// assert!((lags.values[30] + 1.0).abs() < 0.05);               // lag 31: half a period
/// ```
pub fn autocorrelation(stretches: &[&[f64]], lags: usize) -> Option<Lags> {
    let own = stretches.iter().map(|s| Pair { residual: s, other: s });
    let all = sums(own, lags)?;
    let (energy, n) = (all[lags], stretches.iter().map(|s| s.len()).sum::<usize>() as f64);
    let values: Vec<f64> = all[lags + 1..].iter().map(|c| c / energy).collect();
    // Var r_k = (1 + 2 Σ_{j<k} r_j²)/N
    let mut square = 1.0;
    let mut band = Vec::with_capacity(lags);
    for r in &values {
        band.push(WIDE * f64::sqrt(square / n));
        square += 2.0 * r * r;
    }
    (energy > 0.0).then_some(Lags { first: 1, values, band })
}

/// A stretch of a residual and what may drive it at the same times.
#[derive(Debug, Clone, Copy)]
pub struct Pair<'a> {
    pub residual: &'a [f64],
    /// As many values, with or without a mean.
    pub other: &'a [f64],
}

/// The correlation of residuals with a signal so many samples before (positive lags) and after them; none where one of
/// them does not move.
///
/// ```
/// use gyrospec::estimate::{Pair, cross_correlation};
/// let signal: Vec<f64> = (0..1000).map(|i| f64::from((i * i * 79) % 101) - 50.0).collect();
/// let late: Vec<f64> = (0..1000).map(|i: usize| signal[i.saturating_sub(3)]).collect();
/// let lags = cross_correlation(&[Pair { residual: &late, other: &signal }], 10).unwrap();
/// assert!(lags.values[13] > 0.99 && lags.first == -10);         // lag 3: the signal comes first
/// ```
pub fn cross_correlation(pairs: &[Pair<'_>], lags: usize) -> Option<Lags> {
    let count: usize = pairs.iter().map(|p| p.other.len()).sum();
    let mean = pairs.iter().flat_map(|p| p.other).sum::<f64>() / count.max(1) as f64;
    let moved: Vec<Vec<f64>> = pairs.iter().map(|p| p.other.iter().map(|u| u - mean).collect()).collect();
    let pairs: Vec<Pair<'_>> =
        pairs.iter().zip(&moved).map(|(p, other)| Pair { residual: p.residual, other }).collect();
    let square = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
    let energy: f64 = pairs.iter().map(|p| square(p.residual)).sum();
    let size = (energy * pairs.iter().map(|p| square(p.other)).sum::<f64>()).sqrt();
    if !(size > 0.0 && size.is_finite()) {
        return None;
    }
    let values = sums(pairs.iter().copied(), lags)?.iter().map(|c| c / size).collect();
    let variance = pairs.iter().map(chance).sum::<Option<f64>>()?;
    let band = vec![WIDE * variance.sqrt() / size; 2 * lags + 1];
    Some(Lags { first: -(lags as isize), values, band })
}

/// Σ e_t o_{t−k} for k = −lags … lags, over all pairs.
fn sums<'a>(pairs: impl Iterator<Item = Pair<'a>>, lags: usize) -> Option<Vec<f64>> {
    let mut all = vec![0.0; 2 * lags + 1];
    let mut planner = RealFftPlanner::<f64>::new();
    for pair in pairs {
        let Spectra { residual, other, size } = Spectra::of(&mut planner, &pair)?;
        let plan = planner.plan_fft_inverse(size);
        let mut product: Vec<Complex64> = residual.iter().zip(&other).map(|(e, o)| e * o.conj()).collect();
        let mut back = plan.make_output_vec();
        plan.process(&mut product, &mut back).ok()?;
        let reach = lags.min(pair.residual.len() - 1);
        for k in 0..=reach {
            all[lags + k] += back[k] / size as f64;
            if k > 0 {
                all[lags - k] += back[size - k] / size as f64;
            }
        }
    }
    Some(all)
}

/// Spectra from zero to Nyquist, padded so that no lag wraps around.
struct Spectra {
    residual: Vec<Complex64>,
    other: Vec<Complex64>,
    size: usize,
}

impl Spectra {
    fn of(planner: &mut RealFftPlanner<f64>, pair: &Pair<'_>) -> Option<Self> {
        let size = (2 * pair.residual.len()).next_power_of_two();
        let plan = planner.plan_fft_forward(size);
        let transform = |values: &[f64]| {
            let (mut padded, mut out) = (plan.make_input_vec(), plan.make_output_vec());
            padded[..values.len()].copy_from_slice(values);
            plan.process(&mut padded, &mut out).ok().map(|()| out)
        };
        Some(Self { residual: transform(pair.residual)?, other: transform(pair.other)?, size })
    }
}

/// The variance of Σ e_t o_{t−k} for a residual of this one's spectrum that knows nothing of the other.
fn chance(pair: &Pair<'_>) -> Option<f64> {
    let Spectra { residual, other, size } = Spectra::of(&mut RealFftPlanner::new(), pair)?;
    let n = pair.residual.len() as f64;
    let power: Vec<f64> = residual.iter().map(Complex64::norm_sqr).collect();
    let last = power.len() - 1;
    // the spectrum goes on evenly beyond both ends
    let at = |k: isize| {
        let k = k.unsigned_abs();
        power[if k > last { (2 * last).saturating_sub(k) } else { k }]
    };
    let reach = (LINES * size as f64 / n).round() as isize;
    let width = (2 * reach + 1) as f64;
    let mut window: f64 = (-reach..=reach).map(at).sum();
    let mut sum = 0.0;
    for (k, o) in other.iter().enumerate() {
        let twice = if k == 0 || k == last { 1.0 } else { 2.0 };
        sum += twice * window.max(0.0) / width * o.norm_sqr();
        let k = k as isize;
        window += at(k + reach + 1) - at(k - reach);
    }
    Some(sum / (n * size as f64))
}

/// What an output of a fit leaves over, against itself or against an input.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Correlation {
    pub output: String,
    /// The input; none for the residual against itself.
    pub input: Option<String>,
    /// Step of the lags, s; none where samples follow each other unevenly.
    pub step: Option<f64>,
    pub lags: Lags,
}

/// All correlations of a fit's residuals on what was fitted; none for steady trials and short recordings.
pub fn correlations(fit: &Fit, recordings: &[Recording]) -> Vec<Correlation> {
    if recordings.iter().any(|r| r.kind == Kind::Trials) {
        return Vec::new();
    }
    let outputs = fit.model.outputs.iter().enumerate();
    outputs.flat_map(|(k, o)| of_output(fit, recordings, (k, &o.name))).collect()
}

/// A stretch with the number of its recording.
struct Own<'a> {
    recording: usize,
    time: &'a [f64],
    residual: &'a [f64],
}

fn of_output(fit: &Fit, recordings: &[Recording], (k, name): (usize, &str)) -> Vec<Correlation> {
    let series = fit.records.iter().enumerate().flat_map(|(i, r)| r.series.iter().map(move |s| (i, s)));
    let own: Vec<Own<'_>> = series
        .filter(|(_, s)| s.output == k)
        .flat_map(|(recording, s)| {
            let own = |r: &std::ops::Range<usize>| Own {
                recording,
                time: &s.time[r.clone()],
                residual: &s.residual[r.clone()],
            };
            s.stretches.iter().map(own).collect::<Vec<_>>()
        })
        .filter(|o| o.residual.len() > 1 && o.residual.iter().all(|e| e.is_finite()))
        .collect();
    let Some(longest) = own.iter().max_by_key(|o| o.residual.len()) else { return Vec::new() };
    if longest.residual.len() < SAMPLES {
        return Vec::new();
    }
    let residuals: Vec<&[f64]> = own.iter().map(|o| o.residual).collect();
    let wanted = ((MEMORIES * correlation_time(&residuals)) as usize).clamp(LEAST, MOST);
    let lags = wanted.min(longest.residual.len() / 3);
    let told = |input: Option<&str>, lags: Lags| Correlation {
        output: name.to_owned(),
        input: input.map(str::to_owned),
        step: even_step(longest.time),
        lags,
    };
    let itself = autocorrelation(&residuals, lags).map(|l| told(None, l));
    let inputs = fit.model.inputs.iter().filter_map(|i| {
        let beside = beside(&own, recordings, &i.name);
        let pairs: Vec<Pair<'_>> = beside.iter().map(|(residual, other)| Pair { residual, other }).collect();
        cross_correlation(&pairs, lags).map(|l| told(Some(&i.name), l))
    });
    itself.into_iter().chain(inputs).collect()
}

/// Residuals with an input at their times, where it has no gap.
fn beside<'a>(own: &[Own<'a>], recordings: &[Recording], input: &str) -> Vec<(&'a [f64], Vec<f64>)> {
    let of = |o: &Own<'a>| {
        let channel = recordings.get(o.recording)?.find(input)?;
        let values: Option<Vec<f64>> = o.time.iter().map(|t| channel.value_from(*t)).collect();
        Some((o.residual, values?))
    };
    own.iter().filter_map(of).collect()
}

/// The step between times that follow each other evenly, within a hundredth.
fn even_step(time: &[f64]) -> Option<f64> {
    let steps = || time.windows(2).map(|w| w[1] - w[0]);
    let (low, high) = (steps().fold(f64::INFINITY, f64::min), steps().fold(0.0, f64::max));
    (high - low <= 0.01 * high).then(|| (time[time.len() - 1] - time[0]) / (time.len() - 1) as f64)
}

/// How much of a measured signal's movement a model follows: 100·(1 − ‖y − ŷ‖/‖y − ȳ‖) %, of pairs of measured and
/// residual; 0 is as good as the mean. NaN where the signal does not move. What is not finite is left out.
///
/// ```
/// use gyrospec::estimate::fit_percent;
/// assert_eq!(fit_percent([[1.0, 0.5], [-1.0, -0.5]]), 50.0);
/// assert!(fit_percent([[1.0, 0.5], [1.0, 0.5]]).is_nan());
/// ```
pub fn fit_percent(samples: impl IntoIterator<Item = [f64; 2]>) -> f64 {
    let known: Vec<[f64; 2]> = samples.into_iter().filter(|s| s.iter().all(|x| x.is_finite())).collect();
    let mean = known.iter().map(|s| s[0]).sum::<f64>() / known.len() as f64;
    let moved = known.iter().map(|s| (s[0] - mean).powi(2)).sum::<f64>().sqrt();
    let left = known.iter().map(|s| s[1] * s[1]).sum::<f64>().sqrt();
    if moved > 0.0 { 100.0 * (1.0 - left / moved) } else { f64::NAN }
}
