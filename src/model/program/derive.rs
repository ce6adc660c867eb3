//! # Purpose
//! Derivatives of graph nodes, as graph nodes.
//!
//! # Method
//! Forward differentiation in the order of the nodes; equal results share nodes, zeros vanish.
//!
//! # References
//! A. Griewank, A. Walther, Evaluating Derivatives, 2nd ed., SIAM 2008, chapter 3.
//!
//! # Numerical aspects
//! A switch has no derivative; what jumps there is the work of the events of the simulation.

use super::graph::{Graph, Id, Node, PassSwitches, Two, reachable};
use crate::expression::Function;

/// With respect to what.
#[derive(Clone, Copy)]
pub(super) enum By<'a> {
    /// One state alone.
    State(usize),
    /// The time with the states held fast.
    Time,
    /// The time, the states moving at these rates.
    Motion(&'a [Id]),
}

/// The derivatives of the targets.
pub(super) fn derivatives(graph: &mut Graph, targets: &[Id], by: By<'_>) -> Vec<Id> {
    let last = targets.iter().copied().max().map_or(0, |m| m + 1);
    let needed = reachable(graph, targets, PassSwitches::No);
    let zero = graph.constant(0.0);
    let mut d = vec![zero; last];
    for id in 0..last {
        if needed[id] {
            d[id] = derivative(graph, id, &d, by);
        }
    }
    targets.iter().map(|t| d[*t]).collect()
}

fn derivative(g: &mut Graph, id: Id, d: &[Id], by: By<'_>) -> Id {
    let zero = g.constant(0.0);
    let one = g.constant(1.0);
    match (g.nodes[id], by) {
        (Node::State(i), By::State(j)) => {
            if i == j {
                one
            } else {
                zero
            }
        }
        (Node::State(i), By::Motion(rates)) => rates[i],
        (Node::Time, By::Time | By::Motion(_)) => one,
        (Node::Column(c), By::Time | By::Motion(_)) => g.add(Node::ColumnSlope(c)),
        (Node::Past(p), By::Time | By::Motion(_)) => g.add(Node::PastSlope(p)),
        (Node::Negative(a), _) => g.negative(d[a]),
        (Node::Two(op, a, b), _) => of_two(g, op, (a, d[a]), (b, d[b]), id),
        (Node::Select(s, a, b), _) => g.select(s, d[a], d[b]),
        (Node::Whole(a, n), _) => {
            // (xⁿ)′ = n·xⁿ⁻¹·x′
            let exponent = g.constant(f64::from(n - 1));
            let factor = g.constant(f64::from(n));
            let lower = if n == 1 { one } else { g.power(a, exponent) };
            let slope = g.product(factor, lower);
            g.product(slope, d[a])
        }
        (Node::Foreign(call, result), _) => {
            // Σ ∂f/∂aⱼ·aⱼ′
            let arguments = g.calls[call].1.clone();
            let mut whole = zero;
            for (j, a) in arguments.into_iter().enumerate().filter(|(_, a)| d[*a] != zero) {
                let slope = g.add(Node::ForeignSlope(call, result, j as u16));
                let part = g.product(slope, d[a]);
                whole = g.sum(whole, part);
            }
            whole
        }
        (Node::One(f, a), _) => {
            if d[a] == zero {
                return zero;
            }
            let slope = slope_of(g, f, a, id);
            g.product(slope, d[a])
        }
        _ => zero,
    }
}

fn of_two(g: &mut Graph, op: Two, (a, da): (Id, Id), (b, db): (Id, Id), own: Id) -> Id {
    match op {
        Two::Add => g.sum(da, db),
        Two::Sub => g.difference(da, db),
        Two::Mul => {
            let (left, right) = (g.product(da, b), g.product(a, db));
            g.sum(left, right)
        }
        Two::Div => {
            // (a/b)′ = (a′ − (a/b)·b′)/b
            let part = g.product(own, db);
            let top = g.difference(da, part);
            if g.value(top) == Some(0.0) { top } else { g.quotient(top, b) }
        }
        Two::Pow => {
            // (aᵇ)′ = b·aᵇ⁻¹·a′ + aᵇ·ln a·b′
            let minus = g.constant(-1.0);
            let exponent = g.sum(b, minus);
            let lower = g.power(a, exponent);
            let slope = g.product(b, lower);
            let left = g.product(slope, da);
            let ln = g.one(Function::Ln, a);
            let growth = g.product(own, ln);
            let right = g.product(growth, db);
            g.sum(left, right)
        }
        Two::Atan2 => {
            // atan2(a, b)′ = (b·a′ − a·b′)/(a² + b²)
            let (p, q) = (g.product(b, da), g.product(a, db));
            let top = g.difference(p, q);
            let (aa, bb) = (g.product(a, a), g.product(b, b));
            let bottom = g.sum(aa, bb);
            if g.value(top) == Some(0.0) { top } else { g.quotient(top, bottom) }
        }
    }
}

/// f′(a), with f(a) at hand as `own`.
fn slope_of(g: &mut Graph, f: Function, a: Id, own: Id) -> Id {
    let one = g.constant(1.0);
    let two = g.constant(2.0);
    let square = |g: &mut Graph, x: Id| g.product(x, x);
    match f {
        Function::Sin => g.one(Function::Cos, a),
        Function::Cos => {
            let s = g.one(Function::Sin, a);
            g.negative(s)
        }
        Function::Tan => {
            let s = square(g, own);
            g.sum(one, s)
        }
        Function::Asin | Function::Acos => {
            let s = square(g, a);
            let rest = g.difference(one, s);
            let root = g.one(Function::Sqrt, rest);
            let slope = g.quotient(one, root);
            if f == Function::Asin { slope } else { g.negative(slope) }
        }
        Function::Atan => {
            let s = square(g, a);
            let bottom = g.sum(one, s);
            g.quotient(one, bottom)
        }
        Function::Sinh => g.one(Function::Cosh, a),
        Function::Cosh => g.one(Function::Sinh, a),
        Function::Tanh => {
            let s = square(g, own);
            g.difference(one, s)
        }
        Function::Exp => own,
        Function::Ln => g.quotient(one, a),
        Function::Sqrt => {
            let bottom = g.product(two, own);
            g.quotient(one, bottom)
        }
        _ => g.constant(0.0),
    }
}
