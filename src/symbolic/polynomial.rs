//! Sparse polynomials in many symbols with exact integer coefficients.
//!
//! Purpose: the arithmetic under tables and formulas.
//! Method: terms sorted by packed exponents, largest first; sums are merges.
//! References: S. C. Johnson, Sparse polynomial arithmetic, SIGSAM Bull. 8 (1974) 63.
//! Numerical aspects: exact; an exponent that does not fit is an error.

use super::integer::Integer;
use super::ring::{Monomial, Ring};
use crate::{Error, Result};
use std::cmp::Ordering;
use std::sync::Arc;

/// The most products of terms in one multiplication, some hundred megabytes.
const MOST_PRODUCTS: usize = 4_000_000;

/// A polynomial: its ring and its terms, largest monomial first, no zero coefficient, no monomial twice.
///
/// ```
/// use gyrospec::symbolic::{Polynomial, Ring};
/// let ring = Ring::new(vec!["x".into(), "y".into()])?;
/// let (x, y) = (Polynomial::symbol(&ring, 0)?, Polynomial::symbol(&ring, 1)?);
/// let product = x.plus(&y).times(&x.minus(&y))?;
/// assert_eq!(product.divided_by(&x.plus(&y))?, Some(x.minus(&y)));
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Polynomial {
    ring: Arc<Ring>,
    terms: Vec<(Monomial, Integer)>,
}

impl Polynomial {
    /// A constant.
    pub fn constant(ring: &Arc<Ring>, value: impl Into<Integer>) -> Self {
        Self::term(ring, Monomial::ONE, value.into())
    }

    /// One symbol.
    pub fn symbol(ring: &Arc<Ring>, symbol: usize) -> Result<Self> {
        Ok(Self::term(ring, ring.power(symbol, 1)?, Integer::ONE))
    }

    /// One term.
    pub fn term(ring: &Arc<Ring>, monomial: Monomial, coefficient: Integer) -> Self {
        let terms = if coefficient.is_zero() { Vec::new() } else { vec![(monomial, coefficient)] };
        Self { ring: ring.clone(), terms }
    }

    /// A polynomial of terms in any order, like terms added up.
    pub fn collect(ring: &Arc<Ring>, mut terms: Vec<(Monomial, Integer)>) -> Self {
        terms.sort_unstable_by_key(|(monomial, _)| std::cmp::Reverse(*monomial));
        let mut kept: Vec<(Monomial, Integer)> = Vec::with_capacity(terms.len());
        for (monomial, coefficient) in terms {
            match kept.last_mut() {
                Some((last, sum)) if *last == monomial => *sum = sum.plus(&coefficient),
                _ => kept.push((monomial, coefficient)),
            }
        }
        kept.retain(|(_, coefficient)| !coefficient.is_zero());
        Self { ring: ring.clone(), terms: kept }
    }

    /// The ring of its symbols and their order.
    pub fn ring(&self) -> &Arc<Ring> {
        &self.ring
    }

    /// The terms, largest monomial first.
    pub fn terms(&self) -> &[(Monomial, Integer)] {
        &self.terms
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Its value, if it is a constant.
    pub fn as_constant(&self) -> Option<Integer> {
        match self.terms.as_slice() {
            [] => Some(Integer::ZERO),
            [(Monomial::ONE, value)] => Some(value.clone()),
            _ => None,
        }
    }

    /// The sum with another of the same ring.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let (mut x, mut y) = (self.terms.iter().peekable(), other.terms.iter().peekable());
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        while let (Some((m, p)), Some((k, q))) = (x.peek(), y.peek()) {
            match m.cmp(k) {
                Ordering::Greater => terms.extend(x.next().cloned()),
                Ordering::Less => terms.extend(y.next().cloned()),
                Ordering::Equal => {
                    let sum = p.plus(q);
                    if !sum.is_zero() {
                        terms.push((*m, sum));
                    }
                    x.next();
                    y.next();
                }
            }
        }
        terms.extend(x.cloned().chain(y.cloned()));
        Self { ring: self.ring.clone(), terms }
    }

    /// This less another of the same ring.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&Integer::from(-1)))
    }

    /// Product with a number.
    #[must_use]
    pub fn scaled(&self, factor: &Integer) -> Self {
        if factor.is_zero() {
            return Self { ring: self.ring.clone(), terms: Vec::new() };
        }
        let terms = self.terms.iter().map(|(m, c)| (*m, c.times(factor))).collect();
        Self { ring: self.ring.clone(), terms }
    }

    /// Product with one term; the order of the terms stays.
    pub fn times_term(&self, monomial: Monomial, factor: &Integer) -> Result<Self> {
        let shifted = |(m, c): &(Monomial, Integer)| Ok((self.ring.product(*m, monomial)?, c.times(factor)));
        let terms = self.terms.iter().map(shifted).collect::<Result<_>>()?;
        Ok(Self { ring: self.ring.clone(), terms })
    }

    /// The product with another of the same ring.
    pub fn times(&self, other: &Self) -> Result<Self> {
        let products = self.terms.len().saturating_mul(other.terms.len());
        if products > MOST_PRODUCTS {
            return Err(Error::not_computed(format!(
                "the formula grows too large on the way: sums of {} and {} terms are to be multiplied",
                self.terms.len(),
                other.terms.len()
            ))
            .with_hint("give some symbols values, or one name to several of them"));
        }
        let mut terms = Vec::with_capacity(products);
        for (m, p) in &self.terms {
            for (k, q) in &other.terms {
                terms.push((self.ring.product(*m, *k)?, p.times(q)));
            }
        }
        Ok(Self::collect(&self.ring, terms))
    }

    /// The power with a whole exponent.
    pub fn to_power(&self, exponent: u32) -> Result<Self> {
        (0..exponent).try_fold(Self::constant(&self.ring, 1), |product, _| product.times(self))
    }

    /// The exact quotient, or none where a remainder is left.
    pub fn divided_by(&self, divisor: &Self) -> Result<Option<Self>> {
        let Some((lead, leading)) = divisor.terms.first() else { return Ok(None) };
        let (mut rest, mut quotient) = (self.clone(), Vec::new());
        while let Some((m, c)) = rest.terms.first() {
            let (Some(monomial), Some(factor)) = (self.ring.quotient(*m, *lead), c.divided_by(leading))
            else {
                return Ok(None);
            };
            rest = rest.plus(&divisor.times_term(monomial, &-&factor)?);
            quotient.push((monomial, factor));
        }
        Ok(Some(Self { ring: self.ring.clone(), terms: quotient }))
    }

    /// The greatest common divisor of the coefficients, with the sign of the first one.
    pub fn content(&self) -> Integer {
        let content = self.terms.iter().fold(Integer::ZERO, |gcd, (_, c)| gcd.gcd(c));
        if self.terms.first().is_some_and(|(_, c)| c.is_negative()) { -&content } else { content }
    }

    /// The largest monomial that divides every term; 1 for the polynomial 0.
    pub fn common_monomial(&self) -> Monomial {
        let least = |k| self.terms.iter().map(|(m, _)| self.ring.exponent(*m, k)).min().unwrap_or(0);
        let packed = (0..self.ring.names().len()).filter_map(|k| self.ring.power(k, least(k)).ok());
        Monomial(packed.map(|m| m.0).sum())
    }

    /// The highest power of one symbol; 0 for the polynomial 0.
    pub fn degree(&self, symbol: usize) -> u32 {
        self.terms.iter().map(|(m, _)| self.ring.exponent(*m, symbol)).max().unwrap_or(0)
    }

    /// The coefficients of the powers of one symbol, from the power 0 up.
    pub fn coefficients(&self, symbol: usize) -> Result<Vec<Self>> {
        let mut parts = vec![Vec::new(); self.degree(symbol) as usize + 1];
        for (monomial, coefficient) in &self.terms {
            let exponent = self.ring.exponent(*monomial, symbol);
            let rest = Monomial(monomial.0 - self.ring.power(symbol, exponent)?.0);
            parts[exponent as usize].push((rest, coefficient.clone()));
        }
        Ok(parts.into_iter().map(|terms| Self { ring: self.ring.clone(), terms }).collect())
    }

    /// The derivative in one symbol.
    pub fn derivative(&self, symbol: usize) -> Result<Self> {
        let one = self.ring.power(symbol, 1)?;
        let lowered = self.terms.iter().filter_map(|(m, c)| {
            let exponent = i64::from(self.ring.exponent(*m, symbol));
            Some((self.ring.quotient(*m, one)?, c.times(&exponent.into())))
        });
        Ok(Self { ring: self.ring.clone(), terms: lowered.collect() })
    }

    /// The value at given numbers, one a symbol.
    pub fn value(&self, at: &[f64]) -> f64 {
        let term = |(m, c): &(Monomial, Integer)| {
            self.ring.powers(*m).fold(c.to_f64(), |product, (k, e)| product * at[k].powi(e as i32))
        };
        self.terms.iter().map(term).sum()
    }
}
