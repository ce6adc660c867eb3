//! One integral by every method, side by side.

use super::{Integrand, determinant, evaluate_fast, exact, quadrature};
use crate::Result;
#[cfg(feature = "serde")]
use serde::Serialize;

/// What each method says; a refusal stands as its text.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct Crosscheck {
    /// The recursion in plain doubles.
    pub recursion: Outcome,
    /// The published ratio of determinants.
    pub determinant: Outcome,
    /// Numeric integration to 10⁻⁹.
    pub quadrature: Outcome,
    /// Rational arithmetic.
    pub exact: Outcome,
}

/// The result of one method.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
#[cfg_attr(feature = "serde", serde(untagged))]
pub enum Outcome {
    /// A value with a guaranteed bound.
    Bounded {
        /// The value of I_n by this method.
        value: f64,
        /// |value − I_n| is at most this.
        error_bound: f64,
    },
    /// A value with an estimate of its error.
    Estimated(quadrature::Quadrature),
    /// A value alone.
    Value {
        /// The value of I_n by this method.
        value: f64,
    },
    /// Why there is none.
    Refused {
        /// Why there is none, in words.
        refused: String,
    },
}

fn outcome<T>(result: Result<T>, make: impl Fn(T) -> Outcome) -> Outcome {
    result.map_or_else(|e| Outcome::Refused { refused: e.message().to_owned() }, make)
}

/// Runs every method.
///
/// ```
/// use gyrospec::integral::{Integrand, crosscheck::{Outcome, crosscheck}};
/// let all = crosscheck(&Integrand::new(&[1.0, 2.0, 3.0], &[0.0, 1.0])?);
/// assert!(matches!(all.determinant, Outcome::Value { value } if (value - 1.0 / 12.0).abs() < 1e-15));
/// # Ok::<(), gyrospec::Error>(())
/// ```
pub fn crosscheck(p: &Integrand<'_>) -> Crosscheck {
    let bounded = |value, error_bound| Outcome::Bounded { value, error_bound };
    Crosscheck {
        recursion: outcome(evaluate_fast(p), |e| bounded(e.value, e.error_bound)),
        determinant: outcome(determinant::evaluate(p), |value| Outcome::Value { value }),
        quadrature: outcome(quadrature::evaluate(p, 1e-9), Outcome::Estimated),
        exact: outcome(exact::evaluate(p), |a| bounded(a.value, a.error_bound)),
    }
}
