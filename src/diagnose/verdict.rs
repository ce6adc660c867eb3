//! From what was found to one verdict.

use super::answer::{Finding, Verdict};
use super::rest::Rest;
use super::search::Found;

/// Chance below which what is left counts as a law.
const LEFT_CHANCE: f64 = 0.01;
/// Share of the whitened residual's square that it must explain.
const LEFT_SHARE: f64 = 0.03;
/// Chance of the first screening's largest score, corrected, from which on something is surely missing.
const SURE: f64 = 1e-3;
/// Left-over gain over the gain of the names from which on the names only resemble.
const RESEMBLES: f64 = 0.5;
/// Share of the squared free-run error that names must leave at most where a law is left as well.
const UNNAMED: f64 = 1.0 / 3.0;

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
        self.rest.p_value < LEFT_CHANCE && best.is_some_and(|l| l.explained > LEFT_SHARE)
    }

    /// Whether what is left outweighs what was named: by the fall of the squared error that a law of it
    /// would bring, as logarithms, or because the names explain too little.
    fn outweighs(&self) -> bool {
        let left = self.rest.laws.first().map_or(0.0, |l| -(1.0 - l.explained.min(0.999)).ln());
        self.is_left() && (left > RESEMBLES * self.found.gain() || self.unnamed() > UNNAMED)
    }

    /// Share of the squared free-run error that the names leave, in the output where it is smallest.
    fn unnamed(&self) -> f64 {
        let pairs = self.found.last.rmse.iter().zip(&self.found.base.rmse);
        pairs.map(|(after, before)| (after / before).powi(2)).fold(f64::INFINITY, f64::min)
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
        if self.outweighs() {
            Verdict::Unknown
        } else if first.ties.is_empty() {
            Verdict::Named
        } else {
            Verdict::Tie
        }
    }
}
