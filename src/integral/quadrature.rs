//! I_n by numeric integration through the crate `quadrature`.
//!
//! # Purpose
//! A check of the algebraic methods that shares nothing with them.
//!
//! # Method
//! I = (1/π)∫₀^∞ G(jω)/|H(jω)|² dω, cut at every pole frequency |Im p| and at |Im p| ± k·|Re p|,
//! k = 1, 4, 16, 64, and at 4ᵏ beyond the fastest pole; past the last cut W the variable x = 1/ω
//! runs over (0, 1/W). Each piece goes to the double exponential rule.
//!
//! # References
//! H. Takahasi, M. Mori, Publ. RIMS 9 (1974) 721.
//!
//! # Numerical aspects
//! The crate evaluates a piece at no more than about 350 points, reports a large error estimate
//! but returns the number anyway, and turns values that are not finite into 0. Here a value that
//! is not finite, or a total error estimate above the target, is a refusal. The estimate includes
//! the rounding of H(jω) near lightly damped poles. It is an estimate, not a guaranteed bound.

use super::{Integrand, Numerator};
use crate::exact::{exponent, integers_time_shift, ldexp};
use crate::poly::{even_square, roots::roots};
use crate::{Error, Result};
#[cfg(feature = "serde")]
use serde::Serialize;
use std::cell::Cell;

/// A value by numeric integration.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(Serialize))]
pub struct Quadrature {
    /// I_n as the sum of the pieces of the frequency axis.
    pub value: f64,
    /// Estimated absolute error.
    pub error_estimate: f64,
    /// Evaluations of the integrand.
    pub evaluations: u32,
}

/// The integral with an estimated relative error of at most `target`.
///
/// ```
/// use gyrospec::integral::{Integrand, quadrature};
/// let e = quadrature::evaluate(&Integrand::new(&[1.0, 2e-3, 1.0], &[0.0, 1.0])?, 1e-9)?;
/// assert!((e.value - 250.0).abs() < 1e-6);
/// # Ok::<(), gyrospec::Error>(())
/// ```
///
/// # Errors
/// `Unstable`, `ImaginaryAxis` as decided exactly; `NotComputed` where the estimate exceeds the
/// target or the integrand is not finite somewhere.
pub fn evaluate(p: &Integrand<'_>, target: f64) -> Result<Quadrature> {
    super::exact::require_stable(p.h)?;
    let density = Density::new(p)?;
    let cuts = density.cuts();
    let (rough, _) = density.integrate(&cuts, f64::MAX)?;
    let (fine, evaluations) =
        density.integrate(&cuts, 0.1 * target * rough.value.abs() / (cuts.len() + 1) as f64)?;
    let back = |x: f64| ldexp(x, density.exponent);
    let asked = target * fine.value.abs();
    // each piece stops where its own estimate, which is optimistic, falls below its target
    let estimate = Quadrature {
        value: back(fine.value),
        error_estimate: back(fine.error_estimate.max(asked)),
        evaluations,
    };
    let empty = density.g.iter().all(|b| *b == 0.0);
    if fine.error_estimate <= asked && (estimate.value.is_normal() || empty) {
        return Ok(estimate);
    }
    Err(Error::not_computed(format!(
        "quadrature reaches only {:.1e} relative error, {target:.1e} was asked",
        fine.error_estimate / fine.value.abs()
    )))
}

/// The integrand in scaled frequency.
struct Density {
    h: Vec<f64>,
    g: Vec<f64>,
    exponent: i64,
}

impl Density {
    fn new(p: &Integrand<'_>) -> Result<Self> {
        let n = p.order();
        let time = i64::from(integers_time_shift(p.h));
        let gain = i64::from(exponent(p.h[0])) + time * n as i64;
        let h: Vec<f64> =
            p.h.iter().enumerate().map(|(i, &a)| ldexp(a, time * (n - i) as i64 - gain)).collect();
        let g = match p.numerator {
            Numerator::Even(g) => g.to_vec(),
            Numerator::Square(c) => {
                let mut full = vec![0.0; n - c.len()];
                full.extend_from_slice(c);
                even_square(&full)
            }
        };
        let largest = g.iter().filter(|b| **b != 0.0).map(|b| i64::from(exponent(*b))).max().unwrap_or(0);
        let shifted = |(k, &b): (usize, &f64)| ldexp(b, 2 * time * (n - 1 - k) as i64 - largest);
        let scaled: Vec<f64> = g.iter().enumerate().map(shifted).collect();
        // squares of the coefficients must stay inside the range of doubles
        let fits = |x: &f64| *x == 0.0 || (1e-140..1e140).contains(&x.abs());
        let lost = g.iter().zip(&scaled).any(|(b, s)| (*b == 0.0) != (*s == 0.0));
        if lost || !h.iter().chain(&scaled).all(fits) {
            return Err(Error::not_computed(
                "the coefficients span more decades than quadrature in doubles can hold",
            ));
        }
        Ok(Self { h, g: scaled, exponent: time + largest - 2 * gain })
    }

    /// G(jω)/|H(jω)|² and the relative rounding of it.
    fn at(&self, omega: f64) -> (f64, f64) {
        // beyond ω = 1 in powers of 1/ω: H(jω)/ωⁿ and G(jω)/ω^(2n−2), so that nothing overflows
        let inside = omega <= 1.0;
        let x = if inside { omega } else { 1.0 / omega };
        let (mut re, mut im, mut size) = (0.0, 0.0, 0.0);
        let n = self.h.len() - 1;
        let mut power = 1.0;
        for k in 0..=n {
            // the coefficient of s^k, or of s^(n−k)
            let (a, turn) = if inside { (self.h[n - k], k) } else { (self.h[k], n - k) };
            let term = a * power;
            match turn % 4 {
                0 => re += term,
                1 => im += term,
                2 => re -= term,
                _ => im -= term,
            }
            size += term.abs();
            power *= x;
        }
        let (mut g, mut g_size, mut power) = (0.0, 0.0, 1.0);
        for k in 0..n {
            let (b, turn) = if inside { (self.g[n - 1 - k], k) } else { (self.g[k], n - 1 - k) };
            let term = if turn % 2 == 0 { b * power } else { -b * power };
            g += term;
            g_size += term.abs();
            power *= x * x;
        }
        let square = re * re + im * im;
        let tail = if inside { 1.0 } else { x * x };
        let rounding = f64::EPSILON * n as f64;
        let value = g / square * tail;
        (value, rounding * (g_size / square * tail + 2.0 * value.abs() * size / square.sqrt()))
    }

    /// Where the integrand is cut, ascending, all positive.
    fn cuts(&self) -> Vec<f64> {
        let poles = roots(&self.h);
        let mut cuts: Vec<f64> = Vec::new();
        for p in &poles {
            let (re, im) = (p.re.abs().max(f64::EPSILON * p.norm()), p.im.abs());
            cuts.push(im);
            for k in [1.0, 4.0, 16.0, 64.0, 256.0, 1024.0] {
                cuts.extend([im - k * re, im + k * re].into_iter().filter(|w| *w < 4.0 * p.norm()));
            }
        }
        let fastest = poles.iter().fold(0.0f64, |m, p| m.max(p.norm()));
        cuts.extend([4.0 * fastest, 16.0 * fastest]);
        cuts.retain(|w| *w > 1e-12 * fastest && w.is_finite());
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| (*a - *b).abs() < 1e-3 * self.width(*b, &poles));
        cuts
    }

    /// The distance from jω to the nearest pole.
    #[allow(clippy::unused_self)]
    fn width(&self, omega: f64, poles: &[num_complex::Complex64]) -> f64 {
        poles.iter().map(|p| (p - num_complex::Complex64::new(0.0, omega)).norm()).fold(f64::MAX, f64::min)
    }

    /// All pieces, each to the absolute error `target`.
    fn integrate(&self, cuts: &[f64], target: f64) -> Result<(Quadrature, u32)> {
        let (odd, rounding, weight) = (Cell::new(false), Cell::new(0.0f64), Cell::new(0.0f64));
        let watch = |(value, error): (f64, f64)| {
            odd.set(odd.get() || !value.is_finite());
            if value != 0.0 {
                rounding.set(rounding.get() + error);
                weight.set(weight.get() + value.abs());
            }
            value
        };
        let (mut value, mut error, mut evaluations, mut noise) = (0.0, 0.0, 0, 0.0);
        let mut add = |o: quadrature::Output| {
            value += o.integral;
            error += o.error_estimate;
            evaluations += o.num_function_evaluations;
            // mean relative rounding over the points of this piece
            if weight.get() > 0.0 {
                noise += o.integral.abs() * rounding.get() / weight.get();
            }
            rounding.set(0.0);
            weight.set(0.0);
        };
        let mut from = 0.0;
        for &to in cuts {
            add(quadrature::integrate(|w| watch(self.at(w)), from, to, target));
            from = to;
        }
        // ∫_W^∞ F(ω) dω = ∫_0^(1/W) F(1/x)/x² dx
        let tail = |x: f64| {
            let (f, e) = self.at(1.0 / x);
            watch((f / (x * x), e / (x * x)))
        };
        add(quadrature::integrate(tail, 0.0, 1.0 / from, target));
        if odd.get() {
            return Err(Error::not_computed("the integrand is not finite at some frequency"));
        }
        let pi = std::f64::consts::PI;
        Ok((Quadrature { value: value / pi, error_estimate: (error + noise) / pi, evaluations }, evaluations))
    }
}
