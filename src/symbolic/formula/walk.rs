//! Values for which H is stable, where random ones are not.
//!
//! Purpose: points for the check of formulas with many letters; of random H of order 10 hardly one is stable.
//! Method: a random walk in the logarithms of the symbols. Until H is stable a step is taken if the coefficients come
//! closer to a sufficient condition, then if the least damped root becomes better damped; afterwards while it stays so.
//! References: A. V. Lipatov, N. I. Sokolov, Autom. Remote Control 39 (1979) 1285 (the sufficient condition).
//! Numerical aspects: roots guide the walk only; the engine decides on stability.

use super::derive::Source;
use super::sampler::{Sampler, Values};
use super::transfer::Numbers;
use crate::Result;
use crate::poly::roots::roots;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Steps of one search.
const MOST_STEPS: usize = 8_000;
/// Starts of the search, each at random values.
const STARTS: usize = 2;
/// Damping ratio of the least damped root at which the search ends, and that which the walk keeps.
const FOUND: f64 = 0.15;
const KEPT: f64 = 0.05;
/// The largest decade of a value.
const DECADES: f64 = 5.0;

/// A walk through values for which H is stable.
pub struct Walk<'a> {
    source: &'a Source,
    sampler: Sampler<'a>,
    names: Vec<String>,
    random: ChaCha8Rng,
    at: Option<Vec<f64>>,
}

impl<'a> Walk<'a> {
    /// A walk over the free names of a sampler.
    pub fn new(source: &'a Source, sampler: Sampler<'a>) -> Self {
        let names = sampler.free_in(&source.poles());
        Self { source, sampler, names, random: ChaCha8Rng::seed_from_u64(1895), at: None }
    }

    /// Whether H has letters whose values can be chosen.
    pub fn can_move(&self) -> bool {
        !self.names.is_empty()
    }

    /// The next stable point; none where none was found.
    ///
    /// # Errors
    /// Bad input, where relations contradict each other.
    pub fn next_stable(&mut self) -> Result<Option<Values>> {
        if !self.can_move() {
            return Ok(None);
        }
        if self.at.is_none() {
            for _ in 0..STARTS {
                if self.search()? {
                    break;
                }
            }
        }
        let Some(mut at) = self.at.clone() else { return Ok(None) };
        let mut step = 0.2;
        for _ in 0..200 {
            let next = self.moved(&at, step, false);
            match self.damping(&next)? {
                Some((damping, _)) if damping > KEPT => at = next,
                _ => step *= 0.7,
            }
            if step < 0.01 {
                break;
            }
        }
        self.at = Some(at.clone());
        Ok(self.damping(&at)?.map(|(_, values)| values))
    }

    /// Looks for a first point from random values; whether there is one.
    fn search(&mut self) -> Result<bool> {
        let start: Vec<f64> = self.names.iter().map(|_| self.random.random_range(-0.5..0.5)).collect();
        // a(k) a(k+1) > 1.4656 a(k−1) a(k+2) for all k is enough for stability: first that, then the damping itself
        let (at, _) =
            self.climbed(start, 0.0, |walk, at| Ok(walk.numbers(at)?.and_then(|(h, _)| spread(&h.a))))?;
        let (at, best) =
            self.climbed(at, FOUND, |walk, at| Ok(walk.damping(at)?.map(|(damping, _)| damping)))?;
        let found = best > KEPT;
        self.at = found.then_some(at);
        Ok(found)
    }

    /// Steps that make a quantity larger, until it is above `enough`.
    fn climbed(
        &mut self,
        start: Vec<f64>,
        enough: f64,
        of: impl Fn(&mut Self, &[f64]) -> Result<Option<f64>>,
    ) -> Result<(Vec<f64>, f64)> {
        let mut best = of(self, &start)?.unwrap_or(f64::NEG_INFINITY);
        let mut at = start;
        for _ in 0..MOST_STEPS {
            if best > enough {
                break;
            }
            let size = 10f64.powf(self.random.random_range(-2.0..0.3));
            let one = self.random.random_bool(0.5);
            let next = self.moved(&at, size, one);
            if let Some(value) = of(self, &next)?
                && value >= best
            {
                (at, best) = (next, value);
            }
        }
        Ok((at, best))
    }

    /// Logarithms moved by up to `size`, all of them or one.
    fn moved(&mut self, at: &[f64], size: f64, one: bool) -> Vec<f64> {
        let chosen = self.random.random_range(0..at.len());
        let mut next = at.to_vec();
        for (k, x) in next.iter_mut().enumerate() {
            if !one || k == chosen {
                *x = (*x + self.random.random_range(-size..size)).clamp(-DECADES, DECADES);
            }
        }
        next
    }

    /// H and G, and the values.
    fn numbers(&mut self, at: &[f64]) -> Result<Option<(Numbers, Values)>> {
        let fixed = self.names.iter().cloned().zip(at.iter().map(|x| 10f64.powf(*x))).collect();
        let Some(values) = self.sampler.draw(&fixed)? else { return Ok(None) };
        let numbers = Numbers::new(self.source, &values).ok();
        Ok(numbers.filter(|h| h.a.iter().all(|x| x.is_finite())).map(|h| (h, values)))
    }

    /// The damping ratio −Re r/|r| of the least damped root, and the values.
    fn damping(&mut self, at: &[f64]) -> Result<Option<(f64, Values)>> {
        let Some((Numbers { a, .. }, values)) = self.numbers(at)? else { return Ok(None) };
        let damping = roots(&a).into_iter().map(|r| -r.re / r.norm().max(f64::MIN_POSITIVE));
        let damping = damping.fold(f64::INFINITY, f64::min);
        Ok((!damping.is_nan()).then_some((damping, values)))
    }
}

/// Above 0 where the coefficients are so far apart that H is stable; smooth in their logarithms.
fn spread(a: &[f64]) -> Option<f64> {
    let sign = a[0].signum();
    let logs: Vec<f64> = a.iter().map(|x| (x * sign).ln()).collect();
    if !logs.iter().all(|x| x.is_finite()) {
        return None;
    }
    // Σ (1.6 a(k−1) a(k+2)/(a(k) a(k+1)))⁴
    let part = |l: &[f64]| (4.0 * (1.6f64.ln() + l[0] + l[3] - l[1] - l[2])).exp();
    let sum: f64 = logs.windows(4).map(part).sum();
    Some(1.0 - sum)
}
