//! Polynomials of doubles of which nothing is rounded: integers over one power of two.
//!
//! # Numerical aspects
//! s = 2^time·s′ with one `time` for all polynomials of a problem keeps the integers short; it changes nothing else.

use crate::exact::{IBig, Rounded, integers, round_ratio};

/// A polynomial p(s) = 2^`exponent` Σ kᵢ s′ⁱ with s = 2^`time`·s′.
#[derive(Debug, Clone)]
pub struct Whole {
    /// kᵢ, the highest power first.
    pub coefficients: Vec<IBig>,
    /// The power of two taken out.
    pub exponent: i64,
    time: i32,
}

impl Whole {
    /// A polynomial of finite doubles, descending.
    pub fn new(p: &[f64], time: i32) -> Self {
        let (coefficients, exponent) = integers(p, time, |i| (p.len() - 1 - i) as i32);
        Self { coefficients, exponent, time }
    }

    /// The product with another of the same `time`.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let (p, q) = (&self.coefficients, &other.coefficients);
        let mut coefficients = vec![IBig::ZERO; p.len() + q.len() - 1];
        for (i, a) in p.iter().enumerate() {
            for (j, b) in q.iter().enumerate() {
                coefficients[i + j] += a * b;
            }
        }
        Self { coefficients, exponent: self.exponent + other.exponent, time: self.time }
    }

    /// s times this.
    #[must_use]
    pub fn differentiated(mut self) -> Self {
        self.coefficients.push(IBig::ZERO);
        self.exponent += i64::from(self.time);
        self
    }

    /// The coefficients of s′^2n, s′^(2n−2) … 1 in P(s)Q(−s), to be taken times 2^(both exponents), for products of
    /// no higher even power.
    pub fn even_part(&self, other: &Self, n: usize) -> Vec<IBig> {
        let (p, q) = (&self.coefficients, &other.coefficients);
        let mut out = vec![IBig::ZERO; n + 1];
        for (i, a) in p.iter().rev().enumerate() {
            for (j, b) in q.iter().rev().enumerate().filter(|(j, _)| (i + j) % 2 == 0) {
                // Σ (−1)ʲ pᵢ qⱼ s^(i+j)
                let Some(at) = n.checked_sub(usize::midpoint(i, j)) else { continue };
                if j % 2 == 0 {
                    out[at] += a * b;
                } else {
                    out[at] -= a * b;
                }
            }
        }
        out
    }

    /// The coefficients of p(s), each the nearest double; infinite where none is near.
    pub fn rounded(&self) -> Vec<f64> {
        rounded(&self.coefficients, self.exponent, self.time)
    }
}

/// The coefficients of 2^`exponent` Σ kᵢ (s/2^`step`)ⁱ, each the nearest double; infinite where none is near.
pub fn rounded(k: &[IBig], exponent: i64, step: i32) -> Vec<f64> {
    let powers = (0..k.len() as i64).rev();
    let near = |(k, i)| match round_ratio(k, &IBig::ONE, exponent - i64::from(step) * i) {
        Rounded::Value(x, _) => x,
        Rounded::OutOfRange(_) => f64::INFINITY,
    };
    k.iter().zip(powers).map(near).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_come_out_whole_whatever_the_time() {
        for time in [-7, 0, 3] {
            let [p, q] = [[0.5, 3.0], [2.0, -0.25]].map(|c| Whole::new(&c, time));
            // (s/2 + 3)(2s − 1/4)s = s³ + 47/8 s² − 3/4 s
            assert_eq!(p.times(&q).differentiated().rounded(), [1.0, 5.875, -0.75, 0.0]);
            // (s/2 + 3)(−2s − 1/4): −s² − 49/8 s − 3/4
            let even = p.even_part(&q, 1);
            let back =
                |k: &IBig, i: i64| round_ratio(k, &IBig::ONE, p.exponent + q.exponent - i64::from(time) * i);
            assert_eq!(back(&even[0], 2), Rounded::Value(-1.0, true));
            assert_eq!(back(&even[1], 0), Rounded::Value(-0.75, true));
        }
    }
}
