//! The free-run fit as a least-squares problem.
//!
//! # Purpose
//! Shared parameters and each recording's initial states as one vector of unknowns; residuals of all
//! outputs of all recordings, weighed, as rows.
//!
//! # Method
//! x = (free parameters, free initial states of recording 1, of recording 2, …). A row is
//! √w (predicted − measured) with its sensitivities; under whitening both pass the noise filter of
//! their output, stretch by stretch.
//!
//! # Numerical aspects
//! Recordings run on all cores; their triangles merge in a fixed order, so that the same bytes come
//! out whatever the number of threads.

use super::harness::{Record, Run, Track, Unknown};
use super::options::{Effort, FitOptions, Weighting};
use super::setup;
use crate::Result;
use crate::estimate::least_squares::Problem;
use crate::estimate::noise::NoiseModel;
use crate::estimate::triangle::Triangle;
use crate::model::Model;
use crate::simulate::Budget;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// The free-run fit of some records.
pub struct FreeRun<'a> {
    /// All parameters of the model; the free ones are replaced.
    pub parameters: Vec<f64>,
    /// Numbers of the free parameters.
    pub free: Vec<usize>,
    pub records: &'a [Record],
    /// Weight of the squared residuals of each output.
    pub weights: Vec<f64>,
    /// Frozen noise models, one an output, if residuals are whitened.
    pub whitening: Option<&'a [NoiseModel]>,
    /// What may be spent.
    pub budget: &'a Budget,
    /// One walk may spend one part in so many of it.
    pub walks: u64,
    /// Steps spent at which the present walk ends.
    pub walk_ends: AtomicU64,
}

/// What one record gives at some x.
pub struct Linear {
    /// The run, with sensitivities to `unknowns`.
    pub run: Run,
    /// For each sensitivity its place in x.
    pub places: Vec<usize>,
}

impl FreeRun<'_> {
    /// The full parameters and, by record, the full initial states at x.
    pub fn spread(&self, x: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        let mut parameters = self.parameters.clone();
        for (k, value) in self.free.iter().zip(x) {
            parameters[*k] = *value;
        }
        let mut at = self.free.len();
        let initials = self
            .records
            .iter()
            .map(|r| {
                let mut own = r.initials.clone();
                for s in &r.free_initials {
                    own[*s] = x[at];
                    at += 1;
                }
                own
            })
            .collect();
        (parameters, initials)
    }

    /// The place in x of the first free initial state of each record.
    fn offsets(&self) -> Vec<usize> {
        let mut at = self.free.len();
        self.records
            .iter()
            .map(|r| {
                let here = at;
                at += r.free_initials.len();
                here
            })
            .collect()
    }

    /// One record's unknowns and their places in x.
    fn unknowns_of(&self, record: &Record, offset: usize) -> (Vec<Unknown>, Vec<usize>) {
        let shared = self.free.iter().enumerate().filter(|(_, k)| !record.knows(**k));
        let own = record.free_initials.iter().enumerate();
        shared
            .map(|(at, k)| (Unknown::Parameter(*k), at))
            .chain(own.map(|(i, s)| (Unknown::Initial(*s), offset + i)))
            .unzip()
    }

    /// Runs all records at x with sensitivities.
    pub fn linear(&self, x: &[f64]) -> Result<Vec<Linear>> {
        let (parameters, initials) = self.spread(x);
        let offsets = self.offsets();
        (0..self.records.len())
            .into_par_iter()
            .map(|i| {
                let (wanted, places) = self.unknowns_of(&self.records[i], offsets[i]);
                let run = self.records[i].run(&parameters, &initials[i], &wanted)?;
                Ok(Linear { run, places })
            })
            .collect()
    }

    /// Grants the next walk its share of the steps.
    pub fn begin_walk(&self) {
        let ends = self.budget.spent().saturating_add(self.budget.most() / self.walks);
        self.walk_ends.store(ends, Ordering::Relaxed);
    }

    /// The mean square of each output's residual at x.
    pub fn mean_squares(&self, x: &[f64]) -> Result<Vec<f64>> {
        let (parameters, initials) = self.spread(x);
        let mut sums = vec![(0.0, 0_usize); self.weights.len()];
        for (record, initials) in self.records.iter().zip(&initials) {
            let run = record.run(&parameters, initials, &[])?;
            for (track, predicted) in record.tracks.iter().zip(&run.predictions) {
                let sum = &mut sums[track.output];
                sum.0 += track.residual(predicted).iter().map(|e| e * e).sum::<f64>();
                sum.1 += track.time.len();
            }
        }
        Ok(sums.iter().map(|(sum, count)| sum / (*count).max(1) as f64).collect())
    }

    /// Σ w e² of one track, whitened where asked for.
    fn sum(&self, track: &Track, residual: &[f64]) -> f64 {
        let weight = self.weights[track.output];
        match self.whitening {
            None => weight * residual.iter().map(|e| e * e).sum::<f64>(),
            Some(noise) => track
                .stretches
                .iter()
                .flat_map(|s| noise[track.output].whiten(&residual[s.clone()]))
                .map(|e| e * e)
                .sum(),
        }
    }

    /// The triangle of one record over all unknowns.
    fn triangle(&self, record: &Record, linear: &Linear) -> Triangle {
        let p = self.unknowns();
        let mut triangle = Triangle::new(p);
        for (k, track) in record.tracks.iter().enumerate() {
            let minus: Vec<f64> = track.residual(&linear.run.predictions[k]).iter().map(|e| -e).collect();
            for stretch in &track.stretches {
                let filtered = |v: &[f64]| -> Vec<f64> {
                    match self.whitening {
                        None => {
                            let root = self.weights[track.output].sqrt();
                            v[stretch.clone()].iter().map(|e| root * e).collect()
                        }
                        Some(noise) => noise[track.output].whiten(&v[stretch.clone()]),
                    }
                };
                let residual = filtered(&minus);
                let columns: Vec<Vec<f64>> =
                    linear.run.sensitivities[k].iter().map(|c| filtered(c)).collect();
                let zeros = vec![0.0; residual.len()];
                let mut views: Vec<&[f64]> = vec![&zeros; p];
                for (column, at) in columns.iter().zip(&linear.places) {
                    views[*at] = column;
                }
                triangle.push(&views, &residual);
            }
        }
        triangle
    }
}

impl Problem for FreeRun<'_> {
    fn is_over(&self) -> bool {
        self.budget.over().is_some() || self.budget.spent() >= self.walk_ends.load(Ordering::Relaxed)
    }

    fn unknowns(&self) -> usize {
        self.free.len() + self.records.iter().map(|r| r.free_initials.len()).sum::<usize>()
    }

    fn sum_of_squares(&self, x: &[f64]) -> Result<f64> {
        let (parameters, initials) = self.spread(x);
        let sums: Result<Vec<f64>> = (0..self.records.len())
            .into_par_iter()
            .map(|i| {
                let record = &self.records[i];
                let run = record.run(&parameters, &initials[i], &[])?;
                let tracks = record.tracks.iter().zip(&run.predictions);
                Ok(tracks.map(|(t, f)| self.sum(t, &t.residual(f))).sum())
            })
            .collect();
        Ok(sums?.iter().sum())
    }

    fn linearise(&self, x: &[f64]) -> Result<Triangle> {
        let linear = self.linear(x)?;
        let triangles: Vec<Triangle> =
            self.records.par_iter().zip(&linear).map(|(r, l)| self.triangle(r, l)).collect();
        let mut whole = Triangle::new(self.unknowns());
        for triangle in &triangles {
            whole.merge(triangle);
        }
        Ok(whole)
    }
}

/// The unknowns as the model file and the first guesses give them.
pub fn given(problem: &FreeRun<'_>) -> Vec<f64> {
    let parameters = problem.free.iter().map(|k| problem.parameters[*k]);
    let initials = problem.records.iter().flat_map(|r| r.free_initials.iter().map(|s| r.initials[*s]));
    parameters.chain(initials).collect()
}

/// In how many walks a fit may spend what it may: from several starts, or one and another with the outputs'
/// weights in balance, or one alone.
fn walks(model: &Model, options: &FitOptions<'_>) -> u64 {
    match options.effort {
        Effort::Full => 3,
        Effort::Near if model.outputs.len() > 1 => 2,
        Effort::Near => 1,
    }
}

/// A problem over some records with the weights of their signals.
pub fn problem<'a>(
    model: &Model,
    records: &'a [Record],
    parameters: Vec<f64>,
    options: &'a FitOptions<'_>,
) -> FreeRun<'a> {
    FreeRun {
        free: setup::free_parameters(model, records),
        parameters,
        records,
        weights: setup::signal_weights(model, records),
        whitening: match &options.weighting {
            Weighting::FreeRun => None,
            Weighting::Whitened(noise) => Some(noise),
        },
        budget: &options.budget,
        walks: walks(model, options),
        walk_ends: AtomicU64::new(u64::MAX),
    }
}
