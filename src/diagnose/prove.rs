//! The proof: the model before and after on what was held out.
//!
//! # Purpose
//! Show by how much the findings lower the free-run error where nothing was fitted, with an interval.
//!
//! # Method
//! Both models run over the held-out part in the same way. In a table of trials without given spans one
//! level of each input with three or more levels is left out in turn, both models are refitted without
//! it, and what is left out is pooled. The interval is a paired block bootstrap.
//!
//! # References
//! H. R. Künsch, Annals of Statistics 17 (1989) 1217.

use super::bench::{self, Bench, Stand};
use crate::Result;
use crate::estimate::fit::{Effort, Series, holdout};
use crate::estimate::noise::NoiseModel;
use crate::estimate::{Fit, fit, improvement};
use crate::model::Model;
use crate::record::Recording;

/// Levels of one input that are left out at most.
const LEVELS: usize = 12;

/// Residuals of one output over the held-out part, stretch by stretch.
#[derive(Debug, Clone, Default)]
pub struct Held {
    /// Residuals, SI.
    pub residual: Vec<Vec<f64>>,
    /// Their times, s or row numbers.
    pub time: Vec<Vec<f64>>,
}

impl Held {
    /// Root mean square.
    pub fn rmse(&self) -> f64 {
        let n: usize = self.residual.iter().map(Vec::len).sum();
        (self.residual.iter().flatten().map(|e| e * e).sum::<f64>() / n as f64).sqrt()
    }

    /// Innovations of the same by a noise model.
    #[must_use]
    pub fn whitened(&self, noise: &NoiseModel) -> Self {
        Self { residual: self.residual.iter().map(|r| noise.whiten(r)).collect(), time: Vec::new() }
    }

    fn views(&self) -> Vec<&[f64]> {
        self.residual.iter().map(Vec::as_slice).collect()
    }

    /// Fall of the root mean square from these residuals to others, with its interval (low, high).
    pub fn fall(&self, after: &Self, seed: u64) -> (f64, f64) {
        let i = improvement(&self.views(), &after.views(), seed);
        (i.low, i.high)
    }
}

/// Runs a fitted model over what was held out: one entry an output of the model.
///
/// # Errors
/// Where the model cannot be run there.
pub fn held_out(bench: &Bench, fitted: &Fit, separate: &[Recording]) -> Result<Vec<Held>> {
    let by_levels =
        bench.is_trials() && separate.is_empty() && bench.recordings.iter().all(|r| !r.spans.given);
    if by_levels {
        return left_levels(bench, fitted);
    }
    let options = bench.options(Effort::Near, 40);
    let found = holdout(fitted, &bench.recordings, separate, &options)?;
    let mut all = vec![Held::default(); fitted.model.outputs.len()];
    for h in &found {
        for s in &h.series {
            add(&mut all[h.output], s);
        }
    }
    Ok(all)
}

fn add(held: &mut Held, s: &Series) {
    for r in &s.stretches {
        held.residual.push(s.residual[r.clone()].to_vec());
        held.time.push(s.time[r.clone()].to_vec());
    }
}

/// Rows to be left out together: all of one level of one input.
fn folds(model: &Model, recording: &Recording) -> Vec<Vec<bool>> {
    let mut folds = Vec::new();
    for input in model.inputs.iter().filter_map(|i| recording.find(&i.name)) {
        let levels = input.levels();
        if levels.len() < 3 {
            continue;
        }
        let groups = levels.len().min(LEVELS);
        let group_of = |v: f64| levels.partition_point(|l| *l < v) * groups / levels.len();
        for g in 0..groups {
            folds.push(input.values.iter().map(|v| group_of(*v) == g).collect());
        }
    }
    folds
}

fn left_levels(bench: &Bench, fitted: &Fit) -> Result<Vec<Held>> {
    let model = &fitted.model;
    let mut all = vec![Held::default(); model.outputs.len()];
    let whole = bench.ready(model, bench.tolerance)?;
    for (k, recording) in bench.recordings.iter().enumerate() {
        for fold in folds(model, recording) {
            let mut rest = bench.recordings.clone();
            for c in rest[k].channels.iter_mut().filter(|c| model.outputs.iter().any(|o| o.name == c.name)) {
                c.values.iter_mut().zip(&fold).filter(|(_, out)| **out).for_each(|(v, _)| *v = f64::NAN);
            }
            let Ok(f) = fit(model, &rest, &bench.options(Effort::Near, 10)) else { continue };
            let tracks = bench::run(&whole, &Stand::of(&f), &[])?;
            for t in &tracks {
                let rows = t.time.iter().zip(&t.residual);
                let out = rows.filter(|(row, _)| fold.get(**row as usize).copied().unwrap_or(false));
                let (time, residual): (Vec<f64>, Vec<f64>) = out.map(|(t, e)| (*t, *e)).unzip();
                all[t.output].residual.push(residual);
                all[t.output].time.push(time);
            }
        }
    }
    Ok(all)
}
