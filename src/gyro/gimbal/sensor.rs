//! The gimbal as a sensor: scale factor, band, demodulation.

use super::{Gimbal, Sample};
use crate::gyro::range;
use crate::units::figure;
use crate::{Error, Result};
use num_complex::Complex64;

/// How fast the base's rates may vary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Band {
    /// Up to here the reading is within 1 % of the rate, rad/s.
    pub one_percent: f64,
    /// Up to here it is within 3 dB, rad/s.
    pub three_decibel: f64,
}

impl Gimbal {
    /// The complex scale factor at a slow frequency ν (rad/s, of either sign): base rates
    /// r = Θ′ + jΨ′ = r̂ e^{jνt} give α = Re(a(ν) r e^{jΩt}), rad per rad/s.
    ///
    /// ```
    /// let gimbal = gyrospec::gyro::gimbal::Gimbal::example();
    /// let a = gimbal.scale_factor(0.0);
    /// // a constant rate gives a sine at Ω: amplitude |a|·√(Θ′² + Ψ′²), phase by direction
    /// assert!(a.norm() > 0.0);
    /// ```
    pub fn scale_factor(&self, nu: f64) -> Complex64 {
        let c = self.coefficients();
        // torques: α: −E₁ r + jA ṙ,  β: −jE₂ r − B ṙ,  ṙ = jν r
        let first = Complex64::from(-c.drive[0] - c.inertia[0] * nu);
        let second = Complex64::new(0.0, -c.drive[1] - c.inertia[1] * nu);
        let m = self.inverse(Complex64::new(0.0, self.speed + nu));
        m[0][0] * first + m[0][1] * second
    }

    /// The band in which rates count as slowly varying, by the gimbal alone.
    pub fn band(&self) -> Band {
        let still = self.scale_factor(0.0);
        let off = |nu: f64| {
            [nu, -nu].map(|v| (self.scale_factor(v) / still - 1.0).norm()).into_iter().fold(0.0, f64::max)
        };
        let gain = |nu: f64| {
            [nu, -nu]
                .map(|v| (self.scale_factor(v) / still).norm().ln().abs())
                .into_iter()
                .fold(0.0, f64::max)
        };
        let edge = |f: &dyn Fn(f64) -> f64, limit: f64| {
            let steps = (0..=4000).map(|k| self.speed * 1e-6 * 10f64.powf(6.0 * f64::from(k) / 4000.0));
            steps.take_while(|nu| f(*nu) <= limit).last().unwrap_or(0.0)
        };
        Band { one_percent: edge(&off, 0.01), three_decibel: edge(&gain, 0.5 * 2f64.ln()) }
    }
}

/// Reads both rates from α: multiplies by 2e^{−jΩt}/a(0) and low-passes by 1/(1 + s/ω_c)².
#[derive(Debug, Clone)]
pub struct Demodulator {
    speed: f64,
    scale: Complex64,
    corner: f64,
}

impl Demodulator {
    /// A demodulator for a gimbal with corner ω_c, rad/s.
    ///
    /// # Errors
    /// `BadInput` for a corner outside its [range], or not below the ring's speed.
    pub fn new(gimbal: &Gimbal, corner: f64) -> Result<Self> {
        gimbal.check()?;
        range::CORNER.check(corner)?;
        if corner >= gimbal.speed {
            return Err(Error::bad_input(format!(
                "a demodulator's corner of {} rad/s does not lie below the ring's speed, {} rad/s",
                figure(corner),
                figure(gimbal.speed)
            ))
            .with_hint("it reads rates that are slow beside the ring's"));
        }
        Ok(Self { speed: gimbal.speed, scale: gimbal.scale_factor(0.0), corner })
    }

    /// Both rates (Θ′, Ψ′), rad/s, at each sample of α; samples at equal steps.
    pub fn rates(&self, samples: &[Sample]) -> Vec<(f64, f64)> {
        let (mut first, mut second) = (Complex64::ZERO, Complex64::ZERO);
        let mut before: Option<(f64, Complex64)> = None;
        samples
            .iter()
            .map(|s| {
                let turned = 2.0 * s.alpha * Complex64::from_polar(1.0, -self.speed * s.time) / self.scale;
                if let Some((time, last)) = before {
                    // each low-pass exactly for an input that is straight between samples
                    let step = s.time - time;
                    let next = low_pass(first, last, turned, self.corner * step);
                    second = low_pass(second, first, next, self.corner * step);
                    first = next;
                }
                before = Some((s.time, turned));
                (second.re, second.im)
            })
            .collect()
    }
}

/// y′ = (u − y) over x time constants, u straight from u₀ to u₁.
fn low_pass(y: Complex64, u0: Complex64, u1: Complex64, x: f64) -> Complex64 {
    let decay = (-x).exp();
    let mean = -(-x).exp_m1() / x;
    y * decay + u0 * (mean - decay) + u1 * (1.0 - mean)
}
