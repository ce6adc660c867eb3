//! A second, slower simulation that shares no stepping with the first.
//!
//! # Purpose
//! Make recordings in which a common error of generator and simulator cannot hide.
//!
//! # Method
//! Expressions are walked as trees; the explicit midpoint rule takes many small steps a sample; parts
//! with memory are moved once a step. The simulator compiles its expressions, takes Runge-Kutta steps
//! and stops at events.
//!
//! # References
//! E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I (1993), II.1.

use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Initial, Model};
use crate::record::{Channel, Recording};
use std::collections::BTreeMap;

/// Steps a sample.
const STEPS: usize = 24;

/// A model being stepped over the inputs of a recording.
pub struct Stepper<'a> {
    model: &'a Model,
    inputs: Vec<&'a Channel>,
    parameters: BTreeMap<&'a str, f64>,
    states: Vec<f64>,
    memory: Vec<Option<f64>>,
    next: Vec<Option<f64>>,
    cell: usize,
    step: f64,
}

impl<'a> Stepper<'a> {
    /// Ready at the first time of the recording.
    pub fn new(model: &'a Model, recording: &'a Recording) -> Option<Self> {
        let inputs = model.inputs.iter().map(|i| recording.find(&i.name)).collect::<Option<Vec<_>>>()?;
        let start = |i: &Initial| if let Initial::Number(x) = i { *x } else { 0.0 };
        Some(Self {
            parameters: model.parameters.iter().map(|p| (p.name.as_str(), p.value)).collect(),
            states: model.states.iter().map(|s| start(&s.initial)).collect(),
            memory: Vec::new(),
            next: Vec::new(),
            cell: 0,
            step: 0.0,
            model,
            inputs,
        })
    }

    /// The outputs at some times, one list an output.
    pub fn outputs(&mut self, times: &[f64]) -> Vec<Vec<f64>> {
        let mut out = vec![Vec::with_capacity(times.len()); self.model.outputs.len()];
        for (k, t) in times.iter().enumerate() {
            if k > 0 {
                let (from, h) = (times[k - 1], (t - times[k - 1]) / STEPS as f64);
                for i in 0..STEPS {
                    self.advance(from + i as f64 * h, h);
                }
            }
            let (values, _) = self.look(*t);
            for (o, v) in out.iter_mut().zip(values) {
                o.push(v);
            }
        }
        out
    }

    /// x ← x + h f(t + h/2, x + h/2 f(t, x))
    fn advance(&mut self, t: f64, h: f64) {
        self.step = h;
        let old = self.states.clone();
        let (_, first) = self.look(t);
        for ((x, x0), f) in self.states.iter_mut().zip(&old).zip(&first) {
            *x = x0 + 0.5 * h * f;
        }
        let (_, middle) = self.look(t + 0.5 * h);
        for ((x, x0), f) in self.states.iter_mut().zip(&old).zip(&middle) {
            *x = x0 + h * f;
        }
        self.memory.clone_from(&self.next);
    }

    /// Outputs and rates; what the memories would become is kept aside.
    fn look(&mut self, t: f64) -> (Vec<f64>, Vec<f64>) {
        self.cell = 0;
        let model = self.model;
        let outputs = model.outputs.iter().map(|o| self.value(&o.equals, t)).collect();
        let rates = model.states.iter().map(|s| self.value(&s.rate, t)).collect();
        (outputs, rates)
    }

    fn value(&mut self, e: &Expr, t: f64) -> f64 {
        match e {
            Expr::Number(x) => *x,
            Expr::Name(n) => self.name(n, t),
            Expr::Neg(a) => -self.value(a, t),
            Expr::Binary(op, a, b) => {
                let (a, b) = (self.value(a, t), self.value(b, t));
                match op {
                    BinaryOp::Add => a + b,
                    BinaryOp::Sub => a - b,
                    BinaryOp::Mul => a * b,
                    BinaryOp::Div => a / b,
                    BinaryOp::Pow => a.powf(b),
                }
            }
            Expr::Call(Function::Delay, args) => {
                let late = self.value(&args[1], t);
                self.value(&args[0], t - late)
            }
            Expr::Call(f, args) => {
                let x: Vec<f64> = args.iter().map(|a| self.value(a, t)).collect();
                if f.has_memory() { self.remembered(*f, &x) } else { plain(*f, &x) }
            }
        }
    }

    fn name(&mut self, name: &str, t: f64) -> f64 {
        let model = self.model;
        if let Some(p) = self.parameters.get(name) {
            return *p;
        }
        if let Some(i) = model.states.iter().position(|s| s.name == name) {
            return self.states[i];
        }
        if let Some(i) = model.inputs.iter().position(|i| i.name == name) {
            return held(self.inputs[i], t);
        }
        match (name, model.definitions.iter().find(|d| d.name == name)) {
            (_, Some(d)) => self.value(&d.equals, t),
            ("pi", None) => std::f64::consts::PI,
            ("t", None) => t,
            _ => f64::NAN,
        }
    }

    fn remembered(&mut self, f: Function, x: &[f64]) -> f64 {
        let cell = self.cell;
        self.cell += 1;
        self.memory.resize(self.memory.len().max(cell + 1), None);
        self.next.resize(self.next.len().max(cell + 1), None);
        let start = if f == Function::Relay { 0.0 } else { x[0] };
        let old = self.memory[cell].unwrap_or(start);
        let (new, value) = match f {
            Function::Lag => {
                let new = if x[1] > 0.0 { x[0] + (old - x[0]) * (-self.step / x[1]).exp() } else { x[0] };
                (new, new)
            }
            Function::Backlash | Function::Hysteresis => {
                let new = old.clamp(x[0] - 0.5 * x[1].abs(), x[0] + 0.5 * x[1].abs());
                (new, if f == Function::Backlash { new } else { x[0] - new })
            }
            Function::RateLimit => {
                let most = x[1].abs() * self.step;
                let new = old + (x[0] - old).clamp(-most, most);
                (new, new)
            }
            _ => {
                let new = if x[0].abs() > 0.5 * x[1].abs() { x[0].signum() } else { old };
                (new, new)
            }
        };
        self.next[cell] = Some(new);
        value
    }
}

/// An input on the line between its samples, held at its ends.
fn held(c: &Channel, t: f64) -> f64 {
    c.value_at(t).unwrap_or_else(|| {
        let at_start = c.time.first().is_some_and(|first| t < *first);
        if at_start { c.values.first() } else { c.values.last() }.copied().unwrap_or(f64::NAN)
    })
}

fn plain(f: Function, x: &[f64]) -> f64 {
    match f {
        Function::Sin => x[0].sin(),
        Function::Cos => x[0].cos(),
        Function::Tan => x[0].tan(),
        Function::Asin => x[0].asin(),
        Function::Acos => x[0].acos(),
        Function::Atan => x[0].atan(),
        Function::Atan2 => x[0].atan2(x[1]),
        Function::Sinh => x[0].sinh(),
        Function::Cosh => x[0].cosh(),
        Function::Tanh => x[0].tanh(),
        Function::Exp => x[0].exp(),
        Function::Ln => x[0].ln(),
        Function::Sqrt => x[0].sqrt(),
        Function::Abs => x[0].abs(),
        Function::Sign if x[0] == 0.0 => 0.0,
        Function::Sign => x[0].signum(),
        Function::Min => x[0].min(x[1]),
        Function::Max => x[0].max(x[1]),
        Function::Step => f64::from(u8::from(x[0] >= 0.0)),
        Function::Clamp => x[0].max(x[1]).min(x[2]),
        Function::Curve | Function::Surface(..) => f.of(x),
        _ => f64::NAN,
    }
}
