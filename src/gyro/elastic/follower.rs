//! A law that is followed from event to event: what friction and free play have in common.

use super::in_time::{InTime, Place, Ramp, parts};
use std::fmt::Debug;

/// Most events that a part of a step may hold: more come only of rounding.
const EVENTS: usize = 64;

/// A law that is linear between its events.
pub(super) trait Law: Debug + Send {
    /// Moves on under a force, at most by the time `left` (s) and up to the next event; gives how long that was.
    fn go(&mut self, at: &mut Place, force: Ramp, left: f64) -> f64;
}

/// A part that follows its law, m ẍ + r ẋ + C₀ x = m W₁ but for what the law adds.
#[derive(Debug)]
pub(super) struct Follower<L> {
    law: L,
    at: Place,
    /// Parts of a step, and how long each is, s.
    parts: usize,
    part: f64,
}

impl<L: Law> Follower<L> {
    /// From rest in the middle, in steps of `step` seconds; `law` is made for the length of a part of them.
    pub fn new(coefficients: (f64, f64, f64), step: f64, law: impl FnOnce(f64) -> L) -> Self {
        let parts = parts(coefficients, step);
        let part = step / parts as f64;
        Self { law: law(part), at: Place { x: 0.0, v: 0.0 }, parts, part }
    }

    fn part_of(&mut self, force: Ramp) {
        let mut t = 0.0;
        for _ in 0..EVENTS {
            t += self.law.go(&mut self.at, force.from(t, 0.0), self.part - t);
            if t >= self.part {
                return;
            }
        }
    }
}

impl<L: Law> InTime for Follower<L> {
    fn advance(&mut self, from: f64, to: f64) {
        let slope = (to - from) / (self.parts as f64 * self.part);
        for k in 0..self.parts {
            self.part_of(Ramp { f: from + slope * self.part * k as f64, g: slope });
        }
    }

    fn shift(&self) -> f64 {
        self.at.x
    }

    fn parts(&self) -> usize {
        self.parts
    }
}
