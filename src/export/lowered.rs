//! A model in a form whose memories stand apart.
//!
//! Every call of a function with memory becomes a local value of its own, after what it needs; names are those of
//! the language.

use super::names::Names;
use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Definition, Model};
use crate::{Error, Result};

/// What a local value is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// An expression.
    Is(Expr),
    /// The hidden state of that number, which follows the signal in a time.
    Lag(usize, Expr, Expr),
    /// The play of that number: signal and gap.
    Play(usize, Expr, Expr),
    /// The relay of that number: signal and gap.
    Relay(usize, Expr, Expr),
    /// The rate limit of that number: signal and rate.
    Limit(usize, Expr, Expr),
    /// The signal whose past has that number, and how long ago.
    Past(usize, Expr, Expr),
    /// The sign of that number: its argument, and the sign of 0.
    Sign(usize, Expr, f64),
}

/// A value that has a name inside the functions.
#[derive(Debug, Clone)]
pub(super) struct Local {
    pub name: String,
    pub value: Value,
}

/// An input as it was some time ago.
#[derive(Debug, Clone)]
pub(super) struct Column {
    pub name: String,
    pub input: usize,
    /// An expression of parameters, s.
    pub ago: Expr,
}

/// How many memories of each kind there are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Counts {
    pub lags: usize,
    pub plays: usize,
    pub relays: usize,
    pub limits: usize,
    pub pasts: usize,
    pub signs: usize,
}

/// The model, lowered; inputs, parameters and outputs stay in the model.
#[derive(Debug)]
pub(super) struct Lowered<'a> {
    pub model: &'a Model,
    pub names: Names,
    pub columns: Vec<Column>,
    pub locals: Vec<Local>,
    /// Of the model's states, then of the lags.
    pub rates: Vec<Expr>,
    pub outputs: Vec<Expr>,
    pub counts: Counts,
}

impl<'a> Lowered<'a> {
    /// Lowers a model that compiles.
    pub fn of(model: &'a Model, reserved: &[&str]) -> Result<Self> {
        let names = Names::new(model, reserved);
        let (columns, locals) = (Vec::new(), Vec::new());
        let (rates, outputs) = (Vec::new(), Vec::new());
        let mut own = Self { model, names, columns, locals, rates, outputs, counts: Counts::default() };
        let order: Vec<&Definition> = model.definition_order().map_err(|(_, e)| e)?;
        for d in order {
            let value = Value::Is(own.expression(&d.equals)?);
            own.locals.push(Local { name: own.names.of(&d.name).to_string(), value });
        }
        for s in &model.states {
            let rate = own.expression(&s.rate)?;
            own.rates.push(rate);
        }
        for o in &model.outputs {
            let equals = own.expression(&o.equals)?;
            own.outputs.push(equals);
        }
        let lags: Vec<Expr> = own.locals.iter().filter_map(|l| l.value.rate(&l.name)).collect();
        own.rates.extend(lags);
        Ok(own)
    }

    /// Number of states, those of lags included.
    pub fn states(&self) -> usize {
        self.model.states.len() + self.counts.lags
    }

    /// Whether it is computed step by step; else every sample by itself.
    pub fn steps(&self) -> bool {
        let c = self.counts;
        self.states() + c.plays + c.limits + c.pasts > 0
    }

    /// Whether anything is kept beside the states.
    pub fn remembers(&self) -> bool {
        self.counts != Counts::default()
    }

    fn expression(&mut self, e: &Expr) -> Result<Expr> {
        Ok(match e {
            Expr::Number(_) => e.clone(),
            Expr::Name(name) => Expr::name(self.names.of(name)),
            Expr::Neg(a) => -self.expression(a)?,
            Expr::Binary(op, a, b) => {
                Expr::Binary(*op, Box::new(self.expression(a)?), Box::new(self.expression(b)?))
            }
            Expr::Call(Function::Delay, x) => self.delay(&x[0], &x[1])?,
            Expr::Call(f, x) => {
                let x: Vec<Expr> = x.iter().map(|x| self.expression(x)).collect::<Result<_>>()?;
                self.call(*f, x)
            }
        })
    }

    fn call(&mut self, f: Function, mut x: Vec<Expr>) -> Expr {
        let is_held = is_dynamic(self.model);
        let half = || Expr::number(0.5);
        match f {
            Function::Sign if is_held => self.local("sign", |k| Value::Sign(k, x[0].clone(), 0.0)),
            Function::Step if is_held => {
                let sign = self.local("sign", |k| Value::Sign(k, x[0].clone(), 1.0));
                half() + half() * sign
            }
            Function::Lag => self.local("lag", |k| Value::Lag(k, x[0].clone(), x[1].clone())),
            Function::Backlash => self.local("play", |k| Value::Play(k, x[0].clone(), x[1].clone())),
            Function::Hysteresis => {
                let play = self.local("play", |k| Value::Play(k, x[0].clone(), x[1].clone()));
                x.swap_remove(0) - play
            }
            Function::Relay => self.local("relay", |k| Value::Relay(k, x[0].clone(), x[1].clone())),
            Function::RateLimit => self.local("limited", |k| Value::Limit(k, x[0].clone(), x[1].clone())),
            _ => Expr::call(f, x),
        }
    }

    /// A local value with memory; equal ones are one.
    fn local(&mut self, like: &str, make: impl Fn(usize) -> Value) -> Expr {
        let same = |l: &&Local| l.value.number().is_some_and(|k| make(k) == l.value);
        if let Some(there) = self.locals.iter().find(same) {
            return Expr::name(&there.name);
        }
        let count = match make(0) {
            Value::Is(_) => return Expr::number(0.0),
            Value::Lag(..) => &mut self.counts.lags,
            Value::Play(..) => &mut self.counts.plays,
            Value::Relay(..) => &mut self.counts.relays,
            Value::Limit(..) => &mut self.counts.limits,
            Value::Past(..) => &mut self.counts.pasts,
            Value::Sign(..) => &mut self.counts.signs,
        };
        *count += 1;
        let value = make(*count - 1);
        let name = self.names.fresh(&format!("{like}_{count}"));
        self.locals.push(Local { name: name.clone(), value });
        Expr::name(name)
    }

    fn delay(&mut self, x: &Expr, ago: &Expr) -> Result<Expr> {
        let ago = inlined(self.model, ago);
        let signal = inlined(self.model, x);
        if is_data(self.model, &signal) {
            let shifted = self.shifted(&signal, &ago)?;
            return self.expression_of_columns(&shifted);
        }
        let (signal, ago) = (self.expression(x)?, self.expression(&ago)?);
        Ok(self.local("late", |k| Value::Past(k, signal.clone(), ago.clone())))
    }

    /// An expression of inputs and time alone as it was some time ago, its columns already in place.
    fn shifted(&mut self, e: &Expr, ago: &Expr) -> Result<Expr> {
        Ok(match e {
            Expr::Name(name) if name == "t" => Expr::name("t") - ago.clone(),
            Expr::Name(name) => match self.model.inputs.iter().position(|i| i.name == *name) {
                Some(input) => self.column(input, ago)?,
                None => e.clone(),
            },
            Expr::Call(Function::Delay, x) => {
                let longer = ago.clone() + inlined(self.model, &x[1]);
                self.shifted(&x[0], &longer)?
            }
            _ => {
                let mut failed = None;
                let new = e.map_children(&mut |part| {
                    self.shifted(part, ago).unwrap_or_else(|e| {
                        failed = Some(e);
                        part.clone()
                    })
                });
                return failed.map_or(Ok(new), Err);
            }
        })
    }

    fn column(&mut self, input: usize, ago: &Expr) -> Result<Expr> {
        let ago = self.expression(ago)?;
        if let Some(there) = self.columns.iter().find(|c| c.input == input && c.ago == ago) {
            return Ok(Expr::name(&there.name));
        }
        let own = self.names.of(&self.model.inputs[input].name).to_string();
        let name = self.names.fresh(&format!("{own}_late_{}", self.columns.len() + 1));
        self.columns.push(Column { name: name.clone(), input, ago });
        Ok(Expr::name(name))
    }

    /// As [`Self::expression`], where the names of columns stand already.
    fn expression_of_columns(&mut self, e: &Expr) -> Result<Expr> {
        match e {
            Expr::Call(Function::Delay, _) => Err(Error::not_computed("a delay was left where none can be")),
            _ => self.expression(e),
        }
    }
}

impl Value {
    /// The expressions that it is made of.
    pub fn parts(&self) -> Vec<&Expr> {
        match self {
            Self::Is(e) | Self::Sign(_, e, _) => vec![e],
            Self::Lag(_, a, b)
            | Self::Play(_, a, b)
            | Self::Relay(_, a, b)
            | Self::Limit(_, a, b)
            | Self::Past(_, a, b) => vec![a, b],
        }
    }

    /// The expressions that its memory is made of.
    pub fn remembered(&self) -> Vec<&Expr> {
        match self {
            Self::Lag(_, signal, _) | Self::Past(_, signal, _) => vec![signal],
            _ => self.parts(),
        }
    }

    /// The number of the memory that it has.
    fn number(&self) -> Option<usize> {
        match self {
            Self::Is(_) => None,
            Self::Lag(k, ..)
            | Self::Play(k, ..)
            | Self::Relay(k, ..)
            | Self::Limit(k, ..)
            | Self::Past(k, ..)
            | Self::Sign(k, ..) => Some(*k),
        }
    }

    /// The rate of the hidden state of a lag: (signal − itself)/time.
    fn rate(&self, name: &str) -> Option<Expr> {
        match self {
            Self::Lag(_, signal, time) => Some((signal.clone() - Expr::name(name)) / time.clone()),
            _ => None,
        }
    }
}

/// The expression without the names of definitions.
pub(super) fn inlined(model: &Model, e: &Expr) -> Expr {
    e.substitute_each(&|name| {
        let d = model.definitions.iter().find(|d| d.name == name)?;
        Some(inlined(model, &d.equals))
    })
}

/// Whether inputs, time and parameters alone make it, definitions already inlined.
fn is_data(model: &Model, e: &Expr) -> bool {
    let mut is_data = true;
    e.visit(&mut |part| match part {
        Expr::Name(name) => is_data &= !model.states.iter().any(|s| s.name == *name),
        Expr::Call(f, _) => is_data &= !f.keeps_state(),
        _ => {}
    });
    is_data
}

/// Whether the model is computed step by step, so that signs are held over a step.
fn is_dynamic(model: &Model) -> bool {
    let steps = |e: &Expr| {
        let mut found = false;
        e.visit(&mut |part| {
            found |= match part {
                Expr::Call(f, _) if f.keeps_state() => true,
                Expr::Call(Function::Delay, x) => !is_data(model, &inlined(model, &x[0])),
                _ => false,
            }
        });
        found
    };
    !model.states.is_empty() || super::refused::expressions(model).any(steps)
}

/// Whether an expression is a plain number or made of names that all pass.
pub(super) fn only(e: &Expr, is_wanted: &dyn Fn(&str) -> bool) -> bool {
    let mut all = true;
    e.visit(&mut |part| {
        all &= match part {
            Expr::Name(name) => is_wanted(name),
            Expr::Call(..) | Expr::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => false,
            _ => true,
        }
    });
    all
}
