//! Compliance along the parallel, the meridian and the vertical.

use super::option::{Asked, PartOption};
use super::part::{Elastic, Letters, along, positive};
use super::suspension::Suspension;
use crate::Result;
use crate::gyro::{Gyrosphere, range};
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

pub(super) const ASKED: Asked = Asked {
    options: &[
        PartOption {
            name: "meridian",
            numbers: "STIFFNESS,TIME",
            ranges: &[&range::STIFFNESS, &range::RELAXATION],
            help: "Compliance along the meridian too: stiffness and time",
        },
        PartOption {
            name: "vertical",
            numbers: "STIFFNESS,TIME",
            ranges: &[&range::STIFFNESS, &range::RELAXATION],
            help: "Compliance along the vertical: stiffness and time; it changes the spread alone, not the mean",
        },
    ],
    make: |given| {
        let pair = |k: usize| given[k].as_ref().map(|v| (v[0], v[1]));
        Box::new(Compliance { meridian: pair(0), vertical: pair(1) })
    },
};

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

    fn enters(&self, suspension: &mut Suspension) -> Result<()> {
        if let Some(meridian) = self.meridian {
            Suspension::once(&mut suspension.meridian, meridian, "compliance along the meridian")?;
        }
        let Some(vertical) = self.vertical else { return Ok(()) };
        Suspension::once(&mut suspension.vertical, vertical, "compliance along the vertical")
    }

    fn letters(&self) -> Option<Letters> {
        // ⟨W₂ x − W₁ y⟩ with W₁ = −h θ̈ cos K, W₂ = h θ̈ sin K; the vertical changes no mean
        let both = "-P/g*h*cos(K)*(1/(C0*(T*s + 1)) - 1/(C_1*(T_1*s + 1)))";
        let shift = if self.meridian.is_some() { both } else { "-P/(g*C0)*h*cos(K)/(T*s + 1)" };
        Some(Letters::of(shift, "P h A mu b H U C0 g T"))
    }

    fn idle(&self) -> &'static str {
        if self.vertical.is_some() { "compliance along the vertical" } else { "" }
    }
}
