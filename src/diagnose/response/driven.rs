//! The likelihood of what a model leaves of an output, where a random process drives a state or adds to that output.
//!
//! # Method
//! f' = −f/τ + w of standard deviation s enters a rate of the linearised model, δx₊ = F δx + G (f + f₊), and is seen as
//! C δx, or it is seen as it is; white noise is added to either. Kalman's filter gives the innovations v and their
//! variances S for noise of 1, and the size of both in closed form: σ² = mean v²/S, ln L = −(N ln σ² + Σ ln S)/2.
//!
//! # References
//! A. C. Harvey, Forecasting, Structural Time Series Models and the Kalman Filter (1989), 3.4.3 (concentrated likelihood);
//! G. E. Uhlenbeck, L. S. Ornstein, Phys. Rev. 36 (1930) 823.

use super::along::Along;
use super::{Response, Track};

/// Points of the meshes at most, each recording's share from its beginning.
const LONGEST: usize = 3000;
/// Share of the points at the beginning, before which the states are not known, that are not counted.
const BEGINNING: f64 = 0.1;
/// How far a sample may lie from a point, as a share of the step.
const BESIDE: f64 = 1e-3;

/// A random process that drives what an output shows.
#[derive(Debug, Clone, Copy)]
pub struct Driven {
    /// Log-likelihood of the samples.
    pub likelihood: f64,
    /// Standard deviation of the white noise, SI.
    pub noise: f64,
    /// Standard deviation of the process, in the unit of the rate or the output, SI.
    pub size: f64,
}

/// What is left of an output along the recordings, and where a process may drive it.
pub struct Drive<'a> {
    /// Recordings, each with what is left where a sample lies on its mesh.
    runs: Vec<(&'a Along, Vec<Option<f64>>)>,
    /// States of the model that take part: none where the output itself is driven.
    states: usize,
    /// Number of the rate.
    rate: usize,
    output: usize,
    outputs: usize,
}

impl Response {
    /// What is left of an output along the recordings, driven at a state, or at the output where none is given; without
    /// those of which fewer than ten samples lie on the mesh, and `None` where no other is there.
    pub fn drive(&self, tracks: &[Track], output: usize, state: Option<usize>) -> Option<Drive<'_>> {
        let (mut first, mut runs, each) = (0, Vec::new(), LONGEST / self.runs.len().max(1));
        for along in &self.runs {
            let own = tracks.get(first..first + along.tracks.len())?;
            first += along.tracks.len();
            let number = along.tracks.iter().position(|t| t.0 == output);
            runs.extend(number.and_then(|k| Some((along, on_mesh(along, (k, each), &own[k].residual)?))));
        }
        let (states, rate) = state.map_or((0, 0), |j| (self.model.states.len(), j));
        let outputs = self.model.outputs.len();
        (!runs.is_empty()).then_some(Drive { runs, states, rate, output, outputs })
    }
}

/// What a pass of the filter sums up.
struct Passed {
    /// Σ v²/S
    squares: f64,
    /// Σ ln S
    logs: f64,
    samples: usize,
    /// Variance of what the output shows of the process without any measurement, at the end.
    shown: f64,
}

impl Drive<'_> {
    /// The standard deviation of what the output shows, at the end of a recording, of a process of deviation 1 and memory
    /// `tau`, in s.
    pub fn shows(&self, tau: f64) -> f64 {
        self.pass((tau, 1.0), false).shown.sqrt()
    }

    /// How likely a process of memory `tau`, in s, makes what is left, `size` times as large as the white noise beside it.
    pub fn driven(&self, tau: f64, size: f64) -> Option<Driven> {
        let passed = self.pass((tau, size), true);
        let n = passed.samples as f64;
        let noise = (passed.squares / n).sqrt();
        let likelihood = -0.5 * (n * noise.powi(2).ln() + passed.logs);
        let is_known = passed.samples >= 10 && likelihood.is_finite();
        is_known.then_some(Driven { likelihood, noise, size: size * noise })
    }

    /// The log-likelihood of the same samples as white noise.
    pub fn white(&self) -> Option<f64> {
        self.driven(1.0, 0.0).map(|d| d.likelihood)
    }

    /// Filters what is left by a process of some memory and size, or follows the variances alone; the sums of all recordings.
    fn pass(&self, process: (f64, f64), is_filtered: bool) -> Passed {
        let mut sum = Passed { squares: 0.0, logs: 0.0, samples: 0, shown: 0.0 };
        for (along, residual) in &self.runs {
            self.pass_one(along, (residual, is_filtered), process, &mut sum);
        }
        sum
    }

    fn pass_one(
        &self,
        along: &Along,
        (residual, is_filtered): (&[Option<f64>], bool),
        process: (f64, f64),
        sum: &mut Passed,
    ) {
        let (n, count) = (self.states + 1, residual.len());
        let (mut z, mut p) = (vec![0.0; n], vec![0.0; n * n]);
        p[n * n - 1] = process.1.powi(2);
        let (mut seen, mut shown) = (vec![0.0; n], 0.0);
        for (i, left) in residual.iter().enumerate() {
            self.look(along, i, &mut seen);
            // P C'
            let pc: Vec<f64> = (0..n).map(|r| dot(&p[r * n..][..n], &seen)).collect();
            shown = dot(&pc, &seen);
            if let Some(e) = left.filter(|_| is_filtered) {
                let (v, s) = (e - dot(&z, &seen), shown + 1.0);
                if i as f64 >= BEGINNING * count as f64 {
                    sum.squares += v * v / s;
                    sum.logs += s.ln();
                    sum.samples += 1;
                }
                for r in 0..n {
                    z[r] += pc[r] * v / s;
                    for c in 0..n {
                        p[r * n + c] -= pc[r] * pc[c] / s;
                    }
                }
            }
            if i + 1 < count {
                self.step((along, i), process, &mut z, &mut p);
            }
        }
        sum.shown = sum.shown.max(shown);
    }

    /// What the output shows of the states and the process at a time.
    fn look(&self, along: &Along, i: usize, seen: &mut [f64]) {
        let n = self.states;
        let row = &along.shown[(i * self.outputs + self.output) * n..];
        seen[..n].copy_from_slice(&row[..n]);
        seen[n] = if n == 0 { 1.0 } else { 0.0 };
    }

    /// z₊ = T z and P₊ = T P T' + s²(1 − φ²) Γ Γ', with f₊ = φ f + w in both ends of the step.
    fn step(&self, (along, i): (&Along, usize), (tau, size): (f64, f64), z: &mut Vec<f64>, p: &mut Vec<f64>) {
        let (n, m) = (self.states, self.states + 1);
        let keeps = (-(along.time[i + 1] - along.time[i]) / tau).exp();
        let mut t = vec![0.0; m * m];
        let mut push = vec![1.0; m];
        let (f, g) = along.step(i, n);
        for r in 0..n {
            t[r * m..][..n].copy_from_slice(&f[r * n..][..n]);
            push[r] = g[r * n + self.rate];
            t[r * m + n] = push[r] * (1.0 + keeps);
        }
        t[m * m - 1] = keeps;
        let times = |a: &[f64], b: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            let of = |k: usize| (0..m).map(|j| a[k / m * m + j] * b(j, k % m)).sum();
            (0..m * m).map(of).collect()
        };
        *z = (0..m).map(|r| dot(&t[r * m..][..m], z)).collect();
        let tp = times(&t, &|r, c| p[r * m + c]);
        *p = times(&tp, &|r, c| t[c * m + r]);
        let drawn = size * size * (1.0 - keeps * keeps);
        (0..m * m).for_each(|k| p[k] += drawn * push[k / m] * push[k % m]);
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The residual at the first points of the mesh, where samples lie on them.
fn on_mesh(along: &Along, (track, most): (usize, usize), residual: &[f64]) -> Option<Vec<Option<f64>>> {
    let times = &along.tracks[track].2;
    let mut next = 0;
    let place = |(i, t): (usize, &f64)| {
        let step = along.time.get(i + 1).map_or(f64::INFINITY, |after| after - t);
        while times.get(next).is_some_and(|s| *s < t - BESIDE * step) {
            next += 1;
        }
        let is_here = times.get(next).is_some_and(|s| (s - t).abs() <= BESIDE * step);
        is_here.then(|| residual.get(next).copied()).flatten()
    };
    let all: Vec<Option<f64>> = along.time.iter().enumerate().take(most).map(place).collect();
    (all.iter().flatten().count() >= 10).then_some(all)
}
