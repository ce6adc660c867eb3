//! Liquid with a free surface that swings in its vessel.

use super::option::{Asked, PartOption, first};
use super::part::{Elastic, Letters, along, positive};
use super::suspension::{Suspension, Swing};
use crate::Result;
use crate::gyro::Gyrosphere;
use crate::gyro::range::{Range, range};
use crate::lti::{StateSpace, TransferFunction};

/// x = x₁ + μ ξ: T ẋ₁ + x₁ = P W₁/(g C₀) and ξ̈ + 2ζω ξ̇ + ω² ξ = W₁, the sphere's own lag and a mass of
/// liquid on a spring, which stands for the lowest swing of its surface.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `frequency` | ω, of the surface's lowest swing | rad/s |
/// | `damping` | ζ, its damping ratio | 1 |
/// | `share` | μ, the swinging mass as a part of the gyrosphere's | 1 |
///
/// Reference: H. N. Abramson (ed.), The Dynamic Behavior of Liquids in Moving Containers, NASA SP-106 (1966),
/// chapter 6, on equivalent mechanical models of lateral sloshing.
#[derive(Debug, Clone, Copy)]
pub struct Slosh {
    /// ω, rad/s.
    pub frequency: f64,
    /// ζ.
    pub damping: f64,
    /// μ.
    pub share: f64,
}

const FREQUENCY: Range = range("a frequency of sloshing", "rad/s", [0.05, 1e3]);
const DAMPING: Range = range("a damping ratio of sloshing", "1", [1e-4, 5.0]);
const SHARE: Range = range("a swinging part of the mass", "1", [1e-9, 1.0]);

pub(super) const ASKED: Asked = Asked {
    options: &[PartOption {
        name: "slosh",
        numbers: "FREQUENCY,DAMPING,SHARE",
        ranges: &[&FREQUENCY, &DAMPING, &SHARE],
        help: "Liquid that swings beside the lag: frequency, damping ratio, and its part of the mass",
    }],
    make: |given| {
        let numbers = first(given);
        Box::new(Slosh { frequency: numbers[0], damping: numbers[1], share: numbers[2] })
    },
};

impl Elastic for Slosh {
    fn name(&self) -> &'static str {
        "lag and sloshing liquid"
    }

    fn system(&self, s: &Gyrosphere, _: &StateSpace) -> Result<StateSpace> {
        positive(&[("T", s.lag), ("C0", s.stiffness), ("omega", self.frequency), ("zeta", self.damping)])?;
        let spring = TransferFunction::new(&[s.weight / (s.gravity * s.stiffness)], &[s.lag, 1.0])?;
        // μ/(s² + 2ζω s + ω²)
        let (w, z) = (self.frequency, self.damping);
        let liquid = TransferFunction::new(&[self.share], &[1.0, 2.0 * z * w, w * w])?;
        along(&[(0, StateSpace::from_transfer(&spring)), (0, StateSpace::from_transfer(&liquid))])
    }

    fn enters(&self, suspension: &mut Suspension) -> Result<()> {
        let swing = Swing { frequency: self.frequency, damping: self.damping, share: self.share };
        Suspension::once(&mut suspension.swing, swing, "sloshing liquid")
    }

    fn letters(&self) -> Option<Letters> {
        // both side by side, W₁ = −h θ̈ cos K
        let shift = "-h*cos(K)*(P/(g*C0*(T*s + 1)) + mu_s/(s^2 + 2*zeta*omega*s + omega^2))";
        Some(Letters::of(shift, "P h A mu b H U C0 g T mu_s zeta omega"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gyro::{Instrument, Motion};
    use crate::spectrum::Roll;
    use num_complex::Complex64;
    use std::f64::consts::{FRAC_PI_4, PI};

    /// α = ⟨W₂ x⟩ P/(g H U cos φ) by the trapezoidal rule over the spectrum of θ̈ behind two low-passes.
    fn by_trapezoids(sphere: &Gyrosphere, slosh: &Slosh, roll: &Roll, band: f64) -> f64 {
        let give = sphere.weight / (sphere.gravity * sphere.stiffness);
        let at = |w: f64| -> f64 {
            let s = Complex64::new(0.0, w);
            let (f, z) = (slosh.frequency, slosh.damping);
            let x = give / (s * sphere.lag + 1.0) + slosh.share / (s * s + 2.0 * z * f * s + f * f);
            let pass = 1.0 / (1.0 + (w / band).powi(2)).powi(2);
            roll.density(w) * w.powi(4) * pass * x.re
        };
        let step = 1e-4;
        let sum: f64 = (1..4_000_000).map(|k| at(f64::from(k) * step)).sum();
        // two-sided: 2·(1/2π); W₂ = h θ̈ sin K, W₁ = −h θ̈ cos K
        let moment = -sphere.lever.powi(2) * 0.5 * (2.0 * FRAC_PI_4).sin() * sum * step / PI;
        sphere.weight / sphere.gravity * moment
            / (sphere.momentum * sphere.earth_rate * sphere.latitude.cos())
    }

    #[test]
    fn the_mean_is_the_integral_over_the_spectrum() {
        let (sphere, roll) = (Gyrosphere::seed(), Roll::new(0.02, 0.1, 0.8).unwrap());
        for slosh in [
            Slosh { frequency: 1.5, damping: 0.1, share: 1e-5 },
            Slosh { frequency: 0.7, damping: 0.05, share: 3e-6 },
            Slosh { frequency: 6.0, damping: 1.0, share: 1e-3 },
        ] {
            let motion = Motion::roll(&roll).band_limited(3.0, 2).unwrap();
            let mean = Instrument::new(sphere, Box::new(slosh)).rectified_error(&motion, FRAC_PI_4).unwrap();
            let wanted = by_trapezoids(&sphere, &slosh, &roll, 3.0);
            assert!((mean / wanted - 1.0).abs() < 1e-6, "{slosh:?}: {mean} and {wanted}");
        }
    }
}
