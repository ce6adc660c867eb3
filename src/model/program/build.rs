//! Puts a model's expressions into the graph.
//!
//! Everything that jumps or kinks becomes switches (sign registers); everything with memory
//! becomes hidden states, held values or kept pasts.

use super::graph::{Column, Graph, Id, Level, Memory, Node};
use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Definition, Model};
use crate::{Error, Result};
use std::collections::HashMap;

/// Delays of one expression up to which each has memories of its own.
const COPIES: usize = 2;

/// The roots of a model in its graph.
pub(super) struct Built {
    pub graph: Graph,
    pub rates: Vec<Id>,
    pub outputs: Vec<Id>,
    pub definitions: Vec<Id>,
}

/// Builds the graph of a checked model.
pub(super) fn build(model: &Model) -> Result<Built> {
    let (graph, names) = (Graph::default(), HashMap::new());
    let mut builder = Builder { model, graph, names, states: model.states.len(), late_by: None };
    builder.leaves(model);
    for d in model.definition_order().map_err(|(_, e)| e)? {
        let id = builder.expression(&d.equals)?;
        builder.names.insert(d.name.clone(), id);
    }
    let definitions = model.definitions.iter().map(|d| builder.names[&d.name]).collect();
    let mut rates = Vec::new();
    for s in &model.states {
        rates.push(builder.expression(&s.rate)?);
    }
    let mut outputs = Vec::new();
    for o in &model.outputs {
        outputs.push(builder.expression(&o.equals)?);
    }
    let graph = builder.graph;
    rates.extend(graph.memories.iter().filter_map(|m| match m {
        Memory::Hidden { rate, .. } => Some(*rate),
        _ => None,
    }));
    Ok(Built { graph, rates, outputs, definitions })
}

pub(super) struct Builder<'m> {
    model: &'m Model,
    pub(super) graph: Graph,
    names: HashMap<String, Id>,
    states: usize,
    /// By how much all is late that is built now.
    late_by: Option<Id>,
}

impl Builder<'_> {
    fn leaves(&mut self, model: &Model) {
        for (i, x) in model.inputs.iter().enumerate() {
            let id = self.graph.column(Column { input: i, delay: None });
            self.names.insert(x.name.clone(), id);
        }
        for (i, p) in model.parameters.iter().enumerate() {
            let id = self.graph.add(Node::Parameter(i));
            self.names.insert(p.name.clone(), id);
        }
        for (i, s) in model.states.iter().enumerate() {
            let id = self.graph.add(Node::State(i));
            self.names.insert(s.name.clone(), id);
        }
        let t = self.graph.add(Node::Time);
        let pi = self.graph.constant(std::f64::consts::PI);
        self.names.extend([("t".to_string(), t), ("pi".to_string(), pi)]);
    }

    fn expression(&mut self, e: &Expr) -> Result<Id> {
        match e {
            Expr::Number(x) => Ok(self.graph.constant(*x)),
            Expr::Name(name) => {
                let id = self.names.get(name).copied();
                id.ok_or_else(|| Error::bad_input(format!("unknown name {name:?}")))
            }
            Expr::Neg(a) => {
                let a = self.expression(a)?;
                Ok(self.graph.negative(a))
            }
            Expr::Binary(op, a, b) => {
                let (a, b) = (self.expression(a)?, self.expression(b)?);
                Ok(match op {
                    BinaryOp::Add => self.graph.sum(a, b),
                    BinaryOp::Sub => self.graph.difference(a, b),
                    BinaryOp::Mul => self.graph.product(a, b),
                    BinaryOp::Div => self.graph.quotient(a, b),
                    BinaryOp::Pow => self.graph.power(a, b),
                })
            }
            Expr::Call(Function::Delay, x) => self.delay(&x[0], &x[1]),
            Expr::Call(f, arguments) => {
                let ids: Result<Vec<Id>> = arguments.iter().map(|a| self.expression(a)).collect();
                self.call(*f, &ids?)
            }
        }
    }

    fn call(&mut self, f: Function, x: &[Id]) -> Result<Id> {
        Ok(match f {
            Function::Atan2 => self.graph.atan2(x[0], x[1]),
            Function::Sign => self.graph.sign(x[0], 0),
            Function::Abs => {
                let sign = self.graph.sign(x[0], 0);
                let negative = self.graph.negative(x[0]);
                self.graph.select(sign, x[0], negative)
            }
            Function::Step => {
                // step(x) = (1 + sign x)/2
                let (half, sign) = (self.graph.constant(0.5), self.graph.sign(x[0], 1));
                let part = self.graph.product(half, sign);
                self.graph.sum(half, part)
            }
            Function::Min => self.lesser(x[0], x[1]),
            Function::Max => self.greater(x[0], x[1]),
            Function::Clamp => {
                let raised = self.greater(x[0], x[1]);
                self.lesser(raised, x[2])
            }
            Function::Lag => self.lag(x[0], x[1]),
            Function::RateLimit => self.rate_limit(x[0], x[1]),
            Function::Backlash => self.backlash(x[0], x[1]),
            Function::Hysteresis => {
                let play = self.backlash(x[0], x[1]);
                self.graph.difference(x[0], play)
            }
            Function::Relay => {
                let half = self.half(x[1]);
                self.graph.relay(x[0], half)
            }
            Function::Surface(n, _) => return self.surface(x[0], x[1], usize::from(n), &x[2..]),
            Function::Curve => return self.curve(x[0], &x[1..]),
            Function::Foreign(f) => self.graph.foreign(f, x),
            _ => self.graph.one(f, x[0]),
        })
    }

    fn half(&mut self, a: Id) -> Id {
        let half = self.graph.constant(0.5);
        self.graph.product(half, a)
    }

    fn lesser(&mut self, a: Id, b: Id) -> Id {
        let difference = self.graph.difference(a, b);
        let sign = self.graph.sign(difference, 0);
        self.graph.select(sign, b, a)
    }

    fn greater(&mut self, a: Id, b: Id) -> Id {
        let difference = self.graph.difference(a, b);
        let sign = self.graph.sign(difference, 0);
        self.graph.select(sign, a, b)
    }

    fn hidden(&mut self, start: Id, rate: impl FnOnce(&mut Graph, Id) -> Id) -> Id {
        let state = self.states;
        self.states += 1;
        let y = self.graph.add(Node::State(state));
        let rate = rate(&mut self.graph, y);
        self.graph.memories.push(Memory::Hidden { state, rate, start });
        y
    }

    /// ẏ = (x − y)/T, steady at the start.
    fn lag(&mut self, x: Id, time: Id) -> Id {
        self.hidden(x, |g, y| {
            let gap = g.difference(x, y);
            g.quotient(gap, time)
        })
    }

    /// ẏ = r·sign(x − y): it slides along y = x while |ẋ| < r.
    fn rate_limit(&mut self, x: Id, rate: Id) -> Id {
        self.hidden(x, |g, y| {
            let gap = g.difference(x, y);
            let sign = g.sign(gap, 0);
            g.product(rate, sign)
        })
    }

    /// y = min(max(y₀, x − gap/2), x + gap/2) with y₀ from the end of the last step.
    fn backlash(&mut self, x: Id, gap: Id) -> Id {
        let slot = self.graph.memories.iter().filter(|m| matches!(m, Memory::Held { .. })).count();
        let held = self.graph.add(Node::Held(slot));
        let half = self.half(gap);
        let (low, high) = (self.graph.difference(x, half), self.graph.sum(x, half));
        let raised = self.greater(held, low);
        let next = self.lesser(raised, high);
        self.graph.memories.push(Memory::Held { slot, next, start: x });
        next
    }

    /// x(t − T), T the same during a run: what inputs and time alone make is made of late inputs, whose kinks come at known
    /// times; of anything else, and where that would be more memories than one with its past, the past is kept.
    fn delay(&mut self, e: &Expr, time: &Expr) -> Result<Id> {
        let by = self.expression(time)?;
        if self.graph.levels[by] > Level::Run {
            return Err(Error::bad_input("the time of delay(x, T) must not change during a run")
                .with_hint("make T a parameter or an expression of parameters"));
        }
        let used = self.model.used_by(e);
        let all = || used.iter().map(|d| &d.equals).chain([e]);
        let is_of_states = all().any(|e| self.model.states.iter().any(|s| e.mentions(&s.name)));
        if !is_of_states && (self.delays_of(e) <= COPIES || !all().any(keeps_state)) {
            return self.late(e, &used, by);
        }
        let signal = self.expression(e)?;
        let slot = self.graph.memories.iter().filter(|m| matches!(m, Memory::Past { .. })).count();
        self.graph.memories.push(Memory::Past { slot, signal, delay: by });
        Ok(self.graph.add(Node::Past(slot)))
    }

    /// An expression of inputs and time, and the definitions that it uses, some time ago.
    fn late(&mut self, e: &Expr, used: &[&Definition], by: Id) -> Result<Id> {
        let total = self.late_by.map_or(by, |outer| self.graph.sum(outer, by));
        let (outer, now) = (self.late_by.replace(total), self.names.clone());
        for (input, x) in self.model.inputs.iter().enumerate() {
            let id = self.graph.column(Column { input, delay: Some(total) });
            self.names.insert(x.name.clone(), id);
        }
        let t = self.graph.add(Node::Time);
        let t = self.graph.difference(t, total);
        self.names.insert("t".to_string(), t);
        for d in self.model.definition_order().map_err(|(_, e)| e)? {
            if used.iter().any(|u| u.name == d.name) {
                let id = self.expression(&d.equals)?;
                self.names.insert(d.name.clone(), id);
            }
        }
        let id = self.expression(e)?;
        (self.late_by, self.names) = (outer, now);
        Ok(id)
    }

    /// How often some delay of an expression stands in the model.
    fn delays_of(&self, e: &Expr) -> usize {
        let model = self.model;
        let definitions = model.definitions.iter().map(|d| &d.equals);
        let rates = model.states.iter().map(|s| &s.rate);
        let all = definitions.chain(rates).chain(model.outputs.iter().map(|o| &o.equals));
        let mut count = 0;
        for part in all {
            part.visit(&mut |x| {
                if let Expr::Call(Function::Delay, arguments) = x {
                    count += usize::from(arguments[0] == *e);
                }
            });
        }
        count
    }
}

/// Whether some part of an expression is a state of its own.
fn keeps_state(e: &Expr) -> bool {
    let mut found = false;
    e.visit(&mut |part| found |= matches!(part, Expr::Call(f, _) if f.keeps_state()));
    found
}
