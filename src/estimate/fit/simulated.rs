//! The simulator as a harness.

use super::harness::{Harness, Run, Track, Unknown};
use super::options::FitOptions;
use crate::Result;
use crate::model::Model;
use crate::record::{Recording, Span};
use crate::simulate::{Options, OutputSignal, Planned, Simulator};
use rayon::prelude::*;

/// A simulator, and which rows of its outputs the tracks are.
struct Simulated {
    simulator: Simulator,
    rows: Vec<Vec<usize>>,
}

/// A model on a window of a recording, ready to run, and the samples of its outputs at the times used.
pub struct Ready {
    pub harness: Box<dyn Harness>,
    /// One track an output that has samples.
    pub tracks: Vec<Track>,
    /// s, where the run starts.
    pub start: f64,
    /// Parameters that the recording knows: (number, value).
    pub constants: Vec<(usize, f64)>,
    /// Samples that are there but lie outside the inputs or in their gaps.
    pub lost: usize,
    /// Where those lie, in words.
    pub lie: &'static str,
    /// What a user should know of its channels.
    pub cautions: Vec<String>,
}

/// Builds the simulator over a window and gathers the samples to compare.
///
/// # Errors
/// As [`Simulator::new`].
pub fn ready(
    model: &Model,
    (recording, number): (&Recording, usize),
    window: Span,
    used: &dyn Fn(f64) -> bool,
    options: &FitOptions<'_>,
) -> Result<Ready> {
    let how = Options {
        window: Some((window.from, window.to)),
        tolerance: options.tolerance,
        waits: options.waits,
        budget: options.budget.clone(),
        planned: options.planned.get(number).copied().flatten(),
        ..Options::default()
    };
    let simulator = Simulator::new(model, recording, &how)?;
    let (tracks, rows) = simulator.outputs().iter().map(|o| Track::new(o, used)).unzip();
    let missed = |o: &OutputSignal| {
        let samples = o.time.iter().zip(o.measured.iter()).zip(&o.covered);
        samples.filter(|((t, y), covered)| y.is_finite() && used(**t) && !**covered).count()
    };
    Ok(Ready {
        lost: simulator.outputs().iter().map(missed).sum(),
        start: simulator.span().0,
        constants: simulator.constants().to_vec(),
        lie: simulator.model().uncompared(),
        cautions: simulator.cautions.clone(),
        harness: Box::new(Simulated { simulator, rows }),
        tracks,
    })
}

impl Simulated {
    /// The rows wanted of every output.
    fn pick(&self, values: &[Vec<f64>]) -> Vec<Vec<f64>> {
        values.iter().zip(&self.rows).map(|(y, rows)| rows.iter().map(|i| y[*i]).collect()).collect()
    }

    fn run_some(&self, parameters: &[f64], initials: &[f64], wanted: &[Unknown]) -> Result<Run> {
        let ran = self.simulator.run_with_sensitivities(parameters, initials, wanted)?;
        let of = |(columns, rows): (&Vec<Vec<f64>>, &Vec<usize>)| {
            columns.iter().map(|c| rows.iter().map(|i| c[*i]).collect()).collect()
        };
        Ok(Run {
            predictions: self.pick(&ran.outputs),
            sensitivities: ran.sensitivities.iter().zip(&self.rows).map(of).collect(),
        })
    }
}

/// So many sensitivities are found in one run; more are shared among the cores.
const TOGETHER: usize = 8;

impl Harness for Simulated {
    fn run(&self, parameters: &[f64], initials: &[f64], wanted: &[Unknown]) -> Result<Run> {
        if wanted.len() <= TOGETHER {
            return self.run_some(parameters, initials, wanted);
        }
        let parts = wanted.par_chunks(TOGETHER).map(|some| self.run_some(parameters, initials, some));
        let runs = parts.collect::<Result<Vec<Run>>>()?;
        let whole = runs.into_iter().reduce(|mut whole, part| {
            for (columns, more) in whole.sensitivities.iter_mut().zip(part.sensitivities) {
                columns.extend(more);
            }
            whole
        });
        whole.map_or_else(|| self.run_some(parameters, initials, wanted), Ok)
    }

    fn swings(&self, parameters: &[f64], initials: &[f64]) -> Option<Vec<(f64, f64)>> {
        self.simulator.swings(parameters, initials).ok().flatten()
    }

    fn planned(&self) -> Option<Planned> {
        self.simulator.planned()
    }

    fn slowest_time(&self, parameters: &[f64], initials: &[f64]) -> Option<f64> {
        self.simulator.slowest_time(parameters, initials).ok().flatten()
    }
}
