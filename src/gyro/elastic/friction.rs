//! # Purpose
//! Dry friction in the suspension, replaced by the viscous one that serves this motion best.
//!
//! # Method
//! m ẍ + r ẋ + F_c sign ẋ + C₀ x = m W₁. Stochastic linearisation: sign ẋ ≈ √(2/π) ẋ/σ, with σ
//! the standard deviation of ẋ that the linear system itself has: a fixed point, found by
//! bisection on σ.
//!
//! # References
//! R. C. Booton, IRE Trans. Circuit Theory 1 (1954) 9–18; T. K. Caughey, J. Acoust. Soc. Am. 35
//! (1963) 1706–1711.
//!
//! # Numerical aspects
//! The method is not exact: against simulation the mean error is within 10 % while friction
//! takes less than half of the inertia force's deviation. Where even σ → 0 gives no motion
//! the part sticks, and the shift is zero.

use super::inertia::{oscillator, single};
use super::{Elastic, deviations};
use crate::gyro::Gyrosphere;
use crate::lti::StateSpace;
use crate::{Error, Result};
use std::f64::consts::PI;

/// Dry friction beside the elastic part (2.2).
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `force` | F_c | N |
#[derive(Debug, Clone, Copy)]
pub struct Friction {
    /// F_c, N.
    pub force: f64,
}

impl Elastic for Friction {
    fn name(&self) -> &'static str {
        "dry friction (linearised)"
    }

    fn system(&self, s: &Gyrosphere, acceleration: &StateSpace) -> Result<StateSpace> {
        if !(self.force.is_finite() && self.force >= 0.0) {
            return Err(Error::bad_input("the friction force must not be negative"));
        }
        let (m, r, c) = (s.weight / s.gravity, s.lag * s.stiffness, s.stiffness);
        if self.force == 0.0 {
            return oscillator(m, r, c);
        }
        // r_eq = r + F_c √(2/π)/σ
        let equivalent = |sigma: f64| r + self.force * (2.0 / PI).sqrt() / sigma;
        let free = deviations(&single(m, r, c)?, acceleration)?.1;
        if free == 0.0 {
            return oscillator(m, r, c);
        }
        let (mut low, mut high) = (free * 1e-9, free);
        let moves = |sigma: f64| -> Result<bool> {
            Ok(deviations(&single(m, equivalent(sigma), c)?, acceleration)?.1 > sigma)
        };
        if !moves(low)? {
            // it sticks: no shift at all
            let mut stuck = oscillator(m, r, c)?;
            stuck.c = faer::Mat::zeros(3, stuck.order());
            return Ok(stuck);
        }
        for _ in 0..60 {
            let middle = (low * high).sqrt();
            if moves(middle)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        oscillator(m, equivalent((low * high).sqrt()), c)
    }
}
