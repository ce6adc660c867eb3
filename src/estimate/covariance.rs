//! How surely the unknowns are known.
//!
//! # Purpose
//! The covariance of a least-squares estimate whose residuals are coloured.
//!
//! # Method
//! With sensitivities S, weights w and noise of covariance V = L Lᵀ the estimate that minimises
//! Σ w e² has the covariance A⁻¹ B A⁻¹, A = Sᵀ w S, B = ‖Lᵀ w S‖²: the sandwich with the noise model
//! for its filling. For white noise it is σ² (SᵀS)⁻¹.
//!
//! # References
//! A. R. Gallant, Nonlinear Statistical Models, 1987, ch. 2; H. White, Asymptotic Theory for
//! Econometricians, 2001, ch. 6.
//!
//! # Numerical aspects
//! A and B are kept as triangles; the interval's quantile is Student's with the number of samples
//! that are worth an independent one.

use super::noise::NoiseModel;
use super::triangle::Triangle;
use faer::Mat;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// One contiguous stretch of one output: its weight, its noise, its sensitivities.
#[derive(Debug, Clone)]
pub struct Stretch<'a> {
    /// Weight of its squared residuals.
    pub weight: f64,
    /// The noise of its output.
    pub noise: &'a NoiseModel,
    /// ∂prediction/∂unknown: one slice an unknown.
    pub columns: Vec<&'a [f64]>,
}

/// The covariance of the unknowns, unknowns × unknowns; None where the data do not see them all.
pub fn coloured_covariance(unknowns: usize, stretches: &[Stretch<'_>]) -> Option<Mat<f64>> {
    let mut bread = Triangle::new(unknowns);
    let mut filling = Triangle::new(unknowns);
    for s in stretches {
        let root = s.weight.sqrt();
        let weighted = |f: f64| -> Vec<Vec<f64>> {
            s.columns.iter().map(|c| c.iter().map(|v| f * v).collect()).collect()
        };
        push(&mut bread, &weighted(root));
        let spread: Vec<Vec<f64>> = weighted(s.weight).iter().map(|c| s.noise.spread(c)).collect();
        push(&mut filling, &spread);
    }
    let inverse = inverse_square(&bread)?;
    let half = filling.factor() * &inverse;
    Some(half.transpose() * &half)
}

fn push(triangle: &mut Triangle, columns: &[Vec<f64>]) {
    let rows = columns.first().map_or(0, Vec::len);
    let views: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    triangle.push(&views, &vec![0.0; rows]);
}

/// (RᵀR)⁻¹ of a triangle, with columns scaled to one; None if it is singular to rounding.
pub fn inverse_square(triangle: &Triangle) -> Option<Mat<f64>> {
    let p = triangle.unknowns();
    let norms = triangle.column_norms();
    if norms.iter().any(|n| !(*n > 0.0 && n.is_finite())) {
        return None;
    }
    let scale: Vec<f64> = norms.iter().map(|n| 1.0 / n).collect();
    let factor = triangle.clone().scaled(&scale).factor();
    if (0..p).any(|i| factor[(i, i)].abs() < 1e-12) {
        return None;
    }
    let mut root = Mat::<f64>::identity(p, p);
    factor.as_ref().solve_upper_triangular_in_place(root.as_mut());
    let inverse = &root * root.transpose();
    Some(Mat::from_fn(p, p, |i, j| inverse[(i, j)] * scale[i] * scale[j]))
}

/// Half the width of a 95 % interval, in standard deviations, for so many independent samples left.
///
/// ```
/// use gyrospec::estimate::half_width;
/// assert!((half_width(1e6) - 1.96).abs() < 1e-3 && half_width(4.0) > 2.7);
/// ```
pub fn half_width(degrees: f64) -> f64 {
    let degrees = degrees.clamp(2.0, 1e7);
    StudentsT::new(0.0, 1.0, degrees).map_or(1.96, |t| t.inverse_cdf(0.975))
}

/// Samples of one output that are worth an independent one: N σ²/S(0) for its noise.
pub fn independent_samples(noise: &NoiseModel, samples: usize) -> f64 {
    let ar = &noise.autoregression;
    let inflation = (ar.density(0.0) / ar.variance()).max(1.0);
    samples as f64 / noise.decimation as f64 / inflation
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::noise::Autoregression;
    use rand::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    #[test]
    fn white_noise_gives_the_textbook_covariance() {
        let t: Vec<f64> = (0..50).map(f64::from).collect();
        let ones = vec![1.0; 50];
        let noise = NoiseModel::white(4.0);
        let s = Stretch { weight: 0.3, noise: &noise, columns: vec![&ones, &t] };
        let got = coloured_covariance(2, &[s]).unwrap();
        // Var of a slope: σ²/Σ(t − t̄)²
        let centred: f64 = t.iter().map(|t| (t - 24.5).powi(2)).sum();
        assert!((got[(1, 1)] * centred / 4.0 - 1.0).abs() < 1e-12);
    }

    /// Share of 95 % intervals of a line's three coefficients that hold the truth.
    fn coverage(phi: f64, samples: usize, cases: u64) -> f64 {
        let truth = Autoregression::from_coefficients(&[phi], 1.0).unwrap();
        let columns: [Vec<f64>; 3] = [
            vec![1.0; samples],
            (0..samples).map(|i| i as f64 / samples as f64 - 0.5).collect(),
            (0..samples).map(|i| (i as f64 * 0.05).sin()).collect(),
        ];
        let views: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        let mut hits = 0;
        for seed in 0..cases {
            let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
            let e: Vec<f64> = (0..samples).map(|_| StandardNormal.sample(&mut rng)).collect();
            let noise = truth.colour(&e);
            let mut triangle = Triangle::new(3);
            triangle.push(&views, &noise.iter().map(|y| -y).collect::<Vec<_>>());
            let found = triangle.solve(&[]);
            let residual: Vec<f64> = (0..samples)
                .map(|i| noise[i] - (0..3).map(|j| found[j] * columns[j][i]).sum::<f64>())
                .collect();
            let model =
                NoiseModel::estimate(&[&residual], &views.iter().map(|v| vec![*v]).collect::<Vec<_>>());
            let s = Stretch { weight: 1.0, noise: &model, columns: views.clone() };
            let covariance = coloured_covariance(3, &[s]).unwrap();
            let reach = half_width(independent_samples(&model, samples) - 3.0);
            hits += (0..3).filter(|j| found[*j].abs() <= reach * covariance[(*j, *j)].sqrt()).count();
        }
        hits as f64 / (3 * cases) as f64
    }

    #[test]
    fn intervals_hold_the_truth_at_any_correlation() {
        for (phi, low) in [(0.0, 0.93), (0.9, 0.93), (0.98, 0.92)] {
            let share = coverage(phi, 4000, 200);
            assert!((low..=0.975).contains(&share), "correlation {phi}: {share}");
        }
    }
}
