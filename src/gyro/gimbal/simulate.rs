//! The gimbal's equations in time.

use super::Gimbal;
use crate::{Error, ErrorKind, Result};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// The angles and their rates, rad and rad/s.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct State {
    /// α, rad.
    pub alpha: f64,
    /// β, rad.
    pub beta: f64,
    /// α′, rad/s.
    pub alpha_rate: f64,
    /// β′, rad/s.
    pub beta_rate: f64,
}

/// The angles at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// s.
    pub time: f64,
    /// rad.
    pub alpha: f64,
    /// rad.
    pub beta: f64,
}

/// How to run.
#[derive(Debug, Clone, Copy)]
pub struct Run {
    /// Step, s.
    pub step: f64,
    /// Duration, s.
    pub duration: f64,
    /// Intensities of white torque noise about α and β, (N·m)²·s.
    pub noise: [f64; 2],
    /// Seed of the noise.
    pub seed: u64,
}

/// Most steps of a run, whose samples then take 2.4 GB.
const MOST: f64 = 1e8;

impl Run {
    /// The number of its steps.
    pub fn steps(&self) -> f64 {
        (self.duration / self.step).round()
    }
}

impl Gimbal {
    /// Simulates (1) from `start` while the base turns with rates (Θ′, Ψ′) rad/s and
    /// accelerations (Θ″, Ψ″) rad/s² given at each time: classical Runge–Kutta, with the noise
    /// torque constant over each step.
    ///
    /// # Errors
    /// `BadInput` for a step that does not resolve the fastest motion (a twentieth of its period); `OutOfRange` for
    /// more than 10⁸ steps.
    pub fn simulate(
        &self,
        start: State,
        run: &Run,
        base: impl Fn(f64) -> ([f64; 2], [f64; 2]),
    ) -> Result<Vec<Sample>> {
        self.check()?;
        let fastest = self.free_frequencies().map_or(self.speed, |f| f[1].max(self.speed));
        if !(run.step > 0.0 && run.duration > run.step) || run.step * fastest > 0.32 {
            return Err(Error::bad_input(format!(
                "a step of {} s does not resolve the gimbal's fastest motion, {fastest:.1} rad/s",
                run.step
            )));
        }
        if run.steps() > MOST {
            let text = format!("a run of {} s in steps of {} s is too long", run.duration, run.step);
            return Err(Error::new(ErrorKind::OutOfRange, text));
        }
        let mut rng = ChaCha8Rng::seed_from_u64(run.seed);
        let mut s = start;
        let count = run.steps() as usize;
        let mut out = Vec::with_capacity(count + 1);
        out.push(Sample { time: 0.0, alpha: s.alpha, beta: s.beta });
        for k in 0..count {
            let time = k as f64 * run.step;
            let torque = run.noise.map(|q| {
                let xi: f64 = if q > 0.0 { StandardNormal.sample(&mut rng) } else { 0.0 };
                xi * (q / run.step).sqrt()
            });
            s = Self::stepped(s, time, run.step, &|t, s| self.rates(s, t, base(t), torque));
            out.push(Sample { time: time + run.step, alpha: s.alpha, beta: s.beta });
        }
        Ok(out)
    }

    /// One free step without base motion, for the test of energy and frequencies.
    pub fn free_step(&self, s: State, step: f64) -> State {
        Self::stepped(s, 0.0, step, &|t, s| self.rates(s, t, ([0.0; 2], [0.0; 2]), [0.0; 2]))
    }

    fn stepped(s: State, t: f64, h: f64, f: &dyn Fn(f64, State) -> State) -> State {
        let add = |a: State, b: State, k: f64| State {
            alpha: a.alpha + k * b.alpha,
            beta: a.beta + k * b.beta,
            alpha_rate: a.alpha_rate + k * b.alpha_rate,
            beta_rate: a.beta_rate + k * b.beta_rate,
        };
        let k1 = f(t, s);
        let k2 = f(t + 0.5 * h, add(s, k1, 0.5 * h));
        let k3 = f(t + 0.5 * h, add(s, k2, 0.5 * h));
        let k4 = f(t + h, add(s, k3, h));
        add(add(add(add(s, k1, h / 6.0), k2, h / 3.0), k3, h / 3.0), k4, h / 6.0)
    }

    /// The derivatives of the state.
    fn rates(&self, s: State, t: f64, (rate, acceleration): ([f64; 2], [f64; 2]), torque: [f64; 2]) -> State {
        let c = self.coefficients();
        let (sin, cos) = (self.speed * t).sin_cos();
        let ([theta, psi], [theta2, psi2]) = (rate, acceleration);
        // −A(Θ″ sin Ωt + Ψ″ cos Ωt) − E₁(Θ′ cos Ωt − Ψ′ sin Ωt)
        let drive_alpha =
            -c.inertia[0] * (theta2 * sin + psi2 * cos) - c.drive[0] * (theta * cos - psi * sin);
        // −B(Θ″ cos Ωt − Ψ″ sin Ωt) + E₂(Θ′ sin Ωt + Ψ′ cos Ωt)
        let drive_beta = -c.inertia[1] * (theta2 * cos - psi2 * sin) + c.drive[1] * (theta * sin + psi * cos);
        let alpha2 = drive_alpha + torque[0]
            - self.damping[0] * s.alpha_rate
            - c.stiffness[0] * s.alpha
            - c.gyroscopic * s.beta_rate;
        let beta2 = drive_beta + torque[1] - self.damping[1] * s.beta_rate - c.stiffness[1] * s.beta
            + c.gyroscopic * s.alpha_rate;
        State {
            alpha: s.alpha_rate,
            beta: s.beta_rate,
            alpha_rate: alpha2 / c.inertia[0],
            beta_rate: beta2 / c.inertia[1],
        }
    }
}
