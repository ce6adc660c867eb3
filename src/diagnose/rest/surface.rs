//! Surfaces over two signals: the law of two variables that no sum of laws of one can be.
//!
//! # Purpose
//! See a force that goes with two signals together in any smooth way, f(a, b) = Σ w_ij h_i(a) h_j(b).
//!
//! # Method
//! Each product of hats is a force along the fitted run; the model's response to it is one direction.
//!
//! # References
//! S. F. Masri, T. K. Caughey, J. Appl. Mech. 46 (1979) 433 (the restoring-force surface).
//!
//! # Numerical aspects
//! At any point four products at most are not zero.

use super::laws::{motion_signals, pairs, places};
use crate::diagnose::bench::{Bench, Track};
use crate::diagnose::catalogue::{ANY, Draft, Motion, Proposal, Scene, Signal, SiteKind};
use crate::diagnose::view::View;

/// Hats along a signal.
struct Hats {
    signal: String,
    places: Vec<f64>,
    width: f64,
}

impl Hats {
    fn of(s: &Signal) -> Self {
        let (places, width) = places(s);
        Self { signal: s.name.clone(), places, width }
    }

    /// h_i(x) = max(0, 1 − |x − x_i|/d)
    fn at(&self, x: f64) -> impl Iterator<Item = f64> {
        self.places.iter().map(move |p| (1.0 - (x - p).abs() / self.width).max(0.0))
    }
}

/// A surface at a site.
pub(super) struct Surface {
    /// A force of no shape at the site.
    pub push: Proposal,
    over: [Hats; 2],
}

impl Surface {
    /// The signals that it depends on.
    pub fn signals(&self) -> Vec<String> {
        self.over.iter().map(|h| h.signal.clone()).collect()
    }

    /// Tracks with sensitivities to its weights, where the model's response is known.
    pub fn tracks(&self, bench: &Bench, view: &View) -> Option<Vec<Track>> {
        let [a, b] = &self.over;
        let products = |x: &[f64]| a.at(x[0]).flat_map(|p| b.at(x[1]).map(move |q| p * q)).collect();
        view.response.as_ref()?.shaped(bench, &self.push, &[&a.signal, &b.signal], &products)
    }
}

/// All surfaces of a scene.
pub(super) fn all(scene: &Scene) -> Vec<Surface> {
    let pairs = pairs(&motion_signals(scene));
    let at = |m: &Motion| {
        let push = push(scene, m);
        let surface = |(a, b): &(&Signal, &Signal)| {
            push.clone().map(|push| Surface { push, over: [Hats::of(a), Hats::of(b)] })
        };
        pairs.iter().filter_map(surface).collect::<Vec<_>>()
    };
    scene.motions().iter().flat_map(at).collect()
}

fn push(scene: &Scene, m: &Motion) -> Option<Proposal> {
    let mut d = Draft::new(scene, "flexible", SiteKind::State, &m.state);
    let a = d.amplitude("a", &m.force, ANY, "");
    d.force(&m.state, &a);
    d.start(&[m.size]);
    d.done("")
}
