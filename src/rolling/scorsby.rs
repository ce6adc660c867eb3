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
//! product, and err as each alone. Yaw pushes α and λ alone, whose steady answer is tilt and not heading.
//!
//! # References
//! IMO resolution A.424(XI), Performance standards for gyro-compasses (1979), 5.2: simple harmonic roll, pitch and yaw
//! of any period from 6 to 15 s, of at most 20°, 10° and 5°, with horizontal accelerations of at most 1 m/s², may
//! change the settled heading by at most 1° sec φ. ISO 8728 prescribes how it is tested; its numbers are not used here.
//!
//! # Numerical aspects
//! Headings, phases and periods are tried on a grid of 1.5°, 5° and 0.05 s, on which a maximum is missed by less than
//! 0.5 %. An amplitude whose acceleration would exceed the greatest is reduced to it, both motions alike.

use super::Compass;
use crate::gyro::validity::bounded;
use crate::gyro::{Gyrosphere, Instrument};
use crate::lti::StateSpace;
use crate::{Error, Result};
use faer::Mat;
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
    /// `BadInput` for impossible numbers; `Usage` for a part that is not linear, whose answer to two sines at once is
    /// not the sum of its answers; `OutOfRange` for errors beyond the linear theory.
    pub fn test(&self, compass: &Compass) -> Result<Approval> {
        let instrument = compass.instrument();
        let sphere = instrument.sphere;
        sphere.check()?;
        let response = response(&instrument)?;
        let worst = [TableMotion::Roll, TableMotion::Pitch, TableMotion::Both]
            .map(|m| self.worst(m, &sphere, &response));
        worst.iter().try_for_each(|w| bounded(w.error))?;
        Ok(Approval { table: *self, worst, limit: self.allowed / sphere.latitude.cos() })
    }

    fn worst(&self, motion: TableMotion, sphere: &Gyrosphere, response: &StateSpace) -> TableError {
        let steps = ((self.periods[1] - self.periods[0]) / 0.05).ceil().max(1.0);
        let phases: usize = if motion == TableMotion::Both { 72 } else { 1 };
        let mut worst =
            TableError { motion, period: 0.0, heading: 0.0, phase: 0.0, acceleration: 0.0, error: 0.0 };
        for k in 0..=steps as usize {
            let period = self.periods[0] + (self.periods[1] - self.periods[0]) * k as f64 / steps;
            let gives = response.at(Complex64::new(0.0, TAU / period));
            for phase in (0..phases).map(|i| TAU * i as f64 / phases as f64) {
                let (accelerations, acceleration) = self.accelerations(motion, sphere.lever, period, phase);
                for heading in (0..240).map(|i| 1.5f64.to_radians() * f64::from(i)) {
                    let error = mean_error(sphere, &gives, accelerations, heading);
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

/// The frequency response of the shift (x, y, z) to (W₁, W₂, W₃) as a system.
fn response(instrument: &Instrument) -> Result<StateSpace> {
    if !instrument.is_linear()? {
        let text = format!(
            "no test on a Scorsby table is known for {}, which is not linear",
            instrument.elastic.name()
        );
        return Err(Error::usage(text).with_hint("take --regular: it simulates such a part on one motion"));
    }
    // what moves the compass matters to parts that are not linear alone
    let still = StateSpace::new(Mat::zeros(0, 0), Mat::zeros(0, 3), Mat::zeros(3, 0), Mat::zeros(3, 3))?;
    instrument.elastic.system(&instrument.sphere, &still)
}

/// α = (P/(2 g H U cos φ)) Re(W₂ x* − W₁ y*).
fn mean_error(s: &Gyrosphere, gives: &Mat<faer::c64>, [r, q]: [Complex64; 2], heading: f64) -> f64 {
    let (sin, cos) = heading.sin_cos();
    let w = [-r * cos + q * sin, r * sin + q * cos];
    let shift = |row: usize| gives[(row, 0)] * w[0] + gives[(row, 1)] * w[1];
    let product = (w[1] * shift(0).conj() - w[0] * shift(1).conj()).re;
    s.weight * product / (2.0 * s.gravity * s.momentum * s.earth_rate * s.latitude.cos())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gyro::elastic::Lag;
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
        let gives = response(&Instrument::new(s, Box::new(Lag))).unwrap().at(Complex64::new(0.0, p));
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
    fn a_stiff_sphere_passes_and_one_that_is_not_linear_is_refused() {
        let mut compass = Compass::paper();
        let soft = Scorsby::default().test(&compass).unwrap();
        assert!(!soft.passes() && soft.largest().motion == TableMotion::Both);
        let ratio = soft.largest().error.abs() / soft.limit;
        // the error goes with 1/C0
        for (more, passes) in [(0.999, false), (1.001, true)] {
            let mut stiffer = compass.clone();
            stiffer.sphere.stiffness *= ratio * more;
            assert_eq!(Scorsby::default().test(&stiffer).unwrap().passes(), passes);
        }
        compass.part = crate::gyro::elastic::asked(|o| (o == "friction").then(|| vec![2.0])).remove(0);
        let e = Scorsby::default().test(&compass).unwrap_err();
        assert!(e.to_string().contains("not linear"), "{e}");
    }
}
