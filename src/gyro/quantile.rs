//! # Purpose
//! Percentiles of a simulated error, with their 99 % intervals.
//!
//! # Method
//! At each x every replicate has a part of its time below x; these parts are independent, and their mean has an
//! interval by Student's t. The percentile is where the mean reaches the part wanted, its interval where the ends of
//! the mean's interval do: the scatter within a replicate, which a slow compass makes dependent, is not used.
//!
//! # References
//! A. M. Law, Simulation Modeling and Analysis, ch. 9, for replicates.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// A percentile with its 99 % interval; an end is infinite where the replicates are too few to tell it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantile {
    /// The percentile.
    pub value: f64,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}

impl Quantile {
    pub(super) const NONE: Self = Self { value: f64::NAN, low: f64::NEG_INFINITY, high: f64::INFINITY };
}

/// Samples of each replicate, in order of size.
pub(super) struct Replicates {
    each: Vec<Vec<f64>>,
    all: Vec<f64>,
}

impl Replicates {
    pub fn new(mut each: Vec<Vec<f64>>) -> Self {
        for r in &mut each {
            r.sort_by(f64::total_cmp);
        }
        let mut all = each.concat();
        all.sort_by(f64::total_cmp);
        Self { each, all }
    }

    /// The part of the time below x: mean, and half its 99 % interval.
    fn below(&self, x: f64) -> (f64, f64) {
        let parts: Vec<f64> =
            self.each.iter().map(|r| r.partition_point(|v| *v < x) as f64 / r.len().max(1) as f64).collect();
        let (mean, margin, _) = interval(&parts);
        (mean, margin)
    }

    /// The value below which `part` of the time lies.
    pub fn quantile(&self, part: f64) -> Quantile {
        let first = |reaches: &dyn Fn((f64, f64)) -> bool| {
            self.all.get(self.all.partition_point(|x| !reaches(self.below(*x)))).copied()
        };
        let value = first(&|(mean, _)| mean >= part);
        let low = first(&|(mean, margin)| mean + margin >= part).filter(|x| *x > self.all[0]);
        let high = first(&|(mean, margin)| mean - margin >= part);
        Quantile {
            value: value.or(self.all.last().copied()).unwrap_or(f64::NAN),
            low: low.unwrap_or(f64::NEG_INFINITY),
            high: high.unwrap_or(f64::INFINITY),
        }
    }
}

/// Mean of replicates, half the width of its 99 % interval, and its standard error.
pub(super) fn interval(v: &[f64]) -> (f64, f64, f64) {
    let n = v.len() as f64;
    let mean = v.iter().sum::<f64>() / n;
    let variance = v.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    let t = StudentsT::new(0.0, 1.0, n - 1.0).map_or(f64::INFINITY, |d| d.inverse_cdf(0.995));
    let error = (variance / n).sqrt();
    (mean, t * error, error)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn intervals_hold_the_percentile_as_often_as_they_say() {
        // replicates whose samples hang together: each has a shift of its own, x = u + v, u and v even on 0 … 1
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let (mut held, tries) = (0, 200);
        for _ in 0..tries {
            let each = (0..20).map(|_| {
                let shift: f64 = rng.random_range(0.0..1.0);
                (0..200).map(|_| shift + rng.random_range(0.0..1.0)).collect()
            });
            let q = Replicates::new(each.collect()).quantile(0.8);
            // P(u + v < x) = 1 − (2 − x)²/2 for x > 1
            let wanted = 2.0 - 0.4f64.sqrt();
            held += i32::from(q.low < wanted && wanted < q.high);
            assert!((q.value - wanted).abs() < 0.4);
        }
        assert!(held >= 194, "{held} of {tries}");
        let few = Replicates::new(vec![vec![1.0, 2.0], vec![3.0, 4.0]]).quantile(0.95);
        assert!(few.low == f64::NEG_INFINITY || few.high == f64::INFINITY);
    }
}
