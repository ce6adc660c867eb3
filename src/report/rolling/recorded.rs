//! What is said of a recorded roll and its fit.

use crate::report::terminal::{Trace, picture};
use crate::rolling::{FAST_SHARE, MeasuredRoll, STEADY};
use crate::spectrum::{Interval, RollIntervals};
use crate::units::significant;
use std::f64::consts::{PI, TAU};

/// The recorded roll and its fit in words, with a picture of the correlation.
pub fn told(r: &MeasuredRoll) -> String {
    let a = &r.analysis;
    let degrees2 = |k: &f64| k.to_degrees().to_degrees();
    let measured: Vec<f64> = a.fit.measured.iter().map(degrees2).collect();
    let fitted: Vec<f64> = a.fit.fitted.iter().map(degrees2).collect();
    let last = format!("{:.0} s", (measured.len() - 1) as f64 * a.samples.step);
    format!(
        "{}\nK(τ), deg²: o measured, · fitted\n{}\n",
        words(r),
        picture(
            &[Trace { mark: 'o', values: &measured }, Trace { mark: '·', values: &fitted }],
            (64, 13),
            ("τ = 0", &last)
        )
    )
}

/// The recorded roll and its fit in words.
pub fn words(r: &MeasuredRoll) -> String {
    let a = &r.analysis;
    let (n, step) = (a.samples.values.len(), a.samples.step);
    let gaps = match a.samples.values.iter().filter(|v| !v.is_finite()).count() {
        0 => String::new(),
        k => format!(", {k} of them missing"),
    };
    let roll = a.fit.roll;
    let sigma = a.deviation.to_degrees();
    let slow = match 100.0 * a.slow_share {
        s if s < 1.0 => String::new(),
        s => format!(
            "{s:.0} % of the variance is heel slower than 31 s, left out of the fit: it hardly accelerates\n"
        ),
    };
    let fast = match a.fast_share {
        s if s < FAST_SHARE => String::new(),
        s => format!(
            "{:.0} % of the variance is in the upper half of the band, over {:.2} rad/s: the samples are too far apart, and what \
             moves faster than they follow was folded down into the band; no figure here is sure\n",
            100.0 * s,
            0.5 * PI / step
        ),
    };
    // an amplitude a has x² = a²/2 on the mean, and ⟨x⁴⟩/⟨x²⟩² = 3/2 (1 + var a²/⟨a²⟩²), where a random one has var a² = ⟨a²⟩²
    let steady = match a.kurtosis {
        k if k < STEADY => format!(
            "this roll keeps its size (kurtosis {k:.2}; 3 where waves come and go at random, 1.5 for a sine): the slow part of \
             the spread,\nand with it the whole, is that of a random roll, some {:.0} times too large here or more; \
             --regular AMPLITUDE,PERIOD asks for a steady one\n",
            (1.0 / (k / 1.5 - 1.0).max(1e-2)).sqrt()
        ),
        _ => String::new(),
    };
    let verdict = match a.fit.misfit {
        m if m < MeasuredRoll::FAIR => "a good fit",
        _ if r.mean.is_none() => "this roll is hardly of that form, and the quick spread a guide alone",
        m if m < 0.15 => "a fair fit: trust the column of the measured spectrum more",
        _ => "a poor fit: this roll is not of that form; use the column of the measured spectrum",
    };
    format!(
        "Roll of `{}`: {n} samples {step:.4} s apart{gaps}, {:.1} min; standard deviation {sigma:.3}°\n\
         {fast}{slow}{steady}highest spectral point of the roll at {:.3} rad/s (period {:.1} s), from {} segments\n\n\
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
fn unmeasured(above: f64, banded: bool) -> String {
    let tail = |end: &str| {
        let tail = ", where that form gives the\nacceleration a white tail of infinite variance";
        if above.abs() >= MeasuredRoll::MUCH && !banded { format!("{tail}{end}") } else { String::new() }
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

/// How the figures of a part that is not linear come about.
const FOLLOWED: &str = "The elastic part is not linear: it is followed in time through the recording itself, up to the end of \
its band, and the mean is\nthat of such a roll within the margin told (99 %, from blocks of the recording, with the error of the \
step). The quick\nspread is that of the fit. Rounding and noise of the samples shake the part too: --band takes them away.\n";

/// Why the two means differ, and what follows where the measured spectrum's is the one to trust.
pub fn differs(measured: &MeasuredRoll, follows: &str) -> String {
    let Some(m) = &measured.mean else { return FOLLOWED.into() };
    let mut text = unmeasured(m.above(), measured.band.is_some());
    if let Some(q) = measured.analysis.quantum.filter(|_| measured.is_rounded()) {
        text.push_str(&format!(
            "The roll was recorded in steps of {}°: their rounding alone makes {:.0} % of the mean by the fit in the measured\n\
             spectrum, so that the mean by the fit is the one to take; --band takes away what is faster than the ship.\n",
            significant(q.to_degrees(), 3),
            100.0 * measured.rounding.abs()
        ));
    }
    text.push_str(&format!(
        "The mean by the measured spectrum is {} than by the fit: {} since it ends with the measured band, and\n\
         {} since inside the band the roll is not quite of the fitted form, or the recording is short.\n",
        than(1.0 - m.ratio()),
        than(m.above()),
        than(m.form())
    ));
    if measured.is_surer() {
        text.push_str(&format!("The measured spectrum has no form forced upon it: {follows}.\n"));
    }
    text
}
