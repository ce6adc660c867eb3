//! # Purpose
//! How far A, μ and ε of a fitted roll can be trusted.
//!
//! # Method
//! Delete-one-block jackknife: the recording is cut into ten blocks, each is left out in turn,
//! and the correlation function fitted anew. On logarithms, with θ̂ of all and θ̂₋ⱼ without block j,
//! the pseudo-values θ̃ⱼ = B θ̂ − (B − 1) θ̂₋ⱼ have a mean that is free of the bias in 1/length
//! and give a 95 % interval by Student's t.
//!
//! # References
//! H. R. Künsch, The jackknife and the bootstrap for general stationary observations, Annals of
//! Statistics 17 (1989) 1217–1241.
//!
//! # Numerical aspects
//! The products of each block are summed once; leaving a block out is a subtraction.

use super::correlation::fit_from;
use super::{CorrelationFit, Interval, Roll};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, StudentsT};

const BLOCKS: usize = 10;

/// The three numbers of a roll freed of their bias, with their intervals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollIntervals {
    /// A, rad².
    pub variance: Interval,
    /// μ, 1/s; `None` when it is not known within a factor of ten.
    pub decay: Option<Interval>,
    /// ε, rad/s.
    pub frequency: Interval,
}

/// The intervals of `fit`, which was fitted to the correlation function of `values`; `None` when
/// the blocks are shorter than three periods of roll or some block leaves no fit.
pub fn roll_intervals(values: &[f64], fit: &CorrelationFit) -> Option<RollIntervals> {
    let block = values.len() / BLOCKS;
    let period = std::f64::consts::TAU / fit.roll.frequency / fit.step;
    if (block as f64) < 3.0 * period {
        return None;
    }
    let parts = block_products(values, fit.measured.len(), block);
    let fits: Option<Vec<Roll>> = (0..BLOCKS)
        .into_par_iter()
        .map(|left_out| {
            let count: f64 = (0..BLOCKS).filter(|j| *j != left_out).map(|j| parts[j].1).sum();
            let rest: Vec<f64> = (0..fit.measured.len())
                .map(|k| (0..BLOCKS).filter(|j| *j != left_out).map(|j| parts[j].0[k]).sum::<f64>() / count)
                .collect();
            let start = std::iter::once((fit.roll.decay, fit.roll.frequency));
            fit_from(&rest, (fit.step, fit.slow), start).ok().map(|f| f.roll)
        })
        .collect();
    let fits = fits?;
    let one = |of: fn(&Roll) -> f64| pseudo(of(&fit.roll), fits.iter().map(of));
    Some(RollIntervals {
        variance: one(|r| r.variance)?,
        decay: one(|r| r.decay).filter(|i| i.high < 10.0 * i.value),
        frequency: one(|r| r.frequency)?,
    })
}

/// Σ xᵢ xᵢ₊ₖ over the i of each block, and how many xᵢ it knows.
fn block_products(values: &[f64], lags: usize, block: usize) -> Vec<(Vec<f64>, f64)> {
    let known: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let x: Vec<f64> = values.iter().map(|v| if v.is_finite() { v - mean } else { 0.0 }).collect();
    (0..BLOCKS)
        .into_par_iter()
        .map(|j| {
            let end = if j + 1 == BLOCKS { x.len() } else { (j + 1) * block };
            let range = j * block..end;
            let sums = (0..lags).map(|k| {
                let to = range.end.min(x.len() - k.min(x.len()));
                (range.start..to).map(|i| x[i] * x[i + k]).sum::<f64>()
            });
            let count = values[range.clone()].iter().filter(|v| v.is_finite()).count();
            (sums.collect(), count as f64)
        })
        .collect()
}

fn pseudo(all: f64, without: impl Iterator<Item = f64>) -> Option<Interval> {
    let b = BLOCKS as f64;
    // θ̃ⱼ = B θ̂ − (B − 1) θ̂₋ⱼ
    let values: Vec<f64> = without.map(|w| b * all.ln() - (b - 1.0) * w.ln()).collect();
    let mean = values.iter().sum::<f64>() / b;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (b - 1.0);
    let t = StudentsT::new(0.0, 1.0, b - 1.0).ok()?.inverse_cdf(0.975);
    let margin = t * (variance / b).sqrt();
    let interval = Interval { value: mean.exp(), low: (mean - margin).exp(), high: (mean + margin).exp() };
    [interval.low, interval.high].iter().all(|v| v.is_finite()).then_some(interval)
}
