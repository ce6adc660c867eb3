//! The race: proposals fitted inside the model, those that fall behind given up early.
//!
//! # Purpose
//! A fit by simulation is what a diagnosis spends its time in. Most proposals show after a few steps
//! that another lowers the free-run error by far more, and then need no more steps. All are compared with
//! every output weighed by what the model leaves of it now: a fit's own weights follow its own residual.
//!
//! # Method
//! Two heats: a few steps from the best starts of each proposal, with a solver as rough as the residual
//! that the model leaves now allows; a few more for the better half, or, where one plainly lowers what is left, for
//! those whose sum of squares falls by some share of its fall, as logarithms. Those that then fall by a fair share of
//! it are fitted to the end, and the likeliest to first order: many forms of one slow effect may lower the squares more
//! than that, and yet be less sure beside noise as slow. Where one is plainly likelier than the model as it is, those that
//! gain little of its likelihood go no further: it is already that of the linear problem around where they are. One whose
//! own steps were spent in a heat is told by the best that it reached, so that it can be asked whether it matters.
//!
//! # References
//! O. Maron, A. W. Moore, Artificial Intelligence Review 11 (1997) 193 (racing).

use super::bench::{Bench, Stand};
use super::catalogue::Proposal;
use super::choose::{MUCH, PLAINLY, RIVAL, TIE, floor, is_anchored};
use super::foretold::Foretold;
use super::measure::{Measure, Scale, made_by};
use super::propose::{Screened, starts};
use super::view::View;
use crate::estimate::fit::{Effort, Progress};
use crate::estimate::{Fit, fit};
use crate::model::{Initial, Model, State};
use crate::simulate::Budget;
use rayon::prelude::*;

/// Steps of the two heats.
const HEATS: [usize; 2] = [3, 5];
/// Proposals that the second heat takes.
const SECOND: usize = 12;
/// Share of the largest fall of ln Σe² in the first heat from which on a proposal takes part in the second, and in
/// both from which on it is fitted to the end. None with less than RIVAL of it can be chosen.
const FAIR: [f64; 2] = [0.25, 0.6];
/// Proposals that are fitted to the end at most, and at least: where one plainly lowers what is left, and else.
const LAST: (usize, [usize; 2]) = (8, [3, 6]);
/// How many begin the first heat at least: the most likely to first order, and as many of those that explain most. Where the
/// best of them plainly lowers what is left, none follows whose likelihood is less than a share of the largest and which
/// explains less to first order than a share of that fall, both as logarithms. What was named on twenty recordings of strangers
/// foretold 0.18 of it and more.
const BEGIN: usize = 6;
const FOLLOWS: (f64, f64) = (0.5, 0.1);
/// Share of what a proposal's direction foretells that its first heat must keep.
const KEPT: f64 = 0.5;
/// Shares of the gain in log-likelihood of one that is plainly likelier that another must gain to go on to the second heat and
/// to the end. None with less than a share of 1 - COMMUTES of it can be named.
const LIKELIER: [f64; 2] = [0.3, 0.5];
/// Share of the largest score of those that are fitted to the end from which on those with fewer parameters join them, and how
/// many.
const SIMPLER: f64 = 0.5;
const RIVALS: usize = 2;
/// Times the least error of blocks left out with which another goes on to the second heat and to the end, where the choice
/// is made by that.
const NEAR: [f64; 2] = [2.0, 1.2];
/// Share of what a proposal lowers that its sizes must make, where its own states may begin anywhere.
const COUPLED: f64 = 0.01;
/// Runs, as long as those of the model as given, that a heat and a last fit may spend. One with more sensitivities, events
/// or shorter steps counts as several.
const SPENT: [u64; 2] = [100, 100];
/// Parts of the steps that are left, times the proposals beside each other, of which a heat and a last fit may spend one.
const SHARES: [usize; 2] = [4, 3];
/// Runs that the heats of a proposal take, about, and as many its last fit.
const RUNS: usize = 20;

/// A proposal with its fit so far, and what that leaves.
struct Runner<'s> {
    screened: &'s Screened,
    fit: Fit,
    left: f64,
    is_cut: bool,
}

impl<'s> Runner<'s> {
    fn new(screened: &'s Screened, fit: Fit, scale: &Scale) -> Self {
        let (left, is_cut) = (scale.squares(&fit), fit.ended_early.is_some());
        Self { screened, fit, left, is_cut }
    }

    /// The better of two, which is cut where one of them was.
    fn or(self, other: Self) -> Self {
        let is_cut = self.is_cut || other.is_cut;
        Self { is_cut, ..if other.left.total_cmp(&self.left).is_lt() { other } else { self } }
    }
}

/// A proposal as the race leaves it.
pub struct Finished {
    /// The proposal.
    pub proposal: Proposal,
    /// Its fit, or the best so far.
    pub fit: Fit,
    /// Whether it was ended by its own steps or the time before it was through.
    pub is_cut: bool,
}

/// What proposals are compared with.
#[derive(Clone, Copy)]
pub struct Against<'a> {
    /// What the model leaves now, weighed by the scale.
    pub squares: f64,
    /// How the choice will be made.
    pub by: By,
    /// The scale of comparison.
    pub scale: &'a Scale,
}

/// By what a choice among fitted proposals is made: those that a heat leaves far behind in it go no further.
#[derive(Clone, Copy)]
pub enum By {
    /// By likelihood, which is so much without any of them.
    Likelihood(f64),
    /// By the error of blocks left out, and none that leaves more than this serves.
    LeftOut(f64),
}

/// Fits proposals: gives the best of them, fitted to the end, and those that were cut before.
pub fn run(
    bench: &Bench,
    view: &View,
    given: &[f64],
    chosen: &[&Screened],
    against: Against<'_>,
    progress: &dyn Progress,
) -> Vec<Finished> {
    let now = against.squares;
    if chosen.is_empty() {
        return Vec::new();
    }
    bench.budget.begin("heats");
    let stage = format!("fitting the {} likeliest of them", chosen.len());
    let foretold = Foretold::begin(bench, progress, &stage, RUNS * (chosen.len() + LAST.1[0]));
    let heated = bench.sharing(SHARES[0] * chosen.len());
    let mut field = heats(&heated, view, given, (chosen, &foretold), against);
    let is_plain = fall(&field, now) > MUCH;
    let least = LAST.1[usize::from(!is_plain)];
    let mut last = ahead(&field, now, FAIR[1]).clamp(least, LAST.0).min(field.len());
    if let Some(likeliest) = likelier_behind(&field, last, now) {
        field.swap(last, likeliest);
        last += 1;
    }
    let mut others = field.split_off(last);
    let (mut field, unlikely) = going_on(field, against, 1);
    others.extend(unlikely);
    if view.stand.parameters.len() == bench.own_parameters {
        let (simpler, rest) = simpler(&field, others);
        field.extend(simpler);
        others = rest;
    }
    others.retain(|r| r.is_cut);
    bench.budget.begin("last fits");
    let bench = &bench.sharing(SHARES[1] * LAST.0);
    let ended = field.into_par_iter().with_max_len(1).filter_map(|r| {
        let fit = to_the_end(bench, &r.screened.proposal, &r.fit, &bench.runs(SPENT[1]));
        foretold.done(RUNS);
        let fit = fit?;
        Some(Finished { proposal: r.screened.proposal.clone(), is_cut: fit.ended_early.is_some(), fit })
    });
    let mut all: Vec<Finished> = ended.collect();
    let of = |r: Runner<'_>| Finished { proposal: r.screened.proposal.clone(), fit: r.fit, is_cut: true };
    all.extend(others.into_iter().map(of));
    all
}

/// All proposals after their heats, best first.
fn heats<'s>(
    bench: &Bench,
    view: &View,
    given: &[f64],
    (chosen, foretold): (&[&'s Screened], &Foretold<'_>),
    against: Against<'_>,
) -> Vec<Runner<'s>> {
    let Against { squares: now, scale, .. } = against;
    let first = |s: &&'s Screened| {
        let walks = starts(bench, view, given, s, scale).into_iter().filter_map(|stand| {
            walk(bench, &stand.placed(&s.proposal.model), stand.initials, HEATS[0], view)
        });
        let best = walks.map(|fit| Runner::new(s, fit, scale)).reduce(Runner::or);
        let best = best.map(|best| match held_first(bench, view, &best, now) {
            Some(fit) => best.or(Runner::new(s, fit, scale)),
            None => best,
        });
        foretold.done(RUNS);
        best
    };
    let is_coupled = |r: &Runner<'_>| !begins_alone(&r.screened.proposal, &r.fit, (now, scale));
    let heated = |some: &[&'s Screened]| -> Vec<Runner<'s>> {
        let some = some.par_iter().with_max_len(1).filter_map(first);
        some.filter(is_coupled).collect()
    };
    let (begin, mut follow) = begin(chosen, against.by);
    let mut field = heated(&begin);
    sort(&mut field);
    let many = follow.len();
    follow.retain(|s| may_follow(s, &begin, fall(&field, now)));
    foretold.done(RUNS * (many - follow.len()));
    field.extend(heated(&follow));
    sort(&mut field);
    let is_plain = fall(&field, now) > MUCH;
    let on = if is_plain { ahead(&field, now, FAIR[0]).max(LAST.1[0]) } else { SECOND };
    let mut rest = field.split_off(on.min(SECOND).min(field.len()));
    let (field, unlikely) = going_on(field, against, 0);
    rest.extend(unlikely);
    sort(&mut rest);
    let second = |r: Runner<'s>| {
        let longer = walk(bench, &r.fit.model, r.fit.starts(), HEATS[1], view);
        match longer {
            Some(fit) => {
                let longer = Runner::new(r.screened, fit, scale);
                r.or(longer)
            }
            None => r,
        }
    };
    let mut field: Vec<Runner<'_>> = field.into_par_iter().with_max_len(1).map(second).collect();
    field.retain(is_coupled);
    sort(&mut field);
    field.extend(rest);
    field
}

/// Those that begin the first heat, and the others.
fn begin<'s>(chosen: &[&'s Screened], by: By) -> (Vec<&'s Screened>, Vec<&'s Screened>) {
    if matches!(by, By::LeftOut(_)) {
        return (chosen.to_vec(), Vec::new());
    }
    let ranked = |of: &dyn Fn(&Screened) -> f64| -> f64 {
        let mut values: Vec<f64> = chosen.iter().map(|s| of(s)).collect();
        values.sort_by(|a, b| b.total_cmp(a));
        values.get(BEGIN - 1).copied().unwrap_or(f64::NEG_INFINITY)
    };
    let least = (ranked(&|s| s.score.statistic), ranked(&|s| s.explained));
    let is_first = |s: &&&Screened| s.score.statistic >= least.0 || s.explained >= least.1;
    let (begin, follow): (Vec<_>, Vec<_>) = chosen.iter().partition(is_first);
    (begin, follow)
}

/// Whether a proposal may come near what those that began lowered, or near the likeliest of them.
fn may_follow(s: &Screened, begun: &[&Screened], fall: f64) -> bool {
    let largest = begun.iter().map(|b| b.score.statistic).fold(0.0, f64::max);
    let foretold = -(1.0 - s.explained.clamp(0.0, 1.0)).ln();
    fall < MUCH || foretold >= FOLLOWS.1 * fall || s.score.statistic >= FOLLOWS.0 * largest
}

/// A sorted field parted into those that go on after a heat, and those that are far behind in what the choice is made by.
fn going_on<'s>(
    field: Vec<Runner<'s>>,
    against: Against<'_>,
    heat: usize,
) -> (Vec<Runner<'s>>, Vec<Runner<'s>>) {
    let measures: Vec<Measure> = field.par_iter().map(|r| Measure::of(&r.fit, against.scale)).collect();
    let stays = match against.by {
        By::Likelihood(before) => likely(&field, &measures, (before, against.squares), heat),
        By::LeftOut(most) => {
            let least = measures.iter().map(|m| m.left_out).fold(f64::INFINITY, f64::min);
            measures.iter().map(|m| m.left_out <= NEAR[heat] * least.min(most)).collect()
        }
    };
    let (on, off): (Vec<_>, Vec<_>) = field.into_iter().zip(stays).partition(|(_, stays)| *stays);
    let runners = |part: Vec<(Runner<'s>, bool)>| part.into_iter().map(|(r, _)| r).collect();
    (runners(on), runners(off))
}

/// Which of a sorted field gain a share of the largest gain in likelihood of those that can be chosen, where that is plain,
/// and else are not plainly less likely than the likeliest. The first in squares that is as likely as the model goes on in
/// any case: it may be tried.
fn likely(
    field: &[Runner<'_>],
    measures: &[Measure],
    (before, squares): (f64, f64),
    heat: usize,
) -> Vec<bool> {
    let gains: Vec<f64> = measures.iter().map(|m| m.likelihood - before).collect();
    let tried = gains.iter().position(|g| *g > -TIE);
    let falls: Vec<f64> = field.iter().map(|r| (squares / r.left).ln()).collect();
    let least = RIVAL * tried.map_or(0.0, |i| falls[i]);
    let of = gains.iter().zip(&falls);
    let largest = of.filter(|(_, f)| **f >= least).map(|(g, _)| *g).fold(0.0, f64::max);
    let likeliest = gains.iter().fold(f64::NEG_INFINITY, |all, g| all.max(*g));
    let enough = if largest < PLAINLY { likeliest.min(0.0) - PLAINLY } else { LIKELIER[heat] * largest };
    gains.iter().enumerate().map(|(i, g)| *g >= enough || Some(i) == tried).collect()
}

/// A few steps of a proposal that kept less than it foretold, from its size and the fitted parameters as they fit each other
/// while its shapes are held: from a size that is far off the shapes run away first.
fn held_first(bench: &Bench, view: &View, best: &Runner<'_>, now: f64) -> Option<Fit> {
    let (s, p) = (best.screened, &best.screened.proposal);
    let is_kept = best.left < (1.0 - KEPT * s.explained) * now;
    if is_kept || s.explained < MUCH || p.amplitudes.is_empty() || p.amplitudes.len() == p.added.len() {
        return None;
    }
    let stand = view.stand.extended(&p.model, &p.quiet(&s.start));
    let mut held = stand.placed(&p.model);
    let sizes = p.amplitude_numbers();
    for (number, own) in held.parameters.iter_mut().enumerate() {
        let is_shape = !sizes.contains(&number) && p.added.iter().any(|a| a.name == own.name);
        own.fit &= !is_shape;
    }
    let sized = walk(bench, &held, stand.initials, HEATS[0], view)?;
    walk(bench, &Stand::of(&sized).placed(&p.model), sized.starts(), HEATS[1], view)
}

/// The largest fall of ln Σe² in a sorted field.
fn fall(field: &[Runner<'_>], now: f64) -> f64 {
    field.first().map_or(0.0, |r| (now / r.left).ln())
}

/// How many of a sorted field fall by a share of the largest fall.
fn ahead(field: &[Runner<'_>], now: f64, share: f64) -> usize {
    let least = share * fall(field, now);
    field.iter().take_while(|r| (now / r.left).ln() >= least).count()
}

/// The likeliest to first order that another recording could confirm, where it stands behind those that are fitted to the
/// end and yet lowers what is left.
fn likelier_behind(field: &[Runner<'_>], last: usize, now: f64) -> Option<usize> {
    let statistic = |i: &usize| field[*i].screened.score.statistic;
    let lasting = (0..field.len()).filter(|i| !is_anchored(&field[*i].screened.proposal));
    let likeliest = lasting.max_by(|a, b| statistic(a).total_cmp(&statistic(b)))?;
    (likeliest >= last && (now / field[likeliest].left).ln() > floor(0.0)).then_some(likeliest)
}

/// The likeliest to first order of those with fewer parameters than any that is fitted to the end, and the rest. They may
/// need more steps than the heats give, where the parameters of the model as given must come back from where the effect had
/// drawn them, and would then do with less.
fn simpler<'s>(field: &[Runner<'s>], others: Vec<Runner<'s>>) -> (Vec<Runner<'s>>, Vec<Runner<'s>>) {
    let size = |r: &Runner<'_>| r.screened.proposal.added.len();
    let statistic = |r: &Runner<'_>| r.screened.score.statistic;
    let fewest = field.iter().map(size).min().unwrap_or(0);
    let largest = field.iter().map(statistic).fold(0.0, f64::max);
    let is_rival = |r: &Runner<'_>| {
        let is_like = statistic(r) > SIMPLER * largest && !is_anchored(&r.screened.proposal);
        is_like && (1..fewest).contains(&size(r))
    };
    let (mut rivals, mut rest): (Vec<_>, Vec<_>) = others.into_iter().partition(is_rival);
    rivals.sort_by(|a, b| statistic(b).total_cmp(&statistic(a)));
    rest.extend(rivals.split_off(RIVALS.min(rivals.len())));
    (rivals, rest)
}

fn sort(field: &mut [Runner<'_>]) {
    field.sort_by(|a, b| a.left.total_cmp(&b.left));
}

/// Whether what a proposal lowers is made by how its own states begin, and not by what couples them to the rest: a decay of
/// any shape, which nothing follows.
pub fn begins_alone(p: &Proposal, fit: &Fit, (now, scale): (f64, &Scale)) -> bool {
    let may_begin = |s: &State| matches!(s.initial, Initial::Fit) && p.states.contains(&s.name);
    if p.amplitudes.is_empty() || !p.model.states.iter().any(may_begin) {
        return false;
    }
    let is_size = |name: &str| p.amplitudes.iter().any(|k| p.added[*k].name == name);
    made_by(fit, &is_size, scale) < COUPLED * (now - scale.squares(fit))
}

/// A few rough steps.
pub fn walk(bench: &Bench, model: &Model, initials: Vec<Vec<f64>>, steps: usize, view: &View) -> Option<Fit> {
    let mut options = bench.options(Effort::Near, steps);
    options.tolerance = view.tolerance;
    options.planned.clone_from(&view.planned);
    options.is_rough = true;
    options.initials = initials;
    options.budget = bench.runs(SPENT[0]);
    fit(model, &bench.recordings, &options).ok()
}

/// A law that only replaces another has no size to start small from: it is sought from all starts.
pub fn to_the_end(bench: &Bench, p: &Proposal, heat: &Fit, budget: &Budget) -> Option<Fit> {
    let mut options = if p.added.is_empty() {
        bench.options(Effort::Full, 60)
    } else {
        bench.options(Effort::Near, bench.steps(&heat.model))
    };
    options.initials = heat.starts();
    options.budget = budget.clone();
    fit(&heat.model, &bench.recordings, &options).ok()
}
