//! How long a part of the search will take, said before it begins, and how much of it is done.
//!
//! # Method
//! What is counted are runs of the model, those to come in units of those that the first fit needed: a run of it
//! took so long, and as many go on at a time as there are threads. What takes longer than that is foretold by its own pace.

use super::bench::Bench;
use crate::estimate::fit::Progress;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// The stage that tells how long a run takes.
pub(super) const FIRST_FIT: &str = "fit as given";

/// The share that is told at most of what goes on.
const MOST: f64 = 0.99;

/// A part of the search that goes on.
pub(super) struct Foretold<'a> {
    progress: &'a dyn Progress,
    stage: String,
    time: Option<Duration>,
    since: Instant,
    runs: usize,
    done: AtomicUsize,
}

impl<'a> Foretold<'a> {
    /// Tells that a part begins which takes so many runs.
    pub fn begin(bench: &Bench, progress: &'a dyn Progress, stage: &str, runs: usize) -> Self {
        let one = bench.budget.stages().into_iter().find(|s| s.name == FIRST_FIT && s.runs > 0);
        let threads = rayon::current_num_threads() as f64;
        let time = one.map(|s| s.time.as_secs_f64() / s.runs as f64 * runs as f64 / threads);
        let time = time.and_then(|t| Duration::try_from_secs_f64(t).ok());
        let (since, done) = (Instant::now(), AtomicUsize::new(0));
        let told = Self { progress, stage: stage.to_owned(), time, since, runs, done };
        told.done(0);
        told
    }

    /// Tells that so many more of its runs are done.
    pub fn done(&self, runs: usize) {
        let done = runs + self.done.fetch_add(runs, Ordering::Relaxed);
        let share = (done as f64 / self.runs.max(1) as f64).min(MOST);
        let own = Duration::try_from_secs_f64(self.since.elapsed().as_secs_f64() / share).ok();
        let time = self.time.map(|t| own.map_or(t, |own| t.max(own)));
        let about = time.and_then(about).map(|s| format!(", about {s} s")).unwrap_or_default();
        self.progress.report(&format!("{}{about}", self.stage), Some(share));
    }
}

/// One digit of seconds; none below one.
fn about(time: Duration) -> Option<u64> {
    let seconds = time.as_secs_f64();
    let digit = 10f64.powf(seconds.log10().floor()).max(1.0);
    Some(((seconds / digit).round() * digit) as u64).filter(|s| *s > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_have_one_digit() {
        let told = [(0.3, None), (0.7, Some(1)), (14.0, Some(10)), (260.0, Some(300)), (9.6, Some(10))];
        for (seconds, expected) in told {
            assert_eq!(about(Duration::from_secs_f64(seconds)), expected, "{seconds}");
        }
        assert_eq!(about(Duration::ZERO), None);
    }
}
