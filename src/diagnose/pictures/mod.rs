//! The series behind a report's pictures, thinned, in the units of the model file.
//!
//! # Purpose
//! Give a report all that it draws, so that the report itself computes nothing.
//!
//! # Method
//! Long series keep the least and the greatest value of each of some hundred stretches, so that no
//! peak is lost.

mod bins;
pub mod closer;
mod course;
mod law;
mod probe;
mod sites;

use super::answer::{Band, SiteName, Stretch};
use super::assemble::Assembly;
use super::faults::Spoiled;
use super::locate;
use crate::estimate::{Correlation, Fit, correlations};
use crate::record::Recording;
use serde::Serialize;

/// Stretches that a long series is thinned to.
const STRETCHES: usize = 600;
/// Lines of a spectrum that are kept.
const LINES: usize = 240;

/// A point: x and y.
pub type Point = [f64; 2];

/// All series of the pictures.
#[derive(Debug, Clone, Default, Serialize)]
pub struct Pictures {
    /// Whether the recordings are tables of trials, with row numbers for times.
    pub trials: bool,
    /// How the recordings count time.
    pub clock: Clock,
    /// Outputs over time.
    pub courses: Vec<Course>,
    /// Spectra of the residuals.
    pub spectra: Vec<Spectrum>,
    /// What the model as given leaves, against itself and against its inputs.
    pub left_before: Vec<Correlation>,
    /// The same of the model with the findings.
    pub left_after: Vec<Correlation>,
    /// What each finding explains, against the signal that it goes with.
    pub laws: Vec<Law>,
    /// What was tried, likeliest first.
    pub tried: Vec<Tried>,
    /// Channels with faults.
    pub faults: Vec<Faulty>,
}

/// A unit of time. All times here are in s nevertheless.
#[derive(Debug, Clone, Serialize)]
pub struct Clock {
    /// The unit.
    pub unit: String,
    /// How many seconds it has.
    pub seconds: f64,
}

impl Default for Clock {
    fn default() -> Self {
        Self { unit: "s".into(), seconds: 1.0 }
    }
}

impl Clock {
    /// That of a recording's file.
    pub fn of(recording: &Recording) -> Self {
        let unit = recording.time_unit();
        Self { seconds: unit.to_si(1.0), unit: unit.text().to_owned() }
    }
}

/// One output on one recording.
#[derive(Debug, Clone, Serialize)]
pub struct Course {
    /// The output.
    pub output: String,
    /// Its unit.
    pub unit: String,
    /// Unit of its differences.
    pub difference_unit: String,
    /// The recording's name.
    pub recording: String,
    /// Spans that were held out; a separate record is held out whole.
    pub held: Vec<Stretch>,
    /// How much of the movement the model as given follows, %: fitted, held out; NaN where there is none.
    pub percent_before: [f64; 2],
    /// The same of the model with the findings.
    pub percent_after: [f64; 2],
    /// Measured.
    pub measured: Vec<Point>,
    /// The model as given, fitted.
    pub before: Vec<Point>,
    /// The model with the findings.
    pub after: Vec<Point>,
    /// Measured less the model as given.
    pub residual_before: Vec<Point>,
    /// Measured less the model with the findings.
    pub residual_after: Vec<Point>,
    /// The part where measurement and model part most, of a long series.
    pub close: Option<Close>,
}

/// A short part of a course, with all the samples that it has room for.
#[derive(Debug, Clone, Serialize)]
pub struct Close {
    /// Measured.
    pub measured: Vec<Point>,
    /// The model as given, fitted.
    pub before: Vec<Point>,
    /// The model with the findings.
    pub after: Vec<Point>,
}

/// The residual of an output in frequency.
#[derive(Debug, Clone, Serialize)]
pub struct Spectrum {
    /// The output.
    pub output: String,
    /// Bands that hold much of the mismatch.
    pub bands: Vec<Band>,
    /// rad/s and relative power, before.
    pub before: Vec<Point>,
    /// The same after.
    pub after: Vec<Point>,
}

/// What a finding explains, against the signal that it goes with.
#[derive(Debug, Clone, Serialize)]
pub struct Law {
    /// Code of the finding.
    pub code: String,
    /// Its term.
    pub term: String,
    /// The term in the unit of the effect; empty where that cannot be told.
    pub formula: String,
    /// The signal.
    pub signal: String,
    /// Its unit.
    pub signal_unit: String,
    /// What is missing there: a rate or an output.
    pub effect: String,
    /// Unit of the effect.
    pub effect_unit: String,
    /// What the recording shows, sample by sample.
    pub samples: Vec<Point>,
    /// Means of the samples along the signal with 95 % bands: x, mean, low, high.
    pub means: Vec<[f64; 4]>,
    /// The fitted mechanism with its 95 % band: x, effect, low, high.
    pub curve: Vec<[f64; 4]>,
}

/// A mechanism that was tried at a site.
#[derive(Debug, Clone, Serialize)]
pub struct Tried {
    /// Its code.
    pub code: String,
    /// Where.
    pub site: SiteName,
    /// −ln of the chance that noise alone looks like it.
    pub score: f64,
    /// Whether it is a finding, or fits as well as one.
    pub standing: Standing,
}

/// What became of what was tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Standing {
    /// It is a finding.
    Found,
    /// It fits as well as a finding.
    Tie,
    /// Another explains it better.
    Dropped,
}

/// A channel with faults.
#[derive(Debug, Clone, Serialize)]
pub struct Faulty {
    /// Code of the fault.
    pub code: String,
    /// The channel.
    pub channel: String,
    /// Its unit.
    pub unit: String,
    /// The channel as recorded.
    pub recorded: Vec<Point>,
    /// Where the fault sits.
    pub spans: Vec<Stretch>,
}

/// Gathers the series of all pictures; what cannot be run is left out.
pub(super) fn gather(assembly: &Assembly<'_>) -> Pictures {
    let found = &assembly.found;
    Pictures {
        trials: assembly.bench.is_trials(),
        clock: assembly.bench.recordings.first().map(Clock::of).unwrap_or_default(),
        courses: course::courses(assembly),
        spectra: spectra(&found.base, &found.last),
        left_before: correlations(&found.base, &assembly.bench.recordings),
        left_after: correlations(&found.last, &assembly.bench.recordings),
        laws: law::laws(assembly),
        tried: sites::tried(found),
        faults: faulty(assembly),
    }
}

/// The least and the greatest point of each stretch, in order; all points where they are few. A value
/// that is no number stands for a gap; one of each gap is kept.
pub(super) fn thinned(points: impl Iterator<Item = Point>) -> Vec<Point> {
    let points: Vec<Point> = points.filter(|p| p[0].is_finite()).collect();
    if points.len() <= 2 * STRETCHES {
        return points;
    }
    let size = points.len().div_ceil(STRETCHES);
    let mut kept: Vec<Point> = Vec::with_capacity(2 * STRETCHES + 2);
    for piece in points.chunk_by(|a, b| a[1].is_finite() == b[1].is_finite()) {
        if !piece[0][1].is_finite() {
            kept.push(piece[0]);
            continue;
        }
        for stretch in piece.chunks(size) {
            let by_value = |a: &&Point, b: &&Point| a[1].total_cmp(&b[1]);
            let (low, high) = (stretch.iter().min_by(by_value), stretch.iter().max_by(by_value));
            let mut both: Vec<Point> = low.into_iter().chain(high).copied().collect();
            both.sort_by(|a, b| a[0].total_cmp(&b[0]));
            kept.extend(both);
        }
    }
    kept
}

fn spectra(before: &Fit, after: &Fit) -> Vec<Spectrum> {
    let series = |fit: &Fit, k: usize| {
        let own = fit.records.first()?.series.iter().find(|s| s.output == k)?;
        let longest = own.stretches.iter().max_by_key(|r| r.len()).filter(|r| r.len() > 64)?.clone();
        let step = (own.time[longest.end - 1] - own.time[longest.start]) / (longest.len() - 1) as f64;
        Some(lines(&locate::spectrum(&own.residual[longest]), step))
    };
    let fits = (before, after);
    let outputs = before.model.outputs.iter().enumerate();
    outputs
        .filter_map(|(k, o)| {
            let (before, after) = (series(before, k)?, series(after, k)?);
            let top = before.iter().chain(&after).map(|p| p[1]).fold(0.0, f64::max);
            if top <= 0.0 {
                return None;
            }
            let relative = |v: Vec<Point>| v.into_iter().map(|p| [p[0], p[1] / top]).collect();
            let bands = locate::bands(fits.0, fits.1, k);
            Some(Spectrum { output: o.name.clone(), bands, before: relative(before), after: relative(after) })
        })
        .collect()
}

/// Means of a periodogram over lines of equal width in ln ω.
fn lines(power: &[f64], step: f64) -> Vec<Point> {
    let n = power.len();
    // ω_k = π k / (N Δt), N lines from 0 to Nyquist
    let unit = std::f64::consts::PI / (n as f64 * step);
    let mut lines = Vec::new();
    let (mut from, ratio) = (1usize, (n as f64).powf(1.0 / LINES as f64));
    while from < n {
        let to = ((from as f64 * ratio) as usize).clamp(from + 1, n);
        let mean = power[from..to].iter().sum::<f64>() / (to - from) as f64;
        lines.push([0.5 * (from + to - 1) as f64 * unit, mean]);
        from = to;
    }
    lines
}

fn faulty(assembly: &Assembly<'_>) -> Vec<Faulty> {
    let all = assembly.request.recordings.iter().chain(assembly.request.separate);
    let recordings: Vec<_> = all.collect();
    let picture = |s: &Spoiled| {
        let fault = &s.fault;
        let c = recordings.get(s.recording)?.find(&fault.channel)?;
        let recorded = c.time.iter().zip(&c.values).map(|(t, v)| [*t, c.unit.from_si(*v)]);
        Some(Faulty {
            code: fault.kind.code().to_string(),
            channel: fault.channel.clone(),
            unit: c.unit.text().to_string(),
            recorded: thinned(recorded),
            spans: fault.spans.iter().take(200).map(|s| Stretch { from: s.from, to: s.to }).collect(),
        })
    };
    assembly.spoiled.iter().take(4).filter_map(picture).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_the_peaks_and_the_order() {
        let wave =
            (0..100_000).map(|i| [f64::from(i), if i == 77_777 { 9.0 } else { (f64::from(i) * 0.1).sin() }]);
        let kept = thinned(wave);
        assert!(kept.len() <= 2 * STRETCHES + 2);
        assert!(kept.contains(&[77_777.0, 9.0]));
        assert!(kept.windows(2).all(|w| w[0][0] <= w[1][0]));
    }

    #[test]
    fn a_gap_stays_a_gap() {
        let wave = (0..9000).map(|i| [f64::from(i), if (4000..5000).contains(&i) { f64::NAN } else { 1.0 }]);
        assert_eq!(thinned(wave).iter().filter(|p| p[1].is_nan()).count(), 1);
    }

    #[test]
    fn a_line_stands_at_its_frequency() {
        let step = 0.01;
        let values: Vec<f64> = (0..4096).map(|i| (25.0 * f64::from(i) * step).sin()).collect();
        let lines = lines(&locate::spectrum(&values), step);
        let peak = lines.iter().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
        assert!((peak[0] / 25.0 - 1.0).abs() < 0.03, "{peak:?}");
    }
}
