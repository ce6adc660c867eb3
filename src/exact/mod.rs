//! Integers and rationals of any size behind the exact tier.
//!
//! # Purpose
//! Doubles are rationals with a power of two below. Here they become integers over one common
//! power of two, and ratios of such integers become the nearest double again.
//!
//! # Numerical aspects
//! Nothing is rounded but in [`round_ratio`], which rounds once, to nearest, ties to even.

use dashu_base::{Abs, BitTest, Signed, UnsignedAbs};
pub use dashu_int::{IBig, UBig};
pub use dashu_ratio::RBig;

/// A double as mantissa and exponent: x = m·2^e, exactly; (0, 0) for zero. `x` is finite.
pub fn split(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (mut m, mut e) = match exponent {
        0 => (fraction, -1074),
        _ => (fraction | (1 << 52), exponent - 1075),
    };
    if m == 0 {
        return (0, 0);
    }
    let zeros = m.trailing_zeros();
    m >>= zeros;
    e += zeros as i32;
    (if x < 0.0 { -m } else { m }, e)
}

/// The exponent e with 2^e ≤ |x| < 2^(e+1), for finite x ≠ 0.
pub fn exponent(x: f64) -> i32 {
    let (m, e) = split(x);
    e + 63 - m.unsigned_abs().leading_zeros() as i32
}

/// A double as an exact rational.
///
/// ```
/// use gyrospec::exact::{rational, RBig};
/// assert_eq!(rational(0.375), RBig::from_parts(3.into(), 8u8.into()));
/// ```
pub fn rational(x: f64) -> RBig {
    let (m, e) = split(x);
    if e >= 0 {
        RBig::from(IBig::from(m) << e as usize)
    } else {
        RBig::from_parts(IBig::from(m), UBig::ONE << e.unsigned_abs() as usize)
    }
}

/// Doubles as integers over one power of two: x_i·2^(σ·w_i) = k_i·2^e for all i.
///
/// `weight(i)` is w_i; the returned exponent e is the smallest that keeps all k_i whole.
pub fn integers(x: &[f64], shift: i32, weight: impl Fn(usize) -> i32) -> (Vec<IBig>, i64) {
    let parts: Vec<(i64, i64)> = x
        .iter()
        .enumerate()
        .map(|(i, &v)| {
            let (m, e) = split(v);
            (m, i64::from(e) + i64::from(shift) * i64::from(weight(i)))
        })
        .collect();
    let common = parts.iter().filter(|p| p.0 != 0).map(|p| p.1).min().unwrap_or(0);
    let whole = |&(m, e): &(i64, i64)| match m {
        0 => IBig::ZERO,
        _ => IBig::from(m) << (e - common) as usize,
    };
    (parts.iter().map(whole).collect(), common)
}

/// A shift of time that brings the exponents of the first and the last coefficient together, so
/// that the integers stay short.
pub fn integers_time_shift(h: &[f64]) -> i32 {
    let n = h.len() as i32 - 1;
    match h.iter().rposition(|a| *a != 0.0) {
        Some(last) if last > 0 && n > 0 => (exponent(h[last]) - exponent(h[0])).div_euclid(last as i32),
        _ => 0,
    }
}

/// A ratio of integers as a double.
#[derive(Debug, Clone, PartialEq)]
pub enum Rounded {
    /// The nearest double, normal or zero, and whether it is the ratio itself.
    Value(f64, bool),
    /// No finite normal double: the ratio in decimal, three significant digits.
    OutOfRange(String),
}

/// (p/q)·2^e rounded once to the nearest double, ties to even; q ≠ 0.
pub fn round_ratio(p: &IBig, q: &IBig, e: i64) -> Rounded {
    if *p == IBig::ZERO {
        return Rounded::Value(0.0, true);
    }
    let negative = p.is_negative() != q.is_negative();
    let (n, d) = (p.clone().unsigned_abs(), q.clone().unsigned_abs());
    // 55 or 56 bits of quotient: 53 for the double, the rest and the remainder to round by.
    let shift = 55 - (n.bit_len() as i64 - d.bit_len() as i64);
    let (quotient, remainder) = if shift >= 0 {
        dashu_base::DivRem::div_rem(n << shift as usize, &d)
    } else {
        dashu_base::DivRem::div_rem(n, &(d << shift.unsigned_abs() as usize))
    };
    let exact = remainder == UBig::ZERO;
    let bits = quotient.bit_len() as i64;
    let Ok(wide) = u64::try_from(&quotient) else { return Rounded::OutOfRange(decimal(p, q, e)) };
    let drop = bits - 53;
    let (kept, rest) = (wide >> drop, wide & ((1 << drop) - 1));
    let half = 1u64 << (drop - 1);
    let up = rest > half || (rest == half && (!exact || kept & 1 == 1));
    let mantissa = (kept + u64::from(up)) as f64;
    let power = e - shift + drop;
    let value = ldexp(mantissa, power);
    if !value.is_normal() {
        return Rounded::OutOfRange(decimal(p, q, e));
    }
    Rounded::Value(if negative { -value } else { value }, exact && rest == 0)
}

/// x·2^e, correct while the result is zero, normal or overflows; subnormals round.
pub fn ldexp(x: f64, e: i64) -> f64 {
    let power = |k: i64| f64::from_bits(((k + 1023) as u64) << 52);
    let e = e.clamp(-3000, 3000);
    let (mut x, mut e) = (x, e);
    while e > 1000 {
        x *= power(1000);
        e -= 1000;
    }
    while e < -1000 {
        x *= power(-1000);
        e += 1000;
    }
    x * power(e)
}

/// (p/q)·2^e in decimal with three significant digits, for values that no double holds.
fn decimal(p: &IBig, q: &IBig, e: i64) -> String {
    let sign = if p.is_negative() == q.is_negative() { "" } else { "-" };
    let two = |k: i64| UBig::ONE << k.max(0) as usize;
    let n = p.clone().abs().unsigned_abs() * two(e);
    let d = q.clone().abs().unsigned_abs() * two(-e);
    // a first guess of the decimal exponent from the bit lengths, mended below
    let mut ten = ((n.bit_len() as f64 - d.bit_len() as f64) * 2f64.log10()).floor() as i64;
    let ten_to = |k: i64| UBig::from(10u8).pow(k.max(0) as usize);
    loop {
        // digits = round(n/d·10^(2 − ten))
        let (a, b) = (&n * ten_to(2 - ten), &d * ten_to(ten - 2));
        let digits = (a * 2u8 + &b) / (b * 2u8);
        match digits.to_string().as_str() {
            s if s.len() == 3 => return format!("{sign}{}.{}e{ten:+}", &s[..1], &s[1..]),
            "1000" => ten += 1,
            s if s.len() < 3 => ten -= 1,
            _ => ten += 1,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_double_survives_the_way_through_integers() {
        for x in [1.0, -0.1, 5e-324, f64::MAX, f64::MIN_POSITIVE, 3.0e-310, 12345.678] {
            let (m, e) = split(x);
            assert_eq!(m as f64 * 2f64.powi(e / 2) * 2f64.powi(e - e / 2), x);
            if x.is_normal() {
                assert_eq!(round_ratio(&IBig::from(m), &IBig::ONE, i64::from(e)), Rounded::Value(x, true));
            }
        }
        assert_eq!(exponent(1.0), 0);
        assert_eq!(exponent(0.75), -1);
        assert_eq!(exponent(5e-324), -1074);
    }

    #[test]
    fn ratios_round_as_the_processor_divides() {
        for (a, b) in [(1i64, 3i64), (-2, 7), (i64::MAX, 3), (1, 10), (9_007_199_254_740_993, 1)] {
            let expected = if b == 1 { a as f64 } else { a as f64 / b as f64 };
            if a.abs() < 1 << 53 || b == 1 {
                assert!(
                    matches!(round_ratio(&a.into(), &b.into(), 0), Rounded::Value(v, _) if v == expected)
                );
            }
        }
    }

    #[test]
    fn what_no_double_holds_is_said_in_decimal() {
        let big = IBig::from(10).pow(340) * 5 / 4;
        assert_eq!(round_ratio(&big, &IBig::ONE, 0), Rounded::OutOfRange("1.25e+340".into()));
        assert_eq!(round_ratio(&IBig::from(-1), &big, 0), Rounded::OutOfRange("-8.00e-341".into()));
        assert_eq!(round_ratio(&IBig::ONE, &IBig::ONE, -1023), Rounded::OutOfRange("1.11e-308".into()));
    }
}
