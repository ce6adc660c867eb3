//! Another beginning: the search once more without what it began with, where it ended without a name, or with one that
//! may be two or leaves a law.
//!
//! # Purpose
//! Of two effects the search takes first what follows both best by itself, such as a bend of an input that stands for a
//! limit and a loss. What the limit leaves then has no name, and no finding alone is too much. A loop of hysteresis
//! bends and damps at once, as a softening and a square damping do together.
//!
//! # Method
//! The search begins again without the laws of the same signals as its first finding; later it may take them. Then each
//! finding is asked for its look-alikes beside the others: the model without it is screened and fitted anew, and the
//! best takes its place where it is worth more (stepwise replacement). What comes out is taken for the first answer
//! where it is surely likelier, each for the price of its parameters.
//!
//! # References
//! A. J. Miller, Subset Selection in Regression, 2nd ed. (2002), 3.5 (sequential replacement).

use super::answer::Answer;
use super::bench::Bench;
use super::choose::{Choice, FLOOR, TIE, choose, worth_of};
use super::free_law::surely_leaves;
use super::measure::Measure;
use super::search::{self, Found, Round, State, Taken, is_over};
use super::view::View;
use super::walk::Bounds;
use super::{backward, beside, inert, walk};
use crate::estimate::fit::Progress;
use crate::record::Recording;

/// Share of the fall of the held-out errors from which on one of several findings is no patch.
const MOST: f64 = 2.0 / 3.0;

/// How often each finding is asked: what is found in the place of one changes what stands for the others.
const PASSES: usize = 2;

/// Whether what was found may stand for something else: one loop of hysteresis for two laws; what surely leaves another
/// law, be it one or several of which none explains most.
pub fn may_be_others(found: &Found, answer: &Answer) -> bool {
    let is_loop = matches!(found.taken.as_slice(), [one] if one.proposal.code == "hysteresis");
    let findings = &answer.findings;
    is_loop || surely_leaves(answer) && (findings.len() == 1 || findings.iter().all(|f| f.share < MOST))
}

/// What the search finds where it may not begin as it did; none that is not surely likelier.
pub fn beginning(
    bench: &Bench,
    separate: &[Recording],
    first: &Found,
    given: &[f64],
    progress: &dyn Progress,
) -> Option<Found> {
    let began = &first.taken.first()?.proposal;
    if is_over(bench) || bench.is_trials() {
        return None;
    }
    let bounds = Bounds { given, avoids: Some(began), is_over: &|_| false, may_begin_anew: true };
    let mut found = walk::search(bench, separate, first.base.clone(), &bounds, progress).ok()?;
    found.without = backward::each(bench, &found);
    let mut stands = false;
    for _ in 0..PASSES {
        let mut is_other = false;
        for i in 0..found.taken.len() {
            if i < found.taken.len() && found.taken.len() > 1 && !is_over(bench) {
                is_other |= replace(bench, separate, &mut found, (i, progress)).is_some();
            }
        }
        stands |= is_other;
        if !is_other {
            break;
        }
    }
    // what was replaced stood its test then
    if !stands {
        backward::stand(bench, separate, &mut found);
    }
    beside::settle(bench, separate, &mut found, progress);
    found.is_surely_better(bench, first).then_some(found)
}

/// By how much the logarithm of held-out errors differs where nothing tells them apart.
const ALIKE: f64 = 0.01;

/// Whether another answer has names and leaves nothing, and errors on what was held out that are no larger than those
/// of the first; with more names than the first has, smaller ones.
pub fn is_better(first: &Answer, other: &Answer) -> bool {
    let left = |a: &Answer| a.proof.iter().map(|p| p.holdout_after.ln()).sum::<f64>();
    let names = |a: &Answer| a.verdict.has_names();
    let has_more = names(first) && other.findings.len() > first.findings.len();
    let most = left(first) + if has_more { (1.0 - FLOOR).ln() } else { ALIKE };
    names(other) && other.unexplained.is_none() && left(other) < most
}

/// Puts the likeliest in the place of a finding, beside the others, where that is worth more.
fn replace(
    bench: &Bench,
    separate: &[Recording],
    found: &mut Found,
    (i, progress): (usize, &dyn Progress),
) -> Option<()> {
    let (round, choice) = asked(bench, found, i, progress)?;
    let Choice { best, ties, elsewhere, .. } = choice;
    let r = &round.fitted[best];
    let now = worth_of(&found.taken[i].proposal, &Measure::of(&found.last, &found.scale));
    let is_better = worth_of(&r.proposal, &Measure::of(&r.fit, &found.scale)) > now + TIE;
    if !is_better || search::ahead(bench, separate, &r.fit).is_none() {
        return None;
    }
    let (proposal, p_value, tried) = (r.proposal.clone(), r.p_value, r.tried);
    let taken = Taken { proposal, p_value, tried, ties, elsewhere, others: Vec::new(), rivals: None };
    found.replaces(i, taken, r.fit.clone());
    backward::stand(bench, separate, found);
    Some(())
}

/// What a round chooses in the model without a finding.
fn asked(bench: &Bench, found: &Found, i: usize, progress: &dyn Progress) -> Option<(Round, Choice)> {
    let (with, _) = found.without.get(i)?.as_ref()?;
    let base = &inert::bare(with, bench.own_parameters);
    let view = View::of(bench, base).ok()?;
    let now = Measure::of(base, &found.scale);
    let others: Vec<Taken> =
        found.taken.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, t)| t.clone()).collect();
    let state =
        State { now: &now, scale: &found.scale, gains: 0.0, taken: &others, is_last: false, avoids: None };
    let given: Vec<f64> = base.model.parameters.iter().map(|p| p.value).collect();
    let round = search::round(bench, (base, &view), &state, &given, progress).ok()?;
    search::trace(bench, &round, &now);
    let choice = choose(&round, &now)?;
    Some((round, choice))
}
