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
//!     s' = … + c u |u|, c u^2      as wind acts, where u turns about or changes much
//!     d v |v| -> d (v + c u) |v + c u|      where u is a speed as v is
//!     a cos(heading) -> a cos(heading) - c u sin(heading)   and at the same time
//!     a sin(heading) -> a sin(heading) + c u cos(heading)   where u is the second component of the vector (a, u)
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
//! A gyrocompass model that knows roll alone while the ship pitches; the drag of a car in a headwind.

use crate::expression::{BinaryOp, Expr, Function};
use crate::units::Unit;

use super::terms::{factors, rewritten, with_factor};
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

/// Mean of a signal in units of its spread from which on a coupling feels it about its mean, from which on it acts as a constant
/// does, and up to which its square is not as good as straight.
const CENTRED: f64 = 2.0;
const CONSTANT: f64 = 8.0;
const BENT: f64 = 4.0;

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
            if factor.is_empty() {
                all.extend(motions.iter().flat_map(|m| unaltered(scene, m, signal)));
                all.extend(motions.iter().filter_map(|m| relative(scene, m, signal)));
            }
            let definitions = scene.moving(&[SignalKind::Definition]);
            all.extend(definitions.filter_map(|d| in_definition(scene, d, signal, &factor)));
        }
    }
    all.extend(components(scene));
    all
}

/// Channels as the second component of the vector whose first one is an input that the model turns by a heading.
fn components(scene: &Scene) -> Vec<Proposal> {
    let mut all = Vec::new();
    for i in scene.moving(&[SignalKind::Input]).filter(|s| !s.is_heading()) {
        for h in scene.headings() {
            let channels = scene.moving(&[SignalKind::Channel]);
            let alike = channels.filter(|c| c.unit.dimension() == i.unit.dimension());
            all.extend(alike.filter_map(|c| component(scene, [i, c], &h.name)));
        }
    }
    all
}

/// The second component of a vector at every place of the first: sine and cosine exchanged, one coefficient for all.
fn component(scene: &Scene, [first, second]: [&Signal; 2], heading: &str) -> Option<Proposal> {
    let site = |m: &Motion| (SiteKind::State, m.state.clone());
    let places = turned_places(scene, &first.name, heading);
    // at one place alone it is a signal that acts there, as above
    if places.len() < 2 {
        return None;
    }
    let felt = |n: &str| {
        let states = &scene.model.states;
        states.iter().any(|s| s.name == n || edit::reaches(scene.model, &s.rate, n))
    };
    let (kind, name) = match places.iter().find(|p| felt(p.1)) {
        Some((kind, name)) => (*kind, (*name).to_owned()),
        None => scene.motions().first().map(site)?,
    };
    let mut d = Draft::new(scene, "cross-coupling", kind, &name);
    let c = d.amplitude("c", &scene.unit(&first.name).over(&scene.unit(&second.name)), ANY, "coupling");
    d.uses(&second.name);
    let own = Expr::parse(&format!("{c}*{}", second.name)).ok()?;
    d.each_rate(&|e| rewritten(e, &|t| with_component(t, [&first.name, heading], &own)));
    d.first_change();
    d.start(&[first.spread / second.spread]);
    let (first, second) = (scene.words(&first.name), scene.words(&second.name));
    d.done(&format!("{second} acts beside {first} as the other component of the same vector, {{0}}"))
}

/// Definitions and states in which a term has an input and the sine or cosine of a heading as factors.
fn turned_places<'s>(scene: &'s Scene, input: &str, heading: &str) -> Vec<(SiteKind, &'s str)> {
    let own = Expr::Number(0.0);
    let stands = |e: &Expr| rewritten(e, &|t| with_component(t, [input, heading], &own)) != *e;
    let model = scene.model;
    let defined = model.definitions.iter().filter(|d| stands(&d.equals));
    let moved = model.states.iter().filter(|s| stands(&s.rate));
    let defined = defined.map(|d| (SiteKind::Definition, d.name.as_str()));
    defined.chain(moved.map(|s| (SiteKind::State, s.name.as_str()))).collect()
}

/// A term with an input and the cosine of a heading as factors, less the same with another signal in the input's place
/// and the sine; one with the sine, and the same with the cosine.
fn with_component(term: &Expr, [input, heading]: [&str; 2], other: &Expr) -> Option<Expr> {
    let all = factors(term);
    if !all.iter().any(|f| f.mentions(input)) {
        return None;
    }
    let is_turn = |f: &&&Expr| match f {
        Expr::Call(Function::Sin | Function::Cos, a) => a[0] == Expr::name(heading),
        _ => false,
    };
    let turn = *all.iter().find(is_turn)?;
    let Expr::Call(f, angle) = turn else { return None };
    let exchanged = if *f == Function::Sin { Function::Cos } else { Function::Sin };
    let new = with_factor(term, turn, &Expr::Call(exchanged, angle.clone())).substitute(input, other);
    Some(if *f == Function::Sin { edit::plus(term, &new) } else { edit::minus(term, &new) })
}

fn at(scene: &Scene, m: &Motion, signal: &Signal, factor: &str) -> Option<Proposal> {
    let state = scene.model.states.iter().find(|s| s.name == m.state)?;
    let kinematic = m.position.as_ref() == Some(&signal.name) || m.speed.as_ref() == Some(&signal.name);
    let there = match signal.kind {
        SignalKind::Input => edit::has_free_term_in(scene.model, &state.rate, &signal.name),
        _ => edit::reaches(scene.model, &state.rate, &signal.name),
    };
    if factor.is_empty() && (kinematic || there) {
        return None;
    }
    let mut d = Draft::at(scene, "cross-coupling", m);
    let c = d.amplitude("c", &m.force.over(&signal.unit), ANY, "coupling");
    d.uses(&signal.name);
    let part = d.turned(signal, factor);
    d.force(&m.state, &format!("{c}*{part}{factor}"));
    d.start(&[m.size / signal.spread]);
    d.done(&format!("{}{factor} acts on {}, {{0}}", scene.words(&signal.name), scene.words(&m.state)))
}

/// A channel that acts as it is recorded: in proportion though its mean outweighs its motion, by its square, and by that
/// against the side from which it comes. An input that acts times something may do so by its square beside, as a current heats.
fn unaltered(scene: &Scene, m: &Motion, signal: &Signal) -> Vec<Proposal> {
    let (u, mean) = (&signal.name, signal.mean.abs() / signal.spread);
    let state = scene.model.states.iter().find(|s| s.name == m.state);
    let is_there = state.is_none_or(|s| edit::reaches(scene.model, &s.rate, u));
    let is_other = signal.kind == SignalKind::Channel && !is_there;
    // where it stands alone, and nowhere else, its own square is `input-square`
    let model = scene.model;
    let rates = model.states.iter().map(|s| &s.rate).chain(model.outputs.iter().map(|o| &o.equals));
    let is_once = rates.filter(|e| edit::reaches(model, e, u)).count() < 2;
    let is_alone = is_once && state.is_some_and(|s| edit::has_free_term_in(model, &s.rate, u));
    if !is_other && (signal.kind != SignalKind::Input || is_alone) {
        return Vec::new();
    }
    let laws = [
        (is_other && (CENTRED..CONSTANT).contains(&mean), 1.0, u.clone(), ""),
        (is_other && mean < BENT, 2.0, format!("{u}*abs({u})"), " by its square"),
        (mean < 1.0, 2.0, format!("{u}^2"), " by its square, from either side alike"),
    ];
    let of = |power: f64, law: &str, how: &str| {
        let mut d = Draft::at(scene, "cross-coupling", m);
        let c = d.amplitude("c", &m.force.over(&signal.unit.of_differences().power(power)), ANY, "coupling");
        d.uses(u);
        d.force(&m.state, &format!("{c}*{law}"));
        d.start(&[m.size / signal.size().powf(power)]);
        d.done(&format!("{} acts on {}{how}, {{0}}", scene.words(u), scene.words(&m.state)))
    };
    laws.into_iter().filter(|l| l.0).filter_map(|(_, power, law, how)| of(power, &law, how)).collect()
}

/// A channel that is added to a state in the laws that bend: wind to a speed, a current to that of a ship.
fn relative(scene: &Scene, m: &Motion, signal: &Signal) -> Option<Proposal> {
    let own = scene.signal(&m.state)?;
    if signal.kind == SignalKind::State || signal.unit.dimension() != own.unit.dimension() {
        return None;
    }
    let x = Expr::name(&m.state);
    let is_power = |e: &Expr| matches!(e, Expr::Binary(BinaryOp::Pow, a, _) if a.mentions(&m.state));
    let bends = |t: &Expr| {
        let plain = factors(t).into_iter().filter(|f| **f == x).count();
        let others = factors(t).into_iter().any(|f| *f != x && f.mentions(&m.state));
        plain > 1 || plain == 1 && others || edit::find(t, &is_power).is_some()
    };
    let mut d = Draft::at(scene, "cross-coupling", m);
    let c = d.amplitude("c", &Unit::one(), ANY, "share of the channel that is felt");
    d.uses(&signal.name);
    let sum = Expr::parse(&format!("({} + {c}*{})", m.state, signal.name)).ok()?;
    d.each_rate(&|e| rewritten(e, &|t| bends(t).then(|| t.substitute(&m.state, &sum))));
    d.first_change();
    d.start(&[1.0]);
    let (signal, state) = (scene.words(&signal.name), scene.words(&m.state));
    d.done(&format!("{signal} adds to {state} where that acts by its square or the like, {{0}} of it"))
}

fn in_definition(scene: &Scene, definition: &Signal, signal: &Signal, factor: &str) -> Option<Proposal> {
    if signal.kind == SignalKind::State {
        return None;
    }
    let mut d = Draft::new(scene, "cross-coupling", SiteKind::Definition, &definition.name);
    let c = d.amplitude("c", &definition.unit.over(&signal.unit), ANY, "coupling");
    d.uses(&signal.name);
    let part = d.turned(signal, factor);
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_other_component_stands_a_quarter_turn_ahead() {
        let own = Expr::parse("c*pitch").unwrap();
        let of = |text: &str| {
            let with = |t: &Expr| with_component(t, ["roll", "K"], &own);
            rewritten(&Expr::parse(text).unwrap(), &with).to_string()
        };
        assert_eq!(of("-h*roll*cos(K)"), "-h*roll*cos(K) + h*(c*pitch)*sin(K)");
        assert_eq!(of("h*roll*sin(K) - b*x"), "h*roll*sin(K) + h*(c*pitch)*cos(K) - b*x");
        assert_eq!(of("h*roll + b*sin(K)"), "h*roll + b*sin(K)");
    }
}
