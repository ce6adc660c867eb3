//! The same law of other parameters and at other places, fitted beside the likeliest.
//!
//! # Purpose
//! Few proposals of one code are fitted, and none that moves the outputs as another does to first order. That is no
//! reason to name the one that was: where a change of R and one of C explain the same, both must stand.
//!
//! # Method
//! Where the likeliest of a round is a law of a parameter, those of the same law at other parameters whose score is
//! of its size are fitted too, and the same parameter with another form of the law; where it is none of a parameter, the
//! same law at other places whose score is the same but for a little, such as a delay of the output beside that of an
//! input. Whether they fit as well is then told by their likelihoods.
//! Where a law has a finer form, such as friction that turns over within a range of speeds, or one of which it is the special
//! case has, that is fitted too: what the coarse one leaves would be taken for something else.

use super::bench::Bench;
use super::beside::CASES;
use super::catalogue::{self, Proposal, Scene, SiteKind};
use super::choose::are_late;
use super::propose::{Screened, Screening, explaining};
use super::search::Refitted;
use super::view::View;

/// Share of its score from which on another is fitted too.
const NEAR: f64 = 0.5;
/// The same for a law at another place that is no parameter.
const NEARLY: f64 = 0.9;
/// How many at most.
const MOST: usize = 9;

/// The proposals that may be twins of the likeliest of those fitted, and were not fitted.
pub fn twins<'s>(screening: &'s Screening, fitted: &[Refitted]) -> Vec<&'s Screened> {
    let Some(best) = likeliest(fitted) else { return Vec::new() };
    let is_change = best.site.kind == SiteKind::Parameter;
    let is = |a: &Proposal, b: &Proposal| {
        a.code == b.code && a.site == b.site && a.depends == b.depends && a.term == b.term
    };
    let own = screening.screened.iter().find(|s| is(&s.proposal, best)).map_or(0.0, |s| s.score.chi2);
    let alike = |s: &&Screened| {
        let p = &s.proposal;
        let may_be = if is_change {
            p.depends == best.depends && s.score.chi2 >= NEAR * own
        } else {
            p.site != best.site && s.score.chi2 >= NEARLY * own
        };
        (p.code == best.code || are_late(p, best)) && may_be && !fitted.iter().any(|r| is(&r.proposal, p))
    };
    screening.screened.iter().filter(alike).take(MOST).collect()
}

/// The finer forms of the likeliest of those fitted, or of its special case, at its site, in the order of the catalogue: the
/// next is for what runs into the bound of the one before.
pub fn finer(bench: &Bench, scene: &Scene, view: &View, fitted: &[Refitted]) -> Vec<Screened> {
    let Some(best) = likeliest(fitted) else { return Vec::new() };
    let case = CASES.iter().find(|c| c.0 == best.code).map_or(best.code, |c| c.1);
    let asked = catalogue::ALL.iter().filter(|m| m.code == case);
    let is_finer = |p: &Proposal| p.refines && p.site == best.site && p.depends == best.depends;
    let proposed: Vec<Proposal> = asked.flat_map(|m| (m.propose)(scene)).filter(is_finer).collect();
    proposed.into_iter().flat_map(|p| explaining(bench, view, vec![p])).collect()
}

fn likeliest(fitted: &[Refitted]) -> Option<&Proposal> {
    let likelier = |a: &&Refitted, b: &&Refitted| a.measure.likelihood.total_cmp(&b.measure.likelihood);
    fitted.iter().max_by(likelier).map(|r| &r.proposal)
}
