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

    /// The names of its numbers in the symbol table, in the order of the fields.
    pub const NAMES: [&str; 11] = ["P", "H", "lP", "C", "F", "C0", "T", "h", "lat", "g", "U"];

    /// The place of a number by its name in the symbol table.
    ///
    /// ```
    /// let mut sphere = gyrospec::gyro::Gyrosphere::seed();
    /// *sphere.named("T").unwrap() = 0.6;
    /// assert!(sphere.lag == 0.6 && sphere.named("kappa").is_none());
    /// ```
    pub fn named(&mut self, name: &str) -> Option<&mut f64> {
        Some(match name {
            "P" => &mut self.weight,
            "H" => &mut self.momentum,
            "lP" => &mut self.pendulous,
            "C" => &mut self.damper,
            "F" => &mut self.flow,
            "C0" => &mut self.stiffness,
            "T" => &mut self.lag,
            "h" => &mut self.lever,
            "lat" => &mut self.latitude,
            "g" => &mut self.gravity,
            "U" => &mut self.earth_rate,
            _ => return None,
        })
    }

    /// A number by its name in the symbol table.
    pub fn value(mut self, name: &str) -> Option<f64> {
        self.named(name).copied()
    }

    /// Checks that the numbers describe a compass.
    ///
    /// # Errors
    /// `BadInput` that names the number and its [range](super::range).
    pub fn check(&self) -> Result<()> {
        for name in Self::NAMES {
            if let (Some(value), Some(range)) = (self.value(name), range::of_compass(name)) {
                range.check(value).map_err(|e| e.about(name))?;
            }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_name_has_a_place_of_its_own_and_a_range() {
        let mut sphere = Gyrosphere::seed();
        for (k, name) in Gyrosphere::NAMES.iter().enumerate() {
            *sphere.named(name).unwrap() = k as f64;
            assert!(range::of_compass(name).is_some());
        }
        let values: Vec<f64> = Gyrosphere::NAMES.iter().map(|n| sphere.value(n).unwrap()).collect();
        assert_eq!(values, (0..11).map(f64::from).collect::<Vec<_>>());
        assert_eq!(sphere.value("alpha"), None);
    }
}
