//! # What it is
//! A force that repeats with time (an engine, a pump, a wave) or with position (cogging, teeth, a
//! bent shaft).
//!
//! # Signature in a recording
//! A line in the spectrum of the residual, or a residual force that repeats with the position.
//!
//! # Equation
//! ```text
//!     M v' = … + A sin(w t) + B cos(w t)    or    + A sin(n q) + B cos(n q)
//!     M v' = … + A sin(w t) + B cos(w t)    w a turn a day, or any form that comes each day to two harmonics:
//!     M v' = … + A_0 + A sin(w t) + B cos(w t) + C sin(2 w t) + D cos(2 w t)
//!     M v' = … + W^2 (A sin(n a) + B cos(n a))    with a recorded angle a of a shaft, n = 1, 2; W its speed, or 1
//!     y -> y + A sin(w t) + B cos(w t)      hum of a sensor
//!     y -> y + A sin(n y) + B cos(n y)      a disc that sits off its centre, n = 1 … 4
//! ```
//!
//! # What else looks like this
//! extra-resonance (a line that the input excites), drift-force at very long periods, gravity-
//! pendulum (once a turn).
//!
//! # Reference
//! S. Kay, Fundamentals of Statistical Signal Processing I (1993), example 4.2.
//!
//! # Example
//! A motor with 24 teeth that cogs; a pump of 5 Hz on the same frame; an encoder whose disc is eccentric; a fan out of
//! balance, whose angle is recorded; the sun on a wall, which nobody measured.

use super::misalignment::ROUND;
use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, edit, field,
};
use crate::units::Unit;
use std::f64::consts::TAU;

/// A periodic force.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "periodic-force",
    "a periodic force",
    Group::Force,
    include_str!("periodic_force.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let motions = scene.motions();
    let timed = motions.iter().flat_map(|m| scene.peaks.iter().map(move |w| (m, *w)));
    let mut all: Vec<Proposal> = timed.filter_map(|(m, w)| with_time(scene, m, w)).collect();
    let seen = scene.model.outputs.iter().flat_map(|o| scene.peaks.iter().map(move |w| (o, *w)));
    // a model without motion follows its inputs at once, with every line that they have
    let moves = !motions.is_empty();
    all.extend(seen.filter(|_| moves).filter_map(|(o, w)| on_output(scene, &o.name, w)));
    all.extend(motions.iter().flat_map(|m| with_shafts(scene, m)));
    if moves && scene.length() > DAYS * DAY {
        all.extend(daily(scene, &motions));
    }
    let turns = scene.model.outputs.iter().flat_map(|o| (1..=4).map(move |n| (o, n)));
    all.extend(turns.filter(|_| !scene.trials).filter_map(|(o, n)| on_turn(scene, &o.name, n)));
    for m in motions.iter().filter(|m| m.speed.is_some()) {
        all.extend(with_place(scene, m));
        all.extend(with_teeth(scene, m));
        let lines = scene.lines.get(&m.state).into_iter().flatten();
        all.extend(lines.filter_map(|n| with_line(scene, m, *n)));
    }
    all
}

/// Amplitudes of a sine and of a cosine of something.
fn parts(d: &mut Draft, unit: &Unit, of: &str) -> (String, String) {
    let part = |d: &mut Draft, name, which| d.amplitude(name, unit, ANY, &format!("{which} part of {of}"));
    (part(d, "A_sin", "sine"), part(d, "A_cos", "cosine"))
}

fn with_time(scene: &Scene, m: &Motion, peak: f64) -> Option<Proposal> {
    let mut d = Draft::at(scene, "periodic-force", m);
    let (a, b) = parts(&mut d, &m.force, "the periodic force");
    let w = frequency(&mut d, scene, peak)?;
    d.force(&m.state, &format!("{a}*sin({w}*t) + {b}*cos({w}*t)"));
    d.start(&[m.size, m.size, peak]);
    let what = field::words(m).acts;
    d.done(&format!("{what} of {{0}} and {{1}} (sine and cosine) acts on {} at {{2}}", scene.words(&m.state)))
}

/// Hum that the sensor alone has.
fn on_output(scene: &Scene, output: &str, peak: f64) -> Option<Proposal> {
    let (size, unit) = (scene.signal(output)?.spread, scene.unit(output));
    let mut d = Draft::new(scene, "periodic-force", SiteKind::Output, output);
    let (a, b) = parts(&mut d, &unit, "the hum");
    let w = frequency(&mut d, scene, peak)?;
    d.output(output, &format!("{{}} + {a}*sin({w}*t) + {b}*cos({w}*t)"));
    d.start(&[size, size, peak]);
    d.done(&format!(
        "the sensor of {} hums with {{0}} and {{1}} (sine and cosine) at {{2}}",
        scene.words(output)
    ))
}

/// The sun's day, s, and how many of them a recording must hold. Its frequency is known and not read from the residual,
/// so that no likelihood is paid for having chosen it.
const DAY: f64 = 86_400.0;
const DAYS: f64 = 1.5;

/// What comes again each day, as a sine or of any form (a mean and two harmonics), on every sum and at every sensor.
fn daily(scene: &Scene, motions: &[Motion]) -> Vec<Proposal> {
    let forms = || [1, 2].into_iter();
    let on_states = motions.iter().flat_map(|m| forms().map(move |most| daily_force(scene, m, most)));
    let on_outputs =
        scene.model.outputs.iter().flat_map(|o| forms().map(move |most| daily_hum(scene, &o.name, most)));
    on_states.chain(on_outputs).flatten().collect()
}

fn daily_force(scene: &Scene, m: &Motion, most: usize) -> Option<Proposal> {
    let mut d = Draft::at(scene, "periodic-force", m);
    let wave = day(&mut d, &m.force, m.size, most)?;
    d.force(&m.state, &wave);
    d.done(&format!("{} acts on {} {}", field::words(m).acts, scene.words(&m.state), often_a_day(most)))
}

fn daily_hum(scene: &Scene, output: &str, most: usize) -> Option<Proposal> {
    let mut d = Draft::new(scene, "periodic-force", SiteKind::Output, output);
    let wave = day(&mut d, &scene.unit(output), scene.signal(output)?.spread, most)?;
    d.output(output, &format!("{{}} + {wave}"));
    d.done(&format!("the sensor of {} errs {}", scene.words(output), often_a_day(most)))
}

fn often_a_day(most: usize) -> &'static str {
    match most {
        1 => "once a day, {0} and {1} (sine and cosine)",
        _ => "by {4} and with the day, {0} and {1} once (sine and cosine), {2} and {3} twice a day",
    }
}

/// A sum of so many harmonics of a day, with their amplitudes; what has a form has a mean.
fn day(d: &mut Draft, unit: &Unit, size: f64, most: usize) -> Option<String> {
    let w = d.constant("w_day", &Unit::parse("rad/s").ok()?, TAU / DAY, "angular frequency of the day");
    let mut sum = Vec::new();
    for n in 1..=most {
        let (a, b) = parts(d, unit, "what comes each day");
        let often = if n == 1 { String::new() } else { format!("{n}*") };
        sum.push(format!("{a}*sin({often}{w}*t) + {b}*cos({often}{w}*t)"));
    }
    if most > 1 {
        sum.push(d.amplitude("A_0", unit, ANY, "mean of what comes each day"));
    }
    d.start(&vec![size; 2 * most + usize::from(most > 1)]);
    Some(sum.join(" + "))
}

/// Turns of a shaft in the recording from which on its orders are looked for.
const SHAFT: f64 = 20.0;

/// The orders of every shaft whose angle is recorded, growing with the square of a recorded speed or not.
fn with_shafts(scene: &Scene, m: &Motion) -> Vec<Proposal> {
    let recorded = [SignalKind::Input, SignalKind::Channel];
    let far = |s: &Signal| s.spread / s.pace * scene.length() > SHAFT * TAU;
    let turns = |s: &&Signal| s.is_heading() && s.max - s.min > 0.9 * TAU && far(s);
    let shafts: Vec<&Signal> = scene.moving(&recorded).filter(turns).collect();
    let speeds: Vec<&Signal> =
        scene.signals.iter().filter(|s| recorded.contains(&s.kind) && edit::is_frequency(&s.unit)).collect();
    let mut all = Vec::new();
    for shaft in shafts {
        for n in [1, 2] {
            all.extend(with_shaft(scene, m, shaft, (None, n)));
            all.extend(speeds.iter().filter_map(|w| with_shaft(scene, m, shaft, (Some(w), n))));
        }
    }
    all
}

fn with_shaft(
    scene: &Scene,
    m: &Motion,
    shaft: &Signal,
    (speed, n): (Option<&Signal>, u8),
) -> Option<Proposal> {
    let mut d = Draft::at(scene, "periodic-force", m);
    let unit = speed.map_or_else(|| m.force.clone(), |w| m.force.over(&scene.unit(&w.name).power(2.0)));
    let (a, b) = parts(&mut d, &unit, "the periodic force");
    let angle = if n == 1 { shaft.name.clone() } else { format!("{n}*{}", shaft.name) };
    let wave = format!("({a}*sin({angle}) + {b}*cos({angle}))");
    d.uses(&shaft.name);
    let (text, size, grows) = match speed {
        Some(w) => {
            d.uses(&w.name);
            let grows = format!(" and the square of {}", scene.words(&w.name));
            (format!("{}^2*{wave}", w.name), m.size / w.size().powi(2), grows)
        }
        None => (wave, m.size, String::new()),
    };
    d.force(&m.state, &text);
    d.start(&[size, size]);
    let (what, often) = (field::words(m).acts, if n == 1 { "once" } else { "twice" });
    let shaft = scene.words(&shaft.name);
    d.done(&format!("{what} goes with {shaft}{grows}, {often} a turn: {{0}} and {{1}} (sine and cosine)"))
}

/// An error of a sensor of angle that repeats so many times a turn.
fn on_turn(scene: &Scene, output: &str, n: u8) -> Option<Proposal> {
    // part of a turn shows what comes once in it, and takes much else for what comes more often
    let goes_round = |s: &&Signal| s.max - s.min > TAU || n == 1 && s.is_heading() && s.spread > ROUND;
    let signal = scene.signal(output).filter(|s| scene.is_angle(&s.name)).filter(goes_round)?;
    let unit = scene.unit(output);
    let mut d = Draft::new(scene, "periodic-force", SiteKind::Output, output);
    let (a, b) = parts(&mut d, &unit, "the error");
    let angle = if n == 1 { "{}".to_string() } else { format!("{n}*{{}}") };
    d.output(output, &format!("{{}} + {a}*sin({angle}) + {b}*cos({angle})"));
    let size = (0.01 * signal.spread).min(0.1);
    d.start(&[size, size]);
    let often = if n == 1 { "once".to_string() } else { format!("{n} times") };
    d.done(&format!(
        "the sensor of {} errs {often} a turn by {{0}} and {{1}} (sine and cosine)",
        scene.words(output)
    ))
}

/// The frequency of a line that was read from the residual, about as exactly as it can be told there.
fn frequency(d: &mut Draft, scene: &Scene, peak: f64) -> Option<String> {
    let width = 6.0 / scene.length();
    let limits = ((peak - width).max(0.0), peak + width);
    Some(d.parameter("w", &Unit::parse("rad/s").ok()?, limits, "angular frequency"))
}

/// Angles of the force over the whole way of a position between which a few guesses find its frequency, rad; and up to which
/// they must where lines of what is left are known, of which none has less than two thirds of that.
const FEW_PERIODS: f64 = 9.0;
const MANY_PERIODS: f64 = 400.0;
const BELOW_LINES: f64 = 30.0;
/// Periods a turn that are tried one by one, at most.
const MOST_TEETH: u8 = 24;

fn with_place(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let signal = scene.signal(m.position.as_ref()?)?;
    let range = signal.max - signal.min;
    let has_lines = scene.lines.contains_key(&m.state);
    let most = if has_lines { BELOW_LINES } else { MANY_PERIODS };
    let turns = [1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 15.0, 19.0, 24.0];
    let mut starts: Vec<f64> =
        turns.iter().map(|turn| turn * TAU).filter(|n| *n < most).map(|n| n / range).collect();
    if scene.is_angle(&signal.name) && !has_lines {
        starts.extend((1..=12).map(f64::from).filter(|n| (FEW_PERIODS..MANY_PERIODS).contains(&(n * range))));
    }
    repeating(scene, m, (FEW_PERIODS / range, most / range), &starts)
}

/// Whole numbers of periods a turn, where the shaft turns so often that a few guesses over all of its way find none of them.
fn with_teeth(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let signal = scene.signal(m.position.as_ref()?).filter(|s| scene.is_angle(&s.name))?;
    let range = signal.max - signal.min;
    let starts: Vec<f64> = (1..=MOST_TEETH).map(f64::from).filter(|n| n * range >= MANY_PERIODS).collect();
    let (first, last) = (*starts.first()?, *starts.last()?);
    repeating(scene, m, (first - 0.5, last + 0.5), &starts)
}

/// A force of one frequency in space that was read from the residual, about as exactly as it can be told there.
fn with_line(scene: &Scene, m: &Motion, n: f64) -> Option<Proposal> {
    let signal = scene.signal(m.position.as_ref()?)?;
    // frequencies are told apart where their phases part by a turn over the whole way
    let apart = TAU / (signal.max - signal.min);
    let starts = [-0.3, -0.1, 0.1, 0.3].map(|k| n + k * apart);
    repeating(scene, m, ((n - apart).max(0.0), n + apart), &starts)
}

fn repeating(scene: &Scene, m: &Motion, limits: (f64, f64), starts: &[f64]) -> Option<Proposal> {
    let q = m.position.as_ref()?;
    let mut d = Draft::at(scene, "periodic-force", m);
    let (a, b) = parts(&mut d, &m.force, "the periodic force");
    let unit = Unit::parse("rad").ok()?.over(&scene.signal(q)?.unit);
    let n = d.parameter("n", &unit, limits, "angle of the force for a unit of the position");
    d.force(&m.state, &format!("{a}*sin({n}*{q}) + {b}*cos({n}*{q})"));
    for n in starts {
        d.start(&[m.size, m.size, *n]);
    }
    let what = field::words(m).acts;
    d.done(&format!("{what} repeats with {}, {{0}} and {{1}} (sine and cosine) at {{2}}", scene.words(q)))
}
