//! A run over the whole mesh.

use super::course::{Course, PATIENCE};
use super::machine::Machine;
use super::march::{Marched, Marching, Under};
use super::pieces::{piece, substeps};
use super::probe::{Probe, Stretch};
use super::roughness::Roughness;
use super::start::start;
use super::steps::{Solver, Stepper};
use super::tabulate::tabulated;
use crate::Result;
use crate::model::Scalar;
use crate::model::program::Switching;
use gyrospec_native::TOO_LARGE;

/// Events within one step before the rest of it is taken without looking.
const MOST_EVENTS: usize = 12;

/// Times that the first step of the stiff method is halved.
const LAYER: i32 = 16;
/// Explicit steps that one event costs.
const EVENT: usize = 4;

/// What a run gives.
pub(super) struct Ran<T> {
    /// For each clock: time by time, register by register.
    pub values: Vec<Vec<T>>,
    /// Σ over steps of the embedded error against the range of each state, the largest.
    pub roughness: f64,
    /// The lowest and the highest value of each state at the ends of the steps.
    pub swings: Vec<(f64, f64)>,
    /// The time and the state at which the run blew up.
    pub blew_up: Option<(f64, usize)>,
    /// Whether it ended because it may spend no more.
    pub is_cut: bool,
    /// Number of events.
    pub events: usize,
}

impl<T> Ran<T> {
    /// What a model without states gives.
    pub fn of_none(values: Vec<Vec<T>>) -> Self {
        Self { values, roughness: 0.0, swings: Vec::new(), blew_up: None, is_cut: false, events: 0 }
    }
}

/// How a walk over the mesh ended.
enum Ended {
    Well,
    BlownUp(f64, usize),
    Cut,
}

struct Runner<'a, T> {
    m: Machine<'a, T>,
    stepper: Stepper<T>,
    probe: Probe<'a, T>,
    /// What it marches with, where it can.
    marching: Option<Marching<'a>>,
    x: Vec<T>,
    k: Vec<T>,
    x1: Vec<T>,
    k1: Vec<T>,
    room: Vec<T>,
    events: usize,
    /// Steps that were taken one by one.
    singles: usize,
    roughness: Roughness,
}

/// Runs from start to end.
pub(super) fn run<T: Scalar>(course: &Course<'_>, parameters: &[T], given: &[T]) -> Result<Ran<T>> {
    let mut m = Machine::new(course.program, course.mesh, parameters);
    let steps = course.substeps.saturating_mul(course.mesh.intervals());
    let over = (course.clocks, course.mesh.jumps.contains(&true));
    let kind = course.natives.of(course.program, parameters, over, (course.method, steps));
    let march = kind.as_ref().and_then(|k| k.march(course.program));
    let plan = (course.substeps, course.method);
    let table = tabulated(course.program, course.mesh, plan, march.is_some());
    let marching = march.zip(table.as_deref()).map(|(code, table)| Marching::new(code, table));
    (m.table, m.native) = (table.as_deref(), kind.as_ref().and_then(|k| k.single(course.program)));
    let first = course.mesh.time[0];
    let x = start(&mut m, first, given, course.steady)?;
    let n = x.len();
    let zeros = || vec![T::constant(0.0); n];
    let mut runner = Runner {
        m,
        stepper: Stepper::new(course.method, n),
        probe: Probe::new(course.clocks, first),
        marching,
        x,
        k: zeros(),
        x1: zeros(),
        k1: zeros(),
        room: zeros(),
        events: 0,
        singles: 0,
        roughness: Roughness::new(n),
    };
    runner.begin(first);
    let ended = runner.walk(course)?;
    if let Some(kind) = &kind {
        kind.count_single(runner.singles);
    }
    Ok(Ran {
        values: runner.probe.values,
        roughness: runner.roughness.worst(),
        swings: runner.roughness.ranges(),
        blew_up: if let Ended::BlownUp(t, state) = ended { Some((t, state)) } else { None },
        is_cut: matches!(ended, Ended::Cut),
        events: runner.events,
    })
}

impl<T: Scalar> Runner<'_, T> {
    fn begin(&mut self, t: f64) {
        self.m.rates(t, &self.x, &mut self.k);
        self.m.commit(t);
        self.record_here(t);
    }

    /// Writes down what falls on a time that is loaded.
    fn record_here(&mut self, t: f64) {
        let here = Stretch { from: t, to: t, x0: &self.x, k0: &self.k, x1: &self.x, k1: &self.k };
        self.probe.record(&mut self.m, &here, false, &mut self.room);
    }

    fn walk(&mut self, course: &Course<'_>) -> Result<Ended> {
        let mesh = course.mesh;
        let mut at = (0, 0);
        let mut asked = 0;
        while at.0 < mesh.intervals() {
            if let Some(marched) = self.march(course, at.0)? {
                at = (marched.interval, marched.piece);
                if at.1 == 0 && !marched.is_stopped {
                    continue;
                }
            }
            if let Some(ended) = self.walk_interval(course, at, &mut asked)? {
                return Ok(ended);
            }
            at = (at.0 + 1, 0);
        }
        if mesh.shows[mesh.intervals()] {
            self.m.load_last(&self.x);
            self.record_here(mesh.time[mesh.intervals()]);
        }
        Ok(Ended::Well)
    }

    /// Marches from the beginning of an interval on; none where no step was taken.
    fn march(&mut self, course: &Course<'_>, interval: usize) -> Result<Option<Marched>> {
        let Some(marching) = &mut self.marching else { return Ok(None) };
        let (m, probe, states) = (&mut self.m, &mut self.probe, (&mut self.x[..], &mut self.k[..]));
        marching.march(course, interval, Under { m, probe, states, measures: &mut self.roughness.measures })
    }

    /// Steps to the end of an interval from one of its pieces on; says how the walk ends if it does.
    fn walk_interval(
        &mut self,
        course: &Course<'_>,
        (i, first): (usize, usize),
        asked: &mut usize,
    ) -> Result<Option<Ended>> {
        let mesh = course.mesh;
        let (from, to) = (mesh.time[i], mesh.time[i + 1]);
        if first == 0 {
            self.enter(i, from, to);
        } else {
            self.m.enter(i);
        }
        let is_layer = i == 0 && course.method == Solver::Stiff;
        let pieces = substeps(course.substeps, to - from, mesh.usual);
        let steps = pieces - first + if is_layer { LAYER as usize } else { 0 };
        if !course.allowance.spend((steps * course.method.work(self.x.len())) as u64, T::TANGENTS) {
            return Ok(Some(Ended::Cut));
        }
        *asked += steps;
        self.singles += steps;
        if *asked >= PATIENCE {
            course.allowance.in_time()?;
            *asked = 0;
        }
        let before = self.events;
        let h = (to - from) / pieces as f64;
        for s in first..pieces {
            let (begin, end) = piece((from, to), (s, pieces), h);
            if is_layer && s == 0 {
                self.begin_finely(begin, end);
            } else {
                self.advance(begin, end, Some(s));
            }
        }
        let events = EVENT * (self.events - before);
        if events > 0 && !course.allowance.spend(events as u64, T::TANGENTS) {
            return Ok(Some(Ended::Cut));
        }
        let bad = self.x.iter().position(|x| x.value().is_nan() || x.value().abs() > TOO_LARGE);
        Ok(bad.map(|bad| Ended::BlownUp(to, bad)))
    }

    /// The first step of the stiff method in steps that double: what is fast seldom starts where it would
    /// come to rest, and even steps as fine as its decay asks for would be so all the way.
    fn begin_finely(&mut self, from: f64, to: f64) {
        let mut t = from;
        for k in (0..=LAYER).rev() {
            let next = if k == 0 { to } else { from + (to - from) * 0.5f64.powi(k) };
            self.advance(t, next, None);
            t = next;
        }
    }

    fn enter(&mut self, interval: usize, from: f64, to: f64) {
        let jumps = interval > 0 && self.m.jumps(interval);
        let guards =
            if jumps && !self.m.program.watches.is_empty() { self.guards_at(from) } else { Vec::new() };
        self.m.enter(interval);
        let shows = jumps && self.m.mesh.shows[interval];
        if shows && self.m.mesh.late.contains(&true) {
            self.record_under_late(from, to, &guards);
        }
        let followed = self.m.follow_inputs(from, to);
        if jumps {
            self.m.follow_jumps(from, &self.x, &guards, None);
            self.carry_delay_tangents(from);
        }
        let bends = self.m.tangents_bend() || !self.m.sliding.is_empty();
        if followed || bends || jumps {
            self.m.rates(from, &self.x, &mut self.k);
        }
        if shows {
            // a held input has its new value from the moment of its sample on
            self.record_here(from);
        }
    }

    /// Writes down what is seen where held inputs jump, before those jump that are set from it.
    fn record_under_late(&mut self, from: f64, to: f64, guards: &[f64]) {
        self.m.hold_late_back(true);
        self.m.follow_inputs(from, to);
        self.m.follow_jumps(from, &self.x, guards, None);
        self.m.load(from, &self.x);
        self.record_here(from);
        self.m.hold_late_back(false);
    }

    fn guards_at(&mut self, t: f64) -> Vec<f64> {
        self.m.load(t, &self.x);
        self.m.guards()
    }

    /// Held inputs that jump some delay later: the moment of each jump moves with its delay. Those of one moment jump
    /// one after the other, the undelayed ones first.
    fn carry_delay_tangents(&mut self, t: f64) {
        if !self.m.tangents_bend() {
            return;
        }
        let jumping = self.m.jumping_columns();
        let delayed: Vec<_> = jumping.iter().filter_map(|(c, delay)| Some((*c, (*delay)?))).collect();
        for (c, _) in &delayed {
            self.m.hold_back(*c, true);
        }
        if !delayed.is_empty() && delayed.len() < jumping.len() {
            self.m.rates(t, &self.x, &mut self.k);
        }
        for (c, delay) in delayed {
            let before = self.k.clone();
            self.m.hold_back(c, false);
            self.m.rates(t, &self.x, &mut self.k);
            // the rates before the jump went on for as long as the delay grows: x + (f₋ − f₊) dT
            for (x, (before, after)) in self.x.iter_mut().zip(before.iter().zip(&self.k)) {
                *x += (*before - *after) * delay;
            }
        }
    }

    /// From one time to another within an interval, through whatever events lie between. A whole piece of the
    /// interval has a number.
    fn advance(&mut self, from: f64, to: f64, piece: Option<usize>) {
        let mut t = from;
        for event in 0.. {
            if !self.m.sliding.is_empty() && event < MOST_EVENTS {
                self.leave_slides(t);
            }
            let piece = piece.filter(|_| event == 0);
            let growing = self.stepper.growing;
            self.stepper.step(&mut self.m, (t, to, piece), (&self.x, &self.k), (&mut self.x1, &mut self.k1));
            if !self.m.program.watches.is_empty() && self.k1.iter().any(|k| !k.value().is_finite()) {
                self.step_following(t, to);
                self.accept(t, to);
                return;
            }
            let quiet = self.m.program.watches.is_empty() || self.m.worst_margin().1 >= 0.0;
            if quiet || event >= MOST_EVENTS {
                self.roughness.add(&self.stepper, to - t, &self.k1, &self.x1);
                self.accept(t, to);
                return;
            }
            let whole = Stretch { from: t, to, x0: &self.x, k0: &self.k, x1: &self.x1, k1: &self.k1 };
            let (at, switch) = self.m.locate(&whole, &mut self.room);
            // the step is taken anew, up to the event
            self.stepper.growing = growing;
            if at > t {
                self.stepper.step(
                    &mut self.m,
                    (t, at, None),
                    (&self.x, &self.k),
                    (&mut self.x1, &mut self.k1),
                );
                self.accept(t, at);
            }
            self.m.change(switch, at, &mut self.x, &mut self.k);
            self.events += 1;
            t = at;
            if t >= to {
                return;
            }
        }
    }

    /// A step in which the switches follow at every stage: for rates that do not exist beyond a
    /// switch, like √max(x, 0). It is of first order there.
    fn step_following(&mut self, t: f64, to: f64) {
        self.m.sliding.clear();
        self.m.switching = Switching::Follow;
        self.m.forget_time();
        self.stepper.step(&mut self.m, (t, to, None), (&self.x, &self.k), (&mut self.x1, &mut self.k1));
        self.m.forget_time();
        self.m.rates(to, &self.x1, &mut self.k1);
        self.m.switching = Switching::Hold;
    }

    /// A slide may have to end at once where an input bends.
    fn leave_slides(&mut self, t: f64) {
        self.m.load(t, &self.x);
        while let (k, margin) = self.m.worst_margin()
            && margin < 0.0
            && self.m.sliding.contains(&k)
        {
            self.m.change(k, t, &mut self.x, &mut self.k);
            self.m.load(t, &self.x);
            self.events += 1;
        }
    }

    /// Ends a stretch: memory moves on, records are written, the new state becomes the present.
    fn accept(&mut self, from: f64, to: f64) {
        self.m.commit(to);
        let shows = self.m.shows_after(to);
        let s = Stretch { from, to, x0: &self.x, k0: &self.k, x1: &self.x1, k1: &self.k1 };
        self.probe.record(&mut self.m, &s, shows, &mut self.room);
        std::mem::swap(&mut self.x, &mut self.x1);
        std::mem::swap(&mut self.k, &mut self.k1);
    }
}
