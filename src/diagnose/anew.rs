//! Laws of time, asked of a recording that was held out apart and begins anew.
//!
//! # Purpose
//! What warms up, fouls or runs down after every start is a law of time that another recording can confirm; what
//! happened once is none.
//!
//! # Method
//! Both recordings count their time as they were given it; of what begins at a moment, the other lies before it or after it
//! (`moments`). A law of time stands where it lowers the error of what was held out by a good part of what it lowers that of
//! what was fitted, and further than any law does that lasts; else it is as if it had not been tried.

use super::bench::Bench;
use super::choose::is_anchored;
use super::prove::{Held, held_out};
use super::search::Round;
use crate::estimate::Fit;
use crate::record::Recording;
use rayon::prelude::*;

/// Share of the logarithm of the fitted error's fall that the held-out one must show.
const PART: f64 = 1.0 / 3.0;

/// Leaves out of a round the laws of time that recordings held out apart do not confirm.
pub fn keep_confirmed(bench: &Bench, separate: &[Recording], current: &Fit, round: &mut Round) {
    if !bench.separate || !round.fitted.iter().any(|r| is_anchored(&r.proposal)) {
        return;
    }
    let errors = |fit: &Fit| -> Option<Vec<f64>> {
        let held = held_out(bench, fit, separate).ok()?;
        held.iter().all(Held::is_finite).then(|| held.iter().map(Held::rmse).collect())
    };
    let Some(before) = errors(current) else { return };
    let fall = |before: &[f64], after: &[f64]| -> f64 {
        let falls = before.iter().zip(after).map(|(b, a)| (b / a).ln());
        falls.filter(|x| x.is_finite()).sum()
    };
    // what cannot be run there is no rival
    let lasting: Vec<Vec<f64>> = round
        .fitted
        .par_iter()
        .filter(|r| !is_anchored(&r.proposal))
        .filter_map(|r| errors(&r.fit))
        .collect();
    let is_confirmed = |fit: &Fit| {
        errors(fit).is_some_and(|after| {
            let shows = fall(&before, &after) >= PART * fall(&current.rmse, &fit.rmse);
            shows && lasting.iter().all(|other| fall(other, &after) > 0.0)
        })
    };
    round.fitted.retain(|r| !is_anchored(&r.proposal) || is_confirmed(&r.fit));
}
