//! # What it is
//! A second oscillating part: a flexible shaft, a sloshing tank, a swinging load.
//!
//! # Signature in a recording
//! A peak and a notch in the response where the model is smooth; ringing at a frequency that no
//! equation has.
//!
//! # Equation
//! ```text
//!     f'' = p,  M v' = … - p/W^2,  p = W^2 (c q - f) + 2 zeta W (c v - f')    f = c z, of the shift z of the second part
//!     z'' + 2 zeta W z' + W^2 z = W^2 q,  q -> z where it is used
//!     M v' = … - c p,  p = (W^2 z + 2 zeta W z')/(1 + c/M),  z'' = v' - p     where the model has a speed and no position
//! ```
//!
//! # What else looks like this
//! periodic-force (a line without cause in the input), memory, extra-lag (far below the peak).
//!
//! # Reference
//! J. P. Den Hartog, Mechanical Vibrations, 4th ed. (1956), ch. 3.
//!
//! # Example
//! A crane with a swinging load, modelled as a trolley alone.

use super::{Draft, Group, Mechanism, Motion, Proposal, Scene, draft::POSITIVE, edit::Place};
use crate::model::Initial;
use crate::units::Unit;

/// A resonance that the model lacks.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "extra-resonance",
    "a resonance that the model lacks",
    Group::Dynamics,
    include_str!("extra_resonance.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all: Vec<Proposal> = Vec::new();
    for m in scene.motions() {
        all.extend([beside(scene, &m), carried(scene, &m), after(scene, &m)].into_iter().flatten());
    }
    all
}

/// The states of a second part: its shift, or what goes with it, and the rate of that.
fn part(d: &mut Draft, unit: &Unit, meaning: &str) -> Option<[String; 2]> {
    let turn = Unit::parse("rad/s").ok()?;
    let z = d.state("zr_shift", unit, Initial::Fit, meaning);
    let r = d.state("zr_rate", &unit.times(&turn), Initial::Fit, "its rate");
    d.rate(&z, &r);
    Some([z, r])
}

/// A part that hangs on a position by a spring and a damper, both of which push back. Its state is the force that its shift
/// makes in the spring, so that a part that swings already at the beginning enters as linearly as the spring does.
fn beside(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let (q, v) = (m.position.as_ref()?, m.speed.as_ref()?);
    let mut d = Draft::at(scene, "extra-resonance", m);
    let c = d.amplitude("c", &m.force.over(&scene.unit(q)), POSITIVE, "stiffness of the coupling");
    let (w, zeta) = swing(&mut d, scene)?;
    let [f, r] = part(&mut d, &m.force, "force of the shift of the second part")?;
    d.rate(&r, &format!("{w}^2*({c}*{q} - {f}) + 2*{zeta}*{w}*({c}*{v} - {r})"));
    d.force(&m.state, &format!("-({c}*{q} - {f} + 2*{zeta}/{w}*({c}*{v} - {r}))"));
    for w in scene.frequencies() {
        d.start(&[m.size / scene.size(q), w, 0.1]);
    }
    d.done(&format!("a second part is attached to {} and swings at {{1}}", scene.words(q)))
}

/// A part behind an elastic joint, where the model has the speed alone. What swings are the twist of the joint and its
/// rate, the slip, so that both parts start with one speed; W is the frequency that a recording shows, at which they swing
/// against each other: z'' + 2 zeta W z' + W^2 z is what the forces make without the second part, whatever its inertia.
fn carried(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let v = m.speed.as_ref().filter(|_| m.position.is_none())?;
    let second = Unit::parse("s").ok()?;
    let mut d = Draft::at(scene, "extra-resonance", m);
    let unit = m.force.over(&scene.unit(v).over(&second));
    let c = d.amplitude("c", &unit, POSITIVE, "inertia of the second part");
    let (w, zeta) = swing(&mut d, scene)?;
    let twist = d.state("zr_shift", &scene.unit(v).times(&second), Initial::Fit, "twist of the joint");
    let slip = d.state("zr_rate", &scene.unit(v), Initial::Fit, "its rate");
    let share = d.felt(&m.state, &c)?;
    let pull = format!("(({w}^2*{twist} + 2*{zeta}*{w}*{slip})/(1 + {share}))");
    d.force(&m.state, &format!("-{c}*{pull}"));
    let own = d.rate_of(&m.state);
    d.rate(&twist, &slip);
    d.rate(&slip, &format!("{own} - {pull}"));
    for w in scene.frequencies() {
        d.start(&[m.size / (w * scene.size(v)), w, 0.1]);
    }
    d.done(&format!(
        "{} carries a second part through an elastic joint, on which both swing at {{1}}",
        scene.words(v)
    ))
}

/// Frequency and damping ratio of a resonance.
fn swing(d: &mut Draft, scene: &Scene) -> Option<(String, String)> {
    let turn = Unit::parse("rad/s").ok()?;
    let fastest = std::f64::consts::PI / scene.step;
    let w = d.parameter("Wr", &turn, (1.0 / scene.length(), fastest), "angular frequency of the resonance");
    Some((w, d.parameter("zr", &Unit::one(), (1e-4, 1.0), "damping ratio of the resonance")))
}

fn after(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let s = &m.state;
    let mut d = Draft::at(scene, "extra-resonance", m);
    let (w, zeta) = swing(&mut d, scene)?;
    let own = part(&mut d, &scene.unit(s), "shift of the second part")?;
    let [z, r] = &own;
    d.rate(r, &format!("{w}^2*({s} - {z}) - 2*{zeta}*{w}*{r}"));
    d.replace(s, z, |p| {
        p != Place::Rate(s) && !matches!(p, Place::Output(_)) && !own.iter().any(|n| p == Place::Rate(n))
    });
    d.term(&format!("{s} through a resonance at {w}"));
    for w in scene.frequencies() {
        d.start(&[w, 0.5]);
    }
    d.done(&format!("{} acts on the rest through a resonance at {{0}}", scene.words(s)))
}
