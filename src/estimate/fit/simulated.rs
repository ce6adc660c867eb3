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
    let default = Options::default();
    let how = Options {
        window: Some((window.from, window.to)),
        tolerance: default.tolerance * options.tolerance,
        ..default
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

impl Rig for Simulated {
    fn run(&self, parameters: &[f64], initials: &[f64], wanted: &[Unknown]) -> Result<Run> {
        let ran = self.simulator.run_with_sensitivities(parameters, initials, wanted)?;
        let pick = |values: &[f64], rows: &[usize]| rows.iter().map(|i| values[*i]).collect::<Vec<f64>>();
        Ok(Run {
            predictions: ran.outputs.iter().zip(&self.rows).map(|(y, rows)| pick(y, rows)).collect(),
            sensitivities: ran
                .sensitivities
                .iter()
                .zip(&self.rows)
                .map(|(columns, rows)| columns.iter().map(|c| pick(c, rows)).collect())
                .collect(),
        })
    }
}
