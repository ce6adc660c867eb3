//! Whether numbers describe a gimbal, and which of them does not.

use super::{Gimbal, Inertia};
use crate::gyro::range;
use crate::units::figure;
use crate::{Error, Result};

/// What a rounded sum may be off.
const ROUNDING: f64 = 1e-9;

impl Gimbal {
    /// Checks the numbers.
    ///
    /// # Errors
    /// `BadInput` that names the number: one that is not finite or lies outside its [range], moments of inertia
    /// that no body has, no inertia at all, or a suspension that does not hold the gyroscope.
    pub fn check(&self) -> Result<()> {
        let mut copy = *self;
        for name in Self::NAMES {
            if let (Some(value), Some(range)) = (copy.named(name), range::of_gimbal(name)) {
                range.check(*value).map_err(|e| e.about(name))?;
            }
        }
        self.bodies.iter().zip(1..).try_for_each(|(body, number)| rigid(body, number))?;
        let [first, second] = self.coefficients().inertia;
        for (inertia, sum) in [(first, "Ix1 + Ix3"), (second, "Iy1 + Iy2 + Iy3")] {
            if inertia <= 0.0 {
                return Err(Error::bad_input(format!(
                    "{sum} must be positive: without inertia nothing swings"
                )));
            }
        }
        self.holds()
    }

    /// Refuses a suspension in which the free motion grows.
    fn holds(&self) -> Result<()> {
        let damped = self.damping.iter().any(|d| *d > 0.0);
        let [first, second] = self.coefficients().stiffness;
        let soft = [(first, "α", "cx", self.springs[0]), (second, "β", "cy", self.springs[1])];
        let soft: Vec<_> = soft.into_iter().filter(|s| s.0 <= 0.0).collect();
        // what gyroscopic forces alone hold, damping lets go (Kelvin, Tait, Chetaev)
        if self.free_frequencies().is_some() && (soft.is_empty() || !damped) {
            return Ok(());
        }
        let (told, cure): (Vec<String>, Vec<String>) = soft
            .iter()
            .map(|(stiffness, angle, spring, now)| {
                let told = format!(
                    "about {angle} by {} N*m/rad, {spring} and the ring's rotation with H together",
                    figure(*stiffness)
                );
                (told, format!("{spring} above {} N*m/rad", figure(now - stiffness)))
            })
            .unzip();
        let mut says = "the suspension does not hold the gyroscope: its free motion grows".to_owned();
        if !told.is_empty() {
            says = format!("{says}; it is held {}", told.join(", and "));
        }
        let error = Error::bad_input(says);
        Err(if cure.is_empty() { error } else { error.with_hint(format!("give {}", cure.join(" and "))) })
    }
}

/// Refuses moments of inertia of which one is larger than the other two together.
fn rigid(body: &Inertia, number: usize) -> Result<()> {
    let all = [("Ix", body.x), ("Iy", body.y), ("Iz", body.z)];
    let sum: f64 = all.iter().map(|a| a.1).sum();
    match all.iter().find(|a| a.1 > (sum - a.1) * (1.0 + ROUNDING)) {
        None => Ok(()),
        Some((axis, most)) => {
            let others: Vec<String> =
                all.iter().filter(|a| a.0 != *axis).map(|a| format!("{}{number}", a.0)).collect();
            Err(Error::bad_input(format!(
                "{axis}{number} of {} kg*m^2 is more than {} together, {} kg*m^2: no body has such moments of inertia",
                figure(*most),
                others.join(" and "),
                figure(sum - most)
            ))
            .with_hint("a number without a unit is in kg*m^2; write g*cm^2 where that is meant"))
        }
    }
}
