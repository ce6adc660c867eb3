//! The same change of other parameters, fitted beside the likeliest.
//!
//! # Purpose
//! Few proposals of one code are fitted, and none that moves the outputs as another does to first order. That is no
//! reason to name the one that was: where a change of R and one of C explain the same, both must stand.
//!
//! # Method
//! Where the likeliest of a round is a law of a parameter, those of the same law at other parameters whose score is
//! of its size are fitted too, and the same parameter with another form of the law. Whether they fit as well is then told by their likelihoods.

use super::catalogue::{Proposal, SiteKind};
use super::propose::{Screened, Screening};
use super::search::Refitted;

/// Share of its score from which on another is fitted too.
const NEAR: f64 = 0.5;
/// How many at most.
const MOST: usize = 6;

/// The proposals that may be twins of the likeliest of those fitted, and were not fitted.
pub fn twins<'s>(screening: &'s Screening, fitted: &[Refitted]) -> Vec<&'s Screened> {
    let likelier = |a: &&Refitted, b: &&Refitted| a.measure.likelihood.total_cmp(&b.measure.likelihood);
    let Some(best) = fitted.iter().max_by(likelier).map(|r| &r.proposal) else { return Vec::new() };
    if best.site.kind != SiteKind::Parameter {
        return Vec::new();
    }
    let is = |a: &Proposal, b: &Proposal| {
        a.code == b.code && a.site == b.site && a.depends == b.depends && a.term == b.term
    };
    let own = screening.screened.iter().find(|s| is(&s.proposal, best)).map_or(0.0, |s| s.score.chi2);
    let alike = |s: &&Screened| {
        let p = &s.proposal;
        p.code == best.code
            && p.depends == best.depends
            && s.score.chi2 >= NEAR * own
            && !fitted.iter().any(|r| is(&r.proposal, p))
    };
    screening.screened.iter().filter(alike).take(MOST).collect()
}
