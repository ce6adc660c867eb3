//! Polynomials over f64 and over exact numbers; roots; the Hurwitz test.
//!
//! Coefficients stand in descending order, as in (3.11): `h[0]` belongs to the highest power.

pub mod roots;
pub mod routh;
pub mod stability;
mod sturm;
pub mod whole;

use num_complex::Complex64;

/// H(s) by Horner's rule; `h` descending.
///
/// ```
/// use gyrospec::poly::at;
/// use num_complex::Complex64;
/// // H(s) = s² + 2s + 3 at s = j: −1 + 2j + 3
/// assert_eq!(at(&[1.0, 2.0, 3.0], Complex64::I), Complex64::new(2.0, 2.0));
/// ```
pub fn at(h: &[f64], s: Complex64) -> Complex64 {
    h.iter().fold(Complex64::ZERO, |sum, &a| sum * s + a)
}

/// H(jω), the frequency response of a polynomial; `omega` in rad/s.
///
/// ```
/// use gyrospec::poly::at_frequency;
/// assert_eq!(at_frequency(&[2.0, 1.0], 3.0).im, 6.0);
/// ```
pub fn at_frequency(h: &[f64], omega: f64) -> Complex64 {
    at(h, Complex64::new(0.0, omega))
}

/// The product of two polynomials, descending.
///
/// ```
/// assert_eq!(gyrospec::poly::product(&[1.0, 2.0], &[1.0, 3.0]), [1.0, 5.0, 6.0]);
/// ```
pub fn product(p: &[f64], q: &[f64]) -> Vec<f64> {
    if p.is_empty() || q.is_empty() {
        return Vec::new();
    }
    let mut out = vec![0.0; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

/// The coefficients b0 … b(n−1) of the even polynomial G = C(s)C(−s) in s^(2n−2), s^(2n−4) …,
/// for C of n coefficients, descending; rounded.
///
/// ```
/// // C = s + 2: C(s)C(−s) = 4 − s²
/// assert_eq!(gyrospec::poly::even_square(&[1.0, 2.0]), [-1.0, 4.0]);
/// ```
pub fn even_square(c: &[f64]) -> Vec<f64> {
    even_part_of_product(c, c)
}

/// The even powers s^(2n−2), s^(2n−4) … 1 of P(s)Q(−s), for P and Q of n coefficients each.
///
/// On the imaginary axis the odd powers are odd in ω, so that they drop out of an integral
/// over all ω whose denominator is even.
///
/// # Panics
/// When the lengths differ.
pub fn even_part_of_product(p: &[f64], q: &[f64]) -> Vec<f64> {
    assert_eq!(p.len(), q.len(), "two polynomials of one length");
    let n = p.len();
    let mut out = vec![0.0; n];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            if (i + j) % 2 == 0 {
                // q's power is n−1−j, its sign under s → −s is (−1)^(n−1−j)
                let sign = if (n - 1 - j).is_multiple_of(2) { 1.0 } else { -1.0 };
                out[usize::midpoint(i, j)] += sign * a * b;
            }
        }
    }
    out
}
