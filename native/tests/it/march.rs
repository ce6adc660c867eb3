//! Steps in one loop of machine code against the same steps one by one, on random code, bit for bit.

use crate::common::{Draw, GIVEN, Plain, STATES, agree, care, drawn, empty, parts, random_code};
use gyrospec_native::{
    Action, BEGIN, Dual, JUMP, March, MarchCode, Mark, Method, Op, StepCode, Steps, Switch,
};

/// Registers that are loaded for every stage, plain; the one that is held; the sign of the switch; a parameter.
const LOADED: [u16; 2] = [3, 4];
const HELD: u16 = 5;
const SIGN: u16 = 6;

const STEPS: usize = 40;

/// Random code in three parts: of a time, which reads no state, of the states, and of the outputs.
struct Parts {
    time: Vec<Op>,
    code: Vec<Op>,
    output: Vec<Op>,
    rates: Vec<u16>,
    written: Vec<Vec<u16>>,
    guard: u16,
    next: u16,
    active: Vec<bool>,
}

fn random_parts(draw: &mut Draw) -> Parts {
    let all = random_code(draw, 30);
    let shifted = |op: &Op| {
        let given = |r: u16| match r {
            0..STATES => 3 + r % 2,
            HELD | SIGN => 7,
            other => other,
        };
        let b = if matches!(op.action, Action::Whole(..)) { op.b } else { given(op.b) };
        Op { a: given(op.a), b, c: given(op.c), ..*op }
    };
    let made = |draw: &mut Draw, from: u16, count: u64| GIVEN + from + draw.below(count);
    Parts {
        time: all[..8].iter().map(shifted).collect(),
        code: all[8..20].to_vec(),
        output: all[20..].to_vec(),
        rates: (0..STATES).map(|_| made(draw, 8, 12)).collect(),
        written: vec![vec![0, made(draw, 20, 10)], vec![made(draw, 8, 12)]],
        guard: made(draw, 8, 12),
        next: made(draw, 8, 12),
        active: (0..GIVEN + 30).map(|k| k == HELD || k == 7).collect(),
    }
}

fn right<T: Plain>(r: &[T], guard: u16) -> bool {
    r[usize::from(guard)].value() * r[usize::from(SIGN)].value() >= 0.0
}

/// Whether it may stand: every state small, every rate finite, and the switch right.
fn stands<T: Plain>(x: &[T], k: &[T], r: &[T], guard: u16) -> bool {
    right(r, guard) && x.iter().all(|x| x.value().abs() <= 1e100) && k.iter().all(|k| k.value().is_finite())
}

struct Course<T> {
    r: Vec<T>,
    x: Vec<T>,
    k: Vec<T>,
    measures: Vec<f64>,
    lists: [Vec<T>; 2],
    taken: usize,
}

/// What a march is given.
struct Way {
    h: Vec<f64>,
    rows: Vec<f64>,
    jumps: Vec<f64>,
    marks: Vec<Mark>,
    method: Method,
}

fn random_way(draw: &mut Draw, method: Method, jumps: bool) -> Way {
    let mark = |draw: &mut Draw| {
        let begin = if jumps && draw.below(3) == 0 { JUMP | draw.below(4) << BEGIN } else { 0 };
        begin | draw.below(4)
    };
    let marks: Vec<Mark> = (0..STEPS).map(|_| mark(draw)).collect();
    let count = marks.iter().filter(|m| **m & JUMP != 0).count();
    let mut numbers = |n: usize| -> Vec<f64> { (0..n).map(|_| draw.number()).collect() };
    Way {
        h: numbers(STEPS).iter().map(|x| 0.01 + 0.005 * x).collect(),
        rows: numbers(STEPS * method.stages() * LOADED.len()),
        jumps: numbers(count * LOADED.len()),
        marks,
        method,
    }
}

fn load<T: Plain>(steps: &Steps, r: &mut [T], rows: &[f64], row: usize) {
    for (j, register) in LOADED.iter().enumerate() {
        r[usize::from(*register)] = T::of(rows[row * LOADED.len() + j], &mut || 0.0);
    }
    steps.time(r);
}

impl<T: Plain> Course<T> {
    fn note(&mut self, p: &Parts, steps: &Steps, mark: Mark) {
        steps.output(&mut self.r);
        for (j, list) in self.lists.iter_mut().enumerate().filter(|(j, _)| mark >> j & 1 == 1) {
            list.extend(p.written[j].iter().map(|r| self.r[usize::from(*r)]));
        }
    }

    /// The rates after a jump; whether the switch is right there.
    fn jump(&mut self, p: &Parts, steps: &Steps, (rows, row): (&[f64], usize)) -> bool {
        load(steps, &mut self.r, rows, row);
        self.r[..self.x.len()].copy_from_slice(&self.x);
        steps.state(&mut self.r);
        self.k = p.rates.iter().map(|k| self.r[usize::from(*k)]).collect();
        right(&self.r, p.guard)
    }

    /// Step by step.
    fn walked(mut self, p: &Parts, steps: &Steps, way: &Way) -> Self {
        let n = self.x.len();
        let stages = way.method.stages();
        let zero = T::of(0.0, &mut || 0.0);
        let mut jumps = 0;
        for (i, h) in way.h.iter().copied().enumerate() {
            if way.marks[i] & JUMP != 0 {
                if !self.jump(p, steps, (&way.jumps, jumps)) {
                    break;
                }
                self.note(p, steps, way.marks[i] >> BEGIN);
                jumps += 1;
            }
            let (mut x1, mut k1, mut last) = (vec![zero; n], vec![zero; n], vec![zero; n]);
            load(steps, &mut self.r, &way.rows, i * stages);
            let weight = if way.method == Method::Classical {
                let (mut stage, mut sum) = (vec![zero; n], vec![zero; n]);
                steps.first_half(&self.r, &self.x, &self.k, h, &mut stage, &mut sum);
                load(steps, &mut self.r, &way.rows, i * stages + 1);
                let from = (self.x.as_slice(), stage.as_slice(), sum.as_slice());
                steps.second_half(&mut self.r, from, h, (&mut x1, &mut k1, &mut last));
                h / 6.0
            } else {
                steps.heun(&mut self.r, (&self.x, &self.k), h, (&mut x1, &mut k1, &mut last));
                h / 2.0
            };
            if !stands(&x1, &k1, &self.r, p.guard) {
                break;
            }
            for s in 0..n {
                let (x, m) = (x1[s].value(), &mut self.measures);
                m[s] += weight * (last[s].value() - k1[s].value()).abs();
                m[n + s] = if x < m[n + s] { x } else { m[n + s] };
                m[2 * n + s] = if x > m[2 * n + s] { x } else { m[2 * n + s] };
            }
            (self.x, self.k) = (x1, k1);
            self.r[usize::from(HELD)] = self.r[usize::from(p.next)];
            self.note(p, steps, way.marks[i]);
            self.taken += 1;
        }
        self
    }
}

/// The number of steps that were taken; none where nothing is compiled.
fn tried<T: Plain>(seed: u64, method: Method) -> Option<usize> {
    let jumps = seed % 2 == 1;
    let mut draw = Draw(seed);
    let p = random_parts(&mut draw);
    let states: Vec<u16> = (0..STATES).collect();
    let kept = vec![true; p.active.len()];
    let step = StepCode {
        time: &p.time,
        code: &p.code,
        output: &p.output,
        states: &states,
        rates: &p.rates,
        active: &p.active,
        kept: &kept,
        care: care(seed),
        ..empty(method)
    };
    let code = MarchCode {
        loaded: &LOADED,
        switches: &[Switch { sign: SIGN, guard: p.guard, is_strict: false }],
        held: &[(HELD, p.next)],
        written: &p.written,
        jumps,
    };
    let (steps, march) = (Steps::compile(&step, T::TANGENTS)?, March::compile(&step, &code, T::TANGENTS)?);
    let zero = T::of(0.0, &mut || 0.0);
    let mut r: Vec<T> = vec![zero; p.active.len()];
    (r[usize::from(HELD)], r[7]) = (drawn(&mut draw, true), drawn(&mut draw, true));
    let x: Vec<T> = states.iter().map(|_| drawn(&mut draw, true)).collect();
    let k: Vec<T> = states.iter().map(|_| drawn(&mut draw, true)).collect();
    let way = random_way(&mut draw, method, jumps);
    r[usize::from(SIGN)] = T::of(if draw.number() > 0.0 { 1.0 } else { -1.0 }, &mut || 0.0);
    let begins = [0.0, f64::INFINITY, f64::NEG_INFINITY];
    let measures: Vec<f64> = begins.iter().flat_map(|b| vec![*b; x.len()]).collect();
    let course = Course { r, x, k, measures, lists: [Vec::new(), Vec::new()], taken: 0 };
    let (mut r, mut x, mut k) = (course.r.clone(), course.x.clone(), course.k.clone());
    let mut measures = course.measures.clone();
    let wanted = course.walked(&p, &steps, &way);
    let mut lists = [vec![zero; 4 * STEPS], vec![zero; 2 * STEPS]];
    let [first, second] = &mut lists;
    let all = (&way.h[..], &way.rows[..], &way.jumps[..], &way.marks[..]);
    let taken = march.run((&mut r, &mut x, &mut k), all, &mut measures, &mut [first, second]);
    assert_eq!(taken, wanted.taken, "{seed}");
    assert!(agree(&parts(&x), &parts(&wanted.x)), "{seed}: states");
    // after a jump the rates of a step that is not taken are those that its caller finds as well
    let is_between = taken == STEPS || way.marks[taken] & JUMP == 0;
    assert!(!is_between || agree(&parts(&k), &parts(&wanted.k)), "{seed}: rates");
    assert!(agree(&measures, &wanted.measures), "{seed}: measures");
    for (list, wanted) in lists.iter().zip(&wanted.lists) {
        assert!(agree(&parts(&list[..wanted.len()]), &parts(wanted)), "{seed}: lists");
        let untouched = parts(&list[wanted.len()..]);
        assert!(!is_between || untouched.iter().all(|x| *x == 0.0), "{seed}: nothing beyond");
    }
    let held = |r: &[T]| parts(&r[usize::from(HELD)..=usize::from(HELD)]);
    assert!(taken < STEPS || agree(&held(&r), &held(&wanted.r)), "{seed}: what is held");
    Some(taken)
}

#[test]
fn a_march_is_its_steps() {
    let mut taken = Vec::new();
    for seed in 0..100 {
        for method in [Method::Classical, Method::Heun] {
            let all =
                [tried::<f64>(seed, method), tried::<Dual<2>>(seed, method), tried::<Dual<8>>(seed, method)];
            taken.extend(all.into_iter().flatten());
        }
    }
    if taken.is_empty() {
        println!("SKIPPED: this machine takes no machine code");
        return;
    }
    assert_eq!(taken.len(), 6 * 100);
    let count = |f: &dyn Fn(usize) -> bool| taken.iter().filter(|t| f(**t)).count();
    assert!(count(&|t| t == STEPS) > 50, "some go to the end");
    assert!(count(&|t| t > 0 && t < STEPS) > 50, "some end at an event");
    assert!(count(&|t| t == 0) > 50, "some do not begin");
}

#[test]
fn a_march_that_names_registers_that_are_not_there_is_refused() {
    let step = StepCode { active: &[true; 2], kept: &[true; 2], ..empty(Method::Heun) };
    let none = MarchCode { loaded: &[], switches: &[], held: &[], written: &[], jumps: false };
    let refused = |code: MarchCode<'_>| March::compile(&step, &code, 0).is_none();
    assert!(refused(MarchCode { loaded: &[2], ..none }), "a loaded one beyond the registers");
    assert!(refused(MarchCode { held: &[(0, 2)], ..none }), "a held one beyond the registers");
    assert!(refused(MarchCode { written: &[vec![2]], ..none }), "a written one beyond the registers");
    let switch = Switch { sign: 0, guard: 2, is_strict: false };
    assert!(refused(MarchCode { switches: &[switch], ..none }), "a guard beyond the registers");
    let many = vec![Vec::new(); gyrospec_native::LISTS + 1];
    assert!(refused(MarchCode { written: &many, ..none }), "more lists than bits");
    assert!(March::compile(&StepCode { method: Method::None, ..step.clone() }, &none, 0).is_none());
}

#[test]
#[should_panic(expected = "room for all entries")]
fn a_list_that_is_too_short_is_refused() {
    let step = StepCode { active: &[false; 1], kept: &[true; 1], ..empty(Method::Heun) };
    let code = MarchCode { loaded: &[], switches: &[], held: &[], written: &[vec![0]], jumps: false };
    let Some(march) = March::compile(&step, &code, 0) else {
        panic!("room for all entries: this machine takes no machine code")
    };
    march.run((&mut [0.0; 1], &mut [], &mut []), (&[0.1; 2], &[], &[], &[1, 1]), &mut [], &mut [&mut [0.0]]);
}

/// A strict switch may not come to rest on its guard.
#[test]
fn a_guard_of_zero_ends_a_strict_march() {
    for (is_strict, sign, guard, expected) in [
        (false, 1.0, 0.0, 1),
        (true, 1.0, 0.0, 0),
        (true, 1.0, 2.0, 1),
        (false, 0.0, 0.0, 1),
        (false, 0.0, 2.0, 0),
    ] {
        let step = StepCode { active: &[false; 2], kept: &[true; 2], ..empty(Method::Heun) };
        let switches = [Switch { sign: 0, guard: 1, is_strict }];
        let code = MarchCode { loaded: &[], switches: &switches, held: &[], written: &[], jumps: false };
        let Some(march) = March::compile(&step, &code, 0) else { return };
        let mut r = [sign, guard];
        let taken = march.run((&mut r, &mut [], &mut []), (&[0.1], &[], &[], &[0]), &mut [], &mut []);
        assert_eq!(taken, expected, "{is_strict} {sign} {guard}");
    }
}
