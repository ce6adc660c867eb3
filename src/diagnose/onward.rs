//! Which proposals of a race go on.
//!
//! # Purpose
//! A race is over sooner where what cannot be chosen in the end goes no further, and is fair where nothing is left behind for
//! what its few steps have not reached yet.
//!
//! # Method
//! A field is sorted by what each leaves of the squares. Behind those that lower it by a share of the largest fall go on: the
//! likeliest to first order; those as likely as any, whose sensitivities promise as large a fall; at the beginning of a search
//! those that are nearly as likely to first order with fewer parameters. None goes on that is plainly less likely.

use super::choose::{MUCH, PLAINLY, RIVAL, TIE, floor, is_anchored};
use super::measure::{Measure, Scale, promised};
use super::propose::Screened;
use crate::estimate::Fit;
use rayon::prelude::*;

/// Proposals that the second heat takes.
const SECOND: usize = 12;
/// Share of the largest fall of ln Σe² in the first heat from which on a proposal takes part in the second, and in
/// both from which on it is fitted to the end. None with less than RIVAL of it can be chosen.
const FAIR: [f64; 2] = [0.25, 0.6];
/// Proposals that are fitted to the end at most, and at least: where one plainly lowers what is left, and else.
pub const LAST: (usize, [usize; 2]) = (8, [3, 6]);
/// How many more that are as likely.
const MORE: usize = 4;
/// How many begin the first heat at least: the most likely to first order, and as many of those that explain most. Where the
/// best of them plainly lowers what is left, none follows whose likelihood is less than a share of the largest and which
/// explains less to first order than a share of that fall, both as logarithms. What was named on twenty recordings of strangers
/// foretold 0.18 of it and more.
const BEGIN: usize = 6;
const FOLLOWS: (f64, f64) = (0.5, 0.1);
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

/// A proposal with its fit so far, and what that leaves.
pub struct Runner<'s> {
    /// The proposal.
    pub screened: &'s Screened,
    /// Its fit so far.
    pub fit: Fit,
    /// The squares that it leaves, weighed.
    pub left: f64,
    /// Whether its steps were spent.
    pub is_cut: bool,
}

impl<'s> Runner<'s> {
    /// A proposal and a fit of it.
    pub fn new(screened: &'s Screened, fit: Fit, scale: &Scale) -> Self {
        let (left, is_cut) = (scale.squares(&fit), fit.ended_early.is_some());
        Self { screened, fit, left, is_cut }
    }

    /// The better of two, which is cut where one of them was.
    pub fn or(self, other: Self) -> Self {
        let is_cut = self.is_cut || other.is_cut;
        Self { is_cut, ..if other.left.total_cmp(&self.left).is_lt() { other } else { self } }
    }
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

/// Those that begin the first heat, and the others.
pub fn begin<'s>(chosen: &[&'s Screened], by: By) -> (Vec<&'s Screened>, Vec<&'s Screened>) {
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
pub fn may_follow(s: &Screened, begun: &[&Screened], fall: f64) -> bool {
    let largest = begun.iter().map(|b| b.score.statistic).fold(0.0, f64::max);
    let foretold = -(1.0 - s.explained.clamp(0.0, 1.0)).ln();
    fall < MUCH || foretold >= FOLLOWS.1 * fall || s.score.statistic >= FOLLOWS.0 * largest
}

/// A sorted field parted into those that take part in the second heat, and the others.
pub fn for_second<'s>(
    mut field: Vec<Runner<'s>>,
    against: Against<'_>,
) -> (Vec<Runner<'s>>, Vec<Runner<'s>>) {
    let now = against.squares;
    let is_plain = fall(&field, now) > MUCH;
    let on = if is_plain { ahead(&field, now, FAIR[0]).max(LAST.1[0]) } else { SECOND };
    let mut rest = field.split_off(on.min(SECOND).min(field.len()));
    let (field, unlikely) = going_on(field, against, 0);
    rest.extend(unlikely);
    sort(&mut rest);
    (field, rest)
}

/// A sorted field parted into those that are fitted to the end, and the others; the first search of a diagnosis asks for
/// simpler ones too.
pub fn finalists<'s>(
    mut field: Vec<Runner<'s>>,
    against: Against<'_>,
    is_first: bool,
) -> (Vec<Runner<'s>>, Vec<Runner<'s>>) {
    let now = against.squares;
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
    if matches!(against.by, By::Likelihood(_)) {
        let (as_good, rest) = as_good(&field, others, against);
        field.extend(as_good);
        others = rest;
    }
    if is_first {
        let (simpler, rest) = simpler(&field, others);
        field.extend(simpler);
        others = rest;
    }
    (field, others)
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

/// The largest fall of ln Σe² in a sorted field.
pub fn fall(field: &[Runner<'_>], now: f64) -> f64 {
    field.first().map_or(0.0, |r| (now / r.left).ln())
}

/// How many of a sorted field fall by a share of the largest fall.
fn ahead(field: &[Runner<'_>], now: f64, share: f64) -> usize {
    let least = share * fall(field, now);
    field.iter().take_while(|r| (now / r.left).ln() >= least).count()
}

/// Those of the others that are as likely as any of a sorted field and promise to come as far, and the rest. Where noise is
/// slow the steps of a heat, by likelihood, leave a level that the free run minds.
fn as_good<'s>(
    field: &[Runner<'s>],
    others: Vec<Runner<'s>>,
    against: Against<'_>,
) -> (Vec<Runner<'s>>, Vec<Runner<'s>>) {
    let Against { squares: now, scale, .. } = against;
    let least = FAIR[1] * fall(field, now);
    let likelihood = |r: &Runner<'_>| Measure::of(&r.fit, scale).likelihood;
    let likeliest = field.par_iter().map(likelihood).reduce(|| f64::NEG_INFINITY, f64::max);
    let is_good =
        |r: &Runner<'_>| (now / promised(&r.fit, scale)).ln() >= least && likelihood(r) >= likeliest - TIE;
    let (mut good, mut rest): (Vec<_>, Vec<_>) = others.into_par_iter().partition(is_good);
    good.sort_by(|a, b| likelihood(b).total_cmp(&likelihood(a)));
    rest.extend(good.split_off(MORE.min(good.len())));
    (good, rest)
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

pub fn sort(field: &mut [Runner<'_>]) {
    field.sort_by(|a, b| a.left.total_cmp(&b.left));
}
