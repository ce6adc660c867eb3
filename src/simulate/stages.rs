//! What the runs of a long computation were for: how many, how many steps, how much time.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// What one stage has spent.
#[derive(Debug, Clone, Copy)]
pub struct Stage {
    /// What it is for.
    pub name: &'static str,
    /// Simulations.
    pub runs: u64,
    /// Steps of the solver, each counted once for its values and once for each of its sensitivities.
    pub steps: u64,
    /// Time from its begins to its ends.
    pub time: Duration,
}

/// The stages of a computation, of which one goes on at a time.
#[derive(Debug)]
pub(super) struct Stages(Mutex<Inner>);

#[derive(Debug)]
struct Inner {
    all: Vec<Stage>,
    now: usize,
    since: Instant,
}

const FIRST: Stage = Stage { name: "before", runs: 0, steps: 0, time: Duration::ZERO };

impl Default for Stages {
    fn default() -> Self {
        Self(Mutex::new(Inner { all: vec![FIRST], now: 0, since: Instant::now() }))
    }
}

impl Stages {
    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Begins a stage, or goes on with it.
    pub fn begin(&self, name: &'static str) {
        let mut inner = self.lock();
        inner.settle();
        let known = inner.all.iter().position(|s| s.name == name);
        inner.now = known.unwrap_or(inner.all.len());
        if known.is_none() {
            inner.all.push(Stage { name, ..FIRST });
        }
    }

    /// Counts runs and steps for the stage that goes on.
    pub fn count(&self, runs: u64, steps: u64) {
        let mut inner = self.lock();
        let now = inner.now;
        inner.all[now].runs += runs;
        inner.all[now].steps += steps;
    }

    /// All of them, in the order in which they began.
    pub fn all(&self) -> Vec<Stage> {
        let mut inner = self.lock();
        inner.settle();
        inner.all.clone()
    }
}

impl Inner {
    fn settle(&mut self) {
        let now = Instant::now();
        self.all[self.now].time += now - self.since;
        self.since = now;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_that_goes_on_counts_on() {
        let stages = Stages::default();
        for (name, runs) in [("a", 1), ("b", 2), ("a", 3)] {
            stages.begin(name);
            stages.count(runs, 10 * runs);
        }
        let told: Vec<_> = stages.all().iter().map(|s| (s.name, s.runs, s.steps)).collect();
        assert_eq!(told, [("before", 0, 0), ("a", 4, 40), ("b", 2, 20)]);
    }
}
