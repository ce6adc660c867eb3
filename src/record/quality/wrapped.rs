//! Purpose: angles that pass north as a jump of a turn and are not marked as wrapping.
//!
//! Method: all values lie within one turn, and some neighbours differ by a turn but for a rest
//! no larger than other neighbours differ by.

use super::{Fault, FaultKind, quantile};
use crate::record::{Channel, Span};
use std::f64::consts::TAU;

const NEAR_A_TURN: f64 = 0.85;
const USUAL_STEPS: f64 = 5.0;

/// Jumps by a turn; spans reach from the sample before to the one after.
pub fn wrapped_angle(channel: &Channel) -> Option<Fault> {
    let angle = ["deg", "rad", "arcmin"].contains(&channel.unit.text());
    if channel.wraps || !angle {
        return None;
    }
    let samples: Vec<(f64, f64)> = channel.samples().collect();
    let (low, high) =
        samples.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s.1), h.max(s.1)));
    if high - low > TAU * (1.0 + 1e-9) {
        return None;
    }
    let mut steps: Vec<f64> = samples.windows(2).map(|w| (w[1].1 - w[0].1).abs()).collect();
    let usual = quantile(&mut steps, 0.9)?.min(0.1 * TAU);
    let jump = |w: &&[(f64, f64)]| {
        let step = (w[1].1 - w[0].1).abs();
        step > NEAR_A_TURN * TAU && TAU - step <= USUAL_STEPS * usual + 1e-9
    };
    let spans: Vec<Span> = samples.windows(2).filter(jump).map(|w| Span::new(w[0].0, w[1].0)).collect();
    if spans.is_empty() {
        return None;
    }
    Some(Fault { samples: spans.len(), size: TAU, ..Fault::of(FaultKind::WrappedAngle, channel, spans) })
}
