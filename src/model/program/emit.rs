//! Turns the graph into segments of register code.

use super::build::Built;
use super::code::{Action, Op};
use super::derive::{By, derivatives};
use super::foreign::Call;
use super::graph::{Graph, Id, Level, Memory, Node, PassSwitches, Two, reachable};
use super::{InputColumn, Program, Register, Remembered, Watch};
use crate::expression::Foreign;
use crate::model::Model;
use crate::{Error, Result};

/// Roots beyond the rates, as nodes.
struct Roots {
    /// Everything that the motion of the model depends on.
    moving: Vec<Id>,
    /// One for every switch.
    motions: Vec<Id>,
    slides: Vec<bool>,
    past_motions: Vec<Id>,
    jacobian: Vec<Id>,
    explicit_time: Vec<Id>,
}

/// The program of a built model.
pub(super) fn program(model: &Model, mut built: Built) -> Result<Program> {
    let roots = roots(&mut built);
    let mut emitter = Emitter::new(&built, &roots)?;
    let moving = reachable(&built.graph, &roots.moving, PassSwitches::Yes);
    let outputs: Vec<Id> = built.outputs.iter().chain(&built.definitions).copied().collect();
    let motion: Vec<Id> = roots.motions.iter().chain(&roots.past_motions).copied().collect();
    let slopes: Vec<Id> = roots.jacobian.iter().chain(&roots.explicit_time).copied().collect();
    let g = &built.graph;
    let within = |targets: &[Id]| reachable(g, targets, PassSwitches::Yes);
    let fresh = |targets: &[Id]| -> Vec<bool> {
        within(targets).iter().zip(&moving).map(|(t, m)| *t && !*m).collect()
    };
    let everything = vec![true; g.nodes.len()];
    emitter.once = emitter.segment(&everything, &moving, &[Level::Run]);
    let per_data = emitter.segment(&moving, &moving, &[Level::Data]);
    let per_time = emitter.segment(&moving, &moving, &[Level::Time]);
    let per_state = emitter.segment(&moving, &moving, &[Level::State]);
    let changing = [Level::Data, Level::Time, Level::State];
    let output_code = emitter.segment(&fresh(&outputs), &moving, &changing);
    let motion_code = emitter.segment(&fresh(&motion), &moving, &changing);
    let jacobian_code = emitter.segment(&fresh(&slopes), &moving, &changing);
    let watches = emitter.watches(&roots, &moving);
    let remembered = emitter.remembered(&roots);
    let registers = |ids: &[Id]| ids.iter().map(|id| emitter.register[*id]).collect::<Vec<_>>();
    Ok(Program {
        registers: g.nodes.len(),
        constants: emitter.constants(),
        parameters: (0..model.parameters.len()).map(|i| emitter.leaf(Node::Parameter(i))).collect(),
        time: emitter.leaf(Node::Time),
        states: (0..built.rates.len()).map(|i| emitter.leaf(Node::State(i))).collect(),
        columns: emitter.columns(),
        watches,
        remembered,
        rates: registers(&built.rates),
        outputs: registers(&built.outputs),
        definitions: registers(&built.definitions),
        jacobian: registers(&roots.jacobian),
        explicit_time: registers(&roots.explicit_time),
        once: emitter.once.clone(),
        per_data,
        per_time,
        per_state,
        motion_code,
        jacobian_code,
        output_code,
        calls: emitter.calls(),
        has_memory: !g.memories.is_empty() || g.switches.iter().any(|s| s.half_width.is_some()),
    })
}

fn roots(built: &mut Built) -> Roots {
    let g = &mut built.graph;
    let mut moving = built.rates.clone();
    let mut signals = Vec::new();
    for m in &g.memories {
        match *m {
            Memory::Hidden { rate, start, .. } => moving.extend([rate, start]),
            Memory::Held { next, start, .. } => moving.extend([next, start]),
            Memory::Past { signal, delay, slot: _ } => {
                moving.extend([signal, delay]);
                signals.push(signal);
            }
        }
    }
    for c in 0..g.columns.len() {
        moving.extend(g.columns[c].delay);
        moving.push(g.add(Node::Column(c)));
        g.add(Node::ColumnSlope(c));
    }
    for slot in 0..signals.len() {
        g.add(Node::Past(slot));
        g.add(Node::PastSlope(slot));
    }
    let relays: Vec<usize> = (0..g.switches.len()).filter(|k| g.switches[*k].half_width.is_some()).collect();
    moving.extend(relays.into_iter().map(|k| g.add(Node::Sign(k))));
    // The guard of a relay stands above its sign and is needed beside it.
    loop {
        let needed = reachable(g, &moving, PassSwitches::Yes);
        let missing: Vec<Id> = (0..g.nodes.len())
            .filter(|id| needed[*id])
            .filter_map(|id| if let Node::Sign(k) = g.nodes[id] { Some(g.switches[k].guard) } else { None })
            .filter(|guard| !needed[*guard])
            .collect();
        if missing.is_empty() {
            break;
        }
        moving.extend(missing);
    }
    // what a smooth switch does needs no event, so that nobody asks how its guard moves
    let still = g.constant(0.0);
    let guards: Vec<Id> = g.switches.iter().map(|s| if s.is_smooth { still } else { s.guard }).collect();
    let motions = derivatives(g, &guards, By::Motion(&built.rates));
    let past_motions = derivatives(g, &signals, By::Motion(&built.rates));
    let slides = motions.iter().enumerate().map(|(k, m)| depends_on_sign(g, *m, k)).collect();
    let mut jacobian = Vec::new();
    let by_state: Vec<Vec<Id>> =
        (0..built.rates.len()).map(|j| derivatives(g, &built.rates, By::State(j))).collect();
    for i in 0..built.rates.len() {
        jacobian.extend(by_state.iter().map(|column| column[i]));
    }
    let explicit_time = derivatives(g, &built.rates, By::Time);
    Roots { moving, motions, slides, past_motions, jacobian, explicit_time }
}

fn depends_on_sign(g: &mut Graph, motion: Id, switch: usize) -> bool {
    let sign = g.add(Node::Sign(switch));
    reachable(g, &[motion], PassSwitches::No)[sign]
}

struct Emitter<'a> {
    graph: &'a Graph,
    register: Vec<Register>,
    uses: Vec<usize>,
    once: Vec<Op>,
}

impl<'a> Emitter<'a> {
    fn new(built: &'a Built, roots: &Roots) -> Result<Self> {
        let graph = &built.graph;
        let register: Result<Vec<Register>> = (0..graph.nodes.len())
            .map(|id| {
                Register::try_from(id).map_err(|_| {
                    Error::bad_input("the model has more than 65 000 operations").with_hint("simplify it")
                })
            })
            .collect();
        let mut uses = vec![0; graph.nodes.len()];
        for node in &graph.nodes {
            for part in graph.parts(node) {
                uses[part] += 1;
            }
        }
        let named = [&built.rates, &built.outputs, &built.definitions, &roots.moving, &roots.motions];
        for id in
            named.into_iter().chain([&roots.past_motions, &roots.jacobian, &roots.explicit_time]).flatten()
        {
            uses[*id] += 2;
        }
        Ok(Self { graph, register: register?, uses, once: Vec::new() })
    }

    fn calls(&self) -> Vec<Call> {
        let call = |(f, arguments): &(Foreign, Vec<Id>)| {
            Some(Call {
                code: f.compute()?,
                arguments: arguments.iter().map(|a| self.register[*a]).collect(),
            })
        };
        self.graph.calls.iter().filter_map(call).collect()
    }

    fn leaf(&self, node: Node) -> Register {
        let at = self.graph.nodes.iter().position(|n| *n == node);
        at.map_or(Register::MAX, |id| self.register[id])
    }

    fn constants(&self) -> Vec<(Register, f64)> {
        let values =
            (0..self.graph.nodes.len()).filter_map(|id| Some((self.register[id], self.graph.value(id)?)));
        values.collect()
    }

    fn columns(&self) -> Vec<InputColumn> {
        let with_number = self.graph.columns.iter().enumerate();
        let column = |(c, column): (usize, &super::graph::Column)| InputColumn {
            input: column.input,
            delay: column.delay.map(|d| self.register[d]),
            value: self.leaf(Node::Column(c)),
            slope: self.leaf(Node::ColumnSlope(c)),
        };
        with_number.map(column).collect()
    }

    /// The switches that the motion depends on and that can change during a run.
    fn watches(&self, roots: &Roots, moving: &[bool]) -> Vec<Watch> {
        let watched = |id: Id| moving[id] && self.graph.levels[id] > Level::Run;
        (0..self.graph.nodes.len())
            .filter(|id| watched(*id))
            .filter_map(|id| if let Node::Sign(k) = self.graph.nodes[id] { Some((id, k)) } else { None })
            .filter(|(_, k)| !self.graph.switches[*k].is_smooth)
            .map(|(id, k)| Watch {
                sign: self.register[id],
                guard: self.register[self.graph.switches[k].guard],
                motion: self.register[roots.motions[k]],
                timed: self.graph.levels[id] == Level::Time,
                at_zero: f64::from(self.graph.switches[k].at_zero),
                may_slide: roots.slides[k] && self.graph.switches[k].half_width.is_none(),
            })
            .collect()
    }

    fn remembered(&self, roots: &Roots) -> Vec<Remembered> {
        let r = |id: Id| self.register[id];
        let one = |m: &Memory| match *m {
            Memory::Hidden { state, start, .. } => Remembered::Hidden { state, start: r(start) },
            Memory::Held { slot, next, start } => {
                Remembered::Held { held: self.leaf(Node::Held(slot)), next: r(next), start: r(start) }
            }
            Memory::Past { slot, signal, delay } => Remembered::Past {
                signal: r(signal),
                motion: r(roots.past_motions[slot]),
                delay: r(delay),
                value: self.leaf(Node::Past(slot)),
                slope: self.leaf(Node::PastSlope(slot)),
            },
        };
        self.graph.memories.iter().map(one).collect()
    }

    /// The instructions of the wanted nodes at the given levels, in order.
    fn segment(&self, wanted: &[bool], moving: &[bool], levels: &[Level]) -> Vec<Op> {
        let here = |id: Id| wanted[id] && levels.contains(&self.graph.levels[id]);
        let mut fused = vec![false; self.graph.nodes.len()];
        let mut code = Vec::new();
        for id in (0..self.graph.nodes.len()).rev().filter(|id| here(*id)) {
            if !fused[id] {
                code.extend(self.op(id, moving, &mut |part| {
                    let product = self.uses[part] == 1 && here(part);
                    fused[part] |= product;
                    product
                }));
            }
        }
        code.reverse();
        code
    }

    fn op(&self, id: Id, moving: &[bool], fuse: &mut dyn FnMut(Id) -> bool) -> Option<Op> {
        let r = |id: Id| self.register[id];
        let op = |action, a: Register, b: Register, c: Register| {
            Some(Op { action, to: self.register[id], a, b, c })
        };
        let product = |id: Id| match self.graph.nodes[id] {
            Node::Two(Two::Mul, a, b) => Some((a, b)),
            _ => None,
        };
        match self.graph.nodes[id] {
            Node::Two(two @ (Two::Add | Two::Sub), a, b) => {
                let sub = two == Two::Sub;
                if let Some((x, y)) = product(b).filter(|_| fuse(b)) {
                    return op(if sub { Action::MulSub } else { Action::MulAdd }, r(x), r(y), r(a));
                }
                if let Some((x, y)) = product(a).filter(|_| !sub && fuse(a)) {
                    return op(Action::MulAdd, r(x), r(y), r(b));
                }
                op(if sub { Action::Sub } else { Action::Add }, r(a), r(b), 0)
            }
            Node::Two(Two::Mul, a, b) => op(Action::Mul, r(a), r(b), 0),
            Node::Two(Two::Div, a, b) => op(Action::Div, r(a), r(b), 0),
            Node::Two(Two::Pow, a, b) => op(Action::Pow, r(a), r(b), 0),
            Node::Two(Two::Atan2, a, b) => op(Action::Atan2, r(a), r(b), 0),
            Node::Negative(a) => op(Action::Negative, r(a), 0, 0),
            Node::One(f, a) => op(Action::One(f), r(a), 0, 0),
            Node::Whole(a, 2) => op(Action::Square, r(a), 0, 0),
            Node::Whole(a, 3) => op(Action::Cube, r(a), 0, 0),
            Node::Whole(a, n) => op(Action::Whole, r(a), n as i16 as Register, 0),
            Node::Select(s, a, b) => op(Action::Select, r(s), r(a), r(b)),
            Node::Foreign(call, result) => op(Action::Foreign, call as Register, result, 0),
            Node::ForeignSlope(call, result, by) => op(Action::ForeignSlope, call as Register, result, by),
            Node::Sign(k) => {
                let switch = self.graph.switches[k];
                let held = moving[id] && self.graph.levels[id] > Level::Run && !switch.is_smooth;
                let (argument, at_zero) = (r(switch.argument), Register::from(switch.at_zero));
                match (switch.half_width, held) {
                    (Some(w), _) => op(Action::Relay, argument, r(w), 0),
                    (None, true) => op(Action::Sign, argument, at_zero, 0),
                    (None, false) => op(Action::SignNow, argument, at_zero, 0),
                }
            }
            _ => None,
        }
    }
}
