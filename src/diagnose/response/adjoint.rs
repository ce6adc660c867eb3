//! The response read backwards: what a force at each moment would have done to a weighted sum of the samples.
//!
//! # Method
//! Of L = Σ w·δy with δx₊ = F δx + G (g + g₊), δy = C δx:  λ = Fᵀ λ₊ + Cᵀ w,  ∂L/∂g += Gᵀ λ₊ at both ends of a step.
//!
//! # References
//! A. E. Bryson, Y.-C. Ho, Applied Optimal Control (1975), 2.3 (the adjoint of a linear system).

use super::along::{Along, Site, places};
use super::{Changes, Response};
use crate::diagnose::bench::Track;
use crate::model::Model;

impl Response {
    /// The values of a state or a signal at all times, run by run; `None` where one has gaps.
    pub fn course(&self, name: &str) -> Option<Vec<Vec<f64>>> {
        let of = |along: &Along| Some(along.values(&[name])?.into_iter().flatten().collect());
        self.runs.iter().map(of).collect()
    }

    /// What forces on a state, at all times of each run, do to a weighted sum of the samples of tracks.
    ///
    /// Of L = Σ w·δy it is ∂L/∂g.
    pub fn pulls(&self, state: &str, weights: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
        let state = self.model.states.iter().position(|s| s.name == state)?;
        let mut rest = weights;
        let of = |along: &Along| {
            let (own, others) = rest.split_at_checked(along.tracks.len())?;
            rest = others;
            Some(along.pull(&self.model, state, own))
        };
        self.runs.iter().map(of).collect()
    }

    /// The tracks that forces on a state move, given at all times of each run; a sensitivity each.
    pub fn pushed(&self, state: &str, forces: Vec<Vec<Vec<f64>>>) -> Option<Vec<Track>> {
        let state = self.model.states.iter().position(|s| s.name == state)?;
        let changes: Vec<Changes> = forces.into_iter().map(|run| vec![run]).collect();
        Some(self.moved(&changes, &[Site::Rate(state)]))
    }
}

impl Along {
    /// ∂L/∂g of one state at every time.
    fn pull(&self, model: &Model, state: usize, weights: &[Vec<f64>]) -> Vec<f64> {
        let (n, outputs, count) = (model.states.len(), model.outputs.len(), self.time.len());
        let mut on_mesh = vec![0.0; outputs * count];
        for ((output, _, time), weights) in self.tracks.iter().zip(weights) {
            spread(&self.time, time, weights, &mut on_mesh[output * count..][..count]);
        }
        let mut pull = vec![0.0; count];
        let mut later = vec![0.0; n];
        for i in (0..count).rev() {
            let mut here = vec![0.0; n];
            if i + 1 < count {
                let (f, g) = self.step(i, n);
                let own: f64 = later.iter().enumerate().map(|(row, l)| g[row * n + state] * l).sum();
                pull[i] += own;
                pull[i + 1] += own;
                for (row, l) in later.iter().enumerate() {
                    here.iter_mut().zip(&f[row * n..][..n]).for_each(|(h, f)| *h += f * l);
                }
            }
            for o in 0..outputs {
                let w = on_mesh[o * count + i];
                let shown = &self.shown[(i * outputs + o) * n..][..n];
                here.iter_mut().zip(shown).for_each(|(h, c)| *h += c * w);
            }
            later = here;
        }
        pull
    }
}

/// The adjoint of reading a mesh at rising times, straight between its points.
fn spread(mesh: &[f64], time: &[f64], weights: &[f64], out: &mut [f64]) {
    for ((i, share), w) in places(mesh, time).zip(weights) {
        out[i] += (1.0 - share) * w;
        out[i + 1] += share * w;
    }
}
