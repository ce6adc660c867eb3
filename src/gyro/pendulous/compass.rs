//! # Purpose
//! A single-rotor compass of Sperry's kind: controlled by a liquid ballistic and damped by setting its point of action
//! a small angle aside, so that it settles beside the meridian.
//!
//! # Method
//! With the ballistic's moment B per radian of tilt, the offset ε, and the liquid's level b that follows the tilt with
//! the flow's lag τ,
//! α′ = −U sin φ + (B/H) b,
//! β′ = v_N/R − U cos φ α − (B ε/H) b,
//! τ b′ = β + W₂/g − b.
//! At rest b = β = H U sin φ/B, so that α = v_N/(R U cos φ) − ε tan φ: the error of speed, and that of damping. A
//! corrector takes both off as they are at the latitude and the speed that are set on it.
//!
//! # References
//! A. L. Rawlings, The Theory of the Gyroscopic Compass and Its Deviations, 2nd ed. (Macmillan, 1944); R. N. Arnold,
//! L. Maunder, Gyrodynamics and Its Engineering Applications (Academic Press, 1961), ch. 9. The equations are derived
//! as (2.1), with the damping moment about the vertical in place of the second liquid.
//!
//! # Numerical aspects
//! s³ τ + s² + (Bε/H) s + U cos φ B/H is stable for ε > τ U cos φ alone (Routh): a slow flow undoes the damping.

use crate::gyro::instrument::EARTH_RADIUS;
use crate::gyro::manoeuvre::{Manoeuvres, Settling};
use crate::gyro::range;
use crate::poly::roots::roots;
use crate::units::{figure, significant};
use crate::{Error, Result};
use std::f64::consts::TAU;

/// A compass with a liquid ballistic, and where it stands; SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PendulousCompass {
    /// H, angular momentum, N·m·s.
    pub momentum: f64,
    /// B, moment of the ballistic per radian of tilt, N·m.
    pub ballistic: f64,
    /// ε, by which its point of action stands aside, rad.
    pub offset: f64,
    /// τ, lag of the liquid's flow, s.
    pub flow: f64,
    /// φ, rad.
    pub latitude: f64,
    /// g, m/s².
    pub gravity: f64,
    /// U, rad/s.
    pub earth_rate: f64,
}

/// What is set on a corrector of speed and latitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corrector {
    /// Latitude, rad.
    pub latitude: f64,
    /// Speed, m/s; the compass itself gives it the course.
    pub speed: f64,
}

impl PendulousCompass {
    /// One tuned to the Schuler period 84.4 min at its latitude, H in N·m·s, ε and φ in rad, τ in s.
    ///
    /// ```
    /// let compass = gyrospec::gyro::PendulousCompass::tuned(15.0, 0.03, 60.0, 45f64.to_radians());
    /// assert!((compass.undamped_period() / 60.0 - 84.4).abs() < 0.1);
    /// // the damping error at 45° is the offset itself, to the east
    /// assert!((compass.settled_error(0.0, 0.0)? + 0.03).abs() < 1e-12);
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    pub fn tuned(momentum: f64, offset: f64, flow: f64, latitude: f64) -> Self {
        let (gravity, earth_rate) = (9.81, 7.292_115e-5);
        let ballistic = momentum * gravity / (EARTH_RADIUS * earth_rate * latitude.cos());
        Self { momentum, ballistic, offset, flow, latitude, gravity, earth_rate }
    }

    /// 2π√(H/(B U cos φ)), s: without damping.
    pub fn undamped_period(&self) -> f64 {
        TAU * (self.momentum / (self.ballistic * self.earth_rate * self.latitude.cos())).sqrt()
    }

    /// The mean error of the heading on a ship of `speed` (m/s) on `heading` (rad), rad, west positive:
    /// v_N/(R ν) − ε (U sin φ + v_E tan φ/R)/ν with ν = U cos φ + v_E/R.
    ///
    /// # Errors
    /// `BadInput` for impossible numbers or a compass that does not settle.
    pub fn settled_error(&self, speed: f64, heading: f64) -> Result<f64> {
        let [by_speed, by_damping] = self.settled_parts(speed, heading)?;
        Ok(by_speed + by_damping)
    }

    /// Its two parts, rad: by the ship's speed, and by the damping.
    ///
    /// # Errors
    /// As [`PendulousCompass::settled_error`].
    pub fn settled_parts(&self, speed: f64, heading: f64) -> Result<[f64; 2]> {
        range::SPEED.check(speed)?;
        range::HEADING.check(heading)?;
        self.check()?;
        self.settles(self.level(self.latitude, speed, heading))?;
        Ok(self.settled_at(self.latitude, speed, heading))
    }

    /// The damped period, infinite where it creeps without a swing, and the time in which the slowest motion falls to
    /// 1/e, at rest; s.
    ///
    /// # Errors
    /// As [`PendulousCompass::settled_error`].
    pub fn swing(&self) -> Result<[f64; 2]> {
        self.check()?;
        let (b, north) = (self.ballistic / self.momentum, self.level(self.latitude, 0.0, 0.0));
        // τ s³ + s² + (Bε/H) s + (B/H) U cos φ
        let poles = roots(&[self.flow, 1.0, b * self.offset, b * north]);
        let slowest = poles.iter().map(|p| p.re).fold(f64::NEG_INFINITY, f64::max);
        let fastest = poles.iter().map(|p| p.im.abs()).fold(0.0, f64::max);
        Ok([if fastest > 1e-9 * north { TAU / fastest } else { f64::INFINITY }, -1.0 / slowest])
    }

    /// What a corrector leaves of it, rad.
    ///
    /// # Errors
    /// As [`PendulousCompass::settled_error`].
    pub fn corrected_error(&self, speed: f64, heading: f64, set: &Corrector) -> Result<f64> {
        range::LATITUDE.check(set.latitude)?;
        range::SPEED.check(set.speed)?;
        let error = self.settled_error(speed, heading)?;
        if self.level(set.latitude, set.speed, heading) <= 0.0 {
            return Err(undone().about("the corrector"));
        }
        let [by_speed, by_damping] = self.settled_at(set.latitude, set.speed, heading);
        Ok(error - (by_speed + by_damping))
    }

    /// The standard deviation of the heading about its settled error under random manoeuvres, rad.
    ///
    /// # Errors
    /// `BadInput` for impossible numbers or a compass that does not settle.
    pub fn manoeuvre_deviation(&self, manoeuvres: &Manoeuvres) -> Result<f64> {
        self.check()?;
        self.settling().deviation(manoeuvres)
    }

    /// ν = U cos φ + v_E/R, rad/s.
    fn level(&self, latitude: f64, speed: f64, heading: f64) -> f64 {
        self.earth_rate * latitude.cos() + speed * heading.sin() / EARTH_RADIUS
    }

    /// v_N/(R ν), −ε (U sin φ + v_E tan φ/R)/ν.
    fn settled_at(&self, latitude: f64, speed: f64, heading: f64) -> [f64; 2] {
        let (north, east) = (speed * heading.cos() / EARTH_RADIUS, speed * heading.sin() / EARTH_RADIUS);
        let level = self.level(latitude, speed, heading);
        let vertical = self.earth_rate * latitude.sin() + east * latitude.tan();
        // no zero has a sign
        [north / level, 0.0 - self.offset * vertical / level]
    }

    fn settling(&self) -> Settling {
        let (b, north) = (self.ballistic / self.momentum, self.earth_rate * self.latitude.cos());
        let flow = 1.0 / self.flow;
        Settling {
            rates: vec![vec![0.0, 0.0, b], vec![-north, 0.0, -b * self.offset], vec![0.0, flow, -flow]],
            velocity: vec![0.0, 1.0 / EARTH_RADIUS, 0.0],
            acceleration: vec![0.0, 0.0, flow / self.gravity],
            north,
        }
    }

    fn check(&self) -> Result<()> {
        let positive = [
            ("angular momentum", self.momentum),
            ("ballistic's moment", self.ballistic),
            ("offset", self.offset),
            ("flow's lag", self.flow),
            ("gravity", self.gravity),
            ("Earth's rate", self.earth_rate),
        ];
        for (name, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::bad_input(format!("the {name} must be positive, not {value}")));
            }
        }
        range::LATITUDE.check(self.latitude)?;
        self.settles(self.level(self.latitude, 0.0, 0.0))
    }

    /// Refuses a level rate ν (rad/s) that is none, or with which the flow undoes the damping: ε > τ ν.
    fn settles(&self, level: f64) -> Result<()> {
        if level <= 0.0 {
            return Err(undone());
        }
        let least = self.flow * level;
        if self.offset > least {
            return Ok(());
        }
        Err(Error::bad_input(format!(
            "this compass does not settle: the flow's lag of {} s undoes an offset of {} rad",
            figure(self.flow),
            figure(self.offset)
        ))
        .with_hint(format!("ε must exceed τ (U cos φ + v_E/R) = {} rad", significant(least, 3))))
    }
}

/// No compass finds north where the ship keeps up with the Earth.
fn undone() -> Error {
    Error::bad_input(
        "going west as fast as this at this latitude undoes the Earth's turning: no compass finds north",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// α, rad, each second of `hours` after the northward velocity steps from 0 to `v` (m/s), by Runge and Kutta's method
    /// of fourth order from `start`, the ship going on at `v`.
    fn run(c: &PendulousCompass, [v, v_east]: [f64; 2], start: [f64; 3], hours: f64) -> Vec<f64> {
        let b = c.ballistic / c.momentum;
        let rates = |y: [f64; 3]| {
            let vertical = c.earth_rate * c.latitude.sin() + v_east * c.latitude.tan() / EARTH_RADIUS;
            let level = c.earth_rate * c.latitude.cos() + v_east / EARTH_RADIUS;
            [
                -vertical + b * y[2],
                v / EARTH_RADIUS - level * y[0] - b * c.offset * y[2],
                (y[1] - y[2]) / c.flow,
            ]
        };
        let plus = |y: [f64; 3], k: [f64; 3], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
        let mut y = start;
        let mut all = Vec::new();
        for _ in 0..(hours * 3600.0) as usize {
            all.push(y[0]);
            let k1 = rates(y);
            let k2 = rates(plus(y, k1, 0.5));
            let k3 = rates(plus(y, k2, 0.5));
            let k4 = rates(plus(y, k3, 1.0));
            y = std::array::from_fn(|i| y[i] + (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]) / 6.0);
        }
        all
    }

    fn compass() -> PendulousCompass {
        PendulousCompass::tuned(15.0, 0.03, 60.0, 50f64.to_radians())
    }

    #[test]
    fn it_settles_where_it_is_said_to() {
        let c = compass();
        for (speed, heading) in [(0.0, 0.0), (8.0, 0.3), (10.0, 2.5), (12.0, 4.6)] {
            let (north, east) = (speed * f64::cos(heading), speed * f64::sin(heading));
            let end = *run(&c, [north, east], [0.1, 0.0, 0.0], 60.0).last().unwrap();
            let told = c.settled_error(speed, heading).unwrap();
            assert!((end - told).abs() < 1e-9, "{speed} {heading}: {end} and {told}");
        }
        // a corrector that is set right leaves nothing; set 1° too far north it leaves ε sec² φ · 1°
        let right = Corrector { latitude: c.latitude, speed: 8.0 };
        assert_eq!(c.corrected_error(8.0, 0.7, &right).unwrap(), 0.0);
        let north = Corrector { latitude: c.latitude + 1e-4, speed: 0.0 };
        let left = c.corrected_error(0.0, 0.0, &north).unwrap();
        assert!((left / (c.offset * 1e-4 / c.latitude.cos().powi(2)) - 1.0).abs() < 1e-3, "{left}");
    }

    #[test]
    fn manoeuvres_spread_it_as_many_steps_do() {
        let c = compass();
        // a step of v at once lifts the liquid by v/(g τ)·dt: b jumps by v/(gτ)
        let start = [0.0, 0.0, 1.0 / (c.gravity * c.flow)];
        let still = PendulousCompass { earth_rate: c.earth_rate, ..c };
        let north = c.earth_rate * c.latitude.cos();
        // linear: the answer to v alone, without U sin φ, beside its settled v/(R U cos φ)
        let both = run(&still, [1.0, 0.0], start, 60.0);
        let rest = run(&still, [0.0, 0.0], [0.0; 3], 60.0);
        let settled = 1.0 / (EARTH_RADIUS * north);
        let answer: Vec<f64> = both.iter().zip(&rest).map(|(a, b)| a - b - settled).collect();
        for (deviation, time) in [(7.7, 600.0), (3.0, 120.0), (10.0, 7200.0)] {
            let m = Manoeuvres { deviation, time };
            let other = crate::gyro::manoeuvre::tests::by_steps(1.0, &answer, &m);
            let mine = c.manoeuvre_deviation(&m).unwrap();
            assert!((mine / other - 1.0).abs() < 3e-3, "{m:?}: {mine} and {other}");
        }
    }

    #[test]
    fn a_flow_that_undoes_the_damping_is_refused() {
        let least = |c: &PendulousCompass| c.flow * c.earth_rate * c.latitude.cos();
        let mut c = compass();
        c.offset = 0.99 * least(&c);
        assert!(c.settled_error(0.0, 0.0).unwrap_err().to_string().contains("does not settle"));
        // and it grows indeed; a little more offset, and it does not
        let swing = |c: &PendulousCompass| {
            let path = run(c, [0.0, 0.0], [0.1, 0.0, 0.0], 400.0);
            let largest = |part: &[f64]| part.iter().fold(0.0f64, |m, a| m.max(a.abs()));
            largest(&path[path.len() - 6000..]) / largest(&path[..6000])
        };
        assert!(swing(&c) > 1.0);
        c.offset = 2.0 * least(&c);
        assert!(swing(&c) < 1.0 && c.settled_error(0.0, 0.0).is_ok());
    }
}
