//! How a run starts: given states, steady states, and whatever has memory.

use super::linear::Factors;
use super::machine::Machine;
use crate::model::Scalar;
use crate::model::program::{Remembered, Switching};
use crate::{Error, Result};

/// Newton steps to a steady state before giving up.
const STEPS: usize = 60;

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
        steady_state(m, t, &mut x, &which)?;
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

/// Newton's method for f(x) = 0 in some of the states; the last step is done with tangents.
fn steady_state<T: Scalar>(m: &mut Machine<'_, T>, t: f64, x: &mut [T], which: &[usize]) -> Result<()> {
    let (n, k) = (x.len(), which.len());
    let zeros = |n: usize| vec![T::constant(0.0); n];
    let (mut f, mut jacobian, mut explicit) = (zeros(n), zeros(n * n), zeros(n));
    let (mut a, mut b, mut step) = (zeros(k * k), zeros(k), zeros(k));
    let mut factors = Factors::new(k);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        m.forget_time();
        m.rates(t, x, &mut f);
        m.slopes(&mut jacobian, &mut explicit);
        for (i, row) in which.iter().enumerate() {
            b[i] = f[*row];
            for (j, column) in which.iter().enumerate() {
                a[i * k + j] = jacobian[row * n + column];
            }
        }
        factors.factor(&a);
        factors.solve(&b, &mut step);
        let size = |x: &[T]| x.iter().map(|v| v.value().abs()).fold(0.0, f64::max);
        let moved = size(&step);
        if !moved.is_finite() {
            break;
        }
        for (j, column) in which.iter().enumerate() {
            x[*column] = x[*column] - step[j];
        }
        let scale = which.iter().map(|c| x[*c].value().abs()).fold(1e-300, f64::max);
        if moved <= 1e-14 * scale || (moved <= 1e-9 * scale && moved >= last) {
            return Ok(());
        }
        last = moved;
    }
    Err(Error::not_computed("no steady state was found at the first inputs")
        .with_hint("give the states numbers to start from, or initial = \"fit\""))
}
