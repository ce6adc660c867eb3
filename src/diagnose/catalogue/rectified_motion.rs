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
//!     y  = … + k a^2 sin(2 K)/(1 + w^2 T^2)    (steady trials of amplitude a, or a w^2, at heading K)
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

use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, edit,
};
use crate::units::Unit;

/// A slow effect of the product of two fast motions.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "rectified-motion",
    "a slow effect of the product of two fast motions",
    Group::Rectified,
    include_str!("rectified_motion.rs"),
    propose,
);

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

/// What a steady trial swings with: a column of angular rates ω, or of periods 2π/ω.
struct Swing<'a> {
    signal: &'a Signal,
    text: String,
    unit: Unit,
    size: f64,
}

impl<'a> Swing<'a> {
    fn of(signal: &'a Signal) -> Option<Self> {
        if edit::is_frequency(&signal.unit) {
            return Some(Self {
                signal,
                text: signal.name.clone(),
                unit: signal.unit.clone(),
                size: signal.size(),
            });
        }
        is_time(&signal.unit).then(|| Self {
            signal,
            text: format!("(2*pi/{})", signal.name),
            unit: Unit::one().over(&signal.unit),
            size: 2.0 * std::f64::consts::PI / signal.size(),
        })
    }
}

fn is_time(unit: &Unit) -> bool {
    Unit::parse("s").is_ok_and(|s| s.dimension() == unit.dimension())
}

/// In a table of steady trials: what goes with the square of an amplitude, or of an amplitude times ω²,
/// and with twice the heading; perhaps behind a lag.
fn steady(scene: &Scene) -> Vec<Proposal> {
    let moving: Vec<&Signal> = scene.moving(&[SignalKind::Input, SignalKind::Channel]).collect();
    let swings: Vec<Swing<'_>> = moving.iter().filter_map(|s| Swing::of(s)).collect();
    let amplitudes = moving.iter().filter(|s| s.min >= 0.0 && !s.is_heading() && Swing::of(s).is_none());
    let mut all = Vec::new();
    for o in &scene.model.outputs {
        for h in scene.headings() {
            for a in amplitudes.clone() {
                let law = |w: Option<&Swing<'_>>, lag| in_trials(scene, (&o.name, &h.name), a, (w, lag));
                all.extend(law(None, None));
                for w in &swings {
                    all.extend(
                        [law(Some(w), None), law(None, Some(w)), law(Some(w), Some(w))].into_iter().flatten(),
                    );
                }
            }
        }
    }
    all
}

/// y = … + k A² sin 2K/(1 + ω²T²), A an amplitude a or a ω²: the mean of the product of two accelerations,
/// one of them behind a lag T (Potemkin, from (2.1)).
fn in_trials(
    scene: &Scene,
    (output, heading): (&str, &str),
    a: &Signal,
    (of_rate, lag): (Option<&Swing<'_>>, Option<&Swing<'_>>),
) -> Option<Proposal> {
    let mut d = Draft::new(scene, "rectified-motion", SiteKind::Output, output);
    let (text, unit, size) = match of_rate {
        Some(w) => (
            format!("({}*{}^2)", a.name, w.text),
            a.unit.times(&w.unit.power(2.0)),
            a.size() * w.size.powi(2),
        ),
        None => (a.name.clone(), a.unit.clone(), a.size()),
    };
    let k = d.amplitude(
        "k_rect",
        &scene.unit(output).over(&unit.power(2.0)),
        ANY,
        "strength of the rectified motion",
    );
    d.uses(&a.name);
    if let Some(w) = of_rate.or(lag) {
        d.uses(&w.signal.name);
    }
    d.uses(heading);
    let strength = scene.signal(output)?.spread / size.powi(2);
    let (mut under, mut behind) = (String::new(), "");
    if let Some(w) = lag {
        let t =
            d.parameter("T_rect", &Unit::parse("s").ok()?, (0.0, 10.0 / w.size), "lag of the shifted part");
        under = format!("/(1 + ({}*{t})^2)", w.text);
        behind = ", behind a lag of {1}";
        for share in [0.3, 1.0, 3.0] {
            d.start(&[strength, share / w.size]);
        }
    } else {
        d.start(&[strength]);
    }
    let term = format!("{k}*{text}^2*sin(2*{heading}){under}");
    d.output(output, &format!("{{}} + {term}"));
    d.term(&term);
    let words = scene.words(output);
    d.done(&format!("{words} shows {{0}} times the square of {text} and the sine of twice {heading}{behind}: a rectified motion"))
}

/// Pairs whose product may have a mean. Of two components of one motion the order makes no
/// difference, because the heading is slow: each such pair stands once.
fn pairs<'a>(scene: &Scene, atoms: &'a [Atom]) -> Vec<(&'a Atom, &'a Atom)> {
    let all =
        atoms.iter().enumerate().flat_map(|(i, a)| atoms.iter().enumerate().map(move |(j, b)| (i, a, j, b)));
    let kept = all
        .filter(|(i, a, j, b)| scene.keep_company(&a.signal, &b.signal) && (i <= j || a.signal != b.signal));
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
        let atom = |text: String| Atom {
            text,
            signal: s.name.clone(),
            unit: s.unit.clone(),
            size: s.spread,
            pace: s.pace,
        };
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
    let k =
        d.amplitude("k_rect", &unit.over(&a.unit.times(&b.unit)), ANY, "strength of the rectified product");
    let lag =
        d.parameter("T_rect", &Unit::parse("s").ok()?, (0.0, 100.0 * b.pace), "lag of the shifted part");
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
        scene.words(&a.text),
        scene.words(&b.text),
        scene.words(&m.state)
    ))
}

fn seen(scene: &Scene, output: &str, a: &Atom, b: &Atom) -> Option<Proposal> {
    let mut d = Draft::new(scene, "rectified-motion", SiteKind::Output, output);
    let size = scene.signal(output)?.spread;
    let text = product(&mut d, &scene.unit(output), a, b, size)?;
    d.output(output, &format!("{{}} + {text}"));
    d.term(&text);
    d.done(&format!(
        "{} shows the product of {} with {} behind a lag of {{1}}, times {{0}}",
        scene.words(output),
        a.text,
        b.text
    ))
}
