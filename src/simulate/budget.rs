//! What a long computation may spend: steps of the solver, and wall time for who asks.
//!
//! # Purpose
//! A fit that has run to where its model is stiff would take hours. A budget ends it with the best so far.
//!
//! # Method
//! Steps are counted, each once for its values and once for each of its sensitivities, so that the same
//! inputs end at the same place on every machine. A part of a budget counts for the whole as well, but asks
//! for its own steps alone: parts run beside each other, and what the others have spent by some moment
//! depends on the machine. The whole is asked while no part of it runs. That a part has spent its steps is
//! told by whoever knows what it was for; that the whole has, and that the time is up, is told at once. One
//! simulation may spend a share of the whole, so that none goes on where a model is stiff beyond use. Time is
//! asked at any moment, even inside a run.

use super::stages::{Stage, Stages};
use crate::{Error, Result};
use serde::Serialize;
use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// What ended a computation before it was through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Early {
    /// The steps of the solver were spent.
    Steps,
    /// The time was up.
    Time,
}

impl Early {
    /// The reason in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Steps => "its simulated steps were spent",
            Self::Time => "the time given was up",
        }
    }
}

/// One simulation may spend one part in so many of the whole, its values alone; without a limit to the whole,
/// so many steps.
const RUNS: u64 = 200;
const UNLIMITED: u64 = 1_000_000_000;

/// A budget, or a part of one, shared by all that spend it.
#[derive(Debug, Clone)]
pub struct Budget {
    whole: Arc<Whole>,
    own: Arc<Own>,
}

/// What all parts share.
#[derive(Debug)]
struct Whole {
    until: Option<Instant>,
    /// Steps that one simulation may spend.
    one_run: u64,
    /// 0 for nothing, 1 where a part was ended by its steps, 2 by the time.
    cut: AtomicU8,
    stages: Stages,
}

#[derive(Debug)]
struct Own {
    most: u64,
    spent: AtomicU64,
    /// Whether what is left is finished whatever the time.
    is_lifted: AtomicBool,
    /// What this is a part of.
    of: Option<Arc<Own>>,
}

impl Default for Budget {
    fn default() -> Self {
        Self::new(u64::MAX, None)
    }
}

impl Budget {
    /// So many steps at most, and so much time from now on.
    pub fn new(most: u64, time: Option<Duration>) -> Self {
        let until = time.and_then(|t| Instant::now().checked_add(t));
        let own = Own { most, spent: AtomicU64::new(0), is_lifted: AtomicBool::new(false), of: None };
        let one_run = if most == u64::MAX { UNLIMITED } else { most / RUNS };
        Self {
            whole: Arc::new(Whole { until, one_run, cut: AtomicU8::new(0), stages: Stages::default() }),
            own: Arc::new(own),
        }
    }

    fn with(&self, most: u64) -> Self {
        let is_lifted = AtomicBool::new(self.own.is_lifted.load(Ordering::Relaxed));
        let own = Own { most, spent: AtomicU64::new(0), is_lifted, of: Some(Arc::clone(&self.own)) };
        Self { whole: Arc::clone(&self.whole), own: Arc::new(own) }
    }

    /// A part that ends after a share of the steps, one in so many.
    #[must_use]
    pub fn part(&self, one_in: u64) -> Self {
        self.with(if self.own.most == u64::MAX { u64::MAX } else { self.own.most / one_in.max(1) })
    }

    /// A part of so many steps, or of all that are left; to be asked for while nothing runs beside.
    #[must_use]
    pub fn at_most(&self, steps: u64) -> Self {
        self.with(steps.min(self.own.most.saturating_sub(self.spent())))
    }

    /// A part with all steps that are left; to be asked for while nothing runs beside.
    #[must_use]
    pub fn rest(&self) -> Self {
        self.at_most(u64::MAX)
    }

    /// What one simulation may spend of it.
    pub(super) fn one_run(&self) -> Allowance<'_> {
        Allowance {
            budget: self,
            left: Cell::new(self.whole.one_run),
            owed: Cell::new(0),
            told: Cell::new(0),
        }
    }

    /// Begins what the next runs are for, or goes on with it.
    pub fn begin(&self, stage: &'static str) {
        self.whole.stages.begin(stage);
    }

    /// What was spent for what.
    pub fn stages(&self) -> Vec<Stage> {
        self.whole.stages.all()
    }

    /// Counts steps.
    fn spend(&self, steps: u64) {
        let mut own = Some(&self.own);
        while let Some(o) = own {
            o.spent.fetch_add(steps, Ordering::Relaxed);
            own = o.of.as_ref();
        }
    }

    /// Steps spent, by all parts together.
    pub fn spent(&self) -> u64 {
        self.own.spent.load(Ordering::Relaxed)
    }

    /// Steps that may be spent.
    pub fn most(&self) -> u64 {
        self.own.most
    }

    /// Whether the time is up.
    fn is_late(&self) -> bool {
        let is_up = |until: Instant| Instant::now() >= until;
        !self.own.is_lifted.load(Ordering::Relaxed) && self.whole.until.is_some_and(is_up)
    }

    /// Refuses to go on once the time is up, and remembers it: whoever asks would have gone on.
    fn in_time(&self) -> Result<()> {
        if self.is_late() {
            self.tell(Some(Early::Time));
            return Err(Error::not_computed("the time given was up").with_hint("give a longer --time-limit"));
        }
        Ok(())
    }

    /// What ends it now, if anything does; to be asked while no part of it runs. That a part has spent its
    /// steps ends that part alone.
    pub fn over(&self) -> Option<Early> {
        let is_spent = self.spent() >= self.own.most;
        let early = if is_spent { Some(Early::Steps) } else { self.is_late().then_some(Early::Time) };
        self.tell(early.filter(|e| *e == Early::Time || self.own.of.is_none()));
        early
    }

    /// Remembers that something ended a computation early.
    pub fn tell(&self, early: Option<Early>) {
        let cut = early.map_or(0, |e| if e == Early::Steps { 1 } else { 2 });
        self.whole.cut.fetch_max(cut, Ordering::Relaxed);
    }

    /// What was told to have ended the computation early, if anything was.
    pub fn cut(&self) -> Option<Early> {
        [None, Some(Early::Steps), Some(Early::Time)][usize::from(self.whole.cut.load(Ordering::Relaxed))]
    }

    /// Begins its steps anew, for what they were spent on is not asked about any more; to be asked for while nothing
    /// runs.
    pub fn renew(&self) {
        self.own.spent.store(0, Ordering::Relaxed);
        if self.cut() == Some(Early::Steps) {
            self.whole.cut.store(0, Ordering::Relaxed);
        }
    }

    /// What is left is finished, whatever the time.
    pub fn lift_time(&self) {
        self.own.is_lifted.store(true, Ordering::Relaxed);
    }
}

/// What one simulation may spend, for its values alone.
pub(super) struct Allowance<'a> {
    budget: &'a Budget,
    left: Cell<u64>,
    /// Steps that the budget has not been told of yet.
    owed: Cell<u64>,
    /// Those that it has.
    told: Cell<u64>,
}

/// Steps of which the budget, which threads share, is told at once.
const LOT: u64 = 4096;

impl Allowance<'_> {
    /// Counts steps with so many sensitivities each; false where they are more than is left.
    pub fn spend(&self, steps: u64, sensitivities: usize) -> bool {
        let left = self.left.get();
        self.left.set(left.saturating_sub(steps));
        let owed = self.owed.get().saturating_add(steps.min(left).saturating_mul(1 + sensitivities as u64));
        self.owed.set(owed);
        if owed >= LOT {
            self.settle();
        }
        steps <= left
    }

    /// Tells the budget what it has not been told of.
    fn settle(&self) {
        let owed = self.owed.replace(0);
        self.told.set(self.told.get() + owed);
        self.budget.spend(owed);
    }

    /// Refuses to go on once the time is up.
    pub fn in_time(&self) -> Result<()> {
        self.budget.in_time()
    }

    /// Steps that may still be spent.
    pub fn left(&self) -> u64 {
        self.left.get()
    }

    /// The budget that it is a share of.
    pub fn budget(&self) -> &Budget {
        self.budget
    }
}

impl Drop for Allowance<'_> {
    fn drop(&mut self) {
        self.settle();
        self.budget.whole.stages.count(1, self.told.get());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_counts_for_the_whole_and_ends_by_its_own_steps() {
        let whole = Budget::new(100, None);
        let (a, b) = (whole.part(4), whole.part(2));
        a.spend(25);
        assert_eq!((a.over(), b.over(), whole.over()), (Some(Early::Steps), None, None));
        assert_eq!(whole.cut(), None, "a part that is spent is no end of the whole");
        b.rest().spend(49);
        assert_eq!((b.over(), whole.over(), b.rest().most()), (None, None, 1));
        b.spend(26);
        assert_eq!((b.over(), whole.over()), (Some(Early::Steps), Some(Early::Steps)));
        assert_eq!((whole.spent(), whole.cut()), (100, Some(Early::Steps)));
        whole.renew();
        assert_eq!((whole.spent(), whole.over(), whole.cut()), (0, None, None));
        let three = Budget::new(5, None);
        three.spend(3);
        assert_eq!((three.at_most(1).most(), three.at_most(7).most()), (1, 2));
        assert!(Budget::default().cut().is_none());
    }

    #[test]
    fn one_run_may_spend_a_share_of_the_whole_whatever_its_sensitivities() {
        let whole = Budget::new(1000, None);
        let part = whole.part(10);
        let run = part.one_run();
        assert!(run.spend(3, 0) && run.spend(2, 8) && !run.spend(1, 8));
        drop(run); // a budget hears of the last steps when the run ends
        assert_eq!((whole.spent(), part.spent()), (3 + 2 * 9, 21));
        assert!(part.one_run().spend(5, 0) && Budget::default().one_run().spend(1_000_000, 0));
    }

    #[test]
    fn time_that_is_up_ends_everything_until_it_is_lifted() {
        let whole = Budget::new(u64::MAX, Some(Duration::ZERO));
        let part = whole.part(2);
        assert!(whole.cut().is_none());
        assert!(part.in_time().is_err() && whole.cut() == Some(Early::Time));
        assert!(part.over() == Some(Early::Time));
        part.lift_time();
        assert!(part.in_time().is_ok() && part.over().is_none() && whole.over() == Some(Early::Time));
    }
}
