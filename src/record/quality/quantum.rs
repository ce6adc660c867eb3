//! Purpose: the smallest step of a channel, and whether it is coarse.
//!
//! Method: the quantum is the smallest distance between distinct values, if all distances are
//! whole multiples of it. It is coarse where the channel is a staircase: it mostly stands still,
//! and when it moves it mostly moves by one step, over few steps in all. Inputs that are switched
//! between levels jump by several, or have too few levels, and are no staircase.
//!
//! References: B. Widrow, I. Kollar, Quantization Noise (2008): the error of a staircase has
//! the variance q²/12.
//!
//! Numerical aspects: distances are compared within a hundredth of a quantum and never below
//! the rounding of the values.

use super::{Fault, FaultKind, Samples, ends, steps};
use crate::record::Channel;

const LOOKED_AT: usize = 20_000;
const WHOLE: f64 = 0.01;
const FEWEST_LEVELS: usize = 5;
const COARSE_LEVELS: f64 = 64.0;

/// The step of which all values are whole multiples (but for an offset), SI; `None` where there
/// is none, or fewer than three distinct values.
pub fn quantum(channel: &Channel) -> Option<f64> {
    let every = channel.len().div_ceil(LOOKED_AT).max(1);
    let mut values: Vec<f64> = channel.samples().step_by(every).map(|(_, v)| v).collect();
    values.sort_unstable_by(f64::total_cmp);
    let largest = values.first()?.abs().max(values.last()?.abs());
    let rounding = 1e-13 * largest;
    let distances: Vec<f64> = values.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > rounding).collect();
    if distances.len() < 2 {
        return None;
    }
    let smallest = distances.iter().copied().fold(f64::INFINITY, f64::min);
    if smallest < 100.0 * rounding {
        return None;
    }
    let whole = |d: &f64| {
        let steps = d / smallest;
        (steps - steps.round()).abs() < WHOLE * steps.clamp(1.0, 20.0)
    };
    distances.iter().all(whole).then_some(smallest)
}

/// A staircase of few steps; `size` is the quantum, SI. Never sure: whether it is too coarse is
/// for the use to say.
pub fn coarse_steps(channel: &Channel) -> Option<Fault> {
    let quantum = quantum(channel)?;
    let Samples { values, .. } = Samples::of(channel);
    let (low, high) = ends(&values);
    if (high - low) / quantum > COARSE_LEVELS {
        return None;
    }
    let (mut still, mut single, mut moves) = (0_usize, 0_usize, 0_usize);
    for step in steps(&values) {
        match (step / quantum).abs().round() {
            0.0 => still += 1,
            steps => {
                moves += 1;
                single += usize::from(steps == 1.0);
            }
        }
    }
    let staircase = still > moves && single * 10 >= moves * 9 && moves >= 8;
    if !staircase || channel.levels().len() < FEWEST_LEVELS {
        return None;
    }
    let of = Fault::of(FaultKind::Quantisation, channel, Vec::new());
    Some(Fault { samples: values.len(), size: quantum, sure: false, ..of })
}
