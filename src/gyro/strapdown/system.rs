//! # Purpose
//! All that is asked of a body that vibrates and of the heading found on it, together.
//!
//! # Method
//! Every effect is a drift and a bias, what gyros and accelerometers read in the mean more than there is; drifts and
//! biases add, and so do the errors of the heading in them.

use super::{
    Anisoelasticity, Anisoinertia, EARTH_RATE, Found, GRAVITY, NorthSeeking, Seaway, Shaken, TunedRotor,
    Vector, aligned, by_gyrocompassing, coning, sculling, square_term,
};
use crate::Result;
use crate::spectrum::Roll;

/// Where the heading is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// φ, rad.
    pub latitude: f64,
    /// K of the body's x axis, rad.
    pub heading: f64,
}

/// A tuned rotor on the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MountedRotor {
    /// The rotor.
    pub rotor: TunedRotor,
    /// Its spin axis: 0 to 2 for x, y, z.
    pub spin: usize,
    /// θ₀ of an angle at twice its speed and in step with it, rad.
    pub amplitude: f64,
}

/// What the spread of a heading comes from.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Disturbance {
    /// N of the gyros, rad/√s.
    pub walk: Option<f64>,
    /// ω_n (rad/s) and ζ of the loop that seeks north.
    pub seeking: Option<[f64; 2]>,
    /// The ship's roll, and the height above its axis, m.
    pub sea: Option<(Roll, f64)>,
    /// Time over which a base at rest is averaged, s.
    pub align: Option<f64>,
}

/// All that is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct System {
    /// The vibration.
    pub shaken: Shaken,
    /// A gyro with a float of unlike inertia.
    pub anisoinertia: Option<Anisoinertia>,
    /// A gyro with a float on a suspension of unlike stiffness.
    pub anisoelasticity: Option<Anisoelasticity>,
    /// k₂ of the accelerometers, s²/m.
    pub square: Option<f64>,
    /// A dry-tuned rotor.
    pub rotor: Option<MountedRotor>,
    /// Where the heading is found.
    pub place: Option<Place>,
    /// What spreads it.
    pub disturbance: Disturbance,
}

/// What one cause leaves in the mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effect {
    /// `coning`, `sculling`, `anisoinertia`, `anisoelasticity`, `square-term`; `together` for the sum.
    pub name: &'static str,
    /// Rate read in the mean less the mean rate, rad/s.
    pub drift: Vector,
    /// Acceleration read in the mean less the mean acceleration, m/s².
    pub bias: Vector,
    /// The heading found with it.
    pub found: Option<Found>,
}

/// What a tuned rotor reads.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorReads {
    /// Drift by the angle in step with the rotor, across the spin axis, rad/s.
    pub drift: f64,
    /// The most that it turns the heading, rad.
    pub heading: Option<f64>,
    /// Angle random walk by the random vibration about each axis across the spin axis, rad/√s.
    pub walks: Vec<(usize, f64)>,
}

/// Standard deviations of the heading, rad.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Spread {
    /// Of the loop, by the gyros' random walk.
    pub by_walk: Option<f64>,
    /// Of the loop, by the sea.
    pub by_sea: Option<f64>,
    /// After averaging on a base at rest.
    pub aligned: Option<f64>,
}

/// The answers.
#[derive(Debug, Clone, PartialEq)]
pub struct Findings {
    /// Each cause, and the sum where there are several.
    pub effects: Vec<Effect>,
    /// The tuned rotor.
    pub rotor: Option<RotorReads>,
    /// The spread of the heading.
    pub spread: Spread,
}

/// An error of the heading to which all is linear: 10°.
const LINEAR: f64 = std::f64::consts::PI / 18.0;

impl Findings {
    /// Whether the heading is off by so little that its error is linear in what causes it.
    pub fn is_linear(&self) -> bool {
        let Spread { by_walk, by_sea, aligned } = self.spread;
        let errors = self.effects.iter().filter_map(|e| e.found.map(|f| f.error));
        let largest = self.rotor.iter().filter_map(|r| r.heading);
        let spreads = [by_walk, by_sea, aligned].into_iter().flatten();
        errors.chain(largest).chain(spreads).all(|x| x.abs() <= LINEAR)
    }
}

impl System {
    /// Everything asked.
    ///
    /// # Errors
    /// As the effects.
    pub fn findings(&self) -> Result<Findings> {
        Ok(Findings { effects: self.effects()?, rotor: self.rotor_reads()?, spread: self.spread()? })
    }

    fn effects(&self) -> Result<Vec<Effect>> {
        let shaken = &self.shaken;
        let moving = |axes: &[Option<super::Vibration>; 3]| axes.iter().flatten().count();
        let (angles, accelerations) = (moving(&shaken.angular), moving(&shaken.linear));
        let none = [0.0; 3];
        let mut effects = Vec::new();
        let mut add =
            |name, drift, bias| effects.push(Effect { name, drift, bias, found: self.found(drift, bias) });
        if angles > 1 {
            add("coning", coning(shaken)?.map(|x| 0.0 - x), none);
        }
        if angles > 0 && accelerations > 0 {
            add("sculling", none, sculling(shaken)?.map(|x| 0.0 - x));
        }
        if let Some(float) = self.anisoinertia {
            add("anisoinertia", float.drift(shaken)?, none);
        }
        if let Some(float) = self.anisoelasticity {
            add("anisoelasticity", float.drift(shaken)?, none);
        }
        if let Some(k2) = self.square {
            add("square-term", none, square_term(k2, shaken)?);
        }
        if effects.len() > 1 {
            let sum =
                |part: fn(&Effect) -> Vector| [0, 1, 2].map(|i| effects.iter().map(|e| part(e)[i]).sum());
            let (drift, bias) = (sum(|e| e.drift), sum(|e| e.bias));
            effects.push(Effect { name: "together", drift, bias, found: self.found(drift, bias) });
        }
        Ok(effects)
    }

    fn found(&self, drift: Vector, bias: Vector) -> Option<Found> {
        let place = self.place?;
        Some(by_gyrocompassing(drift, bias, [place.heading, place.latitude], [EARTH_RATE, GRAVITY]))
    }

    fn rotor_reads(&self) -> Result<Option<RotorReads>> {
        let Some(mounted) = self.rotor else { return Ok(None) };
        let drift = mounted.rotor.drift(mounted.amplitude).abs();
        let mut walks = Vec::new();
        for (axis, vibration) in self.shaken.angular.iter().enumerate().filter(|(i, _)| *i != mounted.spin) {
            if let Some(vibration) = vibration {
                walks.push((axis, mounted.rotor.walk(vibration)?));
            }
        }
        Ok(Some(RotorReads { drift, heading: self.north_rate().map(|north| drift / north), walks }))
    }

    /// U cos φ, rad/s.
    fn north_rate(&self) -> Option<f64> {
        self.place.map(|p| EARTH_RATE * p.latitude.cos())
    }

    fn spread(&self) -> Result<Spread> {
        let (Some(place), Some(north_rate)) = (self.place, self.north_rate()) else {
            return Ok(Spread::default());
        };
        let d = &self.disturbance;
        let seeking = d.seeking.map(|[frequency, damping]| NorthSeeking { frequency, damping, north_rate });
        let by_walk = seeking.zip(d.walk).map(|(s, walk)| s.by_walk(walk)).transpose()?;
        let by_sea = seeking.zip(d.sea).map(|(s, (roll, lever))| {
            s.by_sea(&Seaway { roll, lever, heading: place.heading, gravity: GRAVITY })
        });
        let aligned = d.align.zip(d.walk).map(|(time, walk)| aligned(walk, time, north_rate));
        Ok(Spread { by_walk, by_sea: by_sea.transpose()?, aligned })
    }
}
