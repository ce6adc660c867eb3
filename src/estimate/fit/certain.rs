//! Intervals where the curvature at the minimum does not tell them, and what is determined instead.

use super::combination::{Combination, Search};
use super::options::{FitOptions, Weighting};
use super::outcome::{Fit, Status, Warning};
use super::valley::{Directions, Profile, Valley};
use super::{assemble, problem, records, setup};
use crate::Result;
use crate::estimate::covariance::independent_samples;
use crate::estimate::least_squares::Problem;
use crate::record::Recording;
use crate::simulate::Early;
use rayon::prelude::*;

/// A parameter whose interval widens by this when others leave their bounds, or what holds them along a direction that is
/// not seen, does not rest on curvature.
const WIDENS: f64 = 1.2;

/// That profiles were cut off by the time.
const CUT_OFF: &str = "the time given was up before it was found how far parameters that trade with each other may go: \
                       their intervals rest on the curvature at the minimum alone, and may be far too narrow";

/// Replaces the intervals of parameters that trade with others, or that are as uncertain as they are
/// large, by profiles, and finds which combinations of those that trade the data determine. `recordings`
/// and `options` are those of the fit. Where the time is up before that, the fit is as it was, but ended early.
///
/// # Errors
/// Where the fitted model cannot be run.
pub fn ascertain(fit: &mut Fit, recordings: &[Recording], options: &FitOptions<'_>) -> Result<()> {
    let found = profiled(fit, recordings, options);
    // runs that the time has cut off say nothing of how far anything may go
    if options.budget.over() == Some(Early::Time) {
        fit.ended_early = Some(Early::Time);
        fit.warnings.push(Warning { message: CUT_OFF.into() });
        return Ok(());
    }
    if let Some((profiles, determined)) = found? {
        replace(fit, &profiles, determined);
    }
    Ok(())
}

/// Profiles by the number of the parameter, and what is determined of those that trade.
type Found = (Vec<(usize, Profile)>, Vec<Combination>);

/// The profiles that are wanted; none where no direction can be told.
fn profiled(fit: &Fit, recordings: &[Recording], options: &FitOptions<'_>) -> Result<Option<Found>> {
    let near = FitOptions { initials: fit.starts(), tolerance: fit.tolerance, ..options.clone() };
    let own = records(&fit.model, recordings, &near)?;
    let parameters = fit.parameters.iter().map(|p| p.value).collect();
    let mut problem = problem::problem(&fit.model, &own, parameters, &near);
    if fit.rmse.len() > 1 {
        problem.weights =
            fit.rmse.iter().zip(&problem.weights).map(|(e, w)| fitting(1.0 / (e * e), *w)).collect();
    }
    let ranges = setup::ranges(&fit.model, &problem.free, &own);
    let triangle = problem.linearise(&fit.values)?;
    let valley = Valley {
        problem: &problem,
        ranges: &ranges,
        x: &fit.values,
        sum: triangle.sum_of_squares(),
        triangle: &triangle,
        noise: noise(fit, &problem.weights, options),
        reach: assemble::reach(&fit.records, &fit.noise, fit.values.len()),
    };
    if assemble::samples(&fit.records) <= fit.values.len()
        || !(valley.noise > 0.0 && valley.noise.is_finite())
    {
        return Ok(None);
    }
    let Some(directions) = valley.directions() else { return Ok(None) };
    let trading: Vec<usize> = directions.trading().into_iter().filter(|j| *j < problem.free.len()).collect();
    let wanted: Vec<usize> =
        (0..problem.free.len()).filter(|j| is_doubtful(fit, &valley, &directions, *j, &trading)).collect();
    // each with its own share of the steps, so that it ends where it would alone
    let profiled = |j: usize| -> Result<(usize, Profile)> {
        options.progress.report(&format!("how far {} may go", fit.unknowns[j]), None);
        let share = FitOptions { budget: options.budget.part(wanted.len() as u64), ..near.clone() };
        let own = records(&fit.model, recordings, &share)?;
        let mut alone = problem::problem(&fit.model, &own, problem.parameters.clone(), &share);
        alone.weights.clone_from(&problem.weights);
        Ok((problem.free[j], Valley { problem: &alone, ..valley }.profile(j)))
    };
    let profiles: Vec<(usize, Profile)> =
        wanted.par_iter().with_max_len(1).map(|j| profiled(*j)).collect::<Result<_>>()?;
    let points: Vec<Vec<f64>> = profiles.iter().flat_map(|(_, p)| p.points.iter().cloned()).collect();
    let found = Search {
        model: &fit.model,
        free: &problem.free,
        valley: &valley,
        directions: &directions,
        points: &points,
    };
    let determined = if trading.len() > 1 { found.run(&trading) } else { Vec::new() };
    Ok(Some((profiles, determined)))
}

fn fitting(weight: f64, otherwise: f64) -> f64 {
    if weight.is_finite() { weight } else { otherwise }
}

/// What an independent sample of noise adds to the sum of squares, outputs by their slow part.
fn noise(fit: &Fit, weights: &[f64], options: &FitOptions<'_>) -> f64 {
    if matches!(options.weighting, Weighting::Whitened(_)) {
        return 1.0;
    }
    let slow = |(n, w): (&crate::estimate::noise::NoiseModel, &f64)| {
        w * n.autoregression.variance() / independent_samples(n, 1)
    };
    fit.noise.iter().zip(weights).map(slow).filter(|v| v.is_finite()).fold(0.0, f64::max)
}

/// Whether the interval of a parameter does not rest on the curvature.
fn is_doubtful(fit: &Fit, valley: &Valley<'_>, directions: &Directions, j: usize, trading: &[usize]) -> bool {
    let at_bound = fit.is_at_bound(&fit.unknowns[j]);
    let curved = fit.covariance[(j, j)].sqrt();
    let whole = (valley.noise * directions.variance_along(j)).sqrt();
    let held = fit.parameters.iter().any(|p| matches!(p.status, Status::AtBound(_)))
        || fit.unseen.iter().any(|d| d.deviation.is_infinite());
    let widens = held && !at_bound && whole > WIDENS * curved;
    trading.contains(&j) || widens || !at_bound && valley.is_bent(j, directions)
}

fn replace(fit: &mut Fit, profiles: &[(usize, Profile)], determined: Vec<Combination>) {
    for (k, profile) in profiles {
        let p = &mut fit.parameters[*k];
        p.low = profile.low.unwrap_or(f64::NAN);
        p.high = profile.high.unwrap_or(f64::NAN);
        fit.profiled.push(p.name.clone());
    }
    fit.determined = determined;
}
