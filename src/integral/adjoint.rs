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
use crate::poly::stability::Array;
use std::cell::RefCell;

/// Derivatives of the scaled integral in the scaled coefficients, with what it takes to find them;
/// kept between calls so that nothing is allocated again.
#[derive(Debug)]
pub(super) struct Tape<A> {
    /// ∂I/∂a_i, i = 0 … n (and one place more).
    pub h: Vec<A>,
    /// ∂I/∂ of the coefficient of s^(2k) of G, or of sᵏ of C; k = 0 … degree.
    pub numerator: Vec<A>,
    /// w_m and its adjoint, m = 0 … degree.
    w: Vec<A>,
    w_bar: Vec<A>,
    /// v_m^k and its adjoint, k after k, degree + 1 places each.
    v: Vec<A>,
    v_bar: Vec<A>,
}

impl<A> Default for Tape<A> {
    fn default() -> Self {
        Self {
            h: Vec::new(),
            numerator: Vec::new(),
            w: Vec::new(),
            w_bar: Vec::new(),
            v: Vec::new(),
            v_bar: Vec::new(),
        }
    }
}

thread_local! {
    static TAPE: RefCell<Tape<Single<false>>> = RefCell::default();
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
    TAPE.with_borrow_mut(|tape| {
        tape.run(p, scale, weight, work, |x: R| Single::<false>::new(x.value()));
        let of_h = tape.h[..=weight.n].iter().enumerate().map(|(i, x)| (x.0 * scale.h(p.h, i)).abs());
        let of_g = tape.numerator.iter().enumerate();
        let of_g = of_g.map(|(k, x)| (x.0 * scale.numerator(&p.numerator, k)).abs());
        (of_h.sum::<f64>() + of_g.sum::<f64>()) / value.abs()
    })
}

/// The condition number from the minors of the exact tier, each row entry rounded once; infinite
/// where the numbers leave the range of doubles or the value is 0. The integers are the
/// coefficients times 2^−`exponent`.
pub(super) fn condition_of_exact(p: &Integrand<'_>, array: &Array, exponent: i64, value: f64) -> f64 {
    let Some(scale) = Scale::choose(p).filter(|_| value != 0.0) else { return f64::INFINITY };
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

impl<A: Real<Mag = f64>> Tape<A> {
    /// All derivatives, from the rows and weights that an evaluation left in `work`.
    #[inline(always)]
    pub fn run<R: Real<Mag = f64>>(
        &mut self,
        p: &Integrand<'_>,
        scale: &Scale,
        h: Weight<R>,
        work: &Work<R>,
        convert: impl Fn(R) -> A,
    ) {
        let (n, d) = (h.n, h.degree);
        let zero = A::new(0.0);
        for (list, size) in [(&mut self.v, (d + 1) * (d + 1)), (&mut self.v_bar, (d + 1) * (d + 1))] {
            list.clear();
            list.resize(size, zero);
        }
        for list in [&mut self.w, &mut self.w_bar, &mut self.numerator] {
            list.clear();
            list.resize(d + 1, zero);
        }
        for m in 0..=d {
            self.w[m] = convert(work.w[n - m]);
        }
        self.v[0] = convert(h.last.reciprocal());
        self.expand(d);
        match p.numerator {
            Numerator::Even(_) => self.seed_even(d, |k| scale.numerator(&p.numerator, k)),
            Numerator::Square(_) => self.seed_square(d, |k| scale.numerator(&p.numerator, k)),
        }
        self.expand_back(d);
        self.rows_back(n, d, work, convert);
        // v₀⁰ = 1/a_n
        self.h[n] = self.h[n].minus(self.v_bar[0], self.v[0].times(self.v[0]));
    }

    /// v^k for k = 0 … d.
    #[inline(always)]
    fn expand(&mut self, d: usize) {
        for k in 0..d {
            let (now, next) = (k * (d + 1), (k + 1) * (d + 1));
            for m in (k % 2..=k).step_by(2) {
                let up = self.w[m].times(self.v[now + m]);
                self.v[next + m + 1] = self.v[next + m + 1].plus(up);
                if m > 0 {
                    self.v[next + m - 1] = self.v[next + m - 1].plus(up);
                }
            }
        }
    }

    /// I = ½·Σ_k (−1)^k·b_k·Σ_m w_m·(v_m^k)².
    #[inline(always)]
    fn seed_even(&mut self, d: usize, g: impl Fn(usize) -> f64) {
        for k in 0..=d {
            let sign = if k % 2 == 0 { 0.5 } else { -0.5 };
            let (b, mut moment) = (A::new(sign * g(k)), A::new(0.0));
            for m in (k % 2..=k).step_by(2) {
                let (v, w) = (self.v[k * (d + 1) + m], self.w[m]);
                let square = v.times(v);
                moment = moment.plus(w.times(square));
                self.w_bar[m] = self.w_bar[m].plus(b.times(square));
                self.v_bar[k * (d + 1) + m] = A::new(2.0).times(b.times(w.times(v)));
            }
            self.numerator[k] = A::new(sign).times(moment);
        }
    }

    /// I = ½·Σ_m w_m·s_m², s_m = Σ_k ±c_k·v_m^k.
    #[inline(always)]
    fn seed_square(&mut self, d: usize, c: impl Fn(usize) -> f64) {
        let sign = |k: usize, m: usize| if (k - m).is_multiple_of(4) { 1.0 } else { -1.0 };
        for m in 0..=d {
            let mut s = A::new(0.0);
            for k in (m..=d).step_by(2) {
                s = s.plus(A::new(sign(k, m) * c(k)).times(self.v[k * (d + 1) + m]));
            }
            let ws = self.w[m].times(s);
            self.w_bar[m] = A::new(0.5).times(s.times(s));
            for k in (m..=d).step_by(2) {
                let (at, signed) = (k * (d + 1) + m, A::new(sign(k, m)).times(ws));
                self.numerator[k] = self.numerator[k].plus(signed.times(self.v[at]));
                self.v_bar[at] = A::new(c(k)).times(signed);
            }
        }
    }

    /// The expansions backwards.
    #[inline(always)]
    fn expand_back(&mut self, d: usize) {
        for k in (0..d).rev() {
            let (now, next) = (k * (d + 1), (k + 1) * (d + 1));
            for m in (k % 2..=k).step_by(2) {
                let mut t = self.v_bar[next + m + 1];
                if m > 0 {
                    t = t.plus(self.v_bar[next + m - 1]);
                }
                self.v_bar[now + m] = self.v_bar[now + m].plus(self.w[m].times(t));
                self.w_bar[m] = self.w_bar[m].plus(self.v[now + m].times(t));
            }
        }
    }

    /// From w̄ through ᾱ to ∂I/∂a_i.
    #[inline(always)]
    fn rows_back<R: Real<Mag = f64>>(
        &mut self,
        n: usize,
        d: usize,
        work: &Work<R>,
        convert: impl Fn(R) -> A,
    ) {
        let zero = A::new(0.0);
        // the adjoint of r_k[i] stands at k + 2i, where the in-place recursion keeps r_k[i]
        let a = &mut self.h;
        a.clear();
        a.resize(n + 2, zero);
        for k in (1..=n).rev() {
            let (x, y) = (&work.rows[row_start(n, k - 1)..], &work.rows[row_start(n, k)..]);
            let iy = convert(y[0]).reciprocal();
            let alpha = convert(x[0]).times(iy);
            let m = n - k;
            // α = 1/w: ᾱ_(n−m) = −w̄_m·w_m²
            let mut bar = if m <= d { zero.minus(self.w_bar[m], self.w[m].times(self.w[m])) } else { zero };
            for (i, r) in y[1..row_length(n, k)].iter().enumerate() {
                let outer = a[k + 1 + 2 * i];
                bar = bar.minus(outer, convert(*r));
                a[k + 2 + 2 * i] = a[k + 2 + 2 * i].minus(outer, alpha);
            }
            let share = bar.times(iy);
            a[k - 1] = a[k - 1].plus(share);
            a[k] = a[k].minus(share, alpha);
        }
        a.truncate(n + 1);
    }
}
