//! # Purpose
//! Chooses method and step so that the solver's error is known and far below any noise.
//!
//! # Method
//! Runs at the model's own parameters with 1, 2, 4 … steps in a usual interval of the mesh until
//! halving the step moves the outputs by less than the tolerance, a share of each output's spread;
//! a model for which the explicit method needs many steps takes the stiff one if that needs fewer.
//!
//! # Numerical aspects
//! The difference of two halvings is the error of the coarser one. For other parameters the error
//! is foretold from the roughness of the steps (last stage against the rates at the end), which
//! grows with it; where it is foretold too large the run is repeated with more steps.

use super::run::{Course, Ran, run};
use super::steps::Method;
use crate::Result;

/// Method, steps, and the error that they leave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Plan {
    pub method: Method,
    pub substeps: usize,
    /// Share of the outputs' spread by which halving the step moved them.
    pub error: f64,
    /// The roughness of the run that it was measured on.
    pub roughness: f64,
}

/// Steps in an interval at which the stiff method is tried, and at which each method gives up;
/// a mesh of few intervals may be cut finer, up to so many steps in a run.
const MANY: (usize, usize) = (8, 100_000);
const MOST_EXPLICIT: (usize, usize) = (64, 2_000_000);
const MOST_STIFF: (usize, usize) = (16, 200_000);
/// Steps in an interval beyond which no mesh is cut.
const FINEST: usize = 8192;

/// An explicit error below this falls quickly enough with more steps.
const CONVERGING: f64 = 0.01;
/// Halving the step must divide the error by so much before the next halving is foretold to.
const ASYMPTOTIC: f64 = 10.0;

fn limit((least, in_a_run): (usize, usize), intervals: usize) -> usize {
    (in_a_run / intervals.max(1)).clamp(least, FINEST)
}

/// The most steps in an interval that the explicit method may take.
pub(super) fn most_substeps(intervals: usize) -> usize {
    limit(MOST_EXPLICIT, intervals)
}

impl Plan {
    /// The error foretold for a run of another roughness.
    pub fn foretold(&self, roughness: f64) -> f64 {
        let grown = if self.roughness > 0.0 { roughness / self.roughness } else { 1.0 };
        self.error * grown
    }
}

/// The plan for a model at its own parameters.
pub(super) fn plan(course: &Course<'_>, parameters: &[f64], given: &[f64], tolerance: f64) -> Result<Plan> {
    let search = Search { course, parameters, given, tolerance };
    let intervals = course.mesh.intervals();
    let explicit = search.refine(Method::Explicit, limit(MANY, intervals))?;
    if explicit.error <= tolerance {
        return Ok(explicit);
    }
    let stiff = if explicit.error < CONVERGING {
        explicit
    } else {
        search.refine(Method::Stiff, limit(MOST_STIFF, intervals))?
    };
    if stiff.error <= tolerance {
        return Ok(stiff);
    }
    let longer = search.refine(Method::Explicit, most_substeps(intervals))?;
    // NaN: a run that blew up is worse than any number.
    let worse = |p: &Plan| if p.error.is_nan() { f64::INFINITY } else { p.error };
    Ok(if worse(&longer) <= worse(&stiff) { longer } else { stiff })
}

struct Search<'a> {
    course: &'a Course<'a>,
    parameters: &'a [f64],
    given: &'a [f64],
    tolerance: f64,
}

impl Search<'_> {
    fn run(&self, method: Method, substeps: usize) -> Result<Ran<f64>> {
        let Course { program, mesh, clocks, steady, .. } = *self.course;
        run(&Course { program, mesh, clocks, steady, method, substeps }, self.parameters, self.given)
    }

    /// The fewest steps whose halving moves the outputs by less than the tolerance.
    fn refine(&self, method: Method, most: usize) -> Result<Plan> {
        let mut coarse = self.run(method, 1)?;
        let mut best = Plan { method, substeps: 1, error: f64::INFINITY, roughness: coarse.roughness };
        let (mut substeps, mut last) = (1, f64::INFINITY);
        while substeps < most {
            let fine = self.run(method, 2 * substeps)?;
            let error = difference(&coarse, &fine);
            if error < best.error {
                best = Plan { method, substeps, error, roughness: coarse.roughness };
            }
            if error <= self.tolerance || (fine.blew_up.is_some() && coarse.blew_up.is_some() && substeps > 2)
            {
                break;
            }
            let next = error / 16.0;
            if last / error > ASYMPTOTIC && next <= self.tolerance {
                return Ok(Plan { method, substeps: 2 * substeps, error: next, roughness: fine.roughness });
            }
            (coarse, last) = (fine, error);
            substeps *= 2;
        }
        Ok(best)
    }
}

/// The largest root-mean-square difference of an output, as a share of its spread.
fn difference(a: &Ran<f64>, b: &Ran<f64>) -> f64 {
    if a.blew_up.is_some() != b.blew_up.is_some() {
        return f64::INFINITY;
    }
    let shares = a.values.iter().zip(&b.values).map(|(a, b)| share(a, b));
    shares.fold(0.0, f64::max)
}

fn share(a: &[f64], b: &[f64]) -> f64 {
    let pairs = || a.iter().zip(b).filter(|(x, y)| x.is_finite() && y.is_finite());
    let count = pairs().count().max(1) as f64;
    let mean = pairs().map(|(x, _)| x).sum::<f64>() / count;
    let spread = (pairs().map(|(x, _)| (x - mean).powi(2)).sum::<f64>() / count).sqrt();
    let moved = (pairs().map(|(x, y)| (x - y).powi(2)).sum::<f64>() / count).sqrt();
    // A constant output is compared with its size.
    let scale = if spread > 1e-9 * mean.abs() { spread } else { mean.abs() };
    if moved == 0.0 { 0.0 } else { moved / scale }
}
