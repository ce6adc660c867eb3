//! # Purpose
//! One step of the solver between two times with straight inputs and held switches.
//!
//! # Method
//! Explicit: the classical Runge-Kutta method of order 4. Heun: the Runge-Kutta method of order 2
//! that evaluates the rates at the ends of the step alone. Stiff: RODAS, a Rosenbrock method of
//! order 4 with six stages, L-stable and stiffly accurate, with the exact Jacobian.
//!
//! # References
//! E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
//! Springer 1993, section II.1.
//! E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer 1996,
//! section IV.7 and the coefficients of its code RODAS, in the form of A. Sandu et al.,
//! Atmos. Environ. 31 (1997) 3459-3472.
//!
//! # Numerical aspects
//! All run in dual numbers throughout, the Jacobian's entries included, so tangents are the exact
//! derivatives of the computed values. A stiff step damps what grows within it: det(1/(hγ)·1 − J) < 0 says that J has a real
//! eigenvalue above 4/h, and after nine such steps in a row, by e^36, rounding has grown to the size of the state, so that
//! a run that stays small is none of the model's, unless it is at rest to the last digit. (Two such eigenvalues at once are
//! not seen.)

use super::linear::Factors;
use super::machine::Machine;
use crate::model::Scalar;

/// Which solver a run uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Solver {
    /// Classical Runge-Kutta, order 4.
    Explicit,
    /// Heun's method, order 2, for recordings that sample far faster than the model moves.
    Heun,
    /// RODAS, order 4, for models with a fast lag beside slow motion.
    Stiff,
}

impl Solver {
    /// Time that a step takes with n states, in explicit ones of the same model, roughly.
    pub(super) fn work(self, n: usize) -> usize {
        if self == Self::Stiff { 3 + n } else { 1 }
    }
}

/// Room for the stages of a step.
pub(super) struct Stepper<T> {
    method: Solver,
    stage: Vec<T>,
    k: Vec<Vec<T>>,
    jacobian: Vec<T>,
    matrix: Vec<T>,
    explicit_time: Vec<T>,
    right: Vec<T>,
    factors: Factors<T>,
    /// Stiff steps in a row in which something grows by more than e⁴.
    pub(super) growing: usize,
}

/// Such steps after which the run has blown up: e^(4·9) = 4e15.
const GROWN: usize = 9;

impl<T: Scalar> Stepper<T> {
    pub fn new(method: Solver, n: usize) -> Self {
        let zeros = |n: usize| vec![T::constant(0.0); n];
        let (stages, square) = match method {
            Solver::Explicit => (3, 0),
            Solver::Heun => (1, 0),
            Solver::Stiff => (6, n * n),
        };
        Self {
            method,
            stage: zeros(n),
            k: vec![zeros(n); stages],
            jacobian: zeros(square),
            matrix: zeros(square),
            explicit_time: zeros(n),
            right: zeros(n),
            factors: Factors::new(if square == 0 { 0 } else { n }),
            growing: 0,
        }
    }

    /// Steps from x with rates k1 at one time to another; gives the new state and its rates, which are loaded. A whole
    /// piece of an interval has a number.
    pub fn step(
        &mut self,
        m: &mut Machine<'_, T>,
        (t, to, piece): (f64, f64, Option<usize>),
        (x, k1): (&[T], &[T]),
        (out, rates): (&mut [T], &mut [T]),
    ) {
        if let Some(native) = m.native.filter(|_| m.is_smooth()) {
            match (self.method, self.k.as_mut_slice()) {
                (Solver::Explicit, [sum, _, last]) => {
                    let h = to - t;
                    m.load_stage(t + 0.5 * h, piece, 0);
                    native.first_half(&m.r, x, k1, h, &mut self.stage, sum);
                    m.load_stage(to, piece, 1);
                    native.second_half(&mut m.r, (x, &self.stage, sum), h, (out, rates, last));
                    return;
                }
                (Solver::Heun, [last]) => {
                    m.load_stage(to, piece, 0);
                    native.heun(&mut m.r, (x, k1), to - t, (out, rates, last));
                    return;
                }
                _ => {}
            }
        }
        match self.method {
            Solver::Explicit => self.explicit(m, (t, to, piece), (x, k1), out),
            Solver::Heun => self.heun(m, (t, to, piece), (x, k1), out),
            Solver::Stiff => self.stiff(m, (t, to - t), (x, k1), out),
        }
        m.rates(to, out, rates);
    }

    /// Adds the embedded errors of the last step, of h s and with the rates k at its end, to sums
    /// state by state.
    pub fn add_embedded_errors(&self, h: f64, k: &[T], sums: &mut [f64]) {
        let last = self.k[self.k.len() - 1].iter().map(|k| k.value());
        let weight = match self.method {
            // h·(k₄ − k₅)/6
            Solver::Explicit => h / 6.0,
            // h·(k₂ − k₃)/2
            Solver::Heun => h / 2.0,
            Solver::Stiff => {
                sums.iter_mut().zip(last).for_each(|(sum, u)| *sum += u.abs());
                return;
            }
        };
        for ((sum, last), k) in sums.iter_mut().zip(last).zip(k) {
            *sum += weight * (last - k.value()).abs();
        }
    }

    fn heun(
        &mut self,
        m: &mut Machine<'_, T>,
        (t, to, piece): (f64, f64, Option<usize>),
        (x, k1): (&[T], &[T]),
        out: &mut [T],
    ) {
        let h = to - t;
        let k2 = &mut self.k[0];
        for i in 0..x.len() {
            out[i] = x[i] + k1[i].scale(h);
        }
        m.load_stage(to, piece, 0);
        m.rates(to, out, k2);
        for i in 0..x.len() {
            // x + h·(k₁ + k₂)/2
            out[i] = x[i] + (k1[i] + k2[i]).scale(0.5 * h);
        }
    }

    fn explicit(
        &mut self,
        m: &mut Machine<'_, T>,
        (t, to, piece): (f64, f64, Option<usize>),
        (x, k1): (&[T], &[T]),
        out: &mut [T],
    ) {
        let (h, middle) = (to - t, t + 0.5 * (to - t));
        let n = x.len();
        let [k2, k3, k4] = self.k.as_mut_slice() else { return };
        let stage = &mut self.stage;
        for i in 0..n {
            stage[i] = x[i] + k1[i].scale(0.5 * h);
        }
        m.load_stage(middle, piece, 0);
        m.rates(middle, stage, k2);
        for i in 0..n {
            stage[i] = x[i] + k2[i].scale(0.5 * h);
        }
        m.rates(middle, stage, k3);
        for i in 0..n {
            stage[i] = x[i] + k3[i].scale(h);
        }
        m.load_stage(to, piece, 1);
        m.rates(to, stage, k4);
        for i in 0..n {
            // x + h·(k₁ + 2k₂ + 2k₃ + k₄)/6
            out[i] = x[i] + (k1[i] + (k2[i] + k3[i]).scale(2.0) + k4[i]).scale(h / 6.0);
        }
    }

    fn stiff(&mut self, m: &mut Machine<'_, T>, (t, h): (f64, f64), (x, k1): (&[T], &[T]), out: &mut [T]) {
        let n = x.len();
        m.load(t, x);
        m.slopes(&mut self.jacobian, &mut self.explicit_time);
        // (1/(hγ)·1 − J)·uᵢ = f(t + αᵢh, x + Σ aᵢⱼuⱼ) + Σ cᵢⱼuⱼ/h + γᵢ·h·∂f/∂t
        for (i, (a, j)) in self.matrix.iter_mut().zip(&self.jacobian).enumerate() {
            let diagonal = if i % (n + 1) == 0 { 1.0 / (h * GAMMA) } else { 0.0 };
            *a = T::constant(diagonal) - *j;
        }
        self.factors.factor(&self.matrix);
        self.growing = if self.factors.is_negative() { self.growing + 1 } else { 0 };
        for s in 0..6 {
            self.stage.copy_from_slice(x);
            self.add_stages(s, &A);
            if s == 0 {
                self.right.copy_from_slice(k1);
            } else {
                m.rates(t + ALPHA[s] * h, &self.stage, &mut self.right);
            }
            for i in 0..n {
                let earlier =
                    (0..s).fold(T::constant(0.0), |sum, j| sum + self.k[j][i].scale(C[row(s) + j] / h));
                self.right[i] = self.right[i] + earlier + self.explicit_time[i].scale(GAMMAS[s] * h);
            }
            self.factors.solve(&self.right, &mut self.k[s]);
        }
        // The last stage stands on x + Σ a₆ⱼuⱼ, to which u₆ adds: stiffly accurate.
        for (out, (stage, k)) in out.iter_mut().zip(self.stage.iter().zip(&self.k[5])) {
            *out = *stage + *k;
        }
        if self.growing >= GROWN {
            out.fill(T::constant(f64::NAN));
        }
    }

    fn add_stages(&mut self, s: usize, weights: &[f64; 15]) {
        for j in 0..s {
            for (value, k) in self.stage.iter_mut().zip(&self.k[j]) {
                *value += k.scale(weights[row(s) + j]);
            }
        }
    }
}

/// Where the weights of stage s begin in a packed lower triangle.
const fn row(s: usize) -> usize {
    s * s.saturating_sub(1) / 2
}

const GAMMA: f64 = 0.25;
const ALPHA: [f64; 6] = [0.0, 0.386, 0.21, 0.63, 1.0, 1.0];
const GAMMAS: [f64; 6] = [0.25, -0.1043, 0.1035, -0.03620000000000023, 0.0, 0.0];
const A: [f64; 15] = [
    1.544,
    0.9466785280815826,
    0.2557011698983284,
    3.314825187068521,
    2.896124015972201,
    0.9986419139977817,
    1.221224509226641,
    6.019134481288629,
    12.53708332932087,
    -0.687886036105895,
    1.221224509226641,
    6.019134481288629,
    12.53708332932087,
    -0.687886036105895,
    1.0,
];
const C: [f64; 15] = [
    -5.6688,
    -2.430093356833875,
    -0.2063599157091915,
    -0.1073529058151375,
    -9.594562251023355,
    -20.47028614809616,
    7.496443313967647,
    -10.24680431464352,
    -33.99990352819905,
    11.7089089320616,
    8.083246795921522,
    -7.981132988064893,
    -31.52159432874371,
    16.31930543123136,
    -6.058818238834054,
];
