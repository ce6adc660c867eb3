//! # Purpose
//! The slow states simulated in time beside the exact moments: an independent check.
//!
//! # Method
//! The fast states and the integrals of all signals that hold white noise step exactly; a
//! product over a step is the mean of its right signal at both ends times the left signal's
//! integral (Stratonovich). Replicates give 99 % intervals by Student's t.
//!
//! # References
//! P. E. Kloeden, E. Platen, Numerical Solution of Stochastic Differential Equations, ch. 4.9.
//!
//! # Numerical aspects
//! The error of the products is of second order in step × fastest rate. Each replicate has a
//! stream of its own of one seed, so the numbers do not depend on the number of threads.

use super::rectified::SlowFast;
use crate::lti::{Discrete, stationary_covariance};
use crate::{Error, Result};
use faer::Mat;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// How long and how often to simulate.
#[derive(Debug, Clone, Copy)]
pub struct MonteCarlo {
    /// Step, s.
    pub step: f64,
    /// Time kept of each replicate, s.
    pub duration: f64,
    /// Time left to settle before, s.
    pub settle: f64,
    /// Replicates.
    pub runs: usize,
    /// Seed.
    pub seed: u64,
}

/// What the simulation gives for one slow state, with 99 % intervals.
#[derive(Debug, Clone, Copy)]
pub struct Simulated {
    /// Mean over time and replicates.
    pub mean: f64,
    /// Half the width of its 99 % interval.
    pub mean_margin: f64,
    /// Mean square about `about`.
    pub variance: f64,
    /// Half the width of its 99 % interval.
    pub variance_margin: f64,
}

/// One push ready to step: its row, gain, where the integral of its left signal is, and its right.
struct Step {
    row: usize,
    gain: f64,
    integral: usize,
    right: Option<Vec<f64>>,
}

impl MonteCarlo {
    /// Simulates `system` and watches its slow state `row`; the variance is about `about`, its
    /// known mean.
    ///
    /// # Errors
    /// `BadInput` for times or counts that are not positive; else as the covariance says.
    pub fn run(&self, system: &SlowFast, row: usize, about: f64) -> Result<Simulated> {
        if !(self.step > 0.0 && self.duration > self.step && self.settle >= 0.0) || self.runs < 2 {
            return Err(Error::bad_input("a simulation needs a step, a longer duration and two replicates"));
        }
        let (a, b, steps) = with_integrals(system);
        let fast = Discrete::new(&a, &b, self.step);
        let n = system.fast.nrows();
        let still = Mat::zeros(system.slow.nrows(), 1);
        let slow = Discrete::new(&system.slow, &still, self.step);
        // a start from the stationary state: one draw of its covariance
        let q = &system.noise * system.noise.transpose();
        stationary_covariance(&system.fast, &q)?;
        let results: Vec<(f64, f64)> = (0..self.runs)
            .into_par_iter()
            .map(|replicate| {
                let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
                rng.set_stream(replicate as u64);
                let mut run = Run { fast: fast.clone(), slow: slow.clone(), steps: &steps, n, system };
                run.go(self, row, about, &mut rng)
            })
            .collect();
        let (mean, mean_margin) = interval(results.iter().map(|r| r.0));
        let (variance, variance_margin) = interval(results.iter().map(|r| r.1));
        Ok(Simulated { mean, mean_margin, variance, variance_margin })
    }
}

struct Run<'a> {
    fast: Discrete,
    slow: Discrete,
    steps: &'a [Step],
    n: usize,
    system: &'a SlowFast,
}

impl Run<'_> {
    fn go(&mut self, plan: &MonteCarlo, row: usize, about: f64, rng: &mut ChaCha8Rng) -> (f64, f64) {
        let k = self.system.slow.nrows();
        let integrals = self.steps.iter().map(|s| s.integral + 1).max().unwrap_or(0).max(self.n) - self.n;
        let mut z = vec![0.0; self.n + integrals];
        let mut y = super::instrument::rest(&self.system.slow, &self.system.constant);
        y[row] = about;
        let settling = (plan.settle / plan.step).ceil() as usize;
        let keeping = (plan.duration / plan.step).ceil() as usize;
        let (mut sum, mut squares) = (0.0, 0.0);
        let mut before = z.clone();
        for k_step in 0..settling + keeping {
            before.copy_from_slice(&z);
            z[self.n..].fill(0.0);
            self.fast.advance(&mut z, rng);
            let mut push: Vec<f64> = (0..k).map(|i| self.system.constant[i] * plan.step).collect();
            for s in self.steps {
                let right = s.right.as_ref().map_or(1.0, |c| {
                    c.iter()
                        .zip(&before[..self.n])
                        .zip(&z[..self.n])
                        .map(|((c, a), b)| 0.5 * c * (a + b))
                        .sum()
                });
                push[s.row] += s.gain * z[s.integral] * right;
            }
            // half of the push before the step, half after
            y.iter_mut().zip(&push).for_each(|(y, p)| *y += 0.5 * p);
            self.slow.advance(&mut y, rng);
            y.iter_mut().zip(&push).for_each(|(y, p)| *y += 0.5 * p);
            if k_step >= settling {
                sum += y[row];
                squares += (y[row] - about).powi(2);
            }
        }
        (sum / keeping as f64, squares / keeping as f64)
    }
}

/// Fast states with the integral of every pushing signal beside them.
fn with_integrals(system: &SlowFast) -> (Mat<f64>, Mat<f64>, Vec<Step>) {
    let (n, m) = (system.fast.nrows(), system.noise.ncols());
    let lefts: Vec<_> =
        system.linear.iter().map(|p| &p.signal).chain(system.products.iter().map(|p| &p.left)).collect();
    let mut distinct: Vec<&super::Signal> = Vec::new();
    for s in &lefts {
        if !distinct.contains(s) {
            distinct.push(s);
        }
    }
    let place = |s: &super::Signal| n + distinct.iter().position(|d| *d == s).unwrap_or(0);
    let size = n + distinct.len();
    let (mut a, mut b) = (Mat::zeros(size, size), Mat::zeros(size, m));
    for i in 0..n {
        (0..n).for_each(|j| a[(i, j)] = system.fast[(i, j)]);
        (0..m).for_each(|j| b[(i, j)] = system.noise[(i, j)]);
    }
    for (i, s) in distinct.iter().enumerate() {
        (0..n).for_each(|j| a[(n + i, j)] = s.state[j]);
        (0..m).for_each(|j| b[(n + i, j)] = s.noise[j]);
    }
    let mut steps: Vec<Step> = system
        .linear
        .iter()
        .map(|p| Step { row: p.row, gain: p.gain, integral: place(&p.signal), right: None })
        .collect();
    steps.extend(system.products.iter().map(|p| Step {
        row: p.row,
        gain: p.gain,
        integral: place(&p.left),
        right: Some(p.right.state.clone()),
    }));
    (a, b, steps)
}

/// Mean of replicates and half the width of its 99 % interval.
fn interval(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let v: Vec<f64> = values.collect();
    let n = v.len() as f64;
    let mean = v.iter().sum::<f64>() / n;
    let variance = v.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    let t = StudentsT::new(0.0, 1.0, n - 1.0).map_or(f64::INFINITY, |d| d.inverse_cdf(0.995));
    (mean, t * (variance / n).sqrt())
}
