//! How many points of a fine mesh a response needs.
//!
//! # Method
//! The largest stride at which straight lines between the points that are kept follow the course of every
//! signal: where all of them are slow beside the mesh, a look at each of its points repeats itself.
//!
//! # Numerical aspects
//! Straight lines leave (ωh)²/√120 of the amplitude of a motion of angular frequency ω, root mean square, and the
//! trapezoidal rule (ωh)²/12 in its integral: a direction is off by no more than what the signals are. A signal
//! with noise of more than that from point to point keeps the whole mesh.

use crate::record::{Channel, Hold, Recording};
use std::sync::Arc;

/// Root mean square of what the lines leave, as a share of a signal's spread.
pub(super) const LEFT: f64 = 0.05;
/// Points that are kept at least, and the longest stride.
const LEAST: usize = 2000;
pub(super) const LONGEST: usize = 64;

/// The largest stride that keeps the course of every signal.
pub(super) fn stride(signals: &[&[f64]], points: usize, longest: usize) -> usize {
    let mut stride = 1;
    while 2 * stride <= longest && points / (2 * stride) >= LEAST {
        if !signals.iter().all(|s| keeps(s, 2 * stride)) {
            break;
        }
        stride *= 2;
    }
    stride
}

/// Every so many points of a series, and its last.
pub(super) fn every<T: Copy>(series: &[T], stride: usize) -> Vec<T> {
    let last = series.len().saturating_sub(1);
    let mut kept: Vec<T> = series[..last].iter().step_by(stride).copied().collect();
    kept.extend(series.last());
    kept
}

/// Whether straight lines over a stride follow a series.
fn keeps(series: &[f64], stride: usize) -> bool {
    let n = series.len() as f64;
    let mean = series.iter().sum::<f64>() / n;
    let spread: f64 = series.iter().map(|v| (v - mean).powi(2)).sum();
    let off = |w: &[f64]| -> f64 {
        let line = |k: usize| w[0] + (w[stride] - w[0]) * k as f64 / stride as f64;
        w[1..stride].iter().enumerate().map(|(k, v)| (v - line(k + 1)).powi(2)).sum()
    };
    let left: f64 = series.windows(stride + 1).step_by(stride).map(off).sum();
    left <= LEFT * LEFT * spread
}

/// A recording of which each channel that is finer than a mesh is read on the mesh.
pub(super) fn read_on(recording: &mut Recording, mesh: &Arc<[f64]>) {
    for c in recording.channels.iter_mut().filter(|c| c.len() > mesh.len()) {
        if let Some(values) = on(c, mesh) {
            (c.time, c.values, c.hold) = (mesh.clone(), values, Hold::Linear);
        }
    }
}

/// The values of a channel on a mesh; none where it has gaps or does not reach over all of it.
pub(super) fn on(channel: &Channel, mesh: &[f64]) -> Option<Vec<f64>> {
    mesh.iter().map(|t| channel.value_from(*t)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_what_is_slow_and_no_more() {
        // (ωh)²/√120 = LEFT: ωh = 0.74, so that 8.5 points a period are enough.
        let sine = |points: f64| -> Vec<f64> {
            (0..60_000).map(|i| (std::f64::consts::TAU * f64::from(i) / points).sin()).collect()
        };
        for (points, stride_then) in [(15.0, 1), (30.0, 2), (150.0, 16), (20_000.0, 16)] {
            let s = sine(points);
            assert_eq!(stride(&[&s], s.len(), LONGEST), stride_then, "{points}");
        }
        let (slow, fast) = (sine(150.0), sine(12.0));
        assert_eq!(stride(&[&slow, &fast], slow.len(), LONGEST), 1);
    }

    #[test]
    fn the_last_point_stays() {
        assert_eq!(every(&[0, 1, 2, 3, 4, 5, 6], 3), [0, 3, 6]);
        assert_eq!(every(&[0, 1, 2, 3, 4, 5], 3), [0, 3, 5]);
        assert_eq!(every(&[0], 3), [0]);
    }
}
