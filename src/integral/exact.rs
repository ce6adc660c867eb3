//! I_n in rational arithmetic of any size.
//!
//! # Purpose
//! The value for every input that doubles cannot answer, and the decision about stability without
//! a threshold.
//!
//! # Method
//! The coefficients become integers over a power of two. The minors D_k, Δ_k of the exact Routh
//! test (see [`crate::poly::routh`]) eliminate the row b0 … b(n−1) of the numerator,
//!   B_(k+1)\[i\] = (D_k\[0\]·B_k\[i+1\] − B_k\[0\]·D_k\[i+1\])/Δ_(k−1),
//! and I_n = B_(n−1)\[0\]/(2·a0·Δ_(n−1)·a_n): the published ratio of determinants, expanded along
//! the rows of Routh's array.
//!
//! # References
//! (3.10), (3.11); V. A. Besekerskii, E. P. Popov, Theory of Automatic Control Systems (1972).
//!
//! # Numerical aspects
//! One rounding at the very end. The integers grow with the order: n²/2 products of n·53 bits for
//! coefficients of like exponents.

#[cfg(feature = "instruments")]
use super::scale::Scale;
use super::{Integral, Integrand, Method, Numerator};
use crate::exact::{IBig, RBig, Rounded, integers, integers_time_shift, round_ratio};
use crate::poly::routh;
use crate::poly::stability::{Array, Stability};
use crate::{Error, ErrorKind, Result};
use dashu_base::Signed;

/// Why there is no value, as data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// So many roots in the open right half plane.
    Unstable(usize),
    /// A root on the imaginary axis, none in the right half plane.
    ImaginaryAxis,
    /// Stable, but the value is no finite normal double; the value in decimal.
    OutOfRange(String),
}

impl From<Refusal> for Error {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::Unstable(count) => Error::new(
                ErrorKind::Unstable,
                format!("H has {count} root{} in the right half plane", if count == 1 { "" } else { "s" }),
            )
            .with_count(count),
            Refusal::ImaginaryAxis => {
                Error::new(ErrorKind::ImaginaryAxis, "H has a root on the imaginary axis")
            }
            Refusal::OutOfRange(decimal) => Error::new(
                ErrorKind::OutOfRange,
                format!("the integral is {decimal}, which no normal double holds"),
            )
            .with_decimal(decimal),
        }
    }
}

/// Nothing wrong with H, decided exactly.
pub(super) fn require_stable(h: &[f64]) -> Result<()> {
    stable_array(h).map(|_| ())
}

/// The array of the Routh test of H in integers, their time shift and their exponent.
fn stable_array(h: &[f64]) -> Result<(Array, i32, i64)> {
    let (n, time) = (h.len() - 1, integers_time_shift(h));
    // s = 2^time·s′: a_i·2^(time·(n−i)) = k_i·2^e
    let (h, exponent) = integers(h, time, |i| (n - i) as i32);
    Ok((tested(h)?, time, exponent))
}

fn tested(mut h: Vec<IBig>) -> Result<Array> {
    if h[0].is_negative() {
        for a in &mut h {
            *a = -a.clone();
        }
    }
    match routh::test(&h) {
        Stability::Stable(array) => Ok(array),
        Stability::Unstable(count) => Err(Refusal::Unstable(count).into()),
        Stability::Axis => Err(Refusal::ImaginaryAxis.into()),
    }
}

/// An exact value before rounding: (numerator/denominator)·2^exponent.
struct Ratio {
    numerator: IBig,
    denominator: IBig,
    exponent: i64,
    array: Array,
    /// The integers of the array are the scaled coefficients times 2^−this.
    of_h: i64,
}

/// The exact integral, rounded once.
///
/// # Errors
/// As [`super::evaluate`].
pub fn evaluate(p: &Integrand<'_>) -> Result<Integral> {
    rounded(&ratio(p)?, Some(p))
}

/// An integral whose polynomials are integers over powers of two, in a time s = 2^`time`·s′.
#[cfg(feature = "instruments")]
pub(crate) struct Whole {
    /// a0 … an times 2^−`of_h`.
    pub h: Vec<IBig>,
    /// b0 … b(n−1) times 2^−`of_g`.
    pub g: Vec<IBig>,
    pub of_h: i64,
    pub of_g: i64,
    pub time: i32,
}

/// The exact integral of integers, rounded once; `near` are the same polynomials in doubles, whose condition is told.
#[cfg(feature = "instruments")]
pub(crate) fn of_whole(w: Whole, near: Option<&Integrand<'_>>) -> Result<Integral> {
    let array = tested(w.h)?;
    let (numerator, denominator) = eliminate(w.g, &array);
    let exponent = i64::from(w.time) + w.of_g - 2 * w.of_h;
    // the condition is told in the time of the doubles
    let near = near.filter(|p| Scale::choose(p).is_some_and(|s| s.time == w.time));
    rounded(&Ratio { numerator, denominator, exponent, array, of_h: w.of_h }, near)
}

fn rounded(ratio: &Ratio, p: Option<&Integrand<'_>>) -> Result<Integral> {
    let (value, whole) = match round_ratio(&ratio.numerator, &ratio.denominator, ratio.exponent) {
        Rounded::Value(value, whole) => (value, whole),
        Rounded::OutOfRange(decimal) => return Err(Refusal::OutOfRange(decimal).into()),
    };
    let half_ulp = (value.abs() * f64::EPSILON / 2.0).max(f64::from_bits(1));
    let error_bound = if whole { 0.0 } else { half_ulp };
    let condition =
        p.map_or(f64::INFINITY, |p| super::adjoint::condition_of_exact(p, &ratio.array, ratio.of_h, value));
    Ok(Integral { value, error_bound, condition, method: Method::Exact })
}

fn ratio(p: &Integrand<'_>) -> Result<Ratio> {
    let n = p.order();
    let (array, time, eh) = stable_array(p.h)?;
    let (g, eg) = match p.numerator {
        Numerator::Even(g) => integers(g, time, |k| 2 * (n - 1 - k) as i32),
        Numerator::Square(c) => {
            let (c, ec) = integers(c, time, |k| (c.len() - 1 - k) as i32);
            (square(&c, n), 2 * ec)
        }
    };
    let (numerator, denominator) = eliminate(g, &array);
    Ok(Ratio { numerator, denominator, exponent: i64::from(time) + eg - 2 * eh, array, of_h: eh })
}

/// b0 … b(n−1) of C(s)C(−s) for C descending.
fn square(c: &[IBig], n: usize) -> Vec<IBig> {
    let mut g = vec![IBig::ZERO; n];
    let top = c.len() - 1;
    for (i, a) in c.iter().enumerate() {
        for (j, b) in c.iter().enumerate().filter(|(j, _)| (i + j) % 2 == 0) {
            // the power of s is 2·top − i − j; (−1)^(top − j) from C(−s)
            let k = n - 1 - (2 * top - i - j) / 2;
            if (top - j).is_multiple_of(2) {
                g[k] += a * b;
            } else {
                g[k] -= a * b;
            }
        }
    }
    g
}

/// Numerator and denominator of I_n from the row b and the minors.
fn eliminate(mut b: Vec<IBig>, array: &Array) -> (IBig, IBig) {
    let rows = &array.rows;
    let n = rows.len() - 1;
    for k in 0..n - 1 {
        let row = &rows[k];
        let lead = b.remove(0);
        for (i, x) in b.iter_mut().enumerate() {
            // B_(k+1)[i] = (D_k[0]·B_k[i+1] − B_k[0]·D_k[i+1])/Δ_(k−1)
            *x *= &row[0];
            if lead != IBig::ZERO
                && let Some(d) = row.get(i + 1)
            {
                *x -= &lead * d;
            }
            if k >= 2 {
                *x /= &rows[k - 1][0];
            }
        }
    }
    // I_n = B_(n−1)[0]/(2·a0·Δ_(n−1)·a_n), Δ_n = Δ_(n−1)·a_n
    (b.swap_remove(0), IBig::from(2) * &rows[0][0] * &rows[n][0])
}

/// I_n of rational coefficients, exactly; `h` = a0 … an, `g` = b0 … b(n−1).
///
/// ```
/// use gyrospec::exact::RBig;
/// use gyrospec::integral::exact::rational;
/// let r = |n: i32| RBig::from(n);
/// let i2 = rational(&[r(1), r(2), r(3)], &[r(0), r(1)])?;
/// assert_eq!(i2, r(1) / r(12));
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` for wrong lengths, `Unstable` or `ImaginaryAxis`.
#[doc(hidden)]
pub fn rational(h: &[RBig], g: &[RBig]) -> Result<RBig> {
    if h.len() < 2 || g.len() + 1 != h.len() || h[0] == RBig::ZERO {
        return Err(Error::bad_input("h needs n + 1 coefficients with a0 ≠ 0, and g needs n"));
    }
    let (h, dh) = whole(h);
    let (g, dg) = whole(g);
    let (p, q) = eliminate(g, &tested(h)?);
    Ok(RBig::from(p) / RBig::from(q) * RBig::from(&dh * &dh) / RBig::from(dg))
}

/// Rationals times their common denominator, and that denominator.
fn whole(x: &[RBig]) -> (Vec<IBig>, IBig) {
    let common = x.iter().fold(IBig::ONE, |d, r| {
        let own = IBig::from(r.denominator().clone());
        let g = IBig::from(dashu_base::Gcd::gcd(&d, &own));
        &d / g * own
    });
    let scaled = x.iter().map(|r| r.numerator() * (&common / IBig::from(r.denominator().clone())));
    (scaled.collect(), common)
}
