//! What a fit finds.

use super::combination::Combination;
use crate::estimate::coordinates::Side;
use crate::estimate::identify::Direction;
use crate::estimate::least_squares::End;
use crate::estimate::noise::NoiseModel;
use crate::model::Model;
use crate::record::Channel;
use crate::simulate::Early;
use crate::units::Unit;
use std::ops::Range;

/// What became of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// Fitted, inside its bounds.
    Fitted,
    /// Fitted, and pressed against a bound.
    AtBound(Side),
    /// Kept as the model file gives it.
    Fixed,
    /// Given by a recording's constants.
    Constant,
}

/// A parameter after the fit; SI.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterEstimate {
    /// The parameter's name.
    pub name: String,
    pub value: f64,
    /// Lower end of the 95 % interval; NaN where there is none.
    pub low: f64,
    /// Upper end of the 95 % interval; NaN where there is none.
    pub high: f64,
    /// Unit of the model file.
    pub unit: Unit,
    /// What became of it.
    pub status: Status,
}

/// A fitted initial state; SI.
#[derive(Debug, Clone, PartialEq)]
pub struct InitialEstimate {
    /// Number of the recording.
    pub recording: usize,
    /// The state's name.
    pub state: String,
    pub value: f64,
    /// Lower end of the 95 % interval.
    pub low: f64,
    /// Upper end of the 95 % interval.
    pub high: f64,
    /// Unit of the model file.
    pub unit: Unit,
}

/// Residuals of one output on one recording, in order of time.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Number of the output in the model.
    pub output: usize,
    /// s of the recording's clock, or row numbers.
    pub time: Vec<f64>,
    /// Measured less predicted, SI; modulo a turn where the output wraps.
    pub residual: Vec<f64>,
    /// ∂prediction/∂unknown, one vector an unknown of the fit in its order; empty where not asked for.
    pub sensitivities: Vec<Vec<f64>>,
    /// Contiguous stretches: no gap, no jump of the clock inside.
    pub stretches: Vec<Range<usize>>,
}

impl Series {
    /// The stretches of the residual.
    pub fn residual_stretches(&self) -> Vec<&[f64]> {
        self.stretches.iter().map(|r| &self.residual[r.clone()]).collect()
    }

    /// The stretches of the sensitivity to one unknown.
    pub fn sensitivity_stretches(&self, unknown: usize) -> Vec<&[f64]> {
        self.stretches.iter().map(|r| &self.sensitivities[unknown][r.clone()]).collect()
    }

    /// The samples of the output's channel beside the predictions; a gap where a stretch ends.
    pub fn beside(&self, channel: &Channel) -> Vec<Beside> {
        let mut all = Vec::with_capacity(self.time.len() + self.stretches.len());
        for stretch in &self.stretches {
            for i in stretch.clone() {
                let (time, residual) = (self.time[i], self.residual[i]);
                let at = channel.time.partition_point(|t| *t < time);
                let measured = channel.values.get(at).copied().unwrap_or(f64::NAN);
                all.push(Beside { time, measured, predicted: measured - residual, residual });
            }
            if let Some(last) = all.last().copied() {
                all.push(Beside { measured: f64::NAN, predicted: f64::NAN, residual: f64::NAN, ..last });
            }
        }
        all
    }

    /// Σ residual² and the number of samples.
    pub fn energy(&self) -> (f64, usize) {
        (self.residual.iter().map(|e| e * e).sum(), self.residual.len())
    }
}

/// A sample beside its prediction; SI, not finite in a gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beside {
    /// s of the recording's clock, or row number.
    pub time: f64,
    pub measured: f64,
    /// Predicted; of an output that wraps, on the turn of the measured value.
    pub predicted: f64,
    /// Measured less predicted.
    pub residual: f64,
}

/// The fitted part of one recording.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordFit {
    /// Name of the recording.
    pub name: String,
    /// Time at which the simulation starts, s.
    pub start: f64,
    /// All initial states in the model's order; NaN where the simulator finds them itself.
    pub initials: Vec<f64>,
    /// One series an output that the recording has.
    pub series: Vec<Series>,
}

/// Something that a user should know; the fit went on.
#[derive(Debug, Clone, PartialEq)]
pub struct Warning {
    /// What, and what to do.
    pub message: String,
}

/// A fitted model.
#[derive(Debug, Clone)]
pub struct Fit {
    /// The model with the fitted values in place.
    pub model: Model,
    /// All its parameters, in its order.
    pub parameters: Vec<ParameterEstimate>,
    /// The fitted initial states, by recording.
    pub initials: Vec<InitialEstimate>,
    /// Names of the unknowns, in the order of sensitivities and covariance: parameters, then initial
    /// states as `state(0)`, with the recording's number where there are several.
    pub unknowns: Vec<String>,
    /// Their values, SI.
    pub values: Vec<f64>,
    /// Their covariance, unknowns × unknowns, for noise as coloured as the residual; rows of unseen or
    /// bounded unknowns are NaN.
    pub covariance: faer::Mat<f64>,
    /// Residuals by recording.
    pub records: Vec<RecordFit>,
    /// The noise of each output, in the model's order.
    pub noise: Vec<NoiseModel>,
    /// Free-run root mean square of each output over the fitted parts, SI.
    pub rmse: Vec<f64>,
    /// Directions in parameter space that the data do not see.
    pub unseen: Vec<Direction>,
    /// Parameters whose intervals are profiles, by [`super::ascertain`].
    pub profiled: Vec<String>,
    /// Combinations that the data determine of parameters that trade, by [`super::ascertain`].
    pub determined: Vec<Combination>,
    /// What a user should know.
    pub warnings: Vec<Warning>,
    /// Share of an output's spread that the solver's error was kept below.
    pub tolerance: f64,
    /// How the walk ended.
    pub end: End,
    /// What ended the search for the minimum before it was through.
    pub ended_early: Option<Early>,
    /// Simulations done.
    pub simulations: usize,
}

impl Fit {
    /// Where all states start, a list a recording; NaN where the simulator finds the start.
    pub fn starts(&self) -> Vec<Vec<f64>> {
        self.records.iter().map(|r| r.initials.clone()).collect()
    }

    /// Whether a parameter ended at its bound.
    pub fn is_at_bound(&self, name: &str) -> bool {
        self.parameters.iter().any(|p| p.name == name && matches!(p.status, Status::AtBound(_)))
    }
}

/// One output over all held-out parts.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldOut {
    /// Number of the output in the model.
    pub output: usize,
    /// Free-run root mean square, SI; NaN without held-out samples.
    pub rmse: f64,
    /// Residuals, one series a held-out span or record.
    pub series: Vec<Series>,
    /// Which recording each series is of, counted over the fitted and then the separate ones.
    pub recordings: Vec<usize>,
}
