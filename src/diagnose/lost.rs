//! What is fitted all the same where the model as given is lost.
//!
//! # Purpose
//! Where a spring or a loss is forgotten that holds all together, the fit of the model as given ends wherever the
//! squares are least bad: a mass at its bound, a damping that stands for the spring. What a law would do there, in a
//! straight line from there, says nothing of what it does where the model is right.
//!
//! # Method
//! A model is lost where it leaves more of an output than half of what that moves about its mean. Then each force or flow
//! of one unknown is fitted, whatever its score; what gains nothing ends early in the race.
//!
//! # References
//! L. Ljung, System Identification, 2nd ed. (1999), 16.4 (a model that explains less than the mean does).

use super::bench::Bench;
use super::catalogue::SiteKind;
use super::propose::{Screened, Screening};
use crate::estimate::Fit;

/// Share of what an output moves from which on a model that leaves it is lost.
const LOST: f64 = 0.5;

/// The simple laws that are fitted beside the chosen ones, where a fitted model is lost.
pub fn simple<'a>(
    bench: &Bench,
    current: &Fit,
    screening: &'a Screening,
    chosen: &[&Screened],
) -> Vec<&'a Screened> {
    let mut outputs = current.model.outputs.iter().zip(&current.rmse);
    let is_lost = outputs.any(|(o, e)| *e > LOST * bench.spread(&o.name));
    let is_simple = |s: &&Screened| {
        let p = &s.proposal;
        p.site.kind == SiteKind::State && p.added.len() == 1 && p.amplitudes.len() == 1 && p.states.is_empty()
    };
    let is_there = |s: &Screened| chosen.iter().any(|c| c.proposal.term == s.proposal.term);
    screening.screened.iter().filter(|s| is_lost && is_simple(s) && !is_there(s)).collect()
}
