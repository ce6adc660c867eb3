//! The simulator as a rig.

use super::options::FitOptions;
use super::rig::{Rig, Run, Track, Unknown};
use crate::Result;
use crate::model::Model;
use crate::record::{Recording, Span};
use crate::simulate::{Options, Simulator};

/// A simulator, and which rows of its outputs the tracks are.
struct Simulated {
    simulator: Simulator,
    rows: Vec<Vec<usize>>,
}

/// A model on a window of a recording, ready to run, and the samples of its outputs at the times used.
pub struct Ready {
    /// The simulation.
    pub rig: Box<dyn Rig>,
    /// One track an output that has samples.
    pub tracks: Vec<Track>,
    /// s, where the run starts.
    pub start: f64,
    /// Parameters that the recording knows: (number, value).
    pub constants: Vec<(usize, f64)>,
}

/// Builds the simulator over a window and gathers the samples to compare.
///
/// # Errors
/// As [`Simulator::new`].
pub fn ready(
    model: &Model,
    recording: &Recording,
    window: Span,
    used: &dyn Fn(f64) -> bool,
    options: &FitOptions<'_>,
) -> Result<Ready> {
    let how = Options {
        window: Some((window.from, window.to)),
        tolerance: options.tolerance,
        ..Options::default()
    };
    let simulator = Simulator::new(model, recording, &how)?;
    let (tracks, rows) = simulator.outputs().iter().map(|o| Track::new(o, used)).unzip();
    Ok(Ready {
        start: simulator.span().0,
        constants: simulator.constants().to_vec(),
        rig: Box::new(Simulated { simulator, rows }),
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

/// More sensitivities than this are shared among the cores.
const TOGETHER: usize = 4;

impl Rig for Simulated {
    fn run(&self, parameters: &[f64], initials: &[f64], wanted: &[Unknown]) -> Result<Run> {
        if wanted.len() <= TOGETHER {
            return self.run_some(parameters, initials, wanted);
        }
        let (first, second) = wanted.split_at(wanted.len().div_ceil(2));
        let half = |some: &[Unknown]| self.run_some(parameters, initials, some);
        let (one, other) = rayon::join(|| half(first), || half(second));
        let (mut run, other) = (one?, other?);
        for (columns, more) in run.sensitivities.iter_mut().zip(other.sensitivities) {
            columns.extend(more);
        }
        Ok(run)
    }

    fn slowest_time(&self, parameters: &[f64], initials: &[f64]) -> Option<f64> {
        self.simulator.slowest_time(parameters, initials).ok().flatten()
    }
}
