//! # Purpose
//! Switches during a run: where one changes, what it changes to, and what that does to tangents.
//!
//! # Method
//! Within a step every switch keeps its sign, so the rates are smooth. At the step's end each
//! guard must still agree with its sign; where one does not, the earliest crossing is located on
//! the cubic through the step, the step is repeated up to it, and the switch changes there. A sign
//! whose both sides push towards the surface slides (Filippov): it takes the value between -1 and
//! 1 for which its guard stands still, until that value leaves the interval. Dry friction sticks so. A guard that
//! jumps, with a held input or another switch, leaves its surface without an event of its own.
//!
//! # References
//! A. F. Filippov, Differential Equations with Discontinuous Righthand Sides, Kluwer 1988, §4.
//! R. I. Leine, H. Nijmeijer, Dynamics and Bifurcations of Non-Smooth Mechanical Systems,
//! Springer 2004, chapter 7 (saltation).
//!
//! # Numerical aspects
//! With dual numbers the event time moves with the parameters: δ = −g/ġ has no value but the right
//! tangents, and x + (f⁻ − f⁺)·δ carries them into the state.

use super::machine::{Machine, tangents_only};
use super::probe::{Stretch, between};
use crate::model::Scalar;

/// The event is known well enough within this share of the step.
const CLOSE: f64 = 1e-13;
/// Trial times of a search, and the least share of the bracket that one must cut off.
const TRIES: usize = 60;
const EDGE: f64 = 2e-4;

impl<T: Scalar> Machine<'_, T> {
    fn sign(&self, k: usize) -> f64 {
        self.r[usize::from(self.program.watches[k].sign)].value()
    }

    fn guard(&self, k: usize) -> T {
        self.r[usize::from(self.program.watches[k].guard)]
    }

    fn set_sign(&mut self, k: usize, sign: f64) {
        self.r[usize::from(self.program.watches[k].sign)] = T::constant(sign);
    }

    /// How far a switch is from having to change; negative when it should have changed already.
    fn margin(&self, k: usize) -> f64 {
        let sign = self.sign(k);
        if self.sliding.contains(&k) {
            return 1.0 - sign.abs();
        }
        let g = self.guard(k).value();
        if sign == 0.0 { -g.abs() } else { g * sign }
    }

    /// The worst margin of all switches at the loaded time and state.
    pub fn worst_margin(&self) -> (usize, f64) {
        let margins = (0..self.program.watches.len()).map(|k| (k, self.margin(k)));
        margins.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, f64::INFINITY))
    }

    /// Whether every switch that depends on the time and the inputs alone stands as its guard says at a time where an
    /// interval begins, and would go on so.
    pub fn timed_switches_stand(&mut self, t: f64) -> bool {
        let program = self.program;
        let mut timed = (0..program.watches.len()).filter(|k| program.watches[*k].timed).peekable();
        if timed.peek().is_some() {
            self.load_time(t);
        }
        timed.all(|k| self.margin(k) > 0.0)
    }

    /// The earliest time in a stretch at which a switch must change, and the switch.
    pub fn locate(&mut self, s: &Stretch<'_, T>, room: &mut [T]) -> (f64, usize) {
        let (mut low, mut high) = (s.from, s.to);
        let (mut switch, mut below) = self.worst_margin();
        self.load(s.from, s.x0);
        let (first, mut above) = self.worst_margin();
        if above < 0.0 {
            return (s.from, first);
        }
        let mut side = 0;
        for _ in 0..TRIES {
            if high - low <= CLOSE * (s.to - s.from) {
                break;
            }
            let share = (above / (above - below)).clamp(EDGE, 1.0 - EDGE);
            let middle = low + share * (high - low);
            between(s, middle, room);
            self.load(middle, room);
            let (k, margin) = self.worst_margin();
            // Illinois: the end that stays twice loses half its weight.
            if margin < 0.0 {
                (high, below, switch) = (middle, margin, k);
                above *= if side > 0 { 0.5 } else { 1.0 };
                side = 1;
            } else {
                (low, above) = (middle, margin);
                below *= if side < 0 { 0.5 } else { 1.0 };
                side = -1;
            }
        }
        (high, switch)
    }

    /// Changes a switch at a time; x takes over the tangents of the moving event time, and `k`
    /// the rates after it.
    pub fn change(&mut self, k: usize, t: f64, x: &mut [T], rates: &mut [T]) {
        self.load(t, x);
        self.motions();
        let motion = self.r[usize::from(self.program.watches[k].motion)];
        let delta = -tangents_only(self.guard(k)) / motion;
        let before: Vec<T> = self.program.rates.iter().map(|r| self.r[usize::from(*r)]).collect();
        let (was_sliding, old, guards) = (self.sliding.contains(&k), self.sign(k), self.guards());
        self.sliding.retain(|other| *other != k);
        if was_sliding {
            self.set_sign(k, old.signum());
        } else if old == 0.0 {
            let now = self.guard(k).value().signum();
            self.set_sign(k, now);
        } else if self.slides(k, t, x) {
            self.sliding.push(k);
        } else {
            self.set_sign(k, -old);
        }
        self.forget_time();
        self.follow_jumps(t, x, &guards, Some(k));
        self.rates(t, x, rates);
        if T::TANGENTS > 0 && !was_sliding && motion.value() != 0.0 {
            for i in 0..x.len() {
                x[i] += (before[i] - rates[i]) * delta;
            }
            self.rates(t, x, rates);
        }
    }

    /// The values of all guards at the loaded time and state.
    pub fn guards(&self) -> Vec<f64> {
        (0..self.program.watches.len()).map(|k| self.guard(k).value()).collect()
    }

    /// Sets the switches whose guards jumped at a time, since an input or the switch `but` did: what slid no longer
    /// lies on its surface, and what has the wrong sign has passed its surface without being on it.
    pub fn follow_jumps(&mut self, t: f64, x: &[T], before: &[f64], but: Option<usize>) {
        for _ in 0..before.len() {
            self.load(t, x);
            let now = self.guards();
            let jumped = (0..now.len()).find(|k| {
                let may = Some(*k) != but && !self.program.watches[*k].timed && now[*k] != 0.0;
                may && now[*k] != before[*k] && (self.sliding.contains(k) || self.margin(*k) < 0.0)
            });
            let Some(k) = jumped else { return };
            self.sliding.retain(|other| *other != k);
            self.set_sign(k, now[k].signum());
            self.forget_time();
        }
    }

    /// Whether both sides of a switch push towards it at a time and state.
    fn slides(&mut self, k: usize, t: f64, x: &[T]) -> bool {
        if !self.program.watches[k].may_slide {
            return false;
        }
        let (above, below) = self.both_motions(k, t, x);
        above <= 0.0 && below >= 0.0 && above != below
    }

    /// The motion of a guard with the sign +1 and with −1; the sign is as before afterwards.
    fn both_motions(&mut self, k: usize, t: f64, x: &[T]) -> (f64, f64) {
        let old = self.sign(k);
        let mut motion = |sign: f64| {
            self.set_sign(k, sign);
            self.forget_time();
            self.load(t, x);
            self.motions();
            self.r[usize::from(self.program.watches[k].motion)].value()
        };
        let both = (motion(1.0), motion(-1.0));
        self.set_sign(k, old);
        both
    }

    /// Decides the switches whose guards are exactly 0 at the start by where they are going.
    pub fn settle(&mut self, t: f64, x: &[T]) {
        for k in 0..self.program.watches.len() {
            if self.guard(k).value() != 0.0 || self.program.watches[k].timed {
                continue;
            }
            let (above, below) = self.both_motions(k, t, x);
            if self.program.watches[k].may_slide && above <= 0.0 && below >= 0.0 && above != below {
                self.sliding.push(k);
            } else if above > 0.0 {
                self.set_sign(k, 1.0);
            } else if below < 0.0 {
                self.set_sign(k, -1.0);
            }
        }
        self.forget_time();
    }

    /// Sets the switches that depend on time and inputs alone as they are just after a time at
    /// which an interval begins; true if one changed.
    pub fn follow_inputs(&mut self, from: f64, to: f64) -> bool {
        let mut changed = false;
        for k in 0..self.program.watches.len() {
            if !self.program.watches[k].timed {
                continue;
            }
            self.load_time(from);
            let mut g = self.guard(k).value();
            if g == 0.0 {
                self.load_time(0.5 * (from + to));
                g = self.guard(k).value();
            }
            let sign = if g == 0.0 { self.program.watches[k].at_zero } else { g.signum() };
            if sign != self.sign(k) {
                self.set_sign(k, sign);
                self.forget_time();
                changed = true;
            }
        }
        changed
    }
}
