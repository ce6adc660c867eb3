//! The rolling error on a recorded roll.

use super::Arguments;
use super::described::Described;
use super::options::{Against, RowOptions};
use super::parameters::Compass;
use super::table::{Case, Plan};
use crate::gyro::{BySpectrum, Instrument, Motion};
use crate::record::{Recording, Source};
use crate::report::terminal::{Trace, picture};
use crate::spectrum::{
    CorrelationFit, EvenSamples, Interval, Measured, RollIntervals, autocovariance, even_samples,
    fit_correlation, roll_intervals, welch, without_slow,
};
use crate::{Error, Result};
use std::f64::consts::{PI, TAU};

/// A recorded roll with its spectrum and the fit of (3.3).
pub struct Analysis {
    pub name: String,
    /// The files of the recording.
    pub sources: Vec<Source>,
    /// Time of the first sample, s.
    pub start: f64,
    pub samples: EvenSamples,
    pub spectrum: Measured,
    pub fit: CorrelationFit,
    /// 95 % intervals of its numbers, where the recording is long enough.
    pub intervals: Option<RollIntervals>,
    /// Frequency of the highest spectral point of the roll proper, rad/s.
    pub peak: f64,
    /// Standard deviation of all samples, rad.
    pub deviation: f64,
    /// Part of the variance that is slower than [`SLOW`].
    pub slow_share: f64,
}

/// Heel slower than this is no roll and accelerates nothing, rad/s: periods over 31 s.
const SLOW: f64 = 0.2;

/// Reads the roll of a recording (`roll`: NAME or NAME:UNIT) and analyses it.
pub fn analyse(recording: &Recording, roll: &str) -> Result<Analysis> {
    let channel = recording.channel(roll)?;
    let radians = crate::units::Unit::parse("rad")?;
    if channel.unit.dimension() != radians.dimension() {
        return Err(Error::new(
            crate::ErrorKind::Units,
            format!("channel `{roll}` is in {}, which is no angle", channel.unit),
        ));
    }
    let samples = even_samples(&channel.time, &channel.values)?;
    let length = (samples.values.len() / 4).clamp(16, 4096);
    let spectrum = welch(&samples.values, samples.step, length)?;
    let rolling = without_slow(&samples, SLOW)?;
    moves(&samples.values, &rolling.values)?;
    let peak = welch(&rolling.values, samples.step, length)?.peak();
    // lags over about six periods of the peak, at most a quarter of the recording
    let lags = ((6.0 * TAU / peak / samples.step) as usize).clamp(8, (samples.values.len() / 4).max(8));
    let all = autocovariance(&samples.values, 0)[0];
    let measured = autocovariance(&rolling.values, lags);
    let fit = fit_correlation(&measured, samples.step, peak, SLOW)?;
    let intervals = roll_intervals(&rolling.values, &fit);
    let slow_share = (1.0 - measured[0] / all).max(0.0);
    Ok(Analysis {
        name: recording.name.clone(),
        sources: recording.sources.clone(),
        start: channel.samples().next().map_or(0.0, |s| s.0),
        samples,
        spectrum,
        fit,
        intervals,
        peak,
        deviation: all.sqrt(),
        slow_share,
    })
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

/// Part of the mean by the fit from which on its form, or its tail, counts.
const MUCH: f64 = 0.1;
/// Misfit of the correlation function from which on the fit is no longer good.
const FAIR: f64 = 0.05;

/// Whether the mean by the measured spectrum is the one to trust.
fn is_surer(m: &BySpectrum, fit: &CorrelationFit) -> bool {
    m.above().abs() >= MUCH || m.form().abs() >= MUCH || fit.misfit >= FAIR
}

/// The table for a recorded roll: by I_n on the fit of (3.3), with the mean by quadrature over
/// the measured spectrum beside it.
pub fn plan(compass: &Compass, recording: &Recording, a: &Arguments, rows: &RowOptions) -> Result<Plan> {
    if a.motion.given() || rows.against != Against::Heading {
        return Err(Error::usage("a recording is the motion, and its rows run over headings")
            .with_hint("leave the options of the motion and --against away"));
    }
    let name = super::recording::roll_name(recording, a.roll.as_deref())?;
    let mut compass = compass.clone();
    if let (Some(latitude), None) = (recording.constant("lat"), &a.instrument.latitude) {
        compass.sphere.latitude = latitude;
        compass.sphere.check()?;
    }
    let instrument = compass.instrument(&a.instrument)?;
    linear(&instrument)?;
    let analysis = analyse(recording, &name)?;
    let m = instrument.mean_by_spectrum(&analysis.fit.roll, &analysis.spectrum)?;
    let motion = || -> Described {
        let says = format!(
            "the recorded roll by its fit, and the last column by its measured spectrum to {:.2} rad/s",
            PI / analysis.samples.step
        );
        Described::new(Motion::roll(&analysis.fit.roll), says)
    };
    let mut cases = Vec::new();
    for heading in rows.headings()? {
        let (instrument, motion) = (compass.instrument(&a.instrument)?, motion());
        let rectified = instrument.rectified_error(&motion.motion, heading)?;
        let measured = Some(instrument.sailing_error(heading) + m.ratio() * rectified);
        let value = heading.to_degrees();
        cases.push(Case { instrument, motion, heading, value, height: None, measured });
    }
    let by_spectrum = is_surer(&m, &analysis.fit);
    Ok(Plan {
        motion_says: motion().says,
        after: tail(&m, by_spectrum) + &super::table::asides(compass.speed, a)?,
        tail: None,
        by_spectrum,
        smallness: Vec::new(),
        roll: Some(analysis.fit.roll),
        recorded: Some(analysis),
        cases,
        against: Against::Heading,
        compass,
    })
}

/// Refuses a part that is not linear: the fit of (3.3) has no finite acceleration to drive it.
fn linear(instrument: &Instrument) -> Result<()> {
    if instrument.is_linear()? {
        return Ok(());
    }
    let what = instrument.elastic.name();
    Err(Error::usage(format!("{what} is not linear, and the fit of a recorded roll has a white tail"))
        .with_hint("run roll-error on the recording alone, then put the sigma, mu and eps that it tells into --irregular SIGMA,MU,EPS with --band"))
}

/// The recorded roll and its fit in words, with a picture of the correlation.
pub fn told(a: &Analysis) -> String {
    let degrees2 = |k: &f64| k.to_degrees().to_degrees();
    let measured: Vec<f64> = a.fit.measured.iter().map(degrees2).collect();
    let fitted: Vec<f64> = a.fit.fitted.iter().map(degrees2).collect();
    let last = format!("{:.0} s", (measured.len() - 1) as f64 * a.samples.step);
    format!(
        "{}\nK(τ), deg²: o measured, · fitted\n{}\n",
        words(a),
        picture(
            &[Trace { mark: 'o', values: &measured }, Trace { mark: '·', values: &fitted }],
            (64, 13),
            ("τ = 0", &last)
        )
    )
}

/// The recorded roll and its fit in words.
pub fn words(a: &Analysis) -> String {
    let (n, step) = (a.samples.values.len(), a.samples.step);
    let roll = a.fit.roll;
    let sigma = a.deviation.to_degrees();
    let slow = match 100.0 * a.slow_share {
        s if s < 1.0 => String::new(),
        s => format!(
            "{s:.0} % of the variance is heel slower than 31 s, left out of the fit: it hardly accelerates\n"
        ),
    };
    let verdict = match a.fit.misfit {
        m if m < FAIR => "a good fit",
        m if m < 0.15 => "a fair fit: trust the column of the measured spectrum more",
        _ => "a poor fit: this roll is not of the form (3.3); use the column of the measured spectrum",
    };
    format!(
        "Roll of `{}`: {n} samples {step:.4} s apart, {:.1} min; standard deviation {sigma:.3}°\n\
         {slow}highest spectral point of the roll at {:.3} rad/s (period {:.1} s), from {} segments\n\n\
         Fit of K(τ) = A e^(−μ|τ|) (cos ετ + (μ/ε) sin ε|τ|) to the correlation function, lags 0 … {:.0} s\n\
         \x20 A = {:.4e} rad² ({:.3}°)²,  μ = {:.4} 1/s,  ε = {:.4} rad/s (period {:.1} s)\n\
         {}\x20 explains {:.1} % of it; misfit {:.1} % of K(0): {verdict}\n",
        a.name,
        n as f64 * step / 60.0,
        a.peak,
        TAU / a.peak,
        a.spectrum.segments,
        (a.fit.measured.len() - 1) as f64 * step,
        roll.variance,
        roll.variance.sqrt().to_degrees(),
        roll.decay,
        roll.frequency,
        TAU / roll.frequency,
        trusted(a.intervals.as_ref()),
        100.0 * a.fit.r_squared,
        100.0 * a.fit.misfit,
    )
}

/// The intervals in words.
fn trusted(intervals: Option<&RollIntervals>) -> String {
    let Some(i) = intervals else {
        return "\u{20} no intervals: the recording is shorter than 30 periods of roll\n".into();
    };
    let between = |i: &Interval, f: fn(f64) -> f64| format!("{:.4} … {:.4}", f(i.low), f(i.high));
    let decay = match &i.decay {
        Some(mu) => format!("{} 1/s", between(mu, |v| v)),
        None => "not known: too little decay to see".into(),
    };
    format!(
        "\u{20} 95 % intervals (ten blocks left out in turn): standard deviation {}°, ε {} rad/s, μ {decay}\n",
        between(&i.variance, |v| v.sqrt().to_degrees()),
        between(&i.frequency, |v| v)
    )
}

/// So much larger or smaller, in words.
fn than(part: f64) -> String {
    format!("{:.0} % {}", 100.0 * part.abs(), if part < 0.0 { "larger" } else { "smaller" })
}

/// What of the answer depends on frequencies that nobody measured.
fn unmeasured(above: f64) -> String {
    let tail = |end: &str| {
        let tail = ", where (3.3) gives the\nacceleration a white tail of infinite variance";
        if above.abs() >= MUCH { format!("{tail}{end}") } else { String::new() }
    };
    if above < -0.005 {
        let tail = tail(" that nothing measured supports,");
        return format!(
            "Without the frequencies above the measured band{tail} the mean by the fit would be {}.\n",
            than(above)
        );
    }
    format!(
        "{:.0} % of the mean by the fit comes from frequencies above the measured band{}.\n",
        100.0 * above.max(0.0),
        tail(": nothing measured supports it")
    )
}

/// Why the two means differ, and which to trust.
fn tail(m: &BySpectrum, by_spectrum: bool) -> String {
    let mut text = unmeasured(m.above());
    text.push_str(&format!(
        "The mean by the measured spectrum is {} than by the fit: {} since it ends with the measured band, and\n\
         {} since inside the band the roll is not quite of the form (3.3), or the recording is short.\n",
        than(1.0 - m.ratio()),
        than(m.above()),
        than(m.form())
    ));
    if by_spectrum {
        text.push_str("The measured spectrum has no form forced upon it: trust the last column more.\n");
    }
    text
}
