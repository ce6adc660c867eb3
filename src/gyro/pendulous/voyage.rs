//! What is to be known of a compass with a liquid ballistic on a voyage: its errors on each heading, what its corrector
//! leaves, its spread under manoeuvres, and how all of that goes with the latitude.

use super::{Corrector, PendulousCompass};
use crate::Result;
use crate::gyro::Manoeuvres;
use std::f64::consts::PI;

/// What is asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Voyage {
    /// The compass, where it is now.
    pub compass: PendulousCompass,
    /// Speed of the ship, m/s.
    pub speed: f64,
    /// Headings, rad.
    pub headings: Vec<f64>,
    /// Its corrector.
    pub corrector: Option<Corrector>,
    /// Random changes of the northward velocity.
    pub manoeuvres: Option<Manoeuvres>,
}

/// The settled error on one heading, rad, west positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnHeading {
    /// Heading.
    pub heading: f64,
    /// v_N/(R ν).
    pub by_speed: f64,
    /// −ε (U sin φ + v_E tan φ/R)/ν.
    pub by_damping: f64,
    /// What the corrector leaves.
    pub corrected: Option<f64>,
}

impl OnHeading {
    /// All of it, without a corrector.
    pub fn settled(&self) -> f64 {
        self.by_speed + self.by_damping
    }
}

/// The same compass elsewhere, the ship at rest or manoeuvring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtLatitude {
    /// φ, rad.
    pub latitude: f64,
    /// s.
    pub undamped_period: f64,
    /// −ε tan φ, rad; `None` where it does not settle.
    pub by_damping: Option<f64>,
    /// Standard deviation under the manoeuvres, rad; `None` where it does not settle or none are asked for.
    pub spread: Option<f64>,
}

/// The answers.
#[derive(Debug, Clone, PartialEq)]
pub struct SettledVoyage {
    /// s; infinite where it creeps without a swing.
    pub damped_period: f64,
    /// Time in which the slowest motion falls to 1/e, s.
    pub decay: f64,
    /// The errors on each heading.
    pub rows: Vec<OnHeading>,
    /// Standard deviation of the heading about its settled error under the manoeuvres, rad.
    pub spread: Option<f64>,
    /// From the equator to 80°, by 10°, on the side of the equator where the compass is.
    pub by_latitude: Vec<AtLatitude>,
}

/// An error of the heading to which all is linear: 10°.
const LINEAR: f64 = PI / 18.0;

impl SettledVoyage {
    /// Whether the heading is off by so little that its error is linear in what causes it.
    pub fn is_linear(&self) -> bool {
        let errors = self.rows.iter().flat_map(|r| [r.by_speed, r.by_damping, r.settled()]);
        errors.chain(self.spread).all(|x| x.abs() <= LINEAR)
    }
}

impl Voyage {
    /// Everything asked.
    ///
    /// ```
    /// use gyrospec::gyro::pendulous::{PendulousCompass, Voyage};
    /// let compass = PendulousCompass::tuned(15.0, 0.03, 60.0, 45f64.to_radians());
    /// let asked = Voyage { compass, speed: 0.0, headings: vec![0.0], corrector: None, manoeuvres: None };
    /// let told = asked.settled()?;
    /// // at 45° the damping error is the offset; at 60° it is √3 times as large
    /// assert!((told.rows[0].by_damping + 0.03).abs() < 1e-12);
    /// assert!((told.by_latitude[6].by_damping.unwrap() + 0.03 * 3f64.sqrt()).abs() < 1e-12);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`PendulousCompass::settled_error`].
    pub fn settled(&self) -> Result<SettledVoyage> {
        let [damped_period, decay] = self.compass.swing()?;
        let rows = self.headings.iter().map(|heading| self.on(*heading)).collect::<Result<_>>()?;
        let spread = self.manoeuvres.as_ref().map(|m| self.compass.manoeuvre_deviation(m)).transpose()?;
        let side = if self.compass.latitude < 0.0 { -1.0 } else { 1.0 };
        let by_latitude = (0..=8).map(|k| self.at((side * 10.0 * f64::from(k)).to_radians())).collect();
        Ok(SettledVoyage { damped_period, decay, rows, spread, by_latitude })
    }

    fn on(&self, heading: f64) -> Result<OnHeading> {
        let [by_speed, by_damping] = self.compass.settled_parts(self.speed, heading)?;
        let left = |set: &Corrector| self.compass.corrected_error(self.speed, heading, set);
        Ok(OnHeading {
            heading,
            by_speed,
            by_damping,
            corrected: self.corrector.as_ref().map(left).transpose()?,
        })
    }

    /// The compass as it is built, at another latitude.
    pub fn at(&self, latitude: f64) -> AtLatitude {
        let there = PendulousCompass { latitude, ..self.compass };
        AtLatitude {
            latitude,
            undamped_period: there.undamped_period(),
            by_damping: there.settled_parts(0.0, 0.0).ok().map(|parts| parts[1]),
            spread: self.manoeuvres.as_ref().and_then(|m| there.manoeuvre_deviation(m).ok()),
        }
    }
}
