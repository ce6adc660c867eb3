//! Moments of 1/|H|² and integrals of any numerator from them.
//!
//! # Purpose
//! General even G of high order, where the direct recursion on G loses a thousand times more.
//!
//! # Method
//! The polynomials q_m = r_(n−m) (degree m, the rows of Routh's array) are orthogonal with weight
//! 1/|H(jω)|² and have ‖q_m‖² = w_m/2, w_m = 1/α_(n−m). Multiplication by s is tridiagonal,
//!   s·q_m = w_m·(q_(m+1) − q_(m−1)),
//! so the coefficients of sᵏ have the sign (−1)^((k−m)/2) and magnitudes without any subtraction:
//!   v₀⁰ = 1/a_n,   v_m^(k+1) = w_(m−1)·v_(m−1)^k + w_(m+1)·v_(m+1)^k,
//!   M_k = (1/2π)∫ ω^(2k)/|H|² dω = ½·Σ_m w_m·(v_m^k)²,   I = Σ_k (−1)^k·b_(n−1−k)·M_k,
//! and for G = C(s)C(−s): I = ½·Σ_m w_m·(Σ_k ±c_k·v_m^k)².
//!
//! # References
//! The orthogonality is that of the Schwarz form: H. R. Schwarz, Z. angew. Math. Phys. 7 (1956)
//! 473; K. J. Åström, Introduction to Stochastic Control Theory (1970), ch. 5.
//!
//! # Numerical aspects
//! A moment is a sum of products of 2k + 1 factors w: its relative error is at most (2k + 1)·ε for
//! α_k known to ε, and 4(k + 3) operations of υ more. Only the final sum over k can cancel.

use super::real::{Magnitude, Real};
use super::recursion::Work;

/// A value with an absolute bound of its error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounded<R: Real> {
    pub value: R,
    pub bound: R::Mag,
}

/// What the expansions need to know of H.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight<R: Real> {
    /// Order of H.
    pub n: usize,
    /// Highest k with a nonzero coefficient of the numerator.
    pub degree: usize,
    /// The last coefficient of H, scaled.
    pub last: R,
    /// Bound of the relative error of the α_k.
    pub epsilon: R::Mag,
}

/// Magnitudes outside 10^±90 could underflow in a product of three.
#[inline(always)]
fn safe<R: Real>(x: R) -> bool {
    x.value().all(|x| (1e-90..=1e90).contains(&x))
}

/// The next expansion: v_m^(k+1) from v_m^k for m ≡ k + 1 (mod 2), m ≤ k + 1; false where a
/// magnitude leaves the safe range.
#[inline(always)]
fn advance<R: Real>(w: &[R], (n, k): (usize, usize), v: &[R], next: &mut [R]) -> bool {
    let mut fits = true;
    for m in ((k + 1) % 2..=k + 1).step_by(2) {
        // v_m^(k+1) = w_(m−1)·v_(m−1)^k + w_(m+1)·v_(m+1)^k
        let below = (m > 0).then(|| w[n + 1 - m].times(v[m - 1]));
        let above = (m < k).then(|| w[n - 1 - m].times(v[m + 1]));
        next[m] = match (below, above) {
            (Some(x), Some(y)) => x.plus(y),
            (Some(x), None) | (None, Some(x)) => x,
            (None, None) => R::new(0.0),
        };
        fits &= safe(next[m]) && safe(w[n - m]);
    }
    fits
}

/// Makes room and sets v⁰; false where 1/a_n or w_0 is out of the safe range.
#[inline(always)]
fn begin<R: Real>(work: &mut Work<R>, h: Weight<R>) -> bool {
    if work.sizes.len() <= h.n {
        for row in work.v.iter_mut().chain([&mut work.m]) {
            row.resize(h.n + 1, R::new(0.0));
        }
        work.sizes.resize(h.n + 1, R::Mag::new(0.0));
    }
    work.v[0][0] = h.last.reciprocal();
    safe(work.v[0][0]) && safe(work.w[h.n])
}

/// I of an even numerator; `g(k)` is G's coefficient of s^(2k), scaled.
#[inline(always)]
pub(super) fn even<R: Real>(work: &mut Work<R>, h: Weight<R>, g: impl Fn(usize) -> R) -> Option<Bounded<R>> {
    if !begin(work, h) {
        return None;
    }
    let mag = R::Mag::new;
    let (mut sum, mut size, mut bound) = (R::new(0.0), mag(0.0), mag(0.0));
    for k in 0..=h.degree {
        // I = Σ (−1)^k·b·M_k,  M_k = ½·Σ_m w_m·(v_m^k)²
        let half = g(k).times(R::new(if k % 2 == 0 { -0.5 } else { 0.5 }));
        let mut moment = R::new(0.0);
        for m in (k % 2..=k).step_by(2) {
            let v = work.v[0][m];
            moment = moment.plus(work.w[h.n - m].times(v.times(v)));
        }
        sum = sum.minus(half, moment);
        let term = half.value().abs() * moment.value();
        size = size + term;
        bound = bound + term * (mag((2 * k + 1) as f64) * h.epsilon + mag((5 * k + 9) as f64 * R::UNIT));
        if k < h.degree {
            let [v, next] = &mut work.v;
            if !advance(&work.w, (h.n, k), v, next) {
                return None;
            }
            work.v.swap(0, 1);
        }
    }
    bound = bound + mag(4.0 * (h.degree + 1) as f64 * R::UNIT) * size;
    let usable = h.epsilon.all(|e| e * ((2 * h.degree + 1) as f64) < 1e-3)
        && size.all(|s| (1e-250..1e250).contains(&s) || s == 0.0);
    usable.then_some(Bounded { value: sum, bound: mag(1.002) * bound })
}

/// I of G = C(s)C(−s); `c(k)` is C's coefficient of sᵏ, scaled.
#[inline(always)]
pub(super) fn square<R: Real>(
    work: &mut Work<R>,
    h: Weight<R>,
    c: impl Fn(usize) -> R,
) -> Option<Bounded<R>> {
    if !begin(work, h) {
        return None;
    }
    let mag = R::Mag::new;
    work.m[..=h.degree].fill(R::new(0.0));
    work.sizes[..=h.degree].fill(mag(0.0));
    for k in 0..=h.degree {
        let x = c(k);
        for m in (k % 2..=k).step_by(2) {
            // s_m = Σ_k (−1)^((k−m)/2)·c_k·v_m^k
            let term = if (k - m) % 4 == 0 { x.negative() } else { x };
            work.m[m] = work.m[m].minus(term, work.v[0][m]);
            work.sizes[m] = work.sizes[m] + x.value().abs() * work.v[0][m].value();
        }
        if k < h.degree {
            let [v, next] = &mut work.v;
            if !advance(&work.w, (h.n, k), v, next) {
                return None;
            }
            work.v.swap(0, 1);
        }
    }
    let d = h.degree as f64;
    // relative to Σ|c|·v: d factors of w, 2d + 1 operations on v, 4(d + 1) on the sum
    let rho = mag(d) * h.epsilon + mag((6.0 * d + 8.0) * R::UNIT);
    let (mut sum, mut bound) = (R::new(0.0), mag(0.0));
    for m in 0..=h.degree {
        let (s, w) = (work.m[m], work.w[h.n - m]);
        // I = ½·Σ_m w_m·s_m²
        sum = sum.plus(w.times(s.times(s)));
        let (size, error) = (s.value().abs(), work.sizes[m] * rho);
        let own = size * size * (h.epsilon + mag((d + 6.0) * R::UNIT));
        let cross = error * (mag(2.0) * size + error) * (mag(1.0) + h.epsilon);
        bound = bound + w.value() * (cross + own);
    }
    let usable = h.epsilon.all(|e| e * (d + 1.0) < 1e-3) && sum.value().all(|s| (1e-200..1e250).contains(&s));
    let half = sum.times(R::new(0.5));
    usable.then_some(Bounded { value: half, bound: mag(0.501) * bound })
}
