//! The race: proposals fitted inside the model, those that fall behind given up early.
//!
//! # Purpose
//! A fit by simulation is what a diagnosis spends its time in. Most proposals show after a few steps
//! that another lowers the free-run error by far more, and then need no more steps.
//!
//! # Method
//! Two heats: a few steps from the best starts of each proposal, with a solver as rough as the residual
//! that the model leaves now allows; a few more for the better half. Those whose sum of squares then
//! falls by a fair share of the largest fall, as logarithms, are fitted to the end.
//!
//! # References
//! O. Maron, A. W. Moore, Artificial Intelligence Review 11 (1997) 193 (racing).

use super::bench::Bench;
use super::propose::{Screened, View, starts};
use crate::estimate::fit::Effort;
use crate::estimate::{Fit, fit};
use crate::model::Model;
use rayon::prelude::*;

/// Steps of the two heats.
const HEATS: [usize; 2] = [3, 5];
/// Proposals that the second heat takes.
const SECOND: usize = 12;
/// Share of the largest fall of ln Σe² in the heats from which on a proposal is fitted to the end.
const FAIR: f64 = 0.5;
/// Proposals that are fitted to the end at least, and at most.
const LAST: (usize, usize) = (6, 8);

/// A proposal with its fit so far.
type Runner<'s> = (&'s Screened, Fit);

/// Fits proposals, the best of them to the end.
pub fn run(
    bench: &Bench,
    current: &Fit,
    view: &View,
    given: &[f64],
    chosen: &[&Screened],
) -> Vec<(Screened, Fit)> {
    let first = |s: &Screened| -> Option<Fit> {
        let walks = starts(bench, view, given, s).into_iter().filter_map(|stand| {
            walk(bench, &stand.placed(&s.proposal.model), stand.initials, HEATS[0], view.tolerance)
        });
        walks.min_by(|a, b| a.sum_of_squares.total_cmp(&b.sum_of_squares))
    };
    let mut field: Vec<Runner<'_>> =
        chosen.par_iter().with_max_len(1).filter_map(|s| Some((*s, first(s)?))).collect();
    sort(&mut field);
    field.truncate(SECOND);
    field.par_iter_mut().with_max_len(1).for_each(|(_, f)| {
        let longer = walk(bench, &f.model, f.starts(), HEATS[1], view.tolerance);
        if let Some(longer) = longer.filter(|l| l.sum_of_squares < f.sum_of_squares) {
            *f = longer;
        }
    });
    sort(&mut field);
    let fall = |f: &Fit| (current.sum_of_squares / f.sum_of_squares).ln();
    let largest = field.first().map_or(0.0, |h| fall(&h.1));
    let last = field.iter().enumerate().take(LAST.1);
    let last: Vec<&Runner<'_>> =
        last.filter(|(i, h)| *i < LAST.0 || fall(&h.1) >= FAIR * largest).map(|(_, h)| h).collect();
    last.into_par_iter()
        .with_max_len(1)
        .filter_map(|(s, f)| Some(((*s).clone(), to_the_end(bench, s, f)?)))
        .collect()
}

fn sort(field: &mut [Runner<'_>]) {
    field.sort_by(|a, b| a.1.sum_of_squares.total_cmp(&b.1.sum_of_squares));
}

/// A few rough steps.
fn walk(bench: &Bench, model: &Model, initials: Vec<Vec<f64>>, steps: usize, tolerance: f64) -> Option<Fit> {
    let mut options = bench.options(Effort::Near, steps);
    options.tolerance = tolerance;
    options.is_rough = true;
    options.initials = initials;
    fit(model, &bench.recordings, &options).ok()
}

/// A law that only replaces another has no size to start small from: it is sought from all starts.
fn to_the_end(bench: &Bench, s: &Screened, heat: &Fit) -> Option<Fit> {
    let mut options = if s.proposal.added.is_empty() {
        bench.options(Effort::Full, 60)
    } else {
        bench.options(Effort::Near, bench.steps(&heat.model))
    };
    options.initials = heat.starts();
    fit(&heat.model, &bench.recordings, &options).ok()
}
