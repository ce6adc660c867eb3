//! The roll spectrum of the rolling-error paper, (3.3) and (3.4).

use crate::lti::{Discrete, StateSpace, TransferFunction};
use crate::{Error, Result};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// Irregular roll: stationary, Gaussian, with the correlation function (3.3).
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `variance` | A | rad² |
/// | `decay` | μ | 1/s |
/// | `frequency` | ε | rad/s |
///
/// ```
/// use gyrospec::spectrum::Roll;
/// let roll = Roll::new(3.0e-2, 0.1, 0.8).unwrap();
/// assert!((roll.correlation(0.0) - 3.0e-2).abs() < 1e-17);     // K(0) = A
/// ```
///
/// Erratum of the source: (3.4) is printed in the convention K = ∫ S e^{jωτ} dω while the
/// formulas after it divide by 2π; and the last term of its denominator is b⁴, not b².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roll {
    /// A, the variance, rad².
    pub variance: f64,
    /// μ, the decay of the correlation, 1/s.
    pub decay: f64,
    /// ε, the prevailing frequency, rad/s.
    pub frequency: f64,
}

impl Roll {
    /// Irregular roll of variance A, decay μ and prevailing frequency ε.
    ///
    /// # Errors
    /// `BadInput` unless all three are finite and positive.
    pub fn new(variance: f64, decay: f64, frequency: f64) -> Result<Self> {
        for (name, value) in [("A", variance), ("mu", decay), ("eps", frequency)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::bad_input(format!("{name} of the roll must be positive, not {value}")));
            }
        }
        Ok(Self { variance, decay, frequency })
    }

    /// The names of its numbers in the symbol table: A, μ and ε.
    pub const NAMES: [&str; 3] = ["A", "mu", "eps"];

    /// The place of a number by its name in the symbol table.
    pub fn named(&mut self, name: &str) -> Option<&mut f64> {
        Some(match name {
            "A" => &mut self.variance,
            "mu" => &mut self.decay,
            "eps" => &mut self.frequency,
            _ => return None,
        })
    }

    /// b² = μ² + ε², 1/s².
    pub fn b2(&self) -> f64 {
        self.decay * self.decay + self.frequency * self.frequency
    }

    /// K(τ) = A e^{−μ|τ|} (cos ετ + (μ/ε) sin ε|τ|), rad², (3.3).
    pub fn correlation(&self, tau: f64) -> f64 {
        let (t, ratio) = (tau.abs(), self.decay / self.frequency);
        let phase = self.frequency * t;
        self.variance * (-self.decay * t).exp() * (phase.cos() + ratio * phase.sin())
    }

    /// S(ω) = 4Aμb²/(ω⁴ + 2aω² + b⁴), a = μ² − ε²; rad²·s.
    pub fn density(&self, omega: f64) -> f64 {
        let (w2, b2) = (omega * omega, self.b2());
        // ω⁴ + 2(μ² − ε²)ω² + b⁴ = (b² − ω²)² + 4μ²ω²
        let denominator = (b2 - w2).powi(2) + 4.0 * self.decay.powi(2) * w2;
        4.0 * self.variance * self.decay * b2 / denominator
    }

    /// F(s) = 2b√(Aμ)/(s² + 2μs + b²): white noise of unit intensity in, the roll angle out.
    pub fn shaping(&self) -> TransferFunction {
        let gain = 2.0 * (self.variance * self.decay * self.b2()).sqrt();
        // both coefficient lists are made of the checked, finite fields
        TransferFunction::new(&[gain], &[1.0, 2.0 * self.decay, self.b2()])
            .unwrap_or_else(|_| TransferFunction::constant(f64::NAN))
    }

    /// `count` samples at equal steps (s) of such a roll, rad, exact in distribution; the same
    /// seed gives the same numbers.
    pub fn samples(&self, step: f64, count: usize, seed: u64) -> Vec<f64> {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let system = StateSpace::from_transfer(&self.shaping());
        let mut discrete = Discrete::new(&system.a, &system.b, step);
        let gain = system.c[(0, 0)];
        // stationary start: θ and θ̇ independent, ⟨θ²⟩ = A, ⟨θ̇²⟩ = A b²
        let mut draw = |variance: f64| -> f64 {
            let xi: f64 = StandardNormal.sample(&mut rng);
            xi * variance.sqrt() / gain
        };
        let mut z = [draw(self.variance), draw(self.variance * self.b2())];
        (0..count)
            .map(|_| {
                let angle = gain * z[0];
                discrete.advance(&mut z, &mut rng);
                angle
            })
            .collect()
    }
}
