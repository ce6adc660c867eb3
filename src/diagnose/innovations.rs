//! Whether what a model leaves over is noise at all.
//!
//! # Purpose
//! A noise model is estimated from the residual itself, so that it whitens whatever is slow: a zero that
//! steps, a push that comes and goes. Before "nothing is missing" is said, what is left must be noise by
//! two tests that such a model cannot answer for it.
//!
//! # Method
//! Noise of a colour has innovations of one distribution. Where the level of a residual steps, they are one
//! after the other the step as the whitening filter passes it, g = (1, 1 − φ₁, 1 − φ₁ − φ₂, …): the matched
//! filter Σ g_k e_(t+k)/‖g‖, over a scale that steps do not move, is scanned over all moments. A single sample
//! that is off is no step: there the filter of an outlier, (1, −φ₁, −φ₂, …), answers louder. The chance is that
//! of Student's t whose tail is as heavy as that of the innovations, times all moments.
//!
//! Noise forgets. A fitted part of n samples holds n S₀/S(0) independent values of noise of variance S₀ and
//! density S(0) at rest; where these are so few that they may agree by luck, slow noise and a law are one.
//!
//! # References
//! R. S. Tsay, J. Forecasting 7 (1988) 1; C. Chen, L.-M. Liu, J. Amer. Statist. Assoc. 88 (1993) 284.
//!
//! # Numerical aspects
//! The scale never falls below the resolution of the channel or the error of the simulation.

use super::bench::Bench;
use super::catalogue::Shift;
use super::choose::SURE;
use super::few::agree_by_luck;
use super::prove::Held;
use super::stray::{Stray, stray};
use super::words;
use crate::estimate::Fit;
use crate::estimate::fit::Series;
use crate::estimate::noise::{Autoregression, robust_deviation};
use crate::model::Output;
use crate::record::quality::quantum;
use crate::units::figure;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Highest order of the noise.
const ORDER: usize = 12;
/// Samples over which a step is followed.
const FOLLOWED: usize = 32;
/// Samples before a step at which an outlier may be heard; after it, wherever it is followed.
const BESIDE: usize = 2;
/// Steps of time from a sample to the next that are bridged.
const JOINED: usize = 4;
/// Fewest samples whose distribution has a tail, and whose memory can be told.
const FEWEST: usize = 100;
/// The share of innovations above which their tail is measured, both signs.
const TAIL: f64 = 0.02;
/// Degrees of freedom of Student's t, from heaviest to that of normal noise.
const DEGREES: (f64, f64) = (1.0, 200.0);

/// Contiguous samples of a residual.
#[derive(Default)]
pub struct Stretch {
    /// s
    pub time: Vec<f64>,
    /// Measured less predicted, SI.
    pub residual: Vec<f64>,
}

/// A step of the level of a residual.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelShift {
    /// s
    pub at: f64,
    /// How far the level moves, SI.
    pub size: f64,
    /// Chance of one so large among all moments.
    pub p_value: f64,
}

/// Why a residual is not noise.
pub enum Unlike {
    /// Its level steps: output and step.
    Steps(usize, LevelShift),
    /// Some of its samples stand apart: output and samples.
    Strays(usize, Stray),
    /// It forgets too slowly: output and number of independent values.
    Slow(usize, f64),
}

impl Unlike {
    /// The output whose residual steps, or has samples that stand apart.
    pub fn output(&self) -> Option<usize> {
        if let Self::Steps(k, _) | Self::Strays(k, _) = self { Some(*k) } else { None }
    }

    /// Whether its level steps.
    pub fn is_step(&self) -> bool {
        matches!(self, Self::Steps(..))
    }

    /// Chance that noise is so.
    pub fn p_value(&self) -> f64 {
        match self {
            Self::Steps(_, step) => step.p_value,
            Self::Strays(_, strays) => strays.p_value,
            Self::Slow(..) => 1.0,
        }
    }

    /// In words; `rmse` by output, SI.
    pub fn says(&self, outputs: &[Output], rmse: &[f64]) -> String {
        let shown = |k: usize, x: f64| {
            let unit = outputs[k].unit.of_differences();
            words::quantity(unit.difference_from_si(x), unit.text())
        };
        match self {
            Self::Steps(k, s) => format!(
                "the level of what the model leaves over of “{}” steps by {} at {} s, as noise of its colour does not",
                outputs[*k].name,
                shown(*k, s.size),
                figure(s.at)
            ),
            Self::Strays(k, s) => format!(
                "{} samples of “{}” stand apart from the noise of all others, far beyond what noise with heavy tails does: outliers, or something that acts now and then; look at what the model leaves over there",
                s.count, outputs[*k].name
            ),
            Self::Slow(k, values) => format!(
                "what the model leaves over of “{}”, {}, changes so slowly that the fitted part holds no more than {} independent values of it, and noise so slow cannot be told from something missing",
                outputs[*k].name,
                shown(*k, rmse[*k]),
                figure(values.ceil())
            ),
        }
    }
}

/// Whether what a fit leaves, and what it leaves of what was held out, is no noise.
pub fn unlike_noise(bench: &Bench, fit: &Fit, held: &[Held]) -> Option<Unlike> {
    if bench.is_trials() {
        return None;
    }
    let outputs = fit.model.outputs.len();
    let looked: Vec<Looked> = (0..outputs).map(|k| look(bench, fit, held, k)).collect();
    let steps = looked.iter().enumerate().filter_map(|(k, l)| Some((k, l.step?)));
    let surest = steps.min_by(|a, b| a.1.p_value.total_cmp(&b.1.p_value));
    if let Some((k, step)) = surest {
        // Every output was looked at twice: fitted and held out.
        let p_value = (2.0 * outputs as f64 * step.p_value).min(1.0);
        if p_value < SURE {
            return Some(Unlike::Steps(k, LevelShift { p_value, ..step }));
        }
    }
    let strays = looked.iter().enumerate().filter_map(|(k, l)| Some((k, l.strays?)));
    if let Some((k, strays)) = strays.min_by(|a, b| a.1.p_value.total_cmp(&b.1.p_value)) {
        let p_value = (outputs as f64 * strays.p_value).min(1.0);
        if p_value < SURE {
            return Some(Unlike::Strays(k, Stray { p_value, ..strays }));
        }
    }
    let slow = looked.iter().enumerate().filter_map(|(k, l)| Some((k, l.values?)));
    let slowest = slow.min_by(|a, b| a.1.total_cmp(&b.1));
    slowest.filter(|s| agree_by_luck(s.1 as usize)).map(|s| Unlike::Slow(s.0, s.1))
}

/// The plainest step of the level of each output's residual in one recording, sure or not: a jump of the sensor's
/// zero would be such, and its own likelihood tells.
pub fn shifts(bench: &Bench, fit: &Fit) -> Vec<Shift> {
    if bench.is_trials() || bench.separate || fit.records.len() != 1 {
        return Vec::new();
    }
    let of = |(k, output): (usize, &Output)| {
        let floor = floor(bench, &output.name);
        let own = stretches(fit, k);
        let views: Vec<&[f64]> = own.iter().map(|s| &s.residual[..]).collect();
        if views.concat().len() < FEWEST || fit.rmse[k] <= floor {
            return None;
        }
        let step = level_shift(&own, &Autoregression::fit(&views, ORDER), floor)?;
        let before = own.iter().flat_map(|s| &s.time).copied().filter(|t| *t < step.at).reduce(f64::max)?;
        Some(Shift { output: output.name.clone(), between: (before, step.at), size: step.size })
    };
    fit.model.outputs.iter().enumerate().filter_map(of).collect()
}

/// The residual of an output of a fit, stretch by stretch.
fn stretches(fit: &Fit, output: usize) -> Vec<Stretch> {
    let series = fit.records.iter().flat_map(|r| &r.series).filter(|s| s.output == output);
    let parts = |s: &Series| joined(s.stretches.iter().map(|r| (&s.time[r.clone()], &s.residual[r.clone()])));
    series.flat_map(parts).collect()
}

/// What is seen of an output.
#[derive(Default)]
struct Looked {
    /// Its plainest step.
    step: Option<LevelShift>,
    /// What of its fitted part stands apart.
    strays: Option<Stray>,
    /// How many independent values its fitted part has.
    values: Option<f64>,
}

fn look(bench: &Bench, fit: &Fit, held: &[Held], k: usize) -> Looked {
    let own = stretches(fit, k);
    let samples: usize = own.iter().map(|s| s.residual.len()).sum();
    let floor = floor(bench, &fit.model.outputs[k].name);
    if samples < FEWEST || fit.rmse[k] <= floor {
        return Looked::default();
    }
    let views: Vec<&[f64]> = own.iter().map(|s| &s.residual[..]).collect();
    let noise = Autoregression::fit(&views, ORDER);
    let later = held.get(k).map_or_else(Vec::new, |h| {
        joined(h.time.iter().zip(&h.residual).map(|(time, residual)| (&time[..], &residual[..])))
    });
    let (innovations, scale) = innovations(&own, &noise, floor);
    let strays = stray(&innovations.concat(), scale);
    let steps = [own, later].into_iter().filter_map(|all| level_shift(&all, &noise, floor));
    let plainest = steps.min_by(|a, b| a.p_value.total_cmp(&b.p_value));
    Looked { step: plainest, strays, values: Some(independent_values(&noise)) }
}

/// Stretches, joined where next to nothing is missing between them: a sample that was masked hides no step.
fn joined<'a>(parts: impl Iterator<Item = (&'a [f64], &'a [f64])>) -> Vec<Stretch> {
    let mut all: Vec<Stretch> = Vec::new();
    for (time, residual) in parts.filter(|p| !p.0.is_empty()) {
        let step = time.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
        let follows = |s: &&mut Stretch| {
            s.time.last().is_some_and(|last| (0.0..(JOINED as f64 + 0.5) * step).contains(&(time[0] - last)))
        };
        match all.last_mut().filter(follows) {
            Some(s) => {
                s.time.extend(time);
                s.residual.extend(residual);
            }
            None => all.push(Stretch { time: time.to_vec(), residual: residual.to_vec() }),
        }
    }
    all
}

/// What an output does not resolve, SI: its quantum, or the simulator's error.
fn floor(bench: &Bench, output: &str) -> f64 {
    let channels = bench.recordings.iter().filter_map(|r| r.find(output));
    let step = channels.filter_map(quantum).fold(0.0, f64::max);
    step.max(bench.tolerance * bench.spread(output))
}

/// n S₀/S(0): independent values in the samples that a noise model was estimated from.
fn independent_values(noise: &Autoregression) -> f64 {
    noise.samples() as f64 * noise.variance() / noise.density(0.0)
}

/// The innovations of each stretch, and their robust deviation, no finer than `floor`, SI.
fn innovations(stretches: &[Stretch], noise: &Autoregression, floor: f64) -> (Vec<Vec<f64>>, f64) {
    let each: Vec<Vec<f64>> = stretches.iter().map(|s| noise.whiten(&s.residual)).collect();
    let scale = robust_deviation(&each.concat()).max(floor / noise.innovation_variance().sqrt());
    (each, scale)
}

/// The plainest step of the level of a residual, whose innovations are no finer than `floor`, SI.
pub fn level_shift(stretches: &[Stretch], noise: &Autoregression, floor: f64) -> Option<LevelShift> {
    let (innovations, scale) = innovations(stretches, noise, floor);
    let all = innovations.concat();
    if all.len() < FEWEST || all.iter().any(|e| !e.is_finite()) {
        return None;
    }
    let deviation = noise.innovation_variance().sqrt();
    let (outlier, step) = filters(noise);
    let mut plainest: Option<(f64, LevelShift)> = None;
    for (stretch, e) in stretches.iter().zip(&innovations) {
        let outliers: Vec<f64> = (0..e.len()).map(|t| matched(&outlier, &e[t..]).0.abs()).collect();
        for t in 1..e.len() {
            let (z, size) = matched(&step, &e[t..]);
            let beside = &outliers[t.saturating_sub(BESIDE)..(t + FOLLOWED).min(e.len())];
            let is_step = beside.iter().all(|o| *o < z.abs());
            if is_step && plainest.is_none_or(|(most, _)| z.abs() > most) {
                let size = size * deviation;
                plainest = Some((z.abs(), LevelShift { at: stretch.time[t], size, p_value: 1.0 }));
            }
        }
    }
    let (z, shift) = plainest?;
    let tail = StudentsT::new(0.0, 1.0, degrees(&all)).ok()?;
    Some(LevelShift { p_value: (2.0 * all.len() as f64 * tail.sf(z / scale)).min(1.0), ..shift })
}

/// What an outlier and a step of size 1 become in the innovations: π = (1, −φ₁, −φ₂, …) and its sums.
fn filters(noise: &Autoregression) -> (Vec<f64>, Vec<f64>) {
    let outlier: Vec<f64> = std::iter::once(1.0).chain(noise.coefficients().iter().map(|a| -a)).collect();
    let mut sum = 0.0;
    let padded = outlier.iter().copied().chain(std::iter::repeat(0.0)).take(FOLLOWED);
    let step = padded.map(|p| {
        sum += p;
        sum
    });
    (outlier.clone(), step.collect())
}

/// A filter against what follows: g·e/‖g‖, and the size g·e/‖g‖² of what it is for.
fn matched(filter: &[f64], innovations: &[f64]) -> (f64, f64) {
    let pairs = filter.iter().zip(innovations);
    let (along, square) = pairs.fold((0.0, 0.0), |(a, s), (g, e)| (a + g * e, s + g * g));
    (along / square.sqrt(), along / square)
}

/// Degrees of freedom ν of the Student's t whose tail stands to its middle as that of the innovations does:
/// t_ν(1 − TAIL/2)/t_ν(3/4), which falls with ν.
fn degrees(innovations: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = innovations.iter().map(|e| e.abs()).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    let at = |share: f64| sizes[((sizes.len() - 1) as f64 * share).round() as usize];
    let wanted = at(1.0 - TAIL) / at(0.5);
    let ratio = |degrees: f64| {
        StudentsT::new(0.0, 1.0, degrees)
            .map_or(f64::NAN, |t| t.inverse_cdf(1.0 - 0.5 * TAIL) / t.inverse_cdf(0.75))
    };
    let (mut heavy, mut light) = DEGREES;
    for _ in 0..30 {
        let middle = (heavy * light).sqrt();
        if ratio(middle) > wanted { heavy = middle } else { light = middle }
    }
    // Where the middle is no more than the resolution the tail cannot be told: the heaviest.
    if wanted.is_finite() { light } else { DEGREES.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_distr::{Distribution, Exp1, StandardNormal};

    /// An autoregression of lag-one correlation φ and unit deviation from innovations of unit deviation.
    fn coloured(innovations: &[f64], phi: f64) -> Vec<f64> {
        let mut y = 0.0;
        let next = |e: &f64| {
            y = phi * y + (1.0 - phi * phi).sqrt() * e;
            y
        };
        innovations.iter().map(next).collect()
    }

    fn normal(n: usize, seed: u64) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        (0..n).map(|_| StandardNormal.sample(&mut rng)).collect()
    }

    /// Two-sided exponential innovations of unit deviation, whose tails are heavy.
    fn exponential(n: usize, seed: u64) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
        let mut draw = || -> f64 { Exp1.sample(&mut rng) };
        (0..n).map(|_| (draw() - draw()) / 2f64.sqrt()).collect()
    }

    /// The plainest step; where there is none at all, one that noise would do.
    fn shift(y: &[f64]) -> LevelShift {
        let time: Vec<f64> = (0..y.len()).map(|i| i as f64).collect();
        let stretch = [Stretch { time, residual: y.to_vec() }];
        let none = LevelShift { at: 0.0, size: 0.0, p_value: 1.0 };
        level_shift(&stretch, &Autoregression::fit(&[y], ORDER), 0.0).unwrap_or(none)
    }

    #[test]
    fn noise_of_any_colour_and_of_heavy_tails_has_no_step() {
        let (mut steps, mut slow) = (0, 0);
        for seed in 0..60 {
            for phi in [0.0, 0.5, 0.9] {
                for e in [normal(900, seed), exponential(900, 1000 + seed)] {
                    let y = coloured(&e, phi);
                    steps += usize::from(shift(&y).p_value < SURE);
                    slow += usize::from(agree_by_luck(
                        independent_values(&Autoregression::fit(&[&y], ORDER)) as usize,
                    ));
                }
            }
        }
        // 360 at a level of 0.001.
        assert!(steps <= 1 && slow == 0, "{steps} {slow}");
    }

    #[test]
    fn a_step_and_a_square_wave_are_seen_at_their_place_and_with_their_size() {
        for phi in [0.0, 0.5, 0.9] {
            let mut y: Vec<f64> = coloured(&normal(900, 3), phi);
            y[400..].iter_mut().for_each(|y| *y += 12.0);
            let s = shift(&y);
            assert!(s.p_value < 1e-6 && s.at == 400.0 && (s.size - 12.0).abs() < 2.0, "{phi} {s:?}");
            let wave: Vec<f64> = coloured(&normal(900, 4), phi)
                .iter()
                .enumerate()
                .map(|(i, y)| y + 15.0 * f64::from(i % 200 < 100))
                .collect();
            let s = shift(&wave);
            assert!(
                s.p_value < SURE && s.at % 100.0 == 0.0 && (s.size.abs() - 15.0).abs() < 3.0,
                "{phi} {s:?}"
            );
        }
    }

    #[test]
    fn a_single_sample_far_off_is_no_step() {
        for phi in [0.0, 0.9] {
            let mut y = coloured(&normal(900, 5), phi);
            y[300] += 20.0;
            y[700] -= 25.0;
            let s = shift(&y);
            assert!(s.p_value > SURE, "{phi} {s:?}");
        }
    }

    /// n (1 − φ)/(1 + φ) independent values of an autoregression of order one.
    #[test]
    fn slow_noise_has_few_independent_values() {
        let ar = Autoregression::fit(&[&coloured(&normal(20_000, 6), 0.9)], 1);
        let wanted = 20_000.0 * 0.1 / 1.9;
        assert!(
            (independent_values(&ar) / wanted - 1.0).abs() < 0.15,
            "{} {wanted}",
            independent_values(&ar)
        );
        let fading: Vec<f64> =
            normal(600, 7).iter().enumerate().map(|(i, e)| e + 40.0 * (-(i as f64) / 200.0).exp()).collect();
        assert!(agree_by_luck(independent_values(&Autoregression::fit(&[&fading], ORDER)) as usize));
    }

    /// A sample at the step is masked, as an outlier would be.
    #[test]
    fn a_masked_sample_hides_no_step() {
        let mut y = coloured(&normal(900, 8), 0.5);
        y[400..].iter_mut().for_each(|y| *y += 12.0);
        let time: Vec<f64> = (0..900).map(f64::from).collect();
        let parts = [(&time[..400], &y[..400]), (&time[401..600], &y[401..600]), (&time[700..], &y[700..])];
        let all = joined(parts.into_iter());
        assert_eq!(all.iter().map(|s| s.time.len()).collect::<Vec<_>>(), [599, 200]);
        let views: Vec<&[f64]> = all.iter().map(|s| &s.residual[..]).collect();
        let s = level_shift(&all, &Autoregression::fit(&views, ORDER), 0.0).unwrap();
        assert!(s.p_value < 1e-6 && s.at == 401.0, "{s:?}");
    }

    /// Values that move by a step of their resolution are as fine as they can be.
    #[test]
    fn a_step_of_the_resolution_is_none() {
        let y: Vec<f64> = (0..900).map(|i| f64::from((i / 150) % 2) * 0.01).collect();
        let time: Vec<f64> = (0..900).map(f64::from).collect();
        let stretch = [Stretch { time, residual: y.clone() }];
        let s = level_shift(&stretch, &Autoregression::fit(&[&y], ORDER), 0.01);
        assert!(s.is_none_or(|s| s.p_value > SURE), "{s:?}");
    }
}
