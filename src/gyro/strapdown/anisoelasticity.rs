//! # Purpose
//! The g² drift of a gyro with a float whose suspension gives way unlike along its spin and input axes, in a linear
//! vibration along both.
//!
//! # Method
//! The float of mass m lags behind an acceleration a by d, d̈ + 2ζω ḋ + ω² d = a, with its own ω along each axis. The
//! force of inertia −m a at the place −d has about the output axis the moment M_o = m(a_i d_s − a_s d_i), which cannot
//! be told from H times a rate about the input axis:
//! drift = (m/H)(⟨a_i d_s⟩ − ⟨a_s d_i⟩). Far below both ω it is (m/H)(1/ω_s² − 1/ω_i²)⟨a_i a_s⟩, mass by the difference
//! of compliances; sines in phase of amplitudes p and q leave ½ p q of the mean product.
//!
//! # References
//! D. H. Titterton, J. L. Weston, Strapdown Inertial Navigation Technology, 2nd edition (2004), section 4.2 (anisoelastic
//! g² bias); P. H. Savet, Gyroscopes: Theory and Design (1961).

use super::anisoinertia::of_a_gyro;
use super::{Shaken, Vector};
use crate::Result;
use crate::lti::TransferFunction;

/// A float on a suspension of unlike stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Anisoelasticity {
    /// Input and spin axis: 0 to 2 for x, y, z.
    pub axes: [usize; 2],
    /// m, kg.
    pub mass: f64,
    /// H along the spin axis, N·m·s.
    pub momentum: f64,
    /// ω_i and ω_s of the float on its suspension along the two axes, rad/s.
    pub frequencies: [f64; 2],
    /// ζ of both.
    pub damping: f64,
}

impl Anisoelasticity {
    /// (m/H)(⟨a_i d_s⟩ − ⟨a_s d_i⟩) about the input axis, rad/s.
    ///
    /// # Errors
    /// `BadInput` for axes that are one or none, or no momentum; `Unstable` or `ImaginaryAxis` for a suspension without
    /// stiffness or damping; else as [`Vibration::shaping`](super::Vibration::shaping).
    pub fn drift(&self, shaken: &Shaken) -> Result<Vector> {
        let [input, spin] = of_a_gyro(self.axes, self.momentum)?;
        let a = Shaken::shapings(&shaken.linear)?;
        let given = |w: f64| TransferFunction::new(&[1.0], &[1.0, 2.0 * self.damping * w, w * w]);
        let [along_input, along_spin] = self.frequencies;
        // ⟨a_i d_s⟩ − ⟨a_s d_i⟩
        let arm = shaken.product(&a[input], &a[spin].then(&given(along_spin)?))?
            - shaken.product(&a[spin], &a[input].then(&given(along_input)?))?;
        let mut drift = [0.0; 3];
        drift[input] = self.mass * arm / self.momentum;
        Ok(drift)
    }
}
