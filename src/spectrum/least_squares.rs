//! # Purpose
//! Small nonlinear least squares: a handful of parameters, smooth residuals.
//!
//! # Method
//! Levenberg–Marquardt with a central-difference Jacobian and scaling by its columns.
//!
//! # References
//! J. J. Moré, Lecture Notes in Mathematics 630 (1978) 105–116.
//!
//! # Numerical aspects
//! Steps are relative; positive parameters are best given as logarithms.

use crate::{Error, Result};
use faer::Mat;
use faer::linalg::solvers::{DenseSolveCore, Solve};

/// The least-squares solution.
#[derive(Debug, Clone)]
pub struct LeastSquares {
    /// The parameters found.
    pub parameters: Vec<f64>,
    /// Sum of squares of the residuals there.
    pub sum_of_squares: f64,
    /// (JᵀJ)⁻¹; times the residual variance it is the covariance of the parameters.
    pub inverse_normal: Mat<f64>,
}

/// Minimises Σ rᵢ(p)² from `start`.
///
/// # Errors
/// `NotComputed` when the residuals at the start are not finite or the normal matrix stays
/// singular, so that the data do not determine the parameters.
pub fn least_squares(start: &[f64], residuals: impl Fn(&[f64]) -> Vec<f64>) -> Result<LeastSquares> {
    let (p, sum_of_squares) = least(start, &residuals)?;
    let (normal, _) = normal_equations(&jacobian(&p, &residuals), &residuals(&p));
    let inverse_normal = normal.partial_piv_lu().inverse();
    if !(0..p.len()).all(|i| inverse_normal[(i, i)].is_finite() && inverse_normal[(i, i)] >= 0.0) {
        return Err(Error::not_computed("the data do not determine the parameters"));
    }
    Ok(LeastSquares { parameters: p, sum_of_squares, inverse_normal })
}

/// The parameters of the least Σ rᵢ(p)² found from `start`, whether or not they are the only ones, and that sum.
///
/// # Errors
/// `NotComputed` when the residuals at the start are not finite.
pub fn least(start: &[f64], residuals: &impl Fn(&[f64]) -> Vec<f64>) -> Result<(Vec<f64>, f64)> {
    let cost = |r: &[f64]| r.iter().map(|v| v * v).sum::<f64>();
    let mut p = start.to_vec();
    let mut r = residuals(&p);
    let mut best = cost(&r);
    if !best.is_finite() {
        return Err(Error::not_computed("least squares starts from residuals that are not finite"));
    }
    let mut damping = 1e-3;
    for _ in 0..200 {
        let (normal, gradient) = normal_equations(&jacobian(&p, residuals), &r);
        let mut gained = 0.0;
        while damping < 1e12 {
            let trial = step(&p, &normal, &gradient, damping);
            let r_trial = residuals(&trial);
            let c = cost(&r_trial);
            if c.is_finite() && c < best {
                gained = best - c;
                (p, r, best) = (trial, r_trial, c);
                damping = (damping * 0.2).max(1e-14);
                break;
            }
            damping *= 4.0;
        }
        if gained <= 1e-13 * best {
            break;
        }
    }
    Ok((p, best))
}

fn jacobian(p: &[f64], residuals: &impl Fn(&[f64]) -> Vec<f64>) -> Vec<Vec<f64>> {
    (0..p.len())
        .map(|k| {
            let h = 6e-6 * p[k].abs().max(1e-3);
            let moved = |by: f64| {
                let mut q = p.to_vec();
                q[k] += by;
                residuals(&q)
            };
            moved(h).iter().zip(moved(-h)).map(|(a, b)| (a - b) / (2.0 * h)).collect()
        })
        .collect()
}

fn normal_equations(columns: &[Vec<f64>], r: &[f64]) -> (Mat<f64>, Vec<f64>) {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let normal = Mat::from_fn(columns.len(), columns.len(), |i, j| dot(&columns[i], &columns[j]));
    (normal, columns.iter().map(|c| dot(c, r)).collect())
}

/// p − (JᵀJ + λ diag JᵀJ)⁻¹ Jᵀr
fn step(p: &[f64], normal: &Mat<f64>, gradient: &[f64], damping: f64) -> Vec<f64> {
    let n = p.len();
    let damped = Mat::from_fn(n, n, |i, j| normal[(i, j)] * if i == j { 1.0 + damping } else { 1.0 });
    let right = Mat::from_fn(n, 1, |i, _| gradient[i]);
    let delta = damped.partial_piv_lu().solve(&right);
    p.iter().enumerate().map(|(i, v)| v - delta[(i, 0)]).collect()
}
