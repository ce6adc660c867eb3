//! # Purpose
//! The steps of a program as machine code: made once a program and kind of number, kept beside the program.
//!
//! # Method
//! Compiling costs as much as some thousands of steps save, so that short work is interpreted. What the code needs to
//! know of the numbers is which registers may have tangents: a parameter that is not asked for has none, nor has what
//! was measured, nor what is made of these.
//!
//! # Numerical aspects
//! Machine code and interpreter give the same values (`gyrospec_native`), so that neither the machine nor the amount of
//! work shows in a result.

use super::steps::Solver;
use crate::expression::Function;
use crate::model::Scalar;
use crate::model::program::{Action, Op, Program, Register, Remembered, slope, whole_power_parts};
use gyrospec_native::{Method, StepCode, Steps, spread};
use std::cell::OnceCell;
use std::sync::{Arc, Mutex, PoisonError};

/// Steps that pay for compiling.
const WORTH: usize = 4000;
/// Kinds of numbers of one program that are kept.
const MOST: usize = 16;

/// What was compiled of a program.
#[derive(Debug)]
pub(super) struct Natives {
    /// Steps that pay for compiling.
    worth: usize,
    kinds: Mutex<Vec<Kind>>,
}

impl Default for Natives {
    fn default() -> Self {
        Self { worth: WORTH, kinds: Mutex::default() }
    }
}

/// One kind of number on one program.
#[derive(Debug)]
struct Kind {
    tangents: usize,
    method: Method,
    /// The registers that may have tangents.
    active: Vec<bool>,
    /// Steps that were interpreted.
    steps: usize,
    /// What compiling gave, once it was tried.
    compiled: OnceCell<Option<Arc<Steps>>>,
}

impl Natives {
    /// The machine code for a run of so many steps of a method with these registers; none where the run is better
    /// interpreted.
    pub fn of<T: Scalar>(
        &self,
        program: &Program,
        parameters: &[T],
        (solver, steps): (Solver, usize),
    ) -> Option<Arc<Steps>> {
        if !Steps::MADE {
            return None;
        }
        let active = active(program, parameters)?;
        let method = method(program, solver);
        let mut kinds = self.kinds.lock().unwrap_or_else(PoisonError::into_inner);
        let same = |k: &Kind| k.tangents == T::TANGENTS && k.method == method && k.active == active;
        let at = kinds.iter().position(same).unwrap_or_else(|| {
            kinds.truncate(MOST - 1);
            let (tangents, compiled) = (T::TANGENTS, OnceCell::new());
            kinds.insert(0, Kind { tangents, method, active, steps: 0, compiled });
            0
        });
        let kind = &mut kinds[at];
        kind.steps = kind.steps.saturating_add(steps);
        if kind.compiled.get().is_none() && kind.steps < self.worth {
            return None;
        }
        kind.compiled
            .get_or_init(|| compiled(program, &kind.active, (method, kind.tangents)).map(Arc::new))
            .clone()
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

fn compiled(program: &Program, active: &[bool], (method, tangents): (Method, usize)) -> Option<Steps> {
    let slopes: &[Op] = if method == Method::None { &program.jacobian_code } else { &[] };
    let signs: Vec<Register> = program.watches.iter().map(|w| w.sign).collect();
    let step = StepCode {
        time: &translated(&program.per_time)?,
        code: &translated(&program.per_state)?,
        output: &translated(&program.output_code)?,
        motion: &translated(&program.motion_code)?,
        slopes: &translated(slopes)?,
        states: &program.states,
        rates: &program.rates,
        signs: &signs,
        active,
        kept: &program.read_by(&[&program.output_code, &program.motion_code, slopes]),
        method,
    };
    Steps::compile(&step, tangents)
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
        Action::Pow => Native::Two(power, power_by_base, power_by_exponent),
        Action::Atan2 => Native::Two(atan2, atan2_by_y, atan2_by_x),
        Action::Whole => Native::Whole(whole, whole_slope),
        Action::SignNow if op.b == 0 => Native::Sign,
        Action::SignNow => Native::SignOrOne,
        Action::One(Function::Sign) => Native::Sign,
        Action::One(Function::Step) => Native::Step,
        Action::One(Function::Sqrt) => Native::Sqrt,
        Action::One(f) => one(f)?,
        Action::Sign | Action::Relay | Action::Foreign | Action::ForeignSlope => return None,
    };
    Some(gyrospec_native::Op { action, to: op.to, a: op.a, b: op.b, c: op.c })
}

extern "C" fn power(a: f64, b: f64) -> f64 {
    a.power(b)
}

/// ∂aᵇ/∂a
extern "C" fn power_by_base(a: f64, b: f64) -> f64 {
    crate::model::power_slopes(a, b).0
}

/// ∂aᵇ/∂b
extern "C" fn power_by_exponent(a: f64, b: f64) -> f64 {
    crate::model::power_slopes(a, b).1
}

extern "C" fn atan2(y: f64, x: f64) -> f64 {
    y.atan2(x)
}

extern "C" fn atan2_by_y(y: f64, x: f64) -> f64 {
    x / (y * y + x * x)
}

extern "C" fn atan2_by_x(y: f64, x: f64) -> f64 {
    -y / (y * y + x * x)
}

extern "C" fn whole(x: f64, n: i32) -> f64 {
    whole_power_parts(x, n).0
}

extern "C" fn whole_slope(x: f64, n: i32) -> f64 {
    whole_power_parts(x, n).1
}

/// Functions of one argument with their slopes.
macro_rules! functions {
    ($($name:ident),*) => {
        fn one(f: Function) -> Option<gyrospec_native::Action> {
            match f {
                $(Function::$name => {
                    extern "C" fn value(x: f64) -> f64 {
                        Function::$name.of(&[x])
                    }
                    extern "C" fn by(x: f64, y: f64) -> f64 {
                        slope(Function::$name, x, y)
                    }
                    Some(gyrospec_native::Action::One(value, by))
                })*
                _ => None,
            }
        }
    };
}

functions!(Sin, Cos, Tan, Asin, Acos, Atan, Sinh, Cosh, Tanh, Exp, Ln, Abs);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::record::{Channel, Recording};
    use crate::simulate::{Options, Simulator, Unknown};
    use crate::units::Unit;

    /// A body on a spring between an input's sine and dry friction, which sticks and slips.
    const STICKING: &str = r#"
        name = "sticking"
        [inputs]
        force = { unit = "N" }
        [parameters]
        m = { value = 2, unit = "kg" }
        c = { value = 30, unit = "N/m" }
        r = { value = 1.5, unit = "N*s/m" }
        F = { value = 4, unit = "N" }
        [states]
        q = { rate = "v", unit = "m", initial = 0.1 }
        v = { rate = "(force - c*q - r*v - F*sign(v))/m", unit = "m/s", initial = 0 }
        [outputs]
        place = { equals = "q", unit = "m" }
    "#;

    /// A fast lag before a slow one with friction, which only the stiff method runs.
    const STIFF: &str = r#"
        name = "stiff"
        [inputs]
        force = { unit = "N" }
        [parameters]
        T = { value = 1e-5, unit = "s" }
        r = { value = 1.5, unit = "N*s/m" }
        F = { value = 2, unit = "N" }
        m = { value = 2, unit = "kg" }
        [states]
        pull = { rate = "(force*(1 + 0.1*tanh(force/F)) - pull)/T", unit = "N", initial = 0 }
        v = { rate = "(pull - r*v - F*sign(v))/m", unit = "m/s", initial = 0 }
        [outputs]
        speed = { equals = "v", unit = "m/s" }
    "#;

    /// A loop that is closed late.
    const LATE: &str = r#"
        name = "late"
        [inputs]
        force = { unit = "N" }
        [parameters]
        F = { value = 0.2, unit = "N" }
        Td = { value = 0.31, unit = "s" }
        r = { value = 1.5, unit = "N*s/m" }
        m = { value = 2, unit = "kg" }
        [states]
        v = { rate = "(force - r*delay(v, Td) - F*sign(v))/m", unit = "m/s", initial = 0.1 }
        [outputs]
        speed = { equals = "v", unit = "m/s" }
    "#;

    fn made(model: &Model, inputs: &[(&str, &str)], output: (&str, &str)) -> Simulator {
        let time: Vec<f64> = (0..6001).map(|i| 0.02 * f64::from(i)).collect();
        let channel = |(name, unit): (&str, &str), f: &dyn Fn(f64) -> f64| {
            let values = time.iter().map(|t| f(*t)).collect();
            Channel::new(name, Unit::parse(unit).unwrap(), time.clone(), values)
        };
        let mut channels: Vec<Channel> =
            inputs.iter().map(|i| channel(*i, &|t| 5.0 * (0.7 * t).sin() + 2.0 * (2.3 * t).cos())).collect();
        channels.push(channel(output, &|_| 0.0));
        let recording = Recording::from_channels("made", channels).unwrap();
        Simulator::new(model, &recording, &Options::default()).unwrap()
    }

    #[test]
    fn machine_code_and_interpreter_give_the_same_runs() {
        let sphere = Model::builtin("gyrosphere").unwrap();
        let sticking = Model::parse(STICKING).unwrap();
        let cases = [
            made(&sphere, &[("roll_acc", "rad/s^2"), ("heading", "deg")], ("alpha", "deg")),
            made(&sticking, &[("force", "N")], ("place", "m")),
            made(&Model::parse(STIFF).unwrap(), &[("force", "N")], ("speed", "m/s")),
            made(&Model::parse(LATE).unwrap(), &[("force", "N")], ("speed", "m/s")),
        ];
        assert_eq!(cases[2].plan.method, Solver::Stiff);
        for compiled in cases {
            let mut interpreted = compiled.clone();
            interpreted.natives = Arc::new(Natives { worth: usize::MAX, kinds: Mutex::default() });
            let (p, x) = (compiled.parameters(), compiled.initials());
            let unknowns = [Unknown::Parameter(0), Unknown::Parameter(1), Unknown::Initial(0)];
            let run = |s: &Simulator| s.run_with_sensitivities(&p, &x, &unknowns).unwrap();
            let (a, b) = (run(&compiled), run(&interpreted));
            assert!(a.outputs[0].iter().any(|y| *y != 0.0), "something moves");
            assert_eq!(a.outputs, b.outputs);
            assert_eq!(a.sensitivities, b.sensitivities);
            assert_eq!(a.events, b.events);
            assert_eq!(compiled.run(&p, &x).unwrap().outputs, interpreted.run(&p, &x).unwrap().outputs);
            let kinds = compiled.natives.kinds.lock().unwrap();
            assert!(kinds.iter().all(|k| k.compiled.get().is_some()), "both kinds were worth compiling");
        }
    }
}
