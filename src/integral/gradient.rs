//! The gradient of I_n in all coefficients of H and of the numerator.
//!
//! # Purpose
//! Exact slopes for optimisers and for the sensitivity of a variance to its parameters.
//!
//! # Method
//! The adjoint of the recursion (see `adjoint`), in pairs of doubles.
//!
//! # Numerical aspects
//! O(n²) operations. Refused where the recursion in pairs knows its α_k to fewer than 12 digits.

use super::adjoint::Tape;
use super::evaluate::attempt;
use super::real::Pair;
use super::recursion::Work;
use super::{Integrand, Numerator};
use crate::exact::ldexp;
use crate::{Error, Result};

/// Derivatives of I_n.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// The integral itself, to double precision.
    pub value: f64,
    /// ∂I/∂a0 … ∂I/∂an; n + 1 of them.
    pub h: Vec<f64>,
    /// ∂I/∂b0 … ∂I/∂b(n−1), or the derivatives in the coefficients of C; as many as were given.
    pub numerator: Vec<f64>,
}

/// I_n and its derivatives in every coefficient.
///
/// ```
/// use gyrospec::integral::{Integrand, gradient::gradient};
/// // I_1 = b0/(2·a0·a1)
/// let d = gradient(&Integrand::new(&[2.0, 5.0], &[3.0])?)?;
/// assert_eq!((d.value, d.numerator[0]), (0.15, 0.05));
/// assert!((d.h[0] + 0.075).abs() < 1e-16 && (d.h[1] + 0.03).abs() < 1e-16);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// As [`super::evaluate`]; `NotComputed` where the recursion cannot vouch for 12 digits or a
/// derivative leaves the range of doubles.
pub fn gradient(p: &Integrand<'_>) -> Result<Gradient> {
    let mut work = Work::<Pair<false>>::default();
    let Some((scale, weight, r)) = attempt(p, &mut work).filter(|(_, h, _)| h.epsilon < 1e-12) else {
        // says why, where H is to blame
        super::evaluate(p)?;
        return Err(Error::not_computed("the coefficients are too ill-conditioned for a gradient")
            .with_hint("take differences of `integral::exact::rational` instead"));
    };
    let mut d = Tape::<Pair<false>>::default();
    d.run(p, &scale, weight, &work, |x| x);
    let (n, time) = (p.order(), i64::from(scale.time));
    let back = |x: Pair<false>, shift: i64| ldexp(x.hi, scale.value + shift);
    // ∂I/∂a = ∂I′/∂a′·∂a′/∂a·(I/I′), and a′ = a·2^(time·(n−i) − gain)
    let sign = p.h[0].signum();
    let h =
        d.h.iter().enumerate().map(|(i, x)| sign * back(*x, time * (n - i) as i64 - i64::from(scale.gain)));
    let power = match p.numerator {
        Numerator::Even(_) => 2,
        Numerator::Square(_) => 1,
    };
    let numerator = d
        .numerator
        .iter()
        .enumerate()
        .rev()
        .map(|(k, x)| back(*x, power * time * k as i64 - i64::from(scale.numerator)));
    let out = Gradient { value: back(r.value, 0), h: h.collect(), numerator: numerator.collect() };
    let finite = out.h.iter().chain(&out.numerator).all(|x| x.is_finite());
    if finite { Ok(out) } else { Err(Error::not_computed("a derivative is no finite double")) }
}
