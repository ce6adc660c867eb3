//! What was tried at which site, and how it scored.

use super::{Standing, Tried};
use crate::diagnose::answer::SiteName;
use crate::diagnose::catalogue::Proposal;
use crate::diagnose::search::Found;

/// Lines of the table.
const MOST: usize = 16;

/// The best-scored places of each mechanism, likeliest first; what was found always stands among them.
pub fn tried(found: &Found) -> Vec<Tried> {
    let mut all: Vec<Tried> = Vec::new();
    for s in &found.first.screened {
        let p = &s.proposal;
        let one = Tried {
            code: p.code.to_string(),
            site: SiteName { kind: p.site.kind.word().to_string(), name: p.site.name.clone() },
            score: s.score.statistic,
            standing: standing(found, p),
        };
        let seen = all.iter().any(|t| t.code == one.code && t.site == one.site);
        if !seen && (all.len() < MOST || one.standing != Standing::Dropped) {
            all.push(one);
        }
    }
    all
}

fn standing(found: &Found, p: &Proposal) -> Standing {
    let same = |q: &Proposal| q.code == p.code && q.site == p.site;
    if found.taken.iter().any(|t| same(&t.proposal)) {
        Standing::Found
    } else if found.taken.iter().any(|t| t.ties.iter().chain(&t.elsewhere).any(same)) {
        Standing::Tie
    } else {
        Standing::Dropped
    }
}
