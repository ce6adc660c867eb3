//! # Purpose
//! By how much an error on a motion of rational spectrum misses that on the spectrum which it stands for.
//!
//! # Method
//! The exact spectrum is told as the spectral matrix Q(ω) of the noises behind the motion, 1 where the rational one is
//! right. Mean and density at ω = 0 of the products follow by sums over ω, with Q and with 1.
//!
//! # Numerical aspects
//! With Q the sum is over the true spectrum and the answer of the ship, and knows nothing of how narrow a section of the
//! rational one may be; the mean by that is its exact integral. The compass is taken as far slower than the waves.

use super::kernel::trace;
use super::{Instrument, Motion};
use crate::Result;
use faer::Mat;
use num_complex::Complex64;
use std::f64::consts::PI;

/// The noises' spectral matrix at ω > 0.
#[derive(Debug, Clone)]
pub struct NoiseDensity {
    /// ω, rad/s.
    pub omega: f64,
    /// The width of its place in a sum over ω, rad/s.
    pub width: f64,
    /// Q, m × m, row by row.
    pub matrix: Vec<Vec<Complex64>>,
}

/// By how much a rational spectrum makes figures too large, as parts of those by the exact one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OffBy {
    /// Of the mean by the motion.
    pub mean: f64,
    /// Of the spread by the products.
    pub spread: f64,
    /// The heading, rad, that it is of.
    pub heading: f64,
    /// The mean by the motion, by the exact spectrum, rad.
    pub exact: f64,
}

impl OffBy {
    /// Part of the mean by which the rational spectrum is off from which on the sums are the figures to trust.
    pub const MUCH: f64 = 0.05;

    /// Whether the sums are the figures to trust.
    pub fn is_much(&self) -> bool {
        self.mean.abs() > Self::MUCH
    }
}

impl Instrument {
    /// What the noises' true spectral matrix changes of the error of a linear part; `None` for any other, and where
    /// there is no mean.
    ///
    /// # Errors
    /// As [`Instrument::error`].
    pub fn off_by(&self, motion: &Motion, heading: f64, noise: &[NoiseDensity]) -> Result<Option<OffBy>> {
        if !self.is_linear()? {
            return Ok(None);
        }
        let system = self.system(motion, heading)?;
        let (resting, mean) = (system.resting_of(0), system.rectified_mean()?[0]);
        let (mut exact, mut squares) = (0.0, [0.0; 2]);
        for n in noise {
            let k = system.kernel(&resting, n.omega);
            let q = Mat::from_fn(k.nrows(), k.ncols(), |i, j| n.matrix[i][j]);
            let kq = &k * &q;
            exact += trace(&kq) * n.width / PI;
            squares[0] += trace(&(&k * &k)) * n.width;
            squares[1] += trace(&(&kq * &kq)) * n.width;
        }
        let told = exact.abs() > 1e-12 && squares[1] > 0.0;
        let spread = (squares[0] / squares[1]).sqrt() - 1.0;
        Ok(told.then_some(OffBy { mean: mean / exact - 1.0, spread, heading, exact }))
    }
}
