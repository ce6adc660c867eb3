//! Lines of what is left over a position: forces that repeat with it, at any number of periods.
//!
//! # Purpose
//! The angular frequencies in space from which a force that repeats with a position is started. Over many turns of a
//! shaft the score has a maximum at each of thousands of frequencies, each no wider than a turn over the whole way; a few
//! guesses find none of them.
//!
//! # Method
//! The response read backwards says how much a force at each moment would explain. Gathered over the position on a fine
//! grid, its periodogram is the numerator of the score of every frequency at once; the denominator, which changes slowly,
//! is found at a few frequencies. The residual is whitened by its nearest neighbour alone: an autoregression of higher order
//! takes the line of a steady motion for colour. The position is the measured one: a force is met in another phase where the
//! model is a little off.
//!
//! # References
//! A. E. Bryson, Y.-C. Ho, Applied Optimal Control (1975), 2.3; S. Kay, Fundamentals of Statistical Signal Processing I
//! (1993), example 4.2.

use super::bench::{Bench, Track};
use super::catalogue::{Motion, Scene};
use super::locate::powers;
use super::response::Response;
use super::screen::Screen;
use super::view::{View, own_tracks};
use crate::estimate::Fit;
use crate::estimate::noise::NoiseModel;
use std::collections::BTreeMap;
use std::f64::consts::{LN_2, PI};

/// Periods over the whole position from which on a force is looked for here; fewer are started from a few guesses.
const TURNS: f64 = 20.0;
/// Lines that are kept over one position.
const KEPT: usize = 3;
/// Lines whose score is found exactly, those of them around which it is, and steps to either side at which it is.
const TRIED: usize = 40;
const REFINED: usize = 6;
const STEPS: i32 = 3;
/// −ln of the chance that the largest of so many scores of noise, spread about their median, is a line.
const SURER: f64 = 3.0;
/// Share of the largest score that another line must reach.
const HALF: f64 = 0.5;
/// Frequencies at which the denominator is found.
const KNOWN: usize = 16;
/// Frequencies that are looked at for each that the whole way tells apart, at least.
const FINER: usize = 2;
/// Cells of the grid for the shortest period that the samples resolve.
const CELLS: f64 = 8.0;
/// Cells at most.
const MOST: f64 = 1_048_576.0;

/// By the state that a force would act on, angular frequencies in its position at which something is left, per unit of
/// the position.
pub fn over_positions(
    bench: &Bench,
    scene: &Scene,
    (fit, view): (&Fit, &View),
) -> BTreeMap<String, Vec<f64>> {
    let turning: Vec<Motion> = scene.motions().into_iter().filter(|m| m.speed.is_some()).collect();
    let looked = || Some((view.fine(bench)?, view.response.as_ref()?, open(fit, view)?));
    let Some((fine, smooth, open)) = (!turning.is_empty()).then(looked).flatten() else {
        return BTreeMap::new();
    };
    let of = |m: Motion| {
        let courses = (fine.course(m.position.as_ref()?)?, smooth.course(m.position.as_ref()?)?);
        let lines = Place::of(fine, &open, &m.state, courses)?.lines(&view.tracks)?;
        Some((m.state, lines))
    };
    turning.into_iter().filter_map(of).collect()
}

/// The screening space in which each output's residual is whitened by its nearest neighbour alone.
fn open(fit: &Fit, view: &View) -> Option<Screen> {
    let own = own_tracks(fit, &view.tracks).ok()?;
    let of = |output: usize| {
        let tracks = own.iter().filter(|t| t.output == output);
        let stretches: Vec<&[f64]> =
            tracks.flat_map(|t| t.stretches.iter().map(|r| &t.residual[r.clone()])).collect();
        NoiseModel::of_neighbours(&stretches)
    };
    let noise: Vec<NoiseModel> = (0..fit.noise.len()).map(of).collect();
    Some(Screen::new(&own, &noise, None))
}

/// A position, and a grid over it.
struct Place<'v> {
    response: &'v Response,
    open: &'v Screen,
    state: &'v str,
    /// Where it was, run by run.
    course: Vec<Vec<f64>>,
    first: f64,
    /// Width of a cell.
    width: f64,
    cells: usize,
}

impl<'v> Place<'v> {
    /// A grid that shows every period which the samples resolve at the mean speed; of the courses that were measured
    /// and simulated, for the way of the first is longer by its noise.
    fn of(
        response: &'v Response,
        open: &'v Screen,
        state: &'v str,
        (course, smooth): (Vec<Vec<f64>>, Vec<Vec<f64>>),
    ) -> Option<Self> {
        let all = || course.iter().flatten().copied();
        let (first, last) = (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
        let path: f64 = smooth.iter().flat_map(|q| q.windows(2)).map(|w| (w[1] - w[0]).abs()).sum();
        let shortest = 2.0 * path / open.residual.len() as f64;
        let cells = (CELLS * (last - first) / shortest).min(MOST);
        let width = (last - first) / cells;
        let own = Self { response, open, state, course, first, width, cells: cells as usize + 2 };
        (width > 0.0 && cells > CELLS * TURNS).then_some(own)
    }

    /// The frequencies of the largest scores.
    fn lines(&self, tracks: &[Track]) -> Option<Vec<f64>> {
        let (power, unit, few) = self.periodogram(tracks)?;
        let energies = self.energies((few as f64 * unit, power.len() as f64 * unit))?;
        let energy = |k: usize| between(&energies, k as f64 * unit);
        let score: Vec<f64> = power.iter().enumerate().map(|(k, p)| p / energy(k)).collect();
        let exact = |n: f64| Some((n, self.open.score(&self.directions(n)?, false)?.chi2));
        let by_score = |a: &(f64, f64), b: &(f64, f64)| b.1.total_cmp(&a.1);
        let mut found: Vec<(f64, f64)> = highest(&score, few, unit).into_iter().filter_map(exact).collect();
        found.sort_by(by_score);
        let around = |n: f64| (-STEPS..=STEPS).map(move |k| n + f64::from(k) * unit / f64::from(STEPS));
        let finer = |f: (f64, f64)| around(f.0).filter_map(exact).min_by(by_score);
        let mut found: Vec<(f64, f64)> = found.into_iter().take(REFINED).filter_map(finer).collect();
        found.sort_by(by_score);
        Some(found.into_iter().take(KEPT).map(|f| f.0).collect())
    }

    /// The directions W G sin nq and W G cos nq.
    fn directions(&self, n: f64) -> Option<Vec<Vec<f64>>> {
        let turned = |f: fn(f64) -> f64| move |q: &Vec<f64>| q.iter().map(|q| f(n * q)).collect::<Vec<f64>>();
        let forces = self.course.iter().map(|q| vec![turned(f64::sin)(q), turned(f64::cos)(q)]);
        let tracks = self.response.pushed(self.state, forces.collect())?;
        Some((0..2).map(|j| self.open.whitened(&tracks, |t| &t.sensitivities[j])).collect())
    }

    /// What is left over the position, by frequency in steps of a unit, with the number of the first that is looked at.
    fn periodogram(&self, tracks: &[Track]) -> Option<(Vec<f64>, f64, usize)> {
        let pulls = self.response.pulls(self.state, &self.open.weights(tracks))?;
        let mut gathered = self.gathered(&pulls);
        // no window: it would blur frequencies that the ends of the way tell apart
        gathered.resize((FINER * self.cells).next_power_of_two(), 0.0);
        let mut power = powers(gathered);
        let unit = PI / (power.len() as f64 * self.width);
        let few = (2.0 * TURNS * power.len() as f64 / self.cells as f64).ceil() as usize;
        // the grid is finer than the shortest period that is meant
        power.truncate((2.0 * power.len() as f64 / CELLS) as usize);
        (power.len() > 2 * few).then_some((power, unit, few))
    }

    /// The pulls gathered in cells, each shared by the two that it lies between.
    fn gathered(&self, pulls: &[Vec<f64>]) -> Vec<f64> {
        let mut gathered = vec![0.0; self.cells];
        for (q, pull) in self.course.iter().flatten().zip(pulls.iter().flatten()) {
            let at = (q - self.first) / self.width;
            let i = (at as usize).min(self.cells - 2);
            let share = at - i as f64;
            gathered[i] += (1.0 - share) * pull;
            gathered[i + 1] += share * pull;
        }
        gathered
    }

    /// ‖P W G sin nq‖² + ‖P W G cos nq‖² at frequencies n in equal ratios.
    fn energies(&self, (low, high): (f64, f64)) -> Option<Vec<(f64, f64)>> {
        let of = |i: usize| {
            let n = low * (high / low).powf(i as f64 / (KNOWN - 1) as f64);
            Some((n, self.open.energy(&self.directions(n)?)))
        };
        (0..KNOWN).map(of).collect()
    }
}

/// The highest maxima, those that are at least half as high as the first of them and rise from what lies around: scores of
/// noise have the distribution P(S > s) = 2^(−s/median), whatever its size.
fn highest(of: &[f64], first: usize, unit: f64) -> Vec<f64> {
    let is_top = |k: &usize| of[*k] >= of[k - 1] && of[*k] > of[k + 1];
    let mut tops: Vec<usize> = (first.max(1)..of.len().saturating_sub(1)).filter(is_top).collect();
    tops.sort_by(|a, b| of[*b].total_cmp(&of[*a]));
    let mut all = of[first..].to_vec();
    let middle = all.len() / 2;
    let median = *all.select_nth_unstable_by(middle, f64::total_cmp).1;
    let noise = median / LN_2 * ((all.len() as f64 / FINER as f64).ln() + SURER);
    let least = tops.first().map_or(0.0, |k| noise.max(HALF * of[*k]));
    let kept = tops.into_iter().take(TRIED).filter(|k| of[*k] >= least);
    kept.map(|k| (k as f64 + summit(&of[k - 1..k + 2])) * unit).collect()
}

/// A value between known ones, straight in logarithms.
fn between(known: &[(f64, f64)], at: f64) -> f64 {
    let i = known.partition_point(|k| k.0 < at).clamp(1, known.len() - 1);
    let ((a, x), (b, y)) = (known[i - 1], known[i]);
    let share = (at / a).ln() / (b / a).ln();
    (x.ln() + share * (y / x).ln()).exp().max(f64::MIN_POSITIVE)
}

/// Where the parabola through three equidistant values is largest, from the middle one.
fn summit(of: &[f64]) -> f64 {
    let bend = of[0] - 2.0 * of[1] + of[2];
    if bend < 0.0 { (0.5 * (of[0] - of[2]) / bend).clamp(-0.5, 0.5) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};

    /// Of courses of independent scores of noise one in ten may show a line; a score of some sixty times the median is one.
    #[test]
    fn a_line_rises_from_what_lies_around() {
        let mut shown = 0;
        for seed in 0..200 {
            let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
            let mut draw = || -1e3 * (1.0 - rng.random::<f64>()).ln();
            let mut score: Vec<f64> = (0..600).map(|_| draw()).collect();
            shown += usize::from(!highest(&score, 10, 1.0).is_empty());
            (score[399], score[400], score[401]) = (10e3, 40e3, 10e3);
            let found = highest(&score, 10, 1.0);
            assert!(found.first().is_some_and(|n| (n - 400.0).abs() < 0.5), "{found:?}");
        }
        // half of the scores of a periodogram are independent, here all: 200 × 2 e⁻³ = 20, ± 3 σ
        assert!((7..=33).contains(&shown), "{shown}");
    }
}
