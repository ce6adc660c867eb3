//! What a fit needs of a simulation, and what it knows about one recording.

use crate::estimate::coordinates::Range;
use crate::record::principal;
use crate::simulate::OutputSignal;
use crate::simulate::Planned;
pub use crate::simulate::Unknown;
use crate::{Error, Result};

/// One free run: for every track its predictions, and their sensitivities to what was asked for.
#[derive(Debug, Clone)]
pub struct Run {
    /// Predictions at the track's times.
    pub predictions: Vec<Vec<f64>>,
    /// By track, then by unknown asked for.
    pub sensitivities: Vec<Vec<Vec<f64>>>,
}

/// A model on one recording, ready to run.
pub trait Harness: Send + Sync {
    /// Runs freely from the initial states (all of the model's, NaN where it starts by itself);
    /// `wanted` lists the sensitivities to give.
    fn run(&self, parameters: &[f64], initials: &[f64], wanted: &[Unknown]) -> Result<Run>;

    /// How far each state of the model moves in a run, from its lowest to its highest value; None where the
    /// run does not go to its end.
    fn swings(&self, parameters: &[f64], initials: &[f64]) -> Option<Vec<(f64, f64)>>;

    /// How it runs, for a model that is much like this one.
    fn planned(&self) -> Option<Planned>;

    /// The longest time constant of the model about its start, s; None where there is none.
    fn slowest_time(&self, parameters: &[f64], initials: &[f64]) -> Option<f64>;
}

/// The measured samples of one output that a fit compares with.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// Number of the output in the model.
    pub output: usize,
    /// Times of its samples.
    pub time: Vec<f64>,
    /// Their values, SI.
    pub measured: Vec<f64>,
    /// Whether differences count modulo a turn.
    pub wraps: bool,
    /// Contiguous stretches.
    pub stretches: Vec<std::ops::Range<usize>>,
}

/// A step of the clock over the usual one from which on a stretch ends. One or two samples that are missing leave its noise
/// as it is: what comes after them is foretold from before almost as well, while two stretches would count as two noises
/// that know nothing of each other, however slow the noise.
const JUMP: f64 = 3.5;

impl Track {
    /// The samples of an output that are no gaps, can be predicted and are used, and their rows.
    pub fn new(signal: &OutputSignal, used: &dyn Fn(f64) -> bool) -> (Self, Vec<usize>) {
        let time = &signal.time;
        let kept = |i: &usize| signal.measured[*i].is_finite() && signal.covered[*i] && used(time[*i]);
        let rows: Vec<usize> = (0..time.len()).filter(kept).collect();
        let mut steps: Vec<f64> = time.windows(2).map(|w| w[1] - w[0]).collect();
        let middle = steps.len() / 2;
        let usual = if steps.is_empty() {
            f64::INFINITY
        } else {
            *steps.select_nth_unstable_by(middle, f64::total_cmp).1
        };
        let time: Vec<f64> = rows.iter().map(|i| time[*i]).collect();
        let track = Self {
            output: signal.output,
            measured: rows.iter().map(|i| signal.measured[*i]).collect(),
            wraps: signal.wraps,
            stretches: stretches(&time, JUMP * usual),
            time,
        };
        (track, rows)
    }

    /// Measured less predicted, modulo a turn where the output wraps.
    pub fn residual(&self, predicted: &[f64]) -> Vec<f64> {
        let pairs = self.measured.iter().zip(predicted);
        pairs.map(|(y, f)| if self.wraps { principal(y - f) } else { y - f }).collect()
    }
}

/// Runs of times without a step longer than `jump`.
fn stretches(time: &[f64], jump: f64) -> Vec<std::ops::Range<usize>> {
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
    pub harness: Box<dyn Harness>,
    /// What is compared.
    pub tracks: Vec<Track>,
    /// Parameters that the recording knows: (number, value).
    pub constants: Vec<(usize, f64)>,
    /// Initial states to start the fit from, all of the model's; NaN where the simulator finds them.
    pub initials: Vec<f64>,
    /// Samples that are there but lie outside the inputs or in their gaps.
    pub lost: usize,
    /// Where those lie, in words.
    pub lie: &'static str,
    /// What a user should know of its channels.
    pub cautions: Vec<String>,
    /// States whose start is fitted.
    pub free_initials: Vec<usize>,
    /// Between what the start of each of them may lie.
    pub reach: Vec<Range>,
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
        let run = self.harness.run(&self.parameters(shared), initials, wanted)?;
        if run.predictions.iter().flatten().all(|y| y.is_finite()) {
            return Ok(run);
        }
        Err(Error::not_computed(format!("the simulation of '{}' does not stay finite", self.name))
            .with_hint("give parameters and the `initial` of states values nearer to the instrument's: a division by what begins at 0 is enough"))
    }
}
