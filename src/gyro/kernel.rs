//! # Purpose
//! What products of fast signals give at each frequency of the noise behind them.
//!
//! # Method
//! With the answers a(jω), b(jω) of two signals to each of the noises, and Q(ω) the noises' spectral matrix, a product
//! has the mean (1/2π) ∫ Re aᵀQb* dω = (1/2π) ∫ tr KQ dω, K = ½(b*aᵀ + a*bᵀ). By Isserlis' theorem the density of the
//! product at ω = 0 is 2·(1/2π) ∫ tr (KQ)² dω: all that a slow compass feels of it. White noise of unit intensity has
//! Q = 1.
//!
//! # References
//! L. Isserlis, Biometrika 12 (1918) 134–139; S. O. Rice, Bell System Technical Journal 24 (1945) 46–156, sec. 4.

use super::LinearSignal;
use super::rectified::SlowFast;
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

impl SlowFast {
    /// K(ω) of the products that push each slow row, m × m for m noises.
    pub(super) fn kernels(&self, omega: f64) -> Vec<Mat<c64>> {
        let (n, m) = (self.fast.nrows(), self.noise.ncols());
        // all signals are c z + d w with z = (jω − A)⁻¹ B w
        let shifted =
            Mat::from_fn(n, n, |i, j| c64::new(-self.fast[(i, j)], if i == j { omega } else { 0.0 }));
        let z = shifted.partial_piv_lu().solve(&Mat::from_fn(n, m, |i, k| c64::new(self.noise[(i, k)], 0.0)));
        let of = |s: &LinearSignal, k: usize| -> c64 {
            (0..n).map(|i| z[(i, k)] * s.state[i]).sum::<c64>() + c64::new(s.noise[k], 0.0)
        };
        let mut rows = vec![Mat::zeros(m, m); self.slow.nrows()];
        for p in &self.products {
            let [a, b] = [&p.left, &p.right].map(|s| (0..m).map(|k| of(s, k)).collect::<Vec<c64>>());
            for l in 0..m {
                for k in 0..m {
                    let both = b[l].conj() * a[k] + a[l].conj() * b[k];
                    rows[p.row][(l, k)] += both * (0.5 * p.gain);
                }
            }
        }
        rows
    }

    /// What a steady push of one on each slow row does to slow state `row`.
    pub(super) fn resting_of(&self, row: usize) -> Vec<f64> {
        let k = self.slow.nrows();
        let unit = |at: usize| (0..k).map(|i| f64::from(u8::from(i == at))).collect::<Vec<_>>();
        (0..k).map(|at| self.resting(&unit(at))[row]).collect()
    }

    /// K(ω) of all that moves the mean of a slow state on which steady pushes act by `resting`.
    pub(super) fn kernel(&self, resting: &[f64], omega: f64) -> Mat<c64> {
        let m = self.noise.ncols();
        let rows = self.kernels(omega);
        Mat::from_fn(m, m, |l, k| rows.iter().zip(resting).map(|(r, w)| r[(l, k)] * *w).sum::<c64>())
    }

    /// The density, over ω > 0 (rad/s), of what the products add to the mean of slow state `row`: its
    /// integral from 0 to ∞ is that of [`SlowFast::rectified_mean`].
    pub fn mean_density(&self, row: usize, omega: f64) -> f64 {
        trace(&self.kernel(&self.resting_of(row), omega)) / std::f64::consts::PI
    }
}

/// The trace of a Hermitian matrix, or of a product of two.
pub(super) fn trace(m: &Mat<c64>) -> f64 {
    (0..m.nrows()).map(|i| m[(i, i)].re).sum()
}
