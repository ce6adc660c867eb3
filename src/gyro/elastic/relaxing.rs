//! A second relaxing part: liquid that flows over.

use super::{Elastic, along, positive};
use crate::Result;
use crate::gyro::Gyrosphere;
use crate::lti::{StateSpace, TransferFunction};

/// x = x₁ + x₂: T ẋ₁ + x₁ = P W₁/(g C₀) and T₂ ẋ₂ + x₂ = κ P W₁/(g C₀).
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `time` | T₂, time of the flow | s |
/// | `share` | κ, its give as a part of the spring's | 1 |
///
/// Reference: the rolling-error paper names "flow of the liquids" beside elasticity (section 1);
/// the form is the standard second relaxation of a linear solid.
#[derive(Debug, Clone, Copy)]
pub struct Relaxing {
    /// T₂, s.
    pub time: f64,
    /// κ; negative when the liquid runs against the spring's give.
    pub share: f64,
}

impl Elastic for Relaxing {
    fn name(&self) -> &'static str {
        "lag and liquid flow"
    }

    fn system(&self, s: &Gyrosphere, _: &StateSpace) -> Result<StateSpace> {
        positive(&[("T", s.lag), ("C0", s.stiffness), ("T2", self.time)])?;
        let give = s.weight / (s.gravity * s.stiffness);
        let spring = TransferFunction::new(&[give], &[s.lag, 1.0])?;
        let liquid = TransferFunction::new(&[self.share * give], &[self.time, 1.0])?;
        along(&[(0, StateSpace::from_transfer(&spring)), (0, StateSpace::from_transfer(&liquid))])
    }
}
