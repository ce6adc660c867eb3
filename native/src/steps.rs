//! The functions of a step, compiled, and their calls.

use crate::lower::Lowering;
use crate::unit::{Unit, Wanted, before_a_step, clear_upper_halves};
use crate::{Method, Number, StepCode};
use cranelift_codegen::ir::{InstBuilder, types};
use cranelift_module::FuncId;
use std::fmt;

/// Addresses of the registers and of seven arrays, and the step.
type Entry =
    unsafe extern "C" fn(*mut f64, *const f64, *const f64, *const f64, f64, *mut f64, *mut f64, *mut f64);

/// Addresses among the arguments: the registers, three arrays that are read, three that are written.
const READ: usize = 4;
const WRITTEN: usize = 3;

/// Steps as machine code; shared freely between threads.
///
/// The decay ẋ = −λx with λ in register 0, x in register 1, ẋ in register 2; one step of Heun's method from x = 1:
///
/// ```
/// use gyrospec_native::{Action, Care, Method, Op, StepCode, Steps};
/// let code = [
///     Op { action: Action::Mul, to: 2, a: 0, b: 1, c: 0 },
///     Op { action: Action::Negative, to: 3, a: 2, b: 0, c: 0 },
/// ];
/// let step = StepCode {
///     time: &[],
///     code: &code,
///     output: &[],
///     motion: &[],
///     slopes: &[],
///     states: &[1],
///     rates: &[3],
///     signs: &[],
///     active: &[false; 4],
///     kept: &[true; 4],
///     method: Method::Heun,
///     care: Care::Much,
/// };
/// if let Some(steps) = Steps::compile(&step, 0) {
///     let mut registers = [2.0, 0.0, 0.0, 0.0];
///     let (mut x, mut rate, mut last) = ([0.0], [0.0], [0.0]);
///     steps.heun(&mut registers, (&[1.0], &[-2.0]), 0.1, (&mut x, &mut rate, &mut last));
///     assert_eq!(x[0], 1.0 + (-2.0 + -2.0 * (1.0 + -2.0 * 0.1)) * (0.5 * 0.1));
///     assert_eq!(registers[1], x[0]);
/// }
/// ```
pub struct Steps {
    unit: Unit,
    entries: [Option<Entry>; Which::COUNT],
    registers: usize,
    states: usize,
    tangents: usize,
}

impl fmt::Debug for Steps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Steps({} states, {} tangents)", self.states, self.tangents)
    }
}

/// Which function of a step.
#[derive(Clone, Copy, PartialEq)]
enum Which {
    Time,
    Output,
    State,
    Motion,
    Slopes,
    First,
    Second,
    Heun,
}

impl Which {
    const COUNT: usize = 8;

    /// What is compiled for a method.
    fn of(method: Method) -> Vec<Self> {
        let steps: &[Self] = match method {
            Method::Classical => &[Self::First, Self::Second],
            Method::Heun => &[Self::Heun],
            Method::None => &[Self::Slopes],
        };
        [&[Self::Time, Self::Output, Self::State, Self::Motion], steps].concat()
    }
}

impl Steps {
    /// Whether machine code is made at all.
    pub const MADE: bool = true;

    /// The steps of a model's rates for numbers with so many tangents (an even number); none where the machine is not
    /// known, gives no memory that may run, or the code is too long to be worth it.
    pub fn compile(step: &StepCode<'_>, tangents: usize) -> Option<Self> {
        if !step.is_sound(1 + tangents) || tangents % 2 == 1 {
            return None;
        }
        let mut unit = Unit::new(step.care)?;
        let one = |w: Which| Some((w, define(&mut unit, step, tangents, w)?));
        let built: Option<Vec<(Which, FuncId)>> = Which::of(step.method).into_iter().map(one).collect();
        let is_final = built.is_some() && unit.finish();
        let mut steps = Self {
            unit,
            entries: [None; Which::COUNT],
            registers: step.active.len(),
            states: step.states.len(),
            tangents,
        };
        for (which, id) in built.into_iter().flatten().filter(|_| is_final) {
            steps.entries[which as usize] = Some(steps.entry(id)?);
        }
        is_final.then_some(steps)
    }

    fn entry(&self, id: FuncId) -> Option<Entry> {
        let address = self.unit.address(id)?;
        // SAFETY: `define` gave the function exactly the signature of `Entry` in the machine's own calling convention,
        // and it was finalised; it lives as long as the unit, which lives as long as `self`.
        #[expect(unsafe_code, reason = "an address becomes a function")]
        Some(unsafe { std::mem::transmute::<*const u8, Entry>(address) })
    }

    /// Calls a function after the lengths of all that it touches were looked at.
    fn call<T: Number>(&self, which: Which, r: *mut T, read: &[&[T]], h: f64, written: &mut [&mut [T]]) {
        assert!(T::TANGENTS == self.tangents, "numbers of another kind");
        let n = self.states;
        assert!(
            read.iter().all(|x| x.len() == n) && written.iter().all(|x| x.len() == n),
            "as many as states"
        );
        let from = |k: usize| read.get(k).map_or(std::ptr::null(), |x| x.as_ptr().cast::<f64>());
        let mut to =
            |k: usize| written.get_mut(k).map_or(std::ptr::null_mut(), |x| x.as_mut_ptr().cast::<f64>());
        let (d, e, f) = (to(0), to(1), to(2));
        let Some(entry) = self.entries[which as usize] else { panic!("compiled for another method") };
        clear_upper_halves();
        // SAFETY: `r` comes from a slice of `registers` numbers (asserted by the callers), the arrays hold one number a
        // state, and a number is 1 + `tangents` doubles (`Number`). The code touches registers below `registers` and
        // numbers below `states` alone (`is_sound`, `define`), no array that its caller leaves away, and `first` writes
        // no register. What is written is borrowed mutably, so that nothing overlaps.
        #[expect(unsafe_code, reason = "runs the code")]
        unsafe {
            entry(r.cast::<f64>(), from(0), from(1), from(2), h, d, e, f);
        }
    }

    /// Runs a part of a step on the registers alone.
    fn part<T: Number>(&self, which: Which, r: &mut [T]) {
        assert!(r.len() == self.registers, "as many registers as compiled for");
        self.call(which, r.as_mut_ptr(), &[], 0.0, &mut []);
    }

    /// Runs the instructions of a new time.
    ///
    /// # Panics
    /// As [`Steps::first_half`].
    pub fn time<T: Number>(&self, r: &mut [T]) {
        self.part(Which::Time, r);
    }

    /// Runs the instructions of the outputs.
    ///
    /// # Panics
    /// As [`Steps::first_half`].
    pub fn output<T: Number>(&self, r: &mut [T]) {
        self.part(Which::Output, r);
    }

    /// Runs the instructions of the states.
    ///
    /// # Panics
    /// As [`Steps::first_half`].
    pub fn state<T: Number>(&self, r: &mut [T]) {
        self.part(Which::State, r);
    }

    /// Runs the instructions of the motion of guards.
    ///
    /// # Panics
    /// As [`Steps::first_half`].
    pub fn motion<T: Number>(&self, r: &mut [T]) {
        self.part(Which::Motion, r);
    }

    /// Whether the slopes of the rates were compiled.
    pub fn has_slopes(&self) -> bool {
        self.entries[Which::Slopes as usize].is_some()
    }

    /// Runs the instructions of the slopes of the rates.
    ///
    /// # Panics
    /// As [`Steps::first_half`].
    pub fn slopes<T: Number>(&self, r: &mut [T]) {
        self.part(Which::Slopes, r);
    }

    /// The stages of the classical method up to the last: from x with rates k₁ at the begin of a step h, the inputs in
    /// the registers as they are in its middle, to the last stage s = x + h·k₃ and to k₁ + 2(k₂ + k₃).
    ///
    /// # Panics
    /// Where the lengths, the kind of numbers or the method are not those that it was compiled for.
    pub fn first_half<T: Number>(&self, r: &[T], x: &[T], k: &[T], h: f64, stage: &mut [T], sum: &mut [T]) {
        assert!(r.len() == self.registers, "as many registers as compiled for");
        self.call(Which::First, r.as_ptr().cast_mut(), &[x, k], h, &mut [stage, sum]);
    }

    /// The last stage and the end of the step, the inputs in the registers as they are there: x₁ = x + h/6·(sum + k₄),
    /// its rates k₅, which stand in the registers with all that was to be kept, and the value of k₄ in `last`.
    ///
    /// # Panics
    /// As [`Steps::first_half`].
    pub fn second_half<T: Number>(
        &self,
        r: &mut [T],
        (x, stage, sum): (&[T], &[T], &[T]),
        h: f64,
        (x1, k1, last): (&mut [T], &mut [T], &mut [T]),
    ) {
        assert!(r.len() == self.registers, "as many registers as compiled for");
        self.call(Which::Second, r.as_mut_ptr(), &[x, stage, sum], h, &mut [x1, k1, last]);
    }

    /// A step of Heun's method, the inputs in the registers as they are at its end: x₁ = x + h/2·(k₁ + k₂), its rates
    /// k₃, which stand in the registers with all that was to be kept, and the value of k₂ in `last`.
    ///
    /// # Panics
    /// As [`Steps::first_half`].
    pub fn heun<T: Number>(
        &self,
        r: &mut [T],
        (x, k): (&[T], &[T]),
        h: f64,
        (x1, k1, last): (&mut [T], &mut [T], &mut [T]),
    ) {
        assert!(r.len() == self.registers, "as many registers as compiled for");
        self.call(Which::Heun, r.as_mut_ptr(), &[x, k], h, &mut [x1, k1, last]);
    }
}

/// Builds a function of the signature `Entry`.
fn define(unit: &mut Unit, step: &StepCode<'_>, tangents: usize, which: Which) -> Option<FuncId> {
    let pointer = unit.pointer()?;
    let mut parameters = vec![pointer; READ];
    parameters.push(types::F64);
    parameters.resize(READ + 1 + WRITTEN, pointer);
    let active = before(step, which);
    let wanted = Wanted { step, tangents, parameters: &parameters, result: None, active: &active };
    unit.define(&wanted, |body, arguments| {
        match which {
            Which::Time => body.segment(step.time, Lowering::keep_known),
            Which::Output => body.segment(step.output, Lowering::keep),
            Which::State => body.segment(step.code, |l, r| {
                if step.kept[usize::from(r)] {
                    l.keep(r);
                }
            }),
            Which::Motion => body.segment(step.motion, Lowering::keep),
            Which::Slopes => body.segment(step.slopes, Lowering::keep),
            Which::First => body.first(arguments),
            Which::Second => body.second(arguments),
            Which::Heun => body.heun(arguments),
        }
        body.lowering.builder.ins().return_(&[]);
    })
}

/// The registers that may have tangents when a function begins.
fn before(step: &StepCode<'_>, which: Which) -> Vec<bool> {
    if which == Which::Time {
        return step.active.to_vec();
    }
    let mut active = before_a_step(step);
    if matches!(which, Which::First | Which::Second | Which::Heun) {
        return active;
    }
    step.signs.iter().for_each(|r| active[usize::from(*r)] = true);
    if which != Which::State {
        // what the states make may have tangents under another sign
        step.code.iter().for_each(|op| active[usize::from(op.to)] = true);
    }
    active
}
