//! # Purpose
//! The distribution of the heading's error about its mean: products of Gaussian motions are not Gaussian.
//!
//! # Method
//! A compass far slower than the motion adds up what the products push: α = Σ_r ∫ b_r(τ) q_r(t − τ) dτ, b_r the answer
//! of α to an impulse on row r. With the kernels K_r(ω) of the products ([`SlowFast::kernels`]) and
//! K(t, ω) = Σ_r b_r(t) K_r(ω) the cumulants of this quadratic form are
//!
//! κ_n = 2ⁿ⁻¹ (n − 1)! ∫₀^∞ dt (1/2π) ∫ tr K(t, ω)ⁿ dω,
//!
//! the mean and the variance among them. The swing is Gaussian and adds to the variance alone: it goes with the waves,
//! and the compass answers a product only far later. Percentiles follow from mean, deviation, skewness γ₁ and excess γ₂
//! by the expansion about the normal z,
//!
//! z + γ₁(z² − 1)/6 + γ₂(z³ − 3z)/24 − γ₁²(2z³ − 5z)/36.
//!
//! # References
//! M. Kac, A. J. F. Siegert, J. Appl. Phys. 18 (1947) 383–397, for quadratic forms of Gaussian noise behind a filter;
//! E. A. Cornish, R. A. Fisher, Revue de l'Institut International de Statistique 5 (1938) 307–320.
//!
//! # Numerical aspects
//! The integral over ω is Simpson's on points that crowd about each pole. Nothing is told where κ₂ so found is off the
//! exact variance by more than [`SLOW`], so that the compass is not slow beside the motion, or where the skewness is
//! beyond the expansion.

use super::kernel::trace;
use super::rectified::SlowFast;
use super::{HeadingError, Instrument, Motion};
use crate::Result;
use crate::lti::poles;
use faer::{Mat, c64};
use std::f64::consts::{FRAC_PI_2, PI};

/// Part by which κ₂ may be off the exact variance.
const SLOW: f64 = 0.03;
/// Skewness up to which the expansion is taken.
const MOST_SKEWED: f64 = 1.0;
/// Points about each pole on either side, and those over all frequencies.
const ABOUT: usize = 16;
const OVER_ALL: usize = 100;

/// How far the error's distribution is from a Gaussian one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shape {
    /// γ₁ = κ₃/σ³.
    pub skewness: f64,
    /// γ₂ = κ₄/σ⁴.
    pub excess: f64,
}

impl Shape {
    /// Parts of the time whose percentiles are told, with their standard normal deviates.
    pub const TOLD: [(f64, f64); 4] =
        [(0.05, -1.644_853_627), (0.50, 0.0), (0.95, 1.644_853_627), (0.99, 2.326_347_874)];

    /// By how many deviations the percentile at the normal deviate `z` lies above the mean.
    ///
    /// ```
    /// use gyrospec::gyro::Shape;
    /// // (χ² of 200 degrees − 200)/20: its 95th percentile is 233.99
    /// let shape = Shape { skewness: 0.2, excess: 0.06 };
    /// assert!((200.0 + 20.0 * shape.deviates(1.644_853_627) - 233.99).abs() < 0.01);
    /// ```
    pub fn deviates(&self, z: f64) -> f64 {
        let (skew, excess) = (self.skewness, self.excess);
        z + skew * (z * z - 1.0) / 6.0 + excess * (z * z * z - 3.0 * z) / 24.0
            - skew * skew * (2.0 * z * z * z - 5.0 * z) / 36.0
    }

    /// The percentiles of [`Shape::TOLD`], rad.
    pub fn percentiles(&self, error: &HeadingError) -> [f64; 4] {
        Self::TOLD.map(|(_, z)| error.mean() + error.deviation * self.deviates(z))
    }
}

impl Instrument {
    /// The shape of the distribution of `error`, which is that of a linear part on `motion`; `None` where the theory
    /// of a slow compass does not give it.
    ///
    /// # Errors
    /// As [`Instrument::error`].
    pub fn shape(&self, motion: &Motion, heading: f64, error: &HeadingError) -> Result<Option<Shape>> {
        if !self.is_linear()? || error.deviation <= 0.0 {
            return Ok(None);
        }
        let [second, third, fourth] = self.system(motion, heading)?.cumulants(0)?;
        let own = error.deviation_quadratic.powi(2);
        if (second - own).abs() > SLOW * own {
            return Ok(None);
        }
        let skewness = third / error.deviation.powi(3);
        let excess = fourth / error.deviation.powi(4);
        Ok((skewness.abs() <= MOST_SKEWED).then_some(Shape { skewness, excess }))
    }
}

impl SlowFast {
    /// κ₂, κ₃ and κ₄ of what the products add to a slow state.
    fn cumulants(&self, row: usize) -> Result<[f64; 3]> {
        let pushed: Vec<usize> =
            (0..self.slow.nrows()).filter(|r| self.products.iter().any(|p| p.row == *r)).collect();
        let answers = self.impulses(row, &pushed)?;
        let mut sums = [0.0; 3];
        // each heading's rows answer alike at most times: sum over t of b_r b_s … first
        let weights = Weights::of(&answers);
        for (omega, width) in self.frequencies()? {
            let all = self.kernels(omega);
            let kernels: Vec<&Mat<c64>> = pushed.iter().map(|r| &all[*r]).collect();
            let traced = weights.traces(&kernels);
            (0..3).for_each(|i| sums[i] += width * traced[i]);
        }
        // 2ⁿ⁻¹ (n − 1)!/π
        Ok([2.0 * sums[0] / PI, 8.0 * sums[1] / PI, 48.0 * sums[2] / PI])
    }

    /// The answers of slow state `row` to impulses on others, with the step of time.
    fn impulses(&self, row: usize, pushed: &[usize]) -> Result<(f64, Vec<Vec<f64>>)> {
        let poles = poles(&self.slow, "compass")?;
        let fastest = poles.iter().map(|p| p.re.hypot(p.im)).fold(0.0, f64::max);
        let slowest = poles.iter().map(|p| -p.re).fold(f64::INFINITY, f64::min);
        let step = 0.02 / fastest;
        let count = (12.0 / slowest / step).ceil().clamp(1.0, 2e5) as usize;
        let n = self.slow.nrows();
        let none = Mat::zeros(n, 1);
        let moves = crate::lti::Discrete::new(&self.slow, &none, step).transition();
        let mut answers = vec![Vec::with_capacity(count); pushed.len()];
        let mut state = Mat::from_fn(n, n, |i, j| f64::from(u8::from(i == j)));
        for _ in 0..count {
            for (answer, push) in answers.iter_mut().zip(pushed) {
                answer.push(state[(row, *push)]);
            }
            state = &moves * &state;
        }
        Ok((step, answers))
    }

    /// Frequencies and widths of Simpson's rule on points about the poles.
    fn frequencies(&self) -> Result<Vec<(f64, f64)>> {
        let poles = poles(&self.fast, "motion")?;
        let sizes = || poles.iter().map(|p| p.re.hypot(p.im)).filter(|s| *s > 0.0);
        let (low, high) = (sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max));
        let (first, last) = ((0.01 * low).ln(), (100.0 * high).ln());
        let mut points: Vec<f64> =
            (0..=OVER_ALL).map(|k| (first + (last - first) * k as f64 / OVER_ALL as f64).exp()).collect();
        for p in poles.iter().filter(|p| p.im >= 0.0) {
            for k in 0..2 * ABOUT {
                let away = ((k as f64 + 0.5) / (2 * ABOUT) as f64 - 0.5) * 2.0 * FRAC_PI_2;
                points.push(p.im + p.re.abs() * away.tan());
            }
        }
        points.retain(|w| *w > 0.0 && *w <= last.exp());
        points.push(0.0);
        points.sort_by(f64::total_cmp);
        let mut all: Vec<(f64, f64)> = Vec::new();
        for ends in points.windows(2).filter(|e| e[1] > e[0]) {
            let (a, h) = (ends[0], ends[1] - ends[0]);
            for (at, part) in [(a, 1.0), (a + 0.5 * h, 4.0), (ends[1], 1.0)] {
                match all.last_mut() {
                    Some(end) if end.0 == at => end.1 += part * h / 6.0,
                    _ => all.push((at, part * h / 6.0)),
                }
            }
        }
        Ok(all)
    }
}

/// ∫ b_r b_s dt, ∫ b_r b_s b_u dt and ∫ b_r b_s b_u b_v dt, the indices in the order of counting.
struct Weights {
    rows: usize,
    of: [Vec<f64>; 3],
}

impl Weights {
    fn of((step, answers): &(f64, Vec<Vec<f64>>)) -> Self {
        let rows = answers.len();
        let of = [2, 3, 4].map(|n: u32| {
            let mean = |at: usize| {
                let product = |t: usize| digits(at, rows, n).map(|r| answers[r][t]).product::<f64>();
                let count = answers.first().map_or(0, Vec::len);
                // trapezoids: the answer ends at nothing
                step * ((0..count).map(product).sum::<f64>() - 0.5 * product(0))
            };
            (0..rows.pow(n)).map(mean).collect()
        });
        Self { rows, of }
    }

    /// Σ of the weights with tr K_r K_s, tr K_r K_s K_u, tr K_r K_s K_u K_v.
    fn traces(&self, kernels: &[&Mat<c64>]) -> [f64; 3] {
        let squares: Vec<Mat<c64>> =
            (0..self.rows.pow(2)).map(|at| kernels[at / self.rows] * kernels[at % self.rows]).collect();
        let mut sums = [0.0; 3];
        for (at, square) in squares.iter().enumerate() {
            sums[0] += self.of[0][at] * trace(square);
            for (r, k) in kernels.iter().enumerate() {
                sums[1] += self.of[1][at * self.rows + r] * trace(&(square * *k));
            }
            for (other, k) in squares.iter().enumerate() {
                sums[2] += self.of[2][at * squares.len() + other] * trace(&(square * k));
            }
        }
        sums
    }
}

/// The `n` digits of a number to the base `rows`, the highest first.
fn digits(at: usize, rows: usize, n: u32) -> impl Iterator<Item = usize> {
    (0..n).rev().map(move |power| at / rows.pow(power) % rows)
}

#[cfg(test)]
mod tests {
    use super::super::LinearSignal;
    use super::super::rectified::ProductPush;
    use super::*;

    #[test]
    fn cumulants_of_a_square_behind_a_slow_lag() {
        // ż = −μz + √(2Aμ) w, ẏ = −ay + z²; with S = 2Aμ/(ω² + μ²) and b = e^{−at}:
        // κ₂ = A²/(aμ), κ₃ = 4A³/(aμ²), κ₄ = 30A⁴/(aμ³)
        let (variance, mu, a) = (0.7, 0.3, 1e-3);
        let z = LinearSignal { state: vec![1.0], noise: vec![0.0] };
        let system = SlowFast {
            fast: Mat::from_fn(1, 1, |_, _| -mu),
            noise: Mat::from_fn(1, 1, |_, _| (2.0 * variance * mu).sqrt()),
            slow: Mat::from_fn(1, 1, |_, _| -a),
            constant: vec![0.0],
            linear: Vec::new(),
            products: vec![ProductPush { row: 0, gain: 1.0, left: z.clone(), right: z }],
        };
        let got = system.cumulants(0).unwrap();
        let wanted = [
            variance.powi(2) / (a * mu),
            4.0 * variance.powi(3) / (a * mu * mu),
            30.0 * variance.powi(4) / (a * mu.powi(3)),
        ];
        for (g, w) in got.iter().zip(wanted) {
            assert!((g / w - 1.0).abs() < 1e-3, "{got:?} {wanted:?}");
        }
    }
}
