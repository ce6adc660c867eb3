//! Compliance along the parallel, the meridian and the vertical.

use super::{Elastic, along, positive};
use crate::Result;
use crate::gyro::Gyrosphere;
use crate::lti::{StateSpace, TransferFunction};

/// Tᵢ ẋᵢ + xᵢ = P Wᵢ/(g Cᵢ) along each of the three directions; the first is the paper's.
/// Where the first two agree the errors along them cancel: only their difference shows.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `meridian` | (C₁, T₁) | N/m, s |
/// | `vertical` | (C₂, T₂) | N/m, s |
///
/// Reference: M_y = (P/g)(W₂ x − W₁ y), the moment of the inertia force at the shift (x, y).
#[derive(Debug, Clone, Copy)]
pub struct Compliance {
    /// Stiffness N/m and time s along the meridian; `None`: rigid.
    pub meridian: Option<(f64, f64)>,
    /// Stiffness N/m and time s along the vertical; `None`: rigid.
    pub vertical: Option<(f64, f64)>,
}

impl Elastic for Compliance {
    fn name(&self) -> &'static str {
        "compliance along three axes"
    }

    fn system(&self, s: &Gyrosphere, _: &StateSpace) -> Result<StateSpace> {
        let directions = [Some((s.stiffness, s.lag)), self.meridian, self.vertical];
        let mut parts = Vec::new();
        for (axis, part) in directions.into_iter().enumerate() {
            let Some((stiffness, time)) = part else { continue };
            positive(&[("a stiffness", stiffness), ("a time", time)])?;
            // T ẋ + x = P W/(g C)
            let give = TransferFunction::new(&[s.weight / (s.gravity * stiffness)], &[time, 1.0])?;
            parts.push((axis, StateSpace::from_transfer(&give)));
        }
        along(&parts)
    }
}
