//! # Purpose
//! The ship's motion in time, with what of the gyrosphere answers it linearly.
//!
//! # Method
//! The shaping filter of the motion steps exactly, joined with a linear elastic part. It starts from a
//! draw of its stationary state; a regular roll from a phase drawn at random. Speeds along the
//! parallel, the meridian and the vertical, not accelerations, are handed on: their steps are the
//! accelerations' integrals, white noise or not.
//!
//! # References
//! W₁ = −hθ̈ cos K, W₂ = +hθ̈ sin K: the rolling-error paper, under (2.1).

use super::instrument::Instrument;
use super::seed::Regular;
use super::{Axis, LinearSignal, Motion};
use crate::lti::poles;
use crate::lti::{Discrete, Gaussian, StateSpace, stationary_covariance};
use crate::{Error, ErrorKind, Result};
use faer::Mat;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// What moves the ship in a simulation.
#[derive(Debug, Clone)]
pub struct Drive {
    motion: Motion,
    /// A regular roll: its amplitude and phase, not the noise, make it.
    regular: Option<Regular>,
}

impl Drive {
    /// A random motion, from its stationary state on.
    pub fn irregular(motion: &Motion) -> Self {
        Self { motion: motion.clone(), regular: None }
    }

    /// Regular roll, from a phase drawn at random on.
    ///
    /// # Errors
    /// `BadInput` for numbers that are no roll.
    pub fn regular(roll: &Regular) -> Result<Self> {
        let p = roll.frequency;
        if !(p.is_finite() && p > 0.0 && roll.amplitude.is_finite()) {
            return Err(Error::bad_input("a regular roll needs an amplitude and a positive frequency"));
        }
        // θ̈ = −p² θ, no noise
        let a = faer::mat![[0.0, 1.0], [-p * p, 0.0]];
        let system = StateSpace::new(a, Mat::zeros(2, 1), faer::mat![[1.0, 0.0]], Mat::zeros(1, 1))?;
        Ok(Self { motion: Motion::new(system, &[Axis::Roll])?, regular: Some(*roll) })
    }

    /// A step, s, that follows the motion: 0.03 of the time scale of its fastest axis, and 0.02 where the
    /// acceleration has a white tail.
    ///
    /// # Errors
    /// As the covariance of the motion.
    pub fn step(&self) -> Result<f64> {
        if let Some(roll) = self.regular {
            return Ok(0.03 / roll.frequency);
        }
        let system = self.motion.system();
        let x = stationary_covariance(&system.a, &(&system.b * system.b.transpose()))?.matrix;
        let power = |s: &LinearSignal| -> f64 {
            let n = s.state.len();
            (0..n).map(|i| (0..n).map(|j| s.state[i] * x[(i, j)] * s.state[j]).sum::<f64>()).sum()
        };
        let (mut fastest, mut part) = (0.0f64, 0.03);
        for axis in self.motion.axes() {
            let of = |order| self.motion.derivative(*axis, order);
            let white = of(2)?.is_white();
            let top = if white { 1 } else { 2 };
            part = if white { 0.02 } else { part };
            let square = power(&of(top)?) / power(&of(top - 1)?);
            fastest = fastest.max(if square.is_finite() { square } else { 0.0 });
        }
        if fastest > 0.0 { Ok(part / fastest.sqrt()) } else { Err(Error::bad_input("nothing moves")) }
    }
}

impl Drive {
    /// The time in which the slowest memory of a random motion falls to 1/e, s.
    ///
    /// # Errors
    /// `NotComputed` where the eigenvalues of its filter are not found.
    pub(super) fn memory(&self) -> Result<f64> {
        let poles = poles(&self.motion.system().a, "motion")?;
        Ok(-1.0 / poles.iter().map(|p| p.re).fold(f64::NEG_INFINITY, f64::max))
    }
}

/// The motion and the shift at one moment.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sample {
    /// Speeds whose rates are W₁, W₂, W₃, m/s.
    pub speed: [f64; 3],
    /// W₁, W₂ without their white part, m/s².
    pub acceleration: [f64; 2],
    /// ψ, rad.
    pub yaw: f64,
    /// x, y, z of a linear part, m; y and z alone beside a part that is not linear.
    pub shift: [f64; 3],
}

/// The motion on one heading, ready to step.
#[derive(Debug, Clone)]
pub(super) struct Path {
    fast: Discrete,
    start: Option<Gaussian>,
    regular: Option<Regular>,
    speed: [Vec<f64>; 3],
    acceleration: [Vec<f64>; 2],
    yaw: Vec<f64>,
    shift: [Vec<f64>; 3],
    z: Vec<f64>,
}

impl Path {
    /// The path of a drive on heading K (rad) in steps of `step` seconds.
    ///
    /// # Errors
    /// `OutOfRange` for a motion whose speed is no process, or whose acceleration is none where the part
    /// is not linear; else as the covariance.
    pub fn new(instrument: &Instrument, drive: &Drive, heading: f64, step: f64) -> Result<Self> {
        let motion = &drive.motion;
        let lever = instrument.sphere.lever;
        let (speed, w) = (along(motion, lever, heading, 1)?, along(motion, lever, heading, 2)?);
        let linear = instrument.elastic.in_time(&instrument.sphere, step)?.is_none();
        let white = |s: &[LinearSignal; 3]| s.iter().any(LinearSignal::is_white);
        if white(&speed) || (!linear && white(&w)) {
            return Err(without_band());
        }
        let mut joint = accelerated(motion, &w)?;
        if linear {
            joint = joint.then(&instrument.elastic.system(&instrument.sphere, &joint)?)?;
        } else if let Some(across) = instrument.elastic.across(&instrument.sphere)? {
            joint = joint.then(&across)?;
        } else {
            joint.c = Mat::zeros(3, joint.order());
        }
        let start = drive.regular.is_none().then(|| stationary(&joint)).transpose()?;
        let n = joint.order();
        let wide = |s: LinearSignal| {
            let mut row = s.state;
            row.resize(n, 0.0);
            row
        };
        let [w1, w2, _] = w;
        Ok(Self {
            fast: Discrete::new(&joint.a, &joint.b, step),
            start,
            regular: drive.regular,
            speed: speed.map(wide),
            acceleration: [w1, w2].map(wide),
            yaw: wide(motion.derivative(Axis::Yaw, 0)?),
            shift: [0, 1, 2].map(|i| (0..n).map(|j| joint.c[(i, j)]).collect()),
            z: vec![0.0; n],
        })
    }

    /// Puts the motion at a start drawn at random.
    pub fn begin(&mut self, rng: &mut ChaCha8Rng) -> Sample {
        self.z.fill(0.0);
        if let Some(start) = &self.start {
            start.add(&mut self.z, rng);
        } else if let Some(roll) = self.regular {
            let (sin, cos) = rng.random_range(0.0..TAU).sin_cos();
            (self.z[0], self.z[1]) = (roll.amplitude * sin, roll.amplitude * roll.frequency * cos);
        }
        self.sample()
    }

    /// One step on.
    pub fn next(&mut self, rng: &mut ChaCha8Rng) -> Sample {
        self.fast.advance(&mut self.z, rng);
        self.sample()
    }

    fn sample(&self) -> Sample {
        let of = |row: &Vec<f64>| row.iter().zip(&self.z).map(|(c, z)| c * z).sum::<f64>();
        Sample {
            speed: [0, 1, 2].map(|i| of(&self.speed[i])),
            acceleration: [0, 1].map(|i| of(&self.acceleration[i])),
            yaw: of(&self.yaw),
            shift: [0, 1, 2].map(|i| of(&self.shift[i])),
        }
    }
}

/// The stationary state of a system driven by white noise.
fn stationary(system: &StateSpace) -> Result<Gaussian> {
    let x = stationary_covariance(&system.a, &(&system.b * system.b.transpose()))?;
    Ok(Gaussian::new(&x.matrix, (10.0 * x.relative_error).max(1e-13)))
}

fn without_band() -> Error {
    Error::new(ErrorKind::OutOfRange, "this motion's acceleration has a white tail, of infinite variance")
        .with_hint("a part that is not linear needs a motion of finite acceleration: limit its band")
}

/// The `order`-th derivatives of the compass's place along the parallel, the meridian and the vertical.
fn along(motion: &Motion, lever: f64, heading: f64, order: usize) -> Result<[LinearSignal; 3]> {
    let (sin, cos) = heading.sin_cos();
    let of = |axis| motion.derivative(axis, order);
    let (roll, pitch) = (of(Axis::Roll)?, of(Axis::Pitch)?);
    let (sway, surge) = (of(Axis::Sway)?, of(Axis::Surge)?);
    // abeam: hθ + sway;  forward: h·pitch + surge
    let sum = |abeam: f64, forward: f64| -> LinearSignal {
        let each = |f: fn(&LinearSignal) -> &Vec<f64>| -> Vec<f64> {
            (0..f(&roll).len())
                .map(|i| {
                    abeam * (lever * f(&roll)[i] + f(&sway)[i])
                        + forward * (lever * f(&pitch)[i] + f(&surge)[i])
                })
                .collect()
        };
        LinearSignal { state: each(|s| &s.state), noise: each(|s| &s.noise) }
    };
    Ok([sum(-cos, sin), sum(sin, cos), of(Axis::Heave)?])
}

/// The motion with (W₁, W₂, W₃) as its outputs.
fn accelerated(motion: &Motion, w: &[LinearSignal; 3]) -> Result<StateSpace> {
    let base = motion.system();
    StateSpace::new(
        base.a.clone(),
        base.b.clone(),
        Mat::from_fn(3, base.order(), |i, j| w[i].state[j]),
        Mat::from_fn(3, base.inputs(), |i, j| w[i].noise[j]),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gyro::{Gyrosphere, elastic};
    use crate::spectrum::Roll;
    use rand::SeedableRng;

    /// Roll speed of the compass's place along the meridian, (1/h sin K)² of its mean square, and x².
    fn squares(steps: usize, decay: f64) -> (f64, f64, f64) {
        let roll = Roll::new(0.02, decay, 0.8).unwrap();
        let compass = Instrument::new(Gyrosphere::seed(), Box::new(elastic::Lag));
        let drive = Drive::irregular(&Motion::roll(&roll).band_limited(2.5, 2).unwrap());
        let heading = 45f64.to_radians();
        let path = Path::new(&compass, &drive, heading, 1.0).unwrap();
        let runs = 4000u64;
        let all: Vec<f64> = (0..runs)
            .map(|run| {
                let mut path = path.clone();
                let mut rng = ChaCha8Rng::seed_from_u64(17);
                rng.set_stream(run);
                let mut last = path.begin(&mut rng);
                (0..steps).for_each(|_| last = path.next(&mut rng));
                (last.speed[1] / (compass.sphere.lever * heading.sin())).powi(2)
            })
            .collect();
        let mean = all.iter().sum::<f64>() / runs as f64;
        // ⟨θ̇²⟩ = (1/π)∫ ω² S(ω)/(1 + ω²/ω_c²)² dω behind the two low-passes
        let d = 2e-4;
        let area = |w: f64| w * w * roll.density(w) / (1.0 + (w / 2.5).powi(2)).powi(2);
        let wanted = (1..200_000).map(|k| area(d * f64::from(k))).sum::<f64>() * d / std::f64::consts::PI;
        // the square of a Gaussian has the deviation √2 of its mean
        (mean, wanted, 3.3 * wanted * (2.0 / runs as f64).sqrt())
    }

    #[test]
    fn a_path_starts_as_it_goes_on() {
        // μ so small that a start at rest would take hours to swing up
        for steps in [0, 1, 30] {
            let (mean, wanted, margin) = squares(steps, 1e-2);
            assert!((mean - wanted).abs() < margin, "{steps}: {mean} {wanted} ± {margin}");
        }
    }
}
