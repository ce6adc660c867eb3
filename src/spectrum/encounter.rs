//! # Purpose
//! The slopes and the height of a sea's waves as a ship under way meets them.
//!
//! # Method
//! A wave of frequency ω and number k = ω²/g (deep water) from the bearing ν off the bow is met, at the speed V, with
//! the frequency ω_e = ω + (ω²V/g) cos ν. The sea is cut into cells of ω and of direction, and the power of each goes
//! into bins of |ω_e| as it is. No Jacobian dω/dω_e is formed: where it has its singularity, at ω = −g/(2V cos ν) of a
//! following sea, the power of a bin is finite; and where one ω_e is that of three waves their powers add up. A wave
//! that the ship overtakes, ω_e < 0, she meets with |ω_e|: its slopes athwart and along keep their ratio at each
//! moment, and the cross-spectrum of the two is real throughout.
//!
//! Waves from many directions have the density D(θ) ∝ cosⁿ(θ − θ₀) within 90° of the main one.
//!
//! # References
//! M. St. Denis, W. J. Pierson, Trans. SNAME 61 (1953) 280–357; W. G. Price, R. E. D. Bishop, Probabilistic Theory of
//! Ship Dynamics (Chapman and Hall 1974); cosⁿ as in DNV-RP-C205.
//!
//! # Numerical aspects
//! Cells run from 0.3 to 12 times the frequency of the peak, below which exp(−1.25 (ω_p/ω)⁴) leaves nothing. The bins
//! end where the given part of the slope's rate has been met.

use super::sea::GRAVITY;
use super::{Hull, Sea};
use crate::{Error, Result};
use std::f64::consts::PI;

/// A sea, where it comes from, and how fast a ship goes through it.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `from` | ν, main bearing off the bow, clockwise: 0 ahead | rad |
/// | `speed` | V, through the water | m/s |
/// | `spread` | n of cosⁿ about the main direction | 1 |
///
/// ```
/// use gyrospec::spectrum::{Encounter, Hull, Sea};
/// let sea = Sea::Bretschneider { height: 3.0, peak: 0.8 };
/// let met = |speed| Encounter { sea, from: 0.0, speed, spread: None }.slopes(&Hull::default(), 500, 0.999);
/// // head waves are met more often, with the same power
/// assert!(met(8.0)?.step > 1.2 * met(0.0)?.step);
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Encounter {
    /// The sea.
    pub sea: Sea,
    /// ν, rad.
    pub from: f64,
    /// V, m/s.
    pub speed: f64,
    /// n; `None` for a sea whose crests are long.
    pub spread: Option<f64>,
}

/// Densities over equal bins of the frequency of encounter, from 0 on: two-sided, K(0) = (1/π) ∫₀^∞ S dω_e.
#[derive(Debug, Clone)]
pub struct SlopeSpectrum {
    /// Width of a bin, rad/s.
    pub step: f64,
    /// Of the mean slope athwart and of that along the ship, their cross-spectrum (rad²·s), and of the mean height
    /// (m²·s).
    pub bins: Vec<[f64; 4]>,
}

/// Cells of frequency, and the first and the last, in parts of the peak's.
const CELLS: usize = 2000;
const ENDS: [f64; 2] = [0.3, 12.0];
/// Directions of a sea that has many, 2° apart.
const DIRECTIONS: usize = 90;

/// A cell: frequencies of encounter and the variances of athwart, along, their product, and height.
struct Cell {
    met: [f64; 2],
    power: [f64; 4],
}

impl Encounter {
    /// What the ship meets, averaged over her waterplane, in so many bins that hold `part` of the slope's rate.
    ///
    /// # Errors
    /// `BadInput` for numbers that are no sea, ship or spread.
    pub fn slopes(&self, hull: &Hull, bins: usize, part: f64) -> Result<SlopeSpectrum> {
        self.averaged(hull, (bins, part), |bearing| Box::new(hull.keeps(bearing)))
    }

    /// The same averaged over a rectangle with its zeros.
    ///
    /// # Errors
    /// As [`Encounter::slopes`].
    pub fn slopes_of_rectangle(&self, hull: &Hull, bins: usize, part: f64) -> Result<SlopeSpectrum> {
        self.averaged(hull, (bins, part), |bearing| Box::new(hull.keeps_of_rectangle(bearing)))
    }

    fn averaged(
        &self,
        hull: &Hull,
        (bins, part): (usize, f64),
        keeps: impl Fn(f64) -> Box<dyn Fn(f64) -> f64>,
    ) -> Result<SlopeSpectrum> {
        self.sea.check()?;
        hull.check()?;
        if !self.spread.is_none_or(|n| n.is_finite() && n >= 1.0) || !self.speed.is_finite() {
            return Err(Error::bad_input(
                "the spread of a sea, n of cosⁿ, is 1 or more, and a speed is finite",
            ));
        }
        let cells = self.cells(keeps);
        let step = end(&cells, part) / bins as f64;
        Ok(SlopeSpectrum { step, bins: filled(&cells, step, bins) })
    }

    /// Bearings, rad, and the part of the sea that comes from each.
    fn directions(&self) -> Vec<(f64, f64)> {
        let Some(n) = self.spread else { return vec![(self.from, 1.0)] };
        let away = |i: usize| ((i as f64 + 0.5) / DIRECTIONS as f64 - 0.5) * PI;
        // D ∝ cosⁿ(θ − θ₀), |θ − θ₀| < π/2
        let density = |i: usize| away(i).cos().powf(n);
        let all: f64 = (0..DIRECTIONS).map(density).sum();
        (0..DIRECTIONS).map(|i| (self.from + away(i), density(i) / all)).collect()
    }

    fn cells(&self, keeps: impl Fn(f64) -> Box<dyn Fn(f64) -> f64>) -> Vec<Cell> {
        let ratio = (ENDS[1] / ENDS[0]).ln() / CELLS as f64;
        let edge = |k: usize| ENDS[0] * self.sea.peak() * (k as f64 * ratio).exp();
        // (1/π) S dω
        let variance =
            |k: usize| self.sea.density((edge(k) * edge(k + 1)).sqrt()) * (edge(k + 1) - edge(k)) / PI;
        let variances: Vec<f64> = (0..CELLS).map(variance).collect();
        let mut all = Vec::new();
        for (bearing, share) in self.directions() {
            let (keeps, (athwart, along)) = (keeps(bearing), Hull::slopes(bearing));
            // ω_e = ω + (ω²V/g) cos ν
            let met = |w: f64| w + w * w * self.speed * along / GRAVITY;
            for (k, variance) in variances.iter().enumerate() {
                let fourth = (edge(k) * edge(k + 1)).powi(2);
                let height = share * variance * keeps(fourth);
                // (ω²/g)²
                let slope = height * fourth / (GRAVITY * GRAVITY);
                let power = [athwart * athwart, along * along, athwart * along].map(|x| slope * x);
                let power = [power[0], power[1], power[2], height];
                all.push(Cell { met: [met(edge(k)), met(edge(k + 1))], power });
            }
        }
        all
    }
}

/// The frequency below which `part` of the slope's rate is met.
fn end(cells: &[Cell], part: f64) -> f64 {
    let last = cells.iter().flat_map(|c| c.met).fold(0.0f64, |m, w| m.max(w.abs()));
    let step = last / CELLS as f64;
    let rates: Vec<f64> = filled(cells, step, CELLS)
        .iter()
        .enumerate()
        .map(|(k, s)| ((k as f64 + 0.5) * step).powi(2) * (s[0] + s[1]))
        .collect();
    let whole: f64 = rates.iter().sum();
    let mut met = 0.0;
    let reached = rates.iter().position(|r| {
        met += r;
        met >= part * whole
    });
    reached.map_or(last, |k| (k + 1) as f64 * step)
}

/// The densities over the bins: each cell spread evenly between its ends.
fn filled(cells: &[Cell], step: f64, count: usize) -> Vec<[f64; 4]> {
    let mut bins = vec![[0.0; 4]; count];
    for cell in cells {
        let [a, b] = cell.met;
        let high = a.abs().max(b.abs());
        let low = if a * b <= 0.0 { 0.0 } else { a.abs().min(b.abs()) };
        let (first, last) = ((low / step) as usize, (high / step) as usize);
        for (k, bin) in bins.iter_mut().enumerate().take(last + 1).skip(first) {
            let inside = high.min((k + 1) as f64 * step) - low.max(k as f64 * step);
            let share = if high > low { inside / (high - low) } else { 1.0 };
            (0..4).for_each(|i| bin[i] += share * cell.power[i] * PI / step);
        }
    }
    bins
}

impl SlopeSpectrum {
    /// The middle of a bin, rad/s.
    pub fn omega(&self, bin: usize) -> f64 {
        (bin as f64 + 0.5) * self.step
    }

    /// The density of c₁·athwart + c₂·along times that of d₁·athwart + d₂·along in a bin, rad²·s.
    pub fn cross(&self, bin: usize, c: [f64; 2], d: [f64; 2]) -> f64 {
        let [athwart, along, both, _] = self.bins[bin];
        c[0] * d[0] * athwart + c[1] * d[1] * along + (c[0] * d[1] + c[1] * d[0]) * both
    }

    /// The direction (athwart, along) of which most is met under a weight, and that at right angles to it: the two
    /// are uncorrelated over all.
    pub fn axes(&self, weight: impl Fn(f64) -> f64) -> [[f64; 2]; 2] {
        let mut sums = [0.0; 3];
        for (k, bin) in self.bins.iter().enumerate() {
            (0..3).for_each(|i| sums[i] += weight(self.omega(k)) * bin[i]);
        }
        // tan 2χ = 2 S_al/(S_aa − S_ll)
        let angle = 0.5 * (2.0 * sums[2]).atan2(sums[0] - sums[1]);
        let clean = |x: f64| if x.abs() < 1e-9 { 0.0 } else { x };
        let (sin, cos) = angle.sin_cos();
        [[clean(cos), clean(sin)], [clean(-sin), clean(cos)]]
    }

    /// Frequency, width and bin of points that resolve a resonance too, rad/s.
    pub fn points(&self, frequency: f64, damping: f64) -> Vec<(f64, f64, usize)> {
        let half = damping * frequency;
        let mut all = Vec::new();
        for k in 0..self.bins.len() {
            let near = (self.omega(k) - frequency).abs() < 10.0 * half + self.step;
            let parts = if near { (4.0 * self.step / half).ceil().clamp(1.0, 1000.0) } else { 1.0 };
            let width = self.step / parts;
            all.extend(
                (0..parts as usize).map(|i| (k as f64 * self.step + (i as f64 + 0.5) * width, width, k)),
            );
        }
        all
    }

    /// How much is met at hardly any frequency, a part of the highest density of the slope.
    pub fn at_rest(&self) -> f64 {
        let slope = |k: usize| self.bins[k][0] + self.bins[k][1];
        let highest = (0..self.bins.len()).map(slope).fold(0.0, f64::max);
        if highest > 0.0 { slope(0) / highest } else { 0.0 }
    }
}
