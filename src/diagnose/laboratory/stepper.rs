//! A second, slower simulation that shares no stepping with the first.
//!
//! # Purpose
//! Make recordings in which a common error of generator and simulator cannot hide.
//!
//! # Method
//! Expressions are walked as trees; the explicit midpoint rule takes many small steps a sample; parts
//! with memory are moved once a step, a lag as its input runs straight over the step. The simulator compiles its expressions, takes Runge-Kutta steps
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
    memory: Vec<Option<Memory>>,
    next: Vec<Option<Memory>>,
    cell: usize,
    /// Time since the memories were moved, s.
    since: f64,
}

/// What a part with memory holds, and what it was given, when it was moved.
#[derive(Clone, Copy)]
struct Memory {
    value: f64,
    given: f64,
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
            since: 0.0,
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
            if k == 0 {
                self.memory.clone_from(&self.next);
            }
            for (o, v) in out.iter_mut().zip(values) {
                o.push(v);
            }
        }
        out
    }

    /// x ← x + h f(t + h/2, x + h/2 f(t, x))
    fn advance(&mut self, t: f64, h: f64) {
        let old = self.states.clone();
        let (_, first) = self.look(t);
        for ((x, x0), f) in self.states.iter_mut().zip(&old).zip(&first) {
            *x = x0 + 0.5 * h * f;
        }
        self.since = 0.5 * h;
        let (_, middle) = self.look(t + 0.5 * h);
        for ((x, x0), f) in self.states.iter_mut().zip(&old).zip(&middle) {
            *x = x0 + h * f;
        }
        if !self.memory.is_empty() {
            self.since = h;
            self.look(t + h);
            self.memory.clone_from(&self.next);
        }
        self.since = 0.0;
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
        let Memory { value: old, given } = self.memory[cell].unwrap_or(Memory { value: start, given: x[0] });
        let (new, value) = match f {
            Function::Lag => {
                let new = lagged(old, [given, x[0]], x[1], self.since);
                (new, new)
            }
            Function::Backlash | Function::Hysteresis => {
                let new = old.clamp(x[0] - 0.5 * x[1].abs(), x[0] + 0.5 * x[1].abs());
                (new, if f == Function::Backlash { new } else { x[0] - new })
            }
            Function::RateLimit => {
                let most = x[1].abs() * self.since;
                let new = old + (x[0] - old).clamp(-most, most);
                (new, new)
            }
            _ => {
                let new = if x[0].abs() > 0.5 * x[1].abs() { x[0].signum() } else { old };
                (new, new)
            }
        };
        self.next[cell] = Some(Memory { value: new, given: x[0] });
        value
    }
}

/// T y' = u - y after a time s, of an input that runs straight from u0 to u1 = u0 + r s:
///
/// ```text
///     y = u1 - r T + (y0 - u0 + r T) exp(-s/T)
/// ```
fn lagged(old: f64, [from, to]: [f64; 2], lag: f64, since: f64) -> f64 {
    if lag <= 0.0 {
        return to;
    }
    if since <= 0.0 {
        return old;
    }
    let behind = lag * (to - from) / since;
    to - behind + (old - from + behind) * (-since / lag).exp()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Unit;

    /// T y' = t - y from rest is y = t - T (1 - exp(-t/T)).
    #[test]
    fn a_lag_of_a_ramp_is_the_closed_form() {
        let text = "name = 'm'\n[inputs]\nu = { unit = '1' }\n[parameters]\nT = { value = 2.5, unit = 's' }\n[outputs]\ny = { equals = 'lag(u, T)', unit = '1' }";
        let model = Model::parse(text).unwrap();
        let times: Vec<f64> = (0..20).map(f64::from).collect();
        let ramp = Channel::new("u", Unit::one(), times.clone(), times.clone());
        let recording = Recording::from_channels("r", vec![ramp]).unwrap();
        let y = Stepper::new(&model, &recording).unwrap().outputs(&times);
        for (t, y) in times.iter().zip(&y[0]) {
            assert!((y - (t - 2.5 * (1.0 - (-t / 2.5).exp()))).abs() < 1e-9, "{t} {y}");
        }
    }
}
