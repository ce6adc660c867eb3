//! # Purpose
//! The drift of a gyro with a float (single degree of freedom) whose moments of inertia about its spin and input axes
//! differ, in an angular vibration about both.
//!
//! # Method
//! Euler's equation about the output axis, with H along the spin axis s, is
//! I_o ω̇_o = M_o + H ω_i + (I_s − I_i) ω_i ω_s: the product cannot be told from a rate about the input axis,
//! drift = (I_s − I_i)⟨φ̇_i φ̇_s⟩/H. Sines in phase of rate amplitudes p and q: ½ (I_s − I_i) p q/H.
//!
//! # References
//! D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd edition (2004), section 4.2
//! (anisoinertia); P. H. Savet, Gyroscopes: Theory and Design (1961).

use super::{Shaken, Vector};
use crate::{Error, Result};

/// A float of unlike moments of inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Anisoinertia {
    /// Input and spin axis: 0 to 2 for x, y, z.
    pub axes: [usize; 2],
    /// I_s − I_i, kg·m².
    pub difference: f64,
    /// H along the spin axis, N·m·s.
    pub momentum: f64,
}

impl Anisoinertia {
    /// (I_s − I_i)⟨φ̇_i φ̇_s⟩/H about the input axis, rad/s.
    ///
    /// # Errors
    /// `BadInput` for axes that are one or none, or no momentum; else as
    /// [`Vibration::shaping`](super::Vibration::shaping).
    pub fn drift(&self, shaken: &Shaken) -> Result<Vector> {
        let [input, spin] = of_a_gyro(self.axes, self.momentum)?;
        let phi = Shaken::shapings(&shaken.angular)?;
        let rates = shaken.product(&phi[input].differentiated()?, &phi[spin].differentiated()?)?;
        let mut drift = [0.0; 3];
        drift[input] = self.difference * rates / self.momentum;
        Ok(drift)
    }
}

/// The two axes, if they are two of three, and the momentum some.
pub(super) fn of_a_gyro(axes: [usize; 2], momentum: f64) -> Result<[usize; 2]> {
    if axes[0] == axes[1] || axes.iter().any(|a| *a > 2) {
        return Err(Error::bad_input("a gyro's input and spin axes are two of x, y, z"));
    }
    if !momentum.is_finite() || momentum == 0.0 {
        return Err(Error::bad_input("a gyro's angular momentum is a number and not 0"));
    }
    Ok(axes)
}
