//! The kept past of a signal, for delays of what the model itself computes.

use crate::model::Scalar;

/// Values and slopes of a signal at the ends of steps.
#[derive(Debug)]
pub(super) struct History<T> {
    times: Vec<f64>,
    values: Vec<(T, T)>,
    /// How many entries lay at or before the time that was asked for last.
    near: usize,
}

impl<T> Default for History<T> {
    fn default() -> Self {
        Self { times: Vec::new(), values: Vec::new(), near: 0 }
    }
}

impl<T: Scalar> History<T> {
    /// Adds the value and the slope at a later time; at the same time it replaces the last.
    pub fn push(&mut self, t: f64, value: T, slope: T) {
        if self.times.last() == Some(&t) {
            // An event: the slope after it is that of the next stretch.
            self.values.pop();
            self.times.pop();
        }
        self.times.push(t);
        self.values.push((value, slope));
    }

    /// Value and slope at a time: the first value before the start, a cubic between entries.
    pub fn at(&mut self, t: T) -> (T, T) {
        let zero = T::constant(0.0);
        let i = self.passed(t.value());
        if i == 0 {
            return self.values.first().map_or((zero, zero), |v| (v.0, zero));
        }
        let (v0, s0) = self.values[i - 1];
        let into = t - T::constant(self.times[i - 1]);
        if i == self.times.len() {
            return (v0 + s0 * into, s0);
        }
        let (v1, s1) = self.values[i];
        let h = self.times[i] - self.times[i - 1];
        // p(θ) = v₀ + hθs₀ + θ²(3Δ − h(2s₀ + s₁)) + θ³(h(s₀ + s₁) − 2Δ)
        let (theta, rise) = (into.scale(1.0 / h), v1 - v0);
        let c2 = rise.scale(3.0) - (s0.scale(2.0) + s1).scale(h);
        let c3 = (s0 + s1).scale(h) - rise.scale(2.0);
        let value = v0 + theta * (s0.scale(h) + theta * (c2 + theta * c3));
        let slope = s0 + (theta * (c2.scale(2.0) + theta * c3.scale(3.0))).scale(1.0 / h);
        (value, slope)
    }

    /// How many entries lie at or before a time, looked for from the last answer on: a run asks almost in order.
    fn passed(&mut self, t: f64) -> usize {
        let is_passed = |x: &f64| *x <= t;
        let mut i = self.near.min(self.times.len());
        while self.times.get(i).is_some_and(is_passed) {
            i += 1;
        }
        while i > 0 && !is_passed(&self.times[i - 1]) {
            i -= 1;
        }
        self.near = i;
        i
    }
}
