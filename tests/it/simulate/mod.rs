//! The simulator against closed forms, against an independent integrator, and against itself.

mod begins;
mod closed_forms;
mod curves;
mod faults;
mod jumps;
mod memory;
mod sensitivities;
mod spent;

use gyrospec::model::Model;
use gyrospec::record::{Channel, Recording};
use gyrospec::simulate::{Options, Simulator};
use gyrospec::units::Unit;

/// Times from 0 to `end` with a step.
pub fn times(end: f64, step: f64) -> Vec<f64> {
    (0..=(end / step).round() as usize).map(|i| i as f64 * step).collect()
}

/// A channel of a function of time.
pub fn channel(name: &str, unit: &str, time: &[f64], f: impl Fn(f64) -> f64) -> Channel {
    let values = time.iter().map(|t| f(*t)).collect();
    Channel::new(name, Unit::parse(unit).unwrap(), time.to_vec(), values)
}

pub fn recording(channels: Vec<Channel>) -> Recording {
    Recording::from_channels("made", channels).unwrap()
}

pub fn simulator(model: &str, recording: &Recording) -> Simulator {
    let options = Options { tolerance: 1e-7, ..Options::default() };
    Simulator::new(&Model::parse(model).unwrap(), recording, &options).unwrap()
}

/// Runs at the model's own parameters and starts.
pub fn outputs(s: &Simulator) -> Vec<f64> {
    let mut run = s.run(&s.parameters(), &s.initials()).unwrap();
    run.outputs.remove(0)
}

/// The largest difference from a function of time.
pub fn worst(time: &[f64], got: &[f64], wanted: impl Fn(f64) -> f64) -> f64 {
    time.iter().zip(got).map(|(t, y)| (y - wanted(*t)).abs()).fold(0.0, f64::max)
}
