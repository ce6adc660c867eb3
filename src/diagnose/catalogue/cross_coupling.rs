//! # What it is
//! A signal that the model does not use, or not there, acts on an equation: pitch on a roll
//! equation, wind, a neighbouring axis.
//!
//! # Signature in a recording
//! The residual is coherent with that signal.
//!
//! # Equation
//! ```text
//!     s' = … + c u,  perhaps c u sin(heading) or c u cos(heading)
//! ```
//!
//! # What else looks like this
//! output-cross-axis (the sensor alone feels it), misalignment, parameter-dependence (a product,
//! not a sum).
//!
//! # Reference
//! J. S. Bendat, A. G. Piersol, Random Data, 4th ed. (2010), ch. 7 on coherence.
//!
//! # Example
//! A gyrocompass model that knows roll alone while the ship pitches.

use crate::expression::Expr;

use super::{
    Draft, Group, Mechanism, Motion, Proposal, Scene, Signal, SignalKind, SiteKind, draft::ANY, edit,
};

/// Another recorded motion acts.
pub(super) const MECHANISM: Mechanism = Mechanism::new(
    "cross-coupling",
    "another recorded motion acts",
    Group::Ignored,
    include_str!("cross_coupling.rs"),
    propose,
);

fn propose(scene: &Scene) -> Vec<Proposal> {
    let mut all = Vec::new();
    let signals: Vec<&Signal> =
        scene.moving(&[SignalKind::Channel, SignalKind::Input, SignalKind::State]).collect();
    if scene.trials {
        return harmonics(scene);
    }
    let motions = scene.motions();
    for signal in signals {
        for factor in scene.factors(signal) {
            all.extend(motions.iter().filter_map(|m| at(scene, m, signal, &factor)));
            let definitions = scene.moving(&[SignalKind::Definition]);
            all.extend(definitions.filter_map(|d| in_definition(scene, d, signal, &factor)));
        }
    }
    all
}

fn at(scene: &Scene, m: &Motion, signal: &Signal, factor: &str) -> Option<Proposal> {
    let state = scene.model.states.iter().find(|s| s.name == m.state)?;
    let kinematic = m.position.as_ref() == Some(&signal.name) || m.speed.as_ref() == Some(&signal.name);
    let there = match signal.kind {
        SignalKind::Input => edit::has_term_in(scene.model, &state.rate, &signal.name),
        _ => edit::reaches(scene.model, &state.rate, &signal.name),
    };
    if factor.is_empty() && (kinematic || there) {
        return None;
    }
    let mut d = Draft::at(scene, "cross-coupling", m);
    let c = d.amplitude("c", &m.force.over(&signal.unit), ANY, "coupling");
    d.uses(&signal.name);
    let part = d.centred(signal);
    d.force(&m.state, &format!("{c}*{part}{factor}"));
    d.start(&[m.size / signal.spread]);
    d.done(&format!("{}{factor} acts on {}, {{0}}", scene.words(&signal.name), scene.words(&m.state)))
}

fn in_definition(scene: &Scene, definition: &Signal, signal: &Signal, factor: &str) -> Option<Proposal> {
    if signal.kind == SignalKind::State {
        return None;
    }
    let mut d = Draft::new(scene, "cross-coupling", SiteKind::Definition, &definition.name);
    let c = d.amplitude("c", &definition.unit.over(&signal.unit), ANY, "coupling");
    d.uses(&signal.name);
    let part = d.centred(signal);
    d.define(&definition.name, &format!("{c}*{part}{factor}"));
    d.start(&[definition.spread / signal.spread]);
    d.done(&format!("{}{factor} enters {}, {{0}}", scene.words(&signal.name), scene.words(&definition.name)))
}

/// In a table of trials: harmonics of the heading, alone and times another recorded quantity.
fn harmonics(scene: &Scene) -> Vec<Proposal> {
    let mut all = Vec::new();
    for o in &scene.model.outputs {
        for h in scene.headings() {
            // The model may have one of the two parts already; where the heading stands but once in it, the
            // other part is a misalignment.
            let often = times(scene, &h.name) > 1;
            let parts: &[&[&str]] =
                if often { &[&["sin", "cos"], &["sin"], &["cos"]] } else { &[&["sin", "cos"]] };
            for order in [1, 2, 4] {
                all.extend(parts.iter().filter_map(|p| harmonic(scene, (&o.name, &h.name), order, p)));
            }
        }
        for s in scene.moving(&[SignalKind::Channel, SignalKind::Input]).filter(|s| !s.is_heading()) {
            for factor in std::iter::once(String::new()).chain(scene.factors(s)) {
                all.extend(
                    [true, false].iter().filter_map(|about| beside(scene, &o.name, s, (&factor, *about))),
                );
            }
        }
    }
    all.dedup_by(|a, b| a.term == b.term);
    all
}

/// How often a name stands in the outputs and definitions.
fn times(scene: &Scene, name: &str) -> usize {
    let mut count = 0;
    let texts = scene.model.outputs.iter().map(|o| &o.equals);
    for e in texts.chain(scene.model.definitions.iter().map(|d| &d.equals)) {
        e.visit(&mut |part| count += usize::from(*part == Expr::name(name)));
    }
    count
}

fn harmonic(scene: &Scene, (output, heading): (&str, &str), order: u32, parts: &[&str]) -> Option<Proposal> {
    let mut d = Draft::new(scene, "cross-coupling", SiteKind::Output, output);
    let size = scene.signal(output)?.spread;
    let unit = scene.unit(output);
    let angle = if order == 1 { heading.to_string() } else { format!("{order}*{heading}") };
    let mut text = "{}".to_string();
    let mut says = Vec::new();
    for (i, part) in parts.iter().enumerate() {
        let h = d.amplitude(&format!("h_{part}"), &unit, ANY, &format!("part with the {part} of {angle}"));
        text += &format!(" + {h}*{part}({angle})");
        says.push(format!("{{{i}}} {part}({angle})"));
    }
    d.output(output, &text);
    d.uses(heading);
    d.start(&vec![size; parts.len()]);
    d.done(&format!("{} has a part that turns with {heading}: {}", scene.words(output), says.join(" + ")))
}

/// A signal beside an output, about its mean or as it stands.
fn beside(
    scene: &Scene,
    output: &str,
    signal: &Signal,
    (factor, about_mean): (&str, bool),
) -> Option<Proposal> {
    let mut d = Draft::new(scene, "cross-coupling", SiteKind::Output, output);
    let c = d.amplitude("c", &scene.unit(output).over(&signal.unit), ANY, "coupling");
    d.uses(&signal.name);
    let part = if about_mean { d.centred(signal) } else { signal.name.clone() };
    d.output(output, &format!("{{}} + {c}*{part}{factor}"));
    d.start(&[scene.signal(output)?.spread / signal.spread]);
    d.done(&format!("{}{factor} acts on {}, {{0}}", scene.words(&signal.name), scene.words(output)))
}
