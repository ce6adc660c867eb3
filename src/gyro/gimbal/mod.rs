//! The gyroscope in a rotating gimbal as a vibrating sensor of slow angular rates.
//!
//! Reference: V. G. Tereshin, "On the theory of a gyroscope in a rotating gimbal" (1978),
//! equation (1). Errata of the print: the dots on β′, α′, Θ″, Ψ″ are lost, and −I_x is missing in
//! the first gyroscopic coefficient (the two must be equal and opposite: such forces do no work).

mod check;
mod noise;
mod sensor;
mod simulate;

pub use noise::{Noise, NoiseEquivalent};
pub use sensor::{Band, Demodulator};
pub use simulate::{Run, Sample, State};

use num_complex::Complex64;

/// Moments of inertia of one body about its axes, kg·m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertia {
    /// I_x, kg·m².
    pub x: f64,
    /// I_y, kg·m².
    pub y: f64,
    /// I_z, kg·m².
    pub z: f64,
}

/// A gyroscope in a gimbal that turns uniformly.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `bodies` | I_x1 … I_z3; body 2 takes part in β only | kg·m² |
/// | `momentum` | H | N·m·s |
/// | `speed` | Ω, of the ring | rad/s |
/// | `springs` | c_x, c_y | N·m/rad |
/// | `damping` | d_x, d_y | N·m·s/rad |
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gimbal {
    /// Bodies 1, 2, 3.
    pub bodies: [Inertia; 3],
    /// H, N·m·s.
    pub momentum: f64,
    /// Ω, rad/s.
    pub speed: f64,
    /// c_x, c_y, N·m/rad.
    pub springs: [f64; 2],
    /// d_x, d_y, N·m·s/rad.
    pub damping: [f64; 2],
}

/// The coefficients of the two equations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// I_x − I_x2 and I_y, kg·m².
    pub inertia: [f64; 2],
    /// Stiffness of α and β with the ring's rotation, N·m/rad.
    pub stiffness: [f64; 2],
    /// The gyroscopic coefficient of both, N·m·s.
    pub gyroscopic: f64,
    /// What the base's rates meet: N·m·s.
    pub drive: [f64; 2],
}

impl Gimbal {
    /// A made example of laboratory size: no instrument of the source, which prints no numbers.
    pub fn example() -> Self {
        let body = |x: f64, y: f64, z: f64| Inertia { x: x * 1e-6, y: y * 1e-6, z: z * 1e-6 };
        Self {
            bodies: [body(2.0, 2.0, 3.5), body(0.4, 0.3, 0.3), body(1.0, 1.0, 1.8)],
            momentum: 2e-3,
            speed: 60.0,
            springs: [0.02, 0.02],
            damping: [2e-5, 2e-5],
        }
    }

    /// The names of its numbers in the symbol table.
    pub const NAMES: [&str; 15] =
        ["Ix1", "Iy1", "Iz1", "Ix2", "Iy2", "Iz2", "Ix3", "Iy3", "Iz3", "H", "Omega", "cx", "cy", "dx", "dy"];

    /// The place of a number by its name in the symbol table.
    ///
    /// ```
    /// let mut gimbal = gyrospec::gyro::gimbal::Gimbal::example();
    /// *gimbal.named("Iz3").unwrap() = 2e-6;
    /// assert!(gimbal.bodies[2].z == 2e-6 && gimbal.named("Iz4").is_none());
    /// ```
    pub fn named(&mut self, name: &str) -> Option<&mut f64> {
        let at = Self::NAMES.iter().position(|n| *n == name)?;
        Some(match at {
            0..9 => {
                let body = &mut self.bodies[at % 9 / 3];
                [&mut body.x, &mut body.y, &mut body.z].into_iter().nth(at % 3)?
            }
            9 => &mut self.momentum,
            10 => &mut self.speed,
            11 | 12 => &mut self.springs[at - 11],
            _ => &mut self.damping[at - 13],
        })
    }

    /// The coefficients of (1).
    pub fn coefficients(&self) -> Coefficients {
        let [one, two, three] = self.bodies;
        let (x, y, z) = (one.x + two.x + three.x, one.y + two.y + three.y, one.z + two.z + three.z);
        let (h, w) = (self.momentum, self.speed);
        // I_z − I_y − I_z2 + I_y2
        let flat = z - y - two.z + two.y;
        Coefficients {
            inertia: [x - two.x, y],
            // c_x + HΩ + (I_z − I_y − I_z2 + I_y2)Ω²,  c_y + HΩ + (I_z − I_x)Ω²
            stiffness: [self.springs[0] + h * w + flat * w * w, self.springs[1] + h * w + (z - x) * w * w],
            // H + (I_z − I_y − I_x − I_z2 + I_y2 + I_x2)Ω
            gyroscopic: h + (flat - x + two.x) * w,
            // H + (I_z − I_y + I_x − I_z2 + I_y2 − I_x2)Ω,  H + (I_z + I_y − I_x)Ω
            drive: [h + (flat + x - two.x) * w, h + (z + y - x) * w],
        }
    }

    /// det M(s) = A B s⁴ + (A d_y + B d_x) s³ + (A K₂ + B K₁ + Γ² + d_x d_y) s²
    /// + (d_x K₂ + d_y K₁) s + K₁K₂, descending.
    pub fn characteristic(&self) -> [f64; 5] {
        let Coefficients { inertia: [a, b], stiffness: [k1, k2], gyroscopic, .. } = self.coefficients();
        let [dx, dy] = self.damping;
        [a * b, a * dy + b * dx, a * k2 + b * k1 + gyroscopic.powi(2) + dx * dy, dx * k2 + dy * k1, k1 * k2]
    }

    /// The two frequencies of free motion without damping, rad/s, slow first; `None` when it grows.
    pub fn free_frequencies(&self) -> Option<[f64; 2]> {
        let undamped = Self { damping: [0.0; 2], ..*self };
        let [a, _, b, _, c] = undamped.characteristic();
        // a w⁴ − b w² + c = 0
        let inner = b * b - 4.0 * a * c;
        if inner < 0.0 || b <= 0.0 || c <= 0.0 {
            return None;
        }
        let larger = (b + inner.sqrt()) / (2.0 * a);
        Some([(c / (a * larger)).sqrt(), larger.sqrt()])
    }

    /// Kinetic and spring energy of the relative motion, J: constant without damping and drive.
    pub fn energy(&self, s: &State) -> f64 {
        let Coefficients { inertia: [a, b], stiffness: [k1, k2], .. } = self.coefficients();
        0.5 * (a * s.alpha_rate.powi(2)
            + b * s.beta_rate.powi(2)
            + k1 * s.alpha.powi(2)
            + k2 * s.beta.powi(2))
    }

    /// The common spring stiffness c_x = c_y that brings a free frequency to Ω, N·m/rad:
    /// the roots of det M(jΩ) = 0 without damping.
    pub fn tuned_springs(&self) -> Vec<f64> {
        let bare = Self { springs: [0.0; 2], damping: [0.0; 2], ..*self };
        let Coefficients { inertia: [a, b], stiffness: [k1, k2], gyroscopic, .. } = bare.coefficients();
        let w2 = self.speed * self.speed;
        // (c + K₁ − AΩ²)(c + K₂ − BΩ²) = Γ²Ω²
        let (p, q) = (k1 - a * w2, k2 - b * w2);
        let root = (0.25 * (p - q).powi(2) + gyroscopic.powi(2) * w2).sqrt();
        vec![-0.5 * (p + q) - root, -0.5 * (p + q) + root]
    }

    /// M(s)⁻¹, where M(s)(α, β)ᵀ = torques.
    pub(super) fn inverse(&self, s: Complex64) -> [[Complex64; 2]; 2] {
        let c = self.coefficients();
        let m11 = s * s * c.inertia[0] + s * self.damping[0] + c.stiffness[0];
        let m22 = s * s * c.inertia[1] + s * self.damping[1] + c.stiffness[1];
        let m12 = s * c.gyroscopic;
        let determinant = m11 * m22 + m12 * m12;
        [[m22 / determinant, -m12 / determinant], [m12 / determinant, m11 / determinant]]
    }
}
