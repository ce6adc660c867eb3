//! The noise of one output.
//!
//! # Purpose
//! One object that turns residuals and sensitivities of an output into rows of unit-variance white
//! noise, whatever the sampling: decimation, autoregression, gaps.
//!
//! # Method
//! Where the residual remembers far longer than a sample, block means shorten it first, as far as
//! they keep the sensitivities; an autoregression whitens the rest. Outliers are cut at four robust
//! deviations before the autoregression is estimated.
//!
//! # Numerical aspects
//! An autoregression of an over-sampled residual is nearly singular: its innovations hold only the
//! quantisation of the sensor, and the long memory is missed. The decimation keeps the roots away
//! from the unit circle.

use super::autoregression::Autoregression;
use super::scale::{block_means, correlation_time, robust_deviation};

/// Most of the information of a sensitivity that a block mean may lose.
const LOSS: f64 = 0.02;
/// The same where what is averaged away is no physics.
const LOSS_IN_BAND: f64 = 0.25;
/// The memory, in decimated samples, that the autoregression is left with.
const MEMORY: f64 = 12.0;
/// Highest order that is tried.
pub const MAX_ORDER: usize = 12;

/// Noise of one output: decimation and an autoregression of what is left.
#[derive(Debug, Clone, PartialEq)]
pub struct NoiseModel {
    /// Samples that are averaged into one.
    pub decimation: usize,
    /// The correlation after that.
    pub autoregression: Autoregression,
}

/// Rows of white noise of unit variance.
#[derive(Debug, Clone, PartialEq)]
pub struct Whitened {
    /// The innovations of the residual.
    pub residual: Vec<f64>,
    /// The sensitivities, filtered alike: one vector an unknown.
    pub columns: Vec<Vec<f64>>,
}

impl NoiseModel {
    /// White noise of a given variance.
    pub fn white(variance: f64) -> Self {
        Self { decimation: 1, autoregression: Autoregression::white(variance) }
    }

    /// Estimates the noise from residual stretches; `columns[j]` are the stretches of sensitivity j,
    /// which limit the decimation (none: the residual decides alone).
    pub fn estimate(stretches: &[&[f64]], columns: &[Vec<&[f64]>]) -> Self {
        Self::estimate_below(stretches, columns, 1)
    }

    /// The same where nothing is weighed above half the rate of one in `period` samples, as far as the sensitivities
    /// bear that.
    pub fn estimate_below(stretches: &[&[f64]], columns: &[Vec<&[f64]>], period: usize) -> Self {
        let clipped = clip(stretches);
        let views: Vec<&[f64]> = clipped.iter().map(Vec::as_slice).collect();
        let wanted = (correlation_time(&views) / MEMORY) as usize;
        let shortest_use = views.iter().map(|s| s.len()).sum::<usize>() / 200;
        let shortened = |wanted: usize, bearable: f64| {
            let mut m = wanted.min(shortest_use).max(1);
            while m > 1 && columns.iter().any(|c| loss(c, m) > bearable) {
                m = m * 2 / 3;
            }
            m
        };
        let decimation = shortened(wanted, LOSS).max(shortened(period, LOSS_IN_BAND)).max(1);
        let short: Vec<Vec<f64>> = views.iter().map(|s| block_means(s, decimation)).collect();
        let short: Vec<&[f64]> = short.iter().map(Vec::as_slice).collect();
        let count: usize = short.iter().map(|s| s.len()).sum();
        let mut autoregression = Autoregression::fit(&short, MAX_ORDER.min(count / 10));
        if autoregression.variance() <= 0.0 {
            autoregression = Autoregression::white(f64::MIN_POSITIVE.sqrt());
        }
        Self { decimation, autoregression }
    }

    /// The colour of residual stretches by the next sample alone, none averaged: it cannot hold a line of the spectrum.
    pub fn of_neighbours(stretches: &[&[f64]]) -> Self {
        let clipped = clip(stretches);
        let views: Vec<&[f64]> = clipped.iter().map(Vec::as_slice).collect();
        Self { decimation: 1, autoregression: Autoregression::burg(&views, 1) }
    }

    /// Innovations of one contiguous stretch.
    pub fn whiten(&self, stretch: &[f64]) -> Vec<f64> {
        self.autoregression.whiten(&block_means(stretch, self.decimation))
    }

    /// The adjoint of [`NoiseModel::whiten`] on a stretch of so many samples.
    pub fn whiten_adjoint(&self, innovations: &[f64], samples: usize) -> Vec<f64> {
        let m = self.decimation.max(1);
        let blocks = self.autoregression.whiten_adjoint(innovations);
        let mut out: Vec<f64> = blocks.iter().flat_map(|b| std::iter::repeat_n(b / m as f64, m)).collect();
        out.resize(samples, 0.0);
        out
    }

    /// Residual and sensitivities of one contiguous stretch, filtered alike.
    pub fn whiten_rows(&self, residual: &[f64], columns: &[&[f64]]) -> Whitened {
        Whitened {
            residual: self.whiten(residual),
            columns: columns.iter().map(|c| self.whiten(c)).collect(),
        }
    }

    /// For weights v on the samples of a stretch, a vector u with ‖u‖² = Var(v·noise).
    pub fn spread(&self, v: &[f64]) -> Vec<f64> {
        let m = self.decimation as f64;
        let sums: Vec<f64> = block_means(v, self.decimation).iter().map(|x| x * m).collect();
        self.autoregression.colour_adjoint(&sums)
    }
}

/// The residual with outliers cut at four robust deviations, unless most of it is exactly zero.
fn clip(stretches: &[&[f64]]) -> Vec<Vec<f64>> {
    let all: Vec<f64> = stretches.concat();
    let deviation = robust_deviation(&all);
    let limit = if deviation > 0.0 { 4.0 * deviation } else { f64::INFINITY };
    let mean = all.iter().sum::<f64>() / all.len().max(1) as f64;
    let reach = limit + mean.abs();
    stretches.iter().map(|s| s.iter().map(|y| y.clamp(-reach, reach)).collect()).collect()
}

/// The part of Σ c² that block means lose.
fn loss(column: &[&[f64]], factor: usize) -> f64 {
    let (mut kept, mut whole) = (0.0, 0.0);
    for stretch in column {
        let used = stretch.len() / factor * factor;
        whole += stretch[..used].iter().map(|c| c * c).sum::<f64>();
        kept += block_means(stretch, factor).iter().map(|c| c * c).sum::<f64>() * factor as f64;
    }
    if whole > 0.0 { 1.0 - kept / whole } else { 0.0 }
}
