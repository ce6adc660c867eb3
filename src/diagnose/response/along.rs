//! One recording of a response: the linearised model stepped along its run.

use super::probe::rows;
use crate::diagnose::bench::Track;
use crate::expression::Expr;
use crate::model::{Initial, Model};
use crate::record::Recording;
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::ops::Range;
use std::sync::Arc;

/// Sums over neighbours reach as far as a power of two below this one.
const WIDEST: usize = 8;

/// One recording.
pub(super) struct Along {
    /// Inputs, with the courses of the states beside them.
    pub recording: Recording,
    pub number: usize,
    pub time: Arc<[f64]>,
    /// Which F and which G each step has: those of steps as long between the same slopes are kept once.
    pub steps: Vec<u32>,
    /// F, n × n row by row: δx₊ = F δx + G (g + g₊).
    pub forward: Vec<f64>,
    /// G.
    pub force: Vec<f64>,
    /// C at every time, outputs × n.
    pub shown: Vec<f64>,
    /// A at the first time.
    pub first: Vec<f64>,
    pub tracks: Vec<(usize, Vec<Range<usize>>, Vec<f64>)>,
}

/// Where a term enters.
#[derive(Clone, Copy)]
pub(super) enum Site {
    Rate(usize),
    Output(usize),
}

impl Along {
    /// F = (1 − hA₊/2)⁻¹(1 + hA/2), G = (1 − hA₊/2)⁻¹ h/2
    pub fn fill(&mut self, a: &dyn Fn(usize) -> Mat<f64>) {
        let (mut before, mut here) = (None, a(0));
        let (mut step, mut made) = (0.0, 0);
        for i in 0..self.time.len().saturating_sub(1) {
            let next = a(i + 1);
            let h = self.time[i + 1] - self.time[i];
            let is_alike = (h - step).abs() <= 1e-9 * h && next == here && before.as_ref() == Some(&here);
            if !is_alike {
                let n = next.nrows();
                let unit = Mat::<f64>::identity(n, n);
                let lu = (&unit - &next * faer::Scale(0.5 * h)).partial_piv_lu();
                self.forward.extend(rows(&lu.solve(&unit + &here * faer::Scale(0.5 * h))));
                self.force.extend(rows(&lu.solve(unit * faer::Scale(0.5 * h))));
                made += 1;
            }
            self.steps.push(made - 1);
            before = Some(std::mem::replace(&mut here, next));
            step = h;
        }
    }

    /// F and G of a step.
    pub fn step(&self, i: usize, n: usize) -> (&[f64], &[f64]) {
        let first = self.steps[i] as usize * n * n;
        (&self.forward[first..][..n * n], &self.force[first..][..n * n])
    }

    /// δy of every output at every time, output by output.
    pub fn propagate(&self, model: &Model, terms: &[(Site, &[f64])]) -> Vec<f64> {
        let (n, outputs, count) = (model.states.len(), model.outputs.len(), self.time.len());
        let rates: Vec<(usize, &[f64])> = terms
            .iter()
            .filter_map(|(s, g)| if let Site::Rate(j) = s { Some((*j, *g)) } else { None })
            .collect();
        let mut x = self.at_rest(model, &rates);
        let mut next = vec![0.0; n];
        let mut y = vec![0.0; outputs * count];
        for i in 0..count {
            for o in 0..outputs {
                let c = &self.shown[(i * outputs + o) * n..][..n];
                y[o * count + i] = c.iter().zip(&x).map(|(c, x)| c * x).sum();
            }
            if i + 1 == count || rates.is_empty() {
                continue;
            }
            let (f, g) = self.step(i, n);
            for (row, out) in next.iter_mut().enumerate() {
                let carried: f64 = f[row * n..][..n].iter().zip(&x).map(|(f, x)| f * x).sum();
                *out = rates.iter().fold(carried, |sum, (j, r)| sum + g[row * n + j] * (r[i] + r[i + 1]));
            }
            std::mem::swap(&mut x, &mut next);
        }
        for (site, e) in terms {
            if let Site::Output(o) = site {
                y[o * count..][..count].iter_mut().zip(*e).for_each(|(y, e)| *y += e);
            }
        }
        y
    }

    /// δx at the start: A δx + g = 0 in the states that start steady, 0 in the others.
    fn at_rest(&self, model: &Model, rates: &[(usize, &[f64])]) -> Vec<f64> {
        let n = model.states.len();
        let mut x = vec![0.0; n];
        let steady: Vec<usize> = (0..n).filter(|j| model.states[*j].initial == Initial::Steady).collect();
        if !steady.is_empty() && !rates.is_empty() {
            let a = Mat::from_fn(steady.len(), steady.len(), |i, j| self.first[steady[i] * n + steady[j]]);
            let g = |i: usize| rates.iter().filter(|r| r.0 == steady[i]).map(|r| r.1[0]).sum::<f64>();
            let solved = a.partial_piv_lu().solve(Mat::from_fn(steady.len(), 1, |i, _| -g(i)));
            for (i, j) in steady.iter().enumerate() {
                x[*j] = if solved[(i, 0)].is_finite() { solved[(i, 0)] } else { 0.0 };
            }
        }
        x
    }

    /// Moves the courses of those states that are outputs themselves to where they were measured.
    pub fn take_places(&mut self, model: &Model, tracks: &[Track]) {
        for t in tracks.iter().filter(|t| t.time.len() > 1) {
            let equals = &model.outputs[t.output].equals;
            let Some(state) = model.states.iter().find(|s| *equals == Expr::name(&s.name)) else { continue };
            let off = read(&t.time, &smoothed(&t.residual), &self.time);
            let channel = self.recording.channels.iter_mut().find(|c| c.name == state.name);
            if let Some(channel) = channel.filter(|c| c.len() == off.len()) {
                channel.values = channel.values.iter().zip(off).map(|(x, off)| x + off).collect();
            }
        }
    }

    /// The values of signals at every time; `None` where one has gaps.
    pub fn values(&self, signals: &[&str]) -> Option<Vec<Vec<f64>>> {
        let channels: Option<Vec<_>> = signals.iter().map(|s| self.recording.channel(s).ok()).collect();
        let channels = channels?;
        self.time.iter().map(|t| channels.iter().map(|c| c.value_at(*t)).collect()).collect()
    }

    /// The moves, amplitude by amplitude, read at the tracks' own times.
    pub fn on_tracks(&self, moved: &[Vec<f64>]) -> Vec<Track> {
        let count = self.time.len();
        let one = |(output, stretches, time): &(usize, Vec<Range<usize>>, Vec<f64>)| Track {
            output: *output,
            stretches: stretches.clone(),
            time: Vec::new(),
            residual: Vec::new(),
            sensitivities: moved
                .iter()
                .map(|y| read(&self.time, &y[output * count..][..count], time))
                .collect(),
        };
        self.tracks.iter().map(one).collect()
    }
}

/// A series without its noise: means over as many neighbours as foretell a sample best.
fn smoothed(values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let mut sums = vec![0.0];
    sums.extend(values.iter().scan(0.0, |sum, v| {
        *sum += v;
        Some(*sum)
    }));
    let around = |i: usize, reach: usize| (i.saturating_sub(reach), (i + reach + 1).min(n));
    let without = |i: usize, reach: usize| {
        let (a, b) = around(i, reach);
        values[i] - (sums[b] - sums[a] - values[i]) / (b - a - 1) as f64
    };
    let missed = |reach: usize| (0..n).map(|i| without(i, reach).powi(2)).sum::<f64>();
    let reaches = (0..WIDEST).map(|k| 1 << k).filter(|reach| 4 * reach < n);
    let best = reaches.map(|reach| (reach, missed(reach))).min_by(|a, b| a.1.total_cmp(&b.1));
    let Some((reach, _)) = best else { return values.to_vec() };
    let mean = |i: usize| {
        let (a, b) = around(i, reach);
        (sums[b] - sums[a]) / (b - a) as f64
    };
    (0..n).map(mean).collect()
}

/// Between which points of a mesh rising times lie: the number of the first, and the share of the way to the next.
pub(super) fn places(mesh: &[f64], time: &[f64]) -> impl Iterator<Item = (usize, f64)> {
    let mut i = 0;
    time.iter().map(move |t| {
        while i + 2 < mesh.len() && mesh[i + 1] <= *t {
            i += 1;
        }
        (i, (t - mesh[i]) / (mesh[i + 1] - mesh[i]))
    })
}

/// A series on a mesh, straight between its points, at rising times.
fn read(mesh: &[f64], values: &[f64], time: &[f64]) -> Vec<f64> {
    places(mesh, time).map(|(i, share)| values[i] + share * (values[i + 1] - values[i])).collect()
}
