//! From what was found to one verdict.

use super::answer::{Finding, Verdict};
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

/// What decides.
pub struct Evidence<'a> {
    /// Faults of the data.
    pub faults: &'a [Finding],
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
        if !self.faults.is_empty() {
            return Verdict::DataFault;
        }
        if self.blind.is_some() {
            return Verdict::NotIdentifiable;
        }
        let Some(first) = self.found.taken.first() else {
            let something = self.is_left() || self.found.first.p_value < SURE;
            return if something { Verdict::Unknown } else { Verdict::NothingMissing };
        };
        if self.outweighs() || self.is_left() && self.is_pressed() {
            Verdict::Unknown
        } else if first.ties.is_empty() {
            Verdict::Named
        } else {
            Verdict::Tie
        }
    }
}
