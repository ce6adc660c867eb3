//! Backward from what was found: each finding must be needed beside the others.
//!
//! # Purpose
//! What was taken first may have stood for what was found later, and what was taken last may bend what another
//! leaves. A finding is listed only where the recordings ask for it beside all others.
//!
//! # Method
//! The last model is refitted without each finding in turn. A finding stands if the likelihood that it adds is no
//! noise, corrected for all that was tried beside it, and pays for its parameters; if it lowers the error over blocks
//! left out, and, where it lowers that by little, what was held out too; and if its amplitude is not that of another
//! finding with the other sign, unless the error is far larger without it. Of those that do not stand the
//! least likely is dropped, and the others are asked again; it and its ties count as look-alikes of what was found after it.
//!
//! # References
//! G. Schwarz, Ann. Statist. 6 (1978) 461 (the price); N. R. Draper, H. Smith, Applied Regression Analysis, 3rd ed.
//! (1998), 15.4 (backward elimination).

use super::answer::Evidence;
use super::bench::Bench;
use super::catalogue::Proposal;
use super::choose::{CHANCE, FLOOR, MUCH, gain, price};
use super::inert::{self, Inert};
use super::measure::{Measure, Scale};
use super::prove::{Held, held_out, leaves_levels_out};
use super::search::{Found, Taken, ahead, is_over};
use crate::estimate::fit::Effort;
use crate::estimate::{Fit, fit};
use crate::model::Model;
use crate::record::Recording;
use rayon::prelude::*;

/// Correlation of the amplitudes of two findings from which on they are one thing with two signs.
const ONE: f64 = 0.98;

/// Fall of ln of the squares of blocks left out from which on a finding is needed, however its amplitude is determined.
const NEEDED: f64 = 1.0;

/// Share of the fall of the held-out errors that is none.
const NO_SHARE: f64 = 1e-3;

/// The last model without one finding, and how good it is.
type Without = (Fit, Measure);

/// The model of a fit in which one taken mechanism does nothing, refitted in so many steps; `None` where nothing keeps it
/// from acting.
pub fn without(bench: &Bench, last: &Fit, p: &Proposal, steps: usize) -> Option<Fit> {
    fitted_from(bench, &Inert::of(p)?.model(&last.model, p)?, last, steps)
}

/// A model fitted in so many steps from where it stands and where the states of a larger one begin; in none, it is run there.
pub fn fitted_from(bench: &Bench, model: &Model, last: &Fit, steps: usize) -> Option<Fit> {
    let mut options = bench.options(Effort::Near, steps);
    options.initials = last.starts().iter().map(|x| inert::kept(model, &last.model, x)).collect();
    fit(model, &bench.recordings, &options).ok()
}

/// Drops what the others make needless, and keeps the fits without each of those that stand. A finding is no
/// alternative to another.
pub fn stand(bench: &Bench, separate: &[Recording], found: &mut Found) {
    drop_needless(bench, separate, found);
    let named: Vec<Proposal> = found.taken.iter().map(|t| t.proposal.clone()).collect();
    let is_named = |p: &Proposal| named.iter().any(|n| n.code == p.code && n.site == p.site);
    for t in &mut found.taken {
        t.ties.retain(|p| !is_named(p));
    }
}

fn drop_needless(bench: &Bench, separate: &[Recording], found: &mut Found) {
    bench.budget.begin("needless ones");
    while !is_over(bench) && !found.taken.is_empty() {
        let last = Measure::of(&found.last, &found.scale());
        found.without = each(bench, found);
        let weakest = |i: &usize| match &found.without[*i] {
            Some(w) => worth(&last, w, &found.taken[*i]),
            None => f64::INFINITY,
        };
        let unproven = unproven(bench, separate, found);
        let is_idle = |i: usize| unproven[i] && is_small(found, &last, i);
        let mut failing: Vec<usize> =
            (0..found.taken.len()).filter(|i| fails(found, &last, *i) || is_idle(*i)).collect();
        failing.sort_by(|a, b| weakest(a).total_cmp(&weakest(b)));
        // A smaller model that cannot be run everywhere stands for nothing.
        let runs = |i: &usize| {
            let w = found.without[*i].as_ref();
            w.is_some_and(|w| ahead(bench, separate, &w.0).is_some())
        };
        let Some(i) = failing.into_iter().find(runs) else { return };
        let needless = found.taken.remove(i);
        // what stands for it may be a look-alike of what was found in its place
        let alike = [&[needless.proposal][..], &needless.ties, &needless.others].concat();
        found.taken[i..].iter_mut().for_each(|later| later.others.extend(alike.iter().cloned()));
        if let Some(w) = found.without.swap_remove(i) {
            bench.budget.tell(w.0.ended_early);
            found.last = w.0;
        }
        found.without.clear();
        found.measures.1 = Measure::of(&found.last, &found.scale);
    }
}

/// The last model without each finding; the model as given where there is one.
pub fn each(bench: &Bench, found: &Found) -> Vec<Option<Without>> {
    let scale = found.scale();
    let measured = |fit: Fit| -> Without {
        let measure = Measure::of(&fit, &scale);
        (fit, measure)
    };
    if found.taken.len() == 1 {
        return vec![Some(measured(found.base.clone()))];
    }
    let steps = bench.steps(&found.last.model);
    let one = |t: &Taken| without(bench, &found.last, &t.proposal, steps).map(measured);
    found.taken.par_iter().with_max_len(1).map(one).collect()
}

/// Log-likelihood that a finding adds, less the price of its parameters.
fn worth(last: &Measure, without: &Without, taken: &Taken) -> f64 {
    last.likelihood - without.1.likelihood - price(&taken.proposal, last.samples)
}

/// Whether a finding does not stand. Alone it stands by the choice that took it.
fn fails(found: &Found, last: &Measure, i: usize) -> bool {
    let taken = &found.taken[i];
    let Some(without) = found.without[i].as_ref().filter(|_| found.taken.len() > 1) else { return false };
    let fall = gain(&without.1, last);
    let falls = fall >= -2.0 * (1.0 - 0.5 * FLOOR).ln();
    let p_value = p_value(last, without, taken);
    let is_one = |t: &Taken| is_one(&found.last, &t.proposal, &taken.proposal);
    let mirrored = fall < NEEDED && found.taken[..i].iter().any(is_one);
    !falls || p_value >= CHANCE || worth(last, without, taken) < 0.0 || mirrored
}

/// Whether a finding among several lowers the error over blocks left out by little.
fn is_small(found: &Found, last: &Measure, i: usize) -> bool {
    found.without[i].as_ref().is_some_and(|w| gain(&w.1, last) < MUCH)
}

/// Which findings of several lower no error of what is held out.
fn unproven(bench: &Bench, separate: &[Recording], found: &Found) -> Vec<bool> {
    let none = vec![false; found.taken.len()];
    let held = |fit: &Fit| held_out(bench, fit, separate).ok();
    if found.taken.len() < 2 || leaves_levels_out(bench, separate) {
        return none;
    }
    let (Some(base), Some(last)) = (held(&found.base), held(&found.last)) else { return none };
    let relative = |h: &[Held]| -> f64 {
        let shares = h.iter().zip(&base).map(|(h, b)| h.rmse() / b.rmse());
        shares.filter(|x| x.is_finite()).sum()
    };
    let fall = relative(&base) - relative(&last);
    let idle = |w: &Option<Without>| {
        let smaller = w.as_ref().and_then(|w| held(&w.0));
        smaller.is_some_and(|h| relative(&h) - relative(&last) <= NO_SHARE * fall)
    };
    found.without.iter().map(idle).collect()
}

fn p_value(last: &Measure, without: &Without, taken: &Taken) -> f64 {
    (taken.tried * last.chance_over(without.1.likelihood, taken.proposal.added.len())).min(1.0)
}

/// Whether amplitudes of two findings are determined only together.
fn is_one(fit: &Fit, a: &Proposal, b: &Proposal) -> bool {
    let numbers = |p: &Proposal| -> Vec<usize> {
        let names = p.amplitudes.iter().map(|k| &p.added[*k].name);
        names.filter_map(|n| fit.unknowns.iter().position(|u| u == n)).collect()
    };
    let c = &fit.covariance;
    let correlated = |i: usize, j: usize| c[(i, j)].abs() > ONE * (c[(i, i)] * c[(j, j)]).sqrt();
    let others = numbers(b);
    numbers(a).into_iter().any(|i| others.iter().any(|j| correlated(i, *j)))
}

/// What speaks for each finding; its share of what is held out is filled in by the proof.
pub fn evidence(found: &Found) -> Vec<Option<Evidence>> {
    let last = Measure::of(&found.last, &found.scale());
    let one = |(t, w): (&Taken, &Option<Without>)| {
        w.as_ref().map(|w| Evidence {
            log_likelihood_ratio: last.likelihood - w.1.likelihood,
            degrees: t.proposal.added.len(),
            p_value: p_value(&last, w, t),
            holdout_share: f64::NAN,
        })
    };
    let none = std::iter::repeat_with(|| &None);
    found.taken.iter().zip(found.without.iter().chain(none)).map(one).collect()
}

impl Found {
    /// The scale of the last model.
    fn scale(&self) -> Scale {
        Scale::of(&self.last, self.scale.trials)
    }
}
