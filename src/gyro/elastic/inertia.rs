//! The elastic part with its inertia, (2.2).

use super::option::{Asked, PartOption};
use super::part::{Elastic, Letters, along, positive};
use super::suspension::Suspension;
use crate::Result;
use crate::gyro::Gyrosphere;
use crate::lti::{StateSpace, TransferFunction};

/// m ẍ + r ẋ + C₀ x = m W₁ with m = P/g and r = T C₀, along the parallel.
///
/// | symbol | meaning | unit | where |
/// |---|---|---|---|
/// | m | P/g, mass of the gyrosphere | kg | [`Gyrosphere::weight`] |
/// | r | T C₀, viscous coefficient | N·s/m | [`Gyrosphere::lag`] |
/// | C₀ | stiffness | N/m | [`Gyrosphere::stiffness`] |
///
/// Reference: the rolling-error paper, (2.2).
#[derive(Debug, Clone, Copy, Default)]
pub struct Inertia;

pub(super) const ASKED: Asked = Asked {
    options: &[PartOption {
        name: "inertia",
        numbers: "",
        ranges: &[],
        help: "The elastic part with its inertia, (2.2) in place of (2.3) of Potemkin 1978",
    }],
    make: |_| Box::new(Inertia),
};

impl Elastic for Inertia {
    fn name(&self) -> &'static str {
        "lag with inertia (2.2)"
    }

    fn system(&self, s: &Gyrosphere, _: &StateSpace) -> Result<StateSpace> {
        let m = s.weight / s.gravity;
        oscillator(m, s.lag * s.stiffness, s.stiffness)
    }

    fn enters(&self, suspension: &mut Suspension) -> Result<()> {
        suspension.inertia = true;
        Ok(())
    }

    fn letters(&self) -> Option<Letters> {
        // m ẍ + r ẋ + C₀ x = m W₁, W₁ = −h θ̈ cos K
        Some(Letters::of("-m*h*cos(K)/(m*s^2 + r*s + C0)", "P m h A mu b H U g r C0"))
    }
}

/// m ẍ + r ẋ + c x = m W₁ with the states (x, ẋ).
pub(super) fn oscillator(m: f64, r: f64, c: f64) -> Result<StateSpace> {
    along(&[(0, single(m, r, c)?)])
}

/// The same with one input and one output.
pub(super) fn single(m: f64, r: f64, c: f64) -> Result<StateSpace> {
    positive(&[("m", m), ("r", r), ("C0", c)])?;
    Ok(StateSpace::from_transfer(&TransferFunction::new(&[1.0], &[1.0, r / m, c / m])?))
}
