//! What is left: a flexible law of one signal or of two, at each site.
//!
//! # Purpose
//! Say whether a model leaves anything that goes with its signals, whatever its form, and show that
//! form. It tells a complete model from one that is incomplete in a way that no name fits.
//!
//! # Method
//! At each site a sum of hat functions of a signal, of products of powers of two signals, or a surface
//! of hats over both, is scored like a mechanism of many amplitudes. The chance of the largest score
//! counts for all of them. Where none is left, what follows an input in time is looked for at each output.
//!
//! # References
//! S. F. Masri, T. K. Caughey, J. Appl. Mech. 46 (1979) 433 (the restoring-force surface).

mod echo;
mod elsewhere;
mod laws;
mod surface;

use super::answer::Unexplained;
use super::bench::{Bench, Track};
use super::catalogue::{Scene, Signal, SignalKind, Site, SiteKind};
use super::screen::{Score, Screen};
use super::view::View;
use crate::model::Output;
use rayon::prelude::*;

/// Difference in worth, and share of it, up to which laws at two sites fit as well: what acts at one site
/// reaches the next through the model, so that a law there follows it in part.
const ALIKE: (f64, f64) = (3.0, 0.1);

/// Chance below which what is left counts as a law.
const LEFT_CHANCE: f64 = 0.01;
/// Share of the residual's square, whitened or not, that it must explain.
const LEFT_SHARE: f64 = 0.03;

/// Share of its chi-squared that it must lower the square of parts by that it was not fitted to: about 1 − 2.25 d/χ² for a law,
/// below 0 for what a loop feigns.
const FORETOLD: f64 = 0.1;

/// A flexible law at a site, scored.
pub struct Law {
    /// The state or output that it acts on.
    pub site: Site,
    /// The signals that it depends on.
    pub signals: Vec<String>,
    /// Whether it is what these were before, not what they are.
    pub of_past: bool,
    /// Its score.
    pub score: Score,
    /// Places of the hats along the first signal, SI; empty for products.
    pub places: Vec<f64>,
    /// The weights there, SI.
    pub weights: Vec<f64>,
    /// Standard deviations of the weights.
    pub deviations: Vec<f64>,
    /// By how much it lowers the square of parts that it was not fitted to, where a loop makes that a question.
    pub elsewhere: f64,
    /// Share of the whitened residual's square that it explains.
    pub explained: f64,
    /// Share of the free-run residual's square that it takes away.
    pub lowers: f64,
}

impl Law {
    /// What is left of a share of squares that it takes away without what as many weights take away of noise, 1 − d/χ².
    pub fn beyond_luck(&self, share: f64) -> f64 {
        share * (1.0 - self.score.degrees as f64 / self.score.chi2).max(0.0)
    }

    /// Its gain in log-likelihood, −n/2 ln(1 − R²), less the price of its weights, d/2 ln n.
    fn worth(&self) -> f64 {
        let samples = (self.score.chi2 / self.explained.max(f64::MIN_POSITIVE)).max(2.0);
        let gain = -0.5 * samples * (1.0 - self.explained.min(1.0 - 1e-12)).ln();
        gain - 0.5 * self.score.degrees as f64 * samples.ln()
    }
}

/// All flexible laws, best first, with the chance of the best.
pub struct Rest {
    /// The laws.
    pub laws: Vec<Law>,
    /// Chance that the best is noise.
    pub p_value: f64,
}

impl Rest {
    /// Laws with the chance of the best.
    fn of(view: &View, mut laws: Vec<Law>) -> Self {
        // all were tried, but what foretells nothing elsewhere is no law
        let tried = laws.len().max(1) as f64;
        laws.retain(|l| l.elsewhere > FORETOLD * l.score.chi2);
        let scores: Vec<&Score> = laws.iter().map(|l| &l.score).collect();
        let p_value = (view.screen.p_value(&scores) * tried / laws.len().max(1) as f64).min(1.0);
        laws.sort_by(|a, b| b.score.statistic.total_cmp(&a.score.statistic));
        Self { laws, p_value }
    }

    /// Whether something is left that goes with a signal.
    pub fn is_left(&self) -> bool {
        let is_much = |l: &Law| l.beyond_luck(l.explained.max(l.lowers)) > LEFT_SHARE;
        self.p_value < LEFT_CHANCE && self.laws.first().is_some_and(is_much)
    }

    /// The best law in the answer, with the shape of the best along one signal.
    pub fn unexplained(&self) -> Option<Unexplained> {
        let best = self.laws.first()?;
        let shaped = self.laws.iter().find(|l| !l.places.is_empty());
        let shape = shaped.map(|l| {
            let rows = l.places.iter().zip(&l.weights).zip(&l.deviations).filter(|(_, s)| s.is_finite());
            rows.map(|((x, w), s)| [*x, *w, w - 1.96 * s, w + 1.96 * s]).collect()
        });
        Some(Unexplained {
            p_value: self.p_value,
            signal: best.signals.join(", "),
            shape: shape.unwrap_or_default(),
        })
    }

    /// The sites at which some law fits as well as the best law of all, the best first.
    pub fn sites(&self) -> Vec<&Site> {
        let mut best: Vec<(&Site, f64)> = Vec::new();
        for l in &self.laws {
            match best.iter_mut().find(|b| *b.0 == l.site) {
                Some(b) => b.1 = b.1.max(l.worth()),
                None => best.push((&l.site, l.worth())),
            }
        }
        best.sort_by(|a, b| b.1.total_cmp(&a.1));
        let top = best.first().map_or(0.0, |b| b.1);
        let alike = |worth: f64| worth >= top - ALIKE.0.max(ALIKE.1 * top);
        best.into_iter().filter(|b| alike(b.1)).map(|b| b.0).collect()
    }

    /// Tells the developer, where GYROSPEC_TRACE is set.
    pub fn trace(&self, when: &str) {
        if std::env::var_os("GYROSPEC_TRACE").is_some() {
            #[allow(clippy::print_stderr)]
            for l in self.laws.iter().take(5) {
                eprintln!(
                    "rest {when}: p {:.3} s {:.2} chi2 {:.1}/{} elsewhere {:.1} explained {:.4} lowers {:.4} {} {:?}",
                    self.p_value,
                    l.score.statistic,
                    l.score.chi2,
                    l.score.degrees,
                    l.elsewhere,
                    l.explained,
                    l.lowers,
                    l.site.name,
                    l.signals
                );
            }
        }
    }
}

/// Looks for any law in what a model leaves.
pub fn look(bench: &Bench, scene: &Scene, view: &View) -> Rest {
    let simple = laws::all(scene).into_par_iter().with_max_len(1).filter_map(|(p, places)| {
        let tracks = view.at_rest(bench, &p).tracks(&p.starts[0])?;
        law((bench, view), &tracks, (p.site, p.depends), places)
    });
    let surfaces = surface::all(scene).into_par_iter().with_max_len(1).filter_map(|s| {
        let tracks = s.tracks(bench, view)?;
        law((bench, view), &tracks, (s.push.site.clone(), s.signals()), Vec::new())
    });
    let rest = Rest::of(view, simple.chain(surfaces).collect());
    if rest.is_left() || scene.trials {
        return rest;
    }
    let mut echoes = Rest::of(view, echoes(bench, scene, view));
    // asked second
    echoes.p_value = (2.0 * echoes.p_value).min(1.0);
    if echoes.is_left() { echoes } else { rest }
}

/// What follows each input in time, at each output.
fn echoes(bench: &Bench, scene: &Scene, view: &View) -> Vec<Law> {
    let inputs: Vec<&Signal> = scene.moving(&[SignalKind::Input]).collect();
    let outputs = scene.model.outputs.iter().enumerate();
    let pairs: Vec<_> = outputs.flat_map(|(k, o)| inputs.iter().map(move |u| (k, o, *u))).collect();
    let one = |(k, output, input): (usize, &Output, &Signal)| {
        let tracks = echo::tracks(bench, view, k, &input.name)?;
        let site = Site { kind: SiteKind::Output, name: output.name.clone() };
        let law = law((bench, view), &tracks, (site, vec![input.name.clone()]), Vec::new())?;
        Some(Law { of_past: true, ..law })
    };
    pairs.into_par_iter().with_max_len(1).filter_map(one).collect()
}

fn law(
    (bench, view): (&Bench, &View),
    tracks: &[Track],
    at: (Site, Vec<String>),
    places: Vec<f64>,
) -> Option<Law> {
    let count = tracks.first()?.sensitivities.len();
    let directions = |space: &Screen| -> Vec<Vec<f64>> {
        (0..count).map(|j| space.whitened(tracks, |t| &t.sensitivities[j])).collect()
    };
    let whitened = directions(&view.screen);
    let solved = view.screen.solve(&whitened)?;
    let elsewhere = if bench.is_loop() { elsewhere::gain(&view.screen, &whitened) } else { f64::INFINITY };
    let left = view.free.left(&directions(&view.free), &solved.weights);
    Some(Law {
        site: at.0,
        signals: at.1,
        of_past: false,
        elsewhere,
        places,
        weights: solved.weights,
        deviations: solved.deviations,
        explained: solved.score.chi2 / view.screen.residual.len().max(1) as f64,
        lowers: (1.0 - left).max(0.0),
        score: solved.score,
    })
}
