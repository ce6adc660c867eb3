//! State space: ż = A z + B u, y = C z + D u.

use super::{Covariance, TransferFunction, stationary_covariance};
use crate::{Error, Result};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};
use num_complex::Complex64;

/// A linear system ż = A z + B u, y = C z + D u with n states, m inputs and k outputs.
///
/// ```
/// use gyrospec::lti::{StateSpace, TransferFunction};
/// // white noise of unit intensity through 1/(T s + 1): variance 1/(2T)
/// let lag = TransferFunction::new(&[1.0], &[0.5, 1.0]).unwrap();
/// let cov = StateSpace::from_transfer(&lag).covariance().unwrap();
/// assert!((cov[0][0] - 1.0).abs() < 1e-14);
/// ```
#[derive(Debug, Clone)]
pub struct StateSpace {
    /// n × n.
    #[doc(hidden)]
    pub a: Mat<f64>,
    /// n × m.
    #[doc(hidden)]
    pub b: Mat<f64>,
    /// k × n.
    #[doc(hidden)]
    pub c: Mat<f64>,
    /// k × m.
    #[doc(hidden)]
    pub d: Mat<f64>,
}

impl StateSpace {
    /// A system from the rows of A (n × n), B (n × m), C (k × n) and D (k × m).
    ///
    /// ```
    /// use gyrospec::StateSpace;
    /// // ẍ + 0.4 ẋ + 4 x = w: the variance of x is 1/(2·0.4·4)
    /// let rows = |m: &[&[f64]]| m.iter().map(|r| r.to_vec()).collect::<Vec<_>>();
    /// let (a, b) = (rows(&[&[0.0, 1.0], &[-4.0, -0.4]]), rows(&[&[0.0], &[1.0]]));
    /// let oscillator = StateSpace::from_rows(&a, &b, &rows(&[&[1.0, 0.0]]), &rows(&[&[0.0]]))?;
    /// assert!((oscillator.covariance()?[0][0] - 1.0 / 3.2).abs() < 1e-14);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// `BadInput` when the sizes do not agree or a number is not finite.
    pub fn from_rows(a: &[Vec<f64>], b: &[Vec<f64>], c: &[Vec<f64>], d: &[Vec<f64>]) -> Result<Self> {
        let [a, b, c, d] = [a, b, c, d].map(|rows| {
            let width = rows.first().map_or(0, Vec::len);
            match rows.iter().position(|row| row.len() != width) {
                None => Ok(Mat::from_fn(rows.len(), width, |i, j| rows[i][j])),
                Some(odd) => Err(Error::bad_input(format!(
                    "row {} of a matrix has {} numbers, its first {width}",
                    odd + 1,
                    rows[odd].len()
                ))),
            }
        });
        Self::new(a?, b?, c?, d?)
    }

    /// A system from its four matrices.
    ///
    /// # Errors
    /// `BadInput` when the sizes do not agree or a number is not finite.
    #[doc(hidden)]
    pub fn new(a: Mat<f64>, b: Mat<f64>, c: Mat<f64>, d: Mat<f64>) -> Result<Self> {
        let fits = a.nrows() == a.ncols()
            && b.nrows() == a.nrows()
            && c.ncols() == a.ncols()
            && d.nrows() == c.nrows()
            && d.ncols() == b.ncols();
        if !fits {
            let size = |m: &Mat<f64>| format!("{} × {}", m.nrows(), m.ncols());
            return Err(Error::bad_input(format!(
                "the matrices of a state space do not fit together: A is {}, B {}, C {}, D {}",
                size(&a),
                size(&b),
                size(&c),
                size(&d)
            ))
            .with_hint("of n states, m inputs and k outputs, A is n × n, B n × m, C k × n, D k × m"));
        }
        let finite = |m: &Mat<f64>| m.col_iter().all(|col| col.iter().all(|v| v.is_finite()));
        if ![&a, &b, &c, &d].into_iter().all(finite) {
            return Err(Error::bad_input("a matrix of a state space holds a number that is not finite"));
        }
        Ok(Self { a, b, c, d })
    }

    /// The companion realisation of a transfer function, one input and one output:
    /// A = ⎡0 1 … 0; … ; −aₙ … −a₁⎤/a₀, the lowest derivative first.
    pub fn from_transfer(w: &TransferFunction) -> Self {
        let n = w.order();
        let (h, lead) = (w.denominator(), w.denominator()[0]);
        let mut c = vec![0.0; n + 1 - w.numerator().len()];
        c.extend_from_slice(w.numerator());
        let through = c[0] / lead;
        Self {
            a: Mat::from_fn(n, n, |i, j| {
                if i + 1 == n { -h[n - j] / lead } else { f64::from(u8::from(j == i + 1)) }
            }),
            b: Mat::from_fn(n, 1, |i, _| if i + 1 == n { 1.0 / lead } else { 0.0 }),
            c: Mat::from_fn(1, n, |_, j| c[n - j] - through * h[n - j]),
            d: Mat::from_fn(1, 1, |_, _| through),
        }
    }

    /// Number of states.
    pub fn order(&self) -> usize {
        self.a.nrows()
    }

    /// Number of inputs.
    pub fn inputs(&self) -> usize {
        self.b.ncols()
    }

    /// Number of outputs.
    pub fn outputs(&self) -> usize {
        self.c.nrows()
    }

    /// This system's outputs drive the next system; the outputs are the next one's.
    ///
    /// # Errors
    /// `BadInput` when the numbers of signals differ.
    pub fn then(&self, next: &Self) -> Result<Self> {
        if self.outputs() != next.inputs() {
            let (given, taken) = (self.outputs(), next.inputs());
            return Err(Error::bad_input(format!("{given} outputs cannot drive {taken} inputs")));
        }
        let (n, m) = (self.order(), next.order());
        let (bc, bd) = (&next.b * &self.c, &next.b * &self.d);
        let dc = &next.d * &self.c;
        let a = Mat::from_fn(n + m, n + m, |i, j| match (i < n, j < n) {
            (true, true) => self.a[(i, j)],
            (true, false) => 0.0,
            (false, true) => bc[(i - n, j)],
            (false, false) => next.a[(i - n, j - n)],
        });
        let b =
            Mat::from_fn(n + m, self.inputs(), |i, j| if i < n { self.b[(i, j)] } else { bd[(i - n, j)] });
        let c =
            Mat::from_fn(next.outputs(), n + m, |i, j| if j < n { dc[(i, j)] } else { next.c[(i, j - n)] });
        Self::new(a, b, c, &next.d * &self.d)
    }

    /// W(s) = C (sI − A)⁻¹ B + D, k × m, at a complex frequency that is no pole.
    #[doc(hidden)]
    pub fn at(&self, s: Complex64) -> Mat<c64> {
        let n = self.order();
        let lift = |m: &Mat<f64>| Mat::from_fn(m.nrows(), m.ncols(), |i, j| c64::new(m[(i, j)], 0.0));
        let shifted = Mat::from_fn(n, n, |i, j| {
            let diagonal = if i == j { s } else { Complex64::ZERO };
            c64::new(diagonal.re - self.a[(i, j)], diagonal.im)
        });
        let inner = shifted.partial_piv_lu().solve(&lift(&self.b));
        lift(&self.c) * inner + lift(&self.d)
    }

    /// The stationary covariance of the outputs when the inputs are independent white noises of unit intensity, row
    /// by row.
    ///
    /// # Errors
    /// `OutOfRange` when an output holds white noise (D ≠ 0): its variance is infinite; `Unstable` and
    /// `ImaginaryAxis` where the states have none; `NotComputed` where rounding leaves less than six digits.
    pub fn covariance(&self) -> Result<Vec<Vec<f64>>> {
        let covariance = self.output_covariance()?;
        Ok(covariance.row_iter().map(|row| row.iter().copied().collect()).collect())
    }

    /// The stationary covariance of the states when the inputs are independent white noises
    /// of unit intensity: A X + X Aᵀ + B Bᵀ = 0.
    ///
    /// # Errors
    /// As [`stationary_covariance`].
    #[doc(hidden)]
    pub fn state_covariance(&self) -> Result<Covariance> {
        stationary_covariance(&self.a, &(&self.b * self.b.transpose()))
    }

    /// The stationary covariance of the outputs, C X Cᵀ.
    ///
    /// # Errors
    /// `OutOfRange` when an output holds white noise (D ≠ 0): its variance is infinite;
    /// else as [`stationary_covariance`].
    #[doc(hidden)]
    pub fn output_covariance(&self) -> Result<Mat<f64>> {
        if self.d.col_iter().any(|col| col.iter().any(|v| *v != 0.0)) {
            return Err(Error::new(
                crate::ErrorKind::OutOfRange,
                "an output holds white noise, so its variance is infinite",
            )
            .with_hint("limit the band of the input, or filter the output"));
        }
        let x = self.state_covariance()?.matrix;
        Ok(&self.c * &x * self.c.transpose())
    }
}
