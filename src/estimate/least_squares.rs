//! Bounded non-linear least squares.
//!
//! # Purpose
//! Minimise ½‖r(x)‖² over a box, r given by a simulation that may fail or blow up at a trial point.
//!
//! # Method
//! Levenberg and Marquardt with Moré's scaling, in the coordinates of [`Range`]. Unknowns that press
//! against a bound are taken out; in a step that would leave the box the unknown that meets its bound first
//! stays there and the rest is solved anew. A trial that is not finite counts as infinitely bad and shortens the next step.
//! Where the walk rests, unknowns without a slope are looked at some way off (see `saddle`).
//!
//! # References
//! J. J. Moré, The Levenberg-Marquardt algorithm, Lecture Notes in Mathematics 630 (1978) 105-116;
//! H. B. Nielsen, Damping parameter in Marquardt's method, IMM-REP-1999-05, Lyngby 1999.
//!
//! # Numerical aspects
//! Steps come from the orthogonal factor of J, so that sensitivities are used to full precision.

pub mod problem;

pub use problem::Problem;

use super::coordinates::{Range, Side};
use super::saddle::Rest;
use super::triangle::Triangle;
use crate::{Error, Result};

/// When to stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stopping {
    /// Steps that may be taken.
    pub iterations: usize,
    /// Relative fall of the sum of squares that is no longer worth a step.
    pub reduction: f64,
    /// Relative size of a step that is no longer one.
    pub step: f64,
}

impl Default for Stopping {
    fn default() -> Self {
        Self { iterations: 60, reduction: 1e-8, step: 1e-10 }
    }
}

/// Why the walk ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// No step lowers the sum of squares by a part worth having.
    Converged,
    /// No shorter step helps, yet the slope is not zero: the residual is rough here.
    Stalled,
    /// The steps ran out.
    OutOfSteps,
    /// What it may spend was spent.
    OutOfBudget,
}

/// A minimum.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// The unknowns there.
    pub x: Vec<f64>,
    /// ‖r‖² there.
    pub sum_of_squares: f64,
    /// ‖r‖² at the start.
    pub start_sum_of_squares: f64,
    /// [∂r/∂x | r] there, as a triangle in x.
    pub triangle: Triangle,
    /// The bound each unknown sits at.
    pub at_bound: Vec<Option<Side>>,
    /// Whether the residuals do not move with an unknown there, to first order.
    pub is_level: Vec<bool>,
    /// Why the walk ended.
    pub end: End,
    /// Steps taken.
    pub iterations: usize,
    /// Residuals computed.
    pub evaluations: usize,
}

/// Walks from `start` to a minimum inside `ranges`.
///
/// # Errors
/// Where the residuals cannot be computed at the start itself.
///
/// ```
/// use gyrospec::estimate::{Problem, Range, Stopping, Triangle, minimise};
/// struct Rosenbrock;
/// impl Problem for Rosenbrock {
///     fn unknowns(&self) -> usize { 2 }
///     fn sum_of_squares(&self, x: &[f64]) -> gyrospec::Result<f64> {
///         Ok((10.0 * (x[1] - x[0] * x[0])).powi(2) + (1.0 - x[0]).powi(2))
///     }
///     fn linearise(&self, x: &[f64]) -> gyrospec::Result<Triangle> {
///         let mut t = Triangle::new(2);
///         let r = [10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]];
///         t.push(&[&[-20.0 * x[0], -1.0], &[10.0, 0.0]], &r);
///         Ok(t)
///     }
/// }
/// let least = minimise(&Rosenbrock, &[-1.2, 1.0], &[Range::FREE; 2], Stopping::default())?;
/// assert!((least.x[0] - 1.0).abs() < 1e-6 && (least.x[1] - 1.0).abs() < 1e-6);
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn minimise<P: Problem + ?Sized>(
    problem: &P,
    start: &[f64],
    ranges: &[Range],
    stopping: Stopping,
) -> Result<Minimum> {
    let x: Vec<f64> = start.iter().zip(ranges).map(|(x, r)| r.clamp(*x)).collect();
    let triangle = problem.linearise(&x)?;
    let sum = triangle.sum_of_squares();
    if !sum.is_finite() {
        return Err(Error::not_computed("the residuals are not finite at the start of the fit")
            .with_hint("start nearer, narrow the bounds, or check the units"));
    }
    let mut walk = Walk {
        problem,
        ranges,
        start: x.clone(),
        scale: vec![0.0; x.len()],
        x,
        sum,
        triangle,
        damping: 1e-6,
        growth: GROWTH,
        iterations: 0,
        evaluations: 1,
    };
    let end = walk.run(stopping);
    Ok(Minimum {
        at_bound: walk.x.iter().zip(ranges).map(|(x, r)| r.at_bound(*x)).collect(),
        is_level: (0..walk.x.len()).map(|j| walk.rest(stopping).is_level(j)).collect(),
        x: walk.x,
        sum_of_squares: walk.sum,
        start_sum_of_squares: sum,
        triangle: walk.triangle,
        end,
        iterations: walk.iterations,
        evaluations: walk.evaluations,
    })
}

/// Smallest damping, and the one at which no step is left.
const DAMPING: (f64, f64) = (1e-12, 1e12);
/// Damping after the first step that is refused: near a minimum none is needed, so none is begun with.
const FIRST_REFUSAL: f64 = 1e-4;
/// How much stronger the damping becomes by a first refusal.
const GROWTH: f64 = 4.0;

struct Walk<'a, P: ?Sized> {
    problem: &'a P,
    ranges: &'a [Range],
    start: Vec<f64>,
    x: Vec<f64>,
    sum: f64,
    triangle: Triangle,
    scale: Vec<f64>,
    damping: f64,
    growth: f64,
    iterations: usize,
    evaluations: usize,
}

/// A trial step in z, with the sum of squares that the linear problem promises.
struct Step {
    z: Vec<f64>,
    promised: f64,
}

enum Taken {
    Yes { fall: f64, relative_step: f64 },
    No { promised_fall: f64 },
}

impl<P: Problem + ?Sized> Walk<'_, P> {
    fn run(&mut self, stopping: Stopping) -> End {
        loop {
            let end = self.descend(stopping);
            if !matches!(end, End::Converged | End::Stalled) || !self.leaves_saddle(stopping) {
                return end;
            }
        }
    }

    fn rest(&self, stopping: Stopping) -> Rest<'_, P> {
        Rest {
            problem: self.problem,
            ranges: self.ranges,
            x: &self.x,
            sum: self.sum,
            triangle: &self.triangle,
            start: &self.start,
            reduction: stopping.reduction,
        }
    }

    /// Goes to a lower point beside one of rest, if there is one.
    fn leaves_saddle(&mut self, stopping: Stopping) -> bool {
        let (lower, evaluations) = self.rest(stopping).way_down();
        self.evaluations += evaluations;
        let Some((x, triangle)) = lower.and_then(|x| self.problem.linearise(&x).ok().map(|t| (x, t))) else {
            return false;
        };
        let sum = triangle.sum_of_squares();
        if sum.is_nan() || sum >= self.sum {
            return false;
        }
        (self.x, self.triangle, self.sum) = (x, triangle, sum);
        (self.damping, self.growth) = (FIRST_REFUSAL, GROWTH);
        self.evaluations += 1;
        true
    }

    fn descend(&mut self, stopping: Stopping) -> End {
        while self.iterations < stopping.iterations {
            if self.problem.is_over() {
                return End::OutOfBudget;
            }
            self.iterations += 1;
            let inner = self.inner_triangle();
            loop {
                let step = self.step(&inner);
                match self.try_step(&step) {
                    Taken::Yes { fall, relative_step } => {
                        let refreshed = self.problem.linearise(&self.x);
                        self.evaluations += 1;
                        match refreshed {
                            Ok(t) if t.sum_of_squares().is_finite() => self.triangle = t,
                            _ => return End::Stalled,
                        }
                        if fall <= stopping.reduction || relative_step <= stopping.step {
                            return End::Converged;
                        }
                        break;
                    }
                    Taken::No { promised_fall } if promised_fall <= stopping.reduction => {
                        return End::Converged;
                    }
                    Taken::No { .. } if self.problem.is_over() => return End::OutOfBudget,
                    Taken::No { .. } if self.damping > DAMPING.1 => return End::Stalled,
                    Taken::No { .. } => {}
                }
            }
        }
        End::OutOfSteps
    }

    /// The triangle in z, with the scale of each column brought up to date.
    fn inner_triangle(&mut self) -> Triangle {
        let slopes: Vec<f64> = self.x.iter().zip(self.ranges).map(|(x, r)| r.slope(*x)).collect();
        let inner = self.triangle.clone().scaled(&slopes);
        for (s, norm) in self.scale.iter_mut().zip(inner.column_norms()) {
            *s = s.max(norm);
        }
        inner
    }

    /// The damped step inside the box: the unknown that meets its bound first stays there, and the rest
    /// is solved anew, until none leaves. No such step promises a rise.
    fn step(&self, inner: &Triangle) -> Step {
        let z: Vec<f64> = self.x.iter().zip(self.ranges).map(|(x, r)| r.inward(*x)).collect();
        let gradient = inner.gradient();
        let room = |j: usize, towards: f64| {
            let (low, high) = self.ranges[j].inner();
            if towards < 0.0 { low - z[j] } else { high - z[j] }
        };
        let presses = |j: usize| gradient[j] * room(j, -gradient[j]) == 0.0;
        let mut free: Vec<usize> = (0..z.len()).filter(|j| !presses(*j) && self.scale[*j] > 0.0).collect();
        let mut delta = vec![0.0; z.len()];
        while !free.is_empty() {
            let damping: Vec<f64> = free.iter().map(|j| self.damping.sqrt() * self.scale[*j]).collect();
            let solved = inner.restricted(&free, &delta).solve(&damping);
            let share = |k: usize| room(free[k], solved[k]) / solved[k];
            let first = (0..free.len())
                .filter(|k| solved[*k] != 0.0 && share(*k) < 1.0)
                .min_by(|a, b| share(*a).total_cmp(&share(*b)));
            let Some(k) = first else {
                free.iter().zip(&solved).for_each(|(j, d)| delta[*j] = *d);
                break;
            };
            delta[free[k]] = room(free[k], solved[k]);
            free.remove(k);
        }
        Step { promised: inner.predicted(&delta), z: z.iter().zip(&delta).map(|(z, d)| z + d).collect() }
    }

    fn try_step(&mut self, step: &Step) -> Taken {
        let trial: Vec<f64> = step.z.iter().zip(self.ranges).map(|(z, r)| r.outward(*z)).collect();
        let promised_fall = (self.sum - step.promised) / self.sum.max(f64::MIN_POSITIVE);
        if !trial.iter().all(|x| x.is_finite()) {
            return self.refuse(1.0);
        }
        let sum = self.problem.sum_of_squares(&trial).unwrap_or(f64::INFINITY);
        self.evaluations += 1;
        if sum.is_nan() || sum >= self.sum {
            return self.refuse(promised_fall);
        }
        let gain = (self.sum - sum) / (self.sum - step.promised).max(f64::MIN_POSITIVE);
        // λ ← λ·max(1/10, 1 − (2ϱ − 1)³)
        let factor = (1.0 - (2.0 * gain.min(1.0) - 1.0).powi(3)).max(0.1);
        self.damping = (self.damping * factor).max(DAMPING.0);
        self.growth = GROWTH;
        let relative = |(a, b): (&f64, &f64)| (a - b).abs() / a.abs().max(b.abs()).max(f64::MIN_POSITIVE);
        let relative_step = self.x.iter().zip(&trial).map(relative).fold(0.0, f64::max);
        let fall = (self.sum - sum) / self.sum.max(f64::MIN_POSITIVE);
        self.x = trial;
        self.sum = sum;
        Taken::Yes { fall, relative_step }
    }

    fn refuse(&mut self, promised_fall: f64) -> Taken {
        self.damping = (self.damping * self.growth).max(FIRST_REFUSAL);
        self.growth *= 2.0;
        Taken::No { promised_fall }
    }
}

#[cfg(test)]
mod tests;
