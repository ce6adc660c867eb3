//! A second relaxing part: liquid that flows over.

use super::option::{Asked, PartOption, first};
use super::part::{Elastic, Letters, along, positive};
use super::suspension::{Flow, Suspension};
use crate::gyro::{Gyrosphere, range};
use crate::lti::{StateSpace, TransferFunction};
use crate::{Error, Result};

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

pub(super) const ASKED: Asked = Asked {
    options: &[PartOption {
        name: "flow",
        numbers: "TIME,SHARE",
        ranges: &[&range::RELAXATION, &range::SHARE],
        help: "A second relaxing part, liquid flow: its time and its give as a part of the spring's",
    }],
    make: |given| {
        let numbers = first(given);
        Box::new(Relaxing { time: numbers[0], share: numbers[1] })
    },
};

impl Elastic for Relaxing {
    fn name(&self) -> &'static str {
        "lag and liquid flow"
    }

    fn system(&self, s: &Gyrosphere, _: &StateSpace) -> Result<StateSpace> {
        positive(&[("T", s.lag), ("C0", s.stiffness), ("T2", self.time)])?;
        // at rest the whole gives by 1 + κ of the spring's part
        if self.share <= -1.0 {
            let share = self.share;
            let message = format!(
                "with a share of {share} the liquid gives against the force as much as the spring or more"
            );
            return Err(Error::bad_input(message).with_hint("the share must be above -1"));
        }
        let give = s.weight / (s.gravity * s.stiffness);
        let spring = TransferFunction::new(&[give], &[s.lag, 1.0])?;
        let liquid = TransferFunction::new(&[self.share * give], &[self.time, 1.0])?;
        along(&[(0, StateSpace::from_transfer(&spring)), (0, StateSpace::from_transfer(&liquid))])
    }

    fn enters(&self, suspension: &mut Suspension) -> Result<()> {
        let flow = Flow { time: self.time, share: self.share };
        Suspension::once(&mut suspension.flow, flow, "liquid flow")
    }

    fn letters(&self) -> Option<Letters> {
        // two relaxations side by side
        let shift = "-P/(g*C0)*h*cos(K)*(1/(T*s + 1) + kappa/(T_2*s + 1))";
        Some(Letters::of(shift, "P h A mu b H U C0 g T"))
    }
}
