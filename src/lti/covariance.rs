//! # Purpose
//! The stationary covariance X of ż = A z + noise of intensity Q: A X + X Aᵀ + Q = 0.
//!
//! # Method
//! Newton's iteration for the matrix sign function, with determinantal scaling, on A and Q
//! together; then refinement on the residual while it still gains. Both are done twice: first in the
//! balanced coordinates of A, then in coordinates where each variance is one, so that small
//! variances beside large ones keep their digits.
//!
//! # References
//! J. D. Roberts, Int. J. Control 32 (1980) 677–687; P. Benner, E. S. Quintana-Ortí,
//! Numer. Algorithms 20 (1999) 75–100.
//!
//! # Numerical aspects
//! Residuals are summed in twice the working precision (T. Ogita, S. M. Rump, S. Oishi, SIAM J.
//! Sci. Comput. 26 (2005) 1955–1988), since slow states beside fast ones magnify their rounding.
//! The size of the last refinement step is the estimate of the relative error; above 1e−6 the
//! answer is refused. A matrix with an eigenvalue to the right converges to a sign matrix
//! whose trace is not −n, and is refused as unstable; one on the axis does not converge.

use crate::{Error, ErrorKind, Result};
use faer::Mat;
use faer::linalg::solvers::DenseSolveCore;

const STEPS: usize = 80;
const REFUSED_ABOVE: f64 = 1e-6;
const REFINEMENTS: usize = 30;

/// A stationary covariance with the estimate of its error.
#[derive(Debug, Clone)]
pub struct Covariance {
    /// n × n, symmetric.
    pub matrix: Mat<f64>,
    /// Largest error estimated, relative to √(Xᵢᵢ Xⱼⱼ).
    pub relative_error: f64,
}

/// Solves A X + X Aᵀ + Q = 0 for a stable A (n × n) and symmetric Q.
///
/// ```
/// use faer::mat;
/// let a = mat![[0.0, 1.0], [-4.0, -0.4]];                       // ω₀ = 2, 2ζω₀ = 0.4
/// let q = mat![[0.0, 0.0], [0.0, 1.0]];
/// let x = gyrospec::lti::stationary_covariance(&a, &q).unwrap().matrix;
/// assert!((x[(1, 1)] - 1.0 / 0.8).abs() < 1e-13);               // 1/(2·2ζω₀)
/// ```
///
/// # Errors
/// `BadInput` for sizes that differ or numbers that are not finite, `Unstable`,
/// `ImaginaryAxis`, `NotComputed` when the error estimate exceeds 1e−6.
pub fn stationary_covariance(a: &Mat<f64>, q: &Mat<f64>) -> Result<Covariance> {
    let n = a.nrows();
    if a.ncols() != n || q.nrows() != n || q.ncols() != n {
        return Err(Error::bad_input("A and Q of a covariance must be square and of one size"));
    }
    if !finite(a) || !finite(q) {
        return Err(Error::bad_input("A or Q of a covariance holds a number that is not finite"));
    }
    if n == 0 {
        return Ok(Covariance { matrix: Mat::zeros(0, 0), relative_error: 0.0 });
    }
    let first = refined(a, q, &balancing(a))?.0;
    let scale: Vec<f64> = (0..n).map(|i| power_of_two(first[(i, i)].max(0.0).sqrt())).collect();
    let (matrix, relative_error) = refined(a, q, &scale)?;
    if relative_error.is_nan() || relative_error > REFUSED_ABOVE {
        return Err(Error::not_computed(format!(
            "the covariance is too badly conditioned for doubles (relative error about {relative_error:.1e})"
        )));
    }
    Ok(Covariance { matrix, relative_error })
}

fn finite(m: &Mat<f64>) -> bool {
    m.col_iter().all(|col| col.iter().all(|v| v.is_finite()))
}

fn power_of_two(x: f64) -> f64 {
    if x.is_normal() { x.abs().log2().round().clamp(-500.0, 500.0).exp2() } else { 1.0 }
}

/// Powers of two d such that rows and columns of D⁻¹ A D are of one size (Osborne).
fn balancing(a: &Mat<f64>) -> Vec<f64> {
    let n = a.nrows();
    let mut d = vec![1.0_f64; n];
    for _ in 0..20 {
        for i in 0..n {
            let others = (0..n).filter(|j| *j != i);
            let column: f64 = others.clone().map(|j| (a[(j, i)] * d[i] / d[j]).abs()).sum();
            let row: f64 = others.map(|j| (a[(i, j)] * d[j] / d[i]).abs()).sum();
            if column > 0.0 && row > 0.0 {
                d[i] *= power_of_two((row / column).sqrt());
            }
        }
    }
    d
}

/// Solves in the coordinates z = D ẑ, refines, and returns X with the error estimate.
fn refined(a: &Mat<f64>, q: &Mat<f64>, d: &[f64]) -> Result<(Mat<f64>, f64)> {
    let n = a.nrows();
    let ad = Mat::from_fn(n, n, |i, j| a[(i, j)] * d[j] / d[i]);
    let qd = Mat::from_fn(n, n, |i, j| q[(i, j)] / (d[i] * d[j]));
    let mut x = sign_iteration(&ad, &qd)?;
    let mut worst = f64::INFINITY;
    for _ in 0..REFINEMENTS {
        // R = A X + X Aᵀ + Q;  A ΔX + ΔX Aᵀ + R = 0
        let residual = residual(&ad, &x, &qd);
        let step = sign_iteration(&ad, &residual)?;
        let size = relative_size(&step, &x);
        if size >= worst {
            break;
        }
        x += &step;
        worst = size;
        if worst < 1e-14 {
            break;
        }
    }
    Ok((Mat::from_fn(n, n, |i, j| x[(i, j)] * d[i] * d[j]), worst))
}

/// A X + X Aᵀ + Q in twice the working precision, rounded at the end.
fn residual(a: &Mat<f64>, x: &Mat<f64>, q: &Mat<f64>) -> Mat<f64> {
    let n = a.nrows();
    Mat::from_fn(n, n, |i, j| {
        let (mut sum, mut rest) = (q[(i, j)], 0.0);
        for k in 0..n {
            for (f, g) in [(a[(i, k)], x[(k, j)]), (a[(j, k)], x[(k, i)])] {
                let product = f * g;
                // the rounding errors of the product and of the sum, exactly
                let of_product = f.mul_add(g, -product);
                let next = sum + product;
                let part = next - sum;
                rest += (sum - (next - part)) + (product - part) + of_product;
                sum = next;
            }
        }
        sum + rest
    })
}

/// The largest |ΔXᵢⱼ|/√(Xᵢᵢ Xⱼⱼ).
fn relative_size(step: &Mat<f64>, x: &Mat<f64>) -> f64 {
    let mut worst = 0.0_f64;
    for i in 0..x.nrows() {
        for j in 0..x.nrows() {
            let size = (x[(i, i)].abs() * x[(j, j)].abs()).sqrt();
            if size > f64::MIN_POSITIVE {
                worst = worst.max((step[(i, j)] / size).abs());
            }
        }
    }
    worst
}

/// Aₖ₊₁ = ½(cAₖ + (cAₖ)⁻¹),  Qₖ₊₁ = ½(cQₖ + Aₖ⁻¹QₖAₖ⁻ᵀ/c);  A → −I,  Q → 2X.
fn sign_iteration(a: &Mat<f64>, q: &Mat<f64>) -> Result<Mat<f64>> {
    let n = a.nrows();
    let (mut a, mut q) = (a.clone(), q.clone());
    for _ in 0..STEPS {
        let inverse = a.partial_piv_lu().inverse();
        if !finite(&inverse) {
            return Err(on_axis());
        }
        // c = √(‖A⁻¹‖/‖A‖), one near the end
        let c = (inverse.norm_l2() / a.norm_l2()).sqrt();
        let c = if (c - 1.0).abs() < 0.05 { 1.0 } else { c };
        let folded = &inverse * &q * inverse.transpose();
        q = Mat::from_fn(n, n, |i, j| {
            let (p, f) = (q[(i, j)] + q[(j, i)], folded[(i, j)] + folded[(j, i)]);
            0.25 * (c * p + f / c)
        });
        let next = Mat::from_fn(n, n, |i, j| 0.5 * (c * a[(i, j)] + inverse[(i, j)] / c));
        let moved = (&next - &a).norm_l2();
        a = next;
        if moved <= 1e-14 * (n as f64) * a.norm_l2() {
            return settled(&a, &q);
        }
        if moved < 1e-7 * a.norm_l2() && off_identity(&a) < 1e-9 {
            return Ok(Mat::from_fn(n, n, |i, j| 0.5 * q[(i, j)]));
        }
    }
    Err(on_axis())
}

fn off_identity(a: &Mat<f64>) -> f64 {
    let n = a.nrows();
    Mat::from_fn(n, n, |i, j| a[(i, j)] + f64::from(u8::from(i == j))).norm_l2()
}

fn settled(a: &Mat<f64>, q: &Mat<f64>) -> Result<Mat<f64>> {
    let n = a.nrows();
    let trace: f64 = (0..n).map(|i| a[(i, i)]).sum();
    let right = f64::midpoint(trace, n as f64).round();
    if right > 0.0 {
        return Err(Error::new(
            ErrorKind::Unstable,
            format!("the system is unstable: {right} eigenvalues of A lie to the right"),
        ));
    }
    if off_identity(a) > 1e-6 {
        return Err(Error::not_computed("the covariance iteration lost its accuracy"));
    }
    Ok(q * faer::Scale(0.5))
}

fn on_axis() -> Error {
    Error::new(ErrorKind::ImaginaryAxis, "A has an eigenvalue on the imaginary axis, or too near to tell")
}
