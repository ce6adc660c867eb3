//! A model compiled to register code, generic over plain and dual numbers.
//!
//! Every node of the graph has a register. The code stands in segments by how often it must run:
//! once a run, once a time (of the recording, or of a run), once a state; further segments give outputs, the motion of guards and
//! the Jacobian when they are asked for.

mod build;
mod code;
mod curve;
mod derive;
mod emit;
mod foreign;
mod graph;
mod surface;

pub(crate) use code::{Action, Op, Switching, execute, slope, whole_power_parts};

use foreign::Call;

use super::Model;
use crate::Result;

/// Number of a register.
pub(crate) type Register = u16;

/// A switch that the simulation must watch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Watch {
    /// The sign register.
    pub sign: Register,
    /// What must keep that sign.
    pub guard: Register,
    /// Its rate of change (segment `motion`).
    pub motion: Register,
    /// Whether it depends on the time and the inputs alone.
    pub timed: bool,
    /// The sign where the guard is exactly 0.
    pub at_zero: f64,
    /// Whether it may slide: its guard's motion depends on its own sign.
    pub may_slide: bool,
}

/// A column of input data.
#[derive(Debug, Clone, Copy)]
pub(crate) struct InputColumn {
    pub input: usize,
    /// Register of the delay, s.
    pub delay: Option<Register>,
    pub value: Register,
    pub slope: Register,
}

/// What has memory, in the order in which it can start.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Remembered {
    /// A hidden state starts at the value of a register.
    Hidden { state: usize, start: Register },
    /// A held register starts at one register and takes another's value after every step.
    Held { held: Register, next: Register, start: Register },
    /// The past of a signal.
    Past { signal: Register, motion: Register, delay: Register, value: Register, slope: Register },
}

/// A model as register code.
#[derive(Debug, Clone)]
pub(crate) struct Program {
    pub registers: usize,
    pub constants: Vec<(Register, f64)>,
    pub parameters: Vec<Register>,
    pub time: Register,
    pub states: Vec<Register>,
    pub columns: Vec<InputColumn>,
    pub watches: Vec<Watch>,
    pub remembered: Vec<Remembered>,
    pub rates: Vec<Register>,
    pub outputs: Vec<Register>,
    pub definitions: Vec<Register>,
    /// ∂rateᵢ/∂stateⱼ row by row, and ∂rateᵢ/∂t.
    pub jacobian: Vec<Register>,
    pub explicit_time: Vec<Register>,
    pub once: Vec<Op>,
    /// What was measured, and the time, alone.
    pub per_data: Vec<Op>,
    pub per_time: Vec<Op>,
    pub per_state: Vec<Op>,
    pub motion_code: Vec<Op>,
    pub jacobian_code: Vec<Op>,
    pub output_code: Vec<Op>,
    /// Calls of other people's code.
    pub calls: Vec<Call>,
    /// Whether something besides the states remembers.
    pub has_memory: bool,
}

impl Program {
    /// Which registers these pieces of code read, or a run asks for by themselves.
    pub fn read_by(&self, code: &[&[Op]]) -> Vec<bool> {
        let mut is_read = vec![false; self.registers];
        let operands = code.iter().copied().flatten().flat_map(|op| [op.a, op.b, op.c]);
        let slopes = [&self.jacobian, &self.explicit_time];
        let named = [&self.states, &self.rates, &self.outputs, &self.definitions].into_iter().chain(slopes);
        let watched = self.watches.iter().flat_map(|w| [w.guard, w.sign, w.motion]);
        let remembered = self.remembered.iter().flat_map(Remembered::registers);
        let called = self.calls.iter().flat_map(|c| c.arguments.iter().copied());
        for r in operands.chain(called).chain(named.flatten().copied()).chain(watched).chain(remembered) {
            // an operand may be a whole power, or the number of a call, instead
            if let Some(is_read) = is_read.get_mut(usize::from(r)) {
                *is_read = true;
            }
        }
        is_read
    }
}

impl Remembered {
    /// The registers that are read of it.
    fn registers(&self) -> [Register; 3] {
        match *self {
            Self::Hidden { start, .. } => [start; 3],
            Self::Held { held, next, start } => [held, next, start],
            Self::Past { signal, motion, delay, .. } => [signal, motion, delay],
        }
    }
}

impl Model {
    /// Checks the model and compiles it.
    pub(crate) fn compile(&self) -> Result<Program> {
        self.check_form()?;
        emit::program(self, build::build(self)?)
    }
}
