//! # What it is
//! Two fast motions multiply, one of them through a lag or a resonance; their product has a mean,
//! and the mean pushes a slow equation. The rolling error of a gyrocompass is one: the acceleration
//! along the meridian acts on a centre of mass that the acceleration along the parallel has
//! shifted.
//!
//! # Signature in a recording
//! A slow error that grows with the square of the motion, changes sign from quadrant to quadrant
//! (sine of twice the heading) and vanishes in calm water, with no line of its own in the spectrum.
//!
//! # Equation
//! ```text
//!     s' = … + k A lag(B, T)     (gyrosphere: A = W2, B = W1, k = P^2/(g^2 C0 H), mean by I_n)
//!     y  = … + k a^2 sin(2 K)    (steady trials of amplitude a, or a w^2, at heading K)
//! ```
//!
//! # What else looks like this
//! constant-force where the motion never changes; cross-coupling (linear, no mean), misalignment.
//!
//! # Reference
//! W. Potemkin (1978), (2.1) to (3.13); Isserlis (1918) for the mean of the product.
//!
//! # Example
//! The heading of a gyrocompass with an elastic suspension on irregular roll, modelled by the
//! precession theory alone.

use super::{draft::ANY, edit, Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind};
use crate::units::Unit;

/// A slow effect of the product of two fast motions.
pub(super) const MECHANISM: Mechanism = Mechanism::new("rectified-motion", "a slow effect of the product of two fast motions", Group::Rectified, include_str!("rectified_motion.rs"), propose);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return steady(scene);
    }
    let atoms = atoms(scene);
    let mut all = Vec::new();
    let pairs = pairs(scene, &atoms);
    for m in scene.motions() {
        all.extend(pairs.iter().filter_map(|(a, b)| at(scene, &m, a, b)));
    }
    for o in &scene.model.outputs {
        all.extend(pairs.iter().filter_map(|(a, b)| seen(scene, &o.name, a, b)));
    }
    all
}

/// In a table of steady trials: what goes with the square of an amplitude, or of an amplitude times the
/// square of a frequency, and with twice the heading.
fn steady(scene: &Scene) -> Vec<Proposal> {
    let moving: Vec<&Signal> = scene.moving(&[SignalKind::Input, SignalKind::Channel]).collect();
    let is_rate = |s: &&&Signal| edit::is_frequency(&s.unit);
    let amplitudes = moving.iter().filter(|s| s.min >= 0.0 && !s.is_heading() && !is_rate(s));
    let mut all = Vec::new();
    for o in &scene.model.outputs {
        for h in scene.headings() {
            for a in amplitudes.clone() {
                all.extend(in_trials(scene, &o.name, &h.name, (a, None)));
                let rates = moving.iter().filter(is_rate);
                all.extend(rates.filter_map(|w| in_trials(scene, &o.name, &h.name, (a, Some(w)))));
            }
        }
    }
    all
}

fn in_trials(scene: &Scene, output: &str, heading: &str, (a, w): (&Signal, Option<&Signal>)) -> Option<Proposal> {
    let mut d = Draft::new(scene, "rectified-motion", SiteKind::Output, output);
    let (text, unit, size) = match w {
        Some(w) => (
            format!("({}*{}^2)", a.name, w.name),
            a.unit.times(&w.unit.power(2.0)),
            a.size() * w.size().powi(2),
        ),
        None => (a.name.clone(), a.unit.clone(), a.size()),
    };
    let k = d.amplitude("k_rect", &scene.unit(output).over(&unit.power(2.0)), ANY, "strength of the rectified motion");
    for s in [Some(a), w].into_iter().flatten() {
        d.uses(&s.name);
    }
    d.uses(heading);
    let term = format!("{k}*{text}^2*sin(2*{heading})");
    d.output(output, &format!("{{}} + {term}"));
    d.term(&term);
    d.start(&[scene.signal(output)?.spread / size.powi(2)]);
    d.done(&format!("{} shows {{0}} times the square of {text} and the sine of twice {heading}: a rectified motion", scene.words(output)))
}

/// Pairs whose product may have a mean. Of two components of one motion the order makes no
/// difference, because the heading is slow: each such pair stands once.
fn pairs<'a>(scene: &Scene, atoms: &'a [Atom]) -> Vec<(&'a Atom, &'a Atom)> {
    let all = atoms.iter().enumerate().flat_map(|(i, a)| atoms.iter().enumerate().map(move |(j, b)| (i, a, j, b)));
    let kept = all.filter(|(i, a, j, b)| scene.keep_company(&a.signal, &b.signal) && (i <= j || a.signal != b.signal));
    kept.map(|(_, a, _, b)| (a, b)).collect()
}

/// A fast signal, perhaps with the sine or cosine of the heading.
struct Atom {
    text: String,
    signal: String,
    unit: Unit,
    size: f64,
    pace: f64,
}

fn atoms(scene: &Scene) -> Vec<Atom> {
    let headings = scene.headings();
    let mut atoms = Vec::new();
    for s in scene.moving(&[SignalKind::Input, SignalKind::Channel]) {
        let fast = s.pace < 0.02 * scene.length() && s.mean.abs() < s.spread;
        if !fast || s.is_heading() {
            continue;
        }
        let atom = |text: String| Atom { text, signal: s.name.clone(), unit: s.unit.clone(), size: s.spread, pace: s.pace };
        match headings.iter().find(|h| h.spread > 0.1) {
            Some(h) => {
                atoms.push(atom(format!("{}*sin({})", s.name, h.name)));
                atoms.push(atom(format!("{}*cos({})", s.name, h.name)));
            }
            None => atoms.push(atom(s.name.clone())),
        }
    }
    atoms
}

fn product(d: &mut Draft, unit: &Unit, a: &Atom, b: &Atom, size: f64) -> Option<String> {
    let k = d.amplitude("k_rect", &unit.over(&a.unit.times(&b.unit)), ANY, "strength of the rectified product");
    let lag = d.parameter("T_rect", &Unit::parse("s").ok()?, (0.0, 100.0 * b.pace), "lag of the shifted part");
    for s in [&a.signal, &b.signal] {
        d.uses(s);
    }
    for times in [0.1, 0.5, 2.0] {
        d.start(&[size / (a.size * b.size), times * b.pace]);
    }
    Some(format!("{k}*{}*lag({}, {lag})", a.text, b.text))
}

fn at(scene: &Scene, m: &Motion, a: &Atom, b: &Atom) -> Option<Proposal> {
    let mut d = Draft::at(scene, "rectified-motion", m);
    let text = product(&mut d, &m.force, a, b, m.size)?;
    d.force(&m.state, &text);
    d.done(&format!(
        "the product of {} with {} behind a lag of {{1}} pushes {}: a rectified motion of strength {{0}}",
        scene.words(&a.text), scene.words(&b.text), scene.words(&m.state)
    ))
}

fn seen(scene: &Scene, output: &str, a: &Atom, b: &Atom) -> Option<Proposal> {
    let mut d = Draft::new(scene, "rectified-motion", SiteKind::Output, output);
    let size = scene.signal(output)?.spread;
    let text = product(&mut d, &scene.unit(output), a, b, size)?;
    d.output(output, &format!("{{}} + {text}"));
    d.term(&text);
    d.done(&format!("{} shows the product of {} with {} behind a lag of {{1}}, times {{0}}", scene.words(output), a.text, b.text))
}
