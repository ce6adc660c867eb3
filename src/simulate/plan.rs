//! # Purpose
//! Chooses method and step so that the solver's error is known and far below any noise.
//!
//! # Method
//! Runs at the model's own parameters with 1, 2, 4 … steps in a usual interval of the mesh until
//! halving the step moves the outputs by less than the tolerance, a share of each output's spread;
//! a model for which the explicit method needs many steps takes the stiff one if that needs fewer,
//! one for which a single step is far better than needed takes the method of Heun if that does.
//!
//! # Numerical aspects
//! The difference of two halvings is the error of the coarser one. For other parameters the error
//! is foretold from the roughness of the steps (their embedded error), which grows with it; where
//! it is foretold too large, or a run blows up, the run is repeated with more or stiff steps.

use super::budget::Allowance;
use super::course::Course;
use super::probe::Clock;
use super::run::{Ran, run};
use super::steps::Solver;
use crate::Result;
use crate::model::Scalar;

/// Solver, steps, and the error that they leave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plan {
    pub method: Solver,
    pub substeps: usize,
    /// Share of the outputs' spread by which halving the step moved them.
    pub error: f64,
    /// The roughness of the run that it was measured on.
    pub roughness: f64,
    /// Whether the model blew up in that run.
    pub blew_up: bool,
}

/// A plan with the mesh that it was made on, for a model that is much like the one that it was made for.
#[derive(Debug, Clone, Copy)]
pub struct Planned {
    pub(super) plan: Plan,
    pub(super) careful: Option<Plan>,
    /// Intervals, and the usual length of one, s.
    pub(super) mesh: (usize, f64),
}

/// Steps in an interval at which the stiff method is tried, and at which each method gives up;
/// a mesh of few intervals may be cut finer, up to so many steps in a run.
const MANY: (usize, usize) = (8, 100_000);
const MOST_EXPLICIT: (usize, usize) = (64, 2_000_000);
const MOST_STIFF: (usize, usize) = (16, 200_000);
/// Steps in an interval beyond which no mesh is cut.
const FINEST: usize = 8192;

/// An error of this share of the tolerance in one step shows that Heun's method may do; it does
/// where its own error is a smaller share than the second, and every state as smooth as the third.
const MORE_THAN_NEEDED: f64 = 1e-2;
const WITH_A_MARGIN: f64 = 0.1;
const SMOOTH: f64 = 1e-2;
/// An error below this falls quickly enough with more steps.
const CONVERGING: f64 = 0.01;
/// Share of what runs that blow up have in common by which they are compared.
const BEFORE_THE_END: f64 = 0.8;
/// Fewer values than these in common say nothing.
const TOO_FEW: usize = 8;
/// Halving the step must divide the error by so much before the next halving is foretold to.
const ASYMPTOTIC: f64 = 10.0;

fn limit((least, in_a_run): (usize, usize), intervals: usize) -> usize {
    (in_a_run / intervals.max(1)).clamp(least, FINEST)
}

/// The most steps in an interval that a method may take.
pub(super) fn most_substeps(method: Solver, intervals: usize) -> usize {
    limit(if method == Solver::Stiff { MOST_STIFF } else { MOST_EXPLICIT }, intervals)
}

impl Plan {
    /// Whether it goes to the end with an error below a tolerance.
    fn meets(&self, tolerance: f64) -> bool {
        !self.blew_up && self.error <= tolerance
    }

    /// The error foretold for a run of another roughness.
    pub fn foretold(&self, roughness: f64) -> f64 {
        let grown = if self.roughness > 0.0 { roughness / self.roughness } else { 1.0 };
        // The embedded errors are of order 3 where the methods are of order 4; both of Heun's are of order 2.
        self.error * if self.method == Solver::Heun { grown } else { grown.powf(4.0 / 3.0) }
    }

    /// The same with the next power of two times more steps.
    pub fn finer(&self, times: f64) -> Self {
        let factor = (times.ceil().clamp(2.0, 1e4) as usize).next_power_of_two();
        // Both methods are of order 4, their embedded errors of order 3.
        let (error, roughness) = ((factor as f64).powi(-4), (factor as f64).powi(-3));
        Self {
            method: self.method,
            substeps: self.substeps * factor,
            error: self.error * error,
            roughness: self.roughness * roughness,
            blew_up: self.blew_up,
        }
    }
}

/// The plan for a model at its own parameters, and the one to take where that does not do if it is
/// not of order 4.
pub(super) fn plan(search: &Search<'_>) -> Result<(Plan, Option<Plan>)> {
    let explicit = search.refine(Solver::Explicit, limit(MANY, search.course.mesh.intervals()))?;
    if explicit.substeps == 1 && explicit.meets(MORE_THAN_NEEDED * search.tolerance) {
        let heun = search.refine(Solver::Heun, 2)?;
        if heun.meets(WITH_A_MARGIN * search.tolerance) && heun.roughness <= SMOOTH {
            return Ok((heun, Some(explicit)));
        }
    }
    Ok((of_order_four(search, explicit)?, None))
}

fn of_order_four(search: &Search<'_>, explicit: Plan) -> Result<Plan> {
    let (tolerance, intervals) = (search.tolerance, search.course.mesh.intervals());
    if explicit.meets(tolerance) {
        return Ok(explicit);
    }
    let stiff = if explicit.meets(CONVERGING) { explicit } else { search.stiff()? };
    if stiff.meets(tolerance) {
        return Ok(stiff);
    }
    let longer = search.refine(Solver::Explicit, limit(MOST_EXPLICIT, intervals))?;
    // Where the stiff method does not converge either, the model itself blows up; the stiff method
    // damps that for some steps.
    let longer_is_better =
        if longer.blew_up { !stiff.meets(CONVERGING) } else { stiff.blew_up || longer.error <= stiff.error };
    Ok(if longer_is_better { longer } else { stiff })
}

/// The search for a plan at given parameters.
pub(super) struct Search<'a> {
    pub course: &'a Course<'a>,
    pub parameters: &'a [f64],
    pub given: &'a [f64],
    pub tolerance: f64,
}

impl Search<'_> {
    fn run(&self, (method, substeps): (Solver, usize), allowance: &Allowance<'_>) -> Result<Ran<f64>> {
        let Course { program, natives, mesh, clocks, steady, .. } = *self.course;
        let course = Course { program, natives, mesh, clocks, steady, method, substeps, allowance };
        run(&course, self.parameters, self.given)
    }

    /// The plan of the stiff method; none that has not begun to converge.
    pub fn stiff_if_it_converges(&self) -> Result<Option<Plan>> {
        Ok(Some(self.stiff()?).filter(|p| p.meets(CONVERGING)))
    }

    /// Stiff steps that do elsewhere, where the roughness of a run with them says that they do here, else as above.
    pub fn stiff_from(&self, known: Plan) -> Result<Option<Plan>> {
        let ran = self.run((known.method, known.substeps), &self.course.allowance.budget().one_run())?;
        let error = known.foretold(ran.roughness);
        if ran.is_cut || ran.blew_up.is_some() || error > self.tolerance {
            return self.stiff_if_it_converges();
        }
        Ok(Some(Plan { error, roughness: ran.roughness, ..known }))
    }

    fn stiff(&self) -> Result<Plan> {
        self.refine(Solver::Stiff, limit(MOST_STIFF, self.course.mesh.intervals()))
    }

    /// The fewest steps whose halving moves the outputs by less than the tolerance; the best so far where one
    /// simulation may spend no more.
    fn refine(&self, method: Solver, most: usize) -> Result<Plan> {
        let allowance = self.course.allowance.budget().one_run();
        let mut coarse = self.run((method, 1), &allowance)?;
        let plan = |substeps, error, ran: &Ran<f64>| Plan {
            method,
            substeps,
            error,
            roughness: ran.roughness,
            blew_up: ran.blew_up.is_some(),
        };
        let mut best = plan(1, f64::INFINITY, &coarse);
        let (mut substeps, mut last) = (1, f64::INFINITY);
        while substeps < most {
            let fine = self.run((method, 2 * substeps), &allowance)?;
            if fine.is_cut {
                break;
            }
            let error = coarse.difference(self.course.clocks, &fine);
            let this = plan(substeps, error, &coarse);
            let rank = |p: &Plan| (p.blew_up, p.error.max(self.tolerance));
            // Of runs that blow up before they agree, the one with a few steps an interval is kept.
            let none_agrees = this.blew_up && best.blew_up && best.error > CONVERGING && substeps <= 4;
            if none_agrees || rank(&this) < rank(&best) {
                best = this;
            }
            let gains = error < 0.5 * last;
            let settled = error < CONVERGING && !gains;
            let hopeless = this.blew_up && (settled || (method == Solver::Stiff && substeps > 2));
            if this.meets(self.tolerance) || (hopeless && fine.blew_up.is_some()) {
                break;
            }
            let next = error / 16.0;
            if last / error > ASYMPTOTIC && next <= self.tolerance && fine.blew_up.is_none() {
                return Ok(plan(2 * substeps, next, &fine));
            }
            (coarse, last) = (fine, error);
            substeps *= 2;
        }
        Ok(best)
    }
}

impl<T: Scalar> Ran<T> {
    /// The largest root-mean-square difference of an output from that of another run, as a share of its spread.
    pub fn difference(&self, clocks: &[Clock], other: &Self) -> f64 {
        if self.blew_up.is_some() != other.blew_up.is_some() {
            return f64::INFINITY;
        }
        let part = if self.blew_up.is_some() { BEFORE_THE_END } else { 1.0 };
        let one = |((clock, a), b): ((&Clock, &Vec<T>), &Vec<T>)| {
            // Outputs of one clock stand side by side, each in its own unit.
            let width = clock.registers.len();
            let column =
                |v: &[T], j: usize| v.iter().skip(j).step_by(width).map(|v| v.value()).collect::<Vec<_>>();
            (0..width).map(|j| share(&column(a, j), &column(b, j), part)).fold(0.0, worse)
        };
        clocks.iter().zip(&self.values).zip(&other.values).map(one).fold(0.0, worse)
    }
}

fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

fn share(a: &[f64], b: &[f64], part: f64) -> f64 {
    let common = || a.iter().zip(b).filter(|(x, y)| x.is_finite() && y.is_finite());
    let count = (part * common().count() as f64) as usize;
    if part < 1.0 && count < TOO_FEW {
        return f64::INFINITY;
    }
    let pairs = || common().take(count);
    let n = count.max(1) as f64;
    let mean = pairs().map(|(x, _)| x).sum::<f64>() / n;
    let spread = (pairs().map(|(x, _)| (x - mean).powi(2)).sum::<f64>() / n).sqrt();
    let moved = (pairs().map(|(x, y)| (x - y).powi(2)).sum::<f64>() / n).sqrt();
    // A constant output is compared with its size.
    let scale = if spread > 1e-9 * mean.abs() { spread } else { mean.abs() };
    if moved == 0.0 { 0.0 } else { moved / scale }
}
