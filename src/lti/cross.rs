//! # Purpose
//! The mean product of two signals that one random motion drives through two filters:
//! ⟨y₁ y₂⟩ = (1/2π)∫ S(ω) W₁(jω) W₂(−jω) dω with S = |F(jω)|².
//!
//! # Method
//! Over the common denominator H the integrand is C₁(jω)C₂(−jω)/|H|². Its even part is the
//! G of an integral I_n; its odd part is dropped.
//!
//! # References
//! The reduction (3.8)–(3.12) of the rolling-error paper, where ω⁵ is dropped so.
//!
//! # Numerical aspects
//! Why the odd part may go: it is imaginary for real filters and odd in ω, so its integral
//! over −Ω … Ω is zero for every Ω. Where the odd part falls off only as 1/ω (one of the
//! signals has a white part) this takes the integral as the limit of symmetric bands, which
//! is the mean of the cross-correlation on both sides of zero lag (Stratonovich). An even
//! part that does not fall off at least as 1/ω² has no finite integral and is refused.

use super::TransferFunction;
use crate::integral::{self, Integral, Integrand};
use crate::poly::{even_part_of_product, product};
use crate::{Error, ErrorKind, Result};

/// An integral I_n by its two polynomials of (3.11).
#[derive(Debug, Clone, PartialEq)]
pub struct CrossIntegral {
    /// a0 … an.
    pub h: Vec<f64>,
    /// b0 … b(n−1).
    pub g: Vec<f64>,
}

/// The I_n to which ⟨y₁ y₂⟩ reduces, y₁ = W₁ F w and y₂ = W₂ F w for unit white noise w.
///
/// # Errors
/// `OutOfRange` when both signals have a white part, so that the mean is infinite.
pub fn cross_integrand(
    shaping: &TransferFunction,
    first: &TransferFunction,
    second: &TransferFunction,
) -> Result<CrossIntegral> {
    let same = first.denominator() == second.denominator();
    let (mut h, mut c1, mut c2) = (
        product(shaping.denominator(), first.denominator()),
        product(shaping.numerator(), first.numerator()),
        product(shaping.numerator(), second.numerator()),
    );
    if !same {
        h = product(&h, second.denominator());
        c1 = product(&c1, second.denominator());
        c2 = product(&c2, first.denominator());
    }
    let n = h.len() - 1;
    let padded = |c: &[f64]| [vec![0.0; n + 1 - c.len()], c.to_vec()].concat();
    // b of s^2n, then G
    let even = even_part_of_product(&padded(&c1), &padded(&c2));
    if even[0] != 0.0 {
        return Err(Error::new(
            ErrorKind::OutOfRange,
            "both signals hold white noise, so the mean of their product is infinite",
        )
        .with_hint("limit the band of the motion"));
    }
    Ok(CrossIntegral { h, g: even[1..].to_vec() })
}

/// ⟨y₁ y₂⟩ = (1/2π)∫ |F|² W₁(jω) W₂(−jω) dω.
///
/// ```
/// use gyrospec::lti::{TransferFunction, cross_moment};
/// let one = TransferFunction::constant(1.0);
/// let fast = TransferFunction::new(&[1.0], &[0.5, 1.0]).unwrap();
/// let slow = TransferFunction::new(&[1.0], &[2.0, 1.0]).unwrap();
/// // white noise through two lags: 1/(T₁ + T₂)
/// let mean = cross_moment(&one, &fast, &slow).unwrap().value;
/// assert!((mean - 0.4).abs() < 1e-15);
/// ```
///
/// # Errors
/// As [`cross_integrand`] and [`integral::evaluate`].
pub fn cross_moment(
    shaping: &TransferFunction,
    first: &TransferFunction,
    second: &TransferFunction,
) -> Result<Integral> {
    let CrossIntegral { h, g } = cross_integrand(shaping, first, second)?;
    integral::evaluate(&Integrand::new(&h, &g)?)
}

impl TransferFunction {
    /// The variance of the answer to white noise of unit intensity, (1/2π)∫|W(jω)|² dω, with its bound.
    ///
    /// ```
    /// use gyrospec::TransferFunction;
    /// let lag = TransferFunction::new(&[1.0], &[2.0, 1.0])?;          // 1/(2 s + 1)
    /// assert_eq!(lag.variance()?.value, 0.25);                        // 1/(2T)
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`integral::evaluate`]; where W has as many zeros as poles the variance is infinite.
    pub fn variance(&self) -> Result<Integral> {
        cross_moment(&Self::constant(1.0), self, self)
    }
}
