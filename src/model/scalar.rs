//! Plain and dual numbers behind one trait, so that one code computes values and exact derivatives.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number that the compiled model can compute with.
pub trait Scalar:
    Copy
    + Send
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
{
    /// How many tangents it carries.
    const TANGENTS: usize;

    /// A constant.
    fn constant(value: f64) -> Self;

    /// A number with tangent 1 in one direction, none if the direction is beyond [`Self::TANGENTS`].
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
        let value = a.powf(b);
        // ∂xʸ/∂x = y·xʸ⁻¹, ∂xʸ/∂y = xʸ·ln x
        let by_x = if b == 0.0 { 0.0 } else { b * a.powf(b - 1.0) };
        let by_y = if value == 0.0 { 0.0 } else { value * a.ln() };
        let dy = y.chain(0.0, if by_y.is_finite() { by_y } else { 0.0 });
        self.chain(value, by_x) + dy
    }

    /// atan2(self, x)
    #[must_use]
    fn atan2(self, x: Self) -> Self {
        let (a, b) = (self.value(), x.value());
        let r2 = a * a + b * b;
        self.chain(a.atan2(b), b / r2) + x.chain(0.0, -a / r2)
    }
}

impl Scalar for f64 {
    const TANGENTS: usize = 0;

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

/// A value with N tangents: derivatives in N directions at once.
///
/// ```
/// use gyrospec::model::{Dual, Scalar};
/// let x = Dual::<2>::variable(3.0, 0);
/// let y = Dual::<2>::variable(2.0, 1);
/// let z = x * x * y;
/// assert_eq!((z.value(), z.tangent(0), z.tangent(1)), (18.0, 12.0, 9.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<const N: usize> {
    value: f64,
    tangents: [f64; N],
}

impl<const N: usize> Dual<N> {
    #[inline(always)]
    fn zip(self, other: Self, value: f64, by_self: f64, by_other: f64) -> Self {
        let mut tangents = self.tangents;
        for (a, b) in tangents.iter_mut().zip(other.tangents) {
            *a = by_self * *a + by_other * b;
        }
        Self { value, tangents }
    }
}

impl<const N: usize> Scalar for Dual<N> {
    const TANGENTS: usize = N;

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
        Self { value, tangents: self.tangents.map(|t| slope * t) }
    }

    #[inline(always)]
    fn scale(self, c: f64) -> Self {
        self.chain(c * self.value, c)
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, b: Self) -> Self {
        self.zip(b, self.value + b.value, 1.0, 1.0)
    }
}

impl<const N: usize> AddAssign for Dual<N> {
    #[inline(always)]
    fn add_assign(&mut self, b: Self) {
        *self = *self + b;
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, b: Self) -> Self {
        self.zip(b, self.value - b.value, 1.0, -1.0)
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        self.zip(b, self.value * b.value, b.value, self.value)
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, b: Self) -> Self {
        let quotient = self.value / b.value;
        self.zip(b, quotient, 1.0 / b.value, -quotient / b.value)
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}
