//! # Purpose
//! The compass simulated in time, by its equations as they stand: a check of the moments that shares
//! nothing with them, and the only way where a part is not linear.
//!
//! # Method
//! (2.1) with M_y and, of the second order, the heavier pendulum, its longer arm and the turned heading:
//!
//! dα = (−U sin φ − v_E tan φ/R + (lP/H) β + (C/H) λ) dt + (lP/(Hg)) (dV₂ + β dV₃) + (C/(Hg)) λ dV₃
//!      + (P/H) z (β dt + dV₂/g)
//! dβ = (v_N/R − (U cos φ + v_E/R) α) dt + (P/(gH)) (x dV₂ − y dV₁)
//! dλ = −F(β + λ) dt − (F/g) dV₂
//!
//! with V the speeds whose rates are W; dV₂ of the rows of α and λ on the heading K + ψ. An integral
//! ∫ x dV is the trapezoid rule, whose values over single and double steps are extrapolated; the compass
//! steps by Heun's rule over the double step. The motion starts from its stationary state ([`Drive`]), the
//! compass from its rest and settles. Replicates give 99 % intervals by Student's t.
//!
//! # References
//! P. E. Kloeden, E. Platen, Numerical Solution of Stochastic Differential Equations, ch. 4.9.
//!
//! # Numerical aspects
//! The trapezoid rule is Stratonovich's mean of both sides where V holds a random walk. Extrapolated, the
//! mean of a product errs in the square of the step: by (ωh)²/3 at the frequency ω, and by (h/T)²/3 of
//! what a white tail adds through a lag T. Each replicate has a stream of its own of one seed, so the
//! numbers do not depend on the number of threads.

use super::elastic::InTime;
use super::instrument::{EARTH_RADIUS, Instrument};
use super::path::{Drive, Path, Sample};
use super::percentile::Shape;
use super::quantile::{Quantile, Replicates, interval};
use crate::{Error, Result};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Samples of α that a replicate keeps at most.
const SAMPLES: usize = 10_000;

/// How long and how often to simulate.
#[derive(Debug, Clone, Copy)]
pub struct MonteCarlo {
    /// Step, s; [`Drive::step`] proposes one.
    pub step: f64,
    /// Time kept of each replicate, s.
    pub duration: f64,
    /// Time for the compass to settle before, s.
    pub settle: f64,
    /// Replicates, each from a seed of its own; their scatter gives the intervals.
    pub runs: usize,
    /// Seed of all of them.
    pub seed: u64,
}

/// What the simulation gives for the heading error, with 99 % intervals.
#[derive(Debug, Clone, Copy)]
pub struct SimulatedError {
    /// Mean over time and replicates, rad.
    pub mean: f64,
    /// Half the width of its 99 % interval.
    pub mean_margin: f64,
    /// Mean square about the mean, rad².
    pub variance: f64,
    /// Half the width of its 99 % interval.
    pub variance_margin: f64,
    /// The percentiles of [`Shape::TOLD`], rad.
    pub percentiles: [Quantile; 4],
}

impl MonteCarlo {
    /// Simulates the compass on a heading (rad).
    ///
    /// # Errors
    /// `BadInput` for times or counts that are not positive; `OutOfRange` for a motion that has no such
    /// path; else as the covariance of the motion.
    pub fn run(&self, instrument: &Instrument, drive: &Drive, heading: f64) -> Result<SimulatedError> {
        let sound = self.step > 0.0 && self.duration > 2.0 * self.step && self.settle >= 0.0;
        if !(sound && self.duration.is_finite() && self.settle.is_finite()) || self.runs < 2 {
            return Err(Error::bad_input("a simulation needs a step, a longer duration and two replicates"));
        }
        instrument.check(heading)?;
        let compass = Compass::new(instrument, heading);
        let path = Path::new(instrument, drive, heading, self.step)?;
        let results: Vec<([f64; 2], Vec<f64>)> = (0..self.runs)
            .into_par_iter()
            .map(|replicate| {
                let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
                rng.set_stream(replicate as u64);
                let law = instrument.elastic.in_time(&instrument.sphere, self.step)?;
                Ok(self.replicate(&compass, Walk { path: path.clone(), law, compass: &compass }, &mut rng))
            })
            .collect::<Result<_>>()?;
        let (moments, samples): (Vec<_>, Vec<_>) = results.into_iter().unzip();
        let replicates = Replicates::new(samples);
        let percentiles = Shape::TOLD.map(|(part, _)| replicates.quantile(part));
        Ok(SimulatedError { percentiles, ..pooled(&moments, compass.rest[0]) })
    }

    /// Mean of α, and mean square of α about its value at rest; and samples of it.
    fn replicate(&self, compass: &Compass, mut walk: Walk<'_>, rng: &mut ChaCha8Rng) -> ([f64; 2], Vec<f64>) {
        let pairs = |time: f64| (0.5 * time / self.step).ceil() as usize;
        let (settling, keeping) = (pairs(self.settle), pairs(self.duration));
        let mut y = compass.rest;
        let (mut sum, mut squares) = (0.0, 0.0);
        let mut last = walk.path.begin(rng);
        let (apart, mut samples) = (keeping.div_ceil(SAMPLES), Vec::new());
        for k in 0..settling + keeping {
            let push = walk.pair(&mut last, rng);
            y = compass.step(y, &push, 2.0 * self.step);
            if k >= settling {
                sum += y[0];
                squares += (y[0] - compass.rest[0]).powi(2);
                if (k - settling) % apart == 0 {
                    samples.push(y[0]);
                }
            }
        }
        ([sum / keeping as f64, squares / keeping as f64], samples)
    }
}

/// What pushes the compass over a pair of steps.
#[derive(Default)]
struct Push {
    /// ∫ dV₂ on the heading K + ψ.
    meridian: f64,
    /// ∫ dV₃.
    vertical: f64,
    /// ∫ (x dV₂ − y dV₁).
    moment: f64,
    /// ∫ z dt and ∫ z dV₂.
    longer: [f64; 2],
}

/// The motion with the shift of the centre of mass.
struct Walk<'a> {
    path: Path,
    law: Option<Box<dyn InTime>>,
    compass: &'a Compass,
}

impl Walk<'_> {
    fn next(&mut self, before: &Sample, rng: &mut ChaCha8Rng) -> Sample {
        let mut now = self.path.next(rng);
        if let Some(law) = &mut self.law {
            let force = |s: &Sample| self.compass.mass * s.acceleration[0];
            law.advance(force(before), force(&now));
            now.shift[0] = law.shift();
        }
        now
    }

    /// Two steps on, from `last`, which is left at their end.
    fn pair(&mut self, last: &mut Sample, rng: &mut ChaCha8Rng) -> Push {
        let s0 = *last;
        let s1 = self.next(&s0, rng);
        let s2 = self.next(&s1, rng);
        *last = s2;
        let step = |a: &Sample, b: &Sample, i: usize| b.speed[i] - a.speed[i];
        // ½(f₀ + f₁) ΔV, over single steps twice less over the double step
        let product = |f: &dyn Fn(&Sample) -> f64, i: usize| {
            let rule = |a: &Sample, b: &Sample| 0.5 * (f(a) + f(b)) * step(a, b, i);
            2.0 * (rule(&s0, &s1) + rule(&s1, &s2)) - rule(&s0, &s2)
        };
        let z = [s0, s1, s2].map(|s| s.shift[2]);
        Push {
            // cos ψ dV₂ − sin ψ dV₁
            meridian: product(&|s| s.yaw.cos(), 1) - product(&|s| s.yaw.sin(), 0),
            vertical: step(&s0, &s2, 2),
            moment: product(&|s| s.shift[0], 1) - product(&|s| s.shift[1], 0),
            longer: [(z[0] + 4.0 * z[1] + z[2]) / 6.0, product(&|s| s.shift[2], 1)],
        }
    }
}

/// The compass's numbers on its heading.
struct Compass {
    /// m = P/g, kg.
    mass: f64,
    gravity: f64,
    /// lP/H, C/H, P/H.
    by_momentum: [f64; 3],
    flow: f64,
    /// U sin φ + v_E tan φ/R, U cos φ + v_E/R, v_N/R.
    turning: [f64; 3],
    rest: [f64; 3],
}

impl Compass {
    fn new(instrument: &Instrument, heading: f64) -> Self {
        let s = &instrument.sphere;
        let (north, east) = (instrument.speed * heading.cos(), instrument.speed * heading.sin());
        let (sin, cos) = s.latitude.sin_cos();
        let up = s.earth_rate * sin + east / EARTH_RADIUS * (sin / cos);
        let level = s.earth_rate * cos + east / EARTH_RADIUS;
        let by_momentum = [s.pendulous, s.damper, s.weight].map(|x| x / s.momentum);
        // λ = −β, (lP − C) β = H (U sin φ + v_E tan φ/R), α = v_N/(R (U cos φ + v_E/R))
        let tilt = up / (by_momentum[0] - by_momentum[1]);
        Self {
            mass: s.weight / s.gravity,
            gravity: s.gravity,
            by_momentum,
            flow: s.flow,
            turning: [up, level, north / EARTH_RADIUS],
            rest: [north / EARTH_RADIUS / level, tilt, -tilt],
        }
    }

    /// How far α, β, λ go over the time `dt` if they stood at `y`.
    fn rates(&self, y: [f64; 3], p: &Push, dt: f64) -> [f64; 3] {
        let [alpha, beta, lambda] = y;
        let ([l, c, w], [up, level, north], g) = (self.by_momentum, self.turning, self.gravity);
        [
            (-up + l * beta + c * lambda) * dt
                + l / g * (p.meridian + beta * p.vertical)
                + c / g * lambda * p.vertical
                + w * (p.longer[0] * dt * beta + p.longer[1] / g),
            (north - level * alpha) * dt + w / g * p.moment,
            -self.flow * (beta + lambda) * dt - self.flow / g * p.meridian,
        ]
    }

    /// Heun's rule.
    fn step(&self, y: [f64; 3], p: &Push, dt: f64) -> [f64; 3] {
        let first = self.rates(y, p, dt);
        let second = self.rates([0, 1, 2].map(|i| y[i] + first[i]), p, dt);
        [0, 1, 2].map(|i| y[i] + 0.5 * (first[i] + second[i]))
    }
}

/// The means of all replicates; squares are about `about` and are moved to the mean of all.
fn pooled(results: &[[f64; 2]], about: f64) -> SimulatedError {
    let (mean, mean_margin, own) = interval(&results.iter().map(|r| r[0]).collect::<Vec<_>>());
    // ⟨(α − ᾱ)²⟩ = ⟨(α − a)²⟩ − 2(αᵢ − a)(ᾱ − a) + (ᾱ − a)², and what ᾱ itself takes of it
    let off = mean - about;
    let squares: Vec<f64> =
        results.iter().map(|r| r[1] - 2.0 * (r[0] - about) * off + off * off + own * own).collect();
    let (variance, variance_margin, _) = interval(&squares);
    let percentiles = [Quantile::NONE; 4];
    SimulatedError { mean, mean_margin, variance, variance_margin, percentiles }
}
