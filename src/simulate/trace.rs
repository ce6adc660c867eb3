//! States, definitions and rates of a run, on request.

use super::probe::Clock;
use super::request::Case;
use super::simulator::Simulator;
use crate::{Error, Result};
use std::sync::Arc;

/// Everything that a model computes, at given times; SI.
#[derive(Debug, Clone)]
pub struct Trace {
    /// s
    pub time: Arc<[f64]>,
    /// State by state.
    pub states: Vec<Vec<f64>>,
    /// dx/dt, state by state.
    pub rates: Vec<Vec<f64>>,
    /// Definition by definition.
    pub definitions: Vec<Vec<f64>>,
    /// Output by output.
    pub outputs: Vec<Vec<f64>>,
}

impl Simulator {
    /// Runs and gives everything at rising times; NaN outside the simulated span.
    ///
    /// # Errors
    /// As [`Simulator::run`].
    pub fn trace(&self, parameters: &[f64], initials: &[f64], time: Arc<[f64]>) -> Result<Trace> {
        let model = self.model();
        if parameters.len() != model.parameters.len() || initials.len() != model.states.len() {
            return Err(Error::usage("as many parameters and initial states are needed as the model has"));
        }
        let p = &self.program;
        let n = model.states.len();
        let lists = [&p.states[..n], &p.rates[..n], &p.definitions[..], &p.outputs[..]];
        let clocks = [Clock { time: time.clone(), registers: lists.concat() }];
        let case =
            Case { parameters: self.with_constants(parameters), initials, unknowns: &[], clocks: &clocks };
        let (ran, _) = self.ran::<f64>(&case)?;
        let width = clocks[0].registers.len().max(1);
        let (from, to) = self.span();
        let column = |c: usize| -> Vec<f64> {
            let values = ran.values[0].iter().skip(c).step_by(width);
            let inside = |t: &f64| *t >= from && *t <= to;
            values.zip(time.iter()).map(|(v, t)| if inside(t) { *v } else { f64::NAN }).collect()
        };
        let mut next = 0;
        let mut take = |count: usize| {
            next += count;
            (next - count..next).map(column).collect::<Vec<_>>()
        };
        let (states, rates) = (take(n), take(n));
        let (definitions, outputs) = (take(p.definitions.len()), take(p.outputs.len()));
        Ok(Trace { time, states, rates, definitions, outputs })
    }
}
