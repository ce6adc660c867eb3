//! # Purpose
//! A suspension with dry friction, free play or both in time, whatever else is in it.
//!
//! # Method
//! Between events (a stop of the slip, a break from rest, a touch of the play's end, a leave of it) the balance is
//! linear and the force straight, so that states and force together follow ẏ = A y. A part of a step holds 2⁴⁰ ticks;
//! e^{A h/2ᵏ} − I is kept for every k, so that any number of ticks is a product of a few of them, and the last tick
//! before an event is found by halving. What must not become negative until an event is linear in y, and so is its
//! rate: an event within a part is seen at its end, or at the lowest point where the rate changes its sign.
//!
//! # References
//! A. F. Filippov, Differential Equations with Discontinuous Righthand Sides (1988), for the rest by friction.
//!
//! # Numerical aspects
//! e^{A h} − I is doubled as 2E + E², which loses no digit where E is small; a tick is 10⁻¹² of a part.

use super::balance::{Balance, GIVE, Mode, Row};
use crate::gyro::elastic::in_time::{InTime, parts};
use crate::{Error, Result};
use std::array::from_fn;

/// Powers of one half of a part of a step.
const HALVES: usize = 40;
/// Ticks of a part.
const WHOLE: u64 = 1 << HALVES;
/// Most events that a part of a step may hold: more come only of rounding.
const EVENTS: usize = 64;

/// States, W₁, Ẇ₁ and K, or a quantity over them; what a balance lacks is zero. N is a multiple of four.
type Fixed<const N: usize> = [f64; N];

/// A matrix by its columns.
type Columns<const N: usize> = [Fixed<N>; N];

/// A mode with its steps.
#[derive(Debug, Clone)]
struct Stepper<const N: usize> {
    /// e^{A h/2ᵏ} − I, from k = 0 on.
    steps: Vec<Columns<N>>,
    /// x₁, ẋ₁ and f over y, and the rates of the last two.
    place: Fixed<N>,
    speed: Fixed<N>,
    force: Fixed<N>,
    turning: Fixed<N>,
    loading: Fixed<N>,
}

impl<const N: usize> Stepper<N> {
    fn new(mode: &Mode, part: f64) -> Result<Self> {
        let n = mode.rates.len();
        let rates = |i: usize, j: usize| if i < n && j < n { mode.rates[i][j] } else { 0.0 };
        let tick: Columns<N> = from_fn(|j| from_fn(|i| rates(i, j) * part / WHOLE as f64));
        let size = tick.iter().map(|column| column.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max);
        if size.is_nan() || size >= 0.5 {
            return Err(Error::not_computed("the suspension is too stiff to be followed in time")
                .with_hint("a share or a time near to 0 is that of a part that could as well be left away"));
        }
        // e^X − I = X(I + X/2(I + X/3(…)))
        let mut small = tick;
        for k in (2..14).rev() {
            let product = times(&tick, &small);
            small = from_fn(|j| from_fn(|i| tick[j][i] + product[j][i] / f64::from(k)));
        }
        let mut steps = vec![small];
        for k in 0..HALVES {
            let last = steps[k];
            let square = times(&last, &last);
            steps.push(from_fn(|j| from_fn(|i| 2.0 * last[j][i] + square[j][i])));
        }
        steps.reverse();
        let (speed, force) = (fixed(&mode.speed), fixed(&mode.force));
        let rate = |row: &Fixed<N>| from_fn(|j| (0..N).map(|i| row[i] * rates(i, j)).sum());
        let place = from_fn(|i| f64::from(u8::from(i == GIVE)));
        Ok(Self { steps, place, speed, force, turning: rate(&speed), loading: rate(&force) })
    }

    /// y after one of the steps.
    fn stepped(&self, y: &Fixed<N>, k: usize) -> Fixed<N> {
        let mut out = *y;
        for (column, factor) in self.steps[k].iter().zip(y) {
            out.iter_mut().zip(column).for_each(|(o, x)| *o += x * factor);
        }
        out
    }

    fn after(&self, y: &Fixed<N>, ticks: u64) -> Fixed<N> {
        let mut y = *y;
        for k in (0..=HALVES).filter(|k| ticks & (WHOLE >> k) != 0) {
            y = self.stepped(&y, k);
        }
        y
    }

    /// The last tick up to `end` at which a quantity that falls below zero by then has not done so.
    fn last(&self, y: &Fixed<N>, end: u64, quantity: impl Fn(&Fixed<N>) -> f64) -> u64 {
        let (mut at, mut here) = (0, *y);
        for k in 0..=HALVES {
            let step = WHOLE >> k;
            if at + step < end {
                let there = self.stepped(&here, k);
                if quantity(&there) >= 0.0 {
                    (at, here) = (at + step, there);
                }
            }
        }
        at
    }

    /// The first tick at which a guard is broken within those to the end, where the state is `after`.
    fn breaks(&self, guard: &Guard<'_, N>, y: &Fixed<N>, (after, end): (&Fixed<N>, u64)) -> Option<u64> {
        let value = |y: &Fixed<N>| guard.offset + guard.factor * dot(guard.row, y);
        let rate = |y: &Fixed<N>| guard.factor * dot(guard.rate, y);
        if matches!(guard.event, Event::Slip(_)) && value(y) < 0.0 {
            return Some(0);
        }
        if value(after) < 0.0 {
            return Some(self.last(y, end, value) + 1);
        }
        if rate(y) >= 0.0 || rate(after) <= 0.0 {
            return None;
        }
        // down and up again, with the lowest point between
        let lowest = self.last(y, end, |y| -rate(y)) + 1;
        (value(&self.after(y, lowest)) < 0.0).then(|| self.last(y, lowest, value) + 1)
    }
}

/// What must not become negative, offset + factor·row·y, with its rate and what happens when it does. A slip may begin
/// at once.
struct Guard<'a, const N: usize> {
    row: &'a Fixed<N>,
    rate: &'a Fixed<N>,
    factor: f64,
    offset: f64,
    event: Event,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Event {
    /// The slip ends.
    Stop,
    /// A slip begins, that way.
    Slip(f64),
    /// The stop on that side takes hold.
    Touch(f64),
    /// The stop lets go.
    Leave,
}

/// The suspension in time.
#[derive(Debug, Clone)]
pub(super) struct Switched<const N: usize> {
    held: Stepper<N>,
    free: Option<Stepper<N>>,
    stuck: Option<Stepper<N>>,
    /// x over y.
    give: Fixed<N>,
    y: Fixed<N>,
    /// Place of W₁.
    driven: usize,
    mass: f64,
    stiffness: f64,
    /// F_c, N, and δ, m.
    friction: f64,
    gap: f64,
    /// The sign of the stop that holds; zero in the gap, one without play.
    side: f64,
    /// The sign of ẋ₁; zero at rest.
    slip: f64,
    /// Whether the vessel stands still while friction holds.
    rests: bool,
    parts: usize,
    part: f64,
}

impl<const N: usize> Switched<N> {
    /// From rest in the middle, in steps of `step` seconds.
    ///
    /// # Errors
    /// `NotComputed` for a suspension too stiff.
    pub fn new(balance: &Balance, (friction, gap): (f64, f64), step: f64) -> Result<Self> {
        let own = parts((balance.mass, balance.viscous, balance.spring), step);
        let parts = own.max((step * balance.inside.ringing() / 0.3).ceil() as usize);
        let part = step / parts as f64;
        let free = Balance { spring: 0.0, ..*balance };
        let of = |wanted: bool, mode: &Mode| wanted.then(|| Stepper::new(mode, part)).transpose();
        Ok(Self {
            held: Stepper::new(&balance.moving(), part)?,
            free: of(gap > 0.0, &free.moving())?,
            stuck: of(friction > 0.0, &balance.stuck())?,
            give: fixed(&balance.give()),
            y: [0.0; N],
            driven: balance.driven(),
            mass: balance.mass,
            stiffness: balance.stiffness,
            friction,
            gap,
            side: if gap > 0.0 { 0.0 } else { 1.0 },
            slip: 0.0,
            rests: !balance.flows(),
            parts,
            part,
        })
    }

    fn is_stuck(&self) -> bool {
        self.friction > 0.0 && self.slip == 0.0
    }

    fn stepper(&self) -> &Stepper<N> {
        let moving = if self.side == 0.0 { self.free.as_ref() } else { Some(&self.held) };
        let now = if self.is_stuck() { self.stuck.as_ref() } else { moving };
        now.unwrap_or(&self.held)
    }

    /// C₀ d(x₁), N.
    fn spring(&self) -> f64 {
        if self.side == 0.0 { 0.0 } else { self.stiffness * (self.y[GIVE] - self.side * self.gap) }
    }

    /// What ends the present mode.
    fn guards<'a>(&self, now: &'a Stepper<N>) -> [Option<Guard<'a, N>>; 3] {
        let guard = |factor: f64, (row, rate): (&'a Fixed<N>, &'a Fixed<N>), offset: f64, event: Event| {
            Some(Guard { row, rate, factor, offset, event })
        };
        if self.is_stuck() {
            // |f − C₀ d(x₁)| ≤ F_c
            let force = (&now.force, &now.loading);
            let by = |way: f64| guard(-way, force, self.friction + way * self.spring(), Event::Slip(way));
            return [by(1.0), by(-1.0), None];
        }
        let (place, speed) = ((&now.place, &now.speed), (&now.speed, &now.turning));
        let stop = if self.friction > 0.0 { guard(self.slip, speed, 0.0, Event::Stop) } else { None };
        if self.gap == 0.0 {
            return [stop, None, None];
        }
        if self.side == 0.0 {
            let by = |side: f64| guard(-side, place, self.gap, Event::Touch(side));
            return [stop, by(1.0), by(-1.0)];
        }
        [stop, guard(self.side, place, -self.gap, Event::Leave), None]
    }

    /// Moves on to the next event, by so many ticks at most; gives how many.
    fn go(&mut self, left: u64) -> u64 {
        let k = self.driven + 2;
        let pull = if self.side == 0.0 { 0.0 } else { -self.stiffness * self.side * self.gap };
        self.y[k] = pull + self.friction * self.slip;
        let now = self.stepper();
        let after = now.after(&self.y, left);
        let guards = self.guards(now).into_iter().flatten();
        let events = guards
            .filter_map(|guard| now.breaks(&guard, &self.y, (&after, left)).map(|at| (at, guard.event)));
        let Some((at, event)) = events.min_by_key(|e| e.0) else {
            self.y = after;
            return left;
        };
        self.y = now.after(&self.y, at);
        self.happen(event);
        at
    }

    fn happen(&mut self, event: Event) {
        match event {
            Event::Stop => {
                self.slip = 0.0;
                if self.rests {
                    self.y[0] = 0.0;
                }
            }
            Event::Slip(way) => self.slip = way,
            Event::Touch(side) => {
                self.side = side;
                self.y[GIVE] = side * self.gap;
            }
            Event::Leave => {
                self.y[GIVE] = self.side * self.gap;
                self.side = 0.0;
            }
        }
    }

    fn part_of(&mut self) {
        let mut left = WHOLE;
        for _ in 0..EVENTS {
            left -= self.go(left);
            if left == 0 {
                return;
            }
        }
        self.y = self.stepper().after(&self.y, left);
    }
}

impl<const N: usize> InTime for Switched<N> {
    fn advance(&mut self, from: f64, to: f64) {
        let slope = (to - from) / (self.parts as f64 * self.part);
        for k in 0..self.parts {
            self.y[self.driven] = (from + slope * self.part * k as f64) / self.mass;
            self.y[self.driven + 1] = slope / self.mass;
            self.part_of();
        }
    }

    fn shift(&self) -> f64 {
        dot(&self.give, &self.y)
    }

    fn is_at_rest(&self) -> bool {
        self.y[GIVE] == 0.0
    }

    fn parts(&self) -> usize {
        self.parts
    }
}

fn dot<const N: usize>(a: &Fixed<N>, b: &Fixed<N>) -> f64 {
    let four: [f64; 4] = from_fn(|i| (i..N).step_by(4).map(|j| a[j] * b[j]).sum());
    (four[0] + four[1]) + (four[2] + four[3])
}

fn fixed<const N: usize>(row: &Row) -> Fixed<N> {
    from_fn(|i| row.get(i).copied().unwrap_or(0.0))
}

/// A product of matrices.
fn times<const N: usize>(a: &Columns<N>, b: &Columns<N>) -> Columns<N> {
    from_fn(|j| from_fn(|i| (0..N).map(|k| a[k][i] * b[j][k]).sum()))
}
