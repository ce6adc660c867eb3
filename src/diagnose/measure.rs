//! How good a fitted model is: free run, held-out blocks of the fitted part, likelihood.
//!
//! # Purpose
//! Three figures by which models of the same data are compared: the free-run sum of squares, the same
//! over blocks left out in turn, and the likelihood with the noise's own colour.
//!
//! # Method
//! Parts, each of several blocks spread over the recording, are left out by the influence formula at the minimum, e_k + J_k (A − A_k)⁻¹ J_kᵀ e_k with
//! A = Σ JᵀJ. The likelihood is that of an autoregression fitted to the residual, after two steps of
//! generalised least squares from the free-run minimum along its sensitivities.
//!
//! # References
//! R. D. Cook, S. Weisberg, Residuals and Influence in Regression (1982), ch. 3; D. Cochrane, G. H.
//! Orcutt, J. Amer. Statist. Assoc. 44 (1949) 32.

use super::screen::log_chance;
use crate::estimate::Triangle;
use crate::estimate::fit::{Fit, Series};
use crate::estimate::noise::{Autoregression, NoiseModel, block_means};
use crate::units::Dimension;
use faer::Mat;
use faer::linalg::solvers::Solve;
use statrs::function::beta::checked_beta_reg;
use std::ops::Range;

/// How much likelier another reading of a recording must be, its price paid: odds of e⁵ to 1.
pub const SURELY: f64 = 5.0;
/// Parts that are left out in turn, each of several blocks.
const BLOCKS: usize = 6;
/// Blocks of consecutive samples in one part.
const PIECES: usize = 4;
/// Share of the whole information that stands in for what a part alone would know.
const PRIOR: f64 = 2e-3;
/// Share of all that is known of a time from which on one part alone shows it.
const ALONE: f64 = 0.9;
/// Order of the autoregressions whose likelihoods are compared.
const ORDER: usize = 10;
/// One in so many samples is not weighed at the beginning: what a law remembers from before it is not known, and a
/// steady residual that is foretold by its own past would win against such a law by a few samples.
const BEGINNING: usize = 50;
/// So many samples make no law where they make this share of what it lowers, and others are so many times as many.
const FEW: usize = 2;
const MOSTLY: f64 = 0.8;
const MANY_MORE: usize = 20;
/// Degrees of freedom from which on Fisher's distribution is that of chi-squared.
const MANY: f64 = 2000.0;

/// Stretches of so many samples without the beginning.
pub fn after_beginning(stretches: &[Range<usize>], samples: usize) -> Vec<Range<usize>> {
    let first = samples / BEGINNING;
    stretches.iter().map(|r| r.start.max(first)..r.end).filter(|r| !r.is_empty()).collect()
}

/// The scale on which models of one set of recordings are compared.
#[derive(Debug, Clone)]
pub struct Scale {
    /// One over the mean square of each output's residual.
    pub weights: Vec<f64>,
    /// Decimation of each output.
    pub decimation: Vec<usize>,
    /// Whether rows are independent.
    pub trials: bool,
}

impl Scale {
    /// The scale set by a fit.
    pub fn of(fit: &Fit, trials: bool) -> Self {
        let inverse = |r: &f64| if *r > 0.0 { 1.0 / (r * r) } else { 0.0 };
        let decimation =
            if trials { vec![1; fit.noise.len()] } else { fit.noise.iter().map(|n| n.decimation).collect() };
        Self { weights: fit.rmse.iter().map(inverse).collect(), decimation, trials }
    }

    /// The stretches of a series that are weighed.
    fn stretches(&self, s: &Series) -> Vec<Range<usize>> {
        if self.trials { s.stretches.clone() } else { after_beginning(&s.stretches, s.residual.len()) }
    }

    /// Free-run sum of squares of a fit, every output weighed by this scale.
    pub fn squares(&self, fit: &Fit) -> f64 {
        series(fit).map(|s| self.weights[s.output] * s.residual.iter().map(|e| e * e).sum::<f64>()).sum()
    }
}

/// The least sum of squares, weighed by a scale, that a fit's own sensitivities promise: what one that was
/// ended early may still come down to near where it is.
pub fn promised(fit: &Fit, scale: &Scale) -> f64 {
    let free = free_unknowns(fit);
    let mut triangle = Triangle::new(free.len());
    for s in series(fit) {
        let root = scale.weights[s.output].sqrt();
        let weighed = |v: &[f64]| v.iter().map(|x| root * x).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = free.iter().map(|j| weighed(&s.sensitivities[*j])).collect();
        let minus: Vec<f64> = s.residual.iter().map(|e| -root * e).collect();
        triangle.push(&columns.iter().map(Vec::as_slice).collect::<Vec<_>>(), &minus);
    }
    let damping: Vec<f64> = triangle.column_norms().iter().map(|n| 1e-6 * n + f64::MIN_POSITIVE).collect();
    let least = triangle.predicted(&triangle.solve(&damping));
    if least.is_finite() { least } else { 0.0 }
}

/// Sum of squares, weighed by a scale, of what parameters of a fit make of the prediction, to first order: Σ (Σ_j s_j p_j)².
pub fn made_by(fit: &Fit, is_one: &dyn Fn(&str) -> bool, scale: &Scale) -> f64 {
    let parameters = fit.model.parameters.iter().filter(|p| is_one(&p.name));
    let numbered =
        parameters.filter_map(|p| Some((fit.unknowns.iter().position(|u| *u == p.name)?, p.value)));
    let ones: Vec<(usize, f64)> = numbered.collect();
    let of = |s: &Series| {
        let at = |i: usize| ones.iter().map(|(j, value)| s.sensitivities[*j][i] * value).sum::<f64>();
        scale.weights[s.output] * (0..s.residual.len()).map(|i| at(i).powi(2)).sum::<f64>()
    };
    series(fit).map(of).sum()
}

/// Whether what a fit lowers of another's sum of squares is that of one or two samples among many: these are far off, and a law
/// that passes through them is none.
pub fn stands_on_few(before: &Fit, after: &Fit, scale: &Scale) -> bool {
    let both = series(before).zip(series(after));
    let of = |(old, new): (&Series, &Series)| {
        let squares = old.residual.iter().zip(&new.residual).map(|(a, b)| a * a - b * b);
        squares.map(|d| scale.weights[old.output] * d).collect::<Vec<f64>>()
    };
    let mut falls: Vec<f64> = both.flat_map(of).collect();
    let all: f64 = falls.iter().sum();
    falls.sort_by(|a, b| b.total_cmp(a));
    let (few, rest) = falls.split_at(FEW.min(falls.len()));
    all > 0.0 && rest.len() >= MANY_MORE * FEW && few.iter().sum::<f64>() > MOSTLY * all
}

/// How good a fit is.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// The same over blocks left out in turn.
    pub left_out: f64,
    /// Log-likelihood.
    pub likelihood: f64,
    /// Independent samples behind the likelihood.
    pub samples: f64,
    /// Unknowns that were free to follow them.
    pub unknowns: usize,
}

impl Measure {
    /// Measures a fit.
    pub fn of(fit: &Fit, scale: &Scale) -> Self {
        let series: Vec<&Series> = series(fit).collect();
        let free = free_unknowns(fit);
        let (likelihood, samples) = likelihood(&series, &free, scale);
        // Initial states belong to their block alone: they stay where they are.
        let shared: Vec<usize> = free.iter().copied().filter(|j| !fit.unknowns[*j].contains("(0)")).collect();
        let is_time = |j: usize| {
            let own = fit.model.parameters.iter().find(|p| p.name == fit.unknowns[j]);
            own.is_some_and(|p| p.unit.dimension() == Dimension::TIME)
        };
        let left_out = left_out(&series, (&shared, &is_time), scale).unwrap_or(f64::INFINITY);
        Self { left_out, likelihood, samples, unknowns: free.len() }
    }

    /// Chance that noise alone raises the log-likelihood as far as from a smaller model's to this one's by
    /// `added` unknowns. With ν degrees of freedom left of n samples 2 Δln L = n ln(1 + kF/ν), and F has
    /// Fisher's distribution: P = I_x(ν/2, k/2) at x = exp(−2 Δln L/n).
    pub fn chance_over(&self, smaller: f64, added: usize) -> f64 {
        let ratio = 2.0 * (self.likelihood - smaller);
        chance(ratio, added.max(1), self.samples, self.samples - self.unknowns as f64)
    }
}

/// Chance that k useless unknowns, which leave some degrees of freedom of n samples, have such a likelihood
/// ratio. From many samples on it is that of chi-squared.
pub fn chance(ratio: f64, k: usize, samples: f64, degrees: f64) -> f64 {
    if degrees < 1.0 || ratio.is_nan() || ratio <= 0.0 {
        return 1.0;
    }
    if degrees > MANY {
        return log_chance(ratio, k).exp();
    }
    checked_beta_reg(0.5 * degrees, 0.5 * k as f64, (-ratio / samples).exp()).unwrap_or(1.0)
}

fn series(fit: &Fit) -> impl Iterator<Item = &Series> {
    fit.records.iter().flat_map(|r| &r.series)
}

/// Unknowns that are inside their bounds.
fn free_unknowns(fit: &Fit) -> Vec<usize> {
    (0..fit.unknowns.len()).filter(|j| !fit.is_at_bound(&fit.unknowns[*j])).collect()
}

/// Σ JᵀJ, Σ Jᵀe and the rows (series, sample) of one part.
type Part = (Mat<f64>, Vec<f64>, Vec<(usize, usize)>);

/// The moment of a leap, a time that one part alone shows, belongs to that part as an initial state does: without it nothing
/// says when, and it stays where it is.
fn left_out(
    series: &[&Series],
    (free, is_time): (&[usize], &dyn Fn(usize) -> bool),
    scale: &Scale,
) -> Option<f64> {
    let p = free.len();
    let total: usize = series.iter().map(|s| s.residual.len()).sum();
    let size = total.div_ceil(BLOCKS * PIECES).max(1);
    let mut blocks: Vec<Part> = (0..BLOCKS).map(|_| (Mat::zeros(p, p), vec![0.0; p], Vec::new())).collect();
    let mut count = 0;
    for (k, s) in series.iter().enumerate() {
        let w = scale.weights[s.output];
        for i in scale.stretches(s).into_iter().flatten() {
            let block = if scale.trials { count % BLOCKS } else { (count / size) % BLOCKS };
            let (a, g, rows) = &mut blocks[block];
            for (x, jx) in free.iter().enumerate() {
                let c = w * s.sensitivities[*jx][i];
                g[x] += c * s.residual[i];
                for (y, jy) in free.iter().enumerate().take(x + 1) {
                    a[(x, y)] += c * s.sensitivities[*jy][i];
                }
            }
            rows.push((k, i));
            count += 1;
        }
    }
    let mut all = Mat::<f64>::zeros(p, p);
    for (a, _, _) in &blocks {
        all += a;
    }
    let is_moment = |x: usize| {
        let alone = |(a, _, _): &Part| a[(x, x)] > ALONE * all[(x, x)];
        !scale.trials && is_time(free[x]) && blocks.iter().any(alone)
    };
    let moving: Vec<usize> = (0..p).filter(|x| !is_moment(*x)).collect();
    let mut sum = 0.0;
    for (a, g, rows) in &blocks {
        let rest = Mat::from_fn(moving.len(), moving.len(), |x, y| {
            let (i, j) = (moving[x.max(y)], moving[x.min(y)]);
            let value = all[(i, j)] - a[(i, j)];
            if x == y { value + PRIOR * all[(i, i)] + f64::MIN_POSITIVE } else { value }
        });
        let step = rest.partial_piv_lu().solve(Mat::from_fn(moving.len(), 1, |x, _| g[moving[x]]));
        for (k, i) in rows {
            let s = series[*k];
            let one = |(x, at): (usize, &usize)| s.sensitivities[free[*at]][*i] * step[(x, 0)];
            let shift: f64 = moving.iter().enumerate().map(one).sum();
            sum += scale.weights[s.output] * (s.residual[*i] + shift).powi(2);
        }
    }
    sum.is_finite().then_some(sum)
}

/// One output's shortened residual and sensitivities, stretch by stretch.
struct Short {
    output: usize,
    residual: Vec<f64>,
    columns: Vec<Vec<f64>>,
}

fn likelihood(series: &[&Series], free: &[usize], scale: &Scale) -> (f64, f64) {
    let mut shorts: Vec<Short> = Vec::new();
    for s in series {
        let m = scale.decimation[s.output];
        for r in scale.stretches(s) {
            let columns = free.iter().map(|j| block_means(&s.sensitivities[*j][r.clone()], m)).collect();
            shorts.push(Short {
                output: s.output,
                residual: block_means(&s.residual[r.clone()], m),
                columns,
            });
        }
    }
    let outputs = scale.decimation.len();
    for _ in 0..3 {
        let noise: Vec<NoiseModel> = (0..outputs).map(|o| colour(&shorts, o, scale.trials)).collect();
        let mut triangle = Triangle::new(free.len());
        for s in &shorts {
            let columns: Vec<&[f64]> = s.columns.iter().map(Vec::as_slice).collect();
            let rows = noise[s.output].whiten_rows(&s.residual, &columns);
            let views: Vec<&[f64]> = rows.columns.iter().map(Vec::as_slice).collect();
            triangle.push(&views, &rows.residual);
        }
        let damping: Vec<f64> =
            triangle.column_norms().iter().map(|n| 1e-6 * n + f64::MIN_POSITIVE).collect();
        let step = triangle.solve(&damping);
        if !step.iter().all(|x| x.is_finite()) {
            break;
        }
        for s in &mut shorts {
            for (c, x) in s.columns.iter().zip(&step) {
                // δ minimises ‖e + J δ‖.
                s.residual.iter_mut().zip(c).for_each(|(e, j)| *e += j * x);
            }
        }
    }
    let mut sum = 0.0;
    let mut count = 0.0;
    for o in 0..outputs {
        let n: usize = shorts.iter().filter(|s| s.output == o).map(|s| s.residual.len()).sum();
        let variance = colour(&shorts, o, scale.trials).autoregression.innovation_variance();
        if n > 0 && variance > 0.0 {
            sum -= 0.5 * n as f64 * variance.ln();
            count += n as f64;
        }
    }
    (sum, count)
}

fn colour(shorts: &[Short], output: usize, trials: bool) -> NoiseModel {
    let own: Vec<&[f64]> =
        shorts.iter().filter(|s| s.output == output).map(|s| s.residual.as_slice()).collect();
    let n: usize = own.iter().map(|s| s.len()).sum();
    let order = if trials { 0 } else { ORDER.min(n / 20) };
    NoiseModel { decimation: 1, autoregression: Autoregression::burg(&own, order) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P(F₁,₅ > 6.608) = 0.05 and P(F₂,₁₀ > 7.559) = 0.01 (tables of Fisher's distribution); with many samples
    /// P(χ²₁ > 10.828) = 0.001.
    #[test]
    fn a_likelihood_ratio_of_few_samples_has_the_chance_of_fishers_distribution() {
        let of = |f: f64, k: usize, samples: f64, degrees: f64| {
            chance(samples * (1.0 + k as f64 * f / degrees).ln(), k, samples, degrees)
        };
        assert!((of(6.608, 1, 9.0, 5.0) - 0.05).abs() < 1e-4);
        assert!((of(7.559, 2, 15.0, 10.0) - 0.01).abs() < 1e-4);
        assert!((chance(10.828, 1, 1e5, 1e5 - 4.0) - 1e-3).abs() < 1e-5);
        let (near, far) = (chance(40.0, 1, 1990.0, 1986.0), chance(40.0, 1, 2010.0, 2006.0));
        assert!((near / far).ln().abs() < 0.5, "{near} {far}");
        assert_eq!(chance(1e3, 1, 4.0, 0.0), 1.0);
    }
}
