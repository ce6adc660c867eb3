//! The exact Routh test and its array of Hurwitz minors.
//!
//! # Purpose
//! Decides without any threshold whether a real polynomial has all its roots in the open left half
//! plane, and keeps the integers from which I_n follows exactly.
//!
//! # Method
//! Fraction-free elimination of the Hurwitz matrix. With the rows r of Routh's array and the
//! leading minors Δ_k, the integers D_k\[i\] = Δ_(k−1)·r_k\[i\] obey
//!   D_(k+1)\[i\] = (Δ_k·D_(k−1)\[i+1\] − D_(k−1)\[0\]·D_k\[i+1\]) / Δ_(k−2),  Δ_0 = Δ_(−1) = 1,
//! and the division leaves no remainder. Where a Δ_k vanishes, Sturm's chain decides.
//!
//! # References
//! E. J. Routh (1877); A. Hurwitz, Math. Ann. 46 (1895); E. H. Bareiss, Math. Comp. 22 (1968);
//! F. R. Gantmacher, The Theory of Matrices, vol. 2, ch. XV.
//!
//! # Numerical aspects
//! Exact. D_k has about k times the bits of the coefficients; n²/4 steps of two products and one
//! division each.

use super::stability::{Array, Stability};
use super::sturm;
use crate::exact::IBig;
use dashu_base::Signed;

/// Tests the polynomial with integer coefficients `h` (descending, `h[0]` ≠ 0).
pub fn test(h: &[IBig]) -> Stability {
    let negative = h[0].is_negative();
    let h: Vec<IBig> = h.iter().map(|a| if negative { -a } else { a.clone() }).collect();
    match array(&h) {
        Some(array) => {
            let n = h.len() - 1;
            // signs of Routh's first column r_k[0] = Δ_k/Δ_(k−1)
            let minors: Vec<bool> = (0..=n).map(|k| array.rows[k][0].is_negative()).collect();
            let sign = |k: usize| if k <= 1 { minors[k] } else { minors[k] != minors[k - 1] };
            let changes = (1..=n).filter(|&k| sign(k) != sign(k - 1)).count();
            if changes == 0 { Stability::Stable(array) } else { Stability::Unstable(changes) }
        }
        None => sturm::classify(&h),
    }
}

/// The rows of the test, or nothing where a leading entry vanishes.
fn array(h: &[IBig]) -> Option<Array> {
    let n = h.len() - 1;
    let pick = |from: usize| h.iter().skip(from).step_by(2).cloned().collect::<Vec<_>>();
    let mut rows = vec![pick(0), pick(1)];
    for k in 1..n {
        if rows[k][0] == IBig::ZERO {
            return None;
        }
        let next = step(&rows, k, n);
        rows.push(next);
    }
    rows.truncate(n + 1);
    (rows[n][0] != IBig::ZERO).then_some(Array { rows })
}

/// D_(k+1) from D_k and D_(k−1).
fn step(rows: &[Vec<IBig>], k: usize, n: usize) -> Vec<IBig> {
    let (old, row) = (&rows[k - 1], &rows[k]);
    let divisor = if k >= 3 { Some(&rows[k - 2][0]) } else { None };
    (0..=(n - k - 1) / 2)
        .map(|i| {
            // Δ_k·D_(k−1)[i+1] − D_(k−1)[0]·D_k[i+1]
            let mut d = &row[0] * &old[i + 1];
            if let Some(next) = row.get(i + 1) {
                d -= &old[0] * next;
            }
            match divisor {
                Some(divisor) => d / divisor,
                None => d,
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integer coefficients of Π (s − r) for real r and Π (s² − 2 re s + |z|²) for pairs.
    fn from_roots(real: &[i64], pairs: &[(i64, i64)]) -> Vec<IBig> {
        let mut h = vec![IBig::ONE];
        let mut multiply = |q: &[i64]| {
            let mut out = vec![IBig::ZERO; h.len() + q.len() - 1];
            for (i, a) in h.iter().enumerate() {
                for (j, b) in q.iter().enumerate() {
                    out[i + j] += a * IBig::from(*b);
                }
            }
            h = out;
        };
        for r in real {
            multiply(&[1, -r]);
        }
        for (re, im) in pairs {
            multiply(&[1, -2 * re, re * re + im * im]);
        }
        h
    }

    #[test]
    fn roots_are_counted_where_they_were_put() {
        type Case = (&'static [i64], &'static [(i64, i64)], Stability);
        let cases: [Case; 10] = [
            (&[1], &[], Stability::Unstable(1)),
            (&[-1, 1], &[], Stability::Unstable(1)),
            (&[-1, 0], &[], Stability::Axis),
            (&[0, 0], &[], Stability::Axis),
            (&[0, 3], &[], Stability::Unstable(1)),
            (&[-2], &[(0, 1)], Stability::Axis),
            (&[-2], &[(0, 1), (0, 1)], Stability::Axis),
            (&[-2, 2], &[(0, 1), (0, 1), (0, 3)], Stability::Unstable(1)),
            (&[-1], &[(1, 2), (-1, 2), (1, 2), (-1, 2)], Stability::Unstable(4)),
            (&[-3, 5, 5, 0], &[(2, 1), (-2, 1), (0, 4)], Stability::Unstable(4)),
        ];
        for (real, pairs, expected) in cases {
            assert_eq!(test(&from_roots(real, pairs)), expected, "{real:?} {pairs:?}");
        }
        let stable = test(&from_roots(&[-1, -7], &[(-1, 3), (-2, 1)]));
        assert!(matches!(stable, Stability::Stable(_)));
    }

    #[test]
    fn the_last_minors_are_the_hurwitz_determinants() {
        // H = s³ + 2s² + 3s + 4: Δ_1 = 2, Δ_2 = 2·3 − 1·4 = 2, Δ_3 = 4·Δ_2 = 8
        let h: Vec<IBig> = [1, 2, 3, 4].map(IBig::from).to_vec();
        let Stability::Stable(array) = test(&h) else { panic!("stable") };
        let leading: Vec<IBig> = array.rows.iter().map(|r| r[0].clone()).collect();
        assert_eq!(leading, [1, 2, 2, 8].map(IBig::from));
    }
}
