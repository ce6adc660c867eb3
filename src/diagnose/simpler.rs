//! A finding that holds a simpler one, where the simpler one does.
//!
//! What is found first has to follow what is found later, too: a constant beside friction that is still missing drifts.
//! Once all is found, the special case is fitted in its place, and stands there where it is worth as much.

use super::bench::Bench;
use super::catalogue::{self, Proposal};
use super::choose::worth_of;
use super::measure::Measure;
use super::propose::explaining;
use super::race;
use super::search::{Found, Taken, is_over};
use super::view::View;
use crate::estimate::Fit;
use crate::estimate::fit::Progress;

/// Mechanisms, and what each is where one of its parameters is 0.
const CASES: [(&str, &str); 4] = [
    ("drift-force", "constant-force"),
    ("output-drift", "output-offset"),
    ("asymmetric-friction", "dry-friction"),
    ("stribeck-friction", "dry-friction"),
];

/// Puts the special case in the place of each finding of several that has one as good.
pub fn settle(bench: &Bench, found: &mut Found, progress: &dyn Progress) {
    for i in 0..found.taken.len() {
        if found.taken.len() < 2 || is_over(bench) {
            return;
        }
        let Some((proposal, fit)) = simpler(bench, found, i, progress) else { continue };
        let Taken { p_value, tried, .. } = found.taken[i];
        let (ties, elsewhere, rivals) = (Vec::new(), Vec::new(), None);
        found.replaces(i, Taken { proposal, p_value, tried, ties, elsewhere, rivals }, fit);
    }
}

/// The special case in the place of a finding, fitted, where it is worth as much.
fn simpler(bench: &Bench, found: &Found, i: usize, progress: &dyn Progress) -> Option<(Proposal, Fit)> {
    let own = &found.taken[i].proposal;
    let code = CASES.iter().find(|(code, _)| *code == own.code)?.1;
    let mechanism = catalogue::ALL.iter().find(|m| m.code == code)?;
    let (base, _) = found.without.get(i)?.as_ref()?;
    let view = View::of(bench, base).ok()?;
    let scene = bench.scene(&base.model, &view.stand).ok()?;
    let cases = (mechanism.propose)(&scene).into_iter().filter(|p| p.site == own.site).collect();
    let scored = explaining(bench, &view, cases);
    let given: Vec<f64> = base.model.parameters.iter().map(|p| p.value).collect();
    let scale = &found.scale;
    let chosen: Vec<_> = scored.iter().take(1).collect();
    let fitted = race::run(bench, &view, &given, &chosen, (scale.squares(base), scale), progress);
    let case = fitted.into_iter().find(|f| !f.is_cut)?;
    let worth = |p: &Proposal, fit: &Fit| worth_of(p, &Measure::of(fit, scale));
    (worth(&case.proposal, &case.fit) >= worth(own, &found.last)).then_some((case.proposal, case.fit))
}
