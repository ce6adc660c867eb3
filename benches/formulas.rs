//! Every instrument on every motion: what the formulas say of mean, spread and spectrum beside simulations that share
//! nothing with them, with 99 % intervals.
//!
//! `cargo bench --bench formulas`; some minutes on two cores. The gyrosphere is a quick one, so that a short simulation
//! holds many of its periods: the theory is the same. A star marks a formula outside the interval of its simulation: one
//! in a hundred is to be expected.
#![allow(missing_docs, clippy::print_stdout)]

use faer::Mat;
use gyrospec::gyro::elastic::{
    Compliance, Elastic, Friction, Inertia, Lag, Pendulum, Relaxing, Slosh, together,
};
use gyrospec::gyro::gimbal::{Demodulator, Gimbal, Noise, Run, State};
use gyrospec::gyro::pendulous::PendulousCompass;
use gyrospec::gyro::seed::Regular;
use gyrospec::gyro::strapdown::NorthSeeking;
use gyrospec::gyro::{Axis, Drive, EARTH_RADIUS, Gyrosphere, Instrument, Manoeuvres, MonteCarlo, Motion};
use gyrospec::lti::{Discrete, StateSpace};
use gyrospec::rolling::{Excitation, Source, Waves};
use gyrospec::spectrum::{Hull, Roll, Sea};
use gyrospec::{Complex64, Result};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// Replicates of a simulation, and Student's t for 99 % of their mean.
const REPLICATES: usize = 16;
const STUDENT: f64 = 2.947;
const FREQUENCIES: [f64; 2] = [0.05, 0.8];

/// Rows, and those outside their interval.
#[derive(Default)]
struct Told {
    rows: usize,
    outside: usize,
}

impl Told {
    fn row(&mut self, [instrument, motion, figure]: [&str; 3], formula: f64, simulated: f64, margin: f64) {
        let off = (formula - simulated).abs() > margin;
        self.rows += 1;
        self.outside += usize::from(off);
        let relative = (formula - simulated) / simulated.abs();
        println!(
            "{instrument:28} {motion:22} {figure:26} {formula:>13.5e} {simulated:>13.5e} {:>9.1} % {:>9.2} % {}",
            100.0 * margin / simulated.abs(),
            100.0 * relative,
            if off { "*" } else { "" }
        );
    }

    /// A row whose simulation is a list of replicates.
    fn pooled(&mut self, names: [&str; 3], formula: f64, replicates: &[f64], root: bool) {
        let n = replicates.len() as f64;
        let mean = replicates.iter().sum::<f64>() / n;
        let variance = replicates.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
        let margin = STUDENT * (variance / n).sqrt();
        if root {
            // of a variance: its root, and half its relative margin
            self.row(names, formula, mean.sqrt(), 0.5 * margin / mean.sqrt());
        } else {
            self.row(names, formula, mean, margin);
        }
    }
}

fn quick() -> Gyrosphere {
    Gyrosphere { pendulous: 40.0, damper: 16.0, flow: 0.02, stiffness: 1e6, ..Gyrosphere::seed() }
}

/// The parts, each with its name.
fn parts() -> Result<Vec<(&'static str, Box<dyn Elastic>)>> {
    let flow = Relaxing { time: 3.0, share: 0.2 };
    Ok(vec![
        ("lag", Box::new(Lag)),
        ("lag with inertia", Box::new(Inertia)),
        ("lag and flow", Box::new(flow)),
        ("lag and slosh", Box::new(Slosh { frequency: 3.0, damping: 0.1, share: 1e-5 })),
        ("lag along the meridian too", Box::new(Compliance { meridian: Some((3e6, 0.6)), vertical: None })),
        ("swing with its rotors", Box::new(Pendulum { period: 20.0, damping: 0.2, coupling: 0.8, lag: 1.0 })),
        ("inertia and flow", together(&[Box::new(Inertia) as Box<dyn Elastic>, Box::new(flow)])?),
        ("dry friction", Box::new(Friction { force: 5.0 })),
    ])
}

fn motions() -> Result<Vec<(&'static str, Motion)>> {
    let roll = Excitation { source: Source::Irregular(Roll::new(0.02, 0.1, 0.8)?), band: Some(2.5) };
    let sea = |sea, from, also| {
        Source::Sea(Waves { sea, from, speed: 0.0, spread: None, hull: Hull::default(), also })
    };
    let beam = sea(Sea::Jonswap { height: 3.0, peak: 0.8, gamma: 3.3 }, FRAC_PI_2, vec![]);
    let bow =
        sea(Sea::PiersonMoskowitz { height: 4.0 }, FRAC_PI_4, vec![Axis::Pitch, Axis::Surge, Axis::Heave]);
    let in_sea = |source| Ok::<_, gyrospec::Error>(Excitation { source, band: Some(2.5) }.motion()?.motion);
    Ok(vec![
        ("irregular roll", roll.motion()?.motion),
        ("JONSWAP from abeam", in_sea(beam)?),
        ("PM on the bow, 4 axes", in_sea(bow)?),
    ])
}

fn main() -> Result<()> {
    let mut told = Told::default();
    println!(
        "{:28} {:22} {:26} {:>13} {:>13} {:>11} {:>11}",
        "instrument", "motion", "figure (SI, rad)", "formula", "simulated", "99 % ±", "difference"
    );
    for (name, part) in parts()? {
        let compass = Instrument::new(quick(), part);
        for (motion, moved) in motions()? {
            random(&mut told, [name, motion], &compass, &moved)?;
        }
        regular(&mut told, name, &compass)?;
    }
    pendulous(&mut told)?;
    seeking(&mut told)?;
    gimbal(&mut told)?;
    println!("\n{} of {} outside their 99 % interval", told.outside, told.rows);
    Ok(())
}

fn random(told: &mut Told, [name, motion]: [&str; 2], compass: &Instrument, moved: &Motion) -> Result<()> {
    let error = compass.error(moved, FRAC_PI_4)?;
    let drive = Drive::irregular(moved);
    let plan = MonteCarlo { step: drive.step()?, duration: 5.0 * 3600.0, settle: 2000.0, runs: 24, seed: 5 };
    let run = plan.run(compass, &drive, FRAC_PI_4)?;
    told.row([name, motion, "mean"], error.mean(), run.mean, run.mean_margin + error.rectified_margin);
    let spread = run.variance.sqrt();
    let margin = 0.5 * run.variance_margin / spread + error.deviation_margin;
    // the simulation's second moment is about the rest, the formula's about the mean
    let about = error.deviation.hypot(error.mean());
    told.row([name, motion, "root mean square"], about, spread, margin);
    if compass.is_linear()? && !moved.axes().contains(&Axis::Heave) {
        let densities = compass.error_spectrum(moved, FRAC_PI_4, &FREQUENCIES)?;
        let simulated = periodograms(compass, moved)?;
        for ((omega, (swing, products)), periodogram) in FREQUENCIES.iter().zip(densities).zip(simulated) {
            told.pooled(
                [name, motion, &format!("density at {omega} rad/s")],
                swing + products,
                &periodogram,
                false,
            );
        }
    }
    Ok(())
}

/// Densities of α at two frequencies from a path of (2.1) stepped by Heun's rule, a list of replicates each.
fn periodograms(compass: &Instrument, moved: &Motion) -> Result<[Vec<f64>; 2]> {
    let s = &compass.sphere;
    let (l, c, f, n) =
        (s.pendulous / s.momentum, s.damper / s.momentum, s.flow, s.earth_rate * s.latitude.cos());
    let accelerations = horizontal(moved, s.lever)?;
    let part = compass.elastic.system(s, &accelerations)?;
    let joint = accelerations.then(&part)?;
    let (order, base) = (joint.order(), accelerations.order());
    let (step, segment, segments) = (0.05, 16_000, 25);
    let mut advance = Discrete::new(&joint.a, &joint.b, step);
    let window: Vec<f64> =
        (0..segment).map(|k| 1.0 - (TAU * f64::from(k) / f64::from(segment)).cos()).collect();
    let turns = FREQUENCIES.map(|w| Complex64::cis(-w * step));
    let replicate = |seed: usize| -> [f64; 2] {
        let mut rng = ChaCha8Rng::seed_from_u64(seed as u64);
        let (mut z, mut y, mut power) = (vec![0.0; order], [0.0; 3], [0.0; 2]);
        let mut push = |z: &mut Vec<f64>| -> [f64; 2] {
            advance.advance(z, &mut rng);
            let w = |i: usize| (0..base).map(|j| accelerations.c[(i, j)] * z[j]).sum::<f64>();
            let shift = |i: usize| (0..order).map(|j| joint.c[(i, j)] * z[j]).sum::<f64>();
            [w(1), s.weight / (s.gravity * s.momentum) * (w(1) * shift(0) - w(0) * shift(1))]
        };
        let rates = |y: [f64; 3], [w2, m]: [f64; 2]| {
            [l * y[1] + c * y[2] + l / s.gravity * w2, m - n * y[0], -f * (y[1] + y[2]) - f / s.gravity * w2]
        };
        let mut before = push(&mut z);
        let mut next = |y: &mut [f64; 3], before: &mut [f64; 2]| {
            let now = push(&mut z);
            let first = rates(*y, *before);
            let second = rates([0, 1, 2].map(|i| y[i] + step * first[i]), now);
            *y = [0, 1, 2].map(|i| y[i] + 0.5 * step * (first[i] + second[i]));
            *before = now;
        };
        for _ in 0..60_000 {
            next(&mut y, &mut before);
        }
        for _ in 0..segments {
            let (mut sums, mut phases) = ([Complex64::ZERO; 2], [Complex64::ONE; 2]);
            for w in &window {
                for i in 0..2 {
                    sums[i] += phases[i] * (w * y[0]);
                    phases[i] *= turns[i];
                }
                next(&mut y, &mut before);
            }
            for (p, sum) in power.iter_mut().zip(sums) {
                *p += sum.norm_sqr() * step / (1.5 * f64::from(segment)) / f64::from(segments);
            }
        }
        power
    };
    let all: Vec<[f64; 2]> = (0..REPLICATES).map(replicate).collect();
    Ok([0, 1].map(|i| all.iter().map(|p| p[i]).collect()))
}

/// From the motion's noises to (W₁, W₂, W₃) on heading 45°.
fn horizontal(moved: &Motion, lever: f64) -> Result<StateSpace> {
    let system = moved.system();
    let half = 0.5f64.sqrt();
    let mut c = Mat::zeros(3, system.order());
    for (axis, arm, first, second) in [
        (Axis::Roll, lever, -half, half),
        (Axis::Sway, 1.0, -half, half),
        (Axis::Pitch, lever, half, half),
        (Axis::Surge, 1.0, half, half),
    ] {
        let a = moved.derivative(axis, 2)?;
        for j in 0..system.order() {
            c[(0, j)] += arm * first * a.state[j];
            c[(1, j)] += arm * second * a.state[j];
        }
    }
    StateSpace::new(system.a.clone(), system.b.clone(), c, Mat::zeros(3, system.inputs()))
}

fn regular(told: &mut Told, name: &str, compass: &Instrument) -> Result<()> {
    let roll = Regular { amplitude: 0.15, frequency: 0.8 };
    let error = compass.regular_error(&roll, FRAC_PI_4)?;
    let drive = Drive::regular(&roll)?;
    let plan = MonteCarlo { step: drive.step()?, duration: 5.0 * 3600.0, settle: 6000.0, runs: 4, seed: 5 };
    let run = plan.run(compass, &drive, FRAC_PI_4)?;
    // steps of 0.03/p cost (ωh)²/3
    let margin = run.mean_margin + error.rectified_margin + 5e-4 * run.mean.abs();
    told.row([name, "regular roll", "mean"], error.mean(), run.mean, margin);
    Ok(())
}

/// A compass with a ballistic: manoeuvres in steps of an hour's thousandth.
fn pendulous(told: &mut Told) -> Result<()> {
    let c = PendulousCompass::tuned(15.0, 0.03, 60.0, 55f64.to_radians());
    let (b, north) = (c.ballistic / c.momentum, c.earth_rate * c.latitude.cos());
    for time in [300.0, 3600.0] {
        let m = Manoeuvres { deviation: 7.0, time };
        let step: f64 = 4.0;
        let (keeps, kick) = ((-step / time).exp(), 7.0 * (1.0 - (-2.0 * step / time).exp()).sqrt());
        let throw = 1.0 / (c.gravity * c.flow);
        // the liquid less v/(g τ), so that no noise enters it
        let rates = |y: [f64; 3], v: f64| {
            let level = y[2] + throw * v;
            [b * level, v / EARTH_RADIUS - north * y[0] - b * c.offset * level, (y[1] - level) / c.flow]
        };
        let replicate = |seed: usize| {
            let mut rng = ChaCha8Rng::seed_from_u64(seed as u64);
            let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
            let (mut v, mut y, mut sum, mut count) = (7.0 * normal(), [0.0; 3], 0.0, 0.0);
            for k in 0..400_000 {
                let next = keeps * v + kick * normal();
                let first = rates(y, v);
                let second = rates([0, 1, 2].map(|i| y[i] + step * first[i]), next);
                y = [0, 1, 2].map(|i| y[i] + 0.5 * step * (first[i] + second[i]));
                v = next;
                if k > 20_000 {
                    sum += (y[0] - v / (EARTH_RADIUS * north)).powi(2);
                    count += 1.0;
                }
            }
            sum / count
        };
        let all: Vec<f64> = (0..REPLICATES).map(replicate).collect();
        let name = format!("manoeuvres of {time} s");
        told.pooled(["liquid ballistic", &name, "spread"], c.manoeuvre_deviation(&m)?, &all, true);
    }
    Ok(())
}

/// A loop that seeks north, by the random walk of its gyros.
fn seeking(told: &mut Told) -> Result<()> {
    let (w, zeta, north, walk) = (0.02, 0.7, 4e-5, 1e-6);
    let formula = NorthSeeking { frequency: w, damping: zeta, north_rate: north }.by_walk(walk)?;
    let (k1, k2, step): (f64, f64, f64) = (2.0 * zeta * w, w * w / north, 0.25);
    let replicate = |seed: usize| {
        let mut rng = ChaCha8Rng::seed_from_u64(seed as u64);
        let (mut a, mut b, mut sum) = (0.0f64, 0.0f64, 0.0);
        let count = 1_000_000;
        for _ in 0..count {
            let noise: [f64; 2] = [0, 1].map(|_| {
                let x: f64 = StandardNormal.sample(&mut rng);
                walk / step.sqrt() * x
            });
            let rates = |a: f64, b: f64| [k2 * b + noise[1], -north * a - k1 * b + noise[0]];
            let first = rates(a, b);
            let second = rates(a + step * first[0], b + step * first[1]);
            a += 0.5 * step * (first[0] + second[0]);
            b += 0.5 * step * (first[1] + second[1]);
            sum += a * a / f64::from(count);
        }
        sum
    };
    let all: Vec<f64> = (0..REPLICATES).map(replicate).collect();
    told.pooled(["strapdown, seeking north", "random walk", "spread"], formula, &all, true);
    Ok(())
}

/// The rotating gimbal under torque noise: what its demodulator reads of a base at rest.
fn gimbal(told: &mut Told) -> Result<()> {
    let (gimbal, torque, corner) = (Gimbal::example(), [1e-18, 2e-18], 2.0);
    let formula = gimbal.noise_equivalent(&Noise { torque, base: None }, corner)?.torque;
    let step = 0.02 / gimbal.speed.max(gimbal.free_frequencies().map_or(0.0, |f| f[1]));
    let replicate = |seed: usize| -> Result<f64> {
        let run = Run { step, duration: 60.0, noise: torque, seed: seed as u64 };
        let samples = gimbal.simulate(State::default(), &run, |_| ([0.0; 2], [0.0; 2]))?;
        let read = Demodulator::new(&gimbal, corner)?.rates(&samples);
        let late = &read[read.len() / 10..];
        Ok(late.iter().map(|r| 0.5 * (r.0 * r.0 + r.1 * r.1)).sum::<f64>() / late.len() as f64)
    };
    let all = (0..REPLICATES).map(replicate).collect::<Result<Vec<f64>>>()?;
    told.pooled(["rotating gimbal", "torque noise", "noise-equivalent rate"], formula, &all, true);
    Ok(())
}
