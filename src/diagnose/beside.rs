//! What may stand in a finding's place, asked once more beside all that was found.
//!
//! # Purpose
//! What is found first has to follow what is found later, too: a constant beside friction that is still missing drifts,
//! and laws that the data part fit alike while another effect is as large as what parts them.
//!
//! # Method
//! Once all is found, each finding's special case, its other forms, those that fitted as well as it when it was
//! taken, or lowered the error nearly as much, and the same at another place that still gains, are fitted in its place, beside
//! the others; so is the latter where there is but one finding. Of those that lower the error
//! of blocks left out by nearly as much as any, the one that is worth most stands there, a special case also where it is
//! worth as much; of the others those that still fit as well are its ties.

use super::backward;
use super::bench::Bench;
use super::catalogue::{self, Proposal, SiteKind};
use super::choose::{self, RIVAL, gain, is_elsewhere, worth_of};
use super::inert;
use super::measure::Measure;
use super::propose::{Screened, explaining};
use super::race::{self, Against, By, Finished};
use super::search::{Found, Taken, is_over, is_pressed};
use super::view::View;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;
use crate::record::Recording;

/// Mechanisms, and what each is where one of its parameters is 0, or what it follows while something else is missing.
pub const CASES: [(&str, &str); 5] = [
    ("drift-force", "constant-force"),
    ("output-drift", "output-offset"),
    ("asymmetric-friction", "dry-friction"),
    ("stribeck-friction", "dry-friction"),
    ("saturable-rate", "dry-friction"),
];

/// Mechanisms that have several forms of one law at a place that is no parameter.
const FORMS: [&str; 4] = ["dry-friction", "cross-coupling", "input-square", "output-square"];

/// Others that are fitted in the place of a finding, at most.
const MOST: usize = 6;

/// Settles what stands in the place of each of several findings, and drops what that makes needless.
pub fn settle(bench: &Bench, separate: &[Recording], found: &mut Found, progress: &dyn Progress) {
    let replaced = pass(bench, found, found.taken.len(), progress);
    if let Some(last) = replaced {
        // those before it were asked while another stood there
        pass(bench, found, last, progress);
    }
    if replaced.is_some() {
        // what was left beside others
        found.small = None;
        backward::stand(bench, separate, found);
    }
}

/// Settles what stands in the place of each of the first findings; the last in whose place another stands now.
fn pass(bench: &Bench, found: &mut Found, first: usize, progress: &dyn Progress) -> Option<usize> {
    let mut replaced = None;
    for i in 0..first {
        let Taken { proposal, others, .. } = &found.taken[i];
        let may_be_elsewhere = others.iter().any(|o| is_elsewhere(proposal, o));
        if found.taken.len() < 2 && !may_be_elsewhere || is_over(bench) {
            break;
        }
        if settled(bench, found, i, progress).unwrap_or(false) {
            // what stands in the place of the next one stands beside this
            found.without = backward::each(bench, found);
            replaced = Some(i);
        }
    }
    replaced
}

/// Whether another takes the place of a finding; its ties are those that still fit as well.
fn settled(bench: &Bench, found: &mut Found, i: usize, progress: &dyn Progress) -> Option<bool> {
    let finished = others(bench, found, i, progress)?;
    let Taken { proposal: own, p_value, tried, elsewhere, ties: tied, others, .. } = found.taken[i].clone();
    let scale = &found.scale;
    let base = Measure::of(&found.without.get(i)?.as_ref()?.0, scale);
    let mut all = vec![Finished { proposal: own.clone(), fit: found.last.clone(), is_cut: false }];
    let (cut, whole): (Vec<Finished>, Vec<Finished>) = finished.into_iter().partition(|f| f.is_cut);
    let was_tied = |p: &Proposal| found.taken[i].ties.iter().any(|t| (t.code, &t.site) == (p.code, &p.site));
    let unsettled: Vec<Proposal> = cut.into_iter().map(|f| f.proposal).filter(was_tied).collect();
    all.extend(whole.into_iter().filter(|f| !is_pressed(&f.proposal, &f.fit)));
    let measures: Vec<Measure> = all.iter().map(|f| Measure::of(&f.fit, scale)).collect();
    let worth = |k: usize| worth_of(&all[k].proposal, &measures[k]);
    let falls = |k: usize| gain(&base, &measures[k]);
    let largest = (0..all.len()).map(falls).fold(0.0, f64::max);
    let rivals: Vec<usize> = (0..all.len()).filter(|k| falls(*k) >= RIVAL * largest).collect();
    let is_case = |k: &usize| CASES.contains(&(own.code, all[*k].proposal.code)) && worth(*k) >= worth(0);
    let most = rivals.iter().copied().rev().max_by(|a, b| worth(*a).total_cmp(&worth(*b)))?;
    let cases = (1..all.len()).filter(is_case);
    let best = cases.max_by(|a, b| worth(*a).total_cmp(&worth(*b))).unwrap_or(most);
    // the same change of another parameter is as good a name though blocks left out may like it less
    let is_other = |k: usize| {
        let (p, q) = (&all[k].proposal, &all[best].proposal);
        p.site.kind == SiteKind::Parameter && is_elsewhere(p, q)
    };
    let fits_as_well = |k: &usize| {
        let of = |k: usize| (&all[k].proposal, &measures[k]);
        let may = rivals.contains(k) || is_other(*k);
        *k != best && may && choose::alike(of(*k), of(best), &base)
    };
    let named = &all[best].proposal;
    let is_another = |k: &usize| (all[*k].proposal.code, &all[*k].proposal.site) != (named.code, &named.site);
    let near: Vec<usize> = (0..all.len()).filter(fits_as_well).filter(is_another).collect();
    let mut ties: Vec<Proposal> = near.iter().map(|k| all[*k].proposal.clone()).collect();
    ties.extend(unsettled);
    let rivals = near.first().map(|k| Box::new((all[best].fit.clone(), all[*k].fit.clone())));
    let elsewhere = if best == 0 { elsewhere } else { Vec::new() };
    let chosen = all.swap_remove(best);
    let stands = |p: &Proposal| {
        let mut standing = ties.iter().chain([&chosen.proposal]);
        standing.any(|q| (q.code, &q.site) == (p.code, &p.site))
    };
    let others = tied.into_iter().chain(others).filter(|p| !stands(p)).collect();
    let taken = Taken { proposal: chosen.proposal, p_value, tried, ties, elsewhere, others, rivals };
    found.replaces(i, taken, chosen.fit);
    Some(best != 0)
}

/// The special case of a finding, its other forms, and those that fitted as well as it, fitted in its place beside the
/// others; none where it has none.
fn others(bench: &Bench, found: &Found, i: usize, progress: &dyn Progress) -> Option<Vec<Finished>> {
    let Taken { proposal: own, ties, others, .. } = &found.taken[i];
    let case = CASES.iter().find(|(code, _)| *code == own.code).map(|(_, case)| (*case, &own.site));
    // elsewhere it was a law of what the finding leaves of its signals
    let law = |t: &Proposal| (!is_elsewhere(own, t)).then(|| t.law_of());
    let tied = ties.iter().chain(others).map(|t| (t.code, &t.site, law(t)));
    let wanted: Vec<_> = case.into_iter().map(|(code, site)| (code, site, None)).chain(tied).collect();
    let (with, _) = found.without.get(i)?.as_ref()?;
    let may_have_forms = own.site.kind == SiteKind::Parameter || FORMS.contains(&own.code);
    if wanted.is_empty() && !may_have_forms {
        return None;
    }
    // what the finding has left of itself would forbid what acts in its place
    let base = &inert::bare(with, bench.own_parameters);
    let place = placed(bench, base, &found.last);
    let view = View::of(bench, place.as_ref().unwrap_or(base)).ok()?;
    let scene = bench.scene(&base.model, &view.stand).ok()?;
    // a law of the same signals and the same parameter, whatever its own parameters are called
    let is_form = |p: &Proposal| {
        may_have_forms
            && (p.code, &p.site, p.law_of()) == (own.code, &own.site, own.law_of())
            && p.says != own.says
    };
    let is_wanted = |p: &Proposal| {
        let is = |law: &Option<Vec<String>>| law.as_ref().is_none_or(|law| *law == p.law_of());
        is_form(p) || wanted.iter().any(|(code, site, law)| (*code, *site) == (p.code, &p.site) && is(law))
    };
    let codes: Vec<&str> = wanted.iter().map(|w| w.0).chain([own.code]).collect();
    let asked = catalogue::ALL.iter().filter(|m| codes.contains(&m.code));
    let proposed: Vec<Proposal> = asked.flat_map(|m| (m.propose)(&scene)).filter(is_wanted).collect();
    if proposed.is_empty() {
        return None;
    }
    let mut scored = explaining(bench, &view, proposed);
    let fitted_as_well = |p: &Proposal| ties.iter().any(|t| (t.code, &t.site) == (p.code, &p.site));
    // the form that was fitted goes before others of its law
    let was_fitted = |p: &Proposal| {
        let mut fitted = ties.iter().chain(others);
        fitted.any(|t| (t.code, &t.site, &t.says) == (p.code, &p.site, &p.says))
    };
    scored.sort_by_key(|s| (!fitted_as_well(&s.proposal), !was_fitted(&s.proposal)));
    let mut chosen: Vec<&Screened> = Vec::new();
    for s in &scored {
        let is_same = |c: &&Screened| {
            let of = |p: &Proposal| (p.code, p.site.clone(), p.added.len());
            of(&c.proposal) == of(&s.proposal) && !is_form(&s.proposal)
        };
        if chosen.len() < MOST && !chosen.iter().any(is_same) {
            chosen.push(s);
        }
    }
    let given: Vec<f64> = base.model.parameters.iter().map(|p| p.value).collect();
    let scale = &found.scale;
    let by = By::Likelihood(Measure::of(base, scale).likelihood);
    let against = Against { squares: scale.squares(base), by, scale };
    // a special case never fits better than what it is a case of, and so would not end a race with it
    let is_case = |s: &&Screened| case.is_some_and(|(code, _)| code == s.proposal.code);
    let (cases, rest): (Vec<&Screened>, Vec<&Screened>) = chosen.into_iter().partition(is_case);
    let alone = cases.iter().map(std::slice::from_ref);
    let fields = std::iter::once(&rest[..]).chain(alone);
    Some(fields.flat_map(|field| race::run(bench, &view, &given, field, against, progress)).collect())
}

/// The model of a fit where a larger one has its parameters and beginnings: fitted without a finding, the others may have gone
/// to their bounds, far from where they stand beside what takes its place.
fn placed(bench: &Bench, base: &Fit, last: &Fit) -> Option<Fit> {
    let mut model = base.model.clone();
    // what is held keeps the finding from acting
    for p in model.parameters.iter_mut().filter(|p| p.fit) {
        let own = last.model.parameters.iter().find(|q| q.name == p.name);
        p.value = own.map_or(p.value, |q| q.value);
    }
    backward::fitted_from(bench, &model, last, 0)
}
