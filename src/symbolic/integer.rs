//! Integer coefficients that widen instead of overflowing.
//!
//! Purpose: coefficients of polynomials in many symbols; nearly all of them fit a machine word.
//! Method: checked i64; what does not fit goes to an integer of any size and comes back when it can.
//! References: none needed.
//! Numerical aspects: exact.

use dashu_base::{DivRem, Gcd};
use dashu_int::IBig;
use std::fmt;
use std::ops::Neg;

/// An exact integer: one machine word while it fits, any size after that.
///
/// ```
/// use gyrospec::symbolic::Integer;
/// let big = Integer::from(i64::MAX).times(&Integer::from(2));
/// assert_eq!(big.to_string(), "18446744073709551614");
/// ```
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Integer {
    /// A value that fits 64 bits.
    Word(i64),
    /// A value that does not; never one that would fit.
    Wide(Box<IBig>),
}

impl Integer {
    /// The neutral element of a sum.
    pub const ZERO: Self = Self::Word(0);
    /// The neutral element of a product.
    pub const ONE: Self = Self::Word(1);

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }

    /// Whether it is below 0.
    pub fn is_negative(&self) -> bool {
        match self {
            Self::Word(w) => *w < 0,
            Self::Wide(w) => **w < IBig::ZERO,
        }
    }

    /// The value as an integer of any size.
    pub fn to_big(&self) -> IBig {
        match self {
            Self::Word(w) => IBig::from(*w),
            Self::Wide(w) => (**w).clone(),
        }
    }

    /// The nearest double.
    pub fn to_f64(&self) -> f64 {
        match self {
            Self::Word(w) => *w as f64,
            Self::Wide(w) => w.to_f64().value(),
        }
    }

    /// Sum, exact whatever its size.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        if let (Self::Word(x), Self::Word(y)) = (self, other)
            && let Some(sum) = x.checked_add(*y)
        {
            return Self::Word(sum);
        }
        (self.to_big() + other.to_big()).into()
    }

    /// Product, exact whatever its size.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        if let (Self::Word(x), Self::Word(y)) = (self, other)
            && let Some(product) = x.checked_mul(*y)
        {
            return Self::Word(product);
        }
        (self.to_big() * other.to_big()).into()
    }

    /// Quotient, if it is an integer.
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        if other.is_zero() {
            return None;
        }
        if let (Self::Word(x), Self::Word(y)) = (self, other)
            && let (Some(quotient), Some(rest)) = (x.checked_div(*y), x.checked_rem(*y))
        {
            return (rest == 0).then_some(Self::Word(quotient));
        }
        let (quotient, rest) = self.to_big().div_rem(other.to_big());
        (rest == IBig::ZERO).then(|| quotient.into())
    }

    /// Greatest common divisor, never negative; that of 0 and 0 is 0.
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        if let (Self::Word(x), Self::Word(y)) = (self, other) {
            let (mut x, mut y) = (x.unsigned_abs(), y.unsigned_abs());
            while y != 0 {
                (x, y) = (y, x % y);
            }
            return IBig::from(x).into();
        }
        match (self.is_zero(), other.is_zero()) {
            (true, _) => other.magnitude(),
            (_, true) => self.magnitude(),
            _ => IBig::from(self.to_big().gcd(other.to_big())).into(),
        }
    }

    /// Absolute value.
    #[must_use]
    pub fn magnitude(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }
}

impl From<i64> for Integer {
    fn from(value: i64) -> Self {
        Self::Word(value)
    }
}

impl From<IBig> for Integer {
    fn from(value: IBig) -> Self {
        i64::try_from(&value).map_or_else(|_| Self::Wide(Box::new(value)), Self::Word)
    }
}

impl Neg for &Integer {
    type Output = Integer;
    fn neg(self) -> Integer {
        match self {
            Integer::Word(w) => w.checked_neg().map_or_else(|| (-IBig::from(*w)).into(), Integer::Word),
            Integer::Wide(w) => (-(**w).clone()).into(),
        }
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(w) => w.fmt(f),
            Self::Wide(w) => fmt::Display::fmt(w, f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widens_at_the_edge_and_comes_back() {
        let least = Integer::from(i64::MIN);
        let wide = -&least;
        assert!(matches!(wide, Integer::Wide(_)));
        assert_eq!(-&wide, least);
        let product = wide.times(&wide);
        assert_eq!(product.divided_by(&wide), Some(wide.clone()));
        assert_eq!(product.gcd(&wide), wide);
        assert_eq!(wide.divided_by(&Integer::from(3)), None);
        assert_eq!(least.divided_by(&Integer::from(-1)), Some(wide));
    }
}
