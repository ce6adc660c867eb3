//! # Purpose
//! The drift of a dry-tuned rotor that an angular vibration of its case at twice its speed makes, and the random walk
//! that a random one makes.
//!
//! # Method
//! A rotor on one gimbal (Hooke's joint) that turns with N is the gyroscope in a rotating gimbal of (1) with H = 0, the
//! gimbal as the body that takes part in one angle. Tuned, c_x = c_y = ½(A_g + B_g − C_g)N², rates of the case about an
//! axis across the spin axis at ∓2N come out at ±N beside those of a constant rate, by the part
//! κ = (A_g + B_g − C_g)/(4C) of what a constant rate gives, to first order in the gimbal's inertia.
//! An angle θ₀ sin(2Nt + ψ) is a rate of amplitude 2Nθ₀, half of it at −2N: drift = κ N θ₀ along a direction set by ψ.
//! A random rate of density S(2N) (two-sided) is read as white noise of density ½κ²S(2N) about each axis.
//!
//! # References
//! (1) of the gimbal paper as put right; R. J. G. Craig, Theory of operation of an elastically supported, tuned
//! gyroscope, IEEE Trans. AES-8 (1972) 280–288, and Theory of errors of a multigimbal, elastically supported, tuned
//! gyroscope, the same, 289–297: tuning, figure of merit, and vibration at twice the speed.

use super::Vibration;
use crate::Result;

/// A dry-tuned rotor on one gimbal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TunedRotor {
    /// N, rad/s.
    pub speed: f64,
    /// C, of the rotor about its spin axis, kg·m².
    pub spin_inertia: f64,
    /// A_g + B_g − C_g of the gimbal, kg·m².
    pub gimbal_inertia: f64,
}

impl TunedRotor {
    /// C/(A_g + B_g − C_g).
    pub fn figure_of_merit(&self) -> f64 {
        self.spin_inertia / self.gimbal_inertia
    }

    /// c_x = c_y that tune the rotor, N·m/rad.
    pub fn tuned_spring(&self) -> f64 {
        // c = ½(A_g + B_g − C_g)N²
        0.5 * self.gimbal_inertia * self.speed * self.speed
    }

    /// κ: what a rate of the case at ∓2N is read as, for one of 1.
    pub fn fold(&self) -> f64 {
        // κ = (A_g + B_g − C_g)/(4C)
        0.25 / self.figure_of_merit()
    }

    /// The drift by an angle of amplitude `amplitude` (rad) at 2N in step with the rotor, rad/s.
    pub fn drift(&self, amplitude: f64) -> f64 {
        // κ·½·2N θ₀
        self.fold() * self.speed * amplitude
    }

    /// The angle random walk that a random vibration about an axis across the spin axis makes, rad/√s.
    ///
    /// # Errors
    /// As [`Vibration::shaping`].
    pub fn walk(&self, angular: &Vibration) -> Result<f64> {
        let twice = 2.0 * self.speed;
        // √(½κ²S), S = (2N)²|F(j2N)|²
        Ok(self.fold() * twice * (0.5 * angular.shaping()?.power(twice)).sqrt())
    }
}
