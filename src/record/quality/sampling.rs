//! Purpose: how even the clock of a channel is, and whether its rate changes for good.
//!
//! Method: median step and the usual deviation from it. Against a straight line of times over
//! sample numbers, a rate that changes leaves a bend: the slopes of the two halves are compared
//! with what the scatter of blocks of steps allows.

use super::{Fault, FaultKind, quantile, steps};
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
    let at = |share| quantile(steps(&channel.time), share);
    let step = at(0.5)?;
    let jitter = 0.5 * (at(0.95)? - at(0.05)?);
    Some(Sampling { step, jitter, even: jitter <= 0.01 * step })
}

/// A rate that changes for good; `size` is the relative change of the step. A suspicion only:
/// the channel's times say nothing of which part is right.
pub(super) fn drift(channel: &Channel) -> Option<Fault> {
    let time = &channel.time;
    if time.len() <= FEWEST_STEPS {
        return None;
    }
    // The middle steps of each block: gaps and single leaps leave them alone.
    let length = (time.len() - 1) / BLOCKS;
    let mut blocks: Vec<f64> = Vec::with_capacity(BLOCKS);
    for block in 0..BLOCKS {
        let part = &time[block * length..=(block + 1) * length];
        blocks.push(trimmed_mean(&mut steps(part).collect::<Vec<f64>>()));
    }
    let (first, second) = blocks.split_at(BLOCKS / 2);
    let (a, b) = (trimmed_mean(&mut first.to_vec()), trimmed_mean(&mut second.to_vec()));
    let scatter: Vec<f64> =
        first.iter().map(|x| (x - a).abs()).chain(second.iter().map(|x| (x - b).abs())).collect();
    let scatter = quantile(scatter.iter().copied(), 0.9)?;
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
    let cut = values.len() / 10;
    let middle = if cut == 0 {
        values
    } else {
        let (_, _, above) = values.select_nth_unstable_by(cut - 1, f64::total_cmp);
        let keep = above.len() - cut;
        above.select_nth_unstable_by(keep, f64::total_cmp).0
    };
    middle.iter().sum::<f64>() / middle.len() as f64
}
