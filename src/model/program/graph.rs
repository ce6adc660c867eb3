//! The graph of a model's expressions: equal subexpressions are one node.
//!
//! Nodes are numbered so that parts come before what is made of them; constants fold on the way.
//! A node's level says when it must be computed anew: never, for a run, for a time of a recording, for a time of a run,
//! for a state.

use crate::expression::{Foreign, Function};
use std::collections::HashMap;

/// Number of a node.
pub(super) type Id = usize;

/// How often a node changes, slowest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Constant,
    Run,
    /// What the inputs and the time alone make, the same in every run.
    Data,
    Time,
    State,
}

/// Two-argument operations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Two {
    Add,
    Sub,
    Mul,
    Div,
    Pow,
    Atan2,
}

/// A node; constants by their bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Node {
    Constant(u64),
    Parameter(usize),
    Column(usize),
    ColumnSlope(usize),
    Time,
    State(usize),
    /// The sign register of a switch: ±1, or between while it slides.
    Sign(usize),
    /// A value kept since the end of the last step.
    Held(usize),
    /// A value that a signal had some time ago, and its slope then.
    Past(usize),
    PastSlope(usize),
    Two(Two, Id, Id),
    Negative(Id),
    One(Function, Id),
    Whole(Id, i32),
    /// The second where the first is positive, else the third.
    Select(Id, Id, Id),
    /// A result of a call of other people's code, by their numbers.
    Foreign(usize, u16),
    /// The derivative of such a result by an argument.
    ForeignSlope(usize, u16, u16),
}

/// A switch: its register is the sign of the argument, with memory for a relay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Switch {
    pub argument: Id,
    /// Half width of a relay.
    pub half_width: Option<Id>,
    /// What must keep the register's sign; equal to the argument but for a relay.
    pub guard: Id,
    /// The sign of 0: 0 or 1.
    pub at_zero: u8,
    /// Whether what it switches goes on with its value and slope, so that no event is needed.
    pub is_smooth: bool,
}

/// A column of input data: an input, perhaps some time ago.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Column {
    pub input: usize,
    pub delay: Option<Id>,
}

/// Something with memory, in the order in which they can start.
#[derive(Debug, Clone, Copy)]
pub(super) enum Memory {
    /// A hidden state: its number, its rate, its start.
    Hidden { state: usize, rate: Id, start: Id },
    /// A held value: its number, its next value, its start.
    Held { slot: usize, next: Id, start: Id },
    /// A signal whose past is kept: its number, itself, its slope, how long ago.
    Past { slot: usize, signal: Id, delay: Id },
}

#[derive(Debug, Default)]
pub(super) struct Graph {
    pub nodes: Vec<Node>,
    pub levels: Vec<Level>,
    index: HashMap<Node, Id>,
    pub switches: Vec<Switch>,
    pub columns: Vec<Column>,
    pub memories: Vec<Memory>,
    /// Calls of other people's code: any of its results, and the arguments.
    pub calls: Vec<(Foreign, Vec<Id>)>,
}

impl Graph {
    /// The node, new or as it stands already.
    pub fn add(&mut self, node: Node) -> Id {
        if let Some(id) = self.index.get(&node) {
            return *id;
        }
        let level = self.level_of(&node);
        self.nodes.push(node);
        self.levels.push(level);
        self.index.insert(node, self.nodes.len() - 1);
        self.nodes.len() - 1
    }

    fn level_of(&self, node: &Node) -> Level {
        match *node {
            Node::Constant(_) => Level::Constant,
            Node::Parameter(_) => Level::Run,
            Node::Column(c) if self.columns[c].delay.is_none() => Level::Data,
            Node::Time => Level::Data,
            Node::Column(_) | Node::ColumnSlope(_) => Level::Time,
            Node::State(_) | Node::Held(_) | Node::Past(_) | Node::PastSlope(_) => Level::State,
            Node::Sign(k) => self.switch_level(k),
            // no result of other people's code is a constant to us
            Node::Foreign(..) | Node::ForeignSlope(..) => self.together(self.parts(node)).max(Level::Run),
            _ => self.together(self.parts(node)),
        }
    }

    fn switch_level(&self, k: usize) -> Level {
        let s = self.switches[k];
        let width = s.half_width.map_or(Level::Constant, |w| self.levels[w]);
        // the simulation holds the sign
        match self.levels[s.argument].max(width).max(Level::Run) {
            Level::Data => Level::Time,
            level => level,
        }
    }

    /// The level of what is made of these.
    fn together(&self, parts: Vec<Id>) -> Level {
        let levels: Vec<Level> = parts.into_iter().map(|p| self.levels[p]).collect();
        match levels.iter().copied().max().unwrap_or(Level::Constant) {
            Level::Data if levels.contains(&Level::Run) => Level::Time,
            level => level,
        }
    }

    /// What a node is made of.
    pub fn parts(&self, node: &Node) -> Vec<Id> {
        match *node {
            Node::Two(_, a, b) => vec![a, b],
            Node::Negative(a) | Node::One(_, a) | Node::Whole(a, _) => vec![a],
            Node::Select(s, a, b) => vec![s, a, b],
            Node::Foreign(call, _) | Node::ForeignSlope(call, ..) => self.calls[call].1.clone(),
            Node::Sign(k) => {
                let s = self.switches[k];
                std::iter::once(s.argument).chain(s.half_width).collect()
            }
            _ => Vec::new(),
        }
    }

    pub fn constant(&mut self, value: f64) -> Id {
        self.add(Node::Constant(value.to_bits()))
    }

    /// The value of a constant node.
    pub fn value(&self, id: Id) -> Option<f64> {
        match self.nodes[id] {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    pub fn sum(&mut self, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => self.constant(x + y),
            (Some(0.0), _) => b,
            (_, Some(0.0)) => a,
            _ => self.add(Node::Two(Two::Add, a, b)),
        }
    }

    pub fn difference(&mut self, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => self.constant(x - y),
            (Some(0.0), _) => self.negative(b),
            (_, Some(0.0)) => a,
            _ => self.add(Node::Two(Two::Sub, a, b)),
        }
    }

    pub fn product(&mut self, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => self.constant(x * y),
            (Some(0.0), _) | (_, Some(1.0)) => a,
            (_, Some(0.0)) | (Some(1.0), _) => b,
            (_, Some(-1.0)) => self.negative(a),
            (Some(-1.0), _) => self.negative(b),
            _ => self.add(Node::Two(Two::Mul, a, b)),
        }
    }

    pub fn quotient(&mut self, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => self.constant(x / y),
            (_, Some(1.0)) => a,
            _ if self.levels[b] <= Level::Run && self.levels[a] > Level::Run => {
                // a/b = a·(1/b), with 1/b computed once in a run
                let one = self.constant(1.0);
                let inverse = self.quotient(one, b);
                self.product(a, inverse)
            }
            _ => self.add(Node::Two(Two::Div, a, b)),
        }
    }

    pub fn negative(&mut self, a: Id) -> Id {
        match (self.value(a), self.nodes[a]) {
            (Some(x), _) => self.constant(-x),
            (None, Node::Negative(inner)) => inner,
            _ => self.add(Node::Negative(a)),
        }
    }

    pub fn power(&mut self, a: Id, b: Id) -> Id {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => self.constant(x.powf(y)),
            (_, Some(1.0)) => a,
            (_, Some(0.5)) => self.one(Function::Sqrt, a),
            (_, Some(y)) if y.fract() == 0.0 && y.abs() <= 16.0 => self.add(Node::Whole(a, y as i32)),
            _ => self.add(Node::Two(Two::Pow, a, b)),
        }
    }

    pub fn one(&mut self, f: Function, a: Id) -> Id {
        match self.value(a) {
            Some(x) => self.constant(f.of(&[x])),
            None => self.add(Node::One(f, a)),
        }
    }

    /// A result of other people's code; equal calls are one.
    pub fn foreign(&mut self, f: Foreign, arguments: &[Id]) -> Id {
        let whole = Foreign::of(f.code(), 0);
        let call = self.calls.iter().position(|c| c.0 == whole && c.1 == arguments).unwrap_or_else(|| {
            self.calls.push((whole, arguments.to_vec()));
            self.calls.len() - 1
        });
        self.add(Node::Foreign(call, f.result))
    }

    pub fn atan2(&mut self, a: Id, b: Id) -> Id {
        self.add(Node::Two(Two::Atan2, a, b))
    }

    pub fn select(&mut self, sign: Id, a: Id, b: Id) -> Id {
        match self.value(sign) {
            _ if a == b => a,
            Some(s) => {
                if s > 0.0 {
                    a
                } else {
                    b
                }
            }
            None => self.add(Node::Select(sign, a, b)),
        }
    }

    /// The sign of a node, as a switch; equal arguments share one.
    pub fn sign(&mut self, argument: Id, at_zero: u8) -> Id {
        if let Some(x) = self.value(argument) {
            return self.constant(if x == 0.0 { f64::from(at_zero) } else { x.signum() });
        }
        self.switch(Switch { argument, half_width: None, guard: argument, at_zero, is_smooth: false })
    }

    /// On which side of 0 a node is, where the value of what it decides is the same on both: no event is needed.
    pub fn side(&mut self, argument: Id) -> Id {
        if let Some(x) = self.value(argument) {
            return self.constant(if x > 0.0 { 1.0 } else { 0.0 });
        }
        self.switch(Switch { argument, half_width: None, guard: argument, at_zero: 0, is_smooth: true })
    }

    fn switch(&mut self, new: Switch) -> Id {
        let k = self.switches.iter().position(|s| *s == new).unwrap_or_else(|| {
            self.switches.push(new);
            self.switches.len() - 1
        });
        self.add(Node::Sign(k))
    }

    /// A relay of a node: ±1, switching half a width beyond zero.
    pub fn relay(&mut self, argument: Id, half_width: Id) -> Id {
        let k = self.switches.len();
        self.switches.push(Switch {
            argument,
            half_width: Some(half_width),
            guard: argument,
            at_zero: 1,
            is_smooth: false,
        });
        let sign = self.add(Node::Sign(k));
        // g = x + r·w/2 keeps the sign of r between its switchings
        let shift = self.product(sign, half_width);
        self.switches[k].guard = self.sum(argument, shift);
        sign
    }

    pub fn column(&mut self, column: Column) -> Id {
        let c = self.columns.iter().position(|c| *c == column).unwrap_or_else(|| {
            self.columns.push(column);
            self.columns.len() - 1
        });
        self.add(Node::Column(c))
    }
}

/// Whether the argument of a switch counts as needed by what uses the switch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PassSwitches {
    Yes,
    No,
}

/// Which nodes the targets are made of, themselves included.
pub(super) fn reachable(graph: &Graph, targets: &[Id], pass: PassSwitches) -> Vec<bool> {
    let mut needed = vec![false; graph.nodes.len()];
    for t in targets {
        needed[*t] = true;
    }
    for id in (0..graph.nodes.len()).rev() {
        let through = pass == PassSwitches::Yes || !matches!(graph.nodes[id], Node::Sign(_));
        if needed[id] && through {
            for part in graph.parts(&graph.nodes[id]) {
                needed[part] = true;
            }
        }
    }
    needed
}
