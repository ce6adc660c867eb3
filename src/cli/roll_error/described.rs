//! A motion with what is to be said of it.

use crate::Result;
use crate::cli::quantity::quantities;
use crate::gyro::seed::Regular;
use crate::gyro::{Motion, range};
use crate::spectrum::{RationalFit, Roll, Sea, fit_rational};

/// A motion with what is to be said of it.
#[derive(Clone)]
pub struct Described {
    pub motion: Motion,
    /// The motion without its low-passes.
    pub free: Motion,
    pub says: String,
    /// What is said of the same in seas of all heights.
    pub of_all: Option<String>,
    /// Regular roll, behind the low-passes where there are any.
    pub regular: Option<Regular>,
    /// The sea that moves the ship.
    pub sea: Option<Sea>,
}

impl Described {
    pub fn new(motion: Motion, says: String) -> Self {
        Self { free: motion.clone(), motion, says, of_all: None, regular: None, sea: None }
    }

    /// The same behind two low-passes, rad/s.
    pub fn banded(mut self, corner: f64) -> Result<Self> {
        self.motion = self.free.band_limited(corner, 2)?;
        if let Some(roll) = &mut self.regular {
            roll.amplitude /= 1.0 + (roll.frequency / corner).powi(2);
        }
        for says in [&mut self.says].into_iter().chain(&mut self.of_all) {
            says.push_str(&format!("; behind two low-passes at {corner} rad/s"));
        }
        Ok(self)
    }
}

/// The sea's surface by a rational spectrum, weighted with ω⁴ as slopes are.
pub fn rational_sea(sea: &Sea) -> Result<RationalFit> {
    let omega: Vec<f64> = (1..=240).map(|k| f64::from(k) * 0.02 * sea.peak()).collect();
    let density: Vec<f64> = omega.iter().map(|w| sea.density(*w)).collect();
    let weight: Vec<f64> = omega.iter().map(|w| w.powi(4)).collect();
    fit_rational(&omega, &density, &weight, &[0, 1, 3, 5])
}

/// Regular roll as the limit of ever narrower irregular roll: θ₀² = 2A, p = ε, μ → 0.
pub fn regular(text: &str) -> Result<Described> {
    let v = quantities("regular", text, &[&range::ROLL_AMPLITUDE, &range::ROLL_FREQUENCY])?;
    let roll = Roll::new(0.5 * v[0] * v[0], 1e-7 * v[1], v[1])?;
    let says = format!("regular roll, amplitude {:.2}°, frequency {} rad/s", v[0].to_degrees(), v[1]);
    let regular = Some(Regular { amplitude: v[0], frequency: v[1] });
    Ok(Described { regular, ..Described::new(Motion::roll(&roll), says) })
}
