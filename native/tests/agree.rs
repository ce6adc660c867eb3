//! Machine code against an interpreter of the same instructions, on random code, bit for bit.
#![cfg(feature = "jit")]

use gyrospec_native::{Action, Dual, Method, Number, Op, StepCode, Steps};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the interpreter needs of a number.
trait Plain:
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

extern "C" fn sine(x: f64) -> f64 {
    x.sin()
}

extern "C" fn cosine(x: f64, _: f64) -> f64 {
    x.cos()
}

extern "C" fn hypot(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

extern "C" fn hypot_by_a(a: f64, b: f64) -> f64 {
    a / hypot(a, b)
}

extern "C" fn hypot_by_b(a: f64, b: f64) -> f64 {
    b / hypot(a, b)
}

extern "C" fn whole(x: f64, n: i32) -> f64 {
    x.powi(n)
}

extern "C" fn whole_slope(x: f64, n: i32) -> f64 {
    f64::from(n) * x.powi(n - 1)
}

/// 1 where a condition holds, −1 where another does, else 0.
fn side(above: bool, below: bool) -> f64 {
    f64::from(i8::from(above) - i8::from(below))
}

fn interpret<T: Plain>(code: &[Op], r: &mut [T]) {
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
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, n: u64) -> u16 {
        u16::try_from(self.next() % n).expect("small")
    }

    fn number(&mut self) -> f64 {
        f64::from(u32::try_from(self.next() % 2_000_001).expect("small")) / 1e6 - 1.0
    }
}

/// A step of a method without code and registers.
fn empty(method: Method) -> StepCode<'static> {
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
    }
}

const GIVEN: u16 = 8;
const STATES: u16 = 3;

fn random_code(draw: &mut Draw, length: u16) -> Vec<Op> {
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
fn agree(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a == b || (a.is_nan() && b.is_nan()))
}

/// A number at random, with tangents or with zeros in their place.
fn drawn<T: Plain>(draw: &mut Draw, with: bool) -> T {
    let value = draw.number();
    T::of(value, &mut || if with { draw.number() } else { 0.0 })
}

fn parts<T: Plain>(x: &[T]) -> Vec<f64> {
    x.iter().flat_map(|x| x.parts()).collect()
}

/// What a step of each method gives, by rates that are asked for.
struct Stepped<T> {
    x1: Vec<T>,
    rates: Vec<T>,
    last: Vec<T>,
}

/// A register that holds a sign, with tangents where it slides.
const SIGN: u16 = 6;

/// Ten instructions of random code that read what stands before number `first`, and their own results.
fn part(code: &[Op], first: u16, from: usize) -> Vec<Op> {
    let (begin, end) = (GIVEN + first, GIVEN + from as u16);
    // in the place of what other parts made, what was given or made before
    let read = |r: u16| if r >= begin && r < end { r - begin } else { r };
    let one = |op: &Op| {
        let is_whole = matches!(op.action, Action::Whole(..));
        let is_foreign_root = matches!(op.action, Action::Sqrt) && read(op.a) != op.a;
        let action = if is_foreign_root { Action::Square } else { op.action };
        Op { action, a: read(op.a), b: if is_whole { op.b } else { read(op.b) }, c: read(op.c), ..*op }
    };
    code[from..from + 10].iter().map(one).collect()
}

/// Code of a time, of states, and of outputs, motions and slopes, which do not read each other.
fn tried_segments<T: Plain>(seed: u64) -> bool {
    let mut draw = Draw(seed);
    let code = random_code(&mut draw, 50);
    let registers = usize::from(GIVEN) + code.len();
    let states: Vec<u16> = (0..STATES).collect();
    // what a time asks for reads no state and no sign
    let shifted = |op: &Op| {
        let given = |r: u16| if r < STATES { r + STATES } else { r + u16::from(r == SIGN) };
        let b = if matches!(op.action, Action::Whole(..)) { op.b } else { given(op.b) };
        Op { a: given(op.a), b, c: given(op.c), ..*op }
    };
    let time: Vec<Op> = code[..10].iter().map(shifted).collect();
    let middle = &code[10..20];
    let [output, motion, slopes] = [20, 30, 40].map(|from| part(&code, 20, from));
    let rates: Vec<u16> = (0..STATES).map(|k| GIVEN + 10 + k).collect();
    let active: Vec<bool> = (0..registers).map(|k| (3..6).contains(&k)).collect();
    let kept = vec![true; registers];
    let step = StepCode {
        time: &time,
        code: middle,
        output: &output,
        motion: &motion,
        slopes: &slopes,
        states: &states,
        rates: &rates,
        signs: &[SIGN],
        active: &active,
        kept: &kept,
        method: Method::None,
    };
    let Some(steps) = Steps::compile(&step, T::TANGENTS) else { return false };
    assert!(steps.has_slopes());
    let mut number = |with: bool| drawn::<T>(&mut draw, with);
    let zero = T::of(0.0, &mut || 0.0);
    let mut r: Vec<T> =
        (0..registers).map(|k| if k < usize::from(GIVEN) { number(k < 7) } else { zero }).collect();
    let mut own = r.clone();
    let codes = [&time, middle, &output, &motion, &slopes];
    let compiled = [Steps::time, Steps::state, Steps::output, Steps::motion, Steps::slopes];
    for (k, (code, run)) in codes.into_iter().zip(compiled).enumerate() {
        interpret(code, &mut r);
        run(&steps, &mut own);
        assert!(agree(&parts(&own), &parts(&r)), "{seed}: part {k} of a step");
    }
    true
}

fn tried<T: Plain>(seed: u64) -> bool {
    let mut draw = Draw(seed);
    let length = 4 + draw.below(40);
    let code = random_code(&mut draw, length);
    stepped::<T>(seed, draw, &code)
}

/// A choice from choices of what lies in memory, from what was computed, and from both, as a curve's pieces are chosen.
fn tried_choices<T: Plain>(seed: u64) -> bool {
    let op = |action, to, a, b, c| Op { action, to, a, b, c };
    let code = [
        op(Action::Sub, 8, 0, 3, 0),
        op(Action::Select, 9, 8, 4, 7),
        op(Action::Sub, 10, 1, 4, 0),
        op(Action::Select, 11, 10, 5, 9),
        op(Action::Select, 12, 2, 11, 6),
        op(Action::Mul, 13, 0, 12, 0),
        op(Action::Select, 14, 10, 13, 12),
        op(Action::MulAdd, 15, 11, 13, 14),
        op(Action::Select, 16, 8, 0, 12),
    ];
    stepped::<T>(seed, Draw(seed), &code)
}

fn stepped<T: Plain>(seed: u64, mut draw: Draw, code: &[Op]) -> bool {
    let length = u16::try_from(code.len()).expect("short");
    let registers = usize::from(GIVEN + length);
    let states: Vec<u16> = (0..STATES).collect();
    let rates: Vec<u16> = (0..STATES).map(|_| GIVEN + draw.below(u64::from(length))).collect();
    // registers 0, 1, 2 are states; 3 to 5 may have tangents, 6 and 7 have none
    let active: Vec<bool> = (0..registers).map(|k| k < 6).collect();
    let kept = vec![true; registers];
    let with = |method| {
        let step =
            StepCode { code, states: &states, rates: &rates, active: &active, kept: &kept, ..empty(method) };
        Steps::compile(&step, T::TANGENTS)
    };
    let (Some(heun), Some(classical)) = (with(Method::Heun), with(Method::Classical)) else { return false };
    let mut number = |with: bool| drawn::<T>(&mut draw, with);
    let given: Vec<T> = active.iter().map(|with| number(*with)).collect();
    let x: Vec<T> = (0..STATES).map(|_| number(true)).collect();
    let h = 0.01;
    let f = |r: &mut Vec<T>, x: &[T]| -> Vec<T> {
        r[..x.len()].copy_from_slice(x);
        interpret(code, r);
        rates.iter().map(|k| r[usize::from(*k)]).collect()
    };
    let along =
        |x: &[T], k: &[T], h: f64| -> Vec<T> { x.iter().zip(k).map(|(x, k)| *x + k.scale(h)).collect() };
    let mut r = given.clone();
    let k1 = f(&mut r, &x);
    let room = || vec![x[0]; x.len()];
    let mut found = Stepped { x1: room(), rates: room(), last: room() };

    // Heun
    let k2 = f(&mut r, &along(&x, &k1, h));
    let both: Vec<T> = k1.iter().zip(&k2).map(|(a, b)| *a + *b).collect();
    let x1 = along(&x, &both, 0.5 * h);
    let rates1 = f(&mut r, &x1);
    let mut own = given.clone();
    heun.heun(&mut own, (&x, &k1), h, (&mut found.x1, &mut found.rates, &mut found.last));
    assert!(agree(&parts(&found.x1), &parts(&x1)), "{seed}: x₁ of Heun");
    assert!(agree(&parts(&found.rates), &parts(&rates1)), "{seed}: rates after Heun");
    assert!(agree(&parts(&own), &parts(&r)), "{seed}: registers after Heun");
    for (found, wanted) in found.last.iter().zip(&k2) {
        assert!(agree(&[found.value()], &[wanted.value()]), "{seed}: k₂");
    }

    // the classical method
    let k2 = f(&mut r, &along(&x, &k1, 0.5 * h));
    let k3 = f(&mut r, &along(&x, &k2, 0.5 * h));
    let stage = along(&x, &k3, h);
    let k4 = f(&mut r, &stage);
    let all: Vec<T> = (0..x.len()).map(|i| k1[i] + (k2[i] + k3[i]).scale(2.0) + k4[i]).collect();
    let x1 = along(&x, &all, h / 6.0);
    let rates1 = f(&mut r, &x1);
    let (mut own_stage, mut sum, mut own) = (room(), room(), given.clone());
    classical.first_half(&own, &x, &k1, h, &mut own_stage, &mut sum);
    assert!(agree(&parts(&own), &parts(&given)), "{seed}: the first half leaves the registers");
    assert!(agree(&parts(&own_stage), &parts(&stage)), "{seed}: the last stage");
    classical.second_half(
        &mut own,
        (&x, &own_stage, &sum),
        h,
        (&mut found.x1, &mut found.rates, &mut found.last),
    );
    assert!(agree(&parts(&found.x1), &parts(&x1)), "{seed}: x₁ of the classical method");
    assert!(agree(&parts(&found.rates), &parts(&rates1)), "{seed}: rates after the classical method");
    assert!(agree(&parts(&own), &parts(&r)), "{seed}: registers after the classical method");
    for (found, wanted) in found.last.iter().zip(&k4) {
        assert!(agree(&[found.value()], &[wanted.value()]), "{seed}: k₄");
    }
    true
}

#[test]
fn machine_code_agrees_with_the_interpreter_on_random_code() {
    let mut compiled = 0;
    for seed in 0..300 {
        compiled += usize::from(tried::<f64>(seed));
        compiled += usize::from(tried::<Dual<2>>(seed));
        compiled += usize::from(tried::<Dual<4>>(seed));
        compiled += usize::from(tried::<Dual<8>>(seed));
    }
    if compiled == 0 {
        println!("SKIPPED: this machine takes no machine code");
    } else {
        assert_eq!(compiled, 4 * 300);
    }
}

#[test]
fn the_code_of_each_part_of_a_step_agrees_too() {
    let all = |seed| {
        let by_kind =
            [tried_segments::<f64>(seed), tried_segments::<Dual<2>>(seed), tried_segments::<Dual<8>>(seed)];
        by_kind.into_iter().filter(|c| *c).count()
    };
    let compiled: usize = (1000..1200).map(all).sum();
    assert!(compiled == 0 || compiled == 600, "{compiled} of 600 compiled");
}

#[test]
fn code_that_names_registers_that_are_not_there_is_refused() {
    let op = |to, a| Op { action: Action::Negative, to, a, b: 0, c: 0 };
    let step = |code: &[Op], states: &[u16], rates: &[u16], registers: usize, tangents: usize| {
        let (active, kept) = (vec![true; registers], vec![true; registers]);
        let step = StepCode { code, states, rates, active: &active, kept: &kept, ..empty(Method::Classical) };
        Steps::compile(&step, tangents).is_none()
    };
    assert!(step(&[op(2, 0)], &[0], &[1], 2, 0), "a result beyond the registers");
    assert!(step(&[op(1, 2)], &[0], &[1], 2, 0), "an operand beyond the registers");
    assert!(step(&[op(1, 0)], &[2], &[1], 2, 0), "a state beyond the registers");
    assert!(step(&[op(1, 0)], &[0], &[2], 2, 0), "a rate beyond the registers");
    assert!(step(&[op(1, 0)], &[0], &[], 2, 0), "fewer rates than states");
    assert!(step(&[op(1, 0)], &[0], &[1], 2, 3), "an odd number of tangents");
}

#[test]
#[should_panic(expected = "as many as states")]
fn arrays_of_a_wrong_length_are_refused() {
    let code = [Op { action: Action::Negative, to: 1, a: 0, b: 0, c: 0 }];
    let step = StepCode {
        code: &code,
        states: &[0],
        rates: &[1],
        active: &[true; 2],
        kept: &[true; 2],
        ..empty(Method::Classical)
    };
    let Some(steps) = Steps::compile(&step, 0) else {
        panic!("as many as states: this machine takes no machine code")
    };
    steps.first_half(&[0.0; 2], &[0.0; 2], &[0.0], 0.1, &mut [0.0], &mut [0.0]);
}

#[test]
#[should_panic(expected = "compiled for another method")]
fn a_step_of_another_method_is_refused() {
    let Some(steps) = Steps::compile(&empty(Method::Heun), 0) else {
        panic!("compiled for another method: this machine takes no machine code")
    };
    steps.first_half::<f64>(&[], &[], &[], 0.1, &mut [], &mut []);
}

#[test]
fn signs_steps_and_roots_of_zeros_and_of_no_number() {
    let op = |action, to| Op { action, to, a: 0, b: 0, c: 0 };
    let time = [op(Action::Sign, 1), op(Action::SignOrOne, 2), op(Action::Step, 3), op(Action::Sqrt, 4)];
    let step = StepCode { time: &time, active: &[true; 5], kept: &[true; 5], ..empty(Method::Heun) };
    let Some(steps) = Steps::compile(&step, 2) else { return };
    for (x, wanted) in [
        (4.0, [1.0, 1.0, 1.0, 2.0, 0.25]),
        (0.0, [0.0, 1.0, 1.0, 0.0, 0.0]),
        (-0.0, [0.0, 1.0, 1.0, 0.0, 0.0]),
        (-4.0, [-1.0, -1.0, 0.0, f64::NAN, f64::NAN]),
        (f64::NAN, [0.0, 0.0, 0.0, f64::NAN, f64::NAN]),
    ] {
        let mut r = [Dual::<2> { value: 0.0, tangents: [0.0; 2] }; 5];
        r[0] = Dual { value: x, tangents: [1.0, 0.0] };
        steps.time(&mut r);
        let [_, sign, or_one, above, root] = r;
        let found = [sign.value, or_one.value, above.value, root.value, root.tangents[0]];
        assert!(agree(&found, &wanted), "{x}: {found:?}");
        assert_eq!([sign.tangents, or_one.tangents, above.tangents], [[0.0; 2]; 3]);
    }
}

#[test]
fn what_is_chosen_from_choices_is_the_same() {
    let kinds = [tried_choices::<f64>, tried_choices::<Dual<2>>, tried_choices::<Dual<8>>];
    let compiled = (0..100).flat_map(|seed| kinds.map(|tried| tried(seed))).filter(|made| *made).count();
    if compiled == 0 {
        println!("SKIPPED: this machine takes no machine code");
    } else {
        assert_eq!(compiled, 3 * 100);
    }
}
