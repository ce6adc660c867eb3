//! Where the roots of a real polynomial lie.

use crate::exact::IBig;

/// Where the roots of a real polynomial lie.
#[derive(Debug, Clone, PartialEq)]
pub enum Stability {
    /// All in the open left half plane; with the array of the test.
    Stable(Array),
    /// So many (with multiplicity) in the open right half plane.
    Unstable(usize),
    /// None in the right half plane, at least one on the imaginary axis.
    Axis,
}

/// The minors D_k\[i\] = Δ_(k−1)·r_k\[i\], k = 0 … n; a0 > 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Array {
    /// D_k, one row a k; row k has ⌊(n−k)/2⌋ + 1 entries.
    pub rows: Vec<Vec<IBig>>,
}
