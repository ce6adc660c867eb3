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
    /// Unknowns and their weights in units of their sizes; the largest part in what cancels first, small
    /// parts left out.
    pub weights: Vec<(String, f64)>,
    /// Relative standard deviation along it; infinite where nothing at all is seen.
    pub deviation: f64,
}

/// Relative deviation from which on a direction counts as unseen.
const UNSEEN: f64 = 5.0;
/// Relative deviation of an unknown along a direction below which it is known well enough there.
const KNOWN: f64 = 0.25;
/// Singular value over the largest one below which nothing but rounding is left.
const ROUNDING: f64 = 1e-10;

/// The unseen directions of a whitened problem; `sizes[j]` is the size that unknown j may reasonably
/// have, so that a change of that size counts as one.
pub fn unseen(triangle: &Triangle, names: &[String], sizes: &[f64]) -> Vec<Direction> {
    if names.is_empty() {
        return Vec::new();
    }
    let scaled = triangle.clone().scaled(sizes);
    let norms = scaled.column_norms();
    let factor = scaled.factor();
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
        .map(|(k, s)| {
            let deviation = if *s <= ROUNDING * largest { f64::INFINITY } else { 1.0 / s };
            let mut weights =
                main_weights(names, (0..names.len()).map(|j| v[(j, k)]), &norms, ROUNDING * largest);
            weights.retain(|(_, w)| w.abs() * deviation >= KNOWN);
            Direction { weights, deviation }
        })
        .filter(|d| !d.weights.is_empty())
        .collect()
}

/// Directions without those that several unknowns of another one make up among themselves.
pub fn told_once(directions: Vec<Direction>) -> Vec<Direction> {
    let mut kept: Vec<Direction> = Vec::new();
    let mut longest_first = directions;
    longest_first.sort_by_key(|d| std::cmp::Reverse(d.weights.len()));
    for d in longest_first {
        let within = |other: &Direction| {
            d.weights.iter().all(|(name, _)| other.weights.iter().any(|(known, _)| known == name))
        };
        match kept.iter_mut().find(|other| d.weights.len() > 1 && within(other)) {
            Some(other) => other.deviation = other.deviation.max(d.deviation),
            None => kept.push(d),
        }
    }
    kept
}

/// The weights of what cancels along a direction, weight times column, above a tenth of the largest;
/// where no column is longer than `nothing`, the weights themselves. Largest first, the first positive.
fn main_weights(
    names: &[String],
    weights: impl Iterator<Item = f64>,
    norms: &[f64],
    nothing: f64,
) -> Vec<(String, f64)> {
    let mut named: Vec<(&String, f64, f64)> =
        names.iter().zip(weights).zip(norms).map(|((name, w), norm)| (name, w, w.abs() * norm)).collect();
    if named.iter().all(|n| n.2 <= nothing) {
        for n in &mut named {
            n.2 = n.1.abs();
        }
    }
    named.sort_by(|a, b| b.2.total_cmp(&a.2));
    let (sign, most) = named.first().map_or((1.0, 0.0), |n| (n.1.signum(), n.2));
    named.into_iter().filter(|n| n.2 >= 0.1 * most).map(|(name, w, _)| (name.clone(), sign * w)).collect()
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

    /// A start near 0 is uncertain against itself, and what else bends with it is not.
    #[test]
    fn what_is_known_is_not_told_beside_a_start_near_zero() {
        let t: Vec<f64> = (0..100).map(|i| 0.01 * f64::from(i)).collect();
        let stiffness: Vec<f64> = t.iter().map(|t| 1e4 * (1.0 - t)).collect();
        let start: Vec<f64> = t.iter().map(|t| 1.0 - t * t).collect();
        let mut triangle = Triangle::new(2);
        triangle.push(&[&stiffness, &start], &t);
        let names = ["k".to_string(), "q(0)".into()];
        let found = unseen(&triangle, &names, &[1.0, 1e-3]);
        assert_eq!(found.len(), 1);
        assert!(found[0].weights.iter().all(|(name, _)| name == "q(0)"), "{found:?}");
    }

    #[test]
    fn two_directions_among_the_same_unknowns_are_told_as_one() {
        let t: Vec<f64> = (0..100).map(f64::from).collect();
        let mut triangle = Triangle::new(4);
        triangle.push(&[&t, &t, &t, &[0.0; 100]], &t);
        let names = ["R", "C", "k", "mute"].map(String::from);
        let found = told_once(unseen(&triangle, &names, &[1.0; 4]));
        let told: Vec<usize> = found.iter().map(|d| d.weights.len()).collect();
        assert_eq!(told, [3, 1], "{found:?}");
    }
}
