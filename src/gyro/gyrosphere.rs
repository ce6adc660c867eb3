//! The numbers of a two-rotor gyrosphere.

use super::range;
use crate::{Error, Result};

/// A gyrosphere and the place where it hangs, in SI.
///
/// | field | symbol | unit |
/// |---|---|---|
/// | `weight` | P | N |
/// | `momentum` | H, angular momentum | N·m·s |
/// | `pendulous` | lP, pendulous moment | N·m |
/// | `damper` | C, damper stiffness | N·m |
/// | `flow` | F, rate of the damping liquid | 1/s |
/// | `stiffness` | C₀, elastic give of the centre of mass | N/m |
/// | `lag` | T = r/C₀ | s |
/// | `lever` | h, above the roll axis | m |
/// | `latitude` | φ | rad |
/// | `gravity` | g | m/s² |
/// | `earth_rate` | U | rad/s |
///
/// ```
/// let sphere = gyrospec::gyro::Gyrosphere::seed();
/// // undamped, tuned: the pendulum as long as the Earth's radius, 84.4 min
/// assert!((sphere.undamped_period() / 60.0 - 84.4).abs() < 0.1);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gyrosphere {
    /// P, N.
    pub weight: f64,
    /// H, N·m·s.
    pub momentum: f64,
    /// lP, N·m.
    pub pendulous: f64,
    /// C, N·m.
    pub damper: f64,
    /// F, 1/s.
    pub flow: f64,
    /// C₀, N/m.
    pub stiffness: f64,
    /// T, s.
    pub lag: f64,
    /// h, m.
    pub lever: f64,
    /// φ, rad.
    pub latitude: f64,
    /// g, m/s².
    pub gravity: f64,
    /// U, rad/s.
    pub earth_rate: f64,
}

impl Gyrosphere {
    /// The gyrocompass of the rolling-error paper at Odessa (46°30′), with its printed
    /// U = 7.3e−5 1/s. The paper gives no lP, C, F: chosen here are lP = 0.4757 N·m,
    /// C = 0.4 lP and F = 1.5e−3 1/s, and h = 3 m as in its Example 3.1.
    pub fn seed() -> Self {
        Self {
            weight: 85.0,
            momentum: 15.5,
            pendulous: 0.4757,
            damper: 0.4 * 0.4757,
            flow: 1.5e-3,
            stiffness: 1.35e5,
            lag: 0.44,
            lever: 3.0,
            latitude: 46.5_f64.to_radians(),
            gravity: 9.81,
            earth_rate: 7.3e-5,
        }
    }

    /// Checks that the numbers describe a compass.
    ///
    /// # Errors
    /// `BadInput` that names the number and its [range](super::range).
    pub fn check(&self) -> Result<()> {
        let all = [
            ("P", self.weight),
            ("H", self.momentum),
            ("lP", self.pendulous),
            ("C", self.damper),
            ("F", self.flow),
            ("C0", self.stiffness),
            ("T", self.lag),
            ("h", self.lever),
            ("lat", self.latitude),
            ("g", self.gravity),
            ("U", self.earth_rate),
        ];
        for (name, value) in all {
            range::of_compass(name).map_or(Ok(value), |r| r.check(value)).map_err(|e| e.about(name))?;
        }
        if self.damper >= self.pendulous {
            return Err(Error::bad_input("the damper C is as strong as the pendulous moment lP")
                .with_hint("a gyrosphere settles only with C < lP"));
        }
        Ok(())
    }

    /// 2π√(H/(lP U cos φ)), s: the period of the undamped compass.
    pub fn undamped_period(&self) -> f64 {
        let stiff = self.pendulous * self.earth_rate * self.latitude.cos();
        std::f64::consts::TAU * (self.momentum / stiff).sqrt()
    }

    /// P²h²/(2g² H U C₀ cos φ), rad·s⁴: the error a unit of ⟨θ̈·lagged θ̈⟩ and of −sin 2K.
    pub(super) fn rectifier(&self) -> f64 {
        let ratio = self.weight * self.lever / self.gravity;
        ratio * ratio / (2.0 * self.momentum * self.earth_rate * self.stiffness * self.latitude.cos())
    }
}
