//! The race: proposals fitted inside the model, those that fall behind given up early.
//!
//! # Purpose
//! A fit by simulation is what a diagnosis spends its time in. Most proposals show after a few steps
//! that another lowers the free-run error by far more, and then need no more steps. All are compared with
//! every output weighed by what the model leaves of it now: a fit's own weights follow its own residual.
//!
//! # Method
//! Two heats: a few steps from the best starts of each proposal, with a solver as rough as the residual
//! that the model leaves now allows; a few more for the better half. Those whose sum of squares then
//! falls by a fair share of the largest fall, as logarithms, are fitted to the end.
//!
//! # References
//! O. Maron, A. W. Moore, Artificial Intelligence Review 11 (1997) 193 (racing).

use super::bench::Bench;
use super::measure::Scale;
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

/// A proposal with its fit so far, and what that leaves.
struct Runner<'s> {
    screened: &'s Screened,
    fit: Fit,
    left: f64,
}

impl<'s> Runner<'s> {
    fn new(screened: &'s Screened, fit: Fit, scale: &Scale) -> Self {
        let left = scale.squares(&fit);
        Self { screened, fit, left }
    }
}

/// Fits proposals, the best of them to the end.
pub fn run<'s>(
    bench: &Bench,
    view: &View,
    given: &[f64],
    chosen: &[&'s Screened],
    (now, scale): (f64, &Scale),
) -> Vec<(Screened, Fit)> {
    let first = |s: &&'s Screened| {
        let walks = starts(bench, view, given, s, scale).into_iter().filter_map(|stand| {
            walk(bench, &stand.placed(&s.proposal.model), stand.initials, HEATS[0], view.tolerance)
        });
        let runners = walks.map(|fit| Runner::new(s, fit, scale));
        runners.min_by(|a, b| a.left.total_cmp(&b.left))
    };
    let mut field: Vec<Runner<'_>> = chosen.par_iter().with_max_len(1).filter_map(first).collect();
    sort(&mut field);
    field.truncate(SECOND);
    field.par_iter_mut().with_max_len(1).for_each(|r| {
        let longer = walk(bench, &r.fit.model, r.fit.starts(), HEATS[1], view.tolerance);
        let longer = longer.map(|fit| Runner::new(r.screened, fit, scale));
        if let Some(longer) = longer.filter(|l| l.left < r.left) {
            *r = longer;
        }
    });
    sort(&mut field);
    let fall = |r: &Runner<'_>| (now / r.left).ln();
    let largest = field.first().map_or(0.0, fall);
    let last = field.iter().enumerate().take(LAST.1);
    let last: Vec<&Runner<'_>> =
        last.filter(|(i, h)| *i < LAST.0 || fall(h) >= FAIR * largest).map(|(_, h)| h).collect();
    last.into_par_iter()
        .with_max_len(1)
        .filter_map(|r| Some((r.screened.clone(), to_the_end(bench, r.screened, &r.fit)?)))
        .collect()
}

fn sort(field: &mut [Runner<'_>]) {
    field.sort_by(|a, b| a.left.total_cmp(&b.left));
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
