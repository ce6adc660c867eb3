//! What the data do not see.
//!
//! # Purpose
//! Name the directions in parameter space along which the predictions do not move more than the
//! noise allows to see.
//!
//! # Method
//! Singular values of the whitened sensitivities with every column scaled by the size of its unknown.
//! A direction with singular value s is known to a relative deviation of 1/s; where that exceeds
//! five, not even the order of magnitude is seen.
//!
//! # References
//! G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. 2013, §5.5; D. A. Belsley, E. Kuh,
//! R. E. Welsch, Regression Diagnostics, 1980, ch. 3.

use super::triangle::Triangle;

/// A direction in parameter space that the data do not see.
#[derive(Debug, Clone, PartialEq)]
pub struct Direction {
    /// Unknowns and their weights in units of their sizes, largest first, small ones left out.
    pub weights: Vec<(String, f64)>,
    /// Relative standard deviation along it; infinite where nothing at all is seen.
    pub deviation: f64,
}

/// Relative deviation from which on a direction counts as unseen.
const UNSEEN: f64 = 5.0;
/// Singular value over the largest one below which nothing but rounding is left.
const ROUNDING: f64 = 1e-10;

/// The unseen directions of a whitened problem; `sizes[j]` is the size that unknown j may reasonably
/// have, so that a change of that size counts as one.
pub fn unseen(triangle: &Triangle, names: &[String], sizes: &[f64]) -> Vec<Direction> {
    if names.is_empty() {
        return Vec::new();
    }
    let factor = triangle.clone().scaled(sizes).factor();
    if !(0..names.len()).all(|i| (0..names.len()).all(|j| factor[(i, j)].is_finite())) {
        return Vec::new();
    }
    let Ok(svd) = factor.thin_svd() else { return Vec::new() };
    let singular: Vec<f64> = svd.S().column_vector().iter().copied().collect();
    let largest = singular.iter().fold(0.0, |a: f64, b| a.max(*b));
    let v = svd.V();
    singular
        .iter()
        .enumerate()
        .filter(|(_, s)| **s < ROUNDING * largest || **s < 1.0 / UNSEEN)
        .map(|(k, s)| Direction {
            weights: main_weights(names, (0..names.len()).map(|j| v[(j, k)])),
            deviation: if *s <= ROUNDING * largest { f64::INFINITY } else { 1.0 / s },
        })
        .collect()
}

/// The weights above a tenth of the largest, largest first, the largest positive.
fn main_weights(names: &[String], weights: impl Iterator<Item = f64>) -> Vec<(String, f64)> {
    let mut named: Vec<(String, f64)> = names.iter().cloned().zip(weights).collect();
    named.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    let lead = named.first().map_or(1.0, |w| w.1);
    named.retain(|w| w.1.abs() >= 0.1 * lead.abs());
    for weight in &mut named {
        weight.1 *= lead.signum();
    }
    named
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_that_alone_is_seen_is_named() {
        let t: Vec<f64> = (0..100).map(|i| f64::from(i) * 0.01).collect();
        let ones = vec![10.0; 100];
        let mut triangle = Triangle::new(3);
        triangle.push(&[&ones, &ones, &t.iter().map(|t| 100.0 * t).collect::<Vec<_>>()], &t);
        let names: Vec<String> = ["a", "b", "c"].map(String::from).to_vec();
        let found = unseen(&triangle, &names, &[1.0; 3]);
        assert_eq!(found.len(), 1);
        let w = &found[0].weights;
        assert_eq!(w.len(), 2);
        assert!((w[0].1 + w[1].1).abs() < 1e-9 && found[0].deviation.is_infinite());
    }

    #[test]
    fn a_well_seen_problem_has_none() {
        let t: Vec<f64> = (0..100).map(f64::from).collect();
        let mut triangle = Triangle::new(2);
        triangle.push(&[&vec![1.0; 100], &t], &t);
        assert!(unseen(&triangle, &["a".into(), "b".into()], &[1.0; 2]).is_empty());
    }
}
