//! Machine code against an interpreter of the same instructions, on random code, bit for bit.

use crate::common::{Draw, GIVEN, Plain, STATES, agree, care, drawn, empty, interpret, parts, random_code};
use gyrospec_native::{Action, Dual, Method, Op, StepCode, Steps};

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
        care: care(seed),
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
        let step = StepCode {
            code,
            states: &states,
            rates: &rates,
            active: &active,
            kept: &kept,
            care: care(seed),
            ..empty(method)
        };
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
