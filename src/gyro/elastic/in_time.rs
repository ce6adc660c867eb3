//! # Purpose
//! A part that is not linear, followed in time without approximation of its law: dry friction
//! that sticks and slips, free play with its two stops.
//!
//! # Method
//! The force over a step runs straight from sample to sample. Between events (a stop of the
//! slip, a break from rest, a touch of the play's end) the law is linear, m ẍ + r ẋ + c x = f + g t,
//! and is solved exactly: with E(t) the answer to a unit speed, x = x̂ + C u + E w, C = Ė + (r/m) E.
//! An event is the first zero of ẋ or of x ∓ δ, bracketed by the ends of the step and by the
//! extremum between them.
//!
//! # References
//! A. F. Filippov, Differential Equations with Discontinuous Righthand Sides (1988), for the rest
//! by friction; E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, II.6,
//! for the location of events.
//!
//! # Numerical aspects
//! The straight force errs in the square of the step; [`crate::gyro::Instrument::error`] takes each
//! figure with the double step too and counts the difference in its margin. A part that rings is
//! stepped in parts of its own period.

use std::fmt::Debug;

/// A part in time under the force m W₁ along the parallel; it starts at rest in the middle.
pub trait InTime: Debug + Send {
    /// Moves on by one step, under a force (N) that runs straight from `from` to `to`.
    fn advance(&mut self, from: f64, to: f64);

    /// x, m.
    fn shift(&self) -> f64;

    /// Whether what friction or play holds has not moved from the middle.
    fn is_at_rest(&self) -> bool {
        self.shift() == 0.0
    }

    /// In how many parts each step is solved.
    fn parts(&self) -> usize {
        1
    }
}

/// x and ẋ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub x: f64,
    pub v: f64,
}

/// m ẍ + r ẋ + c x = force.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    m: f64,
    r: f64,
    c: f64,
    /// The time asked for most, s, with E and Ė there.
    usual: (f64, f64, f64),
}

/// A force f + g t, N.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ramp {
    pub f: f64,
    pub g: f64,
}

impl Ramp {
    pub fn at(self, t: f64) -> f64 {
        self.f + self.g * t
    }

    /// The same from the time `t` on, with a steady force more.
    pub fn from(self, t: f64, more: f64) -> Self {
        Self { f: self.at(t) + more, g: self.g }
    }
}

/// Into how many parts a step is cut: none holds more than a twentieth of the ringing.
pub(super) fn parts((m, r, c): (f64, f64, f64), step: f64) -> usize {
    let (half, square) = (0.5 * r / m, c / m);
    if half * half > square { 1 } else { (step * square.sqrt() / 0.3).ceil().max(1.0) as usize }
}

impl Piece {
    /// `part` is the time that is asked for most, s.
    pub fn new((m, r, c): (f64, f64, f64), part: f64) -> Self {
        let mut piece = Self { m, r, c, usual: (0.0, 0.0, 1.0) };
        let (e, de) = piece.answer(part);
        piece.usual = (part, e, de);
        piece
    }

    /// E and Ė: the answer to x = 0, ẋ = 1 without force.
    fn answer(&self, t: f64) -> (f64, f64) {
        if t == self.usual.0 {
            return (self.usual.1, self.usual.2);
        }
        let (half, square) = (0.5 * self.r / self.m, self.c / self.m);
        let split = half * half - square;
        if split < 0.0 {
            let w = (-split).sqrt();
            let e = (-half * t).exp() * (w * t).sin() / w;
            return (e, (-half * t).exp() * (w * t).cos() - half * e);
        }
        // s² + (r/m) s + c/m = (s − p)(s − q), q ≤ p ≤ 0; p without the loss of digits of −½r/m + √…
        let root = split.sqrt();
        let (p, q) = (-square / (half + root), -(half + root));
        let slow = (p * t).exp();
        let e = if root == 0.0 { t * slow } else { -slow * ((q - p) * t).exp_m1() / (p - q) };
        (e, slow + q * e)
    }

    /// x and ẋ after the time `t`.
    pub fn after(&self, from: Place, force: Ramp, t: f64) -> Place {
        let (e, de) = self.answer(t);
        let Ramp { f, g } = force;
        if self.c == 0.0 {
            // ẋ̂ = (f − m g/r)/r + (g/r) t
            let drift = (f - self.m * g / self.r) / self.r;
            let w = from.v - drift;
            let x = from.x + drift * t + 0.5 * g / self.r * t * t + w * e;
            return Place { x, v: drift + g / self.r * t + w * de };
        }
        // x̂ = (f − r g/c)/c + (g/c) t
        let (still, drift) = ((f - self.r * g / self.c) / self.c, g / self.c);
        let (u, w) = (from.x - still, from.v - drift);
        let x = still + drift * t + (de + self.r / self.m * e) * u + e * w;
        Place { x, v: drift - self.c / self.m * e * u + de * w }
    }

    /// ẍ.
    fn acceleration(&self, at: Place, force: f64) -> f64 {
        (force - self.r * at.v - self.c * at.x) / self.m
    }

    /// The first time up to `end` at which `side`·ẋ falls below zero.
    pub fn stops(&self, from: Place, force: Ramp, end: f64, side: f64) -> Option<f64> {
        let speed = |t: f64| side * self.after(from, force, t).v;
        if speed(end) < 0.0 {
            return Some(crossing(speed, end));
        }
        // two zeros, with the lowest speed between them
        if side * self.acceleration(from, force.f) >= 0.0 {
            return None;
        }
        let pull = |t: f64| -side * self.acceleration(self.after(from, force, t), force.at(t));
        if pull(end) >= 0.0 {
            return None;
        }
        let lowest = crossing(pull, end);
        (speed(lowest) < 0.0).then(|| crossing(speed, lowest))
    }

    /// The first time up to `end` at which `side`·(x − at) rises above zero.
    pub fn reaches(&self, from: Place, force: Ramp, end: f64, (at, side): (f64, f64)) -> Option<f64> {
        let below = |t: f64| side * (at - self.after(from, force, t).x);
        if below(end) < 0.0 {
            return Some(crossing(below, end));
        }
        // there and back, with the farthest point between
        if side * from.v <= 0.0 || side * self.after(from, force, end).v >= 0.0 {
            return None;
        }
        let farthest = crossing(|t| side * self.after(from, force, t).v, end);
        (below(farthest) < 0.0).then(|| crossing(below, farthest))
    }
}

/// Where `f` falls below zero between 0, where it is not below, and `end`, where it is: regula falsi
/// with halved ends (Illinois).
fn crossing(f: impl Fn(f64) -> f64, end: f64) -> f64 {
    let (mut a, mut b) = (0.0, end);
    let (mut fa, mut fb) = (f(a).max(0.0), f(b));
    let mut moved = 0;
    for _ in 0..200 {
        if b - a <= 1e-13 * end {
            break;
        }
        let secant = b - fb * (b - a) / (fb - fa);
        let t = if secant > a && secant < b { secant } else { 0.5 * (a + b) };
        let ft = f(t);
        if ft < 0.0 {
            (b, fb) = (t, ft);
            fa *= if moved > 0 { 0.5 } else { 1.0 };
            moved = 1;
        } else {
            (a, fa) = (t, ft);
            fb *= if moved < 0 { 0.5 } else { 1.0 };
            moved = -1;
        }
    }
    b
}
