//! Puts a model's expressions into the graph.
//!
//! Everything that jumps or kinks becomes switches (sign registers); everything with memory
//! becomes hidden states, held values or kept pasts.

use super::graph::{Column, Graph, Id, Level, Memory, Node, PassSwitches, Switch, Two, reachable};
use crate::expression::{BinaryOp, Expr, Foreign, Function};
use crate::model::Model;
use crate::{Error, Result};
use std::collections::{BTreeSet, HashMap};

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
    let mut builder =
        Builder { model, graph: Graph::default(), names: HashMap::new(), states: model.states.len() };
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
            Expr::Call(f, arguments) => {
                let ids: Result<Vec<Id>> = arguments.iter().map(|a| self.expression(a)).collect();
                self.call(*f, arguments, &ids?)
            }
        }
    }

    fn call(&mut self, f: Function, arguments: &[Expr], x: &[Id]) -> Result<Id> {
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
            Function::Delay => return self.delay(&arguments[0], x[0], x[1]),
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

    fn delay(&mut self, e: &Expr, x: Id, time: Id) -> Result<Id> {
        if self.graph.levels[time] > Level::Run {
            return Err(Error::bad_input("the time of delay(x, T) must not change during a run")
                .with_hint("make T a parameter or an expression of parameters"));
        }
        if self.graph.levels[x] <= Level::Time {
            return Ok(self.shifted(x, time));
        }
        if let Some(late) = self.late(e, time)? {
            return Ok(late);
        }
        let slot = self.graph.memories.iter().filter(|m| matches!(m, Memory::Past { .. })).count();
        self.graph.memories.push(Memory::Past { slot, signal: x, delay: time });
        Ok(self.graph.add(Node::Past(slot)))
    }

    /// What inputs make through memories, some time ago: the same memories of late inputs, whose kinks come at known
    /// times; `None` where a state takes part, or where so many delays of it are asked for that one memory with its past is
    /// less than a memory for each.
    fn late(&mut self, e: &Expr, by: Id) -> Result<Option<Id>> {
        let model = self.model;
        let definition = |n: &str| model.definitions.iter().find(|d| d.name == n);
        let mut reached = BTreeSet::new();
        let mut left = e.names();
        while let Some(name) = left.pop_first() {
            if reached.insert(name) {
                left.extend(definition(name).into_iter().flat_map(|d| d.equals.names()));
            }
        }
        if model.states.iter().any(|s| reached.contains(s.name.as_str())) {
            return Ok(None);
        }
        if self.delays_of(e) > COPIES {
            return Ok(None);
        }
        let now = self.names.clone();
        for name in model.inputs.iter().map(|i| i.name.as_str()).chain(["t"]) {
            let late = self.shifted(now[name], by);
            self.names.insert(name.to_string(), late);
        }
        for d in model.definition_order().map_err(|(_, e)| e)? {
            if reached.contains(d.name.as_str()) {
                let late = self.expression(&d.equals)?;
                self.names.insert(d.name.clone(), late);
            }
        }
        let late = self.expression(e)?;
        self.names = now;
        Ok(Some(late))
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

    /// A node of inputs and time alone, as it was some time ago.
    fn shifted(&mut self, x: Id, by: Id) -> Id {
        let mut map: HashMap<Id, Id> = HashMap::new();
        let needed = reachable(&self.graph, &[x], PassSwitches::Yes);
        for (id, _) in needed.iter().enumerate().filter(|(_, needed)| **needed) {
            let new = self.shifted_node(id, by, &map);
            map.insert(id, new);
        }
        map[&x]
    }

    fn shifted_node(&mut self, id: Id, by: Id, map: &HashMap<Id, Id>) -> Id {
        let g = &mut self.graph;
        if g.levels[id] <= Level::Run {
            return id;
        }
        match g.nodes[id] {
            Node::Time => g.difference(id, by),
            Node::Column(c) => {
                let Column { input, delay } = g.columns[c];
                let total = delay.map_or(by, |d| g.sum(d, by));
                g.column(Column { input, delay: Some(total) })
            }
            Node::Sign(k) => {
                let Switch { argument, half_width, at_zero, is_smooth, .. } = g.switches[k];
                match half_width {
                    None if is_smooth => g.side(map[&argument]),
                    Some(w) => g.relay(map[&argument], map.get(&w).copied().unwrap_or(w)),
                    None => g.sign(map[&argument], at_zero),
                }
            }
            Node::Two(op, a, b) => {
                let (a, b) = (map[&a], map[&b]);
                match op {
                    Two::Add => g.sum(a, b),
                    Two::Sub => g.difference(a, b),
                    Two::Mul => g.product(a, b),
                    Two::Div => g.quotient(a, b),
                    Two::Pow => g.power(a, b),
                    Two::Atan2 => g.atan2(a, b),
                }
            }
            Node::Negative(a) => g.negative(map[&a]),
            Node::One(f, a) => g.one(f, map[&a]),
            Node::Whole(a, n) => g.add(Node::Whole(map[&a], n)),
            Node::Select(s, a, b) => g.select(map[&s], map[&a], map[&b]),
            Node::Foreign(call, result) => {
                let (f, arguments) = g.calls[call].clone();
                let then: Vec<Id> = arguments.iter().map(|a| map.get(a).copied().unwrap_or(*a)).collect();
                g.foreign(Foreign::of(f.code(), result), &then)
            }
            _ => id,
        }
    }
}
