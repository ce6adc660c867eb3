//! # Purpose
//! The standard deviation of the heading about its course-and-speed error while the ship manoeuvres at random: the
//! ballistic deviation of many turns and changes of speed.
//!
//! # Method
//! The northward velocity is a stationary process with K(τ) = σ² exp(−|τ|/T), v̇ = −v/T + σ√(2/T) w. It turns the
//! level below the compass, v/R in the row of β, and its acceleration W₂ = v̇ drives pendulum and damper. The deviation
//! α − v/(R U cos φ) is an output of one linear system of four states, and its variance an integral I₄.
//!
//! # References
//! M. Schuler, Physikalische Zeitschrift 24 (1923) 344–350: without damping, and tuned to 84.4 min, there is none.
//!
//! # Numerical aspects
//! The rates of a compass lie some 10⁻³ 1/s apart from each other at most, so that the covariance keeps its digits.

use super::Gyrosphere;
use super::instrument::EARTH_RADIUS;
use crate::lti::StateSpace;
use crate::{Error, Result};
use faer::Mat;

/// Random changes of the northward velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Manoeuvres {
    /// σ, standard deviation of the northward velocity, m/s.
    pub deviation: f64,
    /// T, the time in which its correlation falls to 1/e, s.
    pub time: f64,
}

/// A compass about its settled heading: ẏ = A y + b v + c v̇ for y = (α, …), with the northward velocity v.
#[derive(Debug, Clone)]
pub(super) struct Settling {
    /// A, n × n, 1/s.
    pub rates: Vec<Vec<f64>>,
    /// b, 1/m.
    pub velocity: Vec<f64>,
    /// c, s/m.
    pub acceleration: Vec<f64>,
    /// U cos φ, rad/s.
    pub north: f64,
}

impl Manoeuvres {
    fn check(&self) -> Result<()> {
        for (name, value) in [("deviation of the northward velocity", self.deviation), ("time", self.time)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::bad_input(format!(
                    "the {name} of manoeuvres must be positive, not {value}"
                )));
            }
        }
        Ok(())
    }
}

impl Settling {
    /// The standard deviation of α − v/(R U cos φ), rad.
    pub fn deviation(&self, m: &Manoeuvres) -> Result<f64> {
        m.check()?;
        let n = self.rates.len();
        // v̇ = −v/T + σ√(2/T) w
        let (decay, kick) = (-1.0 / m.time, m.deviation * (2.0 / m.time).sqrt());
        let a = Mat::from_fn(n + 1, n + 1, |i, j| match (i < n, j < n) {
            (true, true) => self.rates[i][j],
            (true, false) => self.velocity[i] + self.acceleration[i] * decay,
            (false, true) => 0.0,
            (false, false) => decay,
        });
        let b = Mat::from_fn(n + 1, 1, |i, _| if i < n { self.acceleration[i] * kick } else { kick });
        let c = Mat::from_fn(1, n + 1, |_, j| match j {
            0 => 1.0,
            _ if j == n => -1.0 / (EARTH_RADIUS * self.north),
            _ => 0.0,
        });
        let variance = StateSpace::new(a, b, c, Mat::zeros(1, 1))?.output_covariance()?[(0, 0)];
        Ok(variance.max(0.0).sqrt())
    }
}

impl Gyrosphere {
    /// The standard deviation of the heading about v_N/(R U cos φ) under random manoeuvres, rad.
    ///
    /// ```
    /// use gyrospec::gyro::{Gyrosphere, Manoeuvres};
    /// // a ship that doubles back and forth at 15 kn, some ten minutes each way
    /// let turns = Manoeuvres { deviation: 15.0 * 1852.0 / 3600.0, time: 600.0 };
    /// let degrees = Gyrosphere::seed().manoeuvre_deviation(&turns)?.to_degrees();
    /// assert!(degrees > 0.1 && degrees < 5.0);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// `BadInput` for impossible numbers; `Unstable` for a compass that does not settle.
    pub fn manoeuvre_deviation(&self, manoeuvres: &Manoeuvres) -> Result<f64> {
        self.check()?;
        let (l, c) = (self.pendulous / self.momentum, self.damper / self.momentum);
        let (f, north) = (self.flow, self.earth_rate * self.latitude.cos());
        // (2.1): α′ = (lP/H)(β + W₂/g) + (C/H) λ,  β′ = v/R − U cos φ α,  λ′ = −F(β + λ + W₂/g)
        Settling {
            rates: vec![vec![0.0, l, c], vec![-north, 0.0, 0.0], vec![0.0, -f, -f]],
            velocity: vec![0.0, 1.0 / EARTH_RADIUS, 0.0],
            acceleration: vec![l / self.gravity, 0.0, -f / self.gravity],
            north,
        }
        .deviation(manoeuvres)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The same from the answer g(t) to a step of v, by the correlation function of v̇, which is
    /// (2σ²/T) δ(τ) − (σ²/T²) exp(−|τ|/T): the sums run over time alone.
    pub fn by_steps(step: f64, answer: &[f64], m: &Manoeuvres) -> f64 {
        // in the middle of each step: the first answer is a jump
        let answer: Vec<f64> = answer.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        let square: f64 = step * answer.iter().map(|g| g * g).sum::<f64>();
        let keeps = (-step / m.time).exp();
        // Σ g(a) Σ_{b<a} g(b) e^{−(a−b)/T}, one behind the other
        let (mut tail, mut double) = (0.0, 0.0);
        for g in &answer {
            double += g * (2.0 * tail + g);
            tail = keeps * (tail + g);
        }
        let (s2, t) = (m.deviation * m.deviation, m.time);
        (2.0 * s2 / t * square - s2 / (t * t) * double * step * step).sqrt()
    }

    #[test]
    fn the_spread_is_that_of_the_answers_to_steps() {
        let sphere = Gyrosphere::seed();
        for (deviation, time) in [(7.7, 600.0), (3.0, 60.0), (10.0, 7200.0)] {
            let m = Manoeuvres { deviation, time };
            let step = 0.25;
            let answer: Vec<f64> =
                sphere.ballistic(1.0, step, 800_000).unwrap().iter().map(|p| p.1).collect();
            let (mine, other) = (sphere.manoeuvre_deviation(&m).unwrap(), by_steps(step, &answer, &m));
            assert!((mine / other - 1.0).abs() < 2e-3, "{m:?}: {mine} and {other}");
        }
    }

    #[test]
    fn a_tuned_compass_with_hardly_a_damper_stays_still() {
        let seed = Gyrosphere::seed();
        // lP/H = g/(R U cos φ): 84.4 min
        let north = seed.earth_rate * seed.latitude.cos();
        let pendulous = seed.momentum * seed.gravity / (EARTH_RADIUS * north);
        let m = Manoeuvres { deviation: 7.7, time: 900.0 };
        let with = |damper: f64| {
            Gyrosphere { pendulous, damper: damper * pendulous, ..seed }.manoeuvre_deviation(&m).unwrap()
        };
        assert!(with(1e-4) < 0.02 * with(0.4), "{} and {}", with(1e-4), with(0.4));
    }

    #[test]
    fn manoeuvres_that_are_none_are_refused() {
        for (deviation, time) in [(0.0, 600.0), (5.0, -1.0), (f64::NAN, 600.0), (5.0, f64::INFINITY)] {
            assert!(Gyrosphere::seed().manoeuvre_deviation(&Manoeuvres { deviation, time }).is_err());
        }
    }
}
