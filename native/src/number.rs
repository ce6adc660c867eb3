//! Plain numbers and numbers with tangents, as lists of doubles.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number that lies in memory as doubles: its value, then its tangents.
///
/// # Safety
/// The type is `1 + TANGENTS` doubles without padding, any bits of which are a value of the type.
#[expect(unsafe_code, reason = "the layout is promised, not checked by the language")]
pub unsafe trait Number: Copy {
    /// How many tangents it carries.
    const TANGENTS: usize;
}

// SAFETY: one double and no tangents.
#[expect(unsafe_code, reason = "see above")]
unsafe impl Number for f64 {
    const TANGENTS: usize = 0;
}

// SAFETY: `repr(C)` puts the value first and the array after it; both have the alignment of a double, so that there is
// no padding, and doubles take any bits.
#[expect(unsafe_code, reason = "see above")]
unsafe impl<const N: usize> Number for Dual<N> {
    const TANGENTS: usize = N;
}

/// A value with N tangents: derivatives in N directions at once.
///
/// ```
/// use gyrospec_native::Dual;
/// let x = Dual::<2> { value: 3.0, tangents: [1.0, 0.0] };
/// let y = Dual::<2> { value: 2.0, tangents: [0.0, 1.0] };
/// assert_eq!(x * x * y, Dual { value: 18.0, tangents: [12.0, 9.0] });
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Dual<const N: usize> {
    /// The value.
    pub value: f64,
    /// Its derivative in each direction.
    pub tangents: [f64; N],
}

impl<const N: usize> Dual<N> {
    #[inline(always)]
    fn zip(self, other: Self, value: f64, by_self: f64, by_other: f64) -> Self {
        let mut tangents = self.tangents;
        for (a, b) in tangents.iter_mut().zip(&other.tangents) {
            *a = by_self * *a + by_other * b;
        }
        Self { value, tangents }
    }

    /// f(x) where f has this value and this slope at x.
    #[inline(always)]
    #[must_use]
    pub fn chain(self, value: f64, slope: f64) -> Self {
        // in place: an array's own map is a call for each entry where what is compiled apart is not joined
        let mut tangents = self.tangents;
        for t in &mut tangents {
            *t *= slope;
        }
        Self { value, tangents }
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
