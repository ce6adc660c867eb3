//! A finding's effect, watched along the run of the model that has it.

use super::bins::{WILD, between};
use crate::diagnose::bench::Bench;
use crate::diagnose::catalogue::{self, Proposal, edit};
use crate::estimate::Fit;
use crate::estimate::fit::{Effort, setup};
use crate::estimate::smooth::Smoother;
use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Definition, Model, Output, Parameter};
use crate::record::Channel;
use crate::units::Unit;
use std::collections::HashMap;

/// A model with expressions to be watched instead of outputs.
pub struct Probe {
    model: Model,
    copies: Vec<Definition>,
    watched: Vec<Expr>,
}

impl Probe {
    /// A probe of a model; nothing is watched yet.
    pub fn of(model: &Model) -> Self {
        Self { model: model.clone(), copies: Vec::new(), watched: Vec::new() }
    }

    /// A parameter with a value of its own, for [`Probe::watch`].
    pub fn constant(&mut self, value: f64, unit: &Unit) -> Expr {
        let taken = |n: &str| self.model.parameters.iter().any(|p| p.name == n);
        let mut number = self.model.parameters.len();
        while taken(&format!("watched_value_{number}")) {
            number += 1;
        }
        let name = format!("watched_value_{number}");
        self.model.parameters.push(Parameter {
            name: name.clone(),
            value,
            unit: unit.clone(),
            fit: false,
            min: None,
            max: None,
            meaning: None,
        });
        Expr::name(name)
    }

    /// Adds an expression to be watched.
    pub fn watch(&mut self, e: Expr) {
        self.watched.push(e);
    }

    /// An expression that is changed, in the definitions that it uses as well: those that the change reaches stand a
    /// second time, under names of their own.
    pub fn variant(&mut self, e: &Expr, change: &dyn Fn(&Expr) -> Expr) -> Expr {
        let mut by: HashMap<String, Expr> = HashMap::new();
        let mut stem = "watched_copy_".to_string();
        let taken = self.model.scope();
        while taken.keys().any(|n| n.starts_with(&stem)) {
            stem.push('_');
        }
        for d in self.model.definition_order().unwrap_or_default() {
            let equals = change(&d.equals).substitute_each(&|n| by.get(n).cloned());
            if equals != d.equals {
                let name = format!("{stem}{}", self.copies.len());
                by.insert(d.name.clone(), Expr::name(name.clone()));
                self.copies.push(Definition { name, equals, ..d.clone() });
            }
        }
        change(e).substitute_each(&|n| by.get(n).cloned())
    }

    /// The values of all that is watched at times of the first recording: rows of time and values.
    pub fn run(mut self, bench: &Bench, fit: &Fit, times: &[f64]) -> Option<Vec<(f64, Vec<f64>)>> {
        self.model.definitions.append(&mut self.copies);
        let given = std::mem::take(&mut self.model.outputs);
        let outputs = self.watched.iter().enumerate();
        self.model.outputs = outputs
            .map(|(i, e)| Output {
                name: format!("watched_{i}"),
                unit: edit::unit_of(e, &|n| edit::unit_of_name(&self.model, n)),
                equals: e.clone(),
                meaning: None,
            })
            .collect();
        let mut recording = bench.recordings.first()?.clone();
        recording.channels.retain(|c| given.iter().all(|o| o.name != c.name));
        for o in &self.model.outputs {
            let none = vec![0.0; times.len()];
            recording.channels.push(Channel::new(o.name.clone(), o.unit.clone(), times.to_vec(), none));
        }
        let spans = bench.spans(&fit.model, 0);
        let record =
            setup::record(&self.model, &recording, 0, &spans, &bench.options(Effort::Near, 0)).ok()?;
        let parameters: Vec<f64> = self.model.parameters.iter().map(|p| p.value).collect();
        let run = record.run(&parameters, &fit.records.first()?.initials, &[]).ok()?;
        let value = |i: usize, t: f64| {
            let k = record.tracks.iter().position(|track| track.output == i)?;
            let at = record.tracks[k].time.binary_search_by(|x| x.total_cmp(&t)).ok()?;
            run.predictions[k].get(at).copied()
        };
        let rows = times.iter().filter_map(|t| {
            let row: Option<Vec<f64>> = (0..self.watched.len()).map(|i| value(i, *t)).collect();
            row.map(|r| (*t, r))
        });
        Some(rows.collect())
    }
}

/// The signal that a finding goes with.
pub struct Accused {
    /// Its name, or that it is the rate of a name.
    pub words: String,
    /// The signal.
    pub along: Expr,
    /// Unit of what is drawn.
    pub unit: Unit,
    /// Whether the signal's rate is drawn.
    is_rate: bool,
}

impl Accused {
    /// What a finding brings in, else what its term or its site names; of a shift in time the rate of what it shifts.
    /// Time is drawn in the unit of a clock.
    pub fn of(model: &Model, p: &Proposal, clock: &Unit) -> Self {
        if catalogue::find(p.code).is_ok_and(|m| m.shifts_time) {
            // u(t + τ) − u(t) = τ u̇ + …, and of a lag y − u = −T ẏ
            let (mut name, mut along, unit) = signal(model, &p.site.name);
            if let Some(lag) = Expr::parse(&p.term).ok().filter(|e| is_lag(e) && along == Expr::name(&name)) {
                (name, along) = (lag.to_string(), lag);
            }
            let unit = Unit::parse("s").map_or_else(|_| unit.clone(), |s| unit.over(&s));
            return Self { words: format!("rate of {name}"), along, unit, is_rate: true };
        }
        let (words, along, unit) = accused(model, p);
        let unit = if words == "t" { clock.clone() } else { unit };
        Self { words, along, unit, is_rate: false }
    }

    /// What is drawn along the axis, in its unit, for each row whose first value is the signal.
    pub fn values(&self, rows: &[(f64, Vec<f64>)]) -> Vec<f64> {
        let own: Vec<f64> = rows.iter().map(|r| r.1[0]).collect();
        if !self.is_rate {
            return own.into_iter().map(|x| self.unit.from_si(x)).collect();
        }
        let kept: Vec<usize> = (0..own.len()).filter(|i| own[*i].is_finite()).collect();
        let (time, level): (Vec<f64>, Vec<f64>) = kept.iter().map(|i| (rows[*i].0, own[*i])).unzip();
        let mut rates = vec![f64::NAN; own.len()];
        if let Some(smoother) = Smoother::new(&time, &level) {
            kept.iter().enumerate().for_each(|(k, i)| rates[*i] = self.unit.from_si(smoother.jet(k)[1]));
        }
        let (low, high) = between(rates.iter().copied(), WILD);
        rates.into_iter().map(|r| if r >= low && r <= high { r } else { f64::NAN }).collect()
    }
}

fn is_lag(e: &Expr) -> bool {
    matches!(e, Expr::Call(Function::Lag, _))
}

/// What a finding brings in, else what its term or its site names.
fn accused(model: &Model, p: &Proposal) -> (String, Expr, Unit) {
    let is_signal = |n: &str| {
        model.states.iter().any(|s| s.name == n)
            || model.inputs.iter().any(|i| i.name == n)
            || model.definitions.iter().any(|d| d.name == n)
            || model.outputs.iter().any(|o| o.name == n)
    };
    let term = Expr::parse(&p.term).ok();
    if let Some(apart) = term.as_ref().and_then(|e| difference(p, e)) {
        let unit = edit::unit_of(&apart, &|n| edit::unit_of_name(model, n));
        return (apart.to_string(), apart, unit);
    }
    let named = term.iter().flat_map(|e| e.names().into_iter().map(str::to_string).collect::<Vec<_>>());
    let candidates = p.depends.iter().cloned().chain(named);
    let with_site = candidates.chain(std::iter::once(p.site.name.clone()));
    let mut usable = with_site.filter(|n| is_signal(n));
    let over_time = term.as_ref().is_some_and(|e| e.mentions("t"));
    let Some(name) = usable.next().filter(|_| !over_time) else {
        return ("t".into(), Expr::name("t"), edit::unit_of_name(model, "t").unwrap_or_else(Unit::one));
    };
    signal(model, &name)
}

/// The difference of two signals that a finding brings in, where its term goes with it: a flow between two levels.
fn difference(p: &Proposal, term: &Expr) -> Option<Expr> {
    let is_own = |e: &Expr| matches!(e, Expr::Name(n) if p.depends.contains(n));
    let is_apart =
        |e: &Expr| matches!(e, Expr::Binary(BinaryOp::Sub, a, b) if is_own(a) && is_own(b) && a != b);
    edit::find(term, &is_apart).cloned()
}

/// A signal by its name.
fn signal(model: &Model, name: &str) -> (String, Expr, Unit) {
    if let Some(o) = model.outputs.iter().find(|o| o.name == name && !is_inner(model, name)) {
        return (name.to_owned(), o.equals.clone(), o.unit.clone());
    }
    let unit = edit::unit_of_name(model, name).unwrap_or_else(Unit::one);
    (name.to_owned(), Expr::name(name), unit)
}

fn is_inner(model: &Model, name: &str) -> bool {
    edit::unit_of_name(model, name).is_some()
}
