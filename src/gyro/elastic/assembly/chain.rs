//! A suspension without inertia: f = m W₁, and every give stands beside the others.

use crate::Result;
use crate::gyro::Gyrosphere;
use crate::gyro::elastic::part::positive;
use crate::gyro::elastic::suspension::Suspension;
use crate::lti::{StateSpace, TransferFunction};

/// Lag, flow, slosh and swing along the parallel.
pub(super) fn massless(s: &Gyrosphere, suspension: &Suspension) -> Result<Vec<(usize, StateSpace)>> {
    positive(&[("T", s.lag), ("C0", s.stiffness)])?;
    let give = s.weight / (s.gravity * s.stiffness);
    // T ẋ₁ + x₁ = m W₁/C₀
    let mut gives = vec![TransferFunction::new(&[give], &[s.lag, 1.0])?];
    if let Some(flow) = suspension.flow {
        positive(&[("T2", flow.time)])?;
        // T₂ ẋ₂ + x₂ = κ m W₁/C₀
        gives.push(TransferFunction::new(&[flow.share * give], &[flow.time, 1.0])?);
    }
    if let Some(swing) = suspension.swing {
        positive(&[("omega", swing.frequency), ("zeta", swing.damping)])?;
        // μ ξ with ξ̈ + 2ζω ξ̇ + ω² ξ = W₁
        let (w, z) = (swing.frequency, swing.damping);
        gives.push(TransferFunction::new(&[swing.share], &[1.0, 2.0 * z * w, w * w])?);
    }
    if let Some(tilt) = suspension.tilt {
        gives.push(tilt.give(s)?);
    }
    Ok(gives.iter().map(|w| (0, StateSpace::from_transfer(w))).collect())
}
