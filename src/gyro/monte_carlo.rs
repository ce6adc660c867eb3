//! # Purpose
//! The slow states simulated in time beside the exact moments: an independent check.
//!
//! # Method
//! The fast states and the integrals of the linear pushes and of white noise step exactly. A
//! product of states over a step is its mean at both ends; a product with white noise is the
//! state at the start times the noise's integral, and ½ c₂B d₁ᵀ for the mean of both sides. Replicates give 99 % intervals by Student's t.
//!
//! # References
//! P. E. Kloeden, E. Platen, Numerical Solution of Stochastic Differential Equations, ch. 4.9.
//!
//! # Numerical aspects
//! The means of the products are exact; their spread errs in step × fastest rate. Each replicate has a
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

/// One push ready to step.
enum Step {
    /// The integral of a linear push.
    Linear { row: usize, gain: f64, integral: usize },
    /// A product: state parts, the integral of the left one's white noise, and the drift of both sides.
    Product { row: usize, gain: f64, left: Vec<f64>, right: Vec<f64>, white: usize, drift: f64 },
}

impl Step {
    /// The row that it pushes and how far over one step from `before` to `after`.
    fn push(&self, before: &[f64], after: &[f64], step: f64) -> (usize, f64) {
        let dot = |c: &[f64], z: &[f64]| c.iter().zip(z).map(|(c, z)| c * z).sum::<f64>();
        match self {
            Self::Linear { row, gain, integral } => (*row, gain * after[*integral]),
            Self::Product { row, gain, left, right, white, drift } => {
                let (r0, r1) = (dot(right, before), dot(right, after));
                let mean = 0.5 * (dot(left, before) * r0 + dot(left, after) * r1) + drift;
                (*row, gain * (mean * step + r0 * after[*white]))
            }
        }
    }
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
                let mut run =
                    Run { fast: fast.clone(), slow: slow.clone(), steps: &steps, n, size: a.nrows(), system };
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
    size: usize,
    system: &'a SlowFast,
}

impl Run<'_> {
    fn go(&mut self, plan: &MonteCarlo, row: usize, about: f64, rng: &mut ChaCha8Rng) -> (f64, f64) {
        let k = self.system.slow.nrows();
        let mut z = vec![0.0; self.size];
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
                let (row, by) = s.push(&before, &z, plan.step);
                push[row] += by;
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

/// Fast states with the integrals that the pushes need beside them.
fn with_integrals(system: &SlowFast) -> (Mat<f64>, Mat<f64>, Vec<Step>) {
    let (n, m) = (system.fast.nrows(), system.noise.ncols());
    let whites =
        system.products.iter().map(|p| super::Signal { state: vec![0.0; n], noise: p.left.noise.clone() });
    let integrands: Vec<super::Signal> =
        system.linear.iter().map(|p| p.signal.clone()).chain(whites).collect();
    let size = n + integrands.len();
    let (mut a, mut b) = (Mat::zeros(size, size), Mat::zeros(size, m));
    for i in 0..n {
        (0..n).for_each(|j| a[(i, j)] = system.fast[(i, j)]);
        (0..m).for_each(|j| b[(i, j)] = system.noise[(i, j)]);
    }
    for (i, s) in integrands.iter().enumerate() {
        (0..n).for_each(|j| a[(n + i, j)] = s.state[j]);
        (0..m).for_each(|j| b[(n + i, j)] = s.noise[j]);
    }
    let linear = system.linear.iter().enumerate();
    let mut steps: Vec<Step> =
        linear.map(|(i, p)| Step::Linear { row: p.row, gain: p.gain, integral: n + i }).collect();
    for (i, p) in system.products.iter().enumerate() {
        // ½ c₂ B d₁ᵀ
        let kick = |j: usize| (0..m).map(|k| system.noise[(j, k)] * p.left.noise[k]).sum::<f64>();
        let drift = 0.5 * (0..n).map(|j| p.right.state[j] * kick(j)).sum::<f64>();
        let (left, right) = (p.left.state.clone(), p.right.state.clone());
        let white = n + system.linear.len() + i;
        steps.push(Step::Product { row: p.row, gain: p.gain, left, right, white, drift });
    }
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
