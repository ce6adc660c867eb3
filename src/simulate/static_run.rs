//! Models without memory: every sample, or every trial, by itself. What none of the tangents reaches is done in plain
//! numbers: a model may ask for hundreds of sensitivities, a few at a time, of which each reaches little.

use super::machine::registers;
use super::mesh::Samples;
use super::probe::Clock;
use crate::model::Scalar;
use crate::model::program::{Action, Op, Program, Register, Switching, execute};

/// The wanted registers at every time of every clock: time by time, register by register.
pub(super) fn run<T: Scalar>(
    program: &Program,
    samples: &[Samples],
    clocks: &[Clock],
    parameters: &[T],
) -> Vec<Vec<T>> {
    let mut r = registers(program, parameters);
    let mut parts = Parts::new(program, &r);
    let mut out = Vec::with_capacity(clocks.len());
    for clock in clocks {
        let mut values = Vec::with_capacity(clock.time.len() * clock.registers.len());
        let mut near = vec![0; program.columns.len()];
        for t in clock.time.iter() {
            load(program, samples, &mut r, *t, &mut near);
            parts.run(program, &mut r);
            values.extend(clock.registers.iter().map(|k| r[usize::from(*k)]));
        }
        out.push(values);
    }
    out
}

/// The code of a sample in two parts.
struct Parts {
    /// What depends on no register with tangents, in plain numbers.
    plain: Vec<Op>,
    /// The rest, which is done afterwards.
    moved: Vec<Op>,
    /// What the plain part reads of the sample, and what is read of the plain part.
    given: Vec<Register>,
    taken: Vec<Register>,
    numbers: Vec<f64>,
}

impl Parts {
    /// Parts the code by which registers have tangents before it; those of a sample may have some of its delay.
    fn new<T: Scalar>(program: &Program, r: &[T]) -> Self {
        let has = |x: &T| (0..T::TANGENTS).any(|d| x.tangent(d) != 0.0);
        let mut moves: Vec<bool> = r.iter().map(has).collect();
        for column in program.columns.iter().filter(|c| c.delay.is_some()) {
            moves[usize::from(column.value)] = true;
        }
        let code = [&program.per_data, &program.per_time, &program.output_code];
        let is_moved = |op: &Op| {
            // a number in the place of a register may stand for one: then the operation is done with tangents
            let reads_moved =
                [op.a, op.b, op.c].iter().any(|r| moves.get(usize::from(*r)).is_some_and(|m| *m));
            let is_other = matches!(op.action, Action::Foreign | Action::ForeignSlope | Action::Relay);
            // a run without tangents needs no second set of numbers
            let is = T::TANGENTS == 0 || reads_moved || is_other;
            moves[usize::from(op.to)] = is;
            is
        };
        let (moved, plain): (Vec<Op>, Vec<Op>) = code.into_iter().flatten().copied().partition(is_moved);
        let is_read = program.read_by(&[&moved]);
        let columns = program.columns.iter().flat_map(|c| [c.value, c.slope]);
        Self {
            taken: plain.iter().map(|op| op.to).filter(|to| is_read[usize::from(*to)]).collect(),
            given: columns.chain([program.time]).collect(),
            plain,
            moved,
            numbers: r.iter().map(|x| x.value()).collect(),
        }
    }

    /// Runs the code of the sample that is loaded.
    fn run<T: Scalar>(&mut self, program: &Program, r: &mut [T]) {
        for k in &self.given {
            self.numbers[usize::from(*k)] = r[usize::from(*k)].value();
        }
        execute(program, &self.plain, &mut self.numbers, Switching::Follow);
        for k in &self.taken {
            r[usize::from(*k)] = T::constant(self.numbers[usize::from(*k)]);
        }
        execute(program, &self.moved, r, Switching::Follow);
    }
}

fn load<T: Scalar>(program: &Program, samples: &[Samples], r: &mut [T], t: f64, near: &mut [usize]) {
    r[usize::from(program.time)] = T::constant(t);
    for (column, near) in program.columns.iter().zip(near) {
        let shift = column.delay.map(|d| r[usize::from(d)]);
        let delay = shift.map_or(0.0, Scalar::value);
        let (value, slope) = samples[column.input].at(t - delay, near);
        let lead = shift.map_or(T::constant(0.0), |s| (T::constant(s.value()) - s).scale(slope));
        r[usize::from(column.value)] = T::constant(value) + lead;
        r[usize::from(column.slope)] = T::constant(slope);
    }
}
