//! # Purpose
//! Several elastic parts together: one suspension, one system, one I_n.
//!
//! # Method
//! Along the parallel the gyrosphere of mass m = P/g hangs on a suspension that hands the force f on to the ship. Of
//! its mass the part μ is liquid that swings at ξ beside the vessel, at the height of the suspension; and about the
//! suspension the sphere swings by γ with its rotors ([`Pendulum`](super::Pendulum)). The vessel's own give is x_v, so
//! that the centre of mass lies at x = x_v + μ ξ + l γ. Newton's law of the whole, that of the liquid beside the vessel,
//! and that of the moments of the sphere, by the Lagrangian, are
//!
//! ```text
//! m ẍ + f = m W₁
//! ξ̈ + 2ζω ξ̇ + ω² ξ = W₁ − ẍ_v                                              sloshing liquid
//! J γ̈ + d γ̇ + lP γ + Γ δ̇ = (lP/g)(W₁ − ẍ_v),   c δ̇ + k δ = Γ γ̇            the sphere's own swing
//! ```
//!
//! The suspension is a chain: what stands in series carries the same f and the gives add, x_v = x₁ + x₂; what stands
//! side by side gives by the same x₁ and the forces add:
//!
//! ```text
//! f = r ẋ₁ + C₀ x₁                     the lag (2.3), r = T C₀
//!   + F_c sign ẋ₁                      dry friction, beside spring and dashpot
//!   with C₀ d(x₁) in place of C₀ x₁    free play, in series with the spring alone: dashpot and friction act in it
//! f = (C₀/κ)(T₂ ẋ₂ + x₂)               liquid flow, in series with all of them
//! ```
//!
//! (2.3) leaves ẍ away against W₁. Without inertia, friction or free play so does a combination, in all of these
//! laws: then f = m W₁, and the gives of lag, flow, slosh and swing stand side by side. Inertia brings ẍ back, friction and
//! free play hold it in their law. Eliminated, with J = 1/(r s + C₀) + κ/(C₀(T₂ s + 1)), L = 1/(s² + 2ζω s + ω²), N the
//! swing's l γ a unit of W₁, A = μ L + N and M = m(1 − s² A), that is x_v = M J/(1 + M J s²) W₁ and
//! x = x_v + A (W₁ − s² x_v).
//!
//! Along the meridian and the vertical stand spring and dashpot alone, C₁ T₁ ẏ + C₁ y = m W₂ and the like; a mass is
//! heavy in all directions, so that with inertia m ÿ stands there too. Flow, slosh, swing, friction and free play act
//! along the parallel, as they do alone. Each part once; what makes no sense together is refused: inertia of a vessel
//! without mass (μ = 1, or a swing of less inertia than m l²), friction in series with a liquid that runs against the force (κ < 0), and a liquid that runs
//! against it so much that the suspension drives itself.
//!
//! Parts that are not linear have their linear stand-in by the Gaussian closure of each, r + F_c √(2/π)/σ(ẋ₁) and
//! C₀ erfc(δ/(√2 σ(x₁))), both σ of the whole suspension: one joint fixed point. Their own law is followed in time
//! ([`switched`]).
//!
//! # References
//! The rolling-error paper, (2.2), (2.3); those of each part; R. H. Cannon, Dynamics of Physical Systems (1967), ch. 2,
//! for elements in series and side by side.
//!
//! # Numerical aspects
//! The joint fixed point takes the two closures in turn until neither moves by 10⁻⁹.

mod balance;
mod chain;
mod closure;
mod inside;
mod letters;
mod switched;

use super::backlash::Backlash;
use super::friction::Friction;
use super::in_time::InTime;
use super::part::{Elastic, Letters, along};
use super::suspension::Suspension;
use crate::gyro::Gyrosphere;
use crate::lti::{StateSpace, TransferFunction};
use crate::{Error, Result};
use balance::Balance;
use switched::Switched;

/// Several parts together.
///
/// ```
/// use gyrospec::gyro::elastic::{Elastic, Friction, Relaxing, together};
/// let parts: Vec<Box<dyn Elastic>> =
///     vec![Box::new(Relaxing { time: 4.0, share: 0.1 }), Box::new(Friction { force: 2.0 })];
/// let all = together(&parts)?;
/// assert_eq!(all.name(), "lag with inertia (2.2), liquid flow and dry friction");
/// # Ok::<(), gyrospec::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Assembly {
    suspension: Suspension,
    name: String,
}

/// One part that stands for all: the only one itself, the lag where there is none, an [`Assembly`] of several.
///
/// # Errors
/// `Usage` for a part that stands alone, and for one that comes twice.
pub fn together(parts: &[Box<dyn Elastic>]) -> Result<Box<dyn Elastic>> {
    if let [only] = parts {
        return Ok(only.clone());
    }
    let mut suspension = Suspension::default();
    parts.iter().try_for_each(|part| part.enters(&mut suspension))?;
    Ok(Box::new(Assembly::of(suspension)))
}

impl Assembly {
    /// What a suspension makes together.
    pub fn of(suspension: Suspension) -> Self {
        let name = suspension.name();
        Self { suspension, name }
    }

    /// Its entries.
    pub fn suspension(&self) -> &Suspension {
        &self.suspension
    }

    /// The parallel's part of the system, side by side.
    fn parallel(&self, s: &Gyrosphere, acceleration: &StateSpace) -> Result<Vec<(usize, StateSpace)>> {
        if !self.suspension.inertia {
            return chain::massless(s, &self.suspension);
        }
        let balance = Balance::new(s, &self.suspension)?;
        let part = match closure::stand_in(balance, &self.suspension, acceleration)? {
            Some(linear) => linear.moving_part()?,
            None => balance.stuck_part()?,
        };
        Ok(vec![(0, part)])
    }

    /// The elastic part along the meridian and the vertical.
    fn others(&self, s: &Gyrosphere) -> Result<Vec<(usize, StateSpace)>> {
        let mut out = Vec::new();
        for (axis, part) in [(1, self.suspension.meridian), (2, self.suspension.vertical)] {
            let Some((stiffness, time)) = part else { continue };
            let mass = s.weight / s.gravity;
            super::part::positive(&[("a stiffness", stiffness), ("a time", time)])?;
            // m ÿ + C₁ T₁ ẏ + C₁ y = m W₂
            let lead = if self.suspension.inertia { vec![mass / stiffness] } else { Vec::new() };
            let below = [lead, vec![time, 1.0]].concat();
            let give = TransferFunction::new(&[mass / stiffness], &below)?;
            out.push((axis, StateSpace::from_transfer(&give)));
        }
        Ok(out)
    }
}

impl Elastic for Assembly {
    fn name(&self) -> &str {
        &self.name
    }

    fn enters(&self, suspension: &mut Suspension) -> Result<()> {
        if *suspension == Suspension::default() {
            suspension.clone_from(&self.suspension);
            return Ok(());
        }
        Err(Error::usage("an assembly enters another first"))
    }

    fn system(&self, s: &Gyrosphere, acceleration: &StateSpace) -> Result<StateSpace> {
        let mut parts = self.parallel(s, acceleration)?;
        parts.extend(self.others(s)?);
        along(&parts)
    }

    fn across(&self, s: &Gyrosphere) -> Result<Option<StateSpace>> {
        let others = self.others(s)?;
        if others.is_empty() { Ok(None) } else { along(&others).map(Some) }
    }

    fn tightened(&self) -> Option<Box<dyn Elastic>> {
        // friction of no force: linear, and followed in time like the part itself
        let tight = Suspension { friction: Some(0.0), gap: None, ..self.suspension.clone() };
        Some(Box::new(Self::of(tight)))
    }

    fn in_time(&self, s: &Gyrosphere, step: f64) -> Result<Option<Box<dyn InTime>>> {
        if self.suspension.is_linear() {
            return Ok(None);
        }
        let balance = Balance::new(s, &self.suspension)?;
        let Suspension { flow: None, swing: None, tilt: None, friction, gap, .. } = self.suspension else {
            return self.switched(&balance, step).map(Some);
        };
        // one law on one mass is solved in closed form
        match (friction, gap) {
            (Some(force), None) => Friction { force }.in_time(s, step),
            (None, Some(gap)) => Backlash { gap }.in_time(s, step),
            _ => self.switched(&balance, step).map(Some),
        }
    }

    fn letters(&self) -> Option<Letters> {
        letters::letters(&self.suspension)
    }

    fn idle(&self) -> &'static str {
        if self.suspension.vertical.is_some() { "compliance along the vertical" } else { "" }
    }
}

impl Assembly {
    fn switched(&self, balance: &Balance, step: f64) -> Result<Box<dyn InTime>> {
        let laws = (self.suspension.friction.unwrap_or(0.0), self.suspension.gap.unwrap_or(0.0));
        // with W₁, Ẇ₁ and K; most balances need no more than eight
        if balance.order() + 3 <= 8 {
            return Ok(Box::new(Switched::<8>::new(balance, laws, step)?));
        }
        Ok(Box::new(Switched::<12>::new(balance, laws, step)?))
    }
}
