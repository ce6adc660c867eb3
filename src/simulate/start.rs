//! How a run starts: given states, steady states, and whatever has memory.

use super::linear::Factors;
use super::machine::Machine;
use crate::model::Scalar;
use crate::model::program::{Remembered, Switching};
use crate::{Error, Result};

/// Newton steps to a steady state before giving up, and halvings of one.
const STEPS: usize = 60;
const HALVINGS: usize = 60;
/// Where a steady state is sought if it is not found from 0: a law of a power has no slope there, or none beyond.
const GUESSES: [f64; 8] = [1.0, -1.0, 1e3, -1e3, 1e-3, -1e-3, 1e6, 1e-6];

/// The states at the start: those given (one a state of the model), the steady ones solved for, the hidden ones from their
/// signals; switches and held values are set as well.
pub(super) fn start<T: Scalar>(
    m: &mut Machine<'_, T>,
    t: f64,
    given: &[T],
    steady: &[usize],
) -> Result<Vec<T>> {
    let zero = T::constant(0.0);
    let mut x: Vec<T> = given.to_vec();
    x.resize(m.program.rates.len(), zero);
    for i in steady {
        x[*i] = zero;
    }
    m.enter(0);
    m.switching = Switching::Follow;
    remember(m, t, &mut x);
    if !steady.is_empty() {
        let hidden = given.len()..x.len();
        let which: Vec<usize> = steady.iter().copied().chain(hidden).collect();
        x = steady_state(m, t, &x, &which).ok_or_else(|| {
            Error::not_computed("no steady state was found at the first inputs")
                .with_hint("give the states numbers to start from, or initial = \"fit\"")
        })?;
        remember(m, t, &mut x);
    }
    m.forget_time();
    m.load(t, &x);
    m.switching = Switching::Hold;
    m.settle(t, &x);
    Ok(x)
}

/// Starts everything with memory at the present values of its signals, inner ones first.
fn remember<T: Scalar>(m: &mut Machine<'_, T>, t: f64, x: &mut [T]) {
    for i in 0..m.program.remembered.len() {
        m.forget_time();
        m.load(t, x);
        match m.program.remembered[i] {
            Remembered::Hidden { state, start } => x[state] = m.r[usize::from(start)],
            Remembered::Held { held, start, .. } => m.r[usize::from(held)] = m.r[usize::from(start)],
            Remembered::Past { signal, .. } => {
                let value = m.r[usize::from(signal)];
                let slots = &m.program.remembered[..i];
                let slot = slots.iter().filter(|r| matches!(r, Remembered::Past { .. })).count();
                m.pasts[slot].push(t, value, T::constant(0.0));
            }
        }
    }
}

/// The states of which some have no rate, sought from where they are, then from other places.
fn steady_state<T: Scalar>(m: &mut Machine<'_, T>, t: f64, x: &[T], which: &[usize]) -> Option<Vec<T>> {
    let from = |guess: f64| {
        let mut x = x.to_vec();
        for i in which {
            x[*i] = T::constant(guess);
        }
        x
    };
    let begins = std::iter::once(x.to_vec()).chain(GUESSES.into_iter().map(from));
    begins.into_iter().find_map(|mut x| newton(m, t, &mut x, which).then_some(x))
}

/// Newton's method for f(x) = 0 in some of the states, whether it came to an end; the last step is done with tangents.
fn newton<T: Scalar>(m: &mut Machine<'_, T>, t: f64, x: &mut [T], which: &[usize]) -> bool {
    let (n, k) = (x.len(), which.len());
    let zeros = |n: usize| vec![T::constant(0.0); n];
    let (mut f, mut jacobian, mut explicit) = (zeros(n), zeros(n * n), zeros(n));
    let (mut a, mut b, mut step) = (zeros(k * k), zeros(k), zeros(k));
    let mut factors = Factors::new(k);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        m.forget_time();
        m.rates(t, x, &mut f);
        step_back(m, t, (x, which), (&mut step, &mut f));
        m.slopes(&mut jacobian, &mut explicit);
        for (i, row) in which.iter().enumerate() {
            b[i] = f[*row];
            for (j, column) in which.iter().enumerate() {
                a[i * k + j] = jacobian[row * n + column];
            }
        }
        factors.factor(&a);
        factors.solve(&b, &mut step);
        if step.iter().any(|s| !s.value().is_finite()) {
            return false;
        }
        let moved = step.iter().map(|v| v.value().abs()).fold(0.0, f64::max);
        for (j, column) in which.iter().enumerate() {
            x[*column] = x[*column] - step[j];
        }
        let scale = which.iter().map(|c| x[*c].value().abs()).fold(1e-300, f64::max);
        if moved <= 1e-14 * scale || (moved <= 1e-9 * scale && moved >= last) {
            return true;
        }
        last = moved;
    }
    false
}

/// Halves the last step, if there was one, until every rate is a number.
fn step_back<T: Scalar>(
    m: &mut Machine<'_, T>,
    t: f64,
    (x, which): (&mut [T], &[usize]),
    (step, f): (&mut [T], &mut [T]),
) {
    for _ in 0..HALVINGS {
        let stood_still = step.iter().all(|s| s.value() == 0.0);
        if stood_still || which.iter().all(|i| f[*i].value().is_finite()) {
            return;
        }
        for (column, step) in which.iter().zip(&mut *step) {
            *step = step.scale(0.5);
            x[*column] += *step;
        }
        m.forget_time();
        m.rates(t, x, f);
    }
}
