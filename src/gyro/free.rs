//! The compass left alone: its periods, its damping, its settling, and its answer to a turn.

use super::Gyrosphere;
use super::instrument::EARTH_RADIUS;
use crate::lti::Discrete;
use crate::poly::roots::roots;
use crate::{Error, Result};
use faer::Mat;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// Free motion as a navigator knows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeMotion {
    /// 2π√(H/(lP U cos φ)), s: without damping.
    pub undamped_period: f64,
    /// s; infinite where the compass creeps without a swing.
    pub damped_period: f64,
    /// Time in which the slowest motion falls to 1/e, s.
    pub decay: f64,
    /// Time until the heading stays within half a degree, started 10° off, s.
    pub settling: f64,
}

impl Gyrosphere {
    /// Periods, decay and settling of (2.1) without motion.
    ///
    /// ```
    /// let free = gyrospec::gyro::Gyrosphere::seed().free_motion().unwrap();
    /// assert!((free.damped_period / 60.0 - 97.9).abs() < 0.1);
    /// ```
    ///
    /// # Errors
    /// `BadInput` for impossible numbers or a compass that does not settle.
    pub fn free_motion(&self) -> Result<FreeMotion> {
        self.check()?;
        let (l, c, n) = self.rates();
        let f = self.flow;
        // det(sI − A) = s³ + F s² + ln s + nF(l − c)
        let poles = roots(&[1.0, f, l * n, n * f * (l - c)]);
        let slowest = poles.iter().map(|p| p.re).fold(f64::NEG_INFINITY, f64::max);
        if slowest >= 0.0 {
            return Err(Error::bad_input("this compass does not settle: its damping is too weak"));
        }
        let swing = poles.iter().map(|p| p.im.abs()).fold(0.0, f64::max);
        let damped_period = if swing > 1e-12 { TAU / swing } else { f64::INFINITY };
        let start = [10f64.to_radians(), 0.0, 0.0];
        let settling = self.settling(start, 0.5f64.to_radians(), -60.0 / slowest);
        Ok(FreeMotion {
            undamped_period: self.undamped_period(),
            damped_period,
            decay: -1.0 / slowest,
            settling,
        })
    }

    /// The heading's ballistic deviation after a change of the northward speed by Δv (m/s) in
    /// no time: (time s, error beyond the new steady error rad) each `step` seconds.
    ///
    /// The jump of v_N throws α and λ by the impulse of W₂ = Δv: Δα = (lP/(Hg)) Δv, Δλ = −(F/g) Δv.
    /// A compass of period 84.4 min jumps by just the change of v_N/(R U cos φ) and so stays still.
    ///
    /// # Errors
    /// As [`Gyrosphere::free_motion`].
    pub fn ballistic(&self, change: f64, step: f64, count: usize) -> Result<Vec<(f64, f64)>> {
        self.check()?;
        let (l, _, n) = self.rates();
        let jump = l * change / self.gravity;
        let steady = change / (EARTH_RADIUS * n);
        let mut y = vec![jump - steady, 0.0, -self.flow * change / self.gravity];
        let (mut discrete, mut rng) = self.stepper(step);
        Ok((0..count)
            .map(|k| {
                let now = (k as f64 * step, y[0]);
                discrete.advance(&mut y, &mut rng);
                now
            })
            .collect())
    }

    /// lP/H, C/H and U cos φ, 1/s.
    fn rates(&self) -> (f64, f64, f64) {
        let n = self.earth_rate * self.latitude.cos();
        (self.pendulous / self.momentum, self.damper / self.momentum, n)
    }

    fn stepper(&self, step: f64) -> (Discrete, ChaCha8Rng) {
        let (l, c, n) = self.rates();
        let f = self.flow;
        let a = faer::mat![[0.0, l, c], [-n, 0.0, 0.0], [0.0, -f, -f]];
        (Discrete::new(&a, &Mat::zeros(3, 1), step), ChaCha8Rng::seed_from_u64(0))
    }

    fn settling(&self, start: [f64; 3], within: f64, longest: f64) -> f64 {
        let step = 10.0;
        let (mut discrete, mut rng) = self.stepper(step);
        let mut y = start.to_vec();
        let mut last = 0.0;
        for k in 1..=(longest / step) as usize {
            discrete.advance(&mut y, &mut rng);
            if y[0].abs() > within {
                last = k as f64 * step;
            }
        }
        last + step
    }
}
