//! Numbers, an interpreter and random code to try machine code with.

use gyrospec_native::{Action, Care, Dual, Method, Number, Op, StepCode};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the interpreter needs of a number.
pub trait Plain:
    Number
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn of(value: f64, tangents: &mut dyn FnMut() -> f64) -> Self;
    fn parts(self) -> Vec<f64>;
    fn chain(self, value: f64, slope: f64) -> Self;

    fn value(self) -> f64 {
        self.parts()[0]
    }

    fn scale(self, c: f64) -> Self {
        self.chain(c * self.value(), c)
    }
}

impl Plain for f64 {
    fn of(value: f64, _: &mut dyn FnMut() -> f64) -> Self {
        value
    }
    fn parts(self) -> Vec<f64> {
        vec![self]
    }
    fn chain(self, value: f64, _: f64) -> Self {
        value
    }
}

impl<const N: usize> Plain for Dual<N> {
    fn of(value: f64, tangents: &mut dyn FnMut() -> f64) -> Self {
        Self { value, tangents: std::array::from_fn(|_| tangents()) }
    }
    fn parts(self) -> Vec<f64> {
        std::iter::once(self.value).chain(self.tangents).collect()
    }
    fn chain(self, value: f64, slope: f64) -> Self {
        Self::chain(self, value, slope)
    }
}

pub extern "C" fn sine(x: f64) -> f64 {
    x.sin()
}

pub extern "C" fn cosine(x: f64, _: f64) -> f64 {
    x.cos()
}

pub extern "C" fn hypot(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

pub extern "C" fn hypot_by_a(a: f64, b: f64) -> f64 {
    a / hypot(a, b)
}

pub extern "C" fn hypot_by_b(a: f64, b: f64) -> f64 {
    b / hypot(a, b)
}

pub extern "C" fn whole(x: f64, n: i32) -> f64 {
    x.powi(n)
}

pub extern "C" fn whole_slope(x: f64, n: i32) -> f64 {
    f64::from(n) * x.powi(n - 1)
}

/// 1 where a condition holds, −1 where another does, else 0.
pub fn side(above: bool, below: bool) -> f64 {
    f64::from(i8::from(above) - i8::from(below))
}

pub fn interpret<T: Plain>(code: &[Op], r: &mut [T]) {
    for op in code {
        let at = |k: u16| r[usize::from(k)];
        let a = at(op.a);
        r[usize::from(op.to)] = match op.action {
            Action::Add => a + at(op.b),
            Action::Sub => a - at(op.b),
            Action::Mul => a * at(op.b),
            Action::Div => a / at(op.b),
            Action::Negative => -a,
            Action::MulAdd => a * at(op.b) + at(op.c),
            Action::MulSub => at(op.c) - a * at(op.b),
            Action::Square => a * a,
            Action::Cube => a * a * a,
            Action::Select => at(if a.value() > 0.0 { op.b } else { op.c }),
            Action::One(f, slope) => a.chain(f(a.value()), slope(a.value(), f(a.value()))),
            Action::Two(f, by_a, by_b) => {
                let (x, y) = (a.value(), at(op.b).value());
                a.chain(f(x, y), by_a(x, y)) + at(op.b).chain(0.0, by_b(x, y))
            }
            Action::Whole(f, slope) => {
                let n = i32::from(op.b.cast_signed());
                a.chain(f(a.value(), n), slope(a.value(), n))
            }
            Action::Sign => T::of(side(a.value() > 0.0, a.value() < 0.0), &mut || 0.0),
            Action::SignOrOne => T::of(side(a.value() >= 0.0, a.value() < 0.0), &mut || 0.0),
            Action::Step => T::of(side(a.value() >= 0.0, false), &mut || 0.0),
            Action::Sqrt => {
                let root = a.value().sqrt();
                a.chain(root, if root == 0.0 { 0.0 } else { 0.5 / root })
            }
        };
    }
}

/// A sequence of numbers that looks random, the same on every machine (Knuth's multiplier for 64 bits).
pub struct Draw(pub u64);

impl Draw {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    pub fn below(&mut self, n: u64) -> u16 {
        u16::try_from(self.next() % n).expect("small")
    }

    pub fn number(&mut self) -> f64 {
        f64::from(u32::try_from(self.next() % 2_000_001).expect("small")) / 1e6 - 1.0
    }
}

/// A step of a method without code and registers.
pub fn empty(method: Method) -> StepCode<'static> {
    StepCode {
        time: &[],
        code: &[],
        output: &[],
        motion: &[],
        slopes: &[],
        states: &[],
        rates: &[],
        signs: &[],
        active: &[],
        kept: &[],
        method,
        care: Care::Much,
    }
}

/// One way of compiling for every other pair of seeds.
pub fn care(seed: u64) -> Care {
    if (seed / 2).is_multiple_of(2) { Care::Little } else { Care::Much }
}

pub const GIVEN: u16 = 8;
pub const STATES: u16 = 3;

pub fn random_code(draw: &mut Draw, length: u16) -> Vec<Op> {
    let actions = [
        Action::Add,
        Action::Sub,
        Action::Mul,
        Action::Div,
        Action::Negative,
        Action::MulAdd,
        Action::MulSub,
        Action::Square,
        Action::Cube,
        Action::Select,
        Action::One(sine, cosine),
        Action::Two(hypot, hypot_by_a, hypot_by_b),
        Action::Whole(whole, whole_slope),
        Action::SignOrOne,
        Action::Sqrt,
    ];
    let mut is_squared = false;
    let one = |k: u16| {
        let drawn = actions[usize::from(draw.below(actions.len() as u64))];
        let to = GIVEN + k;
        // the root of what may be negative is no number, and has no tangents to compare
        let action = match drawn {
            Action::Sqrt if !is_squared => Action::Square,
            other => other,
        };
        is_squared = matches!(action, Action::Square);
        let mut operand = || draw.below(u64::from(to));
        let (a, b, c) = (operand(), operand(), operand());
        let a = if matches!(action, Action::Sqrt) { to - 1 } else { a };
        let b = if matches!(action, Action::Whole(..)) { (c % 5).wrapping_sub(1) } else { b };
        Op { action, to, a, b, c }
    };
    (0..length).map(one).collect()
}

/// Equal bits, but that zeros of both signs and all of what is no number are the same.
pub fn agree(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a == b || (a.is_nan() && b.is_nan()))
}

/// A number at random, with tangents or with zeros in their place.
pub fn drawn<T: Plain>(draw: &mut Draw, with: bool) -> T {
    let value = draw.number();
    T::of(value, &mut || if with { draw.number() } else { 0.0 })
}

pub fn parts<T: Plain>(x: &[T]) -> Vec<f64> {
    x.iter().flat_map(|x| x.parts()).collect()
}
