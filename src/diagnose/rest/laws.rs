//! The flexible laws that are looked for in what a model leaves.

use crate::diagnose::catalogue::{ANY, Draft, Proposal, Scene, Signal, SignalKind, SiteKind};
use crate::units::Unit;

/// Hats along a signal.
const HATS: usize = 7;

/// Harmonics of a heading in a table of trials.
const HARMONICS: usize = 4;

/// Signals that are taken in pairs, at most.
const PAIRED: usize = 4;

/// Kinds of signals that a flexible law may depend on.
const KINDS: [SignalKind; 3] = [SignalKind::State, SignalKind::Input, SignalKind::Channel];

/// Signals that a flexible law may depend on: they move, over more than a few levels.
pub(super) fn motion_signals<'a>(scene: &'a Scene<'_>) -> Vec<&'a Signal> {
    scene.moving(&KINDS).filter(|s| s.levels > 4).collect()
}

/// All flexible laws of a scene but surfaces, each with the places of its hats along a single signal.
pub(super) fn all(scene: &Scene) -> Vec<(Proposal, Vec<f64>)> {
    let signals = motion_signals(scene);
    let motions = scene.motions();
    let mut all = Vec::new();
    for s in &signals {
        for m in &motions {
            all.extend(hats(scene, Some(&m.state), &m.force, m.size, s));
        }
        for o in &scene.model.outputs {
            all.extend(at_output(scene, &o.name, s));
        }
    }
    if scene.trials {
        all.extend(waves(scene, &signals));
    }
    for m in &motions {
        let pairs = pairs(&signals).into_iter();
        all.extend(pairs.filter_map(|pair| products(scene, &m.state, &m.force, m.size, pair)));
    }
    all
}

/// Pairs of the first few signals.
pub(super) fn pairs<'a>(signals: &[&'a Signal]) -> Vec<(&'a Signal, &'a Signal)> {
    let paired = &signals[..signals.len().min(PAIRED)];
    let with_later = |(i, a): (usize, &&'a Signal)| paired[i + 1..].iter().map(|b| (*a, *b)).collect();
    paired.iter().enumerate().map(with_later).collect::<Vec<Vec<_>>>().concat()
}

fn hat(signal: &str, place: &str, width: &str) -> String {
    format!("max(0, 1 - abs({signal} - {place})/{width})")
}

/// Places of hats along a signal, and their width.
pub(super) fn places(s: &Signal) -> (Vec<f64>, f64) {
    let (low, high) = ((s.mean - 2.2 * s.spread).max(s.min), (s.mean + 2.2 * s.spread).min(s.max));
    let width = (high - low) / (HATS - 1) as f64;
    ((0..HATS).map(|i| low + i as f64 * width).collect(), width)
}

fn hats(
    scene: &Scene,
    state: Option<&str>,
    unit: &Unit,
    size: f64,
    s: &Signal,
) -> Option<(Proposal, Vec<f64>)> {
    let state = state?;
    let mut d = Draft::new(scene, "flexible", SiteKind::State, state);
    d.uses(&s.name);
    let (at, width) = places(s);
    let w = d.constant("width", &s.unit, width, "");
    for place in &at {
        let a = d.amplitude("a", unit, ANY, "");
        let c = d.constant("place", &s.unit, *place, "");
        d.force(state, &format!("{a}*{}", hat(&s.name, &c, &w)));
    }
    d.start(&[size; HATS]);
    d.done("").map(|p| (p, at))
}

fn at_output(scene: &Scene, output: &str, s: &Signal) -> Option<(Proposal, Vec<f64>)> {
    let mut d = Draft::new(scene, "flexible", SiteKind::Output, output);
    d.uses(&s.name);
    let (at, width) = places(s);
    let w = d.constant("width", &s.unit, width, "");
    for place in &at {
        let a = d.amplitude("a", &scene.unit(output), ANY, "");
        let c = d.constant("place", &s.unit, *place, "");
        d.output(output, &format!("{{}} + {a}*{}", hat(&s.name, &c, &w)));
    }
    d.start(&[1.0; HATS]);
    d.done("").map(|p| (p, at))
}

/// In a table of trials: harmonics of each heading, alone and over hats of each other signal.
fn waves(scene: &Scene, signals: &[&Signal]) -> Vec<(Proposal, Vec<f64>)> {
    let mut all = Vec::new();
    for o in &scene.model.outputs {
        for h in signals.iter().filter(|s| s.is_heading()) {
            all.extend(wave(scene, &o.name, h, None));
            let others = scene.moving(&[SignalKind::Input, SignalKind::Channel]).filter(|s| s.name != h.name);
            all.extend(others.filter_map(|s| wave(scene, &o.name, h, Some(s))));
        }
    }
    all
}

fn wave(
    scene: &Scene,
    output: &str,
    heading: &Signal,
    over: Option<&Signal>,
) -> Option<(Proposal, Vec<f64>)> {
    let mut d = Draft::new(scene, "flexible", SiteKind::Output, output);
    d.uses(&heading.name);
    let mut hats = vec![String::new()];
    if let Some(s) = over {
        d.uses(&s.name);
        let width = d.constant("width", &s.unit, (s.max - s.min) / 2.0, "");
        let place = |d: &mut Draft, x: f64| d.constant("place", &s.unit, x, "");
        let at = [s.min, 0.5 * (s.min + s.max), s.max];
        hats = at.map(|x| format!("*{}", hat(&s.name, &place(&mut d, x), &width))).to_vec();
    }
    let mut count = 0;
    for hat in &hats {
        for k in 1..=HARMONICS {
            for wave in ["sin", "cos"] {
                let a = d.amplitude("a", &scene.unit(output), ANY, "");
                d.output(output, &format!("{{}} + {a}*{wave}({k}*{}){hat}", heading.name));
                count += 1;
            }
        }
    }
    d.start(&vec![1.0; count]);
    d.done("").map(|p| (p, Vec::new()))
}

fn products(
    scene: &Scene,
    state: &str,
    unit: &Unit,
    size: f64,
    pair: (&Signal, &Signal),
) -> Option<(Proposal, Vec<f64>)> {
    let (a, b) = pair;
    let mut d = Draft::new(scene, "flexible", SiteKind::State, state);
    let scaled = |d: &mut Draft, s: &Signal| {
        d.uses(&s.name);
        let size = d.constant("size", &s.unit, s.size().max(f64::MIN_POSITIVE), "");
        format!("({}/{size})", s.name)
    };
    let (x, y) = (scaled(&mut d, a), scaled(&mut d, b));
    let forms = [
        format!("{x}*{y}"),
        format!("{x}^2*{y}"),
        format!("{x}*{y}^2"),
        format!("abs({x})*{y}"),
        format!("{x}*abs({y})"),
        format!("{x}^3*{y}"),
        format!("{x}*{y}^3"),
        format!("{x}^2*{y}^2"),
    ];
    for form in &forms {
        let c = d.amplitude("a", unit, ANY, "");
        d.force(state, &format!("{c}*{form}"));
    }
    d.start(&vec![size; forms.len()]);
    d.done("").map(|p| (p, Vec::new()))
}
