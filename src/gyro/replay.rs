//! # Purpose
//! What a part that is not linear makes of a recorded roll.
//!
//! # Method
//! θ̈ of the recording, finer than its samples ([`bent`]), drives the part in time as it is; the product W₂ x − W₁ y is
//! averaged in blocks. The recording is one piece of a longer roll, whose mean the blocks' scatter tells to 99 %.
//!
//! # References
//! As for random motions ([`nonlinear`](super::nonlinear)).
//!
//! # Numerical aspects
//! Everything is followed with the double step too, and the whole difference is added to the margin. Each stretch
//! between gaps starts from rest, and its first ten lags and 30 s are left out.

use super::Instrument;
use super::elastic::InTime;
use super::nonlinear::{Moment, folded_by};
use super::quantile::interval;
use crate::lti::{Discrete, StateSpace};
use crate::spectrum::{EvenSamples, bent};
use crate::{Error, Result};
use faer::Mat;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Blocks of a recording at most, and at least.
const BLOCKS: [usize; 2] = [24, 4];
/// Shortest block, s: some memories of a roll.
const BLOCK: f64 = 60.0;

/// A recorded roll, ready to drive a part in time.
#[derive(Debug, Clone)]
pub struct Replay {
    step: f64,
    /// θ̈ of each stretch, rad/s².
    stretches: Vec<Vec<f64>>,
}

/// Sums over a block of the product with the step and with the double step.
type Block = [f64; 2];

impl Replay {
    /// Samples of a roll (rad) without what is slower than `corner`, behind two low-passes at `band`, both rad/s, which
    /// rolls mostly at `peak`, rad/s.
    ///
    /// # Errors
    /// `BadInput` where no stretch without a gap is long enough.
    pub fn of(samples: &EvenSamples, corner: f64, band: Option<f64>, peak: f64) -> Result<Self> {
        // four steps a sample, and sixty a period of the roll at least
        let times = (samples.step * peak * 10.0).ceil().max(4.0) as usize;
        let stretches = bent(samples, corner, band, times)?;
        if stretches.is_empty() {
            return Err(Error::bad_input("no stretch of this recording without a gap lasts 160 s")
                .with_hint(
                    "a part that is not linear is followed through the recording: give a longer one",
                ));
        }
        Ok(Self { step: samples.step / times as f64, stretches })
    }
}

impl Instrument {
    /// What a part that is not linear makes of a recorded roll on the folded heading of `heading` (rad).
    ///
    /// # Errors
    /// `BadInput` for a recording too short to tell an interval; else as the part.
    pub fn replayed(&self, replay: &Replay, heading: f64) -> Result<Moment> {
        self.check(heading)?;
        let (heading, _) = folded_by(false, heading);
        let settle = ((10.0 * self.sphere.lag).max(30.0) / replay.step) as usize / 2 * 2;
        let kept = |s: &Vec<f64>| s.len().saturating_sub(settle + 2);
        let whole: usize = replay.stretches.iter().map(kept).sum();
        let length = ((BLOCK / replay.step) as usize).max(whole / BLOCKS[0]) / 2 * 2;
        let mut blocks: Vec<Block> = Vec::new();
        let mut rests = true;
        for stretch in replay.stretches.iter().filter(|s| kept(s) >= length) {
            let mut one = Stretch::new(self, replay.step, heading)?;
            let at = one.go(stretch, 0, settle);
            let mut at = at.1;
            while at + length < stretch.len() {
                let (block, next) = one.go(stretch, at, length);
                blocks.push(block.map(|sum| sum / (length / 2) as f64));
                at = next;
            }
            rests &= one.fine.is_at_rest();
        }
        if blocks.len() < BLOCKS[1] {
            return Err(Error::bad_input(format!(
                "{} blocks of a minute without a gap are too few to tell the mean's interval",
                blocks.len()
            ))
            .with_hint("a part that is not linear needs some six minutes of roll at least"));
        }
        let (mut told, length) =
            (of_blocks(&blocks, length as f64 * replay.step), length as f64 * replay.step);
        if rests {
            let mean = |v: fn(f64) -> f64| {
                let all = replay.stretches.iter().flatten();
                all.map(|b| v(*b)).sum::<f64>() / replay.stretches.iter().map(Vec::len).sum::<usize>() as f64
            };
            let bend = self.sphere.lever * mean(|b| b * b).sqrt();
            told.margin += self.seldom(blocks.len() as f64 * length, bend * heading.cos().abs(), bend);
        }
        Ok(Moment { heading, ..told })
    }
}

fn of_blocks(blocks: &[Block], length: f64) -> Moment {
    let n = blocks.len() as f64;
    let fine: Vec<f64> = blocks.iter().map(|b| b[0]).collect();
    let (mean, margin, _) = interval(&fine);
    let by_step = (blocks.iter().map(|b| b[0] - b[1]).sum::<f64>() / n).abs();
    // S(0) = lim L·var(mean over L)
    let squares: Vec<f64> = fine.iter().map(|m| (m - mean).powi(2) * length * n / (n - 1.0)).collect();
    let (density, density_margin, _) = interval(&squares);
    Moment { mean, margin: margin + by_step, density, density_margin, heading: 0.0 }
}

/// The part with the step and with the double step, and what gives way across it.
struct Stretch {
    mass: f64,
    /// W₁ and W₂ a unit of θ̈, m.
    by_bend: [f64; 2],
    fine: Box<dyn InTime>,
    coarse: Box<dyn InTime>,
    across: Option<Across>,
}

impl Stretch {
    fn new(instrument: &Instrument, step: f64, heading: f64) -> Result<Self> {
        let s = &instrument.sphere;
        let of = |step: f64| -> Result<Box<dyn InTime>> {
            let law = instrument.elastic.in_time(s, step)?;
            law.ok_or_else(|| Error::not_computed("a linear part needs no simulation"))
        };
        let across = instrument.elastic.across(s)?.map(|system| Across::new(&system, step));
        // W₁ = −hθ̈ cos K, W₂ = +hθ̈ sin K
        let by_bend = [-s.lever * heading.cos(), s.lever * heading.sin()];
        Ok(Self { mass: s.weight / s.gravity, by_bend, fine: of(step)?, coarse: of(2.0 * step)?, across })
    }

    /// `steps` steps on (an even number) from the point `at`: the sums over every second point, and where it is then.
    fn go(&mut self, bend: &[f64], at: usize, steps: usize) -> (Block, usize) {
        let mut sums = [0.0; 2];
        for k in (at..at + steps).step_by(2) {
            let w = |i: usize, axis: usize| self.by_bend[axis] * bend[k + i];
            let [f0, f1, f2] = [0, 1, 2].map(|i| self.mass * w(i, 0));
            let [g0, g1, g2] = [0, 1, 2].map(|i| w(i, 1));
            let (w1, w2) = (w(2, 0), w(2, 1));
            self.fine.advance(f0, f1);
            self.fine.advance(f1, f2);
            self.coarse.advance(f0, f2);
            let y = self.across.as_mut().map_or(0.0, |a| {
                a.advance(g0, g1);
                a.advance(g1, g2)
            });
            sums[0] += w2 * self.fine.shift() - w1 * y;
            sums[1] += w2 * self.coarse.shift() - w1 * y;
        }
        (sums, at + steps)
    }
}

/// y under a W₂ that runs straight from point to point: the system with W₂ and its rate as states.
struct Across {
    steps: Discrete,
    z: Vec<f64>,
    give: Vec<f64>,
    step: f64,
    /// Draws nothing: no noise drives it.
    rng: ChaCha8Rng,
}

impl Across {
    fn new(system: &StateSpace, step: f64) -> Self {
        let n = system.order();
        let a = Mat::from_fn(n + 2, n + 2, |i, j| match (i < n, j) {
            (true, j) if j < n => system.a[(i, j)],
            (true, j) if j == n => system.b[(i, 1)],
            (false, j) if i == n && j == n + 1 => 1.0,
            _ => 0.0,
        });
        let give = (0..n).map(|j| system.c[(1, j)]).collect();
        let steps = Discrete::new(&a, &Mat::zeros(n + 2, 1), step);
        Self { steps, z: vec![0.0; n + 2], give, step, rng: ChaCha8Rng::seed_from_u64(1) }
    }

    fn advance(&mut self, from: f64, to: f64) -> f64 {
        let n = self.give.len();
        (self.z[n], self.z[n + 1]) = (from, (to - from) / self.step);
        self.steps.advance(&mut self.z, &mut self.rng);
        self.give.iter().zip(&self.z).map(|(c, z)| c * z).sum()
    }
}
