//! What is left: a flexible law of one signal or of two, at each site.
//!
//! # Purpose
//! Say whether a model leaves anything that goes with its signals, whatever its form, and show that
//! form. It tells a complete model from one that is incomplete in a way that no name fits.
//!
//! # Method
//! At each site a sum of hat functions of a signal, or of products of powers of two signals, is scored
//! like a mechanism of many amplitudes. The chance of the largest score counts for all of them.
//!
//! # References
//! S. F. Masri, T. K. Caughey, J. Appl. Mech. 46 (1979) 433 (the restoring-force surface).

use super::bench::Bench;
use super::catalogue::{Draft, Proposal, Scene, Signal, SignalKind, SiteKind};
use super::propose::View;
use super::screen::{Score, Screen};
use crate::units::Unit;
use rayon::prelude::*;

/// Hats along a signal.
const HATS: usize = 7;

/// Harmonics of a heading in a table of trials.
const HARMONICS: usize = 4;

/// Signals that are taken in pairs, at most.
const PAIRED: usize = 4;

/// A flexible law at a site, scored.
pub struct Law {
    /// The state or output that it acts on.
    pub site: super::catalogue::Site,
    /// The signals that it depends on.
    pub signals: Vec<String>,
    /// Its score.
    pub score: Score,
    /// Places of the hats along the first signal, SI; empty for products.
    pub places: Vec<f64>,
    /// The weights there, SI.
    pub weights: Vec<f64>,
    /// Standard deviations of the weights.
    pub deviations: Vec<f64>,
    /// Share of the raw residual's square that it explains.
    pub explained: f64,
}

/// All flexible laws, best first, with the chance of the best.
pub struct Rest {
    /// The laws.
    pub laws: Vec<Law>,
    /// Chance that the best is noise.
    pub p_value: f64,
}

impl Rest {
    /// Tells the developer, where GYROSPEC_TRACE is set.
    pub fn trace(&self, when: &str) {
        if std::env::var_os("GYROSPEC_TRACE").is_some() {
            #[allow(clippy::print_stderr)]
            for l in self.laws.iter().take(5) {
                eprintln!(
                    "rest {when}: p {:.3} s {:.2} chi2 {:.1}/{} explained {:.4} {} {:?}",
                    self.p_value,
                    l.score.statistic,
                    l.score.chi2,
                    l.score.degrees,
                    l.explained,
                    l.site.name,
                    l.signals
                );
            }
        }
    }
}

/// Looks for any law in what a model leaves.
pub fn look(bench: &Bench, scene: &Scene, view: &View) -> Rest {
    let drafts = drafts(scene);
    let mut laws: Vec<Law> = drafts
        .into_par_iter()
        .with_max_len(1)
        .filter_map(|(p, places)| law(bench, view, &p, places))
        .collect();
    let scores: Vec<&Score> = laws.iter().map(|l| &l.score).collect();
    let p_value = Screen::p_value(&scores);
    laws.sort_by(|a, b| b.score.statistic.total_cmp(&a.score.statistic));
    Rest { laws, p_value }
}

fn drafts(scene: &Scene) -> Vec<(Proposal, Vec<f64>)> {
    let signals: Vec<&Signal> = scene
        .moving(&[SignalKind::State, SignalKind::Input, SignalKind::Channel])
        .filter(|s| s.levels > 4)
        .collect();
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
    let sites = motions.iter().map(|m| (m.state.as_str(), &m.force, m.size));
    let paired = &signals[..signals.len().min(PAIRED)];
    for (state, unit, size) in sites {
        for (i, a) in paired.iter().enumerate() {
            for b in &paired[i + 1..] {
                all.extend(products(scene, state, unit, size, (a, b)));
            }
        }
    }
    all
}

fn hat(signal: &str, place: &str, width: &str) -> String {
    format!("max(0, 1 - abs({signal} - {place})/{width})")
}

fn places(s: &Signal) -> (Vec<f64>, f64) {
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
        let a = d.amplitude("a", unit, super::catalogue::ANY, "");
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
        let a = d.amplitude("a", &scene.unit(output), super::catalogue::ANY, "");
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
                let a = d.amplitude("a", &scene.unit(output), super::catalogue::ANY, "");
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
        let c = d.amplitude("a", unit, super::catalogue::ANY, "");
        d.force(state, &format!("{c}*{form}"));
    }
    d.start(&vec![size; forms.len()]);
    d.done("").map(|p| (p, Vec::new()))
}

fn law(bench: &Bench, view: &View, p: &Proposal, places: Vec<f64>) -> Option<Law> {
    let tracks = view.at_rest(bench, p, &p.starts[0])?;
    let directions: Vec<Vec<f64>> =
        (0..p.amplitudes.len()).map(|j| view.screen.whitened(&tracks, |t| &t.sensitivities[j])).collect();
    let solved = view.screen.solve(&directions)?;
    Some(Law {
        site: p.site.clone(),
        signals: p.depends.clone(),
        places,
        weights: solved.weights,
        deviations: solved.deviations,
        explained: solved.score.chi2 / view.screen.residual.len().max(1) as f64,
        score: solved.score,
    })
}
