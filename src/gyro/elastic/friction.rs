//! # Purpose
//! Dry friction in the suspension: in time as it is, and the viscous one that serves a motion best.
//!
//! # Method
//! m ẍ + r ẋ + F_c sign ẋ + C₀ x = m W₁; at rest the part stays while |m W₁ − C₀ x| ≤ F_c. In
//! time it is followed event by event ([`InTime`]). The linear stand-in is the stochastic
//! linearisation sign ẋ ≈ √(2/π) ẋ/σ, with σ the standard deviation of ẋ that the linear system
//! itself has: a fixed point, found by bisection on σ.
//!
//! # References
//! R. C. Booton, IRE Trans. Circuit Theory 1 (1954) 9–18; T. K. Caughey, J. Acoust. Soc. Am. 35
//! (1963) 1706–1711.
//!
//! # Numerical aspects
//! The linear stand-in knows nothing of rest: with friction of one deviation of the force it gives half
//! of the mean error, above 1.6 deviations none where there is one. So errors are told by simulation, and
//! the stand-in's only beside them.

use super::follower::{Follower, Law};
use super::in_time::{InTime, Piece, Place, Ramp};
use super::inertia::{oscillator, single};
use super::option::{Asked, PartOption, first};
use super::part::{Elastic, deviations, fixed_point, positive};
use super::suspension::Suspension;
use crate::gyro::{Gyrosphere, range};
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

pub(super) const ASKED: Asked = Asked {
    options: &[PartOption {
        name: "friction",
        numbers: "FORCE",
        ranges: &[&range::FRICTION],
        help: "Dry friction in the suspension: its errors are simulated",
    }],
    make: |given| Box::new(Friction { force: first(given)[0] }),
};

impl Elastic for Friction {
    fn name(&self) -> &'static str {
        "dry friction"
    }

    fn system(&self, s: &Gyrosphere, acceleration: &StateSpace) -> Result<StateSpace> {
        self.check()?;
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
        // what a stationary swing loses it is given: r_eq σ² = ⟨ẋ m W₁⟩ ≤ σ σ(m W₁), so that it cannot move
        // where F_c √(2/π) ≥ σ(m W₁)
        let force = acceleration.output_covariance().map_or(f64::INFINITY, |k| m * k[(0, 0)].max(0.0).sqrt());
        if self.force * (2.0 / PI).sqrt() >= force {
            return stuck(m, r, c);
        }
        let low = free * 1e-9;
        let moves = |sigma: f64| -> Result<bool> {
            Ok(deviations(&single(m, equivalent(sigma), c)?, acceleration)?.1 > sigma)
        };
        if !moves(low)? {
            return stuck(m, r, c);
        }
        oscillator(m, equivalent(fixed_point([low, free], moves)?), c)
    }

    fn enters(&self, suspension: &mut Suspension) -> Result<()> {
        // its law holds the inertia
        suspension.inertia = true;
        Suspension::once(&mut suspension.friction, self.force, "dry friction")
    }

    fn in_time(&self, s: &Gyrosphere, step: f64) -> Result<Option<Box<dyn InTime>>> {
        self.check()?;
        let (m, r, c) = (s.weight / s.gravity, s.lag * s.stiffness, s.stiffness);
        positive(&[("m", m), ("r", r), ("C0", c)])?;
        let law = |part| Rubbed {
            piece: Piece::new((m, r, c), part),
            stiffness: c,
            friction: self.force,
            slip: 0.0,
        };
        Ok(Some(Box::new(Follower::new((m, r, c), step, law))))
    }
}

impl Friction {
    fn check(self) -> Result<()> {
        if self.force.is_finite() && self.force >= 0.0 {
            return Ok(());
        }
        Err(Error::bad_input("the friction force must not be negative"))
    }
}

/// A part at rest: no shift at all.
fn stuck(m: f64, r: f64, c: f64) -> Result<StateSpace> {
    let mut part = oscillator(m, r, c)?;
    part.c = faer::Mat::zeros(3, part.order());
    Ok(part)
}

/// Rest and slip in turn.
#[derive(Debug)]
struct Rubbed {
    piece: Piece,
    /// C₀, N/m.
    stiffness: f64,
    /// F_c, N.
    friction: f64,
    /// The sign of ẋ; zero at rest.
    slip: f64,
}

impl Law for Rubbed {
    fn go(&mut self, at: &mut Place, force: Ramp, left: f64) -> f64 {
        if self.slip == 0.0 { self.rest(at.x, force, left) } else { self.slide(at, force, left) }
    }
}

impl Rubbed {
    /// How long it rests; then it slips or the time is over.
    fn rest(&mut self, x: f64, force: Ramp, left: f64) -> f64 {
        let Ramp { f, g } = force.from(0.0, -self.stiffness * x);
        // |f + g τ| = F_c
        let until = if f.abs() > self.friction { 0.0 } else { (self.friction.copysign(g) - f) / g };
        if until.is_nan() || until >= left {
            return left;
        }
        self.slip = if f.abs() > self.friction { f.signum() } else { g.signum() };
        until.max(0.0)
    }

    /// How long it slips one way; then it rests or the time is over.
    fn slide(&mut self, at: &mut Place, force: Ramp, left: f64) -> f64 {
        let force = force.from(0.0, -self.friction * self.slip);
        if let Some(until) = self.piece.stops(*at, force, left, self.slip) {
            // ẋ = 0: `rest` tells whether it stays
            *at = Place { x: self.piece.after(*at, force, until).x, v: 0.0 };
            self.slip = 0.0;
            return until;
        }
        *at = self.piece.after(*at, force, left);
        left
    }
}
