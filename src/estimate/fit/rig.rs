//! What a fit needs of a simulation, and what it knows about one recording.

use crate::record::Recording;
use crate::{Error, Result};
use std::ops::Range;

/// Something that a free run depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unknown {
    /// A parameter, by its number in the model.
    Parameter(usize),
    /// An initial state, by the state's number in the model.
    Initial(usize),
}

/// One free run: for every track its predictions, and their sensitivities to what was asked for.
#[derive(Debug, Clone)]
pub struct Run {
    /// Predictions at the track's times.
    pub predictions: Vec<Vec<f64>>,
    /// By track, then by unknown asked for.
    pub sensitivities: Vec<Vec<Vec<f64>>>,
}

/// A model on one recording, ready to run.
pub trait Rig: Send + Sync {
    /// Runs freely from the initial states (all of the model's, NaN where it starts by itself);
    /// `wanted` lists the sensitivities to give.
    fn run(&self, parameters: &[f64], initials: &[f64], wanted: &[Unknown]) -> Result<Run>;
}

/// The measured samples of one output that a fit compares with.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// Number of the output in the model.
    pub output: usize,
    /// Rows of the channel that are used.
    pub rows: Vec<usize>,
    /// Their times.
    pub time: Vec<f64>,
    /// Their values, SI.
    pub measured: Vec<f64>,
    /// Whether differences count modulo a turn.
    pub wraps: bool,
    /// Contiguous stretches.
    pub stretches: Vec<Range<usize>>,
}

/// A step of the clock over the usual one from which on a stretch ends.
const JUMP: f64 = 1.5;

impl Track {
    /// The samples of a channel that are no gaps and whose times are used.
    pub fn new(
        recording: &Recording,
        channel: &str,
        output: usize,
        used: &dyn Fn(f64) -> bool,
    ) -> Result<Self> {
        let c = recording.channel(channel)?;
        let rows: Vec<usize> =
            (0..c.len()).filter(|i| c.values[*i].is_finite() && used(c.time[*i])).collect();
        let time: Vec<f64> = rows.iter().map(|i| c.time[*i]).collect();
        let usual = c.median_step().unwrap_or(f64::INFINITY);
        Ok(Self {
            output,
            measured: rows.iter().map(|i| c.values[*i]).collect(),
            wraps: c.wraps,
            stretches: stretches(&time, JUMP * usual),
            time,
            rows,
        })
    }

    /// Measured less predicted, modulo a turn where the output wraps.
    pub fn residual(&self, predicted: &[f64]) -> Vec<f64> {
        let turn = std::f64::consts::TAU;
        self.measured
            .iter()
            .zip(predicted)
            .map(|(y, f)| {
                let e = y - f;
                if self.wraps { e - turn * (e / turn).round() } else { e }
            })
            .collect()
    }
}

/// Runs of times without a step longer than `jump`.
fn stretches(time: &[f64], jump: f64) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut from = 0;
    for i in 1..=time.len() {
        if i == time.len() || time[i] - time[i - 1] > jump {
            found.push(from..i);
            from = i;
        }
    }
    found
}

/// A recording, or a window of one, as a fit sees it.
pub struct Record {
    /// Name for reports.
    pub name: String,
    /// Number of the recording that it belongs to.
    pub recording: usize,
    /// s, where the free run starts.
    pub start: f64,
    /// The simulation.
    pub rig: Box<dyn Rig>,
    /// What is compared.
    pub tracks: Vec<Track>,
    /// Parameters that the recording knows: (number, value).
    pub constants: Vec<(usize, f64)>,
    /// Initial states to start the fit from, all of the model's; NaN where the simulator finds them.
    pub initials: Vec<f64>,
    /// States whose start is fitted.
    pub free_initials: Vec<usize>,
}

impl Record {
    /// The model's parameters with the recording's own constants in place.
    pub fn parameters(&self, shared: &[f64]) -> Vec<f64> {
        let mut own = shared.to_vec();
        for (k, value) in &self.constants {
            own[*k] = *value;
        }
        own
    }

    /// Whether the recording fixes a parameter itself.
    pub fn knows(&self, parameter: usize) -> bool {
        self.constants.iter().any(|(k, _)| *k == parameter)
    }

    /// Runs and refuses predictions that are not finite.
    pub fn run(&self, shared: &[f64], initials: &[f64], wanted: &[Unknown]) -> Result<Run> {
        let run = self.rig.run(&self.parameters(shared), initials, wanted)?;
        if run.predictions.iter().flatten().all(|y| y.is_finite()) {
            return Ok(run);
        }
        Err(Error::not_computed(format!("the simulation of '{}' does not stay finite", self.name)))
    }
}
