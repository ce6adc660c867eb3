//! The search for the best minimum.
//!
//! # Purpose
//! Free-run fits have side minima: dry friction of the wrong sign, a period too many. One walk from
//! one start is not trusted.
//!
//! # Method
//! Walks from the given values and from the equation-error estimate; where the two end in the same
//! minimum that is it. Else multiple shooting, from many short segments to one long run, and starts
//! drawn about the best so far, until two walks agree on the best. Where the best hardly holds a parameter,
//! as at a bound that walks have slid to off the far side of a ridge, that parameter is held at places over its range
//! while all else follows, and a last walk begins at the lowest of them.
//!
//! # References
//! H. G. Bock, Recent advances in parameter identification for ODEs, Birkhäuser 1983 (multiple
//! shooting); A. H. G. Rinnooy Kan, G. T. Timmer, Mathematical Programming 39 (1987) 27-56.
//!
//! # Numerical aspects
//! Drawn starts come from a seeded generator; the best of equal minima is the first found.

use super::equation_error::equation_error;
use super::options::{Effort, FitOptions};
use super::outcome::Warning;
use super::problem::FreeRun;
use super::shooting::shoot;
use crate::estimate::coordinates::Range;
use crate::estimate::least_squares::{Minimum, Problem, Stopping, minimise};
use crate::model::Model;
use crate::record::Recording;
use crate::{Error, Result};
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Two sums of squares this near to each other, relatively, are one minimum.
const SAME: f64 = 1e-3;

/// Relative rise of a sum by which the doubling of a parameter tells nothing of its place.
const LOOSE: f64 = 0.01;
/// Rise of a sum, over the variance of white noise, that chance may bring.
const CHANCE: f64 = 10.0;
/// Places of its range at which a parameter is held.
const PLACES: usize = 6;
/// Factor from a value to the end of a range that has none.
const FAR: f64 = 1e2;

/// A short walk, the parameter held.
const HOLDING: Stopping = Stopping { iterations: 8, reduction: 1e-3, step: 1e-4 };

/// A search and what it has found so far.
pub struct Search<'a> {
    model: &'a Model,
    recordings: &'a [Recording],
    options: &'a FitOptions<'a>,
    problem: &'a FreeRun<'a>,
    ranges: &'a [Range],
    found: Vec<Minimum>,
    failure: Option<Error>,
    simulations: usize,
    warnings: Vec<Warning>,
}

/// What a search ends with.
pub struct Found {
    /// The best minimum.
    pub minimum: Minimum,
    /// Simulations done.
    pub simulations: usize,
    /// What a user should know.
    pub warnings: Vec<Warning>,
}

impl<'a> Search<'a> {
    /// A search over a problem.
    pub fn new(
        model: &'a Model,
        recordings: &'a [Recording],
        options: &'a FitOptions<'a>,
        problem: &'a FreeRun<'a>,
        ranges: &'a [Range],
    ) -> Self {
        Self {
            model,
            recordings,
            options,
            problem,
            ranges,
            found: Vec::new(),
            failure: None,
            simulations: 0,
            warnings: Vec::new(),
        }
    }

    /// Searches from x.
    ///
    /// # Errors
    /// Where no start at all can be simulated.
    pub fn run(mut self, given: &[f64]) -> Result<Found> {
        self.walk("from the given values", given);
        if self.found.is_empty() {
            self.warnings.push(Warning {
                message: "from the values given in the model file the simulation does not stay finite; \
                       the fit began elsewhere: give values nearer to the instrument's"
                    .into(),
            });
        }
        if self.options.effort == Effort::Full && self.problem.unknowns() > 0 {
            self.search(given);
            self.look_along_loose(given);
        }
        self.finish()
    }

    fn search(&mut self, given: &[f64]) {
        let has_states = !self.model.states.is_empty();
        if let Some(values) = equation_error(self.model, self.recordings, self.options) {
            self.walk("from the equation error", &self.with_parameters(given, &values));
        }
        if self.is_done() {
            return;
        }
        if has_states {
            let near = self.best().map_or(given.to_vec(), |m| m.x.clone());
            let mut bases = vec![given.to_vec(), near];
            bases.dedup();
            for base in bases {
                if let Some(values) = shoot(self.model, self.recordings, self.options, &self.all(&base)) {
                    self.walk("from multiple shooting", &self.with_parameters(given, &values));
                }
                if self.is_done() {
                    return;
                }
            }
        }
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(self.options.seed);
        for _ in 0..self.options.drawn_starts {
            let near = self.best().map_or(given.to_vec(), |m| m.x.clone());
            let drawn = self.draw(&near, given, &mut rng);
            self.walk("from drawn values", &drawn);
            if self.is_done() {
                return;
            }
        }
    }

    /// A walk from the lowest place in the range of each parameter that the best minimum hardly holds.
    fn look_along_loose(&mut self, given: &[f64]) -> Option<()> {
        let best = self.best()?.clone();
        for j in self.loose(&best) {
            if self.options.budget.over().is_some() {
                return None;
            }
            let x = if best.x[j] > 0.0 { best.x[j] } else { given[j] };
            let held = self.places(j, x).into_iter().filter_map(|x| self.held(&best, j, x));
            let lowest = held.min_by(|a, b| a.sum_of_squares.total_cmp(&b.sum_of_squares));
            if let Some(lowest) = lowest.filter(|l| l.sum_of_squares < best.sum_of_squares) {
                self.walk("from along its range", &lowest.x);
            }
        }
        Some(())
    }

    /// Parameters of one sign that may double while the sum, all else following, hardly rises.
    fn loose(&self, best: &Minimum) -> Vec<usize> {
        let Ok(triangle) = self.problem.linearise(&best.x) else { return Vec::new() };
        let others = |j: usize| (0..best.x.len()).filter(|k| *k != j).collect::<Vec<_>>();
        let doubled = |j: usize| {
            let mut step = vec![0.0; best.x.len()];
            step[j] = best.x[j];
            triangle.restricted(&others(j), &step).least_sum()
        };
        let hardly = LOOSE.max(CHANCE / triangle.rows().max(1) as f64) * best.sum_of_squares;
        let is_loose = |j: &usize| self.ranges[*j].min >= 0.0 && doubled(*j) - triangle.least_sum() < hardly;
        (0..self.problem.free.len()).filter(is_loose).collect()
    }

    /// Values over the range of a parameter of one sign, by equal factors.
    fn places(&self, j: usize, x: f64) -> Vec<f64> {
        let Range { min, max } = self.ranges[j];
        let low = if min > 0.0 { min } else { x / FAR };
        let high = if max.is_finite() { max } else { x * FAR };
        let place = |k: usize| low * (high / low).powf(k as f64 / (PLACES + 1) as f64);
        (1..=PLACES).map(place).filter(|x| x.is_finite() && *x > min && *x < max).collect()
    }

    /// The minimum with one parameter held.
    fn held(&self, best: &Minimum, j: usize, x: f64) -> Option<Minimum> {
        let mut ranges = self.ranges.to_vec();
        ranges[j] = Range { min: x, max: x };
        let mut start = best.x.clone();
        start[j] = x;
        minimise(self.problem, &start, &ranges, HOLDING).ok()
    }

    /// All parameters of the model at x.
    fn all(&self, x: &[f64]) -> Vec<f64> {
        self.problem.spread(x).0
    }

    /// x with its free parameters taken from a full list.
    fn with_parameters(&self, x: &[f64], parameters: &[f64]) -> Vec<f64> {
        let mut own = x.to_vec();
        for (at, k) in self.problem.free.iter().enumerate() {
            own[at] = parameters[*k];
        }
        own
    }

    fn walk(&mut self, stage: &str, start: &[f64]) {
        self.options.progress.report(&format!("fitting {stage}"), None);
        self.problem.begin_walk();
        match minimise(self.problem, start, self.ranges, self.options.stopping) {
            Ok(minimum) => {
                self.simulations += minimum.evaluations;
                self.found.push(minimum);
            }
            Err(e) => {
                self.failure.get_or_insert(e);
            }
        }
    }

    fn best(&self) -> Option<&Minimum> {
        self.found.iter().min_by(|a, b| a.sum_of_squares.total_cmp(&b.sum_of_squares))
    }

    /// Whether no further walk is worth while, or allowed.
    fn is_done(&self) -> bool {
        self.agreed() || self.options.budget.over().is_some()
    }

    /// Whether two walks ended in the best minimum, and at least one of them came there from elsewhere:
    /// where an output is clipped throughout, say, no walk moves at all.
    fn agreed(&self) -> bool {
        let Some(best) = self.best() else { return false };
        let near = |m: &&Minimum| m.sum_of_squares <= best.sum_of_squares * (1.0 + SAME);
        let moved = |m: &Minimum| m.start_sum_of_squares > m.sum_of_squares * (1.0 + SAME);
        let there: Vec<&Minimum> = self.found.iter().filter(near).collect();
        there.len() > 1 && there.into_iter().any(moved)
    }

    /// Parameters drawn about x, or about the given values where x is 0: factors for those of one sign,
    /// shifts by their size for the others.
    fn draw(&self, x: &[f64], given: &[f64], rng: &mut rand_chacha::ChaCha8Rng) -> Vec<f64> {
        let mut drawn = x.to_vec();
        for at in 0..self.problem.free.len() {
            let z: f64 = StandardNormal.sample(rng);
            let range = self.ranges[at];
            let x = if x[at] == 0.0 { given[at] } else { x[at] };
            drawn[at] = if range.min >= 0.0 && x > 0.0 { x * z.exp() } else { x * (1.0 + z) };
            drawn[at] = range.clamp(drawn[at]);
        }
        drawn
    }

    fn finish(mut self) -> Result<Found> {
        let best = self.best().cloned();
        let Some(minimum) = best else {
            return Err(self
                .failure
                .take()
                .unwrap_or_else(|| Error::not_computed("nothing could be fitted")));
        };
        Ok(Found { minimum, simulations: self.simulations, warnings: self.warnings })
    }
}
