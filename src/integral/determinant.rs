//! I_n as the published ratio of determinants.
//!
//! # Purpose
//! The definition behind the printed tables, as a cross-check of the recursion; not the default
//! path, since no pivoting strategy saves it from stiff or lightly damped filters.
//!
//! # Method
//! I_n = (−1)ⁿ⁻¹·N/(2·a0·Δ), Δ the Hurwitz determinant with rows (a1 a3 a5 …), (a0 a2 a4 …),
//! (0 a1 a3 …) … and N the same with b0 … b(n−1) in place of the first row. Both are factored by
//! faer with partial pivoting. Rows are scaled by powers of two and the diagonal is multiplied up
//! with its exponent apart, so that nothing overflows at any order.
//!
//! # References
//! (3.10), (3.11); V. A. Besekerskii, E. P. Popov, Theory of Automatic Control Systems (1972);
//! H. M. James, N. B. Nichols, R. S. Phillips, Theory of Servomechanisms (1947), appendix.
//!
//! # Numerical aspects
//! No bound. Relative errors of 10⁻¹⁴ for well-damped filters of order 10, of 1 for stiff ones.

use super::{Integrand, Numerator};
use crate::exact::{exponent, integers_time_shift, ldexp};
use crate::poly::even_square;
use crate::{Error, Result};
use faer::Mat;

/// The ratio of determinants in doubles; says nothing about stability.
///
/// ```
/// use gyrospec::integral::{Integrand, determinant};
/// let i2 = determinant::evaluate(&Integrand::new(&[1.0, 2.0, 3.0], &[0.0, 1.0])?)?;
/// assert!((i2 - 1.0 / 12.0).abs() < 1e-16);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `NotComputed` where the ratio is no finite double.
pub fn evaluate(p: &Integrand<'_>) -> Result<f64> {
    let n = p.order();
    let time = i64::from(integers_time_shift(p.h));
    // s = 2^time·s′
    let h: Vec<f64> = p.h.iter().enumerate().map(|(i, &a)| ldexp(a, time * (n - i) as i64)).collect();
    let g = match p.numerator {
        Numerator::Even(g) => g.to_vec(),
        Numerator::Square(c) => {
            let mut full = vec![0.0; n - c.len()];
            full.extend_from_slice(c);
            even_square(&full)
        }
    };
    let g: Vec<f64> = g.iter().enumerate().map(|(k, &b)| ldexp(b, 2 * time * (n - 1 - k) as i64)).collect();
    let (hurwitz, hurwitz_exponent) = determinant(n, |j| entry(&h, 2 * j as i64 + 1), &h);
    let (numerator, numerator_exponent) = determinant(n, |j| g[j], &h);
    let sign = if n % 2 == 1 { 0.5 } else { -0.5 };
    let value = ldexp(sign * numerator / (h[0] * hurwitz), numerator_exponent - hurwitz_exponent + time);
    if value.is_finite() {
        return Ok(value);
    }
    Err(Error::not_computed("the ratio of determinants is no finite double"))
}

/// a_i, zero outside 0 … n.
fn entry(h: &[f64], i: i64) -> f64 {
    usize::try_from(i).ok().and_then(|i| h.get(i)).copied().unwrap_or(0.0)
}

/// Mantissa and exponent of the determinant with a given first row and Hurwitz rows below.
fn determinant(n: usize, first: impl Fn(usize) -> f64, h: &[f64]) -> (f64, i64) {
    let mut total = 0;
    let mut matrix = Mat::<f64>::zeros(n, n);
    for i in 0..n {
        let row: Vec<f64> =
            (0..n).map(|j| if i == 0 { first(j) } else { entry(h, 2 * j as i64 + 1 - i as i64) }).collect();
        let largest = row.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        let shift = if largest > 0.0 && largest.is_finite() { i64::from(exponent(largest)) } else { 0 };
        total += shift;
        for (j, x) in row.iter().enumerate() {
            matrix[(i, j)] = ldexp(*x, -shift);
        }
    }
    let lu = matrix.partial_piv_lu();
    let mut mantissa = parity(lu.P().arrays().0);
    for i in 0..n {
        mantissa *= lu.U()[(i, i)];
        if mantissa != 0.0 && mantissa.is_finite() {
            let shift = i64::from(exponent(mantissa));
            mantissa = ldexp(mantissa, -shift);
            total += shift;
        }
    }
    (mantissa, total)
}

/// +1 for an even permutation, −1 for an odd one.
fn parity(permutation: &[usize]) -> f64 {
    let mut seen = vec![false; permutation.len()];
    let mut sign = 1.0;
    for start in 0..permutation.len() {
        let mut at = start;
        while !seen[at] {
            seen[at] = true;
            at = permutation[at];
            if at != start {
                sign = -sign;
            }
        }
    }
    sign
}
