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
use super::choose::MUCH;
use super::foretold::Foretold;
use super::measure::{Scale, made_by};
pub use super::onward::{Against, By};
use super::onward::{LAST, Runner, begin, fall, finalists, for_second, may_follow, sort};
use super::propose::{Screened, starts};
use super::view::View;
use crate::estimate::fit::{Effort, Progress};
use crate::estimate::{Fit, fit};
use crate::model::{Initial, Model, State};
use crate::simulate::Budget;
use rayon::prelude::*;

/// Steps of the two heats.
const HEATS: [usize; 2] = [3, 5];
/// Share of what a proposal's direction foretells that its first heat must keep.
const KEPT: f64 = 0.5;
/// Share of what a proposal lowers that its sizes must make, where its own states may begin anywhere.
const COUPLED: f64 = 0.01;
/// Runs, as long as those of the model as given, that a heat and a last fit may spend. One with more sensitivities, events
/// or shorter steps counts as several.
const SPENT: [u64; 2] = [100, 100];
/// Parts of the steps that are left, times the proposals beside each other, of which a heat and a last fit may spend one.
const SHARES: [usize; 2] = [4, 3];
/// Runs that the heats of a proposal take, about, and as many its last fit.
const RUNS: usize = 20;

/// A proposal as the race leaves it.
pub struct Finished {
    /// The proposal.
    pub proposal: Proposal,
    /// Its fit, or the best so far.
    pub fit: Fit,
    /// Whether it was ended by its own steps or the time before it was through.
    pub is_cut: bool,
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
    if chosen.is_empty() {
        return Vec::new();
    }
    bench.budget.begin("heats");
    let stage = format!("fitting the {} likeliest of them", chosen.len());
    let foretold = Foretold::begin(bench, progress, &stage, RUNS * (chosen.len() + LAST.1[0]));
    let heated = bench.sharing(SHARES[0] * chosen.len());
    let field = heats(&heated, view, given, (chosen, &foretold), against);
    let is_first = view.stand.parameters.len() == bench.own_parameters;
    let (field, mut others) = finalists(field, against, is_first);
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
    let (field, rest) = for_second(field, against);
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
