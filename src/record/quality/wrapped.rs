//! Purpose: angles that pass north as a jump of a turn and are not marked as wrapping.
//!
//! Method: all values lie within one turn, and some neighbours differ by a turn but for a rest
//! no larger than other neighbours differ by.

use super::{Fault, FaultKind, Samples, ends, quantile, steps};
use crate::record::{Channel, Span};
use std::f64::consts::TAU;

const NEAR_A_TURN: f64 = 0.85;
const USUAL_STEPS: f64 = 5.0;

/// Jumps by a turn; spans reach from the sample before to the one after.
pub fn wrapped_angle(channel: &Channel) -> Option<Fault> {
    if channel.wraps || !channel.unit.is_angle() {
        return None;
    }
    let Samples { time, values } = Samples::of(channel);
    let (low, high) = ends(&values);
    if high - low > TAU * (1.0 + 1e-9) || high - low < NEAR_A_TURN * TAU {
        return None;
    }
    let usual = quantile(steps(&values).map(f64::abs), 0.9)?.min(0.1 * TAU);
    let jump = |i: &usize| {
        let step = (values[*i] - values[i - 1]).abs();
        step > NEAR_A_TURN * TAU && TAU - step <= USUAL_STEPS * usual + 1e-9
    };
    let spans: Vec<Span> = (1..values.len()).filter(jump).map(|i| Span::new(time[i - 1], time[i])).collect();
    if spans.is_empty() {
        return None;
    }
    Some(Fault { samples: spans.len(), size: TAU, ..Fault::of(FaultKind::WrappedAngle, channel, spans) })
}
