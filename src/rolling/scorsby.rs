//! # Purpose
//! The largest mean heading error on a Scorsby table, which rolls, pitches and yaws a compass by sines, beside what
//! type approval allows.
//!
//! # Method
//! With r and q the complex amplitudes of the accelerations athwart and forward, of one frequency p, (2.1) has
//! W₁ = −r cos K + q sin K and W₂ = r sin K + q cos K; the elastic part answers (x, y) = R(jp)(W₁, W₂), and
//! α = (P/(2 g H U cos φ)) Re(W₂ x* − W₁ y*).
//! For a part that gives way along the parallel alone, x = R₁ W₁, this is
//! α ∝ Re R₁ (−½ sin 2K (|r|² − |q|²) − cos 2K Re r q*) + Im R₁ Im r q*:
//! motions in quadrature add an error that is the same on every heading. Sines of different frequencies have no mean
//! product, and err as each alone. A part that is not linear makes of W₁ an x whose fundamental alone meets W₂: it is
//! followed in time for sines of many amplitudes and periods, R₁ being a function of both, and the worst of each
//! motion once more by itself. Yaw pushes α and λ alone, whose steady answer is tilt and not heading.
//!
//! # References
//! IMO resolution A.424(XI), Performance standards for gyro-compasses (1979), 5.2: simple harmonic roll, pitch and yaw
//! of any period from 6 to 15 s, of at most 20°, 10° and 5°, with horizontal accelerations of at most 1 m/s², may
//! change the settled heading by at most 1° sec φ. ISO 8728 prescribes how it is tested; its numbers are not used here.
//!
//! # Numerical aspects
//! Headings, phases and periods are tried on a grid of 1.5°, 5° and 0.05 s, on which a maximum is missed by less than
//! 0.5 %; of a part that is not linear at periods 0.1 s and amplitudes 1/32 of the greatest apart, so that the largest
//! error, which is followed at its own amplitude, may be missed by some percent. An amplitude whose acceleration would exceed the greatest is reduced to it, both motions alike.

use super::Compass;
use super::table_answer::{Gives, TableAnswer, along, mean_error};
use crate::Result;
use crate::gyro::Gyrosphere;
use crate::gyro::validity::bounded;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// The motions of the table and what is allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scorsby {
    /// Amplitude of roll, rad.
    pub roll: f64,
    /// Amplitude of pitch, rad.
    pub pitch: f64,
    /// Shortest and longest period, s.
    pub periods: [f64; 2],
    /// Greatest horizontal acceleration at the compass, m/s².
    pub acceleration: f64,
    /// The error allowed on the equator, rad; elsewhere it is multiplied by sec φ.
    pub allowed: f64,
}

/// What moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableMotion {
    /// Roll.
    Roll,
    /// Pitch.
    Pitch,
    /// Roll and pitch of one period.
    Both,
}

/// The worst of one kind of motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableError {
    /// What moves.
    pub motion: TableMotion,
    /// Period, s.
    pub period: f64,
    /// Heading, rad.
    pub heading: f64,
    /// By how much pitch leads roll, rad; zero where one moves alone.
    pub phase: f64,
    /// The largest horizontal acceleration in it, m/s².
    pub acceleration: f64,
    /// The mean heading error, rad.
    pub error: f64,
}

/// The worst of each kind of motion, and what is allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct Approval {
    /// The table.
    pub table: Scorsby,
    /// Roll alone, pitch alone, both.
    pub worst: [TableError; 3],
    /// The error allowed at the compass's latitude, rad.
    pub limit: f64,
    /// Whether the part is not linear and was followed in time.
    pub followed: bool,
}

impl Default for Scorsby {
    /// The motions of IMO resolution A.424(XI), 5.2.
    fn default() -> Self {
        Self {
            roll: 20f64.to_radians(),
            pitch: 10f64.to_radians(),
            periods: [6.0, 15.0],
            acceleration: 1.0,
            allowed: 1f64.to_radians(),
        }
    }
}

impl Approval {
    /// The worst of all.
    pub fn largest(&self) -> &TableError {
        let [first, rest @ ..] = &self.worst;
        rest.iter().fold(first, |worst, e| if e.error.abs() > worst.error.abs() { e } else { worst })
    }

    /// What is allowed less the largest error, rad; negative where the compass fails.
    pub fn margin(&self) -> f64 {
        self.limit - self.largest().error.abs()
    }

    /// Whether the compass passes.
    pub fn passes(&self) -> bool {
        self.margin() >= 0.0
    }
}

impl Scorsby {
    /// The largest mean errors of a compass on the table.
    ///
    /// ```
    /// use gyrospec::rolling::{Compass, Scorsby};
    /// let mut compass = Compass::paper();
    /// compass.sphere.stiffness *= 100.0;               // a centre of mass that hardly gives way
    /// assert!(Scorsby::default().test(&compass)?.passes());
    /// # Ok::<(), gyrospec::Error>(())
    /// ```
    ///
    /// # Errors
    /// `BadInput` for impossible numbers; `NotComputed` where the answer of a part that is not linear does not become
    /// periodic; `OutOfRange` for errors beyond the linear theory.
    pub fn test(&self, compass: &Compass) -> Result<Approval> {
        let instrument = compass.instrument();
        let sphere = instrument.sphere;
        sphere.check()?;
        let answer = TableAnswer::of(instrument, self.acceleration)?;
        let gives = self.gives(&answer)?;
        let mut worst = [TableMotion::Roll, TableMotion::Pitch, TableMotion::Both]
            .map(|m| self.worst(m, &sphere, &gives));
        for e in worst.iter_mut().filter(|e| answer.is_followed() && e.period > 0.0) {
            let (accelerations, _) = self.accelerations(e.motion, sphere.lever, e.period, e.phase);
            let exact = answer.of_one(e.period, along(accelerations, e.heading)[0])?;
            e.error = mean_error(&sphere, &exact, accelerations, e.heading);
        }
        worst.iter().try_for_each(|w| bounded(w.error))?;
        let limit = self.allowed / sphere.latitude.cos();
        Ok(Approval { table: *self, worst, limit, followed: answer.is_followed() })
    }

    /// What the part gives at each period that is tried.
    fn gives(&self, answer: &TableAnswer) -> Result<Vec<(f64, Gives)>> {
        let [first, last] = self.periods;
        let apart = if answer.is_followed() { 0.1 } else { 0.05 };
        let steps = ((last - first) / apart).ceil().max(1.0);
        let period = |k: usize| first + (last - first) * k as f64 / steps;
        (0..=steps as usize).map(|k| Ok((period(k), answer.at(period(k))?))).collect()
    }

    fn worst(&self, motion: TableMotion, sphere: &Gyrosphere, gives: &[(f64, Gives)]) -> TableError {
        let phases: usize = if motion == TableMotion::Both { 72 } else { 1 };
        let mut worst =
            TableError { motion, period: 0.0, heading: 0.0, phase: 0.0, acceleration: 0.0, error: 0.0 };
        for (period, gives) in gives {
            let period = *period;
            for phase in (0..phases).map(|i| TAU * i as f64 / phases as f64) {
                let (accelerations, acceleration) = self.accelerations(motion, sphere.lever, period, phase);
                for heading in (0..240).map(|i| 1.5f64.to_radians() * f64::from(i)) {
                    let error = mean_error(sphere, gives, accelerations, heading);
                    // the first of equals is kept, whatever rounding makes of them
                    if error.abs() > worst.error.abs() * (1.0 + 1e-9) {
                        worst = TableError { motion, period, heading, phase, acceleration, error };
                    }
                }
            }
        }
        worst
    }

    /// r and q, m/s², and the largest acceleration in them.
    fn accelerations(
        &self,
        motion: TableMotion,
        lever: f64,
        period: f64,
        phase: f64,
    ) -> ([Complex64; 2], f64) {
        let share = |axis| f64::from(u8::from(motion == axis || motion == TableMotion::Both));
        let square = (TAU / period).powi(2);
        let (a, b) = (self.roll * share(TableMotion::Roll), self.pitch * share(TableMotion::Pitch));
        // s̈ = −h p² θ
        let [r, q] =
            [Complex64::new(a, 0.0), Complex64::from_polar(b, phase)].map(|angle| -lever * square * angle);
        // the half axis of the ellipse: ½(|r|² + |q|² + |r² + q²|)
        let peak = (0.5 * (r.norm_sqr() + q.norm_sqr() + (r * r + q * q).norm())).sqrt();
        let scale = if peak > self.acceleration { self.acceleration / peak } else { 1.0 };
        ([r * scale, q * scale], peak * scale)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gyro::Instrument;
    use crate::gyro::elastic::{Friction, Lag};
    use crate::gyro::seed::{Regular, regular_error};
    use std::f64::consts::PI;

    /// Mean heading over the last of 40 h of (2.1), (2.3) by Runge and Kutta's method of fourth order, under sines of
    /// roll, pitch and yaw.
    fn simulated(s: &Gyrosphere, p: f64, [roll, pitch, yaw]: [f64; 3], phase: f64, heading: f64) -> f64 {
        let l = s.pendulous / s.momentum;
        let rates = |t: f64, y: [f64; 4]| {
            let [alpha, beta, lambda, x] = y;
            let (r, q) =
                (s.lever * roll * p * p * (p * t).sin(), s.lever * pitch * p * p * (p * t + phase).sin());
            let k = heading + yaw * (p * t + 0.7).sin();
            // minus the displacement's second derivative is in r and q
            let (w1, w2) = (r * k.cos() - q * k.sin(), -r * k.sin() - q * k.cos());
            [
                l * beta + s.damper / s.momentum * lambda + l / s.gravity * w2,
                -s.earth_rate * s.latitude.cos() * alpha + s.weight / s.gravity * w2 * x / s.momentum,
                -s.flow * (beta + lambda) - s.flow / s.gravity * w2,
                (s.weight * w1 / (s.gravity * s.stiffness) - x) / s.lag,
            ]
        };
        let step = TAU / p / 64.0;
        let plus = |y: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
        let (mut y, mut t, mut sum, mut count) = ([0.0; 4], 0.0, 0.0, 0);
        while t < 40.0 * 3600.0 {
            let a = rates(t, y);
            let b = rates(t + 0.5 * step, plus(y, a, 0.5 * step));
            let c = rates(t + 0.5 * step, plus(y, b, 0.5 * step));
            let d = rates(t + step, plus(y, c, step));
            y = std::array::from_fn(|i| y[i] + step / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
            t += step;
            if t > 39.0 * 3600.0 {
                (sum, count) = (sum + y[0], count + 1);
            }
        }
        sum / f64::from(count)
    }

    #[test]
    fn roll_alone_is_the_papers_regular_roll() {
        let compass = Compass::paper();
        let wide = Scorsby { acceleration: 1e3, ..Scorsby::default() };
        let [roll, pitch, _] = wide.test(&compass).unwrap().worst;
        // (2.4) at its largest, on 135°, at the shortest period
        let regular = Regular { amplitude: 20f64.to_radians(), frequency: TAU / 6.0 };
        let wanted = regular_error(&compass.sphere, &regular, 0.75 * PI);
        assert!((roll.error.abs() / wanted - 1.0).abs() < 1e-9, "{roll:?}, {wanted}");
        assert!((pitch.error / roll.error).abs() - 0.25 < 1e-9, "as the square of the amplitude");
        assert_eq!(roll.period, 6.0);
    }

    #[test]
    fn together_they_are_as_simulated_on_every_heading() {
        let mut compass = Compass::paper();
        compass.sphere.lever = 1.0;
        let (s, p) = (compass.sphere, TAU / 8.0);
        let gives = TableAnswer::of(Instrument::new(s, Box::new(Lag)), 1.0).unwrap().at(8.0).unwrap();
        let table = Scorsby { roll: 0.05, pitch: 0.03, ..Scorsby::default() };
        for (heading, phase) in [(0.0f64, 1.5f64), (0.6, -1.2), (2.0, 0.4), (5.0, 3.0)] {
            let (amplitudes, _) = table.accelerations(TableMotion::Both, s.lever, 8.0, phase);
            let mine = mean_error(&s, &gives, amplitudes, heading);
            for yaw in [0.0, 0.02] {
                let other = simulated(&s, p, [0.05, 0.03, yaw], phase, heading);
                // yaw's own part is of third order
                let slack = 2e-3 * mine.abs() + 0.02 * yaw * 1e-2;
                assert!((mine - other).abs() < slack, "{heading} {phase} {yaw}: {mine} and {other}");
            }
        }
    }

    #[test]
    fn no_acceleration_exceeds_the_greatest() {
        let table = Scorsby::default();
        for (period, phase) in [(6.0, 0.0), (6.0, 1.0), (7.5, 2.5), (15.0, 1.6)] {
            let ([r, q], largest) = table.accelerations(TableMotion::Both, 9.0, period, phase);
            let at = |i: i32| {
                let turn = Complex64::from_polar(1.0, TAU * f64::from(i) / 3600.0);
                ((r * turn).re.powi(2) + (q * turn).re.powi(2)).sqrt()
            };
            let seen = (0..3600).map(at).fold(0.0, f64::max);
            assert!((seen - largest).abs() < 1e-5 && largest <= 1.0 + 1e-12, "{seen} and {largest}");
        }
    }

    #[test]
    fn a_stiff_sphere_passes() {
        let compass = Compass::paper();
        let soft = Scorsby::default().test(&compass).unwrap();
        assert!(!soft.passes() && soft.largest().motion == TableMotion::Both);
        let ratio = soft.largest().error.abs() / soft.limit;
        // the error goes with 1/C0
        for (more, passes) in [(0.999, false), (1.001, true)] {
            let mut stiffer = compass.clone();
            stiffer.sphere.stiffness *= ratio * more;
            assert_eq!(Scorsby::default().test(&stiffer).unwrap().passes(), passes);
        }
    }

    /// The mean of W₂ x under two sines of period 8 s of m ẍ + r ẋ + C₀ x + F tanh(ẋ/u) = m W₁, by Runge and Kutta.
    fn rubbed(s: &Gyrosphere, force: f64, [r, q]: [Complex64; 2], (heading, steep): (f64, f64)) -> f64 {
        let (m, c, p) = (s.weight / s.gravity, s.stiffness, TAU / 8.0);
        let w = |t: f64| {
            let [r, q] = [r, q].map(|a| (a * Complex64::from_polar(1.0, p * t)).re);
            [-r * heading.cos() + q * heading.sin(), r * heading.sin() + q * heading.cos()]
        };
        let rate = |t: f64, [x, v]: [f64; 2]| {
            [v, w(t)[0] - (s.lag * c * v + c * x + force * (v / steep).tanh()) / m]
        };
        let (count, periods) = (100_000, 4);
        let dt = 8.0 / f64::from(count);
        let (mut y, mut sum) = ([0.0; 2], 0.0);
        for k in 0..count * periods {
            let t = f64::from(k) * dt;
            let step = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
            let a = rate(t, y);
            let b = rate(t + 0.5 * dt, step(a, 0.5 * dt));
            let e = rate(t + 0.5 * dt, step(b, 0.5 * dt));
            let f = rate(t + dt, step(e, dt));
            y = [0, 1].map(|i| y[i] + dt / 6.0 * (a[i] + 2.0 * (b[i] + e[i]) + f[i]));
            if k >= count * (periods - 1) {
                sum += w(t + dt)[1] * y[0] / f64::from(count);
            }
        }
        s.weight / s.gravity * sum / (s.momentum * s.earth_rate * s.latitude.cos())
    }

    #[test]
    fn rubbed_parts_are_as_simulated_on_every_heading() {
        // soft and slow, that the friction is crossed in many of the steps
        let s = Gyrosphere { stiffness: 60.0, lag: 0.2, lever: 1.0, ..Compass::paper().sphere };
        let table = Scorsby { roll: 0.5, pitch: 0.3, ..Scorsby::default() };
        for (force, heading, phase) in [(0.5, 0.6f64, -1.2f64), (2.0, 2.0, 0.4), (2.0, 0.0, 1.5)] {
            let answer = TableAnswer::of(Instrument::new(s, Box::new(Friction { force })), 1.0).unwrap();
            let (rq, _) = table.accelerations(TableMotion::Both, s.lever, 8.0, phase);
            let mine = mean_error(&s, &answer.of_one(8.0, along(rq, heading)[0]).unwrap(), rq, heading);
            let near = mean_error(&s, &answer.at(8.0).unwrap(), rq, heading);
            let [coarse, fine] = [2e-4, 1e-4].map(|u| rubbed(&s, force, rq, (heading, u)));
            // the steepness errs in proportion to itself
            let other = 2.0 * fine - coarse;
            assert!((mine / other - 1.0).abs() < 2e-3, "{force} {heading}: {mine} and {other}");
            assert!((near / mine - 1.0).abs() < 0.03, "{near} {mine}");
        }
    }

    #[test]
    fn friction_of_no_force_errs_as_the_linear_part() {
        use crate::gyro::elastic::Inertia;
        let mut compass = Compass::paper();
        let mut test = |part: Box<dyn crate::gyro::elastic::Elastic>| {
            compass.part = part;
            Scorsby::default().test(&compass).unwrap()
        };
        let (linear, followed) = (test(Box::new(Inertia)), test(Box::new(Friction { force: 0.0 })));
        assert!(followed.followed && !linear.followed);
        for (a, b) in linear.worst.iter().zip(&followed.worst) {
            assert!((a.error / b.error - 1.0).abs() < 1e-2, "{a:?} {b:?}");
        }
        // friction above m W₁ holds the mass, and nothing errs
        let held = test(Box::new(Friction { force: 100.0 }));
        assert!(held.passes() && held.largest().error == 0.0);
    }
}
