//! # What it is
//! A force of constant size that acts against the motion, whatever its speed. At rest it holds the
//! part until the other forces exceed it.
//!
//! # Signature in a recording
//! Decay of a free motion is a straight line, not an exponential; small motions stop short. The
//! residual force jumps when the speed changes its sign, and depends on the speed by its sign
//! alone. A current through brushes or diodes drops a voltage so, whatever its size.
//!
//! # Equation
//! ```text
//!     M v' = … - Fc sign(v),  Fc >= 0
//!     M v' = … - Fc tanh(v/vs)             where it turns over not at once
//!     c (v - w) -> c (v - w) + Fc sign(v - w) of a damper between two bodies
//! ```
//!
//! # What else looks like this
//! stribeck-friction (more at rest than in motion), asymmetric-friction (other size each way),
//! backlash, hysteresis; at one amplitude only, linear-damping.
//!
//! # Reference
//! C. Canudas de Wit et al., A new model for control of systems with friction, IEEE Trans. Autom.
//! Control 40 (1995) 419.
//!
//! # Example
//! A positioning axis modelled with viscous friction alone; 20 N of dry friction in its guides.

use super::between::{self, Between, Of};
use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE};

/// Dry (Coulomb) friction.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "dry-friction",
    "dry (Coulomb) friction",
    Group::Friction,
    include_str!("dry_friction.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = Vec::new();
    for m in scene.motions() {
        all.extend(at(scene, &m).into_iter().chain(ROUNDED.iter().filter_map(|r| rounded(scene, &m, *r))));
        all.extend(gradual(scene, &m));
    }
    all.extend(between::all(scene, Of::Speeds).iter().filter_map(|b| rubs(scene, b)));
    all.extend(scene.richer_lag("dry-friction").and_then(|(mut d, lag)| {
        let f = d.amplitude("Fc_T", &lag.acceleration_unit(scene), POSITIVE, "dry friction over stiffness");
        let (w, a) = (&lag.frequency, lag.amplitude.as_ref()?);
        d.lag_factor(&format!("1 + (sqrt({}) + {f}/({a}*{w}^2))^2", lag.square));
        d.start(&[0.3 * scene.size(a) * scene.size(w).powi(2)]);
        d.done(&format!("dry friction in the giving part, {{0}}, adds most to its lag at small {a}"))
    }));
    all
}

fn at(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.flows(scene)?;
    let mut d = Draft::at(scene, "dry-friction", m);
    let (meaning, says) = match m.speed {
        Some(_) => ("dry friction", format!("dry friction of {{0}} acts against {}", scene.words(v))),
        None => (
            "drop of constant size",
            format!("a drop of {{0}} stands against {}, whatever its size", scene.words(v)),
        ),
    };
    let f = d.amplitude("Fc", &m.force, POSITIVE, meaning);
    d.force(&m.state, &format!("-{f}*sign({v})"));
    d.start(&[m.size]);
    d.done(&says)
}

/// Where friction may turn over, and where that is looked for first, as shares of the speed's spread. What is sharp makes short
/// steps, and stands alone.
const ROUNDED: [((f64, f64), f64); 2] = [((5e-3, 0.1), 0.02), ((5e-4, 6e-3), 3e-3)];

/// The same of friction of which much of the motion sees the turn.
const GRADUAL: ((f64, f64), f64) = ((0.08, 1.0), 0.25);

/// Friction that turns over within a range of speeds, small beside those of the recording.
fn rounded(scene: &Scene, m: &Motion, range: ((f64, f64), f64)) -> Option<Proposal> {
    let mut d = Draft::at(scene, "dry-friction", m);
    d.refines();
    turning(scene, d, m, range)
}

/// Friction that turns over within speeds that are many of the recording's, as that of a wet seal does.
fn gradual(scene: &Scene, m: &Motion) -> Option<Proposal> {
    turning(scene, Draft::at(scene, "dry-friction", m), m, GRADUAL)
}

/// Friction that turns over within a range of speeds, as shares of their spread.
fn turning(scene: &Scene, mut d: Draft, m: &Motion, (within, first): ((f64, f64), f64)) -> Option<Proposal> {
    let v = m.speed.as_ref()?;
    let spread = scene.signal(v)?.spread;
    let f = d.amplitude("Fc", &m.force, POSITIVE, "dry friction");
    let within = (within.0 * spread, within.1 * spread);
    let vs = d.parameter("vs", &scene.unit(v), within, "speed within which it turns over");
    d.force(&m.state, &format!("-{f}*tanh({v}/{vs})"));
    d.start(&[m.size, first * spread]);
    d.done(&format!("dry friction of {{0}} acts against {}, and turns over within {{1}}", scene.words(v)))
}

/// Friction between two bodies.
fn rubs(scene: &Scene, b: &Between) -> Option<Proposal> {
    let mut d = b.draft(scene, "dry-friction");
    let f = d.amplitude("Fc", &b.force, POSITIVE, "dry friction between the two");
    b.obeys(&mut d, &|v, _| format!("{}*{v} + {f}*sign({v})", b.parameter));
    d.start(&[b.force_size(scene)]);
    d.done(&format!("dry friction of {{0}} acts against {}", b.difference))
}
