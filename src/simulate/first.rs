//! Where the states of a model begin by what a recording shows first.

use super::Simulator;
use crate::model::shown::{Seen, begins_at, first_guesses, shifted};

impl Simulator {
    /// The model's initial states in SI: its numbers; for one to be fitted what an output shows of it first, else what a
    /// state or an input of its dimension begins at, else 0; NaN for a steady one.
    pub fn initials(&self) -> Vec<f64> {
        let parameters = self.parameters();
        let input = |i: usize| Some(self.samples[i].at(self.span().0, &mut 0).0);
        let known = |name: &str| {
            let parameter = self.model.parameters.iter().position(|p| p.name == name).map(|k| parameters[k]);
            parameter.or_else(|| input(self.model.inputs.iter().position(|i| i.name == name)?))
        };
        let shows = |k: usize, seen: Seen| {
            let o = self.outputs().iter().find(|s| s.output == seen.output && seen.order == 0)?;
            let mut samples = o.time.iter().zip(o.measured.iter());
            let (_, y) = samples.find(|(t, y)| **t >= self.span().0 && y.is_finite())?;
            shifted(&self.model, (k, seen.output), (*y, o.wraps), &known).or(Some(*y))
        };
        let guesses = first_guesses(&self.model, shows, input);
        self.model.states.iter().zip(guesses).map(|(s, guess)| begins_at(s, guess)).collect()
    }
}
