//! # Purpose
//! Free play in the suspension, replaced by the spring that serves this motion best.
//!
//! # Method
//! m ẍ + r ẋ + C₀ d(x) = m W₁ with d(x) = 0 for |x| < δ and x ∓ δ beyond. Stochastic
//! linearisation: d(x) ≈ P(|x| > δ) x = erfc(δ/(√2 σ)) x, with σ the standard deviation of x
//! that the linear system itself has: a fixed point, found by bisection on σ.
//!
//! # References
//! As for dry friction; the factor is E[d′(x)] of a Gaussian x.
//!
//! # Numerical aspects
//! Not exact: within 10 % of simulation where the play is below one standard deviation of x.

use super::inertia::{oscillator, single};
use super::{Elastic, deviations};
use crate::gyro::Gyrosphere;
use crate::lti::StateSpace;
use crate::{Error, Result};
use std::f64::consts::SQRT_2;

/// Free play of half-width δ before the spring takes hold.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `gap` | δ, half the play | m |
#[derive(Debug, Clone, Copy)]
pub struct Backlash {
    /// δ, m.
    pub gap: f64,
}

impl Elastic for Backlash {
    fn name(&self) -> &'static str {
        "free play (linearised)"
    }

    fn system(&self, s: &Gyrosphere, acceleration: &StateSpace) -> Result<StateSpace> {
        if !(self.gap.is_finite() && self.gap >= 0.0) {
            return Err(Error::bad_input("the free play must not be negative"));
        }
        let (m, r, c) = (s.weight / s.gravity, s.lag * s.stiffness, s.stiffness);
        let tight = deviations(&single(m, r, c)?, acceleration)?.0;
        if self.gap == 0.0 || tight == 0.0 {
            return oscillator(m, r, c);
        }
        // C_eq = C₀ erfc(δ/(√2 σ))
        let equivalent = |sigma: f64| c * statrs::function::erf::erfc(self.gap / (SQRT_2 * sigma)).max(1e-12);
        let wider = |sigma: f64| -> Result<bool> {
            Ok(deviations(&single(m, r, equivalent(sigma))?, acceleration)?.0 > sigma)
        };
        let (mut low, mut high) = (tight, 1e3 * (tight + self.gap));
        for _ in 0..60 {
            let middle = (low * high).sqrt();
            if wider(middle)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        oscillator(m, r, equivalent((low * high).sqrt()))
    }
}
