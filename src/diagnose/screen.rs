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
//! residual under chi-squared. The distribution of the largest statistic s is found by projecting
//! drawn white noise on the same directions. Beyond the draws its tail is that of as many independent scores as
//! the draws show: each has P(S > s) = e^(−s) of its own, so that P(max S > s) = P(max S > s₀) e^(s₀ − s).
//!
//! # References
//! C. R. Rao, Proc. Cambridge Phil. Soc. 44 (1948) 50; H. White, A reality check for data snooping,
//! Econometrica 68 (2000) 1097.
//!
//! # Numerical aspects
//! Directions are made orthogonal to the fitted ones twice, then to each other by the Cholesky factor of their
//! products; a direction of which less than 10⁻⁴ is left is not seen. Drawn noise is projected on short images
//! of long directions: sums over sample numbers that are equal modulo their length, with random signs, keep
//! products to some 2 % (K. L. Clarkson, D. P. Woodruff, J. ACM 63 (2017) 54:1-45), and the images of one
//! proposal are made orthonormal, so that each statistic alone has its exact distribution.

use super::bench::Track;
use crate::estimate::noise::NoiseModel;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::{Col, ColRef, Mat, MatRef, Par};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Draws of white noise behind the chance of the largest score.
const DRAWS: usize = 999;
/// Draws of them beyond which the tail begins.
const TAIL: usize = 50;
/// Length of the images on which drawn noise is projected.
const IMAGE: usize = 2048;
/// Share of a direction that must be left after projection.
const LEFT: f64 = 1e-4;
/// The same for directions that are solved together.
const APART: f64 = 1e-3;

/// The whitened residual and the space of the fitted unknowns.
pub struct Screen {
    /// Whitened residual, orthogonal to the fitted sensitivities.
    pub residual: Vec<f64>,
    /// Orthonormal columns.
    basis: Mat<f64>,
    noise: Vec<NoiseModel>,
    /// Seed of drawn noise, where the chance of the largest score is asked for.
    seed: Option<u64>,
    /// Signs of the samples in an image; none where directions are no longer than that.
    signs: Vec<f64>,
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
    /// Images of its directions, orthonormal columns on which noise is drawn.
    image: Mat<f64>,
    /// Whether its weight may only be positive.
    one_sided: bool,
    /// Share of the first direction that the fitted unknowns do not hold.
    pub apart: f64,
    /// The first direction, of unit length.
    pub direction: Vec<f32>,
}

/// On how many directions a statistic rests, and whether its weight may only be positive.
type Kind = (usize, bool);

/// Directions orthogonal to the fitted ones, D = Q Lᵀ with orthonormal Q.
struct Apart {
    /// Those that the others before them do not contain.
    kept: Vec<usize>,
    d: Mat<f64>,
    l: Mat<f64>,
}

impl Apart {
    /// Of directions, those whose squares are more than the least beyond what the others before them hold.
    fn of(d: &Mat<f64>, least: impl Fn(usize) -> f64) -> Self {
        let (kept, l) = factor(&(d.transpose() * d), least);
        let d = Mat::from_fn(d.nrows(), kept.len(), |i, k| d[(i, kept[k])]);
        Self { kept, d, l }
    }

    /// Q.
    fn orthonormal(&self) -> Mat<f64> {
        let mut transposed = self.d.transpose().to_owned();
        solve_lower_triangular_in_place(self.l.as_ref(), transposed.as_mut(), Par::Seq);
        transposed.transpose().to_owned()
    }

    /// Qᵀ of vectors.
    fn projected(&self, of: MatRef<'_, f64>) -> Mat<f64> {
        let mut z = self.d.transpose() * of;
        solve_lower_triangular_in_place(self.l.as_ref(), z.as_mut(), Par::Seq);
        z
    }
}

impl Screen {
    /// Whitens the tracks of the fitted model, whose sensitivities are to its unknowns; the chance of the largest
    /// score asks for a seed.
    pub fn new(tracks: &[Track], noise: &[NoiseModel], seed: Option<u64>) -> Self {
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
        let signs = seed.map_or_else(Vec::new, |seed| signs(residual.len(), seed));
        let basis = columns(residual.len(), &basis);
        let noise = noise.iter().map(|m| rescaled(m, scale)).collect();
        Self { residual, basis, noise, seed, signs }
    }

    /// Whitens something that runs beside the tracks' residuals.
    pub fn whitened(&self, tracks: &[Track], of: impl Fn(&Track) -> &[f64]) -> Vec<f64> {
        whiten(tracks, &self.noise, |t| of(t))
    }

    /// How the residual of the screen weighs the samples of tracks: its product with a direction is the sum of these
    /// weights times what moves.
    pub fn weights(&self, tracks: &[Track]) -> Vec<Vec<f64>> {
        let mut rest = &self.residual[..];
        let mut of = |t: &Track| {
            let mut weights = vec![0.0; t.residual.len()];
            for r in &t.stretches {
                let noise = &self.noise[t.output];
                let (own, others) = rest.split_at(r.len() / noise.decimation.max(1));
                rest = others;
                weights[r.clone()].copy_from_slice(&noise.whiten_adjoint(own, r.len()));
            }
            weights
        };
        tracks.iter().map(&mut of).collect()
    }

    /// Sum of the squares of directions, apart from the fitted unknowns.
    pub fn energy(&self, directions: &[Vec<f64>]) -> f64 {
        self.free(directions).squared_norm_l2()
    }

    /// Directions without what lies in the space of the fitted unknowns.
    pub fn free(&self, directions: &[Vec<f64>]) -> Mat<f64> {
        let mut d = columns(self.residual.len(), directions);
        for _ in 0..2 {
            d -= &self.basis * (self.basis.transpose() * &d);
        }
        d
    }

    /// Directions apart from the fitted ones and from each other, without those of which less than a share is left.
    fn apart(&self, directions: &[Vec<f64>], share: f64) -> Option<Apart> {
        let own = Apart::of(&self.free(directions), |j| (share * norm(&directions[j])).powi(2));
        (!own.kept.is_empty()).then_some(own)
    }

    /// What drawn noise is projected on for directions; nothing where none is drawn.
    fn imaged(&self, of: &Apart) -> Mat<f64> {
        match self.seed {
            None => Mat::zeros(0, 0),
            Some(_) if self.signs.is_empty() => of.orthonormal(),
            Some(_) => Apart::of(&image(&of.d, &self.signs), |_| 0.0).orthonormal(),
        }
    }

    /// Scores directions, already whitened; `positive` asks for positive weights.
    pub fn score(&self, directions: &[Vec<f64>], positive: bool) -> Option<Score> {
        if directions.iter().map(|d| norm(d)).any(|b| !b.is_finite() || b <= 0.0) {
            return None;
        }
        let own = self.apart(directions, LEFT)?;
        let degrees = own.kept.len();
        if degrees < directions.len() {
            return None;
        }
        let z = own.projected(ColRef::from_slice(&self.residual).as_mat());
        let projections = z.col_as_slice(0);
        let one_sided = positive && degrees == 1;
        let first = own.l[(0, 0)];
        Some(Score {
            chi2: dot(projections, projections),
            degrees,
            statistic: statistic(square(projections, one_sided), (degrees, one_sided)),
            weights: projections.iter().enumerate().map(|(j, z)| z / own.l[(j, j)]).collect(),
            image: self.imaged(&own),
            one_sided,
            apart: first / norm(&directions[0]),
            direction: own.d.col_as_slice(0).iter().map(|x| (*x / first) as f32).collect(),
        })
    }

    /// The chance that the largest of these scores is as large by noise alone.
    pub fn p_value(&self, scores: &[&Score]) -> f64 {
        let Some(seed) = self.seed.filter(|_| !scores.is_empty()) else { return 1.0 };
        let columns: Vec<&[f64]> =
            scores.iter().flat_map(|s| (0..s.image.ncols()).map(|j| s.image.col_as_slice(j))).collect();
        let images =
            Mat::from_fn(columns.first().map_or(0, |c| c.len()), columns.len(), |i, j| columns[j][i]);
        let z = images.transpose() * draws(images.nrows(), seed);
        // of one kind of statistic the largest has the largest square, so that one a kind is turned into a chance
        let own: Vec<Kind> = scores.iter().map(|s| (s.image.ncols(), s.one_sided)).collect();
        let mut kinds = own.clone();
        kinds.sort_unstable();
        kinds.dedup();
        let numbers: Vec<usize> = own.iter().map(|k| kinds.partition_point(|other| other < k)).collect();
        let of = |draw: &[f64]| {
            let mut largest = vec![0.0f64; kinds.len()];
            let mut rest = draw;
            for ((directions, one_sided), number) in own.iter().zip(&numbers) {
                let (z, others) = rest.split_at(*directions);
                rest = others;
                largest[*number] = largest[*number].max(square(z, *one_sided));
            }
            kinds.iter().zip(&largest).map(|(k, square)| statistic(*square, *k)).fold(0.0, f64::max)
        };
        let drawn = (0..DRAWS).map(|r| of(z.col_as_slice(r))).collect();
        beyond(drawn, scores.iter().map(|s| s.statistic).fold(0.0, f64::max))
    }
}

/// The chance of so large a score beside drawn ones, (1 + number beyond)/(1 + draws) or the tail's.
fn beyond(mut drawn: Vec<f64>, largest: f64) -> f64 {
    let all = (1 + drawn.len()) as f64;
    let beyond = drawn.iter().filter(|d| **d >= largest).count();
    if beyond >= TAIL || drawn.len() <= TAIL {
        return (1 + beyond) as f64 / all;
    }
    let (_, first, _) = drawn.select_nth_unstable_by(TAIL - 1, |a, b| b.total_cmp(a));
    (TAIL as f64 / all) * (*first - largest).exp()
}

fn rescaled(model: &NoiseModel, scale: f64) -> NoiseModel {
    let mut model = model.clone();
    if scale > 0.0 {
        model.autoregression = model.autoregression.rescaled(scale * scale);
    }
    model
}

/// The square of a projection on some unit directions; 0 where its one weight may only be positive and is not.
fn square(z: &[f64], one_sided: bool) -> f64 {
    if one_sided && z.first().is_some_and(|z| *z <= 0.0) { 0.0 } else { z.iter().map(|z| z * z).sum() }
}

/// −ln of the chance of so large a square; it grows with it.
fn statistic(chi2: f64, (directions, one_sided): Kind) -> f64 {
    match one_sided {
        true if chi2 <= 0.0 => 0.0,
        true => std::f64::consts::LN_2 - log_chance(chi2, directions),
        false => -log_chance(chi2, directions),
    }
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
    let [a, b] = [a, b].map(ColRef::from_slice);
    a.transpose() * b
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// Vectors of a length as the columns of a matrix.
fn columns(length: usize, vectors: &[Vec<f64>]) -> Mat<f64> {
    Mat::from_fn(length, vectors.len(), |i, j| vectors[j][i])
}

/// Drawn white noise of a length, a column a draw.
fn draws(rows: usize, seed: u64) -> Mat<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    Mat::from_fn(rows, DRAWS, |_, _| StandardNormal.sample(&mut rng))
}

/// The signs of samples in an image, where directions are longer than that.
fn signs(length: usize, seed: u64) -> Vec<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(!seed);
    let mut sign = || if rng.random_bool(0.5) { 1.0 } else { -1.0 };
    if length > IMAGE { (0..length).map(|_| sign()).collect() } else { Vec::new() }
}

/// The images of columns: sums with signs over samples whose numbers are equal modulo [`IMAGE`].
fn image(of: &Mat<f64>, signs: &[f64]) -> Mat<f64> {
    let mut image = Mat::zeros(IMAGE, of.ncols());
    for j in 0..of.ncols() {
        let sums = image.col_as_slice_mut(j);
        for (values, signs) in of.col_as_slice(j).chunks(IMAGE).zip(signs.chunks(IMAGE)) {
            for (sum, (x, s)) in sums.iter_mut().zip(values.iter().zip(signs)) {
                *sum += s * x;
            }
        }
    }
    image
}

/// G = L Lᵀ for those rows and columns whose squares are more than the least beyond what the others before them hold.
fn factor(g: &Mat<f64>, least: impl Fn(usize) -> f64) -> (Vec<usize>, Mat<f64>) {
    let mut kept: Vec<usize> = Vec::new();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for j in 0..g.nrows() {
        let mut row: Vec<f64> = Vec::with_capacity(kept.len() + 1);
        for (k, above) in kept.iter().zip(&rows) {
            let held: f64 = row.iter().zip(above).map(|(x, y)| x * y).sum();
            row.push((g[(j, *k)] - held) / above[row.len()]);
        }
        let left = g[(j, j)] - row.iter().map(|x| x * x).sum::<f64>();
        if left > least(j) && left.is_finite() {
            row.push(left.sqrt());
            rows.push(row);
            kept.push(j);
        }
    }
    let k = kept.len();
    (kept, Mat::from_fn(k, k, |i, j| rows[i].get(j).copied().unwrap_or(0.0)))
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
        let moved = self.free(directions) * Col::from_fn(weights.len(), |j| weights[j]);
        let left: f64 = self.residual.iter().zip(moved.iter()).map(|(e, m)| (e - m).powi(2)).sum();
        left / dot(&self.residual, &self.residual).max(f64::MIN_POSITIVE)
    }

    /// Scores directions together; those that the others contain are left out.
    pub fn solve(&self, directions: &[Vec<f64>]) -> Option<Solved> {
        let own = self.apart(directions, APART)?;
        let k = own.kept.len();
        let z = own.projected(ColRef::from_slice(&self.residual).as_mat());
        let z = z.col_as_slice(0);
        // D = Q Lᵀ: weights L⁻ᵀ z, covariance L⁻ᵀ L⁻¹
        let mut inverse = Mat::<f64>::identity(k, k);
        solve_lower_triangular_in_place(own.l.as_ref(), inverse.as_mut(), Par::Seq);
        let mut weights = vec![0.0; directions.len()];
        let mut deviations = vec![f64::NAN; directions.len()];
        for (a, j) in own.kept.iter().enumerate() {
            weights[*j] = dot(inverse.col_as_slice(a), z);
            deviations[*j] = norm(inverse.col_as_slice(a));
        }
        let score = Score {
            chi2: dot(z, z),
            degrees: k,
            statistic: statistic(dot(z, z), (k, false)),
            weights: weights.clone(),
            image: self.imaged(&own),
            one_sided: false,
            apart: f64::NAN,
            direction: Vec::new(),
        };
        Some(Solved { score, weights, deviations })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of m independent scores P(max > s) = 1 − (1 − e^(−s))^m.
    #[test]
    fn the_chance_of_the_largest_score_is_that_of_so_many_independent_ones() {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        for m in [1, 20, 300] {
            let exact = |s: f64| 1.0 - (1.0 - (-s).exp()).powi(m);
            let mut largest = || (0..m).map(|_| -rng.random::<f64>().ln()).fold(0.0, f64::max);
            let drawn: Vec<f64> = (0..DRAWS).map(|_| largest()).collect();
            for p in [0.5f64, 0.2, 0.05, 0.01, 1e-3, 1e-6] {
                let s = -(1.0 - (1.0 - p).powf(1.0 / f64::from(m))).ln();
                assert!((exact(s) / p - 1.0).abs() < 1e-6);
                // 50 draws lie in the tail: its share is known to 14 %
                let ratio = beyond(drawn.clone(), s) / p;
                assert!((ratio.ln()).abs() < 3.0 * 0.14 + 0.03, "{m} {p} {ratio}");
            }
        }
        assert_eq!(beyond(Vec::new(), 0.0), 1.0);
    }
}
