//! Whether noise of the inputs could be what a model leaves.
//!
//! # Purpose
//! A model that is run by noisy inputs leaves what their noise does to it, which is no physics. Where that is too small,
//! something else drives the model.
//!
//! # Method
//! An input holds no more noise than what its own past does not foretell: the innovations of an autoregression. They are
//! added to it once more, reversed in time so that they are independent of what they stand beside, and the model is run.
//! An input of steps or of noise may hold as much as it is itself; then nothing is said. The noise is that between samples
//! as they were written: what is slower than these, or filled by lines, is taken for the input's own course.
//!
//! # References
//! T. Söderström, Errors-in-Variables Methods in System Identification (2018), 1.2.

use super::bench::{self, Bench};
use super::view::View;
use crate::estimate::Fit;
use crate::estimate::noise::Autoregression;
use crate::record::Channel;

/// Order of the autoregression.
const ORDER: usize = 20;
/// Share of the root mean square of what is left from which on the inputs could have done it.
const SHARE: f64 = 0.5;

/// Whether noise of the inputs could leave as much of an output as a fitted model does, or that cannot be told.
pub fn could_leave(bench: &Bench, view: &View, fit: &Fit, output: usize) -> bool {
    let mut noisy = bench.clone();
    for channel in noisy.recordings.iter_mut().flat_map(|r| &mut r.channels) {
        if fit.model.inputs.iter().any(|i| i.name == channel.name) {
            add_noise(channel);
        }
    }
    let moved = noisy
        .ready(&fit.model, fit.starts(), (view.tolerance, Vec::new()))
        .and_then(|records| bench::run(&records, &view.stand, &[]));
    let Ok(moved) = moved else { return true };
    let both = || moved.iter().zip(&view.tracks).filter(|(_, plain)| plain.output == output);
    let square = |x: f64| Some(x * x).filter(|x| x.is_finite()).unwrap_or_default();
    let left: f64 = both().flat_map(|(_, plain)| &plain.residual).map(|x| square(*x)).sum();
    let by_noise: f64 = both()
        .flat_map(|(noisy, plain)| noisy.residual.iter().zip(&plain.residual))
        .map(|(a, b)| square(a - b))
        .sum();
    by_noise >= SHARE * SHARE * left
}

/// Adds what the channel's past does not foretell, reversed in time.
fn add_noise(channel: &mut Channel) {
    let known: Vec<f64> = channel.values.iter().copied().filter(|v| v.is_finite()).collect();
    let mean = known.iter().sum::<f64>() / known.len().max(1) as f64;
    let about: Vec<f64> = known.iter().map(|v| v - mean).collect();
    if about.iter().all(|v| v.abs() <= 1e-12 * mean.abs()) {
        return;
    }
    let own = Autoregression::fit(&[&about], ORDER);
    let size = own.innovation_variance().sqrt();
    let new = own.whiten(&about).into_iter().rev().map(|e| size * e);
    channel.values.iter_mut().filter(|v| v.is_finite()).zip(new).for_each(|(v, e)| *v += e);
}
