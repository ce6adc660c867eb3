//! Models without memory: every sample, or every trial, by itself.

use super::machine::registers;
use super::mesh::Samples;
use super::probe::Clock;
use crate::model::Scalar;
use crate::model::program::{Program, Switching, execute};

/// The wanted registers at every time of every clock: time by time, register by register.
pub(super) fn run<T: Scalar>(
    program: &Program,
    samples: &[Samples],
    clocks: &[Clock],
    parameters: &[T],
) -> Vec<Vec<T>> {
    let mut r = registers(program, parameters);
    let mut out = Vec::with_capacity(clocks.len());
    for clock in clocks {
        let mut values = Vec::with_capacity(clock.time.len() * clock.registers.len());
        let mut near = vec![0; program.columns.len()];
        for t in clock.time.iter() {
            load(program, samples, &mut r, *t, &mut near);
            execute(program, &program.per_data, &mut r, Switching::Follow);
            execute(program, &program.per_time, &mut r, Switching::Follow);
            execute(program, &program.output_code, &mut r, Switching::Follow);
            values.extend(clock.registers.iter().map(|k| r[usize::from(*k)]));
        }
        out.push(values);
    }
    out
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
