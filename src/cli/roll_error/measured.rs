//! The rolling error on a recorded roll.

use super::parameters::Compass;
use crate::gyro::seed;
use crate::record::Recording;
use crate::report::terminal::{Trace, picture};
use crate::spectrum::{
    CorrelationFit, EvenSamples, Measured, autocovariance, even_samples, fit_correlation, welch, without_slow,
};
use crate::{Error, Result};
use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::path::Path;

/// A recorded roll with its spectrum and the fit of (3.3).
pub struct Analysis {
    pub name: String,
    pub samples: EvenSamples,
    pub spectrum: Measured,
    pub fit: CorrelationFit,
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
    let peak = welch(&rolling.values, samples.step, length)?.peak();
    // lags over about six periods of the peak, at most a quarter of the recording
    let lags = ((6.0 * TAU / peak / samples.step) as usize).clamp(8, (samples.values.len() / 4).max(8));
    let all = autocovariance(&samples.values, 0)[0];
    let measured = autocovariance(&rolling.values, lags);
    let fit = fit_correlation(&measured, samples.step, peak)?;
    let slow_share = (1.0 - measured[0] / all).max(0.0);
    Ok(Analysis {
        name: recording.name.clone(),
        samples,
        spectrum,
        fit,
        peak,
        deviation: all.sqrt(),
        slow_share,
    })
}

/// ⟨θ̈·lagged θ̈⟩ three ways, rad²/s⁴: by I₃ of the fit, by the fit on the measured band, and by
/// quadrature over the measured spectrum.
struct Moments {
    integral: f64,
    banded: f64,
    measured: f64,
}

fn moments(a: &Analysis, lag: f64) -> Result<Moments> {
    // ω⁴/(1 + ω²T²)
    let weight = |w: f64| w.powi(4) / (1.0 + (w * lag).powi(2));
    let limit = PI / a.samples.step;
    let roll = a.fit.roll;
    let banded = quadrature_over(limit, |w| roll.density(w) * weight(w)) / PI;
    Ok(Moments {
        integral: seed::rectified_moment(&roll, lag)?.value,
        banded,
        measured: a.spectrum.integral(weight),
    })
}

/// Simpson's rule on 0 … limit; the integrand is smooth on the scale of its 4000 panels.
fn quadrature_over(limit: f64, f: impl Fn(f64) -> f64) -> f64 {
    let panels = 4000;
    let h = limit / f64::from(panels);
    let inner: f64 = (1..panels).map(|k| f(f64::from(k) * h) * if k % 2 == 1 { 4.0 } else { 2.0 }).sum();
    h / 3.0 * (f(0.0) + inner + f(limit))
}

pub fn text(compass: &Compass, path: &Path, roll: Option<&str>) -> Result<String> {
    let recording = super::recording::read(path, roll)?;
    let mut compass_here = compass.sphere;
    if let Some(latitude) = recording.constant("lat") {
        compass_here.latitude = latitude;
        compass_here.check()?;
    }
    let analysis = analyse(&recording, &super::recording::roll_name(&recording, roll)?)?;
    let mut out = motion(&analysis);
    let m = moments(&analysis, compass_here.lag)?;
    // the error on heading 45° a unit of the moment
    let unit = seed::error_of_moment(&compass_here, 1.0, PI / 4.0).to_degrees();
    let _ = writeln!(
        out,
        "Mean rolling error of this gyrocompass on this ship ({}): h = {} m, latitude {:.1}°\n\
         \x20 heading    fit, all frequencies    fit, measured band    measured spectrum\n\
         \x20             (I₃, exact)             (to {:.2} rad/s)       (quadrature)",
        compass.described(),
        compass_here.lever,
        compass_here.latitude.to_degrees(),
        PI / analysis.samples.step
    );
    for heading in (0..360).step_by(15) {
        let sine = (2.0 * f64::from(heading).to_radians()).sin() * unit;
        let _ = writeln!(
            out,
            "  {heading:>4}°     {:>12.5}°          {:>12.5}°        {:>12.5}°",
            shown(sine * m.integral),
            shown(sine * m.banded),
            shown(sine * m.measured)
        );
    }
    out.push_str(&tail(&m));
    Ok(out)
}

/// No sign on a zero.
fn shown(degrees: f64) -> f64 {
    if degrees.abs() < 5e-6 { 0.0 } else { degrees }
}

fn motion(a: &Analysis) -> String {
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
        m if m < 0.05 => "a good fit",
        m if m < 0.15 => "a fair fit: trust the column of the measured spectrum more",
        _ => "a poor fit: this roll is not of the form (3.3); use the column of the measured spectrum",
    };
    let degrees2 = |k: &f64| k.to_degrees().to_degrees();
    let measured: Vec<f64> = a.fit.measured.iter().map(degrees2).collect();
    let fitted: Vec<f64> =
        (0..measured.len()).map(|k| degrees2(&roll.correlation(k as f64 * step))).collect();
    let last = format!("{:.0} s", (measured.len() - 1) as f64 * step);
    format!(
        "Roll of `{}`: {n} samples {step:.4} s apart, {:.1} min; standard deviation {sigma:.3}°\n\
         {slow}highest spectral point of the roll at {:.3} rad/s (period {:.1} s), from {} segments\n\n\
         Fit of K(τ) = A e^(−μ|τ|) (cos ετ + (μ/ε) sin ε|τ|) to the correlation function, lags 0 … {last}\n\
         \x20 A = {:.4e} rad² ({:.3}°)²,  μ = {:.4} 1/s,  ε = {:.4} rad/s (period {:.1} s)\n\
         \x20 explains {:.1} % of it; misfit {:.1} % of K(0): {verdict}\n\n\
         K(τ), deg²: o measured, · fitted\n{}\n",
        a.name,
        n as f64 * step / 60.0,
        a.peak,
        TAU / a.peak,
        a.spectrum.segments,
        roll.variance,
        roll.variance.sqrt().to_degrees(),
        roll.decay,
        roll.frequency,
        TAU / roll.frequency,
        100.0 * a.fit.r_squared,
        100.0 * a.fit.misfit,
        picture(
            &[Trace { mark: 'o', values: &measured }, Trace { mark: '·', values: &fitted }],
            (64, 13),
            ("τ = 0", &last)
        )
    )
}

/// What of the answer hangs on frequencies that nobody measured.
fn tail(m: &Moments) -> String {
    let share = 100.0 * (1.0 - m.banded / m.integral);
    if share < 10.0 {
        return format!("{share:.0} % of the first column comes from frequencies above the measured band.\n");
    }
    format!(
        "{share:.0} % of the first column comes from frequencies above the measured band, where (3.3) gives the\n\
         acceleration a white tail of infinite variance: nothing measured supports it. Use the other two columns.\n"
    )
}
