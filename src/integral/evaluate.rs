//! The two calls that users make.
//!
//! # Purpose
//! [`evaluate`]: within 2 units in the last place of the exact integral of the doubles given, or a
//! refusal. [`evaluate_fast`]: plain doubles with their guaranteed bound.
//!
//! # Method
//! The recursion runs in pairs of doubles with a running bound. Where the bound is wider than half
//! a unit in the last place, where stability is not proven by it, or where the scaled numbers could
//! leave the safe range, the exact tier answers instead.
//!
//! # Numerical aspects
//! The value is the leading double of the pair: its distance from the exact integral is at most
//! the trailing double plus the bound, that is at most one unit in the last place.

use super::adjoint;
use super::moments::{self, Bounded, Weight};
use super::real::{Pair, Real, Single};
use super::recursion::{self, Work};
use super::scale::Scale;
use super::{Integral, Integrand, Method, Numerator, exact};
use crate::Result;
use crate::exact::ldexp;
use std::cell::RefCell;

/// I_n within 2 units in the last place of the exact integral of the given doubles.
///
/// ```
/// use gyrospec::integral::{Integrand, evaluate};
/// use gyrospec::ErrorKind;
/// let stable = evaluate(&Integrand::new(&[1.0, 1.0], &[1.0])?)?;
/// assert_eq!(stable.value, 0.5);
/// let axis = evaluate(&Integrand::new(&[1.0, 0.0, 1.0], &[0.0, 1.0])?);
/// assert_eq!(axis.unwrap_err().kind(), ErrorKind::ImaginaryAxis);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `Unstable` with the number of right-half-plane roots, `ImaginaryAxis`, `OutOfRange` with the
/// value in decimal; see [`exact::Refusal`] for these as data.
pub fn evaluate(p: &Integrand<'_>) -> Result<Integral> {
    match dispatch(Double(p)) {
        Some(answer) => Ok(answer),
        None => exact::evaluate(p),
    }
}

/// I_n by the recursion in plain doubles, with its guaranteed bound.
///
/// Where that bound exceeds a thousandth of the value, or stability is not proven by it, the
/// call goes on as [`evaluate`].
///
/// ```
/// use gyrospec::integral::{Integrand, evaluate_fast};
/// let a = evaluate_fast(&Integrand::new(&[1.0, 2.0, 3.0], &[0.0, 1.0])?)?;
/// assert!((a.value - 1.0 / 12.0).abs() <= a.error_bound && a.error_bound < 1e-15);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// As [`evaluate`].
#[inline]
pub fn evaluate_fast(p: &Integrand<'_>) -> Result<Estimate> {
    match dispatch(Plain(p)) {
        Some(estimate) => Ok(estimate),
        None => evaluate(p).map(|a| Estimate { value: a.value, error_bound: a.error_bound }),
    }
}

/// A value of I_n with its bound alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// I_n in plain doubles, within `error_bound` of the exact one.
    pub value: f64,
    /// |value − exact| ≤ error_bound for the doubles given, guaranteed.
    pub error_bound: f64,
}

thread_local! {
    static SINGLE: RefCell<(Work<Single<true>>, Work<Single<false>>)> = RefCell::default();
    static PAIR: RefCell<(Work<Pair<true>>, Work<Pair<false>>)> = RefCell::default();
}

/// A kernel in both forms.
pub(super) trait Kernel {
    type Output;
    fn run<const FMA: bool>(self) -> Self::Output;
}

struct Fused<K>(K);

#[cfg(target_arch = "x86_64")]
impl<K: Kernel> pulp::NullaryFnOnce for Fused<K> {
    type Output = K::Output;
    #[inline(always)]
    fn call(self) -> K::Output {
        self.0.run::<true>()
    }
}

/// Runs a kernel with the processor's fused multiply-add where there is one.
#[inline(always)]
pub(super) fn dispatch<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if let pulp::x86::Arch::V3(simd) = pulp::x86::Arch::new() {
        return simd.vectorize(Fused(kernel));
    }
    if cfg!(target_arch = "aarch64") { Fused(kernel).0.run::<true>() } else { kernel.run::<false>() }
}

struct Plain<'a>(&'a Integrand<'a>);

impl Kernel for Plain<'_> {
    type Output = Option<Estimate>;
    #[inline(always)]
    fn run<const FMA: bool>(self) -> Option<Estimate> {
        SINGLE.with_borrow_mut(|w| if FMA { single(self.0, &mut w.0) } else { single(self.0, &mut w.1) })
    }
}

struct Double<'a>(&'a Integrand<'a>);

impl Kernel for Double<'_> {
    type Output = Option<Integral>;
    #[inline(always)]
    fn run<const FMA: bool>(self) -> Option<Integral> {
        PAIR.with_borrow_mut(|w| if FMA { pair(self.0, &mut w.0) } else { pair(self.0, &mut w.1) })
    }
}

/// An integral with its powers of two and its bound.
pub(super) type Found<R> = (Scale, Weight<R>, Bounded<R>);

/// The integral, unscaled where that is enough; nothing where the tier cannot answer.
#[inline(always)]
pub(super) fn attempt<R: Real>(p: &Integrand<'_>, work: &mut Work<R>) -> Option<Found<R>> {
    // the body stands once, so that it is compiled once
    for chosen in [false, true] {
        let scale = if chosen { Some(Scale::choose(p)?) } else { Scale::none(p) };
        if let Some(found) = scale.and_then(|scale| scaled(p, scale, work)) {
            return Some(found);
        }
    }
    None
}

#[inline(always)]
fn scaled<R: Real>(p: &Integrand<'_>, scale: Scale, work: &mut Work<R>) -> Option<Found<R>> {
    let n = p.order();
    let epsilon = recursion::array(work, n, |i| R::new(scale.h(p.h, i)))?;
    let weight = Weight { n, degree: p.degree(), last: R::new(scale.h(p.h, n)), epsilon };
    let coefficient = |k| R::new(scale.numerator(&p.numerator, k));
    let result = match p.numerator {
        Numerator::Even(_) => moments::even(work, weight, coefficient),
        Numerator::Square(_) => moments::square(work, weight, coefficient),
    };
    result.map(|r| (scale, weight, r))
}

#[inline(always)]
fn single<const F: bool>(p: &Integrand<'_>, work: &mut Work<Single<F>>) -> Option<Estimate> {
    let (scale, _, r) = attempt(p, work)?;
    let value = r.value.0;
    let (value, error_bound) = (r.bound <= 1e-3 * value.abs()).then(|| rescale(&scale, value, r.bound))??;
    Some(Estimate { value, error_bound })
}

#[inline(always)]
fn pair<const F: bool>(p: &Integrand<'_>, work: &mut Work<Pair<F>>) -> Option<Integral> {
    let (scale, weight, r) = attempt(p, work)?;
    let hi = r.value.hi;
    // half a unit in the last place is at least 2⁻⁵⁴ of the value
    let narrow = r.bound <= 5.5e-17 * hi.abs();
    if !narrow || hi == 0.0 {
        return None;
    }
    let (value, error_bound) = rescale(&scale, hi, r.value.lo.abs() + r.bound)?;
    let condition = adjoint::condition(p, &scale, weight, work, hi);
    Some(Integral { value, error_bound, condition, method: Method::RecursionDoubleDouble })
}

/// Puts the powers of two back; nothing where the value is then no normal double.
#[inline(always)]
pub(super) fn rescale(scale: &Scale, value: f64, bound: f64) -> Option<(f64, f64)> {
    let bound = 1.001 * bound;
    if scale.value == 0 {
        return Some((value, bound));
    }
    let (value, bound) = (ldexp(value, scale.value), ldexp(bound, scale.value));
    // the smallest double more than covers the rounding of a bound below the normal range
    (value.is_normal() && bound.is_finite()).then(|| (value, bound + f64::from_bits(1)))
}
