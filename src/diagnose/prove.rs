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
use super::moments;
use super::search::Found;
use crate::Result;
use crate::estimate::fit::{Effort, Series, holdout};
use crate::estimate::noise::NoiseModel;
use crate::estimate::{Fit, fit, improvement};
use crate::model::{Model, Output};
use crate::record::Recording;

/// Levels of one input that are left out at most.
const LEVELS: usize = 12;

/// Spreads of an output from which on a run that lies so far off has blown up.
const BLOWN_UP: f64 = 100.0;

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
        (self.residual.iter().flatten().map(|e| e * e).sum::<f64>() / self.samples() as f64).sqrt()
    }

    /// Innovations of the same by a noise model.
    #[must_use]
    pub fn whitened(&self, noise: &NoiseModel) -> Self {
        Self { residual: self.residual.iter().map(|r| noise.whiten(r)).collect(), time: Vec::new() }
    }

    /// Mean square by the differences of neighbours (J. von Neumann, Ann. Math. Statist. 12 (1941) 367): what a law leaves that
    /// does not carry over goes on from sample to sample, and is no noise. None of no samples.
    pub fn loudness(&self) -> Option<f64> {
        let neighbours = || self.residual.iter().flat_map(|r| r.windows(2));
        let count = neighbours().count();
        // E (e₂ − e₁)² = 2σ²
        (count > 0).then(|| neighbours().map(|e| 0.5 * (e[1] - e[0]).powi(2)).sum::<f64>() / count as f64)
    }

    /// How many there are.
    pub fn samples(&self) -> usize {
        self.residual.iter().map(Vec::len).sum()
    }

    fn views(&self) -> Vec<&[f64]> {
        self.residual.iter().map(Vec::as_slice).collect()
    }

    /// Whether the model ran through to the end.
    pub fn is_finite(&self) -> bool {
        self.residual.iter().flatten().all(|e| e.is_finite())
    }

    /// The same of a model that did not run through.
    fn blown_up(&self) -> Self {
        let lost = |r: &Vec<f64>| vec![f64::NAN; r.len()];
        Self { residual: self.residual.iter().map(lost).collect(), time: self.time.clone() }
    }

    /// Fall of the root mean square from these residuals to others, with its interval (low, high); NaN where
    /// one of the models did not run through.
    pub fn fall(&self, after: &Self, seed: u64) -> (f64, f64) {
        if !(self.is_finite() && after.is_finite()) {
            return (f64::NAN, f64::NAN);
        }
        let i = improvement(&self.views(), &after.views(), seed);
        (i.low, i.high)
    }
}

/// Runs the model as given and the last one over what was held out, each with no number where it cannot be.
pub fn both(bench: &Bench, found: &Found, separate: &[Recording]) -> (Vec<Held>, Vec<Held>) {
    let of = |fit: &Fit| held_out(bench, fit, separate).ok();
    let last = || (!found.taken.is_empty()).then(|| of(&found.last));
    let (before, after) = rayon::join(|| of(&found.base), last);
    let after = after.unwrap_or_else(|| before.clone());
    let blown_up = |other: &[Held]| other.iter().map(Held::blown_up).collect();
    match (before, after) {
        (Some(before), Some(after)) => (before, after),
        (Some(before), None) => (before.clone(), blown_up(&before)),
        (None, Some(after)) => (blown_up(&after), after),
        (None, None) => {
            let none = Held { residual: vec![vec![f64::NAN]], time: vec![vec![f64::NAN]] };
            let none = vec![none; found.base.model.outputs.len()];
            (none.clone(), none)
        }
    }
}

/// Whether a fitted model runs through what is held out without leaving the outputs' neighbourhood; of
/// levels left out in turn it was fitted to all.
pub fn runs(bench: &Bench, fitted: &Fit, separate: &[Recording]) -> bool {
    let stays = |(h, o): (&Held, &Output)| {
        let far = BLOWN_UP * bench.spread(&o.name);
        h.is_finite() && !(far > 0.0 && h.residual.iter().flatten().any(|e| e.abs() > far))
    };
    let all_stay = |held: Vec<Held>| held.iter().zip(&fitted.model.outputs).all(stays);
    leaves_levels_out(bench, separate) || held_out(bench, fitted, separate).is_ok_and(all_stay)
}

/// Whether levels of trials are left out in turn, for want of anything that is held out.
pub fn leaves_levels_out(bench: &Bench, separate: &[Recording]) -> bool {
    bench.is_trials() && separate.is_empty() && bench.recordings.iter().all(|r| !r.spans.given)
}

/// Runs a fitted model over what was held out: one entry an output of the model.
///
/// # Errors
/// Where the model cannot be run there.
pub fn held_out(bench: &Bench, fitted: &Fit, separate: &[Recording]) -> Result<Vec<Held>> {
    if leaves_levels_out(bench, separate) {
        return left_levels(bench, fitted);
    }
    let options = bench.options(Effort::Near, 40);
    let found = holdout(&moments::placed(bench, fitted, separate), &bench.recordings, separate, &options)?;
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
    let whole = bench.ready(model, fitted.starts(), (bench.tolerance, Vec::new()))?;
    for (k, recording) in bench.recordings.iter().enumerate() {
        for fold in folds(model, recording) {
            let mut rest = bench.recordings.clone();
            for c in rest[k].channels.iter_mut().filter(|c| model.outputs.iter().any(|o| o.name == c.name)) {
                c.values.iter_mut().zip(&fold).filter(|(_, out)| **out).for_each(|(v, _)| *v = f64::NAN);
            }
            let fitted = fit(model, &rest, &bench.options(Effort::Near, 10));
            let own = &whole[k..=k];
            let tracks = fitted.and_then(|f| bench::run(own, &Stand::of(&f), &[])).ok();
            for (i, t) in own[0].tracks.iter().enumerate() {
                let left = |row: usize| tracks.as_ref().map_or(f64::NAN, |t| t[i].residual[row]);
                let is_out = |row: &usize| fold.get(t.time[*row] as usize).copied().unwrap_or(false);
                let rows: Vec<usize> = (0..t.time.len()).filter(is_out).collect();
                all[t.output].residual.push(rows.iter().map(|r| left(*r)).collect());
                all[t.output].time.push(rows.iter().map(|r| t.time[*r]).collect());
            }
        }
    }
    Ok(all)
}
