//! # Purpose
//! Fills the table of what the measured inputs and the time alone make.
//!
//! # Method
//! The code of what was measured is run at the times at which the explicit methods ask for it; what other code reads of
//! it is kept. Where that code calls no function it is quicker run than looked up.

use super::machine::Machine;
use super::mesh::Mesh;
use super::pieces::{piece, substeps};
use super::steps::Solver;
use super::table::{Table, Use};
use crate::model::program::{Action, Program, Register};
use std::sync::Arc;

/// Numbers that a table may hold.
const LARGEST: usize = 4_000_000;

/// The table of a mesh for a method with so many steps in a usual interval; none where it is not worth it. Where the
/// steps are marched over, it holds what was measured as well.
pub(super) fn tabulated(
    program: &Program,
    mesh: &Mesh,
    (steps, method): (usize, Solver),
    is_marched: bool,
) -> Option<Arc<Table>> {
    let calls = [Action::Pow, Action::Atan2, Action::Whole];
    let is_called = |a: &Action| calls.contains(a) || matches!(a, Action::One(_));
    let is_worth = is_marched || program.per_data.iter().any(|op| is_called(&op.action));
    if method == Solver::Stiff || !is_worth {
        return None;
    }
    let stages = if method == Solver::Explicit { 2 } else { 1 };
    let plan = (steps, stages, is_marched);
    mesh.tables.of(plan, || filled(program, mesh, plan))
}

/// The registers of a table.
pub(super) fn registers(program: &Program, is_marched: bool) -> Vec<Register> {
    let mut registers = read_elsewhere(program);
    if is_marched {
        registers.extend(program.columns.iter().flat_map(|c| [c.value, c.slope]).chain([program.time]));
    }
    registers
}

fn filled(program: &Program, mesh: &Mesh, (steps, stages, is_marched): Use) -> Option<Table> {
    let registers = registers(program, is_marched);
    let lengths = mesh.time.windows(2).map(|w| w[1] - w[0]);
    let pieces: Vec<usize> = lengths.map(|l| substeps(steps, l, mesh.usual)).collect();
    let rows = stages * pieces.iter().sum::<usize>();
    if rows.saturating_mul(registers.len()) > LARGEST {
        return None;
    }
    let values = Vec::with_capacity(rows * registers.len());
    let mut table = Table {
        made: read_elsewhere(program).len(),
        registers,
        lengths: Vec::new(),
        ends: Vec::new(),
        after_jumps: Vec::new(),
        jumps: Vec::new(),
        first: Vec::with_capacity(pieces.len()),
        stages,
        values,
    };
    let mut m = Machine::<f64>::new(program, mesh, &vec![0.0; program.parameters.len()]);
    let mut first = 0;
    for (interval, pieces) in pieces.into_iter().enumerate() {
        table.first.push(first);
        first += stages * pieces;
        m.enter(interval);
        let ends = (mesh.time[interval], mesh.time[interval + 1]);
        if is_marched {
            table.jumps.push(table.after_jumps.len() / table.registers.len());
            if mesh.jumps[interval] {
                m.load_data(ends.0);
                table.after_jumps.extend(table.registers.iter().map(|r| m.r[usize::from(*r)]));
            }
        }
        for s in 0..pieces {
            let (begin, end) = piece(ends, (s, pieces), (ends.1 - ends.0) / pieces as f64);
            if is_marched {
                table.lengths.push(end - begin);
                table.ends.push(end);
            }
            let middle = (stages == 2).then_some(begin + 0.5 * (end - begin));
            for t in middle.into_iter().chain([end]) {
                m.load_data(t);
                table.values.extend(table.registers.iter().map(|r| m.r[usize::from(*r)]));
            }
        }
    }
    Some(table)
}

/// The registers of the code of what was measured that anything else reads.
fn read_elsewhere(program: &Program) -> Vec<Register> {
    let p = program;
    let is_read = p.read_by(&[&p.per_time, &p.per_state, &p.output_code, &p.motion_code, &p.jacobian_code]);
    let is_slope = |r: &Register| p.jacobian.contains(r) || p.explicit_time.contains(r);
    program.per_data.iter().map(|op| op.to).filter(|r| is_read[usize::from(*r)] || is_slope(r)).collect()
}
