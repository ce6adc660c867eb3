//! # What it is
//! A sensor shows a part of another motion: a tilted accelerometer, a crosstalk, a lever arm.
//!
//! # Signature in a recording
//! The residual is proportional to the other signal at once, without the system's own dynamics.
//!
//! # Equation
//! ```text
//!     y -> y + c u
//! ```
//!
//! # What else looks like this
//! cross-coupling (through the dynamics), misalignment.
//!
//! # Reference
//! IEEE Std 1293-2018, on cross-axis sensitivity of accelerometers.
//!
//! # Example
//! A roll sensor mounted with two degrees of yaw shows some pitch.

use super::{Draft, Group, Mechanism, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, edit};
use crate::expression::Expr;
use crate::model::Output;
use crate::units::Dimension;

/// A sensor that feels another motion.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "output-cross-axis",
    "a sensor that feels another motion",
    Group::Output,
    include_str!("output_cross_axis.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    if scene.trials {
        return Vec::new();
    }
    let signals: Vec<&Signal> =
        scene.moving(&[SignalKind::Channel, SignalKind::Input, SignalKind::State]).collect();
    let mut all = Vec::new();
    for o in &scene.model.outputs {
        for s in &signals {
            for factor in scene.factors(s) {
                all.extend(at(scene, &o.name, s, &factor, false));
            }
            all.extend(at(scene, &o.name, s, "", true).filter(|_| is_component(o, s)));
        }
        all.extend(scene.model.outputs.iter().filter_map(|other| beside(scene, o, other)));
    }
    all
}

/// What another sensor feels, where that is no signal by itself.
fn beside(scene: &Scene, o: &Output, other: &Output) -> Option<Proposal> {
    let felt = scene.signal(&other.name).filter(|s| s.varies() && !s.is_heading())?;
    let is_plain = |e: &Expr| e.names().len() < 2;
    if o.name == other.name || is_plain(&other.equals) || o.equals == other.equals {
        return None;
    }
    let mut d = Draft::new(scene, "output-cross-axis", SiteKind::Output, &o.name);
    let c = d.amplitude(
        "c",
        &scene.unit(&o.name).over(&scene.unit(&other.name)),
        ANY,
        "part of the other motion",
    );
    scene.model.states.iter().filter(|s| other.equals.mentions(&s.name)).for_each(|s| d.uses(&s.name));
    d.output(&o.name, &format!("{{}} + {c}*({})", other.equals));
    d.start(&[scene.signal(&o.name)?.spread / felt.spread]);
    let [own, felt] = [o, other].map(|o| scene.words(&o.name));
    d.done(&format!("the sensor of {own} also feels what that of {felt} feels, {{0}}"))
}

/// Whether a signal is another component of what a twisted instrument shows, which it feels from its zero, and far from that.
fn is_component(o: &Output, s: &Signal) -> bool {
    let dimension = o.unit.of_differences().dimension();
    let is_alike = s.unit.of_differences().dimension() == dimension && dimension != Dimension::TEMPERATURE;
    is_alike && s.kind == SignalKind::State && s.is_off_zero() && !s.is_heading()
}

/// What the sensor feels of a signal, as couplings feel it or as it is.
fn at(scene: &Scene, output: &str, s: &Signal, factor: &str, is_whole: bool) -> Option<Proposal> {
    let own = scene.model.outputs.iter().find(|o| o.name == output)?;
    let is_own = || factor.is_empty() && edit::has_multiple_of(scene.model, &own.equals, &s.name);
    if is_own() || s.is_heading() && s.spread > 0.3 {
        return None;
    }
    let mut d = Draft::new(scene, "output-cross-axis", SiteKind::Output, output);
    let c = d.amplitude("c", &scene.unit(output).over(&s.unit), ANY, "part of the other motion");
    d.uses(&s.name);
    let part = if is_whole { s.name.clone() } else { d.turned(s, factor) };
    d.output(output, &format!("{{}} + {c}*{part}{factor}"));
    d.start(&[scene.signal(output)?.spread / s.spread]);
    d.done(&format!(
        "the sensor of {} also feels {}{factor}, {{0}}",
        scene.words(output),
        scene.words(&s.name)
    ))
}
