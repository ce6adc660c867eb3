//! # Purpose
//! The rate that random torques and random base motion feign: noise-equivalent rate.
//!
//! # Method
//! Demodulation shifts frequencies by Ω. Base motion r = Θ′ + jΨ′ gives α = Re(a∗r e^{jΩt}), so that the reading is
//! F∗(a∗r)/a(0) + F∗((a∗r)* e^{−2jΩt})/a(0): what passes the low-pass F where it is, the skirt of F included, and
//! what is folded by 2Ω. Both axes of the base alike and independent, the two add in the mean square. The density of the reading's noise is a product of
//! squared moduli of polynomials at jω and j(ω ± Ω), j(ω ± 2Ω); over a common denominator of
//! real coefficients its even part in ω is the G of an integral I_n.
//!
//! # References
//! The reduction to I_n as in the rolling-error paper, (3.10)–(3.12), with shifted arguments.
//!
//! # Numerical aspects
//! Shifted real polynomials come in conjugate pairs f(s + jσ) f(s − jσ), whose product is real
//! and Hurwitz when f is. Frequencies are taken in units of Ω to keep the coefficients of one size.

use super::Gimbal;
use crate::gyro::range;
use crate::gyro::validity::Smallness;
use crate::integral::{Integrand, evaluate};
use crate::poly::product;
use crate::units::figure;
use crate::{Error, ErrorKind, Result};
use num_complex::Complex64;

/// What disturbs the sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Intensities of white torque noise about α and β, (N·m)²·s.
    pub torque: [f64; 2],
    /// Random base rates about each axis: standard deviation rad/s, prevailing frequency rad/s,
    /// and damping ratio of their second-order spectrum; `None`: a quiet base.
    pub base: Option<[f64; 3]>,
}

impl Noise {
    /// The names of its numbers in the symbol table.
    pub const NAMES: [&str; 5] = ["Qx", "Qy", "sigma", "omega0", "zeta"];

    /// The place of a number by its name in the symbol table; a quiet base begins to move by it.
    pub fn named(&mut self, name: &str) -> Option<&mut f64> {
        let base = || [0.0, 10.0, 0.5];
        Some(match name {
            "Qx" => &mut self.torque[0],
            "Qy" => &mut self.torque[1],
            "sigma" => &mut self.base.get_or_insert_with(base)[0],
            "omega0" => &mut self.base.get_or_insert_with(base)[1],
            "zeta" => &mut self.base.get_or_insert_with(base)[2],
            _ => return None,
        })
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// `BadInput` that names a number outside its [range].
    pub fn check(&self) -> Result<()> {
        let values = self.torque.into_iter().chain(self.base.into_iter().flatten());
        Self::NAMES.iter().zip(values).try_for_each(|(name, value)| {
            let range = range::of_gimbal(name);
            range.map_or(Ok(value), |r| r.check(value)).map(|_| ()).map_err(|e| e.about(name))
        })
    }
}

/// The standard deviation of each rate that the sensor reads wrongly, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NoiseEquivalent {
    /// By the torque noise.
    pub torque: f64,
    /// By the base's random motion, in all.
    pub base: f64,
    /// Its part that passes the low-pass where it is: slow rates, truly read, and what the filter's skirt lets through.
    pub base_passed: f64,
    /// Its part near twice the ring's speed, which folds onto slow rates.
    pub base_folded: f64,
}

/// ∏ |f(j(ω + σ))|² in a denominator: f descending, σ in units of Ω.
struct Factor {
    f: Vec<f64>,
    shift: f64,
}

impl Gimbal {
    /// Noise-equivalent rate behind a demodulator with corner ω_c, rad/s.
    ///
    /// # Errors
    /// `BadInput` that names a number outside its [range]; `NotComputed` where damping and corner lie too far
    /// from the ring's speed for doubles.
    pub fn noise_equivalent(&self, noise: &Noise, corner: f64) -> Result<NoiseEquivalent> {
        self.check()?;
        noise.check()?;
        range::CORNER.check(corner)?;
        self.behind(noise, corner).map_err(|e| self.too_far_apart(e, corner))
    }

    fn behind(&self, noise: &Noise, corner: f64) -> Result<NoiseEquivalent> {
        let torque = self.by_torque(noise.torque, corner)?;
        let [passed, folded] = match noise.base {
            Some(base) => {
                [self.by_base(base, Some((corner, -1.0)))?, self.by_base(base, Some((corner, 1.0)))?]
            }
            None => [0.0; 2],
        };
        Ok(NoiseEquivalent {
            torque: torque.sqrt(),
            base: (passed + folded).sqrt(),
            base_passed: passed.sqrt(),
            base_folded: folded.sqrt(),
        })
    }

    /// What (1) takes for small: the swing of α by a constant rate (rad/s) and by the base's random motion, in rad, and
    /// the base's rates against the ring's.
    ///
    /// # Errors
    /// As [`Gimbal::noise_equivalent`].
    pub fn smallness(&self, noise: &Noise, rate: f64) -> Result<Vec<Smallness>> {
        noise.check()?;
        let small = |figure, message, value| Smallness { figure, message, value, limit: 0.3, unit: "1" };
        let scale = self.scale_factor(0.0).norm();
        let sigma = noise.base.map_or(0.0, |b| b[0]);
        let random = match noise.base {
            Some(base) => {
                let moved = self.by_base(base, None).map_err(|e| self.too_far_apart(e, self.speed))?;
                scale * moved.sqrt()
            }
            None => 0.0,
        };
        Ok(vec![
            small("swing", "swing of α by the manoeuvre, rad", scale * rate),
            small("random-swing", "swing of α by the base's random motion, rad", random),
            small("rate", "rates of the base against that of the ring", sigma.max(rate) / self.speed),
        ])
    }

    /// A denominator that is stable, but not in doubles: in words of the gimbal.
    fn too_far_apart(&self, e: Error, corner: f64) -> Error {
        if !matches!(e.kind(), ErrorKind::Unstable | ErrorKind::ImaginaryAxis | ErrorKind::OutOfRange) {
            return e;
        }
        let [dx, dy] = self.damping.map(figure);
        Error::not_computed(format!(
            "no double tells the noise of the reading: the ring's speed of {} rad/s, damping (dx = {dx}, dy = {dy} N*m*s) \
             and the demodulator's corner of {} rad/s lie too far apart",
            figure(self.speed),
            figure(corner)
        ))
    }

    /// In units of Ω for frequencies: det M, (M⁻¹)₁₁ and (M⁻¹)₁₂ numerators, the low-pass.
    fn scaled(&self, corner: f64) -> (Vec<f64>, [Vec<f64>; 2], Vec<f64>) {
        let w = self.speed;
        let c = self.coefficients();
        let powers = |p: &[f64]| -> Vec<f64> {
            p.iter().enumerate().map(|(i, v)| v * w.powi((p.len() - 1 - i) as i32)).collect()
        };
        let first = powers(&[c.inertia[1], self.damping[1], c.stiffness[1]]);
        let second = powers(&[-c.gyroscopic, 0.0]);
        let x = w / corner;
        (powers(&self.characteristic()), [first, second], vec![x * x, 2.0 * x, 1.0])
    }

    /// Var Re r = (2/|a|²)(1/2π)∫ |F(j(ω − Ω))|² S_α(ω) dω: half of the complex variance.
    fn by_torque(&self, torque: [f64; 2], corner: f64) -> Result<f64> {
        let (determinant, numerators, low) = self.scaled(corner);
        let mut top = vec![0.0];
        for (q, n) in torque.iter().zip(&numerators) {
            top = plus(&top, &square(&real(n), 0.0).iter().map(|v| q * v).collect::<Vec<_>>());
        }
        let factors = [Factor { f: determinant, shift: 0.0 }, Factor { f: low, shift: -1.0 }];
        Ok(2.0 / self.scale_factor(0.0).norm_sqr() * self.speed * shifted_integral(&top, &factors)?)
    }

    /// Var Re r = (1/2)(1/2π)∫ |F(j(ω ∓ Ω))|² |a(ω − Ω)/a(0)|² 2S(ω − Ω) dω, ω = Ω + ν: what passes the low-pass
    /// at its own ν (`shift` −1), or folds from near ν = −2Ω (`shift` +1), or without F all of it; S of each rate is a second-order spectrum.
    fn by_base(&self, [deviation, frequency, damping]: [f64; 3], low: Option<(f64, f64)>) -> Result<f64> {
        let determinant = self.scaled(self.speed).0;
        let (w, w0) = (self.speed, frequency / self.speed);
        // S(ν) = σ² 4ζω₀³/|s² + 2ζω₀ s + ω₀²|², in units of Ω
        let gain = deviation.powi(2) * 4.0 * damping * w0.powi(3) / w;
        let spectrum = vec![1.0, 2.0 * damping * w0, w0 * w0];
        let top: Vec<f64> = square(&self.drive_numerator(), 0.0)
            .iter()
            .map(|v| gain * v / self.scale_factor(0.0).norm_sqr())
            .collect();
        let mut factors = vec![Factor { f: determinant, shift: 0.0 }, Factor { f: spectrum, shift: -1.0 }];
        factors.extend(low.map(|(corner, shift)| Factor { f: self.scaled(corner).2, shift }));
        Ok(self.speed * shifted_integral(&top, &factors)?)
    }

    /// a(ν)·det M(jω) as a polynomial in x = ω/Ω, descending: with ν = ω − Ω the torques are
    /// −E₁ − A(ω − Ω) and −jE₂ − jB(ω − Ω).
    fn drive_numerator(&self) -> Vec<Complex64> {
        let c = self.coefficients();
        let w = self.speed;
        let (a, b) = (c.inertia[0] * w, c.inertia[1] * w);
        let j = Complex64::I;
        let first = [Complex64::from(-a), Complex64::from(-c.drive[0] + a)];
        let second = [-j * b, j * (b - c.drive[1])];
        // m₂₂(jω) = −Bω² + j d_y ω + K₂,  m₁₂(jω) = jΓω
        let m22 = [
            Complex64::from(-c.inertia[1] * w * w),
            j * (self.damping[1] * w),
            Complex64::from(c.stiffness[1]),
        ];
        let m12 = [-j * (c.gyroscopic * w), Complex64::ZERO];
        let (one, two) = (times(&m22, &first), times(&m12, &second));
        let pad = one.len() - two.len();
        one.iter().enumerate().map(|(i, v)| if i < pad { *v } else { v + two[i - pad] }).collect()
    }
}

/// A polynomial in s of real coefficients as one in x, s = jx.
fn real(f: &[f64]) -> Vec<Complex64> {
    let n = f.len() - 1;
    f.iter().enumerate().map(|(i, v)| Complex64::I.powu((n - i) as u32) * *v).collect()
}

fn times(p: &[Complex64], q: &[Complex64]) -> Vec<Complex64> {
    let mut out = vec![Complex64::ZERO; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (k, b) in q.iter().enumerate() {
            out[i + k] += a * b;
        }
    }
    out
}

/// p(x + σ), descending, by repeated synthetic division.
fn shifted(p: &[Complex64], sigma: f64) -> Vec<Complex64> {
    let mut out = p.to_vec();
    for end in (1..out.len()).rev() {
        for i in 1..=end {
            let carried = out[i - 1] * sigma;
            out[i] += carried;
        }
    }
    out
}

/// |p(x + σ)|² for real x, a real polynomial in x.
fn square(p: &[Complex64], sigma: f64) -> Vec<f64> {
    let moved = shifted(p, sigma);
    let conjugate: Vec<Complex64> = moved.iter().map(Complex64::conj).collect();
    times(&moved, &conjugate).iter().map(|z| z.re).collect()
}

fn plus(p: &[f64], q: &[f64]) -> Vec<f64> {
    let n = p.len().max(q.len());
    let at = |c: &[f64], i: usize| (i + c.len()).checked_sub(n).map_or(0.0, |k| c[k]);
    (0..n).map(|i| at(p, i) + at(q, i)).collect()
}

/// (1/2π)∫ top(x)/∏|f(j(x + σ))|² dx as an I_n.
fn shifted_integral(top: &[f64], factors: &[Factor]) -> Result<f64> {
    let mut h = vec![1.0];
    let mut g = top.to_vec();
    for factor in factors {
        if factor.shift == 0.0 {
            h = product(&h, &factor.f);
            continue;
        }
        // f(s + jσ) f(s − jσ): real; in x = s/j a pair of shifts by ±σ
        let p = real(&factor.f);
        let pair = times(&shifted(&p, factor.shift), &shifted(&p, -factor.shift));
        h = product(&h, &in_s(&pair));
        g = product(&g, &square(&p, -factor.shift));
    }
    let n = h.len() - 1;
    // even part in x, x² = −s²
    let degree = g.len() - 1;
    let mut b = vec![0.0; n];
    for (i, v) in g.iter().enumerate() {
        let power = degree - i;
        if power.is_multiple_of(2) {
            let half = power / 2;
            if half >= n {
                return Err(Error::not_computed("the noise's density does not fall off"));
            }
            b[n - 1 - half] = if half.is_multiple_of(2) { *v } else { -v };
        }
    }
    Ok(evaluate(&Integrand::new(&h, &b)?)?.value)
}

/// A polynomial in x = s/j back in s; its coefficients there are real.
fn in_s(p: &[Complex64]) -> Vec<f64> {
    let n = p.len() - 1;
    p.iter().enumerate().map(|(i, z)| (*z / Complex64::I.powu((n - i) as u32)).re).collect()
}
