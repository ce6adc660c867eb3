//! Two findings that may be one law: both act at one place and follow the same signals.
//!
//! # Purpose
//! What is taken first follows as much of a law as its own form can, and another form of the same signals makes up for the
//! rest: a square and a sine of an angle for a weight that is balanced in no upright place. Neither can be left out alone.
//!
//! # Method
//! The model without both is asked for a law of the same signals at that place. One that fits as well as the two, each for the
//! price of its parameters, takes their place.
//!
//! # References
//! A. J. Miller, Subset Selection in Regression, 2nd ed. (2002), 3.5 (replacing several at a time).

use super::backward;
use super::bench::Bench;
use super::catalogue::{self, Proposal};
use super::choose::{RIVAL, TIE, gain, worth_of};
use super::inert;
use super::measure::Measure;
use super::propose::{Screened, explaining};
use super::race::{self, Against, By, Finished};
use super::search::{Found, Taken, is_over, is_pressed};
use super::view::View;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;
use crate::record::Recording;

/// Laws that are fitted in the place of two, at most.
const MOST: usize = 4;
/// Steps of the fit without either.
const STEPS: usize = 8;

/// Puts one law in the place of the first two for which one is worth as much.
pub fn settle(bench: &Bench, separate: &[Recording], found: &mut Found, progress: &dyn Progress) {
    let pairs = (0..found.taken.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let mut alike = pairs.filter(|(i, j)| are_alike(&found.taken[*i].proposal, &found.taken[*j].proposal));
    let one = |(i, j)| Some((i, j, in_place_of(bench, found, (i, j), progress)?));
    let Some((i, j, (one, tried))) = alike.find_map(one) else { return };
    let taken = Taken {
        proposal: one.proposal,
        p_value: found.taken[i].p_value,
        tried,
        ties: Vec::new(),
        elsewhere: Vec::new(),
        others: Vec::new(),
        rivals: None,
    };
    found.taken.remove(j);
    found.replaces(i, taken, one.fit);
    found.without = backward::each(bench, found);
    found.small = None;
    backward::stand(bench, separate, found);
}

/// Whether two findings act at one place and follow the same signals.
fn are_alike(p: &Proposal, q: &Proposal) -> bool {
    p.site == q.site && p.alone == q.alone && !p.follows().is_empty() && p.follows() == q.follows()
}

/// The law that is worth as much as two findings, fitted in their place, and how many were tried.
fn in_place_of(
    bench: &Bench,
    found: &Found,
    (i, j): (usize, usize),
    progress: &dyn Progress,
) -> Option<(Finished, f64)> {
    if is_over(bench) {
        return None;
    }
    let [p, q] = [i, j].map(|k| &found.taken[k].proposal);
    let (with, _) = found.without.get(i)?.as_ref()?;
    let base: &Fit = &inert::bare(&backward::without(bench, with, q, STEPS)?, bench.own_parameters);
    let view = View::of(bench, base).ok()?;
    let scene = bench.scene(&base.model, &view.stand).ok()?;
    let all = catalogue::ALL.iter().flat_map(|m| (m.propose)(&scene));
    let scored = explaining(bench, &view, all.filter(|one| are_alike(one, p)).collect());
    let chosen: Vec<&Screened> = scored.iter().take(MOST).collect();
    let given: Vec<f64> = base.model.parameters.iter().map(|p| p.value).collect();
    let scale = &found.scale;
    let [now, last] = [base, &found.last].map(|fit| Measure::of(fit, scale));
    let against = Against { squares: scale.squares(base), by: By::Likelihood(now.likelihood), scale };
    let fitted = race::run(bench, &view, &given, &chosen, against, progress).into_iter();
    let whole = fitted.filter(|f| !f.is_cut && !is_pressed(&f.proposal, &f.fit));
    let measured = whole.map(|f| (Measure::of(&f.fit, scale), f));
    let worth = |(m, f): &(Measure, Finished)| worth_of(&f.proposal, m);
    let best = measured.max_by(|a, b| worth(a).total_cmp(&worth(b)))?;
    let both = worth_of(q, &last) + worth_of(p, &last) - last.likelihood;
    let is_as_good = worth(&best) > both - TIE && gain(&now, &best.0) >= RIVAL * gain(&now, &last);
    is_as_good.then_some((best.1, scored.len() as f64))
}
