//! The race: proposals fitted inside the model, those that fall behind given up early.
//!
//! # Purpose
//! A fit by simulation is what a diagnosis spends its time in. Most proposals show after a few steps
//! that another lowers the free-run error by far more, and then need no more steps.
//!
//! # Method
//! Heats: a few steps from the best starts of each proposal, with a solver as rough as the residual
//! that the model leaves now allows. Those whose sum of squares falls by a fair share of the largest
//! fall, as logarithms, are fitted to the end.
//!
//! # References
//! O. Maron, A. W. Moore, Artificial Intelligence Review 11 (1997) 193 (racing).

use super::bench::{Bench, Stand};
use super::propose::{Screened, View, starts};
use crate::estimate::fit::Effort;
use crate::estimate::{Fit, fit};
use rayon::prelude::*;

/// Steps of a heat.
const HEAT: usize = 6;
/// Share of the largest fall of ln Σe² in the heats from which on a proposal is fitted to the end.
const FAIR: f64 = 0.5;
/// Proposals that are fitted to the end at least, and at most.
const LAST: (usize, usize) = (6, 8);

/// Fits proposals, the best of them to the end.
pub fn run(
    bench: &Bench,
    current: &Fit,
    view: &View,
    given: &[f64],
    chosen: &[&Screened],
) -> Vec<(Screened, Fit)> {
    let mut heats: Vec<(&Screened, Fit)> = chosen
        .par_iter()
        .with_max_len(1)
        .filter_map(|s| Some((*s, heat(bench, view.tolerance, &starts(bench, view, given, s), s)?)))
        .collect();
    heats.sort_by(|a, b| a.1.sum_of_squares.total_cmp(&b.1.sum_of_squares));
    let fall = |f: &Fit| (current.sum_of_squares / f.sum_of_squares).ln();
    let largest = heats.first().map_or(0.0, |h| fall(&h.1));
    let last = heats.iter().enumerate().take(LAST.1);
    let last: Vec<&(&Screened, Fit)> =
        last.filter(|(i, h)| *i < LAST.0 || fall(&h.1) >= FAIR * largest).map(|(_, h)| h).collect();
    last.into_par_iter()
        .with_max_len(1)
        .filter_map(|(s, f)| Some(((*s).clone(), to_the_end(bench, f)?)))
        .collect()
}

/// A few steps from each start; the best.
fn heat(bench: &Bench, tolerance: f64, starts: &[Stand], s: &Screened) -> Option<Fit> {
    let walks = starts.iter().filter_map(|stand| {
        let mut options = bench.options(Effort::Near, HEAT);
        options.tolerance = tolerance;
        options.is_rough = true;
        options.initials.clone_from(&stand.initials);
        fit(&stand.placed(&s.proposal.model), &bench.recordings, &options).ok()
    });
    walks.min_by(|a, b| a.sum_of_squares.total_cmp(&b.sum_of_squares))
}

fn to_the_end(bench: &Bench, heat: &Fit) -> Option<Fit> {
    let mut options = bench.options(Effort::Near, bench.steps(&heat.model));
    options.initials = heat.records.iter().map(|r| r.initials.clone()).collect();
    fit(&heat.model, &bench.recordings, &options).ok()
}
