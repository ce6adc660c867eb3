//! Scaling of time and gain by powers of two.
//!
//! # Purpose
//! Brings any coefficients into the middle of the range of doubles without rounding, so that the
//! recursions neither overflow nor lose bits, and so that scaling the problem by powers of two
//! changes nothing but the exponent of the answer.
//!
//! # Method
//! With s = 2^σ·s′, σ = ⌊(e(a_n) − e(a_0))/n⌋: a_i′ = a_i·2^(σ(n−i) − ε), G's coefficient of s^(2k)
//! times 2^(2σk − γ), and I = I′·2^(σ + γ − 2ε). Exponents e are those of the leading bits.

use super::{Integrand, Numerator};
use crate::exact;

/// Powers of two that were taken out: I = I′·2^`value`, time s = 2^`time`·s′.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Scale {
    pub time: i32,
    pub gain: i32,
    pub numerator: i32,
    pub value: i64,
}

/// 2⁻²⁰⁰: coefficients between this and its reciprocal need no scaling.
const MODERATE: f64 = 6.223015277861142e-61;

/// Coefficients of H whose exponents stay within ± this are safe from over- and underflow.
const SAFE: i32 = 400;

/// The exponent of the leading bit; x finite, not 0.
#[inline(always)]
fn exponent(x: f64) -> i32 {
    let biased = ((x.to_bits() >> 52) & 0x7ff) as i32;
    if biased == 0 { exact::exponent(x) } else { biased - 1023 }
}

/// x·2^e when that is exact and well inside the range of doubles; NaN when not.
#[inline(always)]
fn shift(x: f64, e: i32) -> f64 {
    if x == 0.0 || e == 0 {
        return x;
    }
    if (exponent(x) + e).abs() > 2 * SAFE { f64::NAN } else { exact::ldexp(x, i64::from(e)) }
}

/// The largest exponent of the weighted coefficients, 0 where all vanish.
#[inline(always)]
fn largest(x: &[f64], weight: impl Fn(i32) -> i32) -> i32 {
    x.iter().zip(0..).filter(|(v, _)| **v != 0.0).map(|(&v, i)| exponent(v) + weight(i)).max().unwrap_or(0)
}

impl Scale {
    /// No scaling, where all coefficients are moderate as they stand and those of H of one sign:
    /// the same bits come out as with the scale that [`Scale::choose`] finds.
    #[inline(always)]
    pub fn none(p: &Integrand<'_>) -> Option<Self> {
        let moderate = |x: f64| (MODERATE..1.0 / MODERATE).contains(&x);
        let sign = 1f64.copysign(p.h[0]);
        let (Numerator::Even(x) | Numerator::Square(x)) = p.numerator;
        let fits = p.h.iter().all(|a| moderate(sign * a)) && x.iter().all(|b| *b == 0.0 || moderate(b.abs()));
        fits.then(Self::default)
    }

    /// Chooses the scale; nothing when the scaled coefficients of H would not all be positive and
    /// safe, which leaves the problem to the exact tier.
    pub fn choose(p: &Integrand<'_>) -> Option<Self> {
        let (h, n) = (p.h, (p.h.len() - 1) as i32);
        let negative = h[0] < 0.0;
        if h.iter().any(|&a| if negative { a >= 0.0 } else { a <= 0.0 }) {
            return None;
        }
        let (first, last) = (exponent(h[0]), exponent(h[n as usize]));
        let time = (last - first).div_euclid(n);
        // a_0′ then has exponent 0
        let gain = first + time * n;
        let safe = h.iter().zip(0..).all(|(&a, i)| (exponent(a) + time * (n - i) - gain).abs() <= SAFE);
        let numerator = match p.numerator {
            Numerator::Even(g) => largest(g, |i| 2 * time * (n - 1 - i)),
            Numerator::Square(c) => {
                let top = c.len() as i32 - 1;
                largest(c, |i| time * (top - i))
            }
        };
        let square = matches!(p.numerator, Numerator::Square(_));
        let gamma = if square { 2 * numerator } else { numerator };
        let value = i64::from(time) + i64::from(gamma) - 2 * i64::from(gain);
        safe.then_some(Scale { time, gain, numerator, value })
    }

    #[inline(always)]
    fn is_none(&self) -> bool {
        self.time == 0 && self.gain == 0 && self.numerator == 0
    }

    /// a_i′ > 0.
    #[inline(always)]
    pub fn h(&self, h: &[f64], i: usize) -> f64 {
        if self.is_none() {
            return h[i].abs();
        }
        let n = (h.len() - 1) as i32;
        shift(h[i].abs(), self.time * (n - i as i32) - self.gain)
    }

    /// The scaled coefficient of s^(2k) in G, or of s^k in C; NaN where that is not exact.
    #[inline(always)]
    pub fn numerator(&self, numerator: &Numerator<'_>, k: usize) -> f64 {
        let (Numerator::Even(x) | Numerator::Square(x)) = numerator;
        if self.is_none() {
            return x[x.len() - 1 - k];
        }
        match numerator {
            Numerator::Even(g) => shift(g[g.len() - 1 - k], 2 * self.time * k as i32 - self.numerator),
            Numerator::Square(c) => shift(c[c.len() - 1 - k], self.time * k as i32 - self.numerator),
        }
    }
}
