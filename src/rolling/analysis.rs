//! A recorded roll: its spectrum, its correlation function and the fit of (3.3).

use crate::record::quality::quantum;
use crate::record::{Recording, Source};
use crate::spectrum::{
    CorrelationFit, EvenSamples, MeasuredSpectrum, RollIntervals, autocovariance, even_samples,
    fit_correlation, roll_intervals, welch, without_slow,
};
use crate::units::Unit;
use crate::{Error, ErrorKind, Result};
use std::f64::consts::{PI, TAU};

/// Heel slower than this is no roll and accelerates nothing, rad/s: periods over 31 s.
pub const SLOW: f64 = 0.2;

/// A recorded roll with its spectrum and the fit of (3.3).
#[derive(Debug, Clone)]
pub struct Analysis {
    /// The recording's name.
    pub name: String,
    /// Its files.
    pub sources: Vec<Source>,
    /// Time of the first sample, s.
    pub start: f64,
    /// The roll at equal steps, rad.
    pub samples: EvenSamples,
    /// The spectrum of all of it.
    pub spectrum: MeasuredSpectrum,
    /// A, μ and ε.
    pub fit: CorrelationFit,
    /// 95 % intervals of its numbers, where the recording is long enough.
    pub intervals: Option<RollIntervals>,
    /// Frequency of the highest spectral point of the roll proper, rad/s.
    pub peak: f64,
    /// Standard deviation of all samples, rad.
    pub deviation: f64,
    /// Part of the variance that is slower than [`SLOW`].
    pub slow_share: f64,
    /// Part of the variance in the upper half of the band: where it is more than a little, the samples are too far apart,
    /// and what moves faster than they follow was folded down into the band.
    pub fast_share: f64,
    /// Fourth moment of the roll proper over its squared variance: 3 where waves come and go at random, 1.5 for a sine.
    pub kurtosis: f64,
    /// The step of which all samples are whole multiples, rad, where there is one.
    pub quantum: Option<f64>,
}

impl Analysis {
    /// The spectrum of the rounding of the samples: white, of the variance q²/12 (B. Widrow, I. Kollár, Quantization Noise, 2008).
    pub fn rounding(&self) -> Option<MeasuredSpectrum> {
        let density = self.quantum?.powi(2) / 12.0 * self.samples.step;
        let mut spectrum = self.spectrum.clone();
        spectrum.density.fill(density);
        Some(spectrum)
    }
}

/// Part of the variance in the upper half of the band from which on the samples are too far apart.
pub const FAST_SHARE: f64 = 0.01;

/// Kurtosis of the roll below which it hardly comes and goes.
pub const STEADY: f64 = 2.0;

/// Periods that a recording of roll must hold at least.
const PERIODS: f64 = 5.0;

/// Analyses a channel of a recording as roll.
///
/// ```
/// use gyrospec::record::Channel;
/// use gyrospec::{Recording, Roll, Unit, rolling::analyse};
/// let made = Roll::new(0.02, 0.05, 0.8)?.samples(0.5, 7200, 1);       // an hour at 2 Hz
/// let time: Vec<f64> = (0..7200).map(|k| 0.5 * f64::from(k)).collect();
/// let roll = Channel::new("roll", Unit::parse("rad")?, time, made);
/// let found = analyse(&Recording::from_channels("made", vec![roll])?, "roll")?;
/// assert!((found.fit.roll.frequency - 0.8).abs() < 0.05);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` for a channel that is not there, stands still or is too short; `Units` for one that is no angle.
pub fn analyse(recording: &Recording, channel: &str) -> Result<Analysis> {
    let roll = recording.channel(channel)?;
    if roll.unit.dimension() != Unit::parse("rad")?.dimension() {
        let text = format!("channel `{channel}` is in {}, which is no angle", roll.unit);
        return Err(Error::new(ErrorKind::Units, text));
    }
    let samples = even_samples(&roll.time, &roll.values)?;
    if PI / samples.step < 2.0 * SLOW {
        return Err(Error::bad_input(format!(
            "the samples of `{channel}` are {:.0} s apart and show no roll: of a ship's periods, 5 to 30 s, they make slower ones",
            samples.step
        ))
        .with_hint("record at least two samples a second"));
    }
    let length = (samples.values.len() / 4).clamp(16, 4096);
    let spectrum = welch(&samples.values, samples.step, length)?;
    let rolling = without_slow(&samples, SLOW)?;
    moves(&samples.values, &rolling.values)?;
    let peak = welch(&rolling.values, samples.step, length)?.peak();
    let duration = samples.values.len() as f64 * samples.step;
    if duration < PERIODS * TAU / peak {
        return Err(Error::bad_input(format!(
            "the recording of {duration:.0} s is too short: the roll in it looks as if it had a period of {:.0} s, and fewer than {PERIODS} periods tell neither that nor its size",
            TAU / peak
        ))
        .with_hint("half an hour of roll is usual; some minutes are the least"));
    }
    // lags over about six periods of the peak, at most a quarter of the recording
    let lags = ((6.0 * TAU / peak / samples.step) as usize).clamp(8, (samples.values.len() / 4).max(8));
    let all = autocovariance(&samples.values, 0)[0];
    let measured = autocovariance(&rolling.values, lags);
    let fit = fit_correlation(&measured, samples.step, peak, SLOW)?;
    let intervals = roll_intervals(&rolling.values, &fit);
    let half = 0.5 * PI / samples.step;
    let above = spectrum.integral(|w| f64::from(u8::from(w > half)));
    let fast_share = above / spectrum.integral(|_| 1.0);
    Ok(Analysis {
        name: recording.name.clone(),
        sources: recording.sources.clone(),
        start: roll.samples().next().map_or(0.0, |s| s.0),
        samples,
        spectrum,
        fit,
        intervals,
        peak,
        deviation: all.sqrt(),
        slow_share: (1.0 - measured[0] / all).max(0.0),
        fast_share,
        kurtosis: kurtosis(&rolling.values),
        quantum: quantum(roll),
    })
}

/// Fourth moment over squared variance, of what is there.
fn kurtosis(values: &[f64]) -> f64 {
    let known = || values.iter().filter(|x| x.is_finite());
    let n = known().count() as f64;
    let mean = known().sum::<f64>() / n;
    let moment = |k: i32| known().map(|x| (x - mean).powi(k)).sum::<f64>() / n;
    moment(4) / moment(2).powi(2)
}

/// Refuses a recording that shows no roll: nothing above the rounding of its own numbers.
fn moves(all: &[f64], rolling: &[f64]) -> Result<()> {
    let largest = |v: &[f64]| v.iter().filter(|x| x.is_finite()).fold(0.0f64, |m, x| m.max(x.abs()));
    let heel = largest(all);
    if largest(rolling) > 1e-9 * heel {
        return Ok(());
    }
    Err(Error::bad_input(format!("there is no motion: the roll stands still at {:.3}°", heel.to_degrees()))
        .with_hint("without roll there is no rolling error; a frozen channel looks like this too"))
}
