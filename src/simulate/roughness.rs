//! How rough the steps of a run were: their embedded errors against the ranges of the states.

use super::steps::Stepper;
use crate::model::Scalar;

/// The embedded errors of the steps.
pub(super) struct Roughness {
    /// State by state their sums, then the lowest, then the highest values of the states.
    pub measures: Vec<f64>,
}

impl Roughness {
    pub fn new(n: usize) -> Self {
        let begins = [0.0, f64::INFINITY, f64::NEG_INFINITY];
        Self { measures: begins.into_iter().flat_map(|begin| vec![begin; n]).collect() }
    }

    pub fn add<T: Scalar>(&mut self, stepper: &Stepper<T>, h: f64, k1: &[T], x1: &[T]) {
        let n = x1.len();
        let (sums, ranges) = self.measures.split_at_mut(n);
        stepper.add_embedded_errors(h, k1, sums);
        let (lows, highs) = ranges.split_at_mut(n);
        for ((low, high), x) in lows.iter_mut().zip(highs).zip(x1) {
            let x = x.value();
            *low = if x < *low { x } else { *low };
            *high = if x > *high { x } else { *high };
        }
    }

    /// The lowest and the highest value of each state.
    pub fn ranges(&self) -> Vec<(f64, f64)> {
        let n = self.measures.len() / 3;
        self.measures[n..2 * n].iter().copied().zip(self.measures[2 * n..].iter().copied()).collect()
    }

    /// The largest sum as a share of its state's range.
    pub fn worst(&self) -> f64 {
        let shares = self.measures.iter().zip(self.ranges()).map(|(s, r)| s / (r.1 - r.0));
        shares.filter(|s| s.is_finite()).fold(0.0, f64::max)
    }
}
