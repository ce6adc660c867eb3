//! How sure an improvement is.
//!
//! # Purpose
//! A 95 % interval for the fall of the root mean square from one model to another on the same data.
//!
//! # Method
//! Paired moving-block bootstrap: blocks of consecutive times are drawn with replacement and both
//! models' squared residuals go along together. Block length by the rule of Politis and White for
//! the correlation time of the difference of the squares.
//!
//! # References
//! H. R. Künsch, Annals of Statistics 17 (1989) 1217-1241; D. N. Politis, H. White, Econometric
//! Reviews 23 (2004) 53-70, corrected 28 (2009) 372-375.
//!
//! # Numerical aspects
//! Sums over blocks come from running totals: a draw costs the number of blocks, not of samples. There are so many blocks at
//! most that the interval's own ends are known to two per cent of it; longer ones than the memory asks for are as valid.

use super::noise::correlation_time;
use crate::spectrum::Interval;
use rand::{RngExt, SeedableRng};

/// The fall of the root mean square from `before` to `after`, with its interval; the residuals of one
/// model beside the other's, stretch by stretch. NaN without samples.
///
/// ```
/// use gyrospec::estimate::improvement;
/// let before: Vec<f64> = (0..500).map(|i| 2.0 + (f64::from(i) * 1.7).sin()).collect();
/// let after: Vec<f64> = (0..500).map(|i| (f64::from(i) * 1.7).sin()).collect();
/// let gain = improvement(&[&before], &[&after], 1);
/// assert!(gain.low > 1.0 && gain.low < gain.value && gain.value < gain.high);
/// ```
pub fn improvement(before: &[&[f64]], after: &[&[f64]], seed: u64) -> Interval {
    let squares: Vec<(f64, f64)> = before
        .iter()
        .zip(after)
        .flat_map(|(b, a)| b.iter().zip(a.iter()).map(|(b, a)| (b * b, a * a)))
        .collect();
    let n = squares.len();
    if n == 0 {
        return Interval { value: f64::NAN, low: f64::NAN, high: f64::NAN };
    }
    let totals = running_totals(&squares);
    let fall = |b: f64, a: f64| (b / n as f64).sqrt() - (a / n as f64).sqrt();
    let value = fall(totals[n].0, totals[n].1);
    let block = block_length(&squares);
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let mut draws: Vec<f64> = (0..DRAWS)
        .map(|_| {
            let (b, a) = resample(&totals, n, block, &mut rng);
            fall(b, a)
        })
        .collect();
    draws.sort_unstable_by(f64::total_cmp);
    let quantile = |q: f64| draws[((DRAWS - 1) as f64 * q).round() as usize];
    Interval { value, low: quantile(0.025).min(value), high: quantile(0.975).max(value) }
}

const DRAWS: usize = 2000;
/// Blocks in a draw, at most: the standard error of a deviation from so many is 1/√(2·2000).
const BLOCKS: usize = 2000;

fn running_totals(squares: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut totals = vec![(0.0, 0.0)];
    for (b, a) in squares {
        let last = totals[totals.len() - 1];
        totals.push((last.0 + b, last.1 + a));
    }
    totals
}

/// b = (3/2 (G/g)² N)^(1/3) with G/g = (τ² − 1)/(2τ) for a memory of τ samples.
fn block_length(squares: &[(f64, f64)]) -> usize {
    let n = squares.len() as f64;
    let mean = squares.iter().map(|(b, a)| b - a).sum::<f64>() / n;
    let difference: Vec<f64> = squares.iter().map(|(b, a)| b - a - mean).collect();
    let memory = correlation_time(&[&difference]);
    let ratio = (memory * memory - 1.0) / (2.0 * memory);
    let length = (1.5 * ratio * ratio * n).cbrt().max(memory);
    (length.ceil() as usize).clamp(squares.len().div_ceil(BLOCKS), (squares.len() / 5).max(1))
}

/// The two sums over one draw of n samples in circular blocks.
fn resample(totals: &[(f64, f64)], n: usize, block: usize, rng: &mut rand_chacha::ChaCha8Rng) -> (f64, f64) {
    let (mut before, mut after, mut drawn) = (0.0, 0.0, 0);
    while drawn < n {
        let length = block.min(n - drawn);
        let from: usize = rng.random_range(0..n);
        let to = from + length;
        let mut add = |a: usize, b: usize| {
            before += totals[b].0 - totals[a].0;
            after += totals[b].1 - totals[a].1;
        };
        add(from, to.min(n));
        if to > n {
            add(0, to - n);
        }
        drawn += length;
    }
    (before, after)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::noise::Autoregression;
    use rand_distr::{Distribution, StandardNormal};

    #[test]
    fn the_interval_holds_no_gain_where_there_is_none() {
        let ar = Autoregression::from_coefficients(&[0.9], 1.0).unwrap();
        let mut misses = 0;
        for seed in 0..100 {
            let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
            let mut series = || {
                let e: Vec<f64> = (0..3000).map(|_| StandardNormal.sample(&mut rng)).collect();
                ar.colour(&e)
            };
            let gain = improvement(&[&series()], &[&series()], seed);
            misses += usize::from(gain.low > 0.0 || gain.high < 0.0);
        }
        assert!(misses <= 12, "{misses} of 100");
    }
}
