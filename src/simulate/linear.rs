//! Small dense linear systems over plain or dual numbers.

use crate::model::Scalar;

/// Solves A·x = b in place: each of the n rows holds n coefficients and the right side, which
/// becomes the solution. A singular system gives numbers that are not finite.
///
/// Gaussian elimination with row pivoting on the values.
pub(super) fn solve_table<T: Scalar>(table: &mut [T], n: usize) {
    let width = n + 1;
    for k in 0..n {
        let size = |row: &usize| table[row * width + k].value().abs();
        let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(k);
        for j in 0..width {
            table.swap(k * width + j, pivot * width + j);
        }
        for i in k + 1..n {
            let factor = table[i * width + k] / table[k * width + k];
            for j in k..width {
                table[i * width + j] = table[i * width + j] - factor * table[k * width + j];
            }
        }
    }
    for k in (0..n).rev() {
        let mut sum = table[k * width + n];
        for j in k + 1..n {
            sum = sum - table[k * width + j] * table[j * width + n];
        }
        table[k * width + n] = sum / table[k * width + k];
    }
}

/// A factorisation P·A = L·U, kept for several right sides.
pub(super) struct Factors<T> {
    n: usize,
    lu: Vec<T>,
    order: Vec<usize>,
    /// Whether the order is an odd one.
    is_odd: bool,
}

impl<T: Scalar> Factors<T> {
    /// Room for systems of n equations.
    pub fn new(n: usize) -> Self {
        Self { n, lu: vec![T::constant(0.0); n * n], order: (0..n).collect(), is_odd: false }
    }

    /// Factors a matrix given row by row.
    pub fn factor(&mut self, a: &[T]) {
        let n = self.n;
        self.lu.copy_from_slice(a);
        for (i, o) in self.order.iter_mut().enumerate() {
            *o = i;
        }
        self.is_odd = false;
        for k in 0..n {
            let size = |row: &usize| self.lu[row * n + k].value().abs();
            let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(k);
            self.order.swap(k, pivot);
            self.is_odd ^= pivot != k;
            for j in 0..n {
                self.lu.swap(k * n + j, pivot * n + j);
            }
            for i in k + 1..n {
                let factor = self.lu[i * n + k] / self.lu[k * n + k];
                self.lu[i * n + k] = factor;
                for j in k + 1..n {
                    self.lu[i * n + j] = self.lu[i * n + j] - factor * self.lu[k * n + j];
                }
            }
        }
    }

    /// Whether the determinant is below zero.
    pub fn is_negative(&self) -> bool {
        let below = (0..self.n).filter(|i| self.lu[i * (self.n + 1)].value() < 0.0).count();
        (below % 2 == 1) != self.is_odd
    }

    /// Solves for one right side.
    pub fn solve(&self, b: &[T], x: &mut [T]) {
        let n = self.n;
        for i in 0..n {
            let row = &self.lu[i * n..i * n + i];
            x[i] = row.iter().zip(&*x).fold(b[self.order[i]], |sum, (l, y)| sum - *l * *y);
        }
        for i in (0..n).rev() {
            let row = &self.lu[i * n + i + 1..(i + 1) * n];
            let sum = row.iter().zip(&x[i + 1..]).fold(x[i], |sum, (u, y)| sum - *u * *y);
            x[i] = sum / self.lu[i * n + i];
        }
    }
}
