//! The values that a compass, a ship and a sea can have: one table for the command line, files and
//! Python, each in SI, with the units in which people mean a number that lies outside it.

use crate::units::{Unit, figure};
use crate::{Error, ErrorKind, Result};
use std::f64::consts::PI;

/// What one quantity can be.
#[derive(Debug)]
pub struct Range {
    /// What it is, in words.
    pub what: &'static str,
    /// Its unit in SI.
    pub unit: &'static str,
    /// The ends, both included, in SI.
    ends: [f64; 2],
    /// The unit in which people know it.
    shown: &'static str,
    /// Units in which a number without one may have been meant.
    meant: &'static [&'static str],
    /// Why it ends there, where that is not plain.
    why: &'static str,
}

const DEGREE: f64 = PI / 180.0;

pub(super) const fn range(what: &'static str, unit: &'static str, ends: [f64; 2]) -> Range {
    Range { what, unit, ends, shown: unit, meant: &[], why: "" }
}

const fn meant(
    what: &'static str,
    unit: &'static str,
    ends: [f64; 2],
    meant: &'static [&'static str],
) -> Range {
    Range { what, unit, ends, shown: unit, meant, why: "" }
}

const fn angle(what: &'static str, ends: [f64; 2]) -> Range {
    let ends = [ends[0] * DEGREE, ends[1] * DEGREE];
    Range { what, unit: "rad", ends, shown: "deg", meant: &["deg"], why: "" }
}

/// φ.
pub const LATITUDE: Range = Range {
    why: "towards the pole the Earth's rate loses its horizontal part, U cos φ, and no gyrocompass finds north",
    ..angle("a latitude", [-89.9, 89.9])
};
/// K.
pub const HEADING: Range = angle("a heading", [-360.0, 360.0]);
/// Where a sea comes from, off the bow.
pub const SEA_FROM: Range = angle("the bearing of a sea", [-360.0, 360.0]);
/// n of cosⁿ.
pub const SEA_SPREAD: Range = range("the spread of a sea, n of cosⁿ,", "1", [1.0, 100.0]);
/// h.
pub const LEVER: Range = meant("the height above the roll axis", "m", [-150.0, 150.0], &["cm", "mm"]);
/// Over the ground; negative astern.
pub const SPEED: Range = meant("a ship's speed", "m/s", [-50.0, 50.0], &["kn"]);
/// √A.
pub const ROLL_DEVIATION: Range = angle("a standard deviation of roll", [1e-6, 45.0]);
/// A.
pub const ROLL_VARIANCE: Range = Range {
    shown: "deg^2",
    ..meant("a variance of roll", "rad^2", [1e-16, 2025.0 * DEGREE * DEGREE], &["deg^2"])
};
/// θ₀.
pub const ROLL_AMPLITUDE: Range = angle("an amplitude of roll", [1e-6, 60.0]);
/// θ₀h of a compass that rolls, in a table of trials.
pub const ROLL_PATH: Range = meant("an amplitude of the compass's path", "m", [1e-6, 150.0], &["cm", "mm"]);
/// α as it was measured.
pub const HEADING_ERROR: Range = angle("an error of the heading", [-45.0, 45.0]);
/// μ.
pub const ROLL_DECAY: Range = range("a decay of roll, mu,", "1/s", [1e-9, 10.0]);
/// ε, p.
pub const ROLL_FREQUENCY: Range = range("a frequency of roll", "rad/s", [0.01, 20.0]);
/// H_s.
pub const WAVE_HEIGHT: Range = meant("a significant wave height", "m", [0.01, 30.0], &["cm"]);
/// 2π/ω_p.
pub const WAVE_PERIOD: Range = range("a peak period of a sea", "s", [1.0, 40.0]);
/// 2π/ω_φ.
pub const ROLL_PERIOD: Range = range("a ship's roll period", "s", [1.0, 120.0]);
/// ζ_φ.
pub const ROLL_DAMPING: Range = range("a damping ratio of roll", "1", [1e-4, 5.0]);
/// d of d|φ̇|φ̇, a unit of inertia.
pub const QUADRATIC_DAMPING: Range = range("a quadratic damping of roll", "1/rad", [0.0, 100.0]);
/// c of cφ̇³, a unit of inertia.
pub const CUBIC_DAMPING: Range = range("a cubic damping of roll", "s/rad^2", [0.0, 1e4]);
/// χ.
pub const WAVE_SLOPE: Range = range("an effective part of the wave's slope", "1", [1e-3, 2.0]);
/// B.
pub const BEAM: Range = range("a ship's beam", "m", [0.2, 100.0]);
/// L.
pub const SHIP_LENGTH: Range = range("a ship's length", "m", [0.5, 600.0]);
/// Of the low-passes on a motion.
pub const BAND: Range = range("a band of motion", "rad/s", [0.01, 1e4]);
/// ω_c of a gimbal's demodulator.
pub const CORNER: Range = Range {
    why: "at 0 no slow rate would pass, above the ring's speed more than slow rates would",
    ..range("a demodulator's corner", "rad/s", [1e-4, 1e5])
};
/// F_c.
pub const FRICTION: Range = meant("dry friction", "N", [0.0, 1e5], &["dyn"]);
/// δ.
pub const FREE_PLAY: Range = meant("free play", "m", [0.0, 0.1], &["mm", "um"]);
/// C₁, C₂.
pub const STIFFNESS: Range = range("a stiffness", "N/m", [1e-2, 1e12]);
/// T₁, T₂.
pub const RELAXATION: Range = range("a time of relaxation", "s", [1e-6, 1e5]);
/// κ.
pub const SHARE: Range = range("a share of the spring's give", "1", [-100.0, 100.0]);
/// σ of φ, and θ₀ of a tuned rotor.
pub const SHAKEN_ANGLE: Range = Range {
    meant: &["mrad", "urad"],
    why: "the products are of second order in the angle; what they leave out is of fourth",
    ..range("an angular vibration", "rad", [1e-12, 0.1])
};
/// σ of a.
pub const SHAKEN_ACCELERATION: Range = range("a linear vibration", "m/s^2", [1e-9, 1e5]);
/// ω₀/2π of a vibration, and of a float on its suspension.
pub const VIBRATION_FREQUENCY: Range = range("a frequency of vibration", "Hz", [1e-4, 1e6]);
/// ζ of a vibration, and of a float on its suspension.
pub const VIBRATION_DAMPING: Range = range("a damping ratio of vibration", "1", [1e-7, 10.0]);
/// ψ of a vibration.
pub const PHASE: Range = angle("a phase", [-360.0, 360.0]);
/// The part of two vibrations that goes together.
pub const COHERENCE: Range = range("a coherence", "1", [0.0, 1.0]);
/// I_s − I_i of a float.
pub const INERTIA_DIFFERENCE: Range =
    meant("a difference of moments of inertia", "kg*m^2", [-1.0, 1.0], &["g*cm^2"]);
/// H of one gyro.
pub const GYRO_MOMENTUM: Range = meant("a gyro's angular momentum", "N*m*s", [1e-9, 1e5], &["g*cm^2/s"]);
/// m of a float.
pub const FLOAT_MASS: Range = meant("a float's mass", "kg", [1e-6, 1e3], &["g"]);
/// k₂.
pub const SQUARE_TERM: Range = range("a square term", "s^2/m", [-1.0, 1.0]);
/// N of a tuned rotor.
pub const ROTOR_SPEED: Range = range("a rotor's speed", "rad/s", [1.0, 1e5]);
/// C, and A_g + B_g − C_g.
pub const ROTOR_INERTIA: Range = meant("a moment of inertia", "kg*m^2", [1e-15, 10.0], &["g*cm^2"]);
/// N of angle random walk.
pub const WALK: Range =
    Range { shown: "deg/h^0.5", ..meant("an angle random walk", "rad/s^0.5", [1e-15, 1.0], &["deg/h^0.5"]) };
/// 2π/ω_n of a loop that seeks north.
pub const LOOP_PERIOD: Range = range("a loop's period", "s", [1.0, 1e6]);
/// ζ of a loop that seeks north.
pub const LOOP_DAMPING: Range = range("a loop's damping ratio", "1", [1e-3, 100.0]);
/// A time of averaging at rest.
pub const AVERAGING: Range = range("a time of averaging", "s", [1e-3, 1e7]);

/// H of a gyrocompass.
pub const MOMENTUM: Range = meant("the angular momentum", "N*m*s", [1e-4, 1e5], &["g*cm^2/s"]);
/// B of a liquid ballistic, a radian of tilt.
pub const BALLISTIC: Range = meant("the ballistic's moment", "N*m", [1e-6, 1e5], &["dyn*cm"]);
/// ε of a liquid ballistic.
pub const OFFSET: Range = Range {
    why: "the ballistic's point of action stands a small angle aside: some hundredths of a radian",
    ..angle("the offset of the ballistic", [1e-3, 15.0])
};
/// τ of a liquid ballistic.
pub const FLOW_LAG: Range = range("the lag of the liquid's flow", "s", [1e-3, 1e4]);
/// σ of the northward velocity.
pub const MANOEUVRE_SPEED: Range =
    meant("a deviation of the northward velocity", "m/s", [1e-3, 50.0], &["kn"]);
/// T of manoeuvres.
pub const MANOEUVRE_TIME: Range = range("a time between manoeuvres", "s", [1.0, 1e6]);

/// By the names of a compass's parameters.
const COMPASS: [(&str, Range); 11] = [
    ("P", meant("the gyrosphere's weight", "N", [1e-2, 1e5], &["dyn", "kN"])),
    ("H", MOMENTUM),
    ("lP", meant("the pendulous moment", "N*m", [1e-6, 1e4], &["dyn*cm"])),
    ("C", meant("the damper's moment", "N*m", [0.0, 1e4], &["dyn*cm"])),
    ("F", range("the damping liquid's rate", "1/s", [1e-8, 1e2])),
    ("C0", STIFFNESS),
    ("T", meant("the lag of the centre of mass", "s", [0.0, 1e4], &["ms"])),
    ("h", LEVER),
    ("lat", LATITUDE),
    ("g", meant("the Earth's gravity", "m/s^2", [9.7, 9.9], &["cm/s^2"])),
    ("U", meant("the Earth's rate", "rad/s", [7.2e-5, 7.4e-5], &["deg/h"])),
];

const ROLL: [(&str, Range); 3] = [("A", ROLL_VARIANCE), ("mu", ROLL_DECAY), ("eps", ROLL_FREQUENCY)];

const FLOW: [(&str, Range); 2] = [("T2", RELAXATION), ("kappa", SHARE)];

/// By the names of a gimbal's parameters; the bodies' moments of inertia go by `I`.
const GIMBAL: [(&str, Range); 12] = [
    ("I", meant("a moment of inertia", "kg*m^2", [0.0, 1e3], &["g*cm^2"])),
    ("H", meant("the angular momentum", "N*m*s", [-1e5, 1e5], &["g*cm^2/s"])),
    ("Omega", range("the ring's speed", "rad/s", [1e-2, 1e5])),
    ("cx", range("a spring's stiffness", "N*m", [-1e6, 1e6])),
    ("cy", range("a spring's stiffness", "N*m", [-1e6, 1e6])),
    ("dx", range("a damping", "N*m*s/rad", [0.0, 1e6])),
    ("dy", range("a damping", "N*m*s/rad", [0.0, 1e6])),
    ("Qx", range("an intensity of torque noise", "N^2*m^2*s", [0.0, 1e3])),
    ("Qy", range("an intensity of torque noise", "N^2*m^2*s", [0.0, 1e3])),
    ("sigma", meant("a standard deviation of base rates", "rad/s", [0.0, 10.0], &["deg/s", "mrad/s"])),
    ("omega0", range("a frequency of base motion", "rad/s", [1e-4, 1e6])),
    ("zeta", range("a damping ratio", "1", [1e-6, 100.0])),
];

fn find(table: &'static [(&str, Range)], name: &str) -> Option<&'static Range> {
    table.iter().find(|(n, _)| *n == name).map(|(_, r)| r)
}

/// The range of a parameter of a compass, of its liquid flow or of its roll, by its name in the symbol table.
///
/// ```
/// use gyrospec::gyro::range;
/// let latitude = range::of_compass("lat").unwrap();
/// assert!(latitude.check(60f64.to_radians()).is_ok() && latitude.check(4.0).is_err());
/// ```
pub fn of_compass(name: &str) -> Option<&'static Range> {
    find(&COMPASS, name).or_else(|| find(&ROLL, name)).or_else(|| find(&FLOW, name))
}

/// The range of a parameter of a gimbal, by its name in the symbol table.
pub fn of_gimbal(name: &str) -> Option<&'static Range> {
    let is_inertia = name.len() == 3 && name.starts_with('I');
    find(&GIMBAL, if is_inertia { "I" } else { name })
}

impl Range {
    fn holds(&self, value: f64) -> bool {
        (self.ends[0]..=self.ends[1]).contains(&value)
    }

    /// The value, in SI, if it lies in the range.
    ///
    /// # Errors
    /// `BadInput` that says the range.
    pub fn check(&self, value: f64) -> Result<f64> {
        if self.holds(value) { Ok(value) } else { Err(self.outside(value, None)) }
    }

    /// A number in a unit, or in SI without one, as a value in SI.
    ///
    /// # Errors
    /// `Units` for a unit of another dimension, or one that counts turns where radians are meant; `BadInput` for a
    /// value outside the range, with the unit that was probably meant.
    pub fn read(&self, number: f64, unit: Option<&str>) -> Result<f64> {
        let Some(text) = unit else {
            return if self.holds(number) { Ok(number) } else { Err(self.outside(number, None)) };
        };
        let (unit, meant) = (Unit::parse(text)?, Unit::parse(self.unit)?);
        if unit.dimension() != meant.dimension() {
            return Err(Error::new(ErrorKind::Units, format!("{text} where {} is meant", self.unit)));
        }
        meant.turns_or_radians(&unit).map_err(|e| {
            let e = e.about(self.what);
            if self.unit != "rad/s" {
                return e;
            }
            // what is meant here is no unit of the user's
            e.with_hint("for radians a second write rad/s; for turns a second write 60 times as many rpm")
        })?;
        if self.unit == "1/s" && unit.counts_events() {
            let message = format!("{unit} is given where {meant} is meant: are these turns or radians?");
            let e = Error::new(ErrorKind::Units, message).about(self.what);
            return Err(e.with_hint("write 1/s: to fall to 1/e in a second is 1/s, whether it swings or not"));
        }
        let value = unit.to_si(number);
        if self.holds(value) { Ok(value) } else { Err(self.outside(value, Some(&unit))) }
    }

    /// What is said of a value outside, in the unit in which it was given.
    fn outside(&self, value: f64, given: Option<&Unit>) -> Error {
        if !value.is_finite() {
            return Error::bad_input(format!(
                "{} must be a finite number, not {value}",
                self.what.trim_end_matches(',')
            ));
        }
        let (shown, si) = (Unit::parse(self.shown).ok(), Unit::parse(self.unit).ok());
        let (Some(shown), Some(si)) = (shown, si) else { return Error::bad_input(self.what) };
        let unit = given.unwrap_or(&si);
        let in_unit = |v: f64, u: &Unit| {
            let name = if u.text() == "1" { String::new() } else { format!(" {}", u.text()) };
            format!("{}{name}", figure(u.from_si(v)))
        };
        let also = if unit.text() == shown.text() {
            String::new()
        } else {
            format!(" ({})", in_unit(value, &shown))
        };
        let [low, high] = self.ends;
        let told = Error::bad_input(format!(
            "{} of {}{also} lies outside {} … {}",
            self.what,
            in_unit(value, unit),
            figure(shown.from_si(low)),
            in_unit(high, &shown)
        ));
        let as_meant = |u: &&&str| Unit::parse(u).is_ok_and(|u| self.holds(u.to_si(value)));
        match self.meant.iter().find(as_meant) {
            Some(u) if given.is_none() => told.with_hint(format!(
                "a number without a unit is in {}; did you mean {}{u}?",
                self.unit,
                figure(value)
            )),
            _ if !self.why.is_empty() => told.with_hint(self.why),
            _ => told,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_range_has_units_and_holds_something() {
        let named = COMPASS.iter().chain(&ROLL).chain(&FLOW).chain(&GIMBAL).map(|(_, r)| r);
        let lone = [
            &HEADING,
            &SEA_FROM,
            &SEA_SPREAD,
            &QUADRATIC_DAMPING,
            &CUBIC_DAMPING,
            &SPEED,
            &ROLL_DEVIATION,
            &ROLL_AMPLITUDE,
            &WAVE_HEIGHT,
            &BEAM,
            &SHIP_LENGTH,
            &BAND,
            &SHAKEN_ANGLE,
            &SHAKEN_ACCELERATION,
            &VIBRATION_FREQUENCY,
            &PHASE,
            &INERTIA_DIFFERENCE,
            &GYRO_MOMENTUM,
            &FLOAT_MASS,
            &SQUARE_TERM,
            &ROTOR_SPEED,
            &ROTOR_INERTIA,
            &WALK,
            &ROLL_PATH,
            &HEADING_ERROR,
            &BALLISTIC,
            &OFFSET,
            &MANOEUVRE_SPEED,
        ];
        for r in named.chain(lone) {
            let dimension = |text: &str| Unit::parse(text).unwrap().dimension();
            for text in r.meant.iter().chain([&r.shown]) {
                assert_eq!(dimension(text), dimension(r.unit), "{}: {text}", r.what);
            }
            assert!(r.ends[0] < r.ends[1] && r.check(f64::NAN).is_err() && r.check(f64::INFINITY).is_err());
        }
    }

    #[test]
    fn a_number_outside_is_told_with_the_unit_that_was_meant() {
        let e = ROLL_DEVIATION.read(4.0, None).unwrap_err().to_string();
        assert!(e.contains("4 rad (229.2 deg)") && e.contains("did you mean 4deg?"), "{e}");
        let e = LATITUDE.read(1000.0, Some("deg")).unwrap_err().to_string();
        assert!(e.contains("1000 deg lies outside -89.9 … 89.9 deg"), "{e}");
        let e = of_compass("g").unwrap().read(981.0, None).unwrap_err().to_string();
        assert!(e.contains("did you mean 981cm/s^2?"), "{e}");
        assert_eq!(SPEED.read(-3.0, None).unwrap(), -3.0);
        let e = ROLL_FREQUENCY.read(0.1, Some("Hz")).unwrap_err().to_string();
        assert!(e.contains("turns or radians?") && e.contains("for radians a second write rad/s"), "{e}");
        assert!(ROLL_FREQUENCY.read(0.8, Some("1/s")).is_ok());
        let e = ROLL_DECAY.read(0.1, Some("Hz")).unwrap_err().to_string();
        assert!(e.contains("Hz is given where 1/s is meant: are these turns or radians?"), "{e}");
        assert_eq!(ROLL_DECAY.read(3.0, Some("1/min")).unwrap(), 0.05);
        let damping = of_gimbal("dx").unwrap();
        let e = damping.read(1e-3, Some("N*m*min")).unwrap_err().to_string();
        assert!(e.contains("turns or radians?") && e.contains("N*m*min/rev"), "{e}");
        assert_eq!(damping.read(1e-3, Some("N*m*s")).unwrap(), 1e-3);
    }
}
