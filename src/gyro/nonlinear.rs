//! # Purpose
//! The heading error of a compass whose elastic part is not linear, with the error of that figure.
//!
//! # Method
//! The mean is that of M_y = (P/g)(W₂ x − W₁ y): α = P⟨W₂ x − W₁ y⟩/(g H (U cos φ + v_E/R)), with the product from
//! the motion and the part followed in time ([`elastic::InTime`](super::elastic::InTime)); y, of a compliance along
//! the meridian, is linear. The compass is so slow that it feels of M_y the density at ω = 0 alone: the variance by
//! products is that of the linear part, (2.2) with whatever linear stands beside it, times the ratio of the two
//! densities. On a regular roll one period is followed until it repeats.
//!
//! # References
//! A. M. Law, Simulation Modeling and Analysis, ch. 9 and 11, for replicates and the linear part as their
//! control variate; 99 % intervals by Student's t.
//!
//! # Numerical aspects
//! Replicates are added until the interval is within 2 % of the mean, or of a tenth of what the part would
//! give if it were linear, or until the step's error outweighs their scatter; as many as the [`Effort`] allows at
//! most. Every replicate is followed with the double step too, and the whole difference, about three times the
//! error, is added to the margin. All headings see the same motions. The seed is fixed.

use super::effort::Effort;
use super::elastic::{Elastic, Friction, InTime, Inertia};
use super::instrument::{HeadingError, Instrument};
use super::path::{Drive, Path, Sample};
use super::quantile::interval;
use super::rectified::SlowFast;
use super::seed::Regular;
use super::{Axis, Motion};
use crate::spectrum::Roll;
use crate::{Error, Result};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Replicates of the first round; each further round doubles them.
const FIRST: usize = 192;
/// Streams of the seed from here on, apart from those of a Monte Carlo check.
const STREAM: u64 = 1 << 40;
/// Points of a period of regular roll.
const POINTS: usize = 400;

/// What a part that is not linear makes of a random motion, with 99 % margins. It knows nothing of the
/// compass's latitude or speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// ⟨W₂ x − W₁ y⟩, m²/s².
    pub mean: f64,
    /// Half its 99 % interval, with the numerical error.
    pub margin: f64,
    /// Density of W₂ x − W₁ y at ω = 0, m⁴/s³.
    pub density: f64,
    /// Half its 99 % interval.
    pub density_margin: f64,
    /// The heading, rad, that it is of.
    pub(super) heading: f64,
}

/// One replicate: the mean of W₂ x − W₁ y, with the double step too and of the linear part, the squares of W₁
/// and V₂, and whether nothing slipped.
#[derive(Clone, Copy)]
struct Batch {
    fine: f64,
    coarse: f64,
    linear: f64,
    squares: [f64; 2],
    rests: bool,
}

/// The heading, rad, from 0 to 180° or, where all motion is along one line of the ship, to 90°, on which
/// W₂ x has the moment of `heading` up to its sign, and that sign.
pub fn folded(motion: &Motion, heading: f64) -> (f64, f64) {
    let moves = |axes: [Axis; 2]| motion.axes().iter().any(|a| axes.contains(a));
    let both = moves([Axis::Roll, Axis::Sway]) && moves([Axis::Pitch, Axis::Surge]);
    folded_by(both, heading)
}

/// The same, of motions along both lines of the ship or along one.
pub(super) fn folded_by(both: bool, heading: f64) -> (f64, f64) {
    let k = heading.rem_euclid(PI);
    if both || k <= 0.5 * PI { (k, 1.0) } else { (PI - k, -1.0) }
}

impl Instrument {
    /// The same compass without friction or play, with the linear part (2.2) where no other is left.
    fn tight(&self) -> Self {
        let elastic = self.elastic.tightened().unwrap_or_else(|| Box::new(Inertia));
        Self { sphere: self.sphere, elastic, speed: self.speed }
    }

    /// α a unit of ⟨W₂ x⟩.
    fn by_moment(&self, heading: f64) -> f64 {
        let s = &self.sphere;
        s.weight / (s.gravity * s.momentum * self.northing(heading))
    }

    /// Mean and spread on a random motion, by what [`Instrument::moment`] gives on the [`folded`] heading:
    /// [`Instrument::error`] in two, for many headings or latitudes.
    ///
    /// # Errors
    /// As [`Instrument::error`]; `BadInput` for the moment of another heading.
    pub fn error_by(&self, moment: &Moment, motion: &Motion, heading: f64) -> Result<HeadingError> {
        let (k, sign) = folded(motion, heading);
        if (k - moment.heading).abs() > 1e-9 {
            return Err(Error::bad_input("this moment is that of another heading"));
        }
        let tight = self.tight().system(motion, heading)?;
        let (by_shift, others) = parted(&tight);
        let gain = self.by_moment(heading);
        let rest = others.moments()?;
        let mut error = self.told(&rest, heading);
        error.rectified += sign * gain * moment.mean;
        error.rectified_margin = (gain * moment.margin).abs();
        error.linearised = Some(self.system(motion, heading)?.rectified_mean()?[0]);
        let all = tight.moments()?.quadratic[(0, 0)];
        let (own, other) = (by_shift.moments()?.quadratic[(0, 0)], rest.quadratic[(0, 0)]);
        // the variance a unit of the density at ω = 0
        let low = by_shift.densities(0, &[0.0])?[0].1;
        let unit = if low > 0.0 { own / low * gain * gain } else { 0.0 };
        let (mine, margin) = (unit * moment.density, unit * moment.density_margin);
        // products of both kinds meet as they do where the part is linear
        let cross = if own > 0.0 { (all - own - other) * (mine / own).sqrt() } else { 0.0 };
        error.widen((mine + other + cross).max(0.0), margin + cross.abs());
        Ok(error)
    }

    /// Mean and spread on a regular roll: its products do not spread, since a steady sine has a steady
    /// product.
    ///
    /// # Errors
    /// As [`Instrument::error`]; `NotComputed` where the answer does not become periodic.
    pub fn regular_error(&self, roll: &Regular, heading: f64) -> Result<HeadingError> {
        // the limit of ever narrower irregular roll: θ₀² = 2A, p = ε, μ → 0
        let p = roll.frequency;
        let narrow = Motion::roll(&Roll::new(0.5 * roll.amplitude * roll.amplitude, 1e-7 * p, p)?);
        let linear = self.is_linear()?;
        let exact = |of: &Self| -> Result<HeadingError> {
            Ok(of.told(&of.system(&narrow, heading)?.moments()?, heading))
        };
        let mut error = if linear { self.error(&narrow, heading)? } else { exact(&self.tight())? };
        (error.deviation, error.deviation_quadratic) = (error.deviation_linear, 0.0);
        if !linear {
            let (mean, margin) = self.period(roll, heading)?;
            let gain = self.by_moment(heading);
            (error.rectified, error.rectified_margin) = (gain * mean, (gain * margin).abs());
        }
        Ok(error)
    }

    /// ⟨W₂ x⟩ over one period of regular roll, once it repeats, and its numerical margin.
    fn period(&self, roll: &Regular, heading: f64) -> Result<(f64, f64)> {
        let step = TAU / roll.frequency / POINTS as f64;
        let drive = Drive::regular(roll)?;
        let mut path = Path::new(self, &drive, heading, step)?;
        let mut pair = Pair::new(self, step)?;
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let mut last = path.begin(&mut rng);
        let mut before = f64::NAN;
        for _ in 0..20_000 {
            let b = pair.go(&mut path, &mut last, POINTS, &mut rng);
            if (b.fine - before).abs() <= 1e-9 * b.fine.abs() {
                return Ok((b.fine, (b.fine - b.coarse).abs()));
            }
            before = b.fine;
        }
        Err(Error::not_computed("the part's answer to the regular roll does not become periodic"))
    }

    /// What a part that is not linear makes of a random motion on the [`folded`] heading of `heading`
    /// (rad), by simulation.
    ///
    /// # Errors
    /// `OutOfRange` for a motion of infinite acceleration, and for one that takes too many steps
    /// ([`Effort::check`]); else as the covariance.
    pub fn moment(&self, motion: &Motion, heading: f64) -> Result<Moment> {
        self.moment_with(motion, heading, &|_| ())
    }

    /// The same, which tells time and again what share of the longest simulation is done.
    ///
    /// # Errors
    /// As [`Instrument::moment`].
    pub fn moment_with(&self, motion: &Motion, heading: f64, told: &(dyn Fn(f64) + Sync)) -> Result<Moment> {
        self.check(heading)?;
        let (heading, _) = folded(motion, heading);
        let effort = self.effort(motion)?;
        let path = Path::new(self, &Drive::irregular(motion), heading, effort.step)?;
        effort.check(self.elastic.name())?;
        let linear = parted(&self.tight().system(motion, heading)?).0.rectified_mean()?[0];
        let linear = linear / self.by_moment(heading);
        let (most, done) = (effort.replicates(), AtomicUsize::new(0));
        let one = |replicate: usize| -> Result<Batch> {
            let batch = self.replicate(path.clone(), &effort, replicate);
            told((1 + done.fetch_add(1, Ordering::Relaxed)) as f64 / most as f64);
            batch
        };
        let mut batches: Vec<Batch> = Vec::new();
        loop {
            let next = (2 * batches.len()).max(FIRST).min(most);
            let more: Vec<Batch> = (batches.len()..next).into_par_iter().map(one).collect::<Result<_>>()?;
            batches.extend(more);
            let (m, by_step) = self.of_batches(&batches, linear, effort.step * effort.samples() as f64);
            let near = m.margin <= 0.02 * m.mean.abs().max(0.1 * linear.abs());
            if near || batches.len() == most || by_step > 0.5 * m.margin {
                return Ok(Moment { heading, ..m });
            }
        }
    }

    /// One replicate, from its settling on.
    fn replicate(&self, mut path: Path, effort: &Effort, number: usize) -> Result<Batch> {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        rng.set_stream(STREAM + number as u64);
        let (mut pair, samples) = (Pair::new(self, effort.step)?, effort.samples());
        let mut last = path.begin(&mut rng);
        pair.go(&mut path, &mut last, samples / 8 * 2, &mut rng);
        Ok(pair.go(&mut path, &mut last, samples, &mut rng))
    }

    /// The moment, and what of its margin is the step's; `linear` is the true ⟨W₂ x⟩ of the linear part.
    fn of_batches(&self, batches: &[Batch], linear: f64, length: f64) -> (Moment, f64) {
        let n = batches.len() as f64;
        let means: Vec<f64> = batches.iter().map(|b| b.fine).collect();
        // what the linear part of each replicate is off tells much of what this one is off
        let slope = slope(batches);
        let (mean, mut margin, _) =
            interval(&batches.iter().map(|b| b.fine - slope * (b.linear - linear)).collect::<Vec<_>>());
        let by_step = (batches.iter().map(|b| b.fine - b.coarse).sum::<f64>() / n).abs();
        margin += by_step;
        if batches.iter().all(|b| b.rests) {
            let [w, v] = [0, 1].map(|i| (batches.iter().map(|b| b.squares[i]).sum::<f64>() / n).sqrt());
            margin += self.seldom(n * length, w, v);
        }
        // S(0) = lim L·var(mean over L)
        let own = means.iter().sum::<f64>() / n;
        let squares: Vec<f64> = means.iter().map(|m| (m - own).powi(2) * length * n / (n - 1.0)).collect();
        let (density, density_margin, _) = interval(&squares);
        (Moment { mean, margin, density, density_margin, heading: 0.0 }, by_step)
    }
}

impl Instrument {
    /// What slips that did not happen within a time (s) may add to ⟨W₂ x⟩, with σ of W₁ and of V₂: at 99 % there are less
    /// than 4.6 in as long, each by less than σ(mW₁)/C₀ over the largest swing of V₂.
    pub(super) fn seldom(&self, time: f64, w: f64, v: f64) -> f64 {
        let s = &self.sphere;
        4.6 / time * (s.weight / s.gravity * w / s.stiffness) * 8.0 * v
    }
}

/// The regression of the means of W₂ x on those of the linear part.
fn slope(batches: &[Batch]) -> f64 {
    let n = batches.len() as f64;
    let mean = |f: fn(&Batch) -> f64| batches.iter().map(f).sum::<f64>() / n;
    let (own, linear) = (mean(|b| b.fine), mean(|b| b.linear));
    let common: f64 = batches.iter().map(|b| (b.fine - own) * (b.linear - linear)).sum();
    let square: f64 = batches.iter().map(|b| (b.linear - linear).powi(2)).sum();
    if square > 0.0 { common / square } else { 0.0 }
}

/// The part followed with the step and with the double step, and the linear part beside it.
struct Pair {
    mass: f64,
    fine: Box<dyn InTime>,
    coarse: Box<dyn InTime>,
    linear: Box<dyn InTime>,
}

impl Pair {
    fn new(instrument: &Instrument, step: f64) -> Result<Self> {
        let s = &instrument.sphere;
        let of = |part: &dyn Elastic, step: f64| -> Result<Box<dyn InTime>> {
            let law = part.in_time(s, step)?;
            law.ok_or_else(|| Error::not_computed("a linear part needs no simulation"))
        };
        let part = instrument.elastic.as_ref();
        let (fine, coarse) = (of(part, step)?, of(part, 2.0 * step)?);
        let tight = part.tightened().unwrap_or_else(|| Box::new(Friction { force: 0.0 }));
        Ok(Self { mass: s.weight / s.gravity, fine, coarse, linear: of(tight.as_ref(), step)? })
    }

    /// `steps` steps on (an even number) from `last`, which is left at their end.
    fn go(&mut self, path: &mut Path, last: &mut Sample, steps: usize, rng: &mut ChaCha8Rng) -> Batch {
        let mut b = Batch { fine: 0.0, coarse: 0.0, linear: 0.0, squares: [0.0; 2], rests: false };
        for _ in 0..steps / 2 {
            let [s0, s1] = [*last, path.next(rng)];
            let s2 = path.next(rng);
            let [f0, f1, f2] = [s0, s1, s2].map(|s| self.mass * s.acceleration[0]);
            self.fine.advance(f0, f1);
            self.fine.advance(f1, f2);
            self.coarse.advance(f0, f2);
            self.linear.advance(f0, f1);
            self.linear.advance(f1, f2);
            // W₂ x − W₁ y
            let product =
                |part: &dyn InTime| s2.acceleration[1] * part.shift() - s2.acceleration[0] * s2.shift[1];
            b.fine += product(self.fine.as_ref());
            b.coarse += product(self.coarse.as_ref());
            b.linear += product(self.linear.as_ref());
            b.squares[0] += s2.acceleration[0].powi(2);
            b.squares[1] += s2.speed[1].powi(2);
            *last = s2;
        }
        let n = (steps / 2) as f64;
        let [fine, coarse, linear] = [b.fine, b.coarse, b.linear].map(|x| x / n);
        let rests = self.fine.is_at_rest();
        Batch { fine, coarse, linear, squares: b.squares.map(|x| x / n), rests }
    }
}

impl HeadingError {
    /// Takes the variance by products, and its margin.
    fn widen(&mut self, quadratic: f64, margin: f64) {
        let with = |variance: f64| self.deviation_linear.hypot(variance.max(0.0).sqrt());
        let (low, high) = (with(quadratic - margin), with(quadratic + margin));
        (self.deviation_quadratic, self.deviation) = (quadratic.sqrt(), with(quadratic));
        self.deviation_margin = (high - self.deviation).max(self.deviation - low);
    }
}

/// The system with the products of the shift alone, and with the others and the linear pushes.
fn parted(system: &SlowFast) -> (SlowFast, SlowFast) {
    let (mut own, mut others) = (system.clone(), system.clone());
    // M_y alone turns β
    own.products.retain(|p| p.row == 1);
    others.products.retain(|p| p.row != 1);
    (own, others)
}
