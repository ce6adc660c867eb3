//! # Purpose
//! A run that is repeated until its steps do for the parameters that it is made at.
//!
//! # Method
//! The plan was made at the model's own parameters. Where a run blows up, or the roughness of its steps
//! foretells too large an error, it is repeated with more steps of the same method until two of them agree,
//! then with the stiff one: with the steps that do at the model's own parameters, sought once, where the roughness
//! of the run says that they do here, else with steps that are sought here. All together may spend what one
//! simulation may; one that asks for more ends with the reason.

use super::course::Course;
use super::plan::{self, Plan, Search};
use super::request::{Case, Unknown};
use super::run::{Ran, run};
use super::simulator::Simulator;
use super::steps::Solver;
use super::{static_run, stiff};
use crate::Result;
use crate::model::Scalar;

/// How much larger than planned a foretold error may be before a run is repeated with more steps.
const SLACK: f64 = 4.0;
/// How many times more steps than planned are tried before the stiff method.
const MOST_FINER: usize = 16;

impl Simulator {
    /// Runs, and gives the plan that did.
    ///
    /// # Errors
    /// No start; a time limit that is up; more steps than one simulation may spend.
    pub(super) fn ran<T: Scalar>(&self, case: &Case<'_>) -> Result<(Ran<T>, Plan)> {
        let direction =
            |unknown: Unknown| case.unknowns.iter().position(|u| *u == unknown).unwrap_or(usize::MAX);
        let known = |k: usize| self.constants.iter().any(|c| c.0 == k);
        let parameter = |(k, p): (usize, &f64)| {
            let d = if known(k) { usize::MAX } else { direction(Unknown::Parameter(k)) };
            T::variable(*p, d)
        };
        let parameters: Vec<T> = case.parameters.iter().enumerate().map(parameter).collect();
        if !self.is_dynamic() {
            let values = static_run::run(&self.program, &self.samples, case.clocks, &parameters);
            return Ok((Ran::of_none(values), self.plan));
        }
        let (starts, steady) = self.starts(case.initials);
        let given: Vec<T> =
            starts.iter().enumerate().map(|(i, x)| T::variable(*x, direction(Unknown::Initial(i)))).collect();
        let mesh = self.mesh_at(&case.parameters);
        let allowance = self.budget.one_run();
        // another clock would measure another error
        let is_own = std::ptr::eq(case.clocks, self.clocks.as_slice());
        let did = is_own.then(|| self.did.at(case)).flatten();
        let mut plan = did.unwrap_or(self.plan);
        let mut last: Option<(Ran<T>, Solver)> = None;
        loop {
            let course = Course { clocks: case.clocks, ..self.course(&mesh, plan, &steady, &allowance) };
            let ran = run(&course, &parameters, &given)?;
            if ran.is_cut {
                return Err(stiff::too_long(self, &mesh, (&case.parameters, case.initials)));
            }
            if let Some((coarser, method)) = &last
                && *method == plan.method
            {
                plan.error = ran.difference(case.clocks, coarser);
                plan.roughness = ran.roughness;
            }
            if did.is_some() {
                return Ok((ran, plan));
            }
            let Some(next) = self.better(&course, plan, &ran, (&case.parameters, &starts))? else {
                if is_own {
                    self.did.remember(case, plan);
                }
                return Ok((ran, plan));
            };
            last = Some((ran, plan.method));
            plan = next;
        }
    }

    /// The plan to repeat a run with, if it blew up or its error is foretold to be too large.
    fn better<T>(
        &self,
        course: &Course<'_>,
        plan: Plan,
        ran: &Ran<T>,
        (parameters, given): (&[f64], &[f64]),
    ) -> Result<Option<Plan>> {
        let excess = plan.foretold(ran.roughness) / (SLACK * self.tolerance.max(self.plan.error));
        let blew_up = ran.blew_up.is_some();
        let was_sought = plan.method == Solver::Stiff && self.plan.method != Solver::Stiff;
        if was_sought || self.plan.error.is_nan() || !(blew_up || excess > 1.0) {
            return Ok(None);
        }
        if plan.method == Solver::Heun {
            return Ok(self.careful);
        }
        let finer = plan.finer(excess.powf(0.25));
        let most = plan::most_substeps(plan.method, course.mesh.intervals());
        if !blew_up && finer.substeps <= most.min(MOST_FINER * self.plan.substeps) {
            return Ok(Some(finer));
        }
        if plan.method == Solver::Stiff {
            return Ok(None);
        }
        let search = Search { course, parameters, given, tolerance: self.tolerance };
        match self.own_stiff() {
            Some(own) => search.stiff_from(own),
            None => search.stiff_if_it_converges(),
        }
    }

    /// The steps of the stiff method that do at the model's own parameters; none where it does not converge there.
    fn own_stiff(&self) -> Option<Plan> {
        *self.did.own_stiff.get_or_init(|| {
            let parameters = self.parameters();
            let mesh = self.mesh_at(&parameters);
            let (given, steady) = self.starts(&self.initials());
            let allowance = self.budget.one_run();
            let course = self.course(&mesh, self.plan, &steady, &allowance);
            let tolerance = self.tolerance;
            let search = Search { course: &course, parameters: &parameters, given: &given, tolerance };
            let converges = search.stiff_if_it_converges().ok().flatten();
            converges.filter(|p| p.error <= tolerance && !p.blew_up)
        })
    }
}
