//! From what was found to one verdict: first on the physics, by the data without their faults, then on both.

use super::answer::{DataFault, Finding, Proof, Value, Verdict};
use super::choose::is_wave;
use super::rest::Rest;
use super::search::{Found, is_pressed};

/// Chance below which what is left counts as a law.
const LEFT_CHANCE: f64 = 0.01;
/// Share of the residual's square, whitened or not, that it must explain.
const LEFT_SHARE: f64 = 0.03;
/// Chance of the first screening's largest score, corrected, from which on something is surely missing.
const SURE: f64 = 1e-3;
/// Share of all that names and a law could explain together from which on, left to the law, the names
/// only resemble.
const RESEMBLES: f64 = 0.1;
/// The same in a table of trials, whose rows are independent, where the law's chance is below the second.
const IN_TRIALS: (f64, f64) = (0.005, 1e-4);

/// What decides on the physics.
pub struct Evidence<'a> {
    /// The search's outcome.
    pub found: &'a Found,
    /// What is left after it.
    pub rest: &'a Rest,
    /// Why the fitted part cannot tell, if so.
    pub blind: Option<&'a str>,
}

impl Evidence<'_> {
    /// Whether something is left that goes with a signal.
    pub fn is_left(&self) -> bool {
        let best = self.rest.laws.first();
        self.rest.p_value < LEFT_CHANCE && best.is_some_and(|l| l.explained.max(l.lowers) > LEFT_SHARE)
    }

    /// Whether the names leave too much to a law that no name has. With ρ the share of the squared error
    /// that the names leave and λ the part of it that the law takes away, the law has λρ/(1 − ρ + λρ) of
    /// all that is explained.
    fn outweighs(&self) -> bool {
        let named = 1.0 - (-self.found.gain()).exp();
        let left = self.rest.laws.first().map_or(0.0, |l| l.lowers) * (1.0 - named);
        let sure = self.found.scale.trials && self.rest.p_value < IN_TRIALS.1;
        let most = if sure { IN_TRIALS.0 } else { RESEMBLES };
        self.is_left() && left > most * (named + left)
    }

    /// Whether an own parameter of a name has run into its bound, where it is something else.
    fn is_pressed(&self) -> bool {
        self.found.taken.iter().any(|t| is_pressed(&t.proposal, &self.found.last))
    }

    /// The verdict.
    pub fn verdict(&self) -> Verdict {
        if self.blind.is_some() {
            return Verdict::NotIdentifiable;
        }
        let Some(first) = self.found.taken.first() else {
            let something = self.is_left() || self.found.first.p_value < SURE;
            return if something { Verdict::Unknown } else { Verdict::NothingMissing };
        };
        let doubtful = self.is_pressed() || is_wave(&first.proposal);
        if self.outweighs() || self.is_left() && doubtful {
            Verdict::Unknown
        } else if first.ties.is_empty() {
            Verdict::Named
        } else {
            Verdict::Tie
        }
    }
}

/// The finding with the largest share decides: by its ties between named and tie, and it only resembles
/// what is missing if none of its amplitudes differs from 0 for sure.
pub fn settle(verdict: Verdict, findings: &[Finding], found: &Found) -> Verdict {
    let Some(first) = findings.first().filter(|_| matches!(verdict, Verdict::Named | Verdict::Tie)) else {
        return verdict;
    };
    let proposal =
        found.taken.iter().map(|t| &t.proposal).find(|p| p.code == first.code && p.term == first.term);
    let amplitudes: Vec<&Value> =
        proposal.iter().flat_map(|p| &p.amplitudes).filter_map(|k| first.parameters.get(*k)).collect();
    let unsure = |v: &&Value| v.low <= 0.0 && v.high >= 0.0;
    if !amplitudes.is_empty() && amplitudes.iter().all(unsure) {
        Verdict::Unknown
    } else if first.ties.is_empty() {
        Verdict::Named
    } else {
        Verdict::Tie
    }
}

/// Error at levels held out over the error of the fit, in a table of trials that still holds a law, from
/// which on the names do not reach beyond the levels that they were fitted to.
const BEYOND: f64 = 1.5;

/// Names that lower no held-out error for sure, neither as it stands nor by its innovations (slow noise may
/// hide in the one what the other shows), or that miss held-out levels while a law is left, only resemble
/// what is missing.
pub fn proved(verdict: Verdict, proof: &[Proof], falls_whitened: bool, left_in_trials: bool) -> Verdict {
    let fails = !proof.is_empty() && proof.iter().all(|p| p.improvement_low <= 0.0) && !falls_whitened;
    let misses = left_in_trials && proof.iter().any(|p| p.holdout_after > BEYOND * p.fit_after);
    let blows_up = proof.iter().any(|p| p.holdout_before.is_finite() && !p.holdout_after.is_finite());
    let named = matches!(verdict, Verdict::Named | Verdict::Tie);
    if named && (fails || misses || blows_up) { Verdict::Unknown } else { verdict }
}

/// The verdict on physics and data: the faults take it only where nothing physical stands beside them, or
/// where they leave the question `open`.
pub fn with_faults(physics: Verdict, faults: &[DataFault], open: bool) -> Verdict {
    let alone = open || physics == Verdict::NothingMissing;
    if alone && !faults.is_empty() { Verdict::DataFault } else { physics }
}
