//! A least-squares problem kept as one small triangle.
//!
//! # Purpose
//! Reduce the rows [J | r] of a linear least-squares problem, min ‖J δ + r‖, to the triangle of their
//! orthogonal factorisation while they stream by: 10⁵ rows of 10 unknowns leave an 11 × 11 triangle.
//!
//! # Method
//! Householder factorisation of [R_old; new rows], a slab at a time.
//!
//! # References
//! G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. 2013, §5.2 and §6.5 (appending rows).
//!
//! # Numerical aspects
//! As accurate as a factorisation of the whole matrix; the normal equations JᵀJ, which lose half of
//! the digits, are never formed.

use faer::Mat;
use faer::linalg::solvers::SolveLstsq;

/// Rows that are gathered before the next factorisation.
const SLAB: usize = 512;

/// The triangle R of [J | r], filled a block of rows at a time.
///
/// ```
/// use gyrospec::estimate::Triangle;
/// // The line through (0, 1), (1, 3), (2, 5): r = −y at δ = 0.
/// let mut t = Triangle::new(2);
/// t.push(&[&[1.0, 1.0, 1.0], &[0.0, 1.0, 2.0]], &[-1.0, -3.0, -5.0]);
/// let line = t.solve(&[]);
/// assert!((line[0] - 1.0).abs() < 1e-12 && (line[1] - 2.0).abs() < 1e-12);
/// ```
#[derive(Debug, Clone)]
pub struct Triangle {
    unknowns: usize,
    rows: usize,
    r: Mat<f64>,
}

impl Triangle {
    /// An empty problem in so many unknowns.
    pub fn new(unknowns: usize) -> Self {
        Self { unknowns, rows: 0, r: Mat::zeros(unknowns + 1, unknowns + 1) }
    }

    /// Adds rows: one slice a column of J (each as long as `residual`), and the residuals.
    pub fn push(&mut self, columns: &[&[f64]], residual: &[f64]) {
        let p = self.unknowns;
        debug_assert_eq!(columns.len(), p);
        for from in (0..residual.len()).step_by(SLAB) {
            let count = SLAB.min(residual.len() - from);
            let stacked = Mat::from_fn(p + 1 + count, p + 1, |i, j| {
                if i <= p {
                    self.r[(i, j)]
                } else if j < p {
                    columns[j][from + i - p - 1]
                } else {
                    residual[from + i - p - 1]
                }
            });
            self.absorb(&stacked);
        }
        self.rows += residual.len();
    }

    /// Adds the rows of another triangle in the same unknowns.
    pub fn merge(&mut self, other: &Self) {
        let p = self.unknowns;
        let stacked =
            Mat::from_fn(
                2 * (p + 1),
                p + 1,
                |i, j| {
                    if i <= p { self.r[(i, j)] } else { other.r[(i - p - 1, j)] }
                },
            );
        self.absorb(&stacked);
        self.rows += other.rows;
    }

    fn absorb(&mut self, stacked: &Mat<f64>) {
        let factor = stacked.qr();
        let r = factor.thin_R();
        self.r =
            Mat::from_fn(self.unknowns + 1, self.unknowns + 1, |i, j| if i <= j { r[(i, j)] } else { 0.0 });
    }

    /// Multiplies column j of J by `scale[j]`: a change of the unknowns' units.
    #[must_use]
    pub fn scaled(mut self, scale: &[f64]) -> Self {
        for (j, s) in scale.iter().enumerate() {
            for i in 0..=j {
                self.r[(i, j)] *= s;
            }
        }
        self
    }

    /// The same problem in the unknowns listed alone, the others moved by `step`.
    #[must_use]
    pub fn restricted(&self, keep: &[usize], step: &[f64]) -> Self {
        let p = self.unknowns;
        let others: Vec<usize> = (0..p).filter(|j| !keep.contains(j)).collect();
        let moved = |i: usize| others.iter().map(|j| self.r[(i, *j)] * step[*j]).sum::<f64>();
        let chosen = Mat::from_fn(p + 1, keep.len() + 1, |i, j| {
            if j < keep.len() { self.r[(i, keep[j])] } else { self.r[(i, p)] + moved(i) }
        });
        let mut small = Self::new(keep.len());
        small.absorb(&chosen);
        small.rows = self.rows;
        small
    }

    /// How many unknowns there are.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// How many rows went in.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// The triangle of J alone, unknowns × unknowns.
    pub fn factor(&self) -> Mat<f64> {
        self.r.submatrix(0, 0, self.unknowns, self.unknowns).to_owned()
    }

    /// ‖r‖², the sum of squares at δ = 0.
    pub fn sum_of_squares(&self) -> f64 {
        (0..=self.unknowns).map(|i| self.r[(i, self.unknowns)].powi(2)).sum()
    }

    /// ‖J δ + r‖² at its minimum over all δ.
    pub fn least_sum(&self) -> f64 {
        self.r[(self.unknowns, self.unknowns)].powi(2)
    }

    /// ‖J_j‖ for every column.
    pub fn column_norms(&self) -> Vec<f64> {
        (0..self.unknowns).map(|j| (0..=j).map(|i| self.r[(i, j)].powi(2)).sum::<f64>().sqrt()).collect()
    }

    /// Jᵀ r, the gradient of ½‖r‖².
    pub fn gradient(&self) -> Vec<f64> {
        let p = self.unknowns;
        (0..p).map(|j| (0..=j).map(|i| self.r[(i, j)] * self.r[(i, p)]).sum()).collect()
    }

    /// ‖J δ + r‖² for a step δ, from the triangle alone.
    pub fn predicted(&self, step: &[f64]) -> f64 {
        let p = self.unknowns;
        (0..=p)
            .map(|i| {
                let row: f64 = (i..p).map(|j| self.r[(i, j)] * step[j]).sum();
                (row + self.r[(i, p)]).powi(2)
            })
            .sum()
    }

    /// The δ that minimises ‖J δ + r‖² + Σ (d_j δ_j)²; `damping` is empty for none.
    pub fn solve(&self, damping: &[f64]) -> Vec<f64> {
        let p = self.unknowns;
        if p == 0 {
            return Vec::new();
        }
        let below = damping.len();
        let a = Mat::from_fn(p + below, p, |i, j| match i.checked_sub(p) {
            None => self.r[(i, j)],
            Some(k) if k == j => damping[k],
            Some(_) => 0.0,
        });
        let b = Mat::from_fn(p + below, 1, |i, _| if i < p { -self.r[(i, p)] } else { 0.0 });
        let x = a.qr().solve_lstsq(&b);
        (0..p).map(|j| x[(j, 0)]).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(seed: u64, n: usize) -> Vec<f64> {
        (0..n).map(|i| ((i as f64 + 1.3) * (seed as f64 + 0.7)).sin()).collect()
    }

    #[test]
    fn streaming_equals_the_normal_equations() {
        let (a, b, r) = (column(1, 1300), column(2, 1300), column(3, 1300));
        let mut t = Triangle::new(2);
        t.push(&[&a[..700], &b[..700]], &r[..700]);
        t.push(&[&a[700..], &b[700..]], &r[700..]);
        let dot = |x: &[f64], y: &[f64]| x.iter().zip(y).map(|(p, q)| p * q).sum::<f64>();
        let (aa, ab, bb, ar, br) = (dot(&a, &a), dot(&a, &b), dot(&b, &b), dot(&a, &r), dot(&b, &r));
        let det = aa * bb - ab * ab;
        let exact = [-(bb * ar - ab * br) / det, -(aa * br - ab * ar) / det];
        let got = t.solve(&[]);
        assert!((got[0] - exact[0]).abs() < 1e-12 && (got[1] - exact[1]).abs() < 1e-12);
        let left: f64 = (0..1300).map(|i| (r[i] + got[0] * a[i] + got[1] * b[i]).powi(2)).sum();
        assert!((t.least_sum() - left).abs() < 1e-9 * left);
        assert!((t.predicted(&got) - left).abs() < 1e-9 * left);
        assert!((t.gradient()[1] - br).abs() < 1e-9);
    }

    #[test]
    fn a_restriction_is_the_smaller_problem() {
        let (a, b, r) = (column(1, 40), column(2, 40), column(3, 40));
        let mut both = Triangle::new(2);
        both.push(&[&a, &b], &r);
        let mut one = Triangle::new(1);
        one.push(&[&b], &r);
        assert!((both.restricted(&[1], &[0.0; 2]).solve(&[])[0] - one.solve(&[])[0]).abs() < 1e-12);
    }
}
