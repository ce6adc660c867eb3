//! # Purpose
//! What a part that is not linear makes of a sine, once its answer repeats.
//!
//! # Method
//! Under W₁ = a cos pt along the parallel the part is followed in time until x repeats; X = ⟨2 x e^{−jpt}⟩ over one
//! period is the fundamental of x. A product with any other sine of the frequency p has the mean ½ Re(W₂ X*) exactly,
//! whatever else is in x: over a period the higher harmonics meet nothing.
//!
//! # References
//! A. Gelb, W. E. Vander Velde, Multiple-Input Describing Functions and Nonlinear System Design (1968), ch. 2: X/a is
//! the describing function of the part, here of its true answer and not of one supposed to be a sine.
//!
//! # Numerical aspects
//! The force runs straight from point to point, which errs in the square of the step: X is taken with the double step
//! too, and the third of the difference is taken away.

use super::Instrument;
use crate::{Error, Result};
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Periods that a part may take to repeat.
const PERIODS: usize = 20_000;

impl Instrument {
    /// X/a, s²: x along the parallel a unit of W₁ = a cos pt, of the amplitude a (m/s²) and the frequency p (rad/s),
    /// for a part that is not linear; `points` to a period.
    ///
    /// # Errors
    /// `NotComputed` for a linear part, and where the answer does not become periodic.
    ///
    /// ```
    /// use gyrospec::gyro::{Gyrosphere, Instrument, elastic::Friction};
    /// // Next to no friction: the lag alone, X/a = (P/gF)/(1 + jTp).
    /// let s = Gyrosphere::seed();
    /// let instrument = Instrument::new(s.clone(), Box::new(Friction { force: 1e-3 }));
    /// let gain = instrument.answer(0.5, 0.5, 400)?;
    /// let lag = s.weight / s.gravity / s.stiffness / gyrospec::Complex64::new(1.0, s.lag * 0.5);
    /// assert!((gain - lag).norm() < 1e-3 * lag.norm());
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn answer(&self, amplitude: f64, frequency: f64, points: usize) -> Result<Complex64> {
        let [fine, coarse] = [points, points / 2].map(|n| self.repeated(amplitude, frequency, n));
        let (fine, coarse) = (fine?, coarse?);
        Ok(fine + (fine - coarse) / 3.0)
    }

    fn repeated(&self, amplitude: f64, frequency: f64, points: usize) -> Result<Complex64> {
        let s = &self.sphere;
        let step = TAU / frequency / points as f64;
        let law = self.elastic.in_time(s, step)?;
        let mut law = law.ok_or_else(|| Error::not_computed("a linear part needs no simulation"))?;
        let turns: Vec<Complex64> =
            (0..=points).map(|k| Complex64::from_polar(1.0, TAU * k as f64 / points as f64)).collect();
        let force = s.weight / s.gravity * amplitude;
        let mut before = Complex64::new(f64::NAN, 0.0);
        for _ in 0..PERIODS {
            let mut sum = Complex64::ZERO;
            for pair in turns.windows(2) {
                law.advance(force * pair[0].re, force * pair[1].re);
                sum += law.shift() * pair[1].conj();
            }
            let gain = 2.0 * sum / (points as f64 * amplitude);
            if (gain - before).norm() <= 1e-9 * gain.norm() {
                return Ok(gain);
            }
            before = gain;
        }
        Err(Error::not_computed("the part's answer to a sine does not become periodic"))
    }
}
