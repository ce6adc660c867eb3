//! Plain and dual numbers behind one trait, so that one code computes values and exact derivatives.

pub use gyrospec_native::Dual;
use gyrospec_native::Number;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number that the compiled model can compute with.
pub trait Scalar:
    Number
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
{
    /// A constant.
    fn constant(value: f64) -> Self;

    /// A number with tangent 1 in one direction, none if the direction is beyond [`TANGENTS`](gyrospec_native::Number::TANGENTS).
    fn variable(value: f64, direction: usize) -> Self;

    /// The value without tangents.
    fn value(self) -> f64;

    /// The tangent in one direction.
    fn tangent(self, direction: usize) -> f64;

    /// f(x) where f has this value and this slope at x.
    #[must_use]
    fn chain(self, value: f64, slope: f64) -> Self;

    /// c·x for a plain c.
    #[must_use]
    fn scale(self, c: f64) -> Self;

    /// xʸ
    #[must_use]
    fn power(self, y: Self) -> Self {
        let (a, b) = (self.value(), y.value());
        let (by_x, by_y) = power_slopes(a, b);
        self.chain(a.powf(b), by_x) + y.chain(0.0, by_y)
    }

    /// atan2(self, x)
    #[must_use]
    fn atan2(self, x: Self) -> Self {
        let (a, b) = (self.value(), x.value());
        let r2 = a * a + b * b;
        self.chain(a.atan2(b), b / r2) + x.chain(0.0, -a / r2)
    }
}

/// ∂xʸ/∂x = y·xʸ⁻¹ and ∂xʸ/∂y = xʸ·ln x, 0 where that is infinite.
#[inline]
pub(crate) fn power_slopes(x: f64, y: f64) -> (f64, f64) {
    let value = x.powf(y);
    let by_x = if y == 0.0 { 0.0 } else { y * x.powf(y - 1.0) };
    let by_y = if value == 0.0 { 0.0 } else { value * x.ln() };
    (by_x, if by_y.is_finite() { by_y } else { 0.0 })
}

impl Scalar for f64 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn variable(value: f64, _: usize) -> Self {
        value
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self
    }

    #[inline(always)]
    fn tangent(self, _: usize) -> f64 {
        0.0
    }

    #[inline(always)]
    fn chain(self, value: f64, _: f64) -> Self {
        value
    }

    #[inline(always)]
    fn scale(self, c: f64) -> Self {
        c * self
    }

    #[inline(always)]
    fn power(self, y: Self) -> Self {
        self.powf(y)
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        f64::atan2(self, x)
    }
}

impl<const N: usize> Scalar for Dual<N> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self { value, tangents: [0.0; N] }
    }

    #[inline(always)]
    fn variable(value: f64, direction: usize) -> Self {
        let mut out = Self::constant(value);
        if let Some(t) = out.tangents.get_mut(direction) {
            *t = 1.0;
        }
        out
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self.value
    }

    #[inline(always)]
    fn tangent(self, direction: usize) -> f64 {
        self.tangents.get(direction).copied().unwrap_or(0.0)
    }

    #[inline(always)]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self::chain(self, value, slope)
    }

    #[inline(always)]
    fn scale(self, c: f64) -> Self {
        self.chain(c * self.value, c)
    }
}
