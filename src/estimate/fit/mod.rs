//! A model fitted to recordings by simulation.
//!
//! [`fit`] moves the free parameters, shared by all recordings, and each recording's free initial
//! states until the free run of the model lies nearest to the measurements. [`holdout`] runs the
//! fitted model over what was held out.

mod assemble;
mod begins;
mod certain;
mod combination;
mod covered;
mod equation_error;
pub(crate) mod harness;
mod held_out;
mod options;
mod outcome;
mod problem;
mod search;
pub(crate) mod seen;
pub(crate) mod setup;
mod shooting;
mod simulated;
mod spectra;
mod stepping;
mod valley;
mod warnings;

pub use begins::begun_on;
pub use certain::ascertain;
pub use combination::Combination;
pub use options::{Effort, FitOptions, Progress, Silent, Weighting};
pub use outcome::{
    Beside, Fit, HeldOut, InitialEstimate, ParameterEstimate, RecordFit, Series, Status, Warning,
};
pub use spectra::{ResidualSpectrum, residual_spectra};

use crate::estimate::least_squares::{End, Minimum, minimise};
use crate::model::Model;
use crate::record::Recording;
use crate::simulate::Early;
use crate::{Error, ErrorKind, Result};
use assemble::Assembly;
use harness::Record;
use problem::FreeRun;
use std::borrow::Cow;

/// Rounds in which the weights of several outputs are brought in line with their residuals.
const ROUNDS: usize = 4;

/// The solver's error is kept below this share of the innovations' deviation.
const FINER: f64 = 0.03;
/// No finer tolerance is asked of the simulator, as a share of the spread.
const FINEST: f64 = 1e-9;

/// A model as a fit begins with it: a Functional Mock-up Unit that steps itself stands where it fits best.
///
/// # Errors
/// Where the unit does not run.
pub fn begun<'m>(
    model: &'m Model,
    recordings: &[Recording],
    options: &FitOptions<'_>,
) -> Result<Cow<'m, Model>> {
    stepping::settle(model, recordings, options)
}

/// Fits a model to the fitted parts of recordings.
///
/// # Errors
/// Where a channel is missing, no sample is left to fit, or no start can be simulated.
pub fn fit(model: &Model, recordings: &[Recording], options: &FitOptions<'_>) -> Result<Fit> {
    let (mut fitted, wanted, met) = once(model, recordings, options)?;
    let finer = wanted < options.tolerance && !options.is_rough && !model.states.is_empty();
    if finer && fitted.ended_early.is_none() {
        options.progress.report("fitting with finer steps", None);
        let finer = FitOptions {
            tolerance: wanted.max(FINEST),
            effort: Effort::Near,
            initials: fitted.starts(),
            ..options.clone()
        };
        let coarse = fitted;
        let found = once(&coarse.model, recordings, &finer);
        fitted = match found {
            Ok(found) => found.0,
            // Not a single run was finished: the coarser fit is the best so far.
            Err(e) if e.kind() == ErrorKind::NotComputed => return Ok(coarse_alone(coarse, &e, options)),
            Err(e) => return Err(e),
        };
        fitted.simulations += coarse.simulations;
        let own = std::mem::take(&mut fitted.warnings);
        let met = met.into_iter().filter(|w| !own.contains(w)).collect();
        fitted.warnings = [met, own].concat();
    }
    Ok(fitted)
}

/// A fit whose runs cannot be made as fine as its noise asks for.
fn coarse_alone(coarse: Fit, e: &Error, options: &FitOptions<'_>) -> Fit {
    let message = format!("the noise is so small that finer steps would be needed, which failed: {e}");
    let ended_early = options.budget.over();
    let mut warnings = coarse.warnings;
    if ended_early.is_none() {
        warnings.push(Warning { message });
    }
    Fit { warnings, ended_early, ..coarse }
}

/// One fit at one tolerance, the tolerance that its noise asks for, and what its search met with.
fn once(
    model: &Model,
    recordings: &[Recording],
    options: &FitOptions<'_>,
) -> Result<(Fit, f64, Vec<Warning>)> {
    let options = &FitOptions { budget: options.budget.rest(), ..options.clone() };
    let records = records(model, recordings, options)?;
    let parameters = model.parameters.iter().map(|p| p.value).collect();
    let mut problem = problem::problem(model, &records, parameters, options);
    let signals = problem.weights.clone();
    let ranges = setup::ranges(model, &problem.free, &records);
    let given = problem::given(&problem);
    let mut found = search::Search::new(model, recordings, options, &problem, &ranges).run(&given)?;
    if problem.whitening.is_none() && model.outputs.len() > 1 {
        balance(&mut problem, &mut found.minimum, &ranges, options)?;
    }
    let spent = (found.minimum.end == End::OutOfBudget).then_some(Early::Steps);
    let ended_early = options.budget.over().or(spent);
    options.budget.lift_time();
    let fitted = Assembly {
        ended_early,
        model,
        problem: &problem,
        minimum: &found.minimum,
        ranges: &ranges,
        start: &given,
        simulations: found.simulations,
        warnings: [found.warnings.clone(), covered::warnings(model, recordings)].concat(),
        tolerance: options.tolerance,
        periods: covered::samples_in_a_period(model, recordings),
    }
    .finish()?;
    let innovations = fitted.noise.iter().map(|n| n.autoregression.innovation_variance());
    let share = innovations.zip(&signals).map(|(v, w)| (v * w).sqrt()).fold(f64::INFINITY, f64::min);
    Ok((fitted, FINER * share, found.warnings))
}

/// One record a recording.
fn records(model: &Model, recordings: &[Recording], options: &FitOptions<'_>) -> Result<Vec<Record>> {
    recordings
        .iter()
        .enumerate()
        .map(|(number, recording)| {
            let spans = setup::spans(model, recording, options);
            setup::record(model, recording, number, &spans.fit, options)
        })
        .collect()
}

/// Weighs every output by its own residual and walks on, until the weights stand.
fn balance(
    problem: &mut FreeRun<'_>,
    minimum: &mut Minimum,
    ranges: &[super::Range],
    options: &FitOptions<'_>,
) -> Result<()> {
    let over = || options.budget.over().is_some();
    for _ in 0..ROUNDS {
        let squares = match problem.mean_squares(&minimum.x) {
            Err(_) if over() => break,
            squares => squares?,
        };
        let mut change: f64 = 0.0;
        for (weight, square) in problem.weights.iter_mut().zip(squares) {
            let new = 1.0 / square.max(1e-12 / *weight);
            change = change.max((new / *weight).ln().abs());
            *weight = new;
        }
        problem.begin_walk();
        *minimum = match minimise(problem, &minimum.x, ranges, options.stopping) {
            Err(_) if over() => break,
            found => found?,
        };
        if change < 0.05 || over() {
            break;
        }
    }
    Ok(())
}

/// Runs a fitted model over the held-out parts: spans of the fitted `recordings` that follow a fitted
/// span are simulated on from it; for `separate` records only their free initial states are fitted.
/// One entry an output, in the model's order, all records pooled.
///
/// # Errors
/// Where a channel is missing or the fitted model cannot be run.
pub fn holdout(
    fit: &Fit,
    recordings: &[Recording],
    separate: &[Recording],
    options: &FitOptions<'_>,
) -> Result<Vec<HeldOut>> {
    held_out::held_out(fit, recordings, separate, (options, false))
}

/// The same, with sensitivities to the fit's unknowns of what follows a fitted span.
pub(crate) fn carried_on(
    fit: &Fit,
    recordings: &[Recording],
    separate: &[Recording],
    options: &FitOptions<'_>,
) -> Result<Vec<HeldOut>> {
    held_out::held_out(fit, recordings, separate, (options, true))
}
