//! Screening: which of many extensions would explain what the residual still holds.
//!
//! # Purpose
//! Order the proposals of the catalogue by one free run each, and give one honest chance that the
//! largest score among all of them comes from noise alone.
//!
//! # Method
//! Score test. The residual, the sensitivities of the fitted unknowns and the direction in which a
//! proposal moves the predictions are whitened by the same noise models; directions are made
//! orthogonal to the fitted sensitivities. The statistic is −ln of the chance of the projection of the
//! residual under chi-squared. The distribution of the largest statistic is found by projecting
//! drawn white noise on the same directions; a Bonferroni bound serves in the tail beyond the draws.
//!
//! # References
//! C. R. Rao, Proc. Cambridge Phil. Soc. 44 (1948) 50; H. White, A reality check for data snooping,
//! Econometrica 68 (2000) 1097.
//!
//! # Numerical aspects
//! Modified Gram-Schmidt, twice; a direction of which less than 10⁻⁴ is left is not seen.

use super::bench::Track;
use crate::estimate::noise::NoiseModel;
use rand::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Draws of white noise behind the chance of the largest score.
const DRAWS: usize = 99;
/// Share of a direction that must be left after projection.
const LEFT: f64 = 1e-4;

/// The whitened residual and the space of the fitted unknowns.
pub struct Screen {
    /// Whitened residual, orthogonal to the fitted sensitivities.
    pub residual: Vec<f64>,
    basis: Vec<Vec<f64>>,
    noise: Vec<NoiseModel>,
    draws: Vec<Vec<f64>>,
}

/// What a direction, or a few together, explain.
#[derive(Debug, Clone)]
pub struct Score {
    /// Chi-squared of the projection.
    pub chi2: f64,
    /// Number of directions.
    pub degrees: usize,
    /// −ln of its single chance.
    pub statistic: f64,
    /// Least-squares weights of the directions.
    pub weights: Vec<f64>,
    /// The statistic for each draw of noise.
    pub drawn: Vec<f64>,
    /// The first direction, of unit length.
    pub direction: Vec<f32>,
}

impl Screen {
    /// Whitens the tracks of the fitted model, whose sensitivities are to its unknowns.
    pub fn new(tracks: &[Track], noise: &[NoiseModel], seed: u64) -> Self {
        let mut residual = whiten(tracks, noise, |t| &t.residual);
        let unknowns = tracks.first().map_or(0, |t| t.sensitivities.len());
        let mut basis: Vec<Vec<f64>> = Vec::new();
        for j in 0..unknowns {
            let mut column = whiten(tracks, noise, |t| &t.sensitivities[j]);
            let before = norm(&column);
            remove(&mut column, &basis);
            let after = norm(&column);
            if after > 1e-8 * before && after > 0.0 {
                for x in &mut column {
                    *x /= after;
                }
                basis.push(column);
            }
        }
        remove(&mut residual, &basis);
        // What is left lies in so many directions less than there are samples.
        let degrees = residual.len().saturating_sub(basis.len()).max(1);
        let scale = (residual.iter().map(|e| e * e).sum::<f64>() / degrees as f64).sqrt();
        if scale > 0.0 {
            for e in &mut residual {
                *e /= scale;
            }
        }
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let n = residual.len();
        let draw = |rng: &mut rand_chacha::ChaCha8Rng| (0..n).map(|_| StandardNormal.sample(rng)).collect();
        let draws = (0..DRAWS).map(|_| draw(&mut rng)).collect();
        Self { residual, basis, noise: noise.iter().map(|m| rescaled(m, scale)).collect(), draws }
    }

    /// Whitens something that runs beside the tracks' residuals.
    pub fn whitened(&self, tracks: &[Track], of: impl Fn(&Track) -> &[f64]) -> Vec<f64> {
        whiten(tracks, &self.noise, |t| of(t))
    }

    /// Scores directions, already whitened; `positive` asks for positive weights.
    pub fn score(&self, mut directions: Vec<Vec<f64>>, positive: bool) -> Option<Score> {
        let before: Vec<f64> = directions.iter().map(|d| norm(d)).collect();
        if before.iter().any(|b| !b.is_finite() || *b <= 0.0) {
            return None;
        }
        let mut own: Vec<Vec<f64>> = Vec::new();
        for (d, b) in directions.iter_mut().zip(&before) {
            remove(d, &self.basis);
            remove(d, &own);
            let left = norm(d);
            if left > LEFT * b {
                own.push(d.iter().map(|x| x / left).collect());
            }
        }
        let degrees = own.len();
        if degrees == 0 || degrees < before.len() {
            return None;
        }
        let projections: Vec<f64> = own.iter().map(|u| dot(u, &self.residual)).collect();
        let weights = projections.iter().zip(&directions).map(|(z, d)| z / norm(d)).collect();
        let one_sided = positive && degrees == 1;
        let statistic = |z: &[f64]| statistic(z, one_sided);
        let drawn = self.draws.iter().map(|e| {
            let z: Vec<f64> = own.iter().map(|u| dot(u, e)).collect();
            statistic(&z)
        });
        Some(Score {
            chi2: projections.iter().map(|z| z * z).sum(),
            degrees,
            statistic: statistic(&projections),
            weights,
            drawn: drawn.collect(),
            direction: own[0].iter().map(|x| *x as f32).collect(),
        })
    }

    /// The chance that the largest of these scores is as large by noise alone.
    pub fn p_value(scores: &[&Score]) -> f64 {
        let largest = scores.iter().map(|s| s.statistic).fold(0.0, f64::max);
        let beyond =
            (0..DRAWS).filter(|r| scores.iter().map(|s| s.drawn[*r]).fold(0.0, f64::max) >= largest).count();
        let drawn = (1 + beyond) as f64 / (DRAWS + 1) as f64;
        let bound = (scores.len() as f64 * (-largest).exp()).min(1.0);
        if scores.is_empty() { 1.0 } else { drawn.min(bound) }
    }
}

fn rescaled(model: &NoiseModel, scale: f64) -> NoiseModel {
    let mut model = model.clone();
    if scale > 0.0 {
        model.autoregression = model.autoregression.rescaled(scale * scale);
    }
    model
}

/// −ln of the chance of a projection on some unit directions.
fn statistic(z: &[f64], one_sided: bool) -> f64 {
    if one_sided && z[0] <= 0.0 {
        return 0.0;
    }
    let chi2: f64 = z.iter().map(|z| z * z).sum();
    let half = if one_sided { std::f64::consts::LN_2 } else { 0.0 };
    half - log_chance(chi2, z.len())
}

/// ln of the chance that chi-squared exceeds a value.
pub fn log_chance(chi2: f64, degrees: usize) -> f64 {
    let k = degrees.max(1) as f64;
    if chi2 > 600.0 + 2.0 * k {
        // Q(k/2, x/2) → (x/2)^(k/2 − 1) e^(−x/2)/Γ(k/2)
        let x = 0.5 * chi2;
        return (0.5 * k - 1.0) * x.ln() - x - statrs::function::gamma::ln_gamma(0.5 * k);
    }
    ChiSquared::new(k).map_or(0.0, |d| d.sf(chi2.max(0.0)).max(1e-300).ln())
}

fn whiten<'t>(tracks: &'t [Track], noise: &[NoiseModel], of: impl Fn(&'t Track) -> &'t [f64]) -> Vec<f64> {
    let stretch = |t: &'t Track| {
        let values = of(t);
        t.stretches.iter().flat_map(|r| noise[t.output].whiten(&values[r.clone()])).collect::<Vec<f64>>()
    };
    tracks.iter().flat_map(stretch).collect()
}

fn remove(v: &mut [f64], basis: &[Vec<f64>]) {
    for _ in 0..2 {
        for b in basis {
            let c = dot(v, b);
            v.iter_mut().zip(b).for_each(|(x, y)| *x -= c * y);
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// Several directions solved together.
pub struct Solved {
    /// Their score.
    pub score: Score,
    /// Least-squares weights; zero for those that are not seen apart from the others.
    pub weights: Vec<f64>,
    /// Their standard deviations.
    pub deviations: Vec<f64>,
}

impl Screen {
    /// Share of the residual's square that given weights of the directions leave, the fitted unknowns
    /// free to follow.
    pub fn left(&self, directions: &[Vec<f64>], weights: &[f64]) -> f64 {
        let mut rest = self.residual.clone();
        for (d, w) in directions.iter().zip(weights) {
            rest.iter_mut().zip(d).for_each(|(e, d)| *e -= w * d);
        }
        remove(&mut rest, &self.basis);
        dot(&rest, &rest) / dot(&self.residual, &self.residual).max(f64::MIN_POSITIVE)
    }

    /// Scores directions together; those that the others contain are left out.
    pub fn solve(&self, directions: &[Vec<f64>]) -> Option<Solved> {
        let mut kept: Vec<usize> = Vec::new();
        let mut free: Vec<Vec<f64>> = Vec::new();
        let mut own: Vec<Vec<f64>> = Vec::new();
        for (j, d) in directions.iter().enumerate() {
            let before = norm(d);
            let mut x = d.clone();
            remove(&mut x, &self.basis);
            let mut y = x.clone();
            remove(&mut y, &own);
            let left = norm(&y);
            if before.is_finite() && left > 1e-3 * before && left > 0.0 {
                own.push(y.iter().map(|v| v / left).collect());
                free.push(x);
                kept.push(j);
            }
        }
        let k = own.len();
        if k == 0 {
            return None;
        }
        // Free = Own R, with R upper triangular; weights R⁻¹ z, covariance R⁻¹ R⁻ᵀ.
        let r = faer::Mat::from_fn(k, k, |i, j| if i <= j { dot(&own[i], &free[j]) } else { 0.0 });
        let z: Vec<f64> = own.iter().map(|u| dot(u, &self.residual)).collect();
        let inverse = upper_inverse(&r);
        let mut weights = vec![0.0; directions.len()];
        let mut deviations = vec![f64::NAN; directions.len()];
        for (a, j) in kept.iter().enumerate() {
            weights[*j] = (a..k).map(|b| inverse[(a, b)] * z[b]).sum();
            deviations[*j] = (a..k).map(|b| inverse[(a, b)].powi(2)).sum::<f64>().sqrt();
        }
        let drawn =
            self.draws.iter().map(|e| statistic(&own.iter().map(|u| dot(u, e)).collect::<Vec<_>>(), false));
        let score = Score {
            chi2: z.iter().map(|z| z * z).sum(),
            degrees: k,
            statistic: statistic(&z, false),
            weights: weights.clone(),
            drawn: drawn.collect(),
            direction: Vec::new(),
        };
        Some(Solved { score, weights, deviations })
    }
}

fn upper_inverse(r: &faer::Mat<f64>) -> faer::Mat<f64> {
    let k = r.nrows();
    let mut inverse = faer::Mat::<f64>::zeros(k, k);
    for j in 0..k {
        for i in (0..=j).rev() {
            let sum: f64 = (i + 1..=j).map(|m| r[(i, m)] * inverse[(m, j)]).sum();
            let unit = if i == j { 1.0 } else { 0.0 };
            inverse[(i, j)] = (unit - sum) / r[(i, i)];
        }
    }
    inverse
}
