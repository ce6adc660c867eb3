//! Purpose: how even the clock of a channel is, and whether its rate changes for good.
//!
//! Method: median step and the usual deviation from it. Against a straight line of times over
//! sample numbers, a rate that changes leaves a bend: the slopes of the two halves are compared
//! with what the scatter of blocks of steps allows.

use super::{Fault, FaultKind, quantile};
use crate::record::Channel;

const BLOCKS: usize = 20;
const FEWEST_STEPS: usize = 200;
/// Bends below this share of the step are no matter for anybody.
const SMALLEST_DRIFT: f64 = 1e-4;
const FAR: f64 = 8.0;

/// The clock of a channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Median step, s.
    pub step: f64,
    /// Half the range of the middle 90 % of the steps, s.
    pub jitter: f64,
    /// Whether nine steps in ten agree within 1 %.
    pub even: bool,
}

/// The sampling of a channel; `None` with fewer than two samples.
pub fn sampling(channel: &Channel) -> Option<Sampling> {
    let mut steps: Vec<f64> = channel.time.windows(2).map(|w| w[1] - w[0]).collect();
    let step = quantile(&mut steps, 0.5)?;
    let jitter = 0.5 * (quantile(&mut steps, 0.95)? - quantile(&mut steps, 0.05)?);
    Some(Sampling { step, jitter, even: jitter <= 0.01 * step })
}

/// A rate that changes for good; `size` is the relative change of the step. A suspicion only:
/// the channel's times say nothing of which part is right.
pub(super) fn drift(channel: &Channel) -> Option<Fault> {
    let time = &channel.time;
    if time.len() <= FEWEST_STEPS {
        return None;
    }
    // The median of each block's steps: gaps and single leaps leave it alone.
    let length = (time.len() - 1) / BLOCKS;
    let mut blocks: Vec<f64> = Vec::with_capacity(BLOCKS);
    for block in 0..BLOCKS {
        let part = &time[block * length..=(block + 1) * length];
        let mut steps: Vec<f64> = part.windows(2).map(|w| w[1] - w[0]).collect();
        blocks.push(trimmed_mean(&mut steps));
    }
    let (first, second) = blocks.split_at(BLOCKS / 2);
    let (a, b) = (trimmed_mean(&mut first.to_vec()), trimmed_mean(&mut second.to_vec()));
    let mut scatter: Vec<f64> =
        first.iter().map(|x| (x - a).abs()).chain(second.iter().map(|x| (x - b).abs())).collect();
    let scatter = quantile(&mut scatter, 0.9)?;
    let change = (b - a) / a;
    if change.abs() < SMALLEST_DRIFT || (b - a).abs() < FAR * scatter {
        return None;
    }
    Some(Fault {
        samples: time.len() / 2,
        size: change,
        sure: false,
        ..Fault::of(FaultKind::ClockDrift, channel, Vec::new())
    })
}

/// The mean of the middle 80 %.
fn trimmed_mean(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    let cut = values.len() / 10;
    let middle = &values[cut..values.len() - cut];
    middle.iter().sum::<f64>() / middle.len() as f64
}
