//! The paper's elastic lag, (2.3).

use super::part::{Elastic, Letters, along, positive};
use super::suspension::Suspension;
use crate::Result;
use crate::gyro::Gyrosphere;
use crate::lti::{StateSpace, TransferFunction};

/// T ẋ + x = P W₁/(g C₀): a massless spring with a dashpot, along the parallel alone.
///
/// | symbol | meaning | unit | where |
/// |---|---|---|---|
/// | T | r/C₀, time constant | s | [`Gyrosphere::lag`] |
/// | C₀ | stiffness | N/m | [`Gyrosphere::stiffness`] |
///
/// Reference: the rolling-error paper, (2.3).
#[derive(Debug, Clone, Copy, Default)]
pub struct Lag;

impl Elastic for Lag {
    fn name(&self) -> &'static str {
        "lag (2.3)"
    }

    fn system(&self, s: &Gyrosphere, _: &StateSpace) -> Result<StateSpace> {
        positive(&[("T", s.lag), ("C0", s.stiffness)])?;
        // T ẋ + x = P W₁/(g C₀)
        let give = TransferFunction::new(&[s.weight / (s.gravity * s.stiffness)], &[s.lag, 1.0])?;
        along(&[(0, StateSpace::from_transfer(&give))])
    }

    fn enters(&self, _: &mut Suspension) -> Result<()> {
        // spring and dashpot are in every suspension
        Ok(())
    }

    fn letters(&self) -> Option<Letters> {
        // T ẋ + x = P W₁/(g C₀), W₁ = −h θ̈ cos K
        Some(Letters::of("-P/(g*C0)*h*cos(K)/(T*s + 1)", "P h A mu b H U C0 g T"))
    }
}
