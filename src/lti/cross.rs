//! # Purpose
//! The mean product of two signals that one random motion drives through two filters, and of the one with the rate of
//! the other:
//! ⟨y₁ y₂⟩ = (1/2π)∫ S(ω) W₁(jω) W₂(−jω) dω,  ⟨y₁ ẏ₂⟩ = (1/2π)∫ S(ω) W₁(jω) (−jω) W₂(−jω) dω,  S = |F(jω)|².
//!
//! # Method
//! Over the common denominator H the integrand is C₁(jω)C₂(−jω)/|H|². Its even part is the
//! G of an integral I_n; its odd part is dropped. Of a rate C₂ is s·C₂, so that the even part comes from the quadrature
//! part of the cross-spectrum.
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
//!
//! The products of polynomials are made of integers, and the integral in them is rounded once: the bound holds for the
//! coefficients of the three filters as they are given, with nothing left out.

use super::TransferFunction;
use crate::exact::{IBig, integers_time_shift};
use crate::integral::{Integral, Integrand, MAX_ORDER, Method, exact};
use crate::poly::whole::{self, Whole};
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

/// ⟨y₁ y₂⟩ = (1/2π)∫ |F|² W₁(jω) W₂(−jω) dω, with a bound that holds for the coefficients given.
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
/// `OutOfRange` when both signals have a white part, so that the mean is infinite; else as
/// [`evaluate`](crate::integral::evaluate) of H, the denominators' product.
pub fn cross_moment(
    shaping: &TransferFunction,
    first: &TransferFunction,
    second: &TransferFunction,
) -> Result<Integral> {
    mean_product(shaping, first, second, false)
}

/// ⟨y₁ ẏ₂⟩ = −⟨ẏ₁ y₂⟩ = (1/2π)∫ |F|² W₁(jω) (−jω) W₂(−jω) dω: what the quadrature part of a cross-spectrum leaves in the
/// mean, with a bound that holds for the coefficients given.
///
/// ```
/// use gyrospec::lti::{TransferFunction, cross_rate_moment};
/// let one = TransferFunction::constant(1.0);
/// let fast = TransferFunction::new(&[1.0], &[0.5, 1.0]).unwrap();
/// let slow = TransferFunction::new(&[1.0], &[2.0, 1.0]).unwrap();
/// // white noise through two lags: (1/T₁ − 1/T₂)/(2 (T₁ + T₂)), on both sides of zero lag
/// let mean = cross_rate_moment(&one, &fast, &slow).unwrap().value;
/// assert!((mean - 0.3).abs() < 1e-15);
/// assert_eq!(mean, -cross_rate_moment(&one, &slow, &fast).unwrap().value);
/// ```
///
/// # Errors
/// `OutOfRange` when one of the two has a white part or both together fall off no faster than 1/ω, so that the mean is
/// infinite; else as [`cross_moment`].
pub fn cross_rate_moment(
    shaping: &TransferFunction,
    first: &TransferFunction,
    second: &TransferFunction,
) -> Result<Integral> {
    mean_product(shaping, first, second, true)
}

/// ⟨y₁ y₂⟩, or ⟨y₁ ẏ₂⟩ where `rate`.
fn mean_product(
    shaping: &TransferFunction,
    first: &TransferFunction,
    second: &TransferFunction,
    rate: bool,
) -> Result<Integral> {
    let same = first.denominator() == second.denominator();
    let order = shaping.order() + first.order() + if same { 0 } else { second.order() };
    falls_off([shaping, first, second], rate)?;
    if order > MAX_ORDER {
        return Err(Error::bad_input(format!(
            "both filters together have order {order}, above the limit of {MAX_ORDER}"
        )));
    }
    if order == 0 {
        return Ok(Integral {
            value: 0.0,
            error_bound: 0.0,
            condition: f64::INFINITY,
            method: Method::Exact,
        });
    }
    let filters = [shaping, first, second];
    let guess = Common::new(filters, rate, 0);
    // short integers, in the time in which the condition is told
    let h = guess.h.rounded();
    let usable = h.iter().all(|a| a.is_finite()) && h[0] != 0.0;
    let time = if usable { integers_time_shift(&h) } else { 0 };
    let common = if time == 0 { guess } else { Common::new(filters, rate, time) };
    let (g, of_g) = (common.even(), common.c1.exponent + common.c2.exponent);
    let near_g = whole::rounded(&g, of_g, 2 * time);
    let near = Integrand::new(&h, &near_g).ok();
    let (h, of_h) = (common.h.coefficients, common.h.exponent);
    exact::of_whole(exact::Whole { h, g, of_h, of_g, time }, near.as_ref())
}

/// Both signals over their common denominator, in s = 2^time·s′.
struct Common {
    h: Whole,
    c1: Whole,
    c2: Whole,
}

impl Common {
    fn new([shaping, first, second]: [&TransferFunction; 3], rate: bool, time: i32) -> Self {
        let [f, p, q] = [shaping, first, second].map(|w| Whole::new(w.denominator(), time));
        let [c, mut c1, mut c2] = [shaping, first, second].map(|w| Whole::new(w.numerator(), time));
        let mut h = f.times(&p);
        if first.denominator() != second.denominator() {
            (h, c1, c2) = (h.times(&q), c1.times(&q), c2.times(&p));
        }
        (c1, c2) = (c1.times(&c), c2.times(&c));
        if rate {
            c2 = c2.differentiated();
        }
        Self { h, c1, c2 }
    }

    /// b0 … b(n−1); the b of s^2n is zero in what falls off.
    fn even(&self) -> Vec<IBig> {
        self.c1.even_part(&self.c2, self.h.coefficients.len() - 1).split_off(1)
    }
}

/// Refuses a mean product that is infinite: the even part of the integrand falls off at least as 1/ω² where the
/// integrand falls off at all.
fn falls_off([shaping, first, second]: [&TransferFunction; 3], rate: bool) -> Result<()> {
    if [shaping, first, second].iter().any(|w| w.numerator() == [0.0]) {
        return Ok(());
    }
    let poles = 2 * shaping.relative_degree() + first.relative_degree() + second.relative_degree();
    let says = match (rate, poles) {
        (false, 0) => "both signals hold white noise, so the mean of their product is infinite",
        (true, 0) => "both signals hold white noise, which has no rate",
        (true, 1) => {
            "one signal holds white noise and the rate of the other too, so the mean of their product is infinite"
        }
        _ => return Ok(()),
    };
    Err(Error::new(ErrorKind::OutOfRange, says).with_hint("limit the band of the motion"))
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
    /// As [`evaluate`](crate::integral::evaluate); where W has as many zeros as poles the variance is infinite.
    pub fn variance(&self) -> Result<Integral> {
        cross_moment(&Self::constant(1.0), self, self)
    }
}
