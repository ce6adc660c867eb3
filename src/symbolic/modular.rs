//! Images of polynomials modulo a prime, for bounds on the degree of a common divisor.
//!
//! Purpose: to find quickly that two polynomials have no common divisor in some symbol.
//! Method: every other symbol is set to a fixed residue; where the leading coefficients survive, the degree of the
//! greatest common divisor of the images is no smaller than that of the polynomials.
//! References: D. E. Knuth, The Art of Computer Programming 2, section 4.6.1.
//! Numerical aspects: exact; the bound holds for every choice of residues, only its sharpness is a matter of luck.

use super::integer::Integer;
use super::polynomial::Polynomial;
use dashu_int::IBig;

/// 2^61 − 1, a prime.
const PRIME: u64 = (1 << 61) - 1;

fn times(x: u64, y: u64) -> u64 {
    (u128::from(x) * u128::from(y) % u128::from(PRIME)) as u64
}

fn power(base: u64, mut exponent: u64) -> u64 {
    let (mut product, mut square) = (1, base);
    while exponent > 0 {
        if exponent & 1 == 1 {
            product = times(product, square);
        }
        square = times(square, square);
        exponent >>= 1;
    }
    product
}

fn residue(value: &Integer) -> u64 {
    let rest = match value {
        Integer::Word(w) => i128::from(*w).rem_euclid(i128::from(PRIME)),
        Integer::Wide(w) => {
            let rest = i128::try_from(&**w % IBig::from(PRIME)).unwrap_or(0);
            rest.rem_euclid(i128::from(PRIME))
        }
    };
    rest as u64
}

/// The residues that stand for the symbols: fixed and well mixed, so that every run is the same.
fn chosen(symbol: usize) -> u64 {
    power(0x9e37_79b9_7f4a_7c15 % PRIME, 2 * symbol as u64 + 3)
}

/// The coefficients in one symbol from the power 0 up; none where the leading one vanishes.
fn image(polynomial: &Polynomial, symbol: usize) -> Option<Vec<u64>> {
    let ring = polynomial.ring();
    let mut image = vec![0; polynomial.degree(symbol) as usize + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let value = ring
            .powers(*monomial)
            .filter(|(k, _)| *k != symbol)
            .fold(residue(coefficient), |value, (k, e)| times(value, power(chosen(k), u64::from(e))));
        let place = &mut image[ring.exponent(*monomial, symbol) as usize];
        *place = (*place + value) % PRIME;
    }
    (image.last() != Some(&0)).then_some(image)
}

/// A bound on the degree in one symbol of the greatest common divisor.
pub fn common_degree_bound(x: &Polynomial, y: &Polynomial, symbol: usize) -> u32 {
    let trivial = x.degree(symbol).min(y.degree(symbol));
    let (Some(mut x), Some(mut y)) = (image(x, symbol), image(y, symbol)) else { return trivial };
    while !y.is_empty() {
        let inverse = power(y[y.len() - 1], PRIME - 2);
        while x.len() >= y.len() {
            let (factor, shift) = (times(x[x.len() - 1], inverse), x.len() - y.len());
            for (k, c) in y.iter().enumerate() {
                x[k + shift] = (x[k + shift] + PRIME - times(factor, *c)) % PRIME;
            }
            while x.last() == Some(&0) {
                x.pop();
            }
        }
        std::mem::swap(&mut x, &mut y);
    }
    (x.len() as u32).saturating_sub(1).min(trivial)
}
