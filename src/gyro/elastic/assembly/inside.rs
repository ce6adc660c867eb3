//! What swings inside the mass beside the vessel: sloshing liquid by ξ, and the sphere about its north-south axis by
//! η = lγ with its rotors.
//!
//! Each is driven by what the vessel is accelerated with less its own give, a = W₁ − v̇:
//!
//! ```text
//! ξ̈ + 2ζω ξ̇ + ω² ξ = a                                  sloshing liquid, of the part μ of the mass
//! (1 − q) η̈ + 2ζω η̇ + ω² η + q u̇ = ν a,  τ u̇ + u = η̇      the swing, ν = lω²/g; without τ or q: η̈ + 2ζω η̇ + ω² η = ν a
//! ```
//!
//! and the centre of mass lies by μξ + η beside the vessel, so that Newton's law of the whole is
//! (1 − σ) m v̇ = (1 − σ) m W₁ − f + m p with σ = μ + ν/i, where i = 1 − q, or 1 without τ or q, and p = what the springs
//! and dashpots pull, each by its part μ or 1/i.

use crate::gyro::Gyrosphere;
use crate::gyro::elastic::part::positive;
use crate::gyro::elastic::suspension::{Suspension, Swing, Tilt};
use crate::{Error, Result};

/// A part of a row: place and factor.
type Entry = (usize, f64);

/// What swings inside; what gives nothing is not there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Inside {
    swing: Option<Swing>,
    /// With ν.
    tilt: Option<(Tilt, f64)>,
}

/// Whether the rotors follow with a memory of their own.
fn follows(tilt: &Tilt) -> bool {
    tilt.lag > 0.0 && tilt.coupling > 0.0
}

/// i.
fn inertia(tilt: &Tilt) -> f64 {
    if follows(tilt) { 1.0 - tilt.coupling } else { 1.0 }
}

impl Inside {
    /// # Errors
    /// `BadInput` for numbers of no part, and where no vessel is left.
    pub fn new(s: &Gyrosphere, suspension: &Suspension) -> Result<Self> {
        if let Some(swing) = &suspension.swing {
            positive(&[("omega", swing.frequency), ("zeta", swing.damping)])?;
        }
        let swing = suspension.swing.filter(|f| f.share != 0.0);
        let tilt = suspension
            .tilt
            .map(|t| t.give(s).map(|_| (t, s.pendulous / s.weight * t.frequency.powi(2) / s.gravity)));
        let tilt = tilt.transpose()?;
        let inside = Self { swing, tilt };
        let slosh = swing.map_or(0.0, |s| s.share);
        if !(0.0..1.0).contains(&slosh) {
            return Err(Error::bad_input(
                "all of the mass swings: no vessel is left whose inertia could count",
            )
            .with_hint("with inertia, friction or free play the swinging part of the mass is below 1"));
        }
        // J > m l²/(1 − μ), or the sphere would be lighter than its own centre of mass
        if inside.share() >= 1.0 {
            return Err(Error::bad_input(
                "this swing is faster than that of a mass on a thread as long as the sphere is pendulous: no sphere is left \
                 whose inertia could count",
            )
            .with_hint("with inertia, friction or free play (lP/P) ω²/g is below the sphere's own part of the inertia"));
        }
        Ok(inside)
    }

    /// σ.
    pub fn share(&self) -> f64 {
        self.swing.map_or(0.0, |s| s.share) + self.tilt.map_or(0.0, |(t, lean)| lean / inertia(&t))
    }

    /// Number of states: ξ, ξ̇; η, η̇ and, where the rotors follow, u.
    pub fn order(&self) -> usize {
        let tilt = self.tilt.map_or(0, |(t, _)| 2 + usize::from(follows(&t)));
        self.tilt_at(0) + tilt
    }

    /// Place of η, where the first state is at `at`.
    fn tilt_at(&self, at: usize) -> usize {
        at + 2 * usize::from(self.swing.is_some())
    }

    /// The fastest rate at which anything rings, rad/s; 0 where nothing does.
    pub fn ringing(&self) -> f64 {
        let tilt = self.tilt.map_or(0.0, |(t, _)| t.frequency / inertia(&t).sqrt());
        self.swing.map_or(0.0, |s| s.frequency).max(tilt)
    }

    /// μξ + η.
    pub fn give(&self, at: usize) -> Vec<Entry> {
        let slosh = self.swing.map(|s| (at, s.share));
        slosh.into_iter().chain(self.tilt.map(|_| (self.tilt_at(at), 1.0))).collect()
    }

    /// p.
    pub fn pull(&self, at: usize) -> Vec<Entry> {
        let mut pull = Vec::new();
        if let Some(s) = &self.swing {
            pull.extend(scaled(s.share, slosh(s, at)));
        }
        if let Some((t, _)) = &self.tilt {
            pull.extend(scaled(1.0 / inertia(t), swinging(t, self.tilt_at(at))));
        }
        pull
    }

    /// The rate of each state: its place, its part of a, and its part of the states.
    pub fn rates(&self, at: usize) -> Vec<(usize, f64, Vec<Entry>)> {
        let mut rates = Vec::new();
        if let Some(s) = &self.swing {
            rates.push((at, 0.0, vec![(at + 1, 1.0)]));
            rates.push((at + 1, 1.0, scaled(-1.0, slosh(s, at))));
        }
        if let Some((t, lean)) = &self.tilt {
            let (at, i) = (self.tilt_at(at), inertia(t));
            rates.push((at, 0.0, vec![(at + 1, 1.0)]));
            rates.push((at + 1, lean / i, scaled(-1.0 / i, swinging(t, at))));
            if follows(t) {
                // τ u̇ = η̇ − u
                rates.push((at + 2, 0.0, vec![(at + 1, 1.0 / t.lag), (at + 2, -1.0 / t.lag)]));
            }
        }
        rates
    }
}

/// 2ζω ξ̇ + ω² ξ.
fn slosh(s: &Swing, at: usize) -> Vec<Entry> {
    vec![(at, s.frequency.powi(2)), (at + 1, 2.0 * s.damping * s.frequency)]
}

/// 2ζω η̇ + ω² η + q u̇, with u̇ = (η̇ − u)/τ.
fn swinging(t: &Tilt, at: usize) -> Vec<Entry> {
    let mut pull = vec![(at, t.frequency.powi(2)), (at + 1, 2.0 * t.damping * t.frequency)];
    if follows(t) {
        let by = t.coupling / t.lag;
        pull.extend([(at + 1, by), (at + 2, -by)]);
    }
    pull
}

fn scaled(factor: f64, entries: Vec<Entry>) -> Vec<Entry> {
    entries.into_iter().map(|(at, x)| (at, factor * x)).collect()
}
