//! Many steps in one loop of machine code.

use crate::unit::{Unit, Wanted, before_a_step, clear_upper_halves};
use crate::{BEGIN, JUMP, LISTS, MarchCode, Mark, Method, Number, StepCode};
use cranelift_codegen::ir::types;
use std::fmt;

/// Addresses of the registers, of states and rates, of steps, rows, rows of jumps and marks, of the measures, and of the
/// lists' addresses; the number of steps. The number of those that were taken.
type Entry = unsafe extern "C" fn(
    *mut f64,
    *mut f64,
    *mut f64,
    *const f64,
    *const f64,
    *const f64,
    *const Mark,
    *mut f64,
    *const *mut f64,
    i64,
) -> i64;

/// Addresses among the arguments, which come first.
const ADDRESSES: usize = 9;

/// Steps of an explicit method one after the other, as one function; shared freely between threads.
///
/// A march ends before the first step that it cannot take: one after which a switch would have the wrong sign, or a
/// state would be beyond 1e100 or no number. Nothing of such a step is left behind, but that where its begin jumps the
/// rates may be those after the jump already, and an entry written that is not counted.
///
/// The decay ẋ = −λx with λ in register 0, x in register 1, two steps of Heun's method from x = 1; x is written after
/// the second:
///
/// ```
/// use gyrospec_native::{Action, Care, March, MarchCode, Method, Op, StepCode};
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
/// let many = MarchCode { loaded: &[], switches: &[], held: &[], written: &[vec![1]], jumps: false };
/// if let Some(march) = March::compile(&step, &many, 0) {
///     let (mut r, mut x, mut k) = ([2.0, 0.0, 0.0, 0.0], [1.0], [-2.0]);
///     let mut measures = [0.0, f64::INFINITY, f64::NEG_INFINITY];
///     let mut seen = [0.0];
///     let steps = (&[0.1, 0.1][..], &[][..], &[][..], &[0, 1][..]);
///     let taken = march.run((&mut r, &mut x, &mut k), steps, &mut measures, &mut [&mut seen]);
///     assert_eq!(taken, 2);
///     assert!((x[0] - 0.82f64.powi(2)).abs() < 1e-15);
///     assert_eq!(seen, x);
/// }
/// ```
pub struct March {
    /// Holds the memory of `entry`.
    _unit: Unit,
    entry: Entry,
    registers: usize,
    states: usize,
    tangents: usize,
    /// Numbers that a row holds, and rows a step.
    loaded: usize,
    stages: usize,
    jumps: bool,
    /// Registers an entry of each list.
    widths: Vec<usize>,
}

impl fmt::Debug for March {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "March({} states, {} tangents)", self.states, self.tangents)
    }
}

impl March {
    /// The steps of a model for numbers with so many tangents (an even number); none where the method has none, the
    /// machine is not known, gives no memory that may run, or the code is too long to be worth it.
    pub fn compile(step: &StepCode<'_>, march: &MarchCode<'_>, tangents: usize) -> Option<Self> {
        let is_sound = step.is_sound(1 + tangents) && march.is_sound(step.active.len());
        if !is_sound || tangents % 2 == 1 || step.method == Method::None {
            return None;
        }
        let mut unit = Unit::new(step.care)?;
        let mut parameters = vec![unit.pointer()?; ADDRESSES];
        parameters.push(types::I64);
        let active = before_a_step(step);
        let result = Some(types::I64);
        let wanted = Wanted { step, tangents, parameters: &parameters, result, active: &active };
        let id = unit.define(&wanted, |body, arguments| body.march(march, arguments))?;
        if !unit.finish() {
            return None;
        }
        let address = unit.address(id)?;
        // SAFETY: `define` gave the function exactly the signature of `Entry` in the machine's own calling convention,
        // and it was finalised; it lives as long as the unit, which lives as long as `self`.
        #[expect(unsafe_code, reason = "an address becomes a function")]
        let entry = unsafe { std::mem::transmute::<*const u8, Entry>(address) };
        Some(Self {
            _unit: unit,
            entry,
            registers: step.active.len(),
            states: step.states.len(),
            tangents,
            loaded: march.loaded.len(),
            stages: step.method.stages(),
            jumps: march.jumps,
            widths: march.written.iter().map(Vec::len).collect(),
        })
    }

    /// Marches from states x with rates k, both of which go along: the steps' lengths in s, for each step the rows of
    /// its stages, a row for each jump, and the marks of the steps. The measures are, state by state, the sums of the
    /// embedded errors' sizes, then the lowest, then the highest values after steps. Returns the number of steps that were
    /// taken.
    ///
    /// # Panics
    /// Where the lengths or the kind of numbers are not those that it was compiled for, or a list is too short.
    pub fn run<T: Number>(
        &self,
        (r, x, k): (&mut [T], &mut [T], &mut [T]),
        (h, rows, jumps, marks): (&[f64], &[f64], &[f64], &[Mark]),
        measures: &mut [f64],
        lists: &mut [&mut [T]],
    ) -> usize {
        assert!(T::TANGENTS == self.tangents, "numbers of another kind");
        assert!(r.len() == self.registers, "as many registers as compiled for");
        let states = x.len() == self.states && k.len() == self.states && measures.len() == 3 * self.states;
        assert!(states, "as many as states");
        let steps = h.len();
        assert!(
            marks.len() == steps && rows.len() == steps * self.stages * self.loaded,
            "as many rows as steps"
        );
        let count = |mark: Mark| marks.iter().filter(|m| **m & mark != 0).count();
        assert!(count(JUMP) == 0 || self.jumps, "compiled for steps without jumps");
        assert!(jumps.len() >= count(JUMP) * self.loaded, "a row for each jump");
        assert!(lists.len() == self.widths.len(), "as many lists as compiled for");
        let mut addresses = [std::ptr::null_mut::<f64>(); LISTS];
        for (i, (list, width)) in lists.iter_mut().zip(&self.widths).enumerate() {
            let entries = count(1 << i) + count(1 << (i as u32 + BEGIN));
            assert!(list.len() >= entries * width, "room for all entries");
            addresses[i] = list.as_mut_ptr().cast::<f64>();
        }
        let (r, x, k) = (r.as_mut_ptr(), x.as_mut_ptr(), k.as_mut_ptr());
        clear_upper_halves();
        // SAFETY: every address is that of a slice whose length was looked at above: `registers` and `states` numbers of
        // 1 + `tangents` doubles each (`Number`), one step, mark and set of rows a step, one row a jump, three measures a
        // state, and as many entries of each list as marks ask for. The code touches registers below `registers` alone
        // (`is_sound`), and goes one step, mark, set of rows further a round, one row of jumps and one entry further where
        // the mark asked for it. What is written is borrowed mutably, so that nothing overlaps.
        #[expect(unsafe_code, reason = "runs the code")]
        let taken = unsafe {
            (self.entry)(
                r.cast::<f64>(),
                x.cast::<f64>(),
                k.cast::<f64>(),
                h.as_ptr(),
                rows.as_ptr(),
                jumps.as_ptr(),
                marks.as_ptr(),
                measures.as_mut_ptr(),
                addresses.as_ptr(),
                steps as i64,
            )
        };
        usize::try_from(taken).unwrap_or(0)
    }
}
