//! Echoes: what follows an input in time, by any linear law that the model does not have.
//!
//! # Purpose
//! See dynamics that are missing, of which a law of the present values of signals shows nothing: a wave that comes back,
//! many resonances, a slow store.
//!
//! # Method
//! An output may hold, beside what the model gives, what resonators make of an input, x″ + 2ζω x′ + ω² x = u, with
//! frequencies over the whole range in even ratios. They look at the past alone, so that an input that a controller makes
//! from the noise of an output does not pass for its cause.
//!
//! # References
//! L. Ljung, System Identification, 2nd ed. (1999), 16.6 (residual analysis: what is left and past inputs);
//! W. H. Kautz, Transient synthesis in the time domain, IRE Trans. Circuit Theory 1 (1954) 29 (the basis).
//!
//! # Numerical aspects
//! Each pair x, x′ is one complex number, z′ = λz + u with λ = ω(−ζ + i√(1 − ζ²)), stepped exactly for an input that is
//! straight or held from point to point. It starts as if its first value had stood for ever.

use crate::diagnose::bench::{Bench, Track};
use crate::diagnose::view::View;
use crate::record::Channel;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// Resonators at most, and the least ratio of their frequencies.
const MOST: usize = 12;
const RATIO: f64 = 2.0;
/// Their damping.
const DAMPING: f64 = 0.35;
/// Periods of the slowest in the recording, and steps in a radian of the fastest.
const SLOWEST: f64 = 2.0;
const FASTEST: f64 = 2.0;

/// The tracks of a view with sensitivities to an input's echoes at an output; `None` where the input stands still.
pub(super) fn tracks(bench: &Bench, view: &View, output: usize, input: &str) -> Option<Vec<Track>> {
    let own = |t: &&Track| t.output == output && t.time.len() > 2;
    let longest = view.tracks.iter().filter(own).max_by_key(|t| t.time.len())?;
    let lambdas = lambdas(&longest.time);
    let one = |(t, recording): (&Track, &usize)| {
        let nothing = || vec![vec![0.0; t.time.len()]; 2 * lambdas.len()];
        let channel = bench.recordings.get(*recording).and_then(|r| r.find(input));
        let moved = channel.filter(|_| t.output == output).and_then(|c| echoes(c, &t.time, &lambdas));
        Track {
            output: t.output,
            stretches: t.stretches.clone(),
            time: Vec::new(),
            residual: Vec::new(),
            sensitivities: moved.unwrap_or_else(nothing),
        }
    };
    Some(view.tracks.iter().zip(&view.recordings).map(one).collect())
}

/// λ of each resonator for samples at rising times.
fn lambdas(time: &[f64]) -> Vec<Complex64> {
    let mut steps: Vec<f64> = time.windows(2).map(|w| w[1] - w[0]).collect();
    let middle = steps.len() / 2;
    let usual = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
    let slow = TAU * SLOWEST / (time[time.len() - 1] - time[0]);
    let fast = (1.0 / (FASTEST * usual)).max(slow);
    let ratio = (fast / slow).powf(1.0 / (MOST - 1) as f64).max(RATIO);
    let frequencies = (0..MOST as i32).map(|k| slow * ratio.powi(k)).take_while(|w| *w <= 1.001 * fast);
    frequencies.map(|w| w * Complex64::new(-DAMPING, (1.0 - DAMPING * DAMPING).sqrt())).collect()
}

/// Re z and Im z of every resonator at rising times.
fn echoes(input: &Channel, time: &[f64], lambdas: &[Complex64]) -> Option<Vec<Vec<f64>>> {
    let mut points: Vec<f64> = time.to_vec();
    points.extend(input.time.iter().filter(|t| **t > time[0] && **t < time[time.len() - 1]));
    points.sort_by(f64::total_cmp);
    points.dedup();
    let mut value =
        input.value_from(time[0]).or_else(|| input.values.iter().copied().find(|v| v.is_finite()))?;
    let mut z: Vec<Complex64> = lambdas.iter().map(|l| -value / l).collect();
    let mut out = vec![Vec::with_capacity(time.len()); 2 * lambdas.len()];
    let mut asked = time.iter().peekable();
    let mut steps = Steps::default();
    for (k, t) in points.iter().enumerate() {
        if let Some(last) = k.checked_sub(1).map(|k| points[k]) {
            // an input in its gap stays as it was
            let next = input.value_from(*t).unwrap_or(value);
            let to = if input.hold.is_held() { value } else { next };
            steps.advance(&mut z, lambdas, t - last, (value, to));
            value = next;
        }
        if asked.next_if(|a| *a == t).is_some() {
            for (pair, z) in out.chunks_exact_mut(2).zip(&z) {
                pair[0].push(z.re);
                pair[1].push(z.im);
            }
        }
    }
    Some(out)
}

/// The factors of the last step, which the next one mostly shares.
#[derive(Default)]
struct Steps {
    h: f64,
    factors: Vec<[Complex64; 3]>,
}

impl Steps {
    /// z(h) = e^(λh) z + (φ₁ − φ₂) h u₀ + φ₂ h u₁,  φ₁ = (e^(λh) − 1)/(λh), φ₂ = (φ₁ − 1)/(λh)
    fn advance(&mut self, z: &mut [Complex64], lambdas: &[Complex64], h: f64, (from, to): (f64, f64)) {
        if h != self.h || self.factors.is_empty() {
            self.h = h;
            self.factors = lambdas.iter().map(|l| factors(l * h, h)).collect();
        }
        for (z, [decay, a, b]) in z.iter_mut().zip(&self.factors) {
            *z = decay * *z + a * from + b * to;
        }
    }
}

/// e^x, (φ₁ − φ₂) h and φ₂ h.
fn factors(x: Complex64, h: f64) -> [Complex64; 3] {
    let decay = x.exp();
    if x.norm() < 1e-3 {
        // φ₁ = 1 + x/2 + x²/6 + …, φ₂ = 1/2 + x/6 + x²/24 + …
        let first = 1.0 + x / 2.0 + x * x / 6.0 + x * x * x / 24.0;
        let second = 0.5 + x / 6.0 + x * x / 24.0 + x * x * x / 120.0;
        return [decay, (first - second) * h, second * h];
    }
    let first = (decay - 1.0) / x;
    let second = (first - 1.0) / x;
    [decay, (first - second) * h, second * h]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;

    /// A sine through a resonator is a sine: z = Im(e^(iwt)/(iw − λ)) once the start has died away.
    #[test]
    fn a_sine_comes_back_by_the_transfer_function() {
        let time: Vec<f64> = (0..4000).map(|i| 0.01 * f64::from(i)).collect();
        let w = 3.0;
        let values = time.iter().map(|t| (w * t).sin()).collect();
        let input = Channel::new("u", Unit::one(), time.clone(), values);
        let lambda = 2.0 * Complex64::new(-DAMPING, (1.0 - DAMPING * DAMPING).sqrt());
        let seen: Vec<f64> = time.iter().copied().skip(5).step_by(3).collect();
        let echoes = echoes(&input, &seen, &[lambda]).unwrap();
        let i = Complex64::i();
        for (k, t) in seen.iter().enumerate().filter(|(_, t)| **t > 20.0) {
            let plus = (i * w * t).exp() / (i * w - lambda);
            let minus = (-i * w * t).exp() / (-i * w - lambda);
            let z = (plus - minus) / (2.0 * i);
            let off = (Complex64::new(echoes[0][k], echoes[1][k]) - z).norm();
            assert!(off < 1e-4 * z.norm().max(0.1), "{t}: {off}");
        }
    }

    /// The series of small arguments meets the closed form.
    #[test]
    fn small_steps_agree_with_larger_ones() {
        let x = Complex64::new(-3e-4, 1.001e-3);
        let [_, a, b] = factors(x, 1.0);
        let [_, c, d] = factors(x * 0.95, 1.0);
        assert!((a - c).norm() < 1e-4 && (b - d).norm() < 1e-4 && (a + b - 1.0).norm() < 1e-3);
    }
}
