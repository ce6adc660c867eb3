//! An instrument on a moving ship: linear filters from the motion to signals, and products of
//! signals that push the slow compass.
//!
//! α′ = −U sin φ + (lP/H) β + (C/H) λ + (lP/(Hg)) W₂,
//! β′ = v_N/R − U α cos φ + M_y/H,  M_y = (P/g)(W₂ x − W₁ y),
//! λ′ = −Fβ − Fλ − (F/g) W₂,  (2.1) with its signs put right.
//!
//! To second order in the motion come three more products: heave makes the pendulum heavier,
//! (lP/(gH)) W₃ β and (C/(gH)) W₃ λ; a vertical shift z makes it longer, (P/H) z (β + W₂/g);
//! and yaw turns the horizontal accelerations, ψ dW₂/dK in place of a constant heading.

use super::elastic::Elastic;
use super::rectified::{LinearPush, Moments, ProductPush, SlowFast};
use super::{Axis, Gyrosphere, LinearSignal, Motion, range};
use crate::lti::StateSpace;
use crate::{Error, Result};
use faer::Mat;

/// The Earth's mean radius, m.
pub const EARTH_RADIUS: f64 = 6.371e6;

const ALPHA: usize = 0;
const BETA: usize = 1;
const LAMBDA: usize = 2;

/// A gyrosphere with its elastic part on a ship under way.
///
/// ```
/// use gyrospec::gyro::{Gyrosphere, Instrument, Motion, elastic, seed};
/// let (sphere, roll, heading) = seed::example_3_1();
/// let compass = Instrument::new(sphere, Box::new(elastic::Lag));
/// let error = compass.error(&Motion::roll(&roll), heading).unwrap();
/// assert!((error.rectified.to_degrees() + 4.497).abs() < 5e-4);
/// assert!(error.deviation > 0.0);
/// ```
#[derive(Debug)]
pub struct Instrument {
    /// The compass.
    pub sphere: Gyrosphere,
    /// The elastic part.
    pub elastic: Box<dyn Elastic>,
    /// Speed of the ship over the ground along its heading, m/s.
    pub speed: f64,
}

/// The error of the heading, rad; [`super::SIGN`] says which way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadingError {
    /// By course and speed alone: v_N/(R U cos φ + v_E).
    pub sailing: f64,
    /// What the damping of the compass adds at rest: zero for a damper like (2.1)'s.
    pub rest: f64,
    /// The mean error by the motion.
    pub rectified: f64,
    /// Standard deviation about the mean.
    pub deviation: f64,
    /// Its part by the motion's own swing, linear in the motion.
    pub deviation_linear: f64,
    /// Its part by the products, quadratic in the motion.
    pub deviation_quadratic: f64,
    /// Half the 99 % interval of `rectified`, with its numerical error, where the part is not linear and
    /// the figure comes from a simulation; else zero.
    pub rectified_margin: f64,
    /// The same of `deviation`.
    pub deviation_margin: f64,
    /// What `rectified` would be by the linear stand-in of a part that is not linear, on a random motion.
    pub linearised: Option<f64>,
}

impl HeadingError {
    /// The whole mean error, rad.
    pub fn mean(&self) -> f64 {
        self.sailing + self.rest + self.rectified
    }
}

/// The signals that the motion drives, over the joint states of motion and elastic part.
pub(super) struct Signals {
    pub(super) fast: Mat<f64>,
    pub(super) noise: Mat<f64>,
    w: [LinearSignal; 3],
    /// dW/dK of the horizontal accelerations.
    turned: LinearSignal,
    yaw: Option<LinearSignal>,
    pub(super) shift: [Option<LinearSignal>; 3],
}

impl Instrument {
    /// A compass at rest on a ship without way.
    pub fn new(sphere: Gyrosphere, elastic: Box<dyn Elastic>) -> Self {
        Self { sphere, elastic, speed: 0.0 }
    }

    /// Whether the elastic part is linear, so that its errors are exact.
    ///
    /// # Errors
    /// `BadInput` for numbers that describe no such part.
    pub fn is_linear(&self) -> Result<bool> {
        Ok(self.elastic.in_time(&self.sphere, 1.0)?.is_none())
    }

    /// Mean and spread of the heading's error on `motion`, heading K in rad: exact for a linear part, by
    /// simulation within its margins for any other.
    ///
    /// # Errors
    /// `BadInput` for impossible numbers; `OutOfRange` where a mean is infinite; else as the
    /// covariances say.
    pub fn error(&self, motion: &Motion, heading: f64) -> Result<HeadingError> {
        self.check(heading)?;
        if !self.is_linear()? {
            return self.error_by(&self.moment(motion, heading)?, motion, heading);
        }
        let system = self.system(motion, heading)?;
        let m = system.moments()?;
        Ok(self.told(&m, heading))
    }

    /// The mean error by the motion alone, rad; for a linear part much cheaper than
    /// [`Instrument::error`].
    ///
    /// # Errors
    /// As [`Instrument::error`].
    pub fn rectified_error(&self, motion: &Motion, heading: f64) -> Result<f64> {
        if !self.is_linear()? {
            return Ok(self.error(motion, heading)?.rectified);
        }
        Ok(self.system(motion, heading)?.rectified_mean()?[ALPHA])
    }

    /// Two-sided density of the heading's error, rad²·s, at each ω: its linear and its
    /// quadratic part.
    ///
    /// # Errors
    /// As [`Instrument::error`]; `OutOfRange` for a part that is not linear.
    pub fn error_spectrum(&self, motion: &Motion, heading: f64, omega: &[f64]) -> Result<Vec<(f64, f64)>> {
        if !self.is_linear()? {
            return Err(Error::new(
                crate::ErrorKind::OutOfRange,
                format!("no spectrum is known for {}, which is not linear", self.elastic.name()),
            ));
        }
        self.system(motion, heading)?.densities(ALPHA, omega)
    }

    pub(super) fn told(&self, m: &Moments, heading: f64) -> HeadingError {
        let sailing = self.sailing_error(heading);
        let (linear, quadratic) = (m.linear[(ALPHA, ALPHA)].max(0.0), m.quadratic[(ALPHA, ALPHA)].max(0.0));
        HeadingError {
            sailing,
            rest: m.steady[ALPHA] - sailing,
            rectified: m.rectified[ALPHA],
            deviation: (linear + quadratic).sqrt(),
            deviation_linear: linear.sqrt(),
            deviation_quadratic: quadratic.sqrt(),
            rectified_margin: 0.0,
            deviation_margin: 0.0,
            linearised: None,
        }
    }

    /// v_N/(R (U cos φ + v_E/R)), rad: the error of course and speed.
    pub fn sailing_error(&self, heading: f64) -> f64 {
        self.speed * heading.cos() / (EARTH_RADIUS * self.northing(heading))
    }

    /// U cos φ + v_E/R, rad/s.
    pub(super) fn northing(&self, heading: f64) -> f64 {
        let s = &self.sphere;
        s.earth_rate * s.latitude.cos() + self.speed * heading.sin() / EARTH_RADIUS
    }

    /// Checks the compass on a heading (rad).
    pub(super) fn check(&self, heading: f64) -> Result<()> {
        self.sphere.check()?;
        range::HEADING.check(heading)?;
        range::SPEED.check(self.speed)?;
        if self.northing(heading) <= 0.0 {
            return Err(Error::bad_input("heading and speed must leave the compass its meridian"));
        }
        Ok(())
    }

    /// The slow and the fast system on this motion and heading; a part that is not linear is in it by its
    /// linear stand-in.
    ///
    /// # Errors
    /// As [`Instrument::error`].
    pub fn system(&self, motion: &Motion, heading: f64) -> Result<SlowFast> {
        self.check(heading)?;
        let signals = self.signals(motion, heading)?;
        let mut system = self.compass(&signals, heading);
        self.push_by_shift(&mut system, &signals);
        self.push_by_yaw(&mut system, &signals);
        if motion.axes().contains(&Axis::Heave) || signals.shift[2].is_some() {
            self.push_by_heave(&mut system, &signals);
        }
        Ok(system)
    }

    /// The compass's own equations with the linear push by W₂.
    fn compass(&self, signals: &Signals, heading: f64) -> SlowFast {
        let s = &self.sphere;
        let (l, c) = (s.pendulous / s.momentum, s.damper / s.momentum);
        let mut slow = Mat::zeros(3, 3);
        // α′ = (lP/H) β + (C/H) λ;  β′ = −(U cos φ + v_E/R) α;  λ′ = −Fβ − Fλ
        slow[(ALPHA, BETA)] = l;
        slow[(ALPHA, LAMBDA)] = c;
        slow[(BETA, ALPHA)] = -self.northing(heading);
        slow[(LAMBDA, BETA)] = -s.flow;
        slow[(LAMBDA, LAMBDA)] = -s.flow;
        let (v, r) = (self.speed, EARTH_RADIUS);
        let vertical = s.earth_rate * s.latitude.sin() + v * heading.sin() * s.latitude.tan() / r;
        let constant = vec![-vertical, v * heading.cos() / r, 0.0];
        let linear = vec![
            LinearPush { row: ALPHA, gain: l / s.gravity, signal: signals.w[1].clone() },
            LinearPush { row: LAMBDA, gain: -s.flow / s.gravity, signal: signals.w[1].clone() },
        ];
        let (fast, noise) = (signals.fast.clone(), signals.noise.clone());
        SlowFast { fast, noise, slow, constant, linear, products: Vec::new() }
    }

    /// M_y/H = (P/(gH))(W₂ x − W₁ y).
    fn push_by_shift(&self, system: &mut SlowFast, signals: &Signals) {
        let s = &self.sphere;
        let gain = s.weight / (s.gravity * s.momentum);
        for (axis, other, sign) in [(0, 1, 1.0), (1, 0, -1.0)] {
            if let Some(shift) = &signals.shift[axis] {
                let (left, right) = (signals.w[other].clone(), shift.clone());
                system.products.push(ProductPush { row: BETA, gain: sign * gain, left, right });
            }
        }
    }

    /// W₂ on the heading K + ψ: ψ dW₂/dK more, in the rows of α and λ.
    fn push_by_yaw(&self, system: &mut SlowFast, signals: &Signals) {
        let s = &self.sphere;
        let Some(yaw) = &signals.yaw else { return };
        let by_pendulum = s.pendulous / (s.momentum * s.gravity);
        for (row, gain) in [(ALPHA, by_pendulum), (LAMBDA, -s.flow / s.gravity)] {
            let (left, right) = (signals.turned.clone(), yaw.clone());
            system.products.push(ProductPush { row, gain, left, right });
        }
    }

    /// (1/(gH)) W₃ (lP β + C λ) and (P/H) z (β + W₂/g), with β = β̄ + its swing: the compass's
    /// linear answer joins the fast states for that.
    fn push_by_heave(&self, system: &mut SlowFast, signals: &Signals) {
        let s = &self.sphere;
        let n = system.fast.nrows();
        let resting = rest(&system.slow, &system.constant);
        join_compass(system);
        let widened = |x: &LinearSignal| widen(x, 3);
        let swing = |row: usize| unit_signal(n + row, n + 3, system.noise.ncols());
        let heavier = [(BETA, s.pendulous), (LAMBDA, s.damper)];
        let w3 = widened(&signals.w[2]);
        let mut products = Vec::new();
        let mut linear = Vec::new();
        for (row, moment) in heavier {
            let gain = moment / (s.gravity * s.momentum);
            linear.push(LinearPush { row: ALPHA, gain: gain * resting[row], signal: w3.clone() });
            products.push(ProductPush { row: ALPHA, gain, left: w3.clone(), right: swing(row) });
        }
        if let Some(z) = &signals.shift[2] {
            let (z, gain) = (widened(z), s.weight / s.momentum);
            linear.push(LinearPush { row: ALPHA, gain: gain * resting[BETA], signal: z.clone() });
            products.push(ProductPush { row: ALPHA, gain, left: z.clone(), right: swing(BETA) });
            let left = widened(&signals.w[1]);
            products.push(ProductPush { row: ALPHA, gain: gain / s.gravity, left, right: z });
        }
        system.products.extend(products);
        system.linear.extend(linear);
    }

    pub(super) fn signals(&self, motion: &Motion, heading: f64) -> Result<Signals> {
        let (south, west) = (heading.sin(), heading.cos());
        let lever = self.sphere.lever;
        // W₁ = −hθ̈ cos K, W₂ = +hθ̈ sin K; forward motions: W₁ = +s̈ sin K, W₂ = +s̈ cos K
        let parts = [
            (Axis::Roll, lever, [-west, south]),
            (Axis::Sway, 1.0, [-west, south]),
            (Axis::Pitch, lever, [south, west]),
            (Axis::Surge, 1.0, [south, west]),
        ];
        let mut w = [zero(motion), zero(motion), motion.derivative(Axis::Heave, 2)?];
        let mut turned = zero(motion);
        for (axis, arm, [first, second]) in parts {
            let acceleration = motion.derivative(axis, 2)?;
            add(&mut w[0], arm * first, &acceleration);
            add(&mut w[1], arm * second, &acceleration);
            // dW₂/dK = −W₁ for both kinds
            add(&mut turned, -arm * first, &acceleration);
        }
        let yaw = motion.axes().contains(&Axis::Yaw).then(|| motion.derivative(Axis::Yaw, 0)).transpose()?;
        self.with_elastic(motion, w, &turned, yaw)
    }

    fn with_elastic(
        &self,
        motion: &Motion,
        w: [LinearSignal; 3],
        turned: &LinearSignal,
        yaw: Option<LinearSignal>,
    ) -> Result<Signals> {
        let base = motion.system();
        let (n, m) = (base.order(), base.inputs());
        let accelerations = StateSpace::new(
            base.a.clone(),
            base.b.clone(),
            Mat::from_fn(3, n, |i, j| w[i].state[j]),
            Mat::from_fn(3, m, |i, j| w[i].noise[j]),
        )?;
        let part = self.elastic.system(&self.sphere, &accelerations)?;
        let joint = accelerations.then(&part)?;
        let more = part.order();
        let shift = [0, 1, 2].map(|axis| {
            let state: Vec<f64> = (0..joint.order()).map(|j| joint.c[(axis, j)]).collect();
            let noise: Vec<f64> = (0..m).map(|j| joint.d[(axis, j)]).collect();
            state.iter().any(|v| *v != 0.0).then_some(LinearSignal { state, noise })
        });
        Ok(Signals {
            fast: joint.a,
            noise: joint.b,
            w: w.map(|x| widen(&x, more)),
            turned: widen(turned, more),
            yaw: yaw.map(|x| widen(&x, more)),
            shift,
        })
    }
}

fn zero(motion: &Motion) -> LinearSignal {
    LinearSignal { state: vec![0.0; motion.system().order()], noise: vec![0.0; motion.system().inputs()] }
}

fn add(to: &mut LinearSignal, factor: f64, x: &LinearSignal) {
    to.state.iter_mut().zip(&x.state).for_each(|(a, b)| *a += factor * b);
    to.noise.iter_mut().zip(&x.noise).for_each(|(a, b)| *a += factor * b);
}

fn widen(x: &LinearSignal, more: usize) -> LinearSignal {
    let mut state = x.state.clone();
    state.resize(state.len() + more, 0.0);
    LinearSignal { state, noise: x.noise.clone() }
}

fn unit_signal(at: usize, states: usize, noises: usize) -> LinearSignal {
    let mut state = vec![0.0; states];
    state[at] = 1.0;
    LinearSignal { state, noise: vec![0.0; noises] }
}

fn rest(slow: &Mat<f64>, constant: &[f64]) -> Vec<f64> {
    use faer::linalg::solvers::Solve;
    let right = Mat::from_fn(constant.len(), 1, |i, _| -constant[i]);
    let y = slow.partial_piv_lu().solve(&right);
    (0..constant.len()).map(|i| y[(i, 0)]).collect()
}

/// Adds the compass's linear answer to the fast states, behind them.
fn join_compass(system: &mut SlowFast) {
    let (n, k, m) = (system.fast.nrows(), system.slow.nrows(), system.noise.ncols());
    let mut fast = Mat::zeros(n + k, n + k);
    let mut noise = Mat::zeros(n + k, m);
    for i in 0..n {
        (0..n).for_each(|j| fast[(i, j)] = system.fast[(i, j)]);
        (0..m).for_each(|j| noise[(i, j)] = system.noise[(i, j)]);
    }
    for i in 0..k {
        (0..k).for_each(|j| fast[(n + i, n + j)] = system.slow[(i, j)]);
    }
    for p in &system.linear {
        (0..n).for_each(|j| fast[(n + p.row, j)] += p.gain * p.signal.state[j]);
        (0..m).for_each(|j| noise[(n + p.row, j)] += p.gain * p.signal.noise[j]);
    }
    (system.fast, system.noise) = (fast, noise);
    for p in &mut system.linear {
        p.signal = widen(&p.signal, k);
    }
    for p in &mut system.products {
        (p.left, p.right) = (widen(&p.left, k), widen(&p.right, k));
    }
}
