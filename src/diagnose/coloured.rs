//! The model as given, fitted in the colour of its noise.
//!
//! # Purpose
//! Where the noise is slow, the least squares of a free run follow its wander and not what the model does faster: a
//! resonance goes astray, and what it leaves looks like something that is missing.
//!
//! # Method
//! Where the search ends with something that is missing for sure, the model as given is fitted once more, from all reasoned
//! starts, by generalised least squares: whitened by the noise of the first fit, and then by its own. Where it is
//! plainly likelier so than with all that was found, the search begins there.
//!
//! # References
//! A. C. Aitken, Proc. R. Soc. Edinburgh 55 (1936) 42.

use super::bench::Bench;
use super::choose::PLAINLY;
use super::compared::same_samples;
use super::measure::Measure;
use super::search::Found;
use crate::estimate::fit::{Effort, Weighting};
use crate::estimate::{Fit, FitOptions, fit};
use crate::model::Model;

/// The model fitted in the colour of what its first fit leaves, where that is plainly likelier than all that was found.
pub fn refitted(bench: &Bench, found: &Found, model: &Model) -> Option<Fit> {
    let first = &found.base;
    if bench.is_trials() {
        return None;
    }
    let within = |noise: &Fit, options: FitOptions<'static>| FitOptions {
        weighting: Weighting::Whitened(noise.noise.clone()),
        ..options
    };
    let far = fit(model, &bench.recordings, &within(first, bench.first_options())).ok()?;
    // the noise of the first fit held what the model does faster
    let near = FitOptions { initials: far.starts(), ..bench.options(Effort::Near, 30) };
    let other = fit(&far.model, &bench.recordings, &within(&far, near)).ok()?;
    let likely = Measure::of(&other, &found.scale).likelihood;
    (same_samples(first, &other) && likely > found.worth(&found.scale) + PLAINLY).then_some(other)
}
