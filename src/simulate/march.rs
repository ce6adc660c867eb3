//! # Purpose
//! Steps with nothing to look at between them, taken in one loop of machine code.
//!
//! # Method
//! Such are the steps of an explicit method with no switch that slides or changes, whose outputs are wanted at their ends
//! if at all, or at the begin of those where an input jumps. What they load stands in a table, step by step. The loop ends
//! before the first step that is no such one, which is then taken as any other.
//!
//! # Numerical aspects
//! The values are those of single steps, bit for bit.

use super::course::{Course, PATIENCE};
use super::machine::Machine;
use super::probe::{Clock, Probe};
use super::table::Table;
use crate::Result;
use crate::model::Scalar;
use gyrospec_native::{BEGIN, JUMP, March, Mark};

/// Intervals that are not tried after a march that came to nothing.
const REST: usize = 4;

/// What a run marches with.
pub(super) struct Marching<'a> {
    code: &'a March,
    table: &'a Table,
    /// Intervals that are not to be tried.
    rest: usize,
    marks: Vec<Mark>,
}

/// Where a march came to.
pub(super) struct Marched {
    pub interval: usize,
    /// The piece of the interval at whose begin it stands.
    pub piece: usize,
    /// Whether the next step is one that it could not take.
    pub is_stopped: bool,
}

/// What of a run goes along with a march.
pub(super) struct Under<'r, 'a, T> {
    pub m: &'r mut Machine<'a, T>,
    pub probe: &'r mut Probe<'a, T>,
    /// States and rates.
    pub states: (&'r mut [T], &'r mut [T]),
    /// Of the roughness.
    pub measures: &'r mut [f64],
}

impl<'a> Marching<'a> {
    pub fn new(code: &'a March, table: &'a Table) -> Self {
        Self { code, table, rest: 0, marks: Vec::with_capacity(PATIENCE) }
    }

    /// Marks the steps from the beginning of an interval on that can be marched over, at most so many.
    fn mark(&mut self, course: &Course<'_>, interval: usize, (next, most): (&[usize], usize)) {
        self.marks.clear();
        let (mesh, table) = (course.mesh, self.table);
        let mut next = next.to_vec();
        let first = table.step(interval);
        let mut at = interval;
        let mut last = first;
        for step in first..table.ends.len().min(first + most) {
            let mut mark = 0;
            if step == last {
                at += usize::from(step > first);
                last = if at + 1 < table.first.len() { table.step(at + 1) } else { table.ends.len() };
                if mesh.jumps[at] {
                    // some inputs jump before what is measured there, some after it
                    let shows = mesh.shows[at];
                    if shows && mesh.late.contains(&true) {
                        return;
                    }
                    let Some(wanted) = wanted(course.clocks, &mut next, mesh.time[at], shows) else { return };
                    mark = JUMP | wanted << BEGIN;
                }
            }
            // what is measured where an input jumps is written down after the jump
            let is_end = step + 1 < last || !mesh.shows[at + 1];
            let Some(wanted) = wanted(course.clocks, &mut next, table.ends[step], is_end) else { return };
            self.marks.push(mark | wanted);
        }
    }

    /// The interval and the piece that a step is.
    fn place(&self, mut interval: usize, step: usize) -> (usize, usize) {
        let intervals = self.table.first.len();
        if step == self.table.ends.len() {
            return (intervals, 0);
        }
        while interval + 1 < intervals && self.table.step(interval + 1) <= step {
            interval += 1;
        }
        (interval, step - self.table.step(interval))
    }

    /// Marches from the beginning of an interval; gives where it stands then, none where no step was taken.
    ///
    /// # Errors
    /// A time limit that is up.
    pub fn march<T: Scalar>(
        &mut self,
        course: &Course<'_>,
        interval: usize,
        under: Under<'_, '_, T>,
    ) -> Result<Option<Marched>> {
        let Under { m, probe, states: (x, k), measures } = under;
        // what depends on time alone is settled in the first interval
        if interval == 0 || self.rest > 0 || !m.is_smooth() {
            self.rest = self.rest.saturating_sub(1);
            return Ok(None);
        }
        if !m.timed_switches_stand(course.mesh.time[interval]) {
            return Ok(None);
        }
        let most = PATIENCE.min(usize::try_from(course.allowance.left()).unwrap_or(usize::MAX));
        self.mark(course, interval, (&probe.next, most));
        let (first, count) = (self.table.step(interval), self.marks.len());
        let mut lists: Vec<&mut [T]> = Vec::with_capacity(course.clocks.len());
        for (c, values) in probe.values.iter_mut().enumerate() {
            lists.push(&mut values[probe.next[c] * course.clocks[c].registers.len()..]);
        }
        let steps = first..first + count;
        let lengths = &self.table.lengths[steps.clone()];
        let way = (lengths, self.table.rows(steps), self.table.jumps_from(interval), &self.marks[..]);
        let taken = self.code.run((&mut m.r, x, k), way, measures, &mut lists);
        for (c, next) in probe.next.iter_mut().enumerate() {
            let own: Mark = (1 << c) | (1 << (c as u32 + BEGIN));
            *next += self.marks[..taken].iter().map(|m| (m & own).count_ones() as usize).sum::<usize>();
        }
        m.forget_time();
        if taken == 0 {
            self.rest = REST;
            return Ok(None);
        }
        course.allowance.spend(taken as u64, T::TANGENTS);
        course.allowance.in_time()?;
        let (interval, piece) = self.place(interval, first + taken);
        Ok(Some(Marched { interval, piece, is_stopped: taken < count }))
    }
}

/// The clocks that want an entry at a time, which come one further if those count; none where one wants one before it.
fn wanted(clocks: &[Clock], next: &mut [usize], end: f64, counts: bool) -> Option<Mark> {
    let mut mark = 0;
    for (c, (clock, next)) in clocks.iter().zip(next).enumerate() {
        let Some(t) = clock.time.get(*next).filter(|t| **t <= end) else { continue };
        if *t < end || clock.time.get(*next + 1).is_some_and(|t| *t <= end) {
            return None;
        }
        if counts {
            *next += 1;
            mark |= 1 << c;
        }
    }
    Some(mark)
}
