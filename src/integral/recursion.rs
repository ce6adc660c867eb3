//! I_n by the unpivoted Routh / Åström-Jury-Agniel recursion, with a running error bound.
//!
//! # Purpose
//! The default path: O(n²) operations, no pivoting, no determinant, no matrix.
//!
//! # Method
//! Routh's array of H: r_0 = (a0, a2 …), r_1 = (a1, a3 …),
//!   α_k = r_(k−1)\[0\]/r_k\[0\],   r_(k+1)\[i\] = r_(k−1)\[i+1\] − α_k·r_k\[i+1\],
//! H stable ⇔ all α_k > 0. For G = C(s)C(−s) the integral is Σ β_k²/(2α_k), with the β_k of the
//! same elimination applied to C; for G = b_(n−1) it collapses to b/(2·r_(n−1)\[0\]·a_n). Other
//! G go through the moments (see `moments`), which need the α_k alone.
//!
//! # References
//! K. J. Åström, E. I. Jury, R. G. Agniel, IEEE Trans. AC-15 (1970) 611; E. J. Routh (1877).
//!
//! # Numerical aspects
//! Beside each r an absolute bound E of its error is carried, in doubles:
//!   E(r_(k+1)\[i\]) = E(a) + α·((1+ε)·E(b) + (ε + 2υ)·|b|) + 2υ·|a|,  a = r_(k−1)\[i+1\], b = r_k\[i+1\],
//! where ε bounds the relative error of α_k and υ that of one operation. The bounds are sums of
//! products of positive numbers, so that their own rounding is below 10⁻¹² of them for n ≤ 1000;
//! a factor 1.001 covers it. A positive leading entry that exceeds its bound proves stability.
//! The Hurwitz matrix of a stable polynomial is totally nonnegative, so elimination without
//! pivoting is stable in the sense of small componentwise backward error (de Boor, Pinkus 1977).

use super::real::{Magnitude, Real};

/// Rows and bounds of one evaluation, kept between calls so that nothing is allocated again.
#[derive(Debug)]
pub(super) struct Work<R: Real> {
    /// The rows r_0 … r_n, one after the other.
    pub rows: Vec<R>,
    /// Absolute error bounds of the rows.
    pub bounds: Vec<R::Mag>,
    /// w\[k\] = 1/α_k, k = 1 … n; index 0 unused.
    pub w: Vec<R>,
    /// Two rows of the expansion of sʲ (see `moments`).
    pub v: [Vec<R>; 2],
    /// The coefficients of C in the orthogonal basis.
    pub m: Vec<R>,
    /// The same with all terms taken positive.
    pub sizes: Vec<R::Mag>,
}

impl<R: Real> Default for Work<R> {
    fn default() -> Self {
        Self {
            rows: Vec::new(),
            bounds: Vec::new(),
            w: Vec::new(),
            v: [Vec::new(), Vec::new()],
            m: Vec::new(),
            sizes: Vec::new(),
        }
    }
}

/// Entries of row k: ⌊(n−k)/2⌋ + 1.
#[inline(always)]
pub(super) fn row_length(n: usize, k: usize) -> usize {
    (n - k) / 2 + 1
}

/// Entries of all rows together: Σ_j (⌊j/2⌋ + 1), j = 0 … n.
#[inline(always)]
pub(super) fn array_length(n: usize) -> usize {
    n * n / 4 + n + 1
}

/// Where row k starts: after the rows of a polynomial of order n that one of order n − k lacks.
#[inline(always)]
pub(super) fn row_start(n: usize, k: usize) -> usize {
    array_length(n) - array_length(n - k)
}

/// Bound of the relative error of all α_k together; nothing when stability is not proven.
///
/// Fills `work.rows`, `work.bounds` and `work.w` from the scaled coefficients `a(0) … a(n)`.
#[inline(always)]
pub(super) fn array<R: Real>(work: &mut Work<R>, n: usize, a: impl Fn(usize) -> R) -> Option<R::Mag> {
    let mag = R::Mag::new;
    let size = array_length(n);
    if work.rows.len() < size {
        work.rows.resize(size, R::new(0.0));
        work.bounds.resize(size, mag(0.0));
    }
    if work.w.len() <= n {
        work.w.resize(n + 1, R::new(0.0));
    }
    let (rows, bounds) = (&mut work.rows[..size], &mut work.bounds[..size]);
    let (l0, l1) = (row_length(n, 0), row_length(n, 1));
    for i in 0..=n {
        rows[if i % 2 == 0 { i / 2 } else { l0 + i / 2 }] = a(i);
    }
    bounds[..l0 + l1].fill(mag(0.0));
    let mut worst = mag(0.0);
    // relative bound and reciprocal of r_(k−1)[0]
    let (mut ex, mut ix) = (mag(0.0), rows[0].reciprocal());
    let mut start = 0;
    for k in 1..=n {
        let (lx, ly) = (row_length(n, k - 1), row_length(n, k));
        let (x, y) = (rows[start], rows[start + lx]);
        let iy = y.reciprocal();
        let ey = bounds[start + lx] * iy.value();
        // a leading entry below its bound, or no number at all, proves nothing
        let positive = y.value().all(|y| y > 1e-120 && y < 1e120);
        if !(positive && ey.all(|e| e < 1.0 / 64.0)) {
            return None;
        }
        // |α − α̂| ≤ α̂·ε, and the same for 1/α
        let alpha = x.times(iy);
        let both = ex + ey;
        let epsilon = both * (mag(1.0) + mag(1.1) * both) + mag(2.1 * R::UNIT);
        worst = worst.larger(epsilon);
        work.w[k] = y.times(ix);
        (ex, ix) = (ey, iy);
        if k < n {
            let (old, rest) = rows[start + 1..].split_at_mut(lx - 1);
            let (now, new) = rest.split_at_mut(ly);
            let (old_bound, rest) = bounds[start + 1..].split_at_mut(lx - 1);
            let (now_bound, new_bound) = rest.split_at_mut(ly);
            let step = Step { alpha, epsilon };
            step.entries(old, &now[1..], new);
            step.bounds((old, old_bound), (&now[1..], &now_bound[1..]), new_bound);
        }
        start += lx;
    }
    Some(mag(1.001) * worst)
}

/// One step of the recursion.
struct Step<R: Real> {
    alpha: R,
    epsilon: R::Mag,
}

impl<R: Real> Step<R> {
    #[inline(always)]
    fn entries(&self, old: &[R], now: &[R], new: &mut [R]) {
        let m = now.len();
        // r_(k+1)[i] = r_(k−1)[i+1] − α_k·r_k[i+1]
        for ((r, a), b) in new[..m].iter_mut().zip(&old[..m]).zip(now) {
            *r = a.minus(self.alpha, *b);
        }
        if old.len() > m {
            new[m] = old[m];
        }
    }

    #[inline(always)]
    fn bounds(&self, old: (&[R], &[R::Mag]), now: (&[R], &[R::Mag]), new: &mut [R::Mag]) {
        let m = now.0.len();
        let (old_bound, now_bound, new_bound) = (&old.1[..m], &now.1[..m], &mut new[..m]);
        let c = R::Mag::new(2.0 * R::UNIT);
        let (alpha, q, e) = (self.alpha.value(), R::Mag::new(1.0) + self.epsilon, self.epsilon + c);
        // E(r) = E(a) + α·((1+ε)·E(b) + (ε + 2υ)·|b|) + 2υ·|a|
        for i in 0..m {
            let inner = q * now_bound[i] + e * now.0[i].value().abs();
            new_bound[i] = old_bound[i] + c * old.0[i].value().abs() + alpha * inner;
        }
        if old.0.len() > m {
            new[m] = old.1[m];
        }
    }
}
