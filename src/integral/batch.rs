//! Many integrals of one order.
//!
//! # Purpose
//! Sweeps over parameters: the plain recursion with its guaranteed bound, eight problems abreast.
//!
//! # Method
//! The kernel of [`super::evaluate_fast`] on eight lanes. A group in which any lane is out of the
//! safe range or not proven stable is done one by one. From [`PARALLEL`] problems on, both cores
//! (and more, where there are more) share the work; the answers do not depend on how.
//!
//! # Numerical aspects
//! The coefficients are taken unscaled where all lie within 2^±200, which leaves the answers
//! those of the scaled kernel to the last bit.

use super::evaluate::{Kernel, dispatch};
use super::moments::{self, Weight};
use super::real::{Magnitude, Real};
use super::recursion::{self, Work};
use super::{Estimate, Integrand};
use crate::{Error, Result};
use rayon::prelude::*;
use std::ops::{Add, Mul};

/// Problems from which on the work is shared between cores.
pub const PARALLEL: usize = 4096;

const LANES: usize = 8;

/// The integrals of many (H, G) of one order n: `h` holds n + 1 coefficients a problem, `g` holds
/// n, problem after problem.
///
/// ```
/// use gyrospec::integral::batch;
/// let answers = batch::evaluate_fast(1, &[1.0, 1.0, 1.0, 2.0], &[1.0, 1.0])?;
/// assert_eq!(answers[0].as_ref().unwrap().value, 0.5);
/// assert_eq!(answers[1].as_ref().unwrap().value, 0.25);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `BadInput` where the lengths do not fit; each problem's own refusal stands in its place.
pub fn evaluate_fast(n: usize, h: &[f64], g: &[f64]) -> Result<Vec<Result<Estimate>>> {
    if n == 0 || !h.len().is_multiple_of(n + 1) || h.len() / (n + 1) * n != g.len() {
        return Err(Error::bad_input(format!(
            "{} coefficients of H and {} of G are no whole number of problems of order {n}",
            h.len(),
            g.len()
        )));
    }
    if h.len() / (n + 1) < PARALLEL {
        return Ok(dispatch(Block { n, h, g }));
    }
    let size = PARALLEL / 4;
    let pairs: Vec<_> = h.chunks(size * (n + 1)).zip(g.chunks(size * n)).collect();
    let parts: Vec<_> = pairs.into_par_iter().map(|(h, g)| dispatch(Block { n, h, g })).collect();
    Ok(parts.into_iter().flatten().collect())
}

struct Block<'a> {
    n: usize,
    h: &'a [f64],
    g: &'a [f64],
}

impl Kernel for Block<'_> {
    type Output = Vec<Result<Estimate>>;

    #[inline(always)]
    fn run<const FMA: bool>(self) -> Self::Output {
        let n = self.n;
        let count = self.h.len() / (n + 1);
        let mut out = Vec::with_capacity(count);
        let mut work = Work::<Lanes<FMA>>::default();
        while out.len() < count {
            let at = out.len();
            let group = LANES.min(count - at);
            let h = &self.h[at * (n + 1)..(at + group) * (n + 1)];
            let g = &self.g[at * n..(at + group) * n];
            match (group == LANES).then(|| abreast(n, h, g, &mut work)).flatten() {
                Some((value, bound)) => out.extend(
                    value
                        .0
                        .iter()
                        .zip(bound.0)
                        .map(|(&value, error_bound)| Ok(Estimate { value, error_bound })),
                ),
                None => out.extend(
                    h.chunks(n + 1)
                        .zip(g.chunks(n))
                        .map(|(h, g)| super::evaluate_fast(&Integrand::new(h, g)?)),
                ),
            }
        }
        out
    }
}

/// Eight problems at once, or nothing where one of them needs more care.
#[inline(always)]
fn abreast<const F: bool>(
    n: usize,
    h: &[f64],
    g: &[f64],
    work: &mut Work<Lanes<F>>,
) -> Option<(Lanes<F>, Lanes<F>)> {
    const SMALL: f64 = 6.2e-61; // 2^-200
    let inside = |x: &f64| (SMALL..1.0 / SMALL).contains(x);
    if !h.iter().all(inside) || !g.iter().all(|x| *x == 0.0 || inside(&x.abs())) {
        return None;
    }
    let lane = |x: &[f64], stride: usize, i: usize| Lanes(std::array::from_fn(|l| x[l * stride + i]));
    let degree = (0..n).find(|&k| (0..LANES).any(|l| g[l * n + k] != 0.0)).map_or(0, |k| n - 1 - k);
    let epsilon = recursion::array(work, n, |i| lane(h, n + 1, i))?;
    let weight = Weight { n, degree, last: lane(h, n + 1, n), epsilon };
    let r = moments::even(work, weight, |k| lane(g, n, n - 1 - k))?;
    let fits = r.bound.0.iter().zip(r.value.0).all(|(b, v)| *b <= 1e-3 * v.abs() && v.is_normal());
    fits.then_some((r.value, <Lanes<F> as Magnitude>::new(1.001) * r.bound))
}

/// Eight doubles abreast.
#[derive(Clone, Copy, Debug)]
struct Lanes<const FMA: bool>([f64; LANES]);

impl<const F: bool> Lanes<F> {
    #[inline(always)]
    fn zip(self, x: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], x.0[i])))
    }
}

impl<const F: bool> Add for Lanes<F> {
    type Output = Self;
    #[inline(always)]
    fn add(self, x: Self) -> Self {
        self.zip(x, |a, b| a + b)
    }
}

impl<const F: bool> Mul for Lanes<F> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, x: Self) -> Self {
        self.zip(x, |a, b| a * b)
    }
}

impl<const F: bool> Magnitude for Lanes<F> {
    #[inline(always)]
    fn new(x: f64) -> Self {
        Self([x; LANES])
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }
    #[inline(always)]
    fn larger(self, x: Self) -> Self {
        self.zip(x, f64::max)
    }
    #[inline(always)]
    fn all(self, condition: impl Fn(f64) -> bool) -> bool {
        self.0.map(condition).iter().all(|x| *x)
    }
}

impl<const F: bool> Real for Lanes<F> {
    type Mag = Self;
    const UNIT: f64 = super::real::Single::<F>::UNIT;

    #[inline(always)]
    fn new(x: f64) -> Self {
        Self([x; LANES])
    }
    #[inline(always)]
    fn value(self) -> Self {
        self
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self(self.0.map(|x| -x))
    }
    #[inline(always)]
    fn plus(self, x: Self) -> Self {
        self + x
    }
    #[inline(always)]
    fn times(self, x: Self) -> Self {
        self * x
    }
    #[inline(always)]
    fn minus(self, a: Self, b: Self) -> Self {
        Self(std::array::from_fn(|i| {
            if F { a.0[i].mul_add(-b.0[i], self.0[i]) } else { self.0[i] - a.0[i] * b.0[i] }
        }))
    }
    #[inline(always)]
    fn reciprocal(self) -> Self {
        Self(self.0.map(|x| 1.0 / x))
    }
}
