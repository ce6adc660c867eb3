//! The instructions and the loop that runs them.

use super::{Program, Register};
use crate::expression::Function;
use crate::model::scalar::Scalar;

/// Whether sign registers follow their arguments or are held by the simulation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Switching {
    Follow,
    Hold,
}

/// What an instruction does with its registers a, b, c.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Action {
    Add,
    Sub,
    Mul,
    Div,
    Pow,
    Atan2,
    Negative,
    /// a·b + c
    MulAdd,
    /// c − a·b
    MulSub,
    Square,
    Cube,
    /// aⁿ for n = b (as a signed number)
    Whole,
    /// b where a > 0, else c
    Select,
    /// The sign of a (at 0: the number b), when signs follow.
    Sign,
    /// The sign of a, always.
    SignNow,
    /// Relay of a with half width b, when signs follow.
    Relay,
    One(Function),
    /// Result b of call a.
    Foreign,
    /// The derivative of result b of call a by its argument c.
    ForeignSlope,
}

/// One instruction: `to` = action(a, b, c).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Op {
    pub action: Action,
    pub to: Register,
    pub a: Register,
    pub b: Register,
    pub c: Register,
}

/// Runs a segment.
#[inline]
pub(crate) fn execute<T: Scalar>(program: &Program, code: &[Op], r: &mut [T], switching: Switching) {
    for op in code {
        let a = r[usize::from(op.a)];
        let value = match op.action {
            Action::Add => a + r[usize::from(op.b)],
            Action::Sub => a - r[usize::from(op.b)],
            Action::Mul => a * r[usize::from(op.b)],
            Action::Div => a / r[usize::from(op.b)],
            Action::MulAdd => a * r[usize::from(op.b)] + r[usize::from(op.c)],
            Action::MulSub => r[usize::from(op.c)] - a * r[usize::from(op.b)],
            Action::Negative => -a,
            Action::Square => a * a,
            Action::Cube => a * a * a,
            Action::Select => {
                let from = if a.value() > 0.0 { op.b } else { op.c };
                r[usize::from(from)]
            }
            Action::Sign | Action::Relay if switching == Switching::Hold => continue,
            Action::Foreign | Action::ForeignSlope => {
                let by = (op.action == Action::ForeignSlope).then_some(usize::from(op.c));
                program.calls[usize::from(op.a)].result(usize::from(op.b), by, r)
            }
            _ => rare(op, a, r),
        };
        r[usize::from(op.to)] = value;
    }
}

#[inline(never)]
fn rare<T: Scalar>(op: &Op, a: T, r: &[T]) -> T {
    let b = r.get(usize::from(op.b)).copied().unwrap_or(a);
    match op.action {
        Action::Sign | Action::SignNow => T::constant(sign_of(a.value(), op.b)),
        Action::Relay => {
            let beyond = Function::Relay.of(&[a.value(), 2.0 * b.value()]);
            let kept = r[usize::from(op.to)].value();
            let start = if a.value() < 0.0 { -1.0 } else { 1.0 };
            let inside = if kept == 0.0 { start } else { kept };
            T::constant(if beyond == 0.0 { inside } else { beyond })
        }
        Action::Whole => whole_power(a, i32::from(op.b as i16)),
        Action::Pow => a.power(b),
        Action::Atan2 => a.atan2(b),
        Action::One(f) => {
            let x = a.value();
            let y = f.of(&[x]);
            a.chain(y, slope(f, x, y))
        }
        _ => a,
    }
}

/// The sign of x; at 0 it is what the switch says, 0 or 1.
fn sign_of(x: f64, at_zero: Register) -> f64 {
    if x == 0.0 { f64::from(at_zero) } else { Function::Sign.of(&[x]) }
}

fn whole_power<T: Scalar>(a: T, n: i32) -> T {
    let (value, slope) = whole_power_parts(a.value(), n);
    a.chain(value, slope)
}

/// xⁿ and its slope.
#[inline]
pub(crate) fn whole_power_parts(x: f64, n: i32) -> (f64, f64) {
    (x.powi(n), if n == 0 { 0.0 } else { f64::from(n) * x.powi(n - 1) })
}

/// f′(x) with y = f(x); 0 where it is infinite, as at √0, so that fits can start there.
#[inline]
pub(crate) fn slope(f: Function, x: f64, y: f64) -> f64 {
    let slope = match f {
        Function::Sin => x.cos(),
        Function::Cos => -x.sin(),
        Function::Tan => 1.0 + y * y,
        Function::Asin => 1.0 / (1.0 - x * x).sqrt(),
        Function::Acos => -1.0 / (1.0 - x * x).sqrt(),
        Function::Atan => 1.0 / (1.0 + x * x),
        Function::Sinh => x.cosh(),
        Function::Cosh => x.sinh(),
        Function::Tanh => 1.0 - y * y,
        Function::Exp => y,
        Function::Ln => 1.0 / x,
        Function::Sqrt => 0.5 / y,
        _ => 0.0,
    };
    if slope.is_infinite() { 0.0 } else { slope }
}
