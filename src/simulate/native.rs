//! # Purpose
//! The steps of a program as machine code: made once a program and kind of number, kept beside the program.
//!
//! # Method
//! Compiling costs as much as some thousands of steps save, so that short work is interpreted; what goes on is compiled once
//! more, with more care. What the code needs to know of the numbers is which registers may have tangents: a parameter that
//! is not asked for has none, nor has what was measured, nor what is made of these.
//!
//! # Numerical aspects
//! Machine code and interpreter give the same values (`gyrospec_native`), so that neither the machine nor the amount of
//! work shows in a result.

use super::probe::Clock;
use super::steps::Solver;
use super::{functions, tabulate};
use crate::expression::Function;
use crate::model::Scalar;
use crate::model::program::{Action, Op, Program, Register, Remembered, Watch};
use gyrospec_native::{Care, LISTS, March, MarchCode, Method, StepCode, Steps, Switch, spread};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// Steps that pay for compiling.
const WORTH: usize = 4000;
/// Times as many that pay for doing so with care.
const LONG: usize = 40;
/// Kinds of numbers of one program that are kept.
const MOST: usize = 16;

/// What was compiled of a program.
#[derive(Debug)]
pub(super) struct Natives {
    /// Steps that pay for compiling.
    worth: usize,
    kinds: Mutex<Vec<Arc<Kind>>>,
}

impl Default for Natives {
    fn default() -> Self {
        Self { worth: WORTH, kinds: Mutex::default() }
    }
}

/// One kind of number on one program.
#[derive(Debug)]
pub(super) struct Kind {
    worth: usize,
    tangents: usize,
    method: Method,
    /// The registers that may have tangents.
    active: Vec<bool>,
    /// The registers that are written down, clock by clock.
    written: Vec<Vec<Register>>,
    /// Whether inputs jump.
    jumps: bool,
    /// Whether steps without events are nothing but steps: no input is delayed, no past asked for, the method explicit.
    is_marchable: bool,
    /// Steps that were asked for, and those of them that nothing marched over.
    asked: AtomicUsize,
    alone: AtomicUsize,
    /// What compiling gave, once it was tried: with little care, and with much.
    steps: [OnceLock<Option<Steps>>; 2],
    march: [OnceLock<Option<March>>; 2],
}

/// How code is compiled, first and once it has proved long.
const CARE: [Care; 2] = [Care::Little, Care::Much];

impl Kind {
    /// The machine code of single steps; none where they are better interpreted.
    pub fn single(&self, program: &Program) -> Option<&Steps> {
        let of = self.tier(&self.alone)?;
        self.steps[of].get_or_init(|| compiled(program, self, CARE[of])).as_ref()
    }

    /// The machine code of many steps; none where they are better taken one by one.
    pub fn march(&self, program: &Program) -> Option<&March> {
        let of = self.tier(&self.asked)?;
        self.march[of].get_or_init(|| marched(program, self, CARE[of])).as_ref()
    }

    /// With how much care so many steps are worth compiling; none where they are better interpreted.
    fn tier(&self, steps: &AtomicUsize) -> Option<usize> {
        let steps = steps.load(Ordering::Relaxed);
        (steps >= self.worth).then(|| usize::from(steps >= self.worth.saturating_mul(LONG)))
    }

    /// Counts the steps that a run took one by one though it might have marched.
    pub fn count_single(&self, steps: usize) {
        if self.is_marchable {
            self.alone.fetch_add(steps, Ordering::Relaxed);
        }
    }
}

impl Natives {
    /// The machine code for a run of so many steps of a method with these registers, over inputs that jump or do not, once
    /// it is worth compiling.
    pub fn of<T: Scalar>(
        &self,
        program: &Program,
        parameters: &[T],
        (clocks, jumps): (&[Clock], bool),
        (solver, steps): (Solver, usize),
    ) -> Option<Arc<Kind>> {
        if !Steps::MADE {
            return None;
        }
        let active = active(program, parameters)?;
        let method = method(program, solver);
        let mut kinds = self.kinds.lock().unwrap_or_else(PoisonError::into_inner);
        let same = |k: &Arc<Kind>| {
            let written = k.written.iter().zip(clocks).all(|(w, c)| *w == c.registers);
            let looks_alike = k.written.len() == clocks.len() && k.jumps == jumps;
            k.tangents == T::TANGENTS && k.method == method && k.active == active && written && looks_alike
        };
        let is_delayed = program.columns.iter().any(|c| c.delay.is_some());
        let at = kinds.iter().position(same).unwrap_or_else(|| {
            kinds.truncate(MOST - 1);
            let kind = Kind {
                worth: self.worth,
                tangents: T::TANGENTS,
                method,
                active,
                written: clocks.iter().map(|c| c.registers.clone()).collect(),
                jumps,
                is_marchable: method != Method::None && !is_delayed && clocks.len() <= LISTS,
                asked: AtomicUsize::new(0),
                alone: AtomicUsize::new(0),
                steps: Default::default(),
                march: Default::default(),
            };
            kinds.insert(0, Arc::new(kind));
            0
        });
        let kind = &kinds[at];
        kind.asked.fetch_add(steps, Ordering::Relaxed);
        if !kind.is_marchable {
            kind.alone.fetch_add(steps, Ordering::Relaxed);
        }
        Some(kind.clone())
    }
}

fn at(register: Register) -> usize {
    usize::from(register)
}

/// Which registers may have tangents when the code of a time begins.
fn active<T: Scalar>(program: &Program, parameters: &[T]) -> Option<Vec<bool>> {
    let mut active = vec![false; program.registers];
    if T::TANGENTS == 0 {
        return Some(active);
    }
    for (register, p) in program.parameters.iter().zip(parameters) {
        if let Some(a) = active.get_mut(at(*register)) {
            *a = (0..T::TANGENTS).any(|d| p.tangent(d) != 0.0);
        }
    }
    spread(&translated(&program.once)?, &mut active);
    for column in &program.columns {
        active[at(column.value)] = column.delay.is_some_and(|d| active[at(d)]);
    }
    for m in &program.remembered {
        match *m {
            Remembered::Hidden { .. } => {}
            Remembered::Held { held, .. } => active[at(held)] = true,
            Remembered::Past { value, slope, .. } => {
                active[at(value)] = true;
                active[at(slope)] = true;
            }
        }
    }
    spread(&translated(&program.per_data)?, &mut active);
    Some(active)
}

/// What of a step is one function: none where the past of a signal is asked for within it.
fn method(program: &Program, solver: Solver) -> Method {
    if program.remembered.iter().any(|m| matches!(m, Remembered::Past { .. })) {
        return Method::None;
    }
    match solver {
        Solver::Explicit => Method::Classical,
        Solver::Heun => Method::Heun,
        Solver::Stiff => Method::None,
    }
}

/// The code of a step in the words of the package that compiles.
struct Translated {
    time: Vec<gyrospec_native::Op>,
    rates: Vec<gyrospec_native::Op>,
    output: Vec<gyrospec_native::Op>,
    motion: Vec<gyrospec_native::Op>,
    slopes: Vec<gyrospec_native::Op>,
    signs: Vec<Register>,
    kept: Vec<bool>,
}

impl Translated {
    fn of(program: &Program, method: Method) -> Option<Self> {
        let slopes: &[Op] = if method == Method::None { &program.jacobian_code } else { &[] };
        Some(Self {
            time: translated(&program.per_time)?,
            rates: translated(&program.per_state)?,
            output: translated(&program.output_code)?,
            motion: translated(&program.motion_code)?,
            slopes: translated(slopes)?,
            signs: program.watches.iter().map(|w| w.sign).collect(),
            kept: program.read_by(&[&program.output_code, &program.motion_code, slopes]),
        })
    }

    fn step<'a>(&'a self, program: &'a Program, kind: &'a Kind, care: Care) -> StepCode<'a> {
        StepCode {
            time: &self.time,
            code: &self.rates,
            output: &self.output,
            motion: &self.motion,
            slopes: &self.slopes,
            states: &program.states,
            rates: &program.rates,
            signs: &self.signs,
            active: &kind.active,
            kept: &self.kept,
            method: kind.method,
            care,
        }
    }
}

fn compiled(program: &Program, kind: &Kind, care: Care) -> Option<Steps> {
    Steps::compile(&Translated::of(program, kind.method)?.step(program, kind, care), kind.tangents)
}

fn marched(program: &Program, kind: &Kind, care: Care) -> Option<March> {
    if !kind.is_marchable {
        return None;
    }
    let code = Translated::of(program, kind.method)?;
    let switch = |w: &Watch| Switch { sign: w.sign, guard: w.guard, is_strict: w.timed };
    let moved = |m: &Remembered| match *m {
        Remembered::Held { held, next, .. } => Some((held, next)),
        _ => None,
    };
    let march = MarchCode {
        loaded: &tabulate::registers(program, true),
        switches: &program.watches.iter().map(switch).collect::<Vec<_>>(),
        held: &program.remembered.iter().filter_map(moved).collect::<Vec<_>>(),
        written: &kind.written,
        jumps: kind.jumps,
    };
    March::compile(&code.step(program, kind, care), &march, kind.tangents)
}

/// Code in the words of the package that compiles, without the signs that the simulation holds.
fn translated(code: &[Op]) -> Option<Vec<gyrospec_native::Op>> {
    let held = |op: &&Op| !matches!(op.action, Action::Sign | Action::Relay);
    code.iter().filter(held).map(native).collect()
}

/// An instruction in the words of the package that compiles.
fn native(op: &Op) -> Option<gyrospec_native::Op> {
    use gyrospec_native::Action as Native;
    let action = match op.action {
        Action::Add => Native::Add,
        Action::Sub => Native::Sub,
        Action::Mul => Native::Mul,
        Action::Div => Native::Div,
        Action::Negative => Native::Negative,
        Action::MulAdd => Native::MulAdd,
        Action::MulSub => Native::MulSub,
        Action::Square => Native::Square,
        Action::Cube => Native::Cube,
        Action::Select => Native::Select,
        Action::Pow => functions::power(),
        Action::Atan2 => functions::atan2(),
        Action::Whole => functions::whole(),
        Action::SignNow if op.b == 0 => Native::Sign,
        Action::SignNow => Native::SignOrOne,
        Action::One(Function::Sign) => Native::Sign,
        Action::One(Function::Step) => Native::Step,
        Action::One(Function::Sqrt) => Native::Sqrt,
        Action::One(f) => functions::one(f)?,
        Action::Sign | Action::Relay | Action::Foreign | Action::ForeignSlope => return None,
    };
    Some(gyrospec_native::Op { action, to: op.to, a: op.a, b: op.b, c: op.c })
}

#[cfg(test)]
mod tests;
