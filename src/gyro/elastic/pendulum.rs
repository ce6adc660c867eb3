//! The sphere's own swing about its north-south axis, with the rotors that it turns.

use super::option::{Asked, PartOption, first};
use super::part::{Elastic, Letters, along, positive};
use super::suspension::{Suspension, Tilt};
use crate::gyro::Gyrosphere;
use crate::gyro::range::{Range, range};
use crate::lti::{StateSpace, TransferFunction};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// x = x₁ + l γ: T ẋ₁ + x₁ = P W₁/(g C₀), and the swing γ about the axis of the rotors, whose own axes stand ±ε from it,
/// held together by a spring k with a damping c, so that they turn by ±δ about the vertical:
/// J γ̈ + d γ̇ + lP γ + Γ δ̇ = (lP/g) W₁ and c δ̇ + k δ = Γ γ̇, Γ = 2 H₁ sin ε.
///
/// Slow against k/c the rotors add Γ²/k to the sphere's inertia, so that with ω² = lP/(J + Γ²/k), q = (Γ²/k)/(J + Γ²/k)
/// and τ = c/k
/// l γ/W₁ = (l/g) ω² (1 + τ s)/[((1 − q) s² + 2ζω s + ω²)(1 + τ s) + q s²], l = lP/P.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `period` | 2π/ω, of the swing with the rotors | s |
/// | `damping` | ζ, its damping ratio by the liquid about the sphere | 1 |
/// | `coupling` | q, the part of the rotors in its inertia | 1 |
/// | `lag` | τ, of the rotors behind the swing | s |
///
/// Reference: A. Yu. Ishlinsky, Mechanics of Gyroscopic Systems (Israel Program for Scientific Translations, 1965), on
/// the intercardinal deviation of a pendulous compass by its swing about the north-south axis; derived here from the
/// Lagrangian of sphere and rotors.
#[derive(Debug, Clone, Copy)]
pub struct Pendulum {
    /// 2π/ω, s.
    pub period: f64,
    /// ζ.
    pub damping: f64,
    /// q.
    pub coupling: f64,
    /// τ, s.
    pub lag: f64,
}

const PERIOD: Range = range("a period of the sphere's swing", "s", [0.05, 1e4]);
const DAMPING: Range = range("a damping ratio of the sphere's swing", "1", [1e-4, 5.0]);
const COUPLING: Range = range("the rotors' part of the swing's inertia", "1", [0.0, 0.999]);
const LAG: Range = range("the rotors' lag behind the swing", "s", [0.0, 1e4]);

pub(super) const ASKED: Asked = Asked {
    options: &[PartOption {
        name: "swing",
        numbers: "PERIOD,DAMPING,COUPLING,LAG",
        ranges: &[&PERIOD, &DAMPING, &COUPLING, &LAG],
        help: "The sphere's own swing about the north-south axis beside the lag: period, damping ratio, the rotors' part of \
               its inertia (0 for none), their lag",
    }],
    make: |given| {
        let numbers = first(given);
        let [period, damping, coupling, lag] = [numbers[0], numbers[1], numbers[2], numbers[3]];
        Box::new(Pendulum { period, damping, coupling, lag })
    },
};

impl Elastic for Pendulum {
    fn name(&self) -> &'static str {
        "lag and the sphere's own swing"
    }

    fn system(&self, s: &Gyrosphere, _: &StateSpace) -> Result<StateSpace> {
        positive(&[("T", s.lag), ("C0", s.stiffness)])?;
        let spring = TransferFunction::new(&[s.weight / (s.gravity * s.stiffness)], &[s.lag, 1.0])?;
        let swing = self.tilt().give(s)?;
        along(&[(0, StateSpace::from_transfer(&spring)), (0, StateSpace::from_transfer(&swing))])
    }

    fn enters(&self, suspension: &mut Suspension) -> Result<()> {
        Suspension::once(&mut suspension.tilt, self.tilt(), "a swing")
    }

    fn letters(&self) -> Option<Letters> {
        // both side by side, W₁ = −h θ̈ cos K
        let shift = "-h*cos(K)*(P/(g*C0*(T*s + 1)) + lP/(P*g)*omega^2*(tau*s + 1)\
                     /(((1 - q)*s^2 + 2*zeta*omega*s + omega^2)*(tau*s + 1) + q*s^2))";
        Some(Letters::of(shift, "P h A mu b H U C0 g T lP q tau zeta omega"))
    }
}

impl Pendulum {
    fn tilt(&self) -> Tilt {
        Tilt { frequency: TAU / self.period, damping: self.damping, coupling: self.coupling, lag: self.lag }
    }
}

impl Tilt {
    /// l γ a unit of W₁, where the give of the suspension is left away against it.
    ///
    /// # Errors
    /// `BadInput` for numbers that describe no swing.
    pub(super) fn give(&self, s: &Gyrosphere) -> Result<TransferFunction> {
        positive(&[("lP", s.pendulous), ("P", s.weight), ("omega", self.frequency), ("zeta", self.damping)])?;
        let Self { frequency: w, damping: z, coupling: q, lag: t } = *self;
        if !(t.is_finite() && t >= 0.0 && (0.0..1.0).contains(&q)) {
            return Err(Error::bad_input(format!(
                "the rotors take a part of the inertia below 1 and no lag below 0, not {q} and {t} s"
            )));
        }
        // (l/g) ω² (1 + τ s) over (1 − q) τ s³ + (1 + 2ζωτ) s² + (2ζω + ω²τ) s + ω²
        let give = s.pendulous / s.weight / s.gravity * w * w;
        let below = [(1.0 - q) * t, 1.0 + 2.0 * z * w * t, 2.0 * z * w + w * w * t, w * w];
        TransferFunction::new(&[give * t, give], &below)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gyro::seed::Regular;
    use crate::gyro::{Instrument, Motion};
    use crate::spectrum::Roll;
    use std::f64::consts::FRAC_PI_4;

    const SWINGS: [Pendulum; 3] = [
        Pendulum { period: 9.0, damping: 0.1, coupling: 0.0, lag: 0.0 },
        Pendulum { period: 25.0, damping: 0.3, coupling: 0.9, lag: 0.7 },
        Pendulum { period: 3.0, damping: 0.05, coupling: 0.5, lag: 4.0 },
    ];

    /// The mean of α on regular roll, by Runge and Kutta's method of fourth order on sphere and rotors as they stand
    /// above, from J, d, Γ, k and c; `x` alone is followed, and ⟨W₂ x⟩ taken over whole periods.
    fn simulated(s: &Gyrosphere, p: &Pendulum, roll: &Regular, heading: f64) -> f64 {
        let w = TAU / p.period;
        let inertia = s.pendulous / (w * w);
        let (j, d) = ((1.0 - p.coupling) * inertia, 2.0 * p.damping * w * inertia);
        // k = 1 N·m/rad: only Γ²/k and c/k matter
        let (k, gamma) = (1.0, (p.coupling * inertia).sqrt());
        let c = p.lag * k;
        let w1 = |t: f64| {
            s.lever * roll.amplitude * roll.frequency.powi(2) * (roll.frequency * t).sin() * heading.cos()
        };
        let rates = |t: f64, y: [f64; 4]| {
            let [x, swing, rate, turn] = y;
            // without damping δ = Γ γ̇/k follows at once, and its rate belongs to the inertia
            let (turning, heavy) =
                if c > 0.0 { ((gamma * rate - k * turn) / c, j) } else { (0.0, j + gamma * gamma / k) };
            let torque = s.pendulous / s.gravity * w1(t) - d * rate - s.pendulous * swing - gamma * turning;
            [(s.weight * w1(t) / (s.gravity * s.stiffness) - x) / s.lag, rate, torque / heavy, turning]
        };
        let (period, points) = (TAU / roll.frequency, 2000);
        let step = period / f64::from(points);
        let plus = |y: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
        let (mut y, mut sum) = ([0.0; 4], 0.0);
        let settle = 400;
        for i in 0..(settle + 1) * points {
            let t = f64::from(i) * step;
            if i >= settle * points {
                // W₂ = −W₁ tan K
                sum -= w1(t) * heading.tan() * (y[0] + s.pendulous / s.weight * y[1]);
            }
            let a = rates(t, y);
            let b = rates(t + 0.5 * step, plus(y, a, 0.5 * step));
            let e = rates(t + 0.5 * step, plus(y, b, 0.5 * step));
            let f = rates(t + step, plus(y, e, step));
            y = std::array::from_fn(|i| y[i] + step / 6.0 * (a[i] + 2.0 * (b[i] + e[i]) + f[i]));
        }
        let mean = sum / f64::from(points);
        s.weight / s.gravity * mean / (s.momentum * s.earth_rate * s.latitude.cos())
    }

    #[test]
    fn on_regular_roll_it_is_as_simulated() {
        let (sphere, roll) = (Gyrosphere::seed(), Regular { amplitude: 0.02, frequency: 0.9 });
        for swing in SWINGS {
            let compass = Instrument::new(sphere, Box::new(swing));
            let mine = compass.regular_error(&roll, 0.6).unwrap().rectified;
            let other = simulated(&sphere, &swing, &roll, 0.6);
            assert!((mine / other - 1.0).abs() < 1e-5, "{swing:?}: {mine} and {other}");
        }
    }

    #[test]
    fn a_swing_that_never_comes_leaves_the_lag() {
        let (sphere, roll) = (Gyrosphere::seed(), Roll::new(0.02, 0.1, 0.8).unwrap());
        let motion = Motion::roll(&roll).band_limited(3.0, 2).unwrap();
        let mean = |part: Box<dyn Elastic>| {
            Instrument::new(sphere, part).rectified_error(&motion, FRAC_PI_4).unwrap()
        };
        let slow = Pendulum { period: 1e4, damping: 0.1, coupling: 0.3, lag: 1.0 };
        let (with, without) = (mean(Box::new(slow)), mean(Box::new(crate::gyro::elastic::Lag)));
        // above its own frequency the swing is against W₁ and falls with its square
        assert!((with / without - 1.0).abs() < 1e-4, "{with} and {without}");
        // and a quick one leans with the apparent vertical: l/g beside P/(g C₀)
        let quick = Pendulum { period: 0.05, damping: 1.0, coupling: 0.0, lag: 0.0 };
        let lean = sphere.pendulous / sphere.weight / sphere.gravity;
        let stiff = Gyrosphere { lag: 1e-6, ..sphere };
        let both = Instrument::new(stiff, Box::new(quick)).rectified_error(&motion, FRAC_PI_4).unwrap();
        let alone = Instrument::new(stiff, Box::new(crate::gyro::elastic::Lag))
            .rectified_error(&motion, FRAC_PI_4)
            .unwrap();
        let wanted = 1.0 + lean / (sphere.weight / (sphere.gravity * sphere.stiffness));
        assert!((both / alone / wanted - 1.0).abs() < 1e-3, "{both} {alone} {wanted}");
    }
}
