//! The symbols of a polynomial and its packed exponents.
//!
//! Purpose: one machine number for all exponents of a term.
//! Method: equal bit fields, the first symbol in the highest field, so that the order of the numbers is the
//! lexicographic order of the terms and the product of two terms is one addition.
//! References: M. Monagan, R. Pearce, Sparse polynomial division using a heap, J. Symb. Comp. 46 (2011) 807.
//! Numerical aspects: a carry out of a field is found and reported, never passed on.

use crate::{Error, Result};
use std::sync::Arc;

/// The exponents of one term, packed.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Monomial(pub(super) u128);

impl Monomial {
    /// The monomial 1.
    pub const ONE: Self = Self(0);
}

/// The ordered symbols of a family of polynomials.
#[derive(PartialEq, Eq, Debug)]
pub struct Ring {
    names: Vec<String>,
    bits: u32,
    tops: u128,
}

impl Ring {
    /// A ring over the named symbols, at most 32; the fewer the symbols, the larger the exponents may be.
    pub fn new(names: Vec<String>) -> Result<Arc<Self>> {
        let count = names.len().max(1) as u32;
        let bits = (128 / count).min(16);
        if bits < 4 {
            return Err(Error::not_computed(format!(
                "{count} symbols in one formula; at most 32 are possible"
            ))
            .with_hint("give a name to a part of the formula and work it out alone"));
        }
        let tops = (0..count).map(|k| 1_u128 << (k * bits + bits - 1)).sum();
        Ok(Arc::new(Self { names, bits, tops }))
    }

    /// The symbols in their order.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The place of a symbol.
    pub fn index(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|n| n == name)
    }

    fn shift(&self, symbol: usize) -> u32 {
        (self.names.len() - 1 - symbol) as u32 * self.bits
    }

    /// The exponent of one symbol.
    pub fn exponent(&self, monomial: Monomial, symbol: usize) -> u32 {
        let mask = (1_u128 << self.bits) - 1;
        ((monomial.0 >> self.shift(symbol)) & mask) as u32
    }

    /// One symbol to a power.
    pub fn power(&self, symbol: usize, exponent: u32) -> Result<Monomial> {
        if u128::from(exponent) >= 1_u128 << self.bits {
            return Err(self.too_high());
        }
        Ok(Monomial(u128::from(exponent) << self.shift(symbol)))
    }

    fn too_high(&self) -> Error {
        Error::not_computed(format!(
            "with {} symbols and functions a formula holds powers up to {}, and here one is higher",
            self.names.len(),
            (1_u64 << self.bits) - 1
        ))
        .with_hint(
            "give some of them values or one name; where every coefficient of H and G is a letter of its own, \
             `gyrospec table` has the answer",
        )
    }

    /// The product of two monomials.
    pub fn product(&self, x: Monomial, y: Monomial) -> Result<Monomial> {
        let sum = x.0.wrapping_add(y.0);
        // carries out of each field: both top bits set, or one set and lost in the sum
        let carries = ((x.0 & y.0) | ((x.0 | y.0) & !sum)) & self.tops;
        if carries == 0 { Ok(Monomial(sum)) } else { Err(self.too_high()) }
    }

    /// The quotient, if every exponent stays at 0 or above.
    pub fn quotient(&self, x: Monomial, y: Monomial) -> Option<Monomial> {
        let rest = x.0.wrapping_sub(y.0);
        let borrows = ((!x.0 & y.0) | ((!x.0 | y.0) & rest)) & self.tops;
        (borrows == 0).then_some(Monomial(rest))
    }

    /// The symbols with exponents above 0, in order.
    pub fn powers(&self, monomial: Monomial) -> impl Iterator<Item = (usize, u32)> + '_ {
        (0..self.names.len()).map(move |k| (k, self.exponent(monomial, k))).filter(|(_, e)| *e > 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carries_and_borrows_are_found() {
        let ring = Ring::new((0..32).map(|k| format!("x{k}")).collect()).unwrap();
        for symbol in [0, 7, 31] {
            let x = ring.power(symbol, 9).unwrap();
            assert!(ring.product(x, x).is_err());
            let six = ring.power(symbol, 6).unwrap();
            assert_eq!(ring.exponent(ring.product(x, six).unwrap(), symbol), 15);
            assert_eq!(ring.quotient(x, six), Some(ring.power(symbol, 3).unwrap()));
            assert_eq!(ring.quotient(six, x), None);
            assert!(ring.power(symbol, 16).is_err());
        }
        assert!(Ring::new((0..33).map(|k| format!("x{k}")).collect()).is_err());
    }
}
