//! Ratios of polynomials.

use super::gcd::gcd;
use super::integer::Integer;
use super::polynomial::Polynomial;
use super::ring::Ring;
use crate::{Error, Result};
use std::sync::Arc;

/// numerator/denominator without a common factor, the denominator's first coefficient above 0.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fraction {
    /// Above the line.
    pub numerator: Polynomial,
    /// Below the line; never 0.
    pub denominator: Polynomial,
}

impl Fraction {
    /// A ratio, reduced.
    ///
    /// # Errors
    /// Bad input, where the denominator is 0.
    pub fn new(numerator: &Polynomial, denominator: &Polynomial) -> Result<Self> {
        if denominator.is_zero() {
            return Err(Error::bad_input("a formula divides by what is zero for all values of its symbols"));
        }
        let mut common = gcd(numerator, denominator)?;
        if denominator.content().is_negative() {
            common = common.scaled(&Integer::from(-1));
        }
        let reduced = |p: &Polynomial| {
            p.divided_by(&common)?.ok_or_else(|| Error::not_computed("a common divisor that does not divide"))
        };
        Ok(Self { numerator: reduced(numerator)?, denominator: reduced(denominator)? })
    }

    /// A ratio, reduced, where factors are known that the denominator may be made of: each is small, so that its
    /// common divisor with the numerator is found at once.
    ///
    /// # Errors
    /// Bad input, where the denominator is 0.
    pub fn in_factors<'a>(
        numerator: &Polynomial,
        denominator: &Polynomial,
        factors: impl IntoIterator<Item = &'a Polynomial>,
    ) -> Result<Self> {
        let missing = || Error::not_computed("a common divisor that does not divide");
        let (mut above, mut below) = (numerator.clone(), denominator.clone());
        let mut kept = Polynomial::constant(denominator.ring(), 1);
        for factor in factors.into_iter().filter(|factor| factor.terms().len() > 1) {
            while let Some(rest) = below.divided_by(factor)? {
                below = rest;
                let common = gcd(&above, factor)?;
                above = above.divided_by(&common)?.ok_or_else(missing)?;
                kept = kept.times(&factor.divided_by(&common)?.ok_or_else(missing)?)?;
            }
        }
        let rest = Self::new(&above, &below)?;
        Ok(Self { numerator: rest.numerator, denominator: rest.denominator.times(&kept)? })
    }

    /// A polynomial over 1.
    pub fn whole(polynomial: Polynomial) -> Self {
        let denominator = Polynomial::constant(polynomial.ring(), 1);
        Self { numerator: polynomial, denominator }
    }

    /// A number.
    pub fn number(ring: &Arc<Ring>, value: i64) -> Self {
        Self::whole(Polynomial::constant(ring, value))
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Sum over the common denominator.
    pub fn plus(&self, other: &Self) -> Result<Self> {
        if self.denominator == other.denominator {
            return Self::new(&self.numerator.plus(&other.numerator), &self.denominator);
        }
        let left = self.numerator.times(&other.denominator)?;
        let right = other.numerator.times(&self.denominator)?;
        Self::new(&left.plus(&right), &self.denominator.times(&other.denominator)?)
    }

    /// The same with the other sign.
    #[must_use]
    pub fn negated(&self) -> Self {
        let numerator = self.numerator.scaled(&Integer::from(-1));
        Self { numerator, denominator: self.denominator.clone() }
    }

    /// Product, reduced.
    pub fn times(&self, other: &Self) -> Result<Self> {
        Self::new(&self.numerator.times(&other.numerator)?, &self.denominator.times(&other.denominator)?)
    }

    /// Quotient, reduced; an error where `other` is zero.
    pub fn over(&self, other: &Self) -> Result<Self> {
        Self::new(&self.numerator.times(&other.denominator)?, &self.denominator.times(&other.numerator)?)
    }

    /// Whole power, of either sign.
    pub fn to_power(&self, exponent: i32) -> Result<Self> {
        let size = exponent.unsigned_abs();
        let (above, below) = (self.numerator.to_power(size)?, self.denominator.to_power(size)?);
        if exponent < 0 {
            Self::new(&below, &above)
        } else {
            Ok(Self { numerator: above, denominator: below })
        }
    }
}
