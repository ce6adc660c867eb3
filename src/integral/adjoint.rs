//! Derivatives of I_n by running the recursion backwards.
//!
//! # Purpose
//! The componentwise condition number of every answer and the gradient for optimisers, in O(n²).
//!
//! # Method
//! The adjoint of `moments` gives ∂I/∂w_m, and with w = 1/α that of `recursion` gives ∂I/∂a_i:
//! for k = n … 1, with r̄ the adjoint of r,
//!   ᾱ_k −= Σ_i r̄_(k+1)\[i\]·r_k\[i+1\],   r̄_k\[i+1\] −= α_k·r̄_(k+1)\[i\],   r̄_(k−1)\[i+1\] += r̄_(k+1)\[i\],
//!   r̄_(k−1)\[0\] += ᾱ_k/r_k\[0\],   r̄_k\[0\] −= ᾱ_k·α_k/r_k\[0\].
//!
//! # References
//! A. Griewank, A. Walther, Evaluating Derivatives (2008), ch. 3.

use super::moments::Weight;
use super::real::Real;
use super::real::Single;
use super::recursion::{Work, row_length, row_start};
use super::scale::Scale;
use super::{Integrand, Numerator};
use crate::exact::{IBig, Rounded, ldexp, round_ratio};
use crate::poly::routh::Array;

/// Derivatives of the scaled integral in the scaled coefficients.
#[derive(Debug)]
pub(super) struct Derivatives<A> {
    /// ∂I/∂a_i, i = 0 … n.
    pub h: Vec<A>,
    /// ∂I/∂ of the coefficient of s^(2k) of G, or of sᵏ of C; k = 0 … degree.
    pub numerator: Vec<A>,
}

/// Σ|x·∂I/∂x|/|I| over all coefficients.
#[inline(always)]
pub(super) fn condition<R: Real<Mag = f64>>(
    p: &Integrand<'_>,
    scale: &Scale,
    weight: Weight<R>,
    work: &Work<R>,
    value: f64,
) -> f64 {
    let d = derivatives(p, scale, weight, work, |x: R| Single::<false>::new(x.value()));
    let of_h = d.h.iter().enumerate().map(|(i, x)| (x.value() * scale.h(p.h, i)).abs());
    let of_g = d.numerator.iter().enumerate();
    let of_g = of_g.map(|(k, x)| (x.value() * scale.numerator(&p.numerator, k)).abs());
    (of_h.sum::<f64>() + of_g.sum::<f64>()) / value.abs()
}

/// The condition number from the minors of the exact tier, each row entry rounded once; infinite
/// where the numbers leave the range of doubles or the value is 0. The integers are the
/// coefficients times 2^`exponent`.
pub(super) fn condition_of_exact(p: &Integrand<'_>, array: &Array, exponent: i64, value: f64) -> f64 {
    let Some(scale) = super::scale::choose(p).filter(|_| value != 0.0) else { return f64::INFINITY };
    let (n, one) = (p.order(), IBig::ONE);
    let mut work = Work::<Single<false>>::default();
    for (k, row) in array.rows.iter().enumerate() {
        // r_k[i] = D_k[i]/Δ_(k−1)
        let divisor = if k >= 2 { &array.rows[k - 1][0] } else { &one };
        for d in row {
            match round_ratio(d, divisor, exponent - i64::from(scale.gain)) {
                Rounded::Value(r, _) => work.rows.push(Single(r)),
                Rounded::OutOfRange(_) => return f64::INFINITY,
            }
        }
    }
    work.w.push(Single(0.0));
    for k in 1..=n {
        let (x, y) = (work.rows[row_start(n, k - 1)].0, work.rows[row_start(n, k)].0);
        work.w.push(Single(y / x));
    }
    let weight = Weight { n, degree: p.degree(), last: Single(scale.h(p.h, n)), epsilon: 0.0 };
    let condition = condition(p, &scale, weight, &work, ldexp(value, -scale.value));
    if condition.is_nan() { f64::INFINITY } else { condition }
}

/// All derivatives, from the rows and weights that an evaluation left in `work`.
#[inline(always)]
pub(super) fn derivatives<A: Real<Mag = f64>, R: Real<Mag = f64>>(
    p: &Integrand<'_>,
    scale: &Scale,
    h: Weight<R>,
    work: &Work<R>,
    convert: impl Fn(R) -> A,
) -> Derivatives<A> {
    let n = h.n;
    let w: Vec<A> = (0..=h.degree).map(|m| convert(work.w[n - m])).collect();
    let expansions = expand(&w, convert(h.last.reciprocal()));
    let outer = match p.numerator {
        Numerator::Even(_) => even_seeds(&w, &expansions, |k| scale.numerator(&p.numerator, k)),
        Numerator::Square(_) => square_seeds(&w, &expansions, |k| scale.numerator(&p.numerator, k)),
    };
    let (w_bar, v_bar) = expansions_back(&w, &expansions, outer.w, outer.v);
    let minus = |x: A| A::new(0.0).minus(x, A::new(1.0));
    // α = 1/w: ᾱ_(n−m) = −w̄_m·w_m²
    let mut alpha_bar = vec![A::new(0.0); n + 1];
    for m in 0..=h.degree {
        alpha_bar[n - m] = minus(w_bar[m].times(w[m].times(w[m])));
    }
    let mut rows = rows_back(n, work, alpha_bar, &convert);
    // v₀⁰ = 1/a_n
    let v0 = expansions[0][0];
    rows[n] = rows[n].minus(v_bar, v0.times(v0));
    Derivatives { h: rows, numerator: outer.numerator }
}

/// v^k for k = 0 … degree.
#[inline(always)]
fn expand<A: Real<Mag = f64>>(w: &[A], first: A) -> Vec<Vec<A>> {
    let mut all = vec![vec![first]];
    for k in 0..w.len() - 1 {
        let v = &all[k];
        let mut next = vec![A::new(0.0); k + 2];
        for m in (k % 2..=k).step_by(2) {
            let up = w[m].times(v[m]);
            next[m + 1] = next[m + 1].plus(up);
            if m > 0 {
                next[m - 1] = next[m - 1].plus(up);
            }
        }
        all.push(next);
    }
    all
}

/// Adjoints that enter at the sums over m, before the expansions are run backwards.
struct Seeds<A> {
    w: Vec<A>,
    v: Vec<Vec<A>>,
    numerator: Vec<A>,
}

/// I = ½·Σ_k (−1)^k·b_k·Σ_m w_m·(v_m^k)².
#[inline(always)]
fn even_seeds<A: Real<Mag = f64>>(w: &[A], v: &[Vec<A>], g: impl Fn(usize) -> f64) -> Seeds<A> {
    let mut seeds = Seeds { w: vec![A::new(0.0); w.len()], v: Vec::new(), numerator: Vec::new() };
    for (k, v) in v.iter().enumerate() {
        let sign = if k % 2 == 0 { 0.5 } else { -0.5 };
        let b = A::new(sign * g(k));
        let (mut moment, mut back) = (A::new(0.0), vec![A::new(0.0); v.len()]);
        for m in (k % 2..=k).step_by(2) {
            let square = v[m].times(v[m]);
            moment = moment.plus(w[m].times(square));
            seeds.w[m] = seeds.w[m].plus(b.times(square));
            back[m] = A::new(2.0).times(b.times(w[m].times(v[m])));
        }
        seeds.v.push(back);
        seeds.numerator.push(A::new(sign).times(moment));
    }
    seeds
}

/// I = ½·Σ_m w_m·s_m², s_m = Σ_k ±c_k·v_m^k.
#[inline(always)]
fn square_seeds<A: Real<Mag = f64>>(w: &[A], v: &[Vec<A>], c: impl Fn(usize) -> f64) -> Seeds<A> {
    let sign = |k: usize, m: usize| if (k - m).is_multiple_of(4) { 1.0 } else { -1.0 };
    let mut s = vec![A::new(0.0); w.len()];
    for (k, v) in v.iter().enumerate() {
        for m in (k % 2..=k).step_by(2) {
            s[m] = s[m].plus(A::new(sign(k, m) * c(k)).times(v[m]));
        }
    }
    let half = A::new(0.5);
    let of_w = s.iter().map(|x| half.times(x.times(*x))).collect();
    let mut seeds = Seeds { w: of_w, v: Vec::new(), numerator: Vec::new() };
    for (k, v) in v.iter().enumerate() {
        let (mut own, mut back) = (A::new(0.0), vec![A::new(0.0); v.len()]);
        for m in (k % 2..=k).step_by(2) {
            let ws = A::new(sign(k, m)).times(w[m].times(s[m]));
            own = own.plus(ws.times(v[m]));
            back[m] = A::new(c(k)).times(ws);
        }
        seeds.v.push(back);
        seeds.numerator.push(own);
    }
    seeds
}

/// From the seeds to w̄ and the adjoint of v₀⁰.
#[inline(always)]
fn expansions_back<A: Real<Mag = f64>>(
    w: &[A],
    v: &[Vec<A>],
    mut w_bar: Vec<A>,
    mut v_bar: Vec<Vec<A>>,
) -> (Vec<A>, A) {
    for k in (0..v.len() - 1).rev() {
        for m in (k % 2..=k).step_by(2) {
            let mut t = v_bar[k + 1][m + 1];
            if m > 0 {
                t = t.plus(v_bar[k + 1][m - 1]);
            }
            v_bar[k][m] = v_bar[k][m].plus(w[m].times(t));
            w_bar[m] = w_bar[m].plus(v[k][m].times(t));
        }
    }
    let first = v_bar[0][0];
    (w_bar, first)
}

/// From ᾱ to ∂I/∂a_i.
#[inline(always)]
fn rows_back<A: Real<Mag = f64>, R: Real<Mag = f64>>(
    n: usize,
    work: &Work<R>,
    alpha_bar: Vec<A>,
    convert: &impl Fn(R) -> A,
) -> Vec<A> {
    let zero = A::new(0.0);
    // adjoints of r_(k+1), r_k, r_(k−1); their places follow the in-place array a_0 … a_n
    let mut a = vec![zero; n + 2];
    for k in (1..=n).rev() {
        let (x, y) = (&work.rows[row_start(n, k - 1)..], &work.rows[row_start(n, k)..]);
        let iy = convert(y[0]).reciprocal();
        let alpha = convert(x[0]).times(iy);
        let mut bar = alpha_bar[k];
        for i in 0..row_length(n, k) - 1 {
            // r_(k+1)[i] stands at k + 1 + 2i, where r_(k−1)[i+1] stood; r_k[i+1] at k + 2 + 2i
            let outer = a[k + 1 + 2 * i];
            bar = bar.minus(outer, convert(y[i + 1]));
            a[k + 2 + 2 * i] = a[k + 2 + 2 * i].minus(outer, alpha);
        }
        let share = bar.times(iy);
        a[k - 1] = a[k - 1].plus(share);
        a[k] = a[k].minus(share, alpha);
    }
    a.truncate(n + 1);
    a
}
