//! A unit that a solver calls: rates and outputs as functions of the expression language.

use super::super::{Initial, Model, State};
use super::output;
use super::parts::{Entry, Parts};
use crate::expression::foreign::loaded;
use crate::expression::{Expr, Foreign, Function};
use crate::fmu::{Exchange, Fmu, Scalar};
use crate::units::{Dimension, Unit};
use std::sync::Arc;

/// States and outputs that a solver asks the unit for; the number of its code.
pub(super) fn as_function(fmu: &Arc<Fmu>, parts: &Parts, model: &mut Model) -> u16 {
    let code = code(fmu, parts);
    let n = parts.states.len();
    let names = parts.names();
    let arguments: Vec<Expr> =
        std::iter::once("t").chain(names.iter().map(String::as_str)).map(|n| Expr::Name(n.into())).collect();
    let result = |k: usize| Expr::Call(Function::Foreign(Foreign::of(code, k as u16)), arguments.clone());
    let state = |k: usize| Expr::Name(parts.states[k].name.clone());
    let same = same_as_states(code, parts);
    for (k, e) in parts.states.iter().enumerate() {
        model.states.push(State {
            name: e.name.clone(),
            rate: same[k].map_or_else(|| result(k), state),
            unit: e.scalar.unit.clone(),
            initial: Initial::Number(e.start),
            meaning: e.meaning.clone(),
        });
    }
    for (k, e) in parts.outputs.iter().enumerate().filter(|(_, e)| parts.is_compared(e)) {
        let own = same[n + k].map_or_else(|| result(n + k), state);
        model.outputs.push(output(e, own));
    }
    code
}

/// The number of the unit's code with these arguments.
fn code(fmu: &Arc<Fmu>, parts: &Parts) -> u16 {
    let second = Unit::of(Dimension::TIME);
    let rates = parts.states.iter().map(|e| e.scalar.unit.of_differences().over(&second));
    let units = rates.chain(parts.outputs.iter().map(|e| e.scalar.unit.clone())).collect();
    let lists = [&parts.states, &parts.inputs, &parts.parameters, &parts.outputs];
    let spelled = lists
        .map(|l| l.iter().map(|e| format!("{} {}", e.name, e.scalar.unit)).collect::<Vec<_>>().join(","));
    let key = format!("{} {} {}", fmu.source.file.display(), fmu.source.sha256, spelled.join(";"));
    let list = |l: &[Entry]| -> Vec<Scalar> { l.iter().map(|e| e.scalar.clone()).collect() };
    let exchange = Exchange {
        fmu: fmu.clone(),
        key: key.clone(),
        states: list(&parts.states),
        inputs: list(&parts.inputs),
        parameters: list(&parts.parameters),
        outputs: list(&parts.outputs),
        units,
    };
    loaded(&key, || Arc::new(exchange))
}

/// Points at which a result is held against the states.
const TRIALS: usize = 4;

/// For each result the state that it is, bit by bit, wherever one looks: q̇ = v, or a state that is an output.
fn same_as_states(code: u16, parts: &Parts) -> Vec<Option<usize>> {
    let n = parts.states.len();
    let count = n + parts.outputs.len();
    let Some(compute) = Foreign::of(code, 0).compute() else { return vec![None; count] };
    let starts: Vec<f64> =
        parts.states.iter().chain(&parts.inputs).chain(&parts.parameters).map(|e| e.start).collect();
    let mut may: Vec<Vec<usize>> = vec![(0..n).collect(); count];
    for trial in 1..=TRIALS {
        // parameters stay where they are; states and inputs go to places without a pattern
        let moves = n + parts.inputs.len();
        let moved = |(i, x): (usize, &f64)| {
            let shift = (0.37 + 0.61 * (i * TRIALS + trial) as f64).sin();
            if i < moves { x + shift * if *x == 0.0 { 1.0 } else { x.abs() } } else { *x }
        };
        let mut at = vec![0.1 * trial as f64];
        at.extend(starts.iter().enumerate().map(moved));
        for (k, may) in may.iter_mut().enumerate() {
            let value = compute.value(&at, k);
            may.retain(|j| value == at[1 + j]);
        }
    }
    let second = Unit::of(Dimension::TIME);
    let is_free = !parts.all().any(|e| e.has_unit);
    let fits = |k: usize, j: usize| {
        let own = &parts.states[j].scalar.unit;
        let wanted = match parts.states.get(k) {
            Some(state) => state.scalar.unit.of_differences().over(&second),
            None => parts.outputs[k - n].scalar.unit.clone(),
        };
        is_free || wanted.dimension() == own.dimension()
    };
    may.into_iter().enumerate().map(|(k, m)| m.into_iter().find(|j| fits(k, *j))).collect()
}
