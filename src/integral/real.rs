//! The arithmetic that the recursions run on: doubles and pairs of doubles.
//!
//! # Purpose
//! One kernel, several widths. Every operation states a bound of its rounding error.
//!
//! # References
//! T. J. Dekker, Numer. Math. 18 (1971) 224; M. Joldes, J.-M. Muller, V. Popescu, ACM Trans. Math.
//! Softw. 44 (2017) 15 (bounds of double-word arithmetic).
//!
//! # Numerical aspects
//! With u = 2⁻⁵³: products, sums of equal sign and reciprocals carry a relative error of at most
//! [`Real::UNIT`]; `a.minus(b, c)` = a − b·c carries at most 2·UNIT·(|a| + |b·c|). For pairs the
//! proven bounds are 5u² (product), 3u² (sum of equal sign), 10u² (reciprocal as computed here:
//! the neglected square of the residual 4u², its rounding 2u², the correction's 2u², and 2u² of
//! the final sum) and, for a sum of unlike signs, 6u² of the sum of the absolute values; 16u² is
//! used for all. FMA selects the fused product; without it Dekker's splitting gives the same bits
//! for magnitudes below 2⁹⁹⁶, which the scaling in `scale` ensures.

use std::ops::{Add, Mul};

/// Magnitudes: what error bounds are made of; one double, or one a lane.
pub(super) trait Magnitude: Copy + Add<Output = Self> + Mul<Output = Self> {
    /// The same double in every lane.
    fn new(x: f64) -> Self;
    /// |self|.
    fn abs(self) -> Self;
    /// The larger of two.
    fn larger(self, x: Self) -> Self;
    /// Whether a condition holds in every lane.
    fn all(self, condition: impl Fn(f64) -> bool) -> bool;
}

impl Magnitude for f64 {
    #[inline(always)]
    fn new(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }
    #[inline(always)]
    fn larger(self, x: Self) -> Self {
        self.max(x)
    }
    #[inline(always)]
    fn all(self, condition: impl Fn(f64) -> bool) -> bool {
        condition(self)
    }
}

/// A number that the recursions can run on.
pub(super) trait Real: Copy {
    type Mag: Magnitude;
    /// Bound of the relative rounding error of one operation.
    const UNIT: f64;
    /// A double, exactly.
    fn new(x: f64) -> Self;
    /// The nearest double.
    fn value(self) -> Self::Mag;
    /// −self.
    fn negative(self) -> Self;
    /// self + x.
    fn plus(self, x: Self) -> Self;
    /// self·x.
    fn times(self, x: Self) -> Self;
    /// self − a·b.
    fn minus(self, a: Self, b: Self) -> Self;
    /// 1/self.
    fn reciprocal(self) -> Self;
}

/// One double.
#[derive(Clone, Copy, Debug)]
pub(super) struct Single<const FMA: bool>(pub f64);

impl<const FMA: bool> Real for Single<FMA> {
    type Mag = f64;
    const UNIT: f64 = 1.2e-16;

    #[inline(always)]
    fn new(x: f64) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn value(self) -> f64 {
        self.0
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self(-self.0)
    }
    #[inline(always)]
    fn plus(self, x: Self) -> Self {
        Self(self.0 + x.0)
    }
    #[inline(always)]
    fn times(self, x: Self) -> Self {
        Self(self.0 * x.0)
    }
    #[inline(always)]
    fn minus(self, a: Self, b: Self) -> Self {
        if FMA { Self(a.0.mul_add(-b.0, self.0)) } else { Self(self.0 - a.0 * b.0) }
    }
    #[inline(always)]
    fn reciprocal(self) -> Self {
        Self(1.0 / self.0)
    }
}

/// Two doubles, hi + lo with |lo| ≤ ulp(hi)/2.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<const FMA: bool> {
    pub hi: f64,
    pub lo: f64,
}

/// a + b = s + e exactly.
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// a + b = s + e exactly for |a| ≥ |b|.
#[inline(always)]
fn fast_two_sum<const FMA: bool>(a: f64, b: f64) -> Pair<FMA> {
    let hi = a + b;
    Pair { hi, lo: b - (hi - a) }
}

/// a·b = p + e exactly.
#[inline(always)]
fn two_product<const FMA: bool>(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    if FMA {
        return (p, a.mul_add(b, -p));
    }
    let split = |x: f64| {
        let c = 134_217_729.0 * x; // 2²⁷ + 1
        let hi = c - (c - x);
        (hi, x - hi)
    };
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, al * bl - (((p - ah * bh) - al * bh) - ah * bl))
}

impl<const FMA: bool> Real for Pair<FMA> {
    type Mag = f64;
    const UNIT: f64 = 16.0 / (9_007_199_254_740_992.0 * 9_007_199_254_740_992.0);

    #[inline(always)]
    fn new(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }
    #[inline(always)]
    fn value(self) -> f64 {
        self.hi
    }
    #[inline(always)]
    fn negative(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
    #[inline(always)]
    fn plus(self, x: Self) -> Self {
        let (s, e) = two_sum(self.hi, x.hi);
        fast_two_sum(s, e + (self.lo + x.lo))
    }
    #[inline(always)]
    fn times(self, x: Self) -> Self {
        let (p, e) = two_product::<FMA>(self.hi, x.hi);
        fast_two_sum(p, e + (self.hi * x.lo + self.lo * x.hi))
    }
    #[inline(always)]
    fn minus(self, a: Self, b: Self) -> Self {
        let (p, e) = two_product::<FMA>(a.hi, b.hi);
        let low = e + (a.hi * b.lo + a.lo * b.hi);
        let (s, t) = two_sum(self.hi, -p);
        fast_two_sum(s, t + (self.lo - low))
    }
    #[inline(always)]
    fn reciprocal(self) -> Self {
        // 1/(h + l) = r·(1 + t + …), t = 1 − r·(h + l)
        let r = 1.0 / self.hi;
        let (p, e) = two_product::<FMA>(r, self.hi);
        let t = ((1.0 - p) - e) - r * self.lo;
        fast_two_sum(r, r * t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{RBig, rational};
    use proptest::prelude::*;

    fn exact<const F: bool>(p: Pair<F>) -> RBig {
        rational(p.hi) + rational(p.lo)
    }

    /// |computed − truth| ≤ UNIT·size, exactly.
    fn within<const F: bool>(computed: Pair<F>, truth: &RBig, size: &RBig) -> bool {
        let error = exact(computed) - truth;
        let bound = size * rational(Pair::<F>::UNIT);
        error <= bound && -error <= bound
    }

    fn bounds_hold<const F: bool>(a: (f64, f64), b: (f64, f64), c: (f64, f64)) {
        let pair = |x: (f64, f64)| fast_two_sum::<F>(x.0, x.0 * x.1 * f64::EPSILON / 2.0);
        let (a, b, c) = (pair(a), pair(b), pair(c));
        let (x, y, z) = (exact(a), exact(b), exact(c));
        assert!(within(a.times(b), &(&x * &y), &(&x * &y)));
        assert!(within(a.plus(b), &(&x + &y), &(&x + &y)));
        assert!(within(a.reciprocal(), &(RBig::ONE / &x), &(RBig::ONE / &x)));
        assert!(within(a.minus(b, c), &(&x - &y * &z), &((&x + &y * &z) * RBig::from(2))));
        // the product taken away again: all but the rounding of the product cancels
        let p = b.times(c);
        let q = &y * &z;
        assert!(within(p.minus(b, c), &(exact(p) - &q), &(&q * RBig::from(4))));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn every_operation_stays_within_its_stated_bound(
            a in (1e-3f64..1e3, -1.0f64..1.0), b in (1e-3f64..1e3, -1.0f64..1.0), c in (1e-3f64..1e3, -1.0f64..1.0)
        ) {
            bounds_hold::<true>(a, b, c);
            bounds_hold::<false>(a, b, c);
        }
    }
}
