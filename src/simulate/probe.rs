//! What a run writes down: registers at given times.

use super::machine::Machine;
use crate::model::Scalar;
use crate::model::program::Register;
use std::sync::Arc;

/// Registers wanted at rising times.
#[derive(Debug, Clone)]
pub(super) struct Clock {
    pub time: Arc<[f64]>,
    pub registers: Vec<Register>,
}

/// The records of a run, clock by clock.
pub(super) struct Probe<'a, T> {
    pub clocks: &'a [Clock],
    /// For each clock: time by time, register by register.
    pub values: Vec<Vec<T>>,
    /// For each clock: the first time that is not written down yet.
    pub next: Vec<usize>,
}

/// A stretch of a run: both ends, with states and rates.
pub(super) struct Stretch<'a, T> {
    pub from: f64,
    pub to: f64,
    pub x0: &'a [T],
    pub k0: &'a [T],
    pub x1: &'a [T],
    pub k1: &'a [T],
}

impl<'a, T: Scalar> Probe<'a, T> {
    pub fn new(clocks: &'a [Clock], start: f64) -> Self {
        let empty = |c: &Clock| vec![T::constant(f64::NAN); c.time.len() * c.registers.len()];
        let first = |c: &Clock| c.time.partition_point(|t| *t < start);
        Self { clocks, values: clocks.iter().map(empty).collect(), next: clocks.iter().map(first).collect() }
    }

    /// Writes down what falls on the end of the stretch, which is loaded, then what falls inside. Where an input jumps
    /// there, the end is left to the stretch that follows.
    pub fn record(&mut self, m: &mut Machine<'_, T>, s: &Stretch<'_, T>, jumps: bool, room: &mut [T]) {
        let mut loaded = true;
        for c in 0..self.clocks.len() {
            let clock = &self.clocks[c];
            let first = self.next[c];
            let mut end = first;
            while clock.time.get(end).is_some_and(|t| *t < s.to || *t == s.to && !jumps) {
                end += 1;
            }
            self.next[c] = end;
            let mut inside = end;
            if end > first && clock.time[end - 1] == s.to {
                inside = end - 1;
                if !loaded {
                    m.load(s.to, s.x1);
                    loaded = true;
                }
                self.write(m, c, inside);
            }
            for i in first..inside {
                let t = self.clocks[c].time[i];
                between(s, t, room);
                m.load(t, room);
                loaded = false;
                self.write(m, c, i);
            }
        }
    }

    /// Writes down the loaded registers.
    fn write(&mut self, m: &mut Machine<'_, T>, clock: usize, row: usize) {
        m.outputs();
        let registers = &self.clocks[clock].registers;
        let first = row * registers.len();
        for (j, register) in registers.iter().enumerate() {
            self.values[clock][first + j] = m.r[usize::from(*register)];
        }
    }
}

/// The state at a time inside a stretch, by the cubic through both ends with their rates.
pub(super) fn between<T: Scalar>(s: &Stretch<'_, T>, t: f64, x: &mut [T]) {
    let h = s.to - s.from;
    let theta = (t - s.from) / h;
    // x(θ) = (1−θ)x₀ + θx₁ + θ(θ−1)·((1−2θ)(x₁−x₀) + (θ−1)hk₀ + θhk₁)
    let bend = theta * (theta - 1.0);
    for (i, x) in x.iter_mut().enumerate() {
        let rise = s.x1[i] - s.x0[i];
        let curve =
            rise.scale(1.0 - 2.0 * theta) + s.k0[i].scale((theta - 1.0) * h) + s.k1[i].scale(theta * h);
        *x = s.x0[i] + rise.scale(theta) + curve.scale(bend);
    }
}
