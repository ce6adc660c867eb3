//! Whether a law that is fitted to some parts of a recording foretells the others.
//!
//! In a loop over a sensor the signals hold that sensor's own earlier noise, so that sums of them go with what is left more
//! than chi-squared says: five of 24 complete models of a room under a thermostat left "a law of two signals", none with a
//! second thermometer. On parts that a law has not seen this foretells nothing.
//!
//! # References
//! D. A. Dickey, W. A. Fuller, JASA 74 (1979) 427-431 (regression on one's own past sums).

use crate::diagnose::screen::Screen;
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef, Side};

/// Parts that are left out in turn.
const PARTS: usize = 5;
/// What the square of a direction of unit length is stiffened by: one that the other parts hardly show has little weight.
const STIFFENED: f64 = 0.1;

/// By how much the squares of whitened parts fall under weights of directions that were fitted to the others.
pub fn gain(screen: &Screen, directions: &[Vec<f64>]) -> f64 {
    let mut d = screen.free(directions);
    for mut column in d.col_iter_mut() {
        let size = column.norm_l2();
        if size > 0.0 {
            column /= faer::Scale(size);
        }
    }
    let e = Mat::from_fn(d.nrows(), 1, |i, _| screen.residual[i]);
    let normal = |d: MatRef<'_, f64>, e: MatRef<'_, f64>| (d.transpose() * d, d.transpose() * e);
    let (whole, seen) = normal(d.as_ref(), e.as_ref());
    let part = |k: usize| {
        let (first, end) = (k * d.nrows() / PARTS, (k + 1) * d.nrows() / PARTS);
        let rows = |m: &Mat<f64>| m.subrows(first, end - first).to_owned();
        let (own, of_own) = normal(rows(&d).as_ref(), rows(&e).as_ref());
        let mut others = &whole - &own;
        for j in 0..others.nrows() {
            others[(j, j)] += STIFFENED;
        }
        // ‖e‖² − ‖e − D w‖² = 2 wᵀDᵀe − wᵀDᵀD w
        let w = others.llt(Side::Lower).ok()?.solve(&seen - &of_own);
        Some(2.0 * (w.transpose() * &of_own)[(0, 0)] - (w.transpose() * &own * &w)[(0, 0)])
    };
    (0..PARTS).map(part).sum::<Option<f64>>().unwrap_or(0.0)
}
