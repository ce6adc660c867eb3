//! The spectral integral I_n of (3.10), (3.11) for any order.
//!
//! I_n = (1/2π) ∫ G(jω) / (H(jω)·H(−jω)) dω over all ω, with
//! H(s) = a0·sⁿ + a1·sⁿ⁻¹ + … + an and G(s) = b0·s²ⁿ⁻² + b1·s²ⁿ⁻⁴ + … + b(n−1).
//!
//! It is the variance of white noise of unit intensity behind a filter C/H (G = C(s)C(−s)), and
//! with it of any stationary signal whose spectrum is rational.
//!
//! | call | what it promises |
//! |---|---|
//! | [`evaluate`] | within 2 units in the last place of the exact integral of the doubles given, or a refusal |
//! | [`evaluate_fast`] | a wider, still guaranteed bound, for sweeps and optimisers |
//! | [`exact`] | rational arithmetic of any size |
//! | [`determinant`] | the published ratio of Hurwitz determinants, as a cross-check |
//! | [`quadrature`] | numeric integration, as a cross-check |
//! | [`gradient`] | derivatives in all coefficients |
//! | [`batch`] | many problems of one order |
//!
//! | code | symbol | unit |
//! |---|---|---|
//! | `h` | a0 … an of (3.11) | any, s in rad/s |
//! | `g` | b0 … b(n−1) of (3.11) | any |
//! | `c` | C with G = C(s)C(−s), descending | any |
//! | `condition` | Σ\|x·∂I/∂x\|/\|I\| over all coefficients x | 1 |

mod adjoint;
pub mod batch;
pub mod crosscheck;
pub mod determinant;
mod evaluate;
pub mod exact;
pub mod gradient;
mod moments;
pub mod quadrature;
mod real;
mod recursion;
mod scale;

pub use evaluate::{Estimate, evaluate, evaluate_fast};

use crate::{Error, Result};
#[cfg(feature = "serde")]
use serde::{Deserialize, Serialize};

/// The numerator of the integrand.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Numerator<'a> {
    /// b0 … b(n−1) of the even polynomial G, n of them.
    Even(&'a [f64]),
    /// C of G = C(s)C(−s), descending; 1 to n coefficients.
    Square(&'a [f64]),
}

/// One integral: its polynomials, borrowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integrand<'a> {
    h: &'a [f64],
    numerator: Numerator<'a>,
}

impl<'a> Integrand<'a> {
    /// An even numerator: `h` = a0 … an (n ≥ 1, a0 ≠ 0), `g` = b0 … b(n−1), all finite.
    ///
    /// ```
    /// use gyrospec::integral::{Integrand, evaluate};
    /// // I_2 = b1/(2·a1·a2) for b0 = 0
    /// let answer = evaluate(&Integrand::new(&[1.0, 2.0, 3.0], &[0.0, 1.0])?)?;
    /// assert_eq!(answer.value, 1.0 / 12.0);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// `BadInput` for wrong lengths, a zero leading coefficient, or a number that is not finite.
    pub fn new(h: &'a [f64], g: &'a [f64]) -> Result<Self> {
        let n = check_h(h)?;
        if g.len() != n {
            return Err(Error::bad_input(format!(
                "g has {} coefficients; H of order {n} takes b0 … b{}: {n} of them",
                g.len(),
                n - 1
            ))
            .with_hint("pad with leading zeros: b0 belongs to s^(2n-2), the last one to s^0"));
        }
        finite("g", "b", g)?;
        Ok(Self { h, numerator: Numerator::Even(g) })
    }

    /// A squared numerator G = C(s)C(−s): `c` descending, 1 to n coefficients, all finite.
    ///
    /// # Errors
    /// As [`Integrand::new`].
    pub fn from_square(h: &'a [f64], c: &'a [f64]) -> Result<Self> {
        let n = check_h(h)?;
        if c.is_empty() || c.len() > n {
            return Err(Error::bad_input(format!(
                "c has {} coefficients; H of order {n} takes 1 to {n}, highest power first",
                c.len()
            )));
        }
        finite("c", "c", c)?;
        Ok(Self { h, numerator: Numerator::Square(c) })
    }

    /// Order n of H.
    pub fn order(&self) -> usize {
        self.h.len() - 1
    }

    /// a0 … an.
    pub fn h(&self) -> &'a [f64] {
        self.h
    }

    /// G, as it was given: a constant, or coefficients of even powers.
    pub fn numerator(&self) -> Numerator<'a> {
        self.numerator
    }

    /// Half the degree of G (the degree of C): the highest k with a coefficient that is not zero.
    fn degree(&self) -> usize {
        let (Numerator::Even(x) | Numerator::Square(x)) = self.numerator;
        x.iter().position(|v| *v != 0.0).map_or(0, |i| x.len() - 1 - i)
    }
}

/// The highest order that is taken; the exact tier needs about n⁴ steps.
pub const MAX_ORDER: usize = 1000;

fn check_h(h: &[f64]) -> Result<usize> {
    if h.len() < 2 {
        return Err(Error::bad_input(format!(
            "h has {} coefficients; H needs at least two: a0 a1 … an with n ≥ 1",
            h.len()
        )));
    }
    if h.len() > MAX_ORDER + 1 {
        return Err(Error::bad_input(format!(
            "H of order {} is above the limit of {MAX_ORDER}",
            h.len() - 1
        )));
    }
    finite("h", "a", h)?;
    if h[0] == 0.0 {
        return Err(Error::bad_input("the leading coefficient a0 of H is zero")
            .with_hint("leave leading zeros away: the order is the number of coefficients less one"));
    }
    Ok(h.len() - 1)
}

fn finite(name: &str, letter: &str, x: &[f64]) -> Result<()> {
    match x.iter().position(|v| !v.is_finite()) {
        Some(i) => Err(Error::bad_input(format!("{name} holds {} at {letter}{i}; all must be finite", x[i]))),
        None => Ok(()),
    }
}

/// How an answer was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(Serialize, Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Method {
    /// The recursion in doubles.
    Recursion,
    /// The recursion in pairs of doubles.
    RecursionDoubleDouble,
    /// Rational arithmetic.
    Exact,
    /// The ratio of determinants.
    Determinant,
    /// Numeric integration.
    Quadrature,
}

/// A value of I_n with what is known of it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct Integral {
    /// I_n, in the unit of G/H² times rad/s.
    pub value: f64,
    /// |value − exact| ≤ error_bound for the doubles given, guaranteed.
    pub error_bound: f64,
    /// Componentwise condition number Σ|x·∂I/∂x|/|I|: relative change of the value by relative
    /// changes of the coefficients. Not finite where the value is 0.
    pub condition: f64,
    /// The method that gave the value.
    pub method: Method,
}
