//! What a mechanism may look at when it proposes itself: the model, and the size of its signals.

use super::draft::{Draft, SiteKind};
use super::edit;
use crate::expression::{BinaryOp, Expr};
use crate::model::{Model, State};
use crate::units::Unit;
use std::collections::BTreeMap;

/// What a signal is in the model or the recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SignalKind {
    /// A state of the model.
    State,
    /// A measured input.
    Input,
    /// A definition.
    Definition,
    /// A predicted output.
    Output,
    /// A recorded channel that the model does not use.
    Channel,
}

/// A signal with its statistics over the fitted part; SI.
#[derive(Debug, Clone)]
pub struct Signal {
    /// Name in expressions.
    pub name: String,
    /// What it is.
    pub kind: SignalKind,
    /// Unit of the file.
    pub unit: Unit,
    /// Mean.
    pub mean: f64,
    /// Root mean square about the mean.
    pub spread: f64,
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Number of distinct values, counted up to 64.
    pub levels: usize,
    /// Time in which it changes by its own spread, s.
    pub pace: f64,
    /// Whether the model takes its sine.
    pub is_turned: bool,
}

/// Share of the recording at each end in which nothing sets in.
const ENDS: f64 = 0.05;
/// Parts of a recording between which something may begin.
const PARTS: u32 = 10;
/// An angle that goes further than this, rad, may go round.
const ROUND: f64 = 1.6;
/// Spreads from zero that are far.
const FAR: f64 = 3.0;

impl Signal {
    /// The site of what stands between it and the system.
    pub fn site(&self) -> SiteKind {
        if self.kind == SignalKind::Definition { SiteKind::Definition } else { SiteKind::Input }
    }

    /// Root mean square about zero.
    pub fn size(&self) -> f64 {
        self.mean.hypot(self.spread)
    }

    /// Whether it is an angle that turns far enough for its sine and cosine to matter.
    pub fn is_heading(&self) -> bool {
        self.is_far_round() || self.is_turned && self.is_angle()
    }

    /// Whether it is an angle that goes so far from zero that it may go round.
    pub fn is_far_round(&self) -> bool {
        self.is_angle() && self.min.abs().max(self.max.abs()) > ROUND
    }

    fn is_angle(&self) -> bool {
        self.unit.is_angle()
    }

    /// Whether its mean outweighs its motion.
    pub fn is_off_zero(&self) -> bool {
        self.mean.abs() >= 2.0 * self.spread
    }

    /// Whether it stays so far from zero that what happens near zero cannot be seen, as a temperature does.
    pub fn stays_off_zero(&self) -> bool {
        self.min.max(-self.max) > FAR * self.spread
    }

    /// Whether it moves at all.
    pub fn varies(&self) -> bool {
        self.spread > 1e-9 * self.size() && self.levels > 1
    }
}

/// A state at which forces act: the innermost sum of its rate.
#[derive(Debug, Clone)]
pub struct Motion {
    /// The state.
    pub state: String,
    /// The speed: the state itself where it is one.
    pub speed: Option<String>,
    /// The position: the state whose rate is the speed, or the state itself where it is no speed.
    pub position: Option<String>,
    /// Unit of the terms of the sum.
    pub force: Unit,
    /// Root mean square of the largest term of the sum.
    pub size: f64,
}

impl Motion {
    /// What a loss acts against: the speed, or a state that flows: a current, a flow of a volume or of a mass.
    pub fn flows(&self, scene: &Scene) -> Option<&String> {
        let unit = scene.unit(&self.state);
        let is = |u: &str| Unit::parse(u).is_ok_and(|u| u.dimension() == unit.dimension());
        self.speed.as_ref().or_else(|| ["A", "m^3/s", "kg/s"].into_iter().any(is).then_some(&self.state))
    }
}

/// A step of the level of an output's residual.
#[derive(Debug, Clone)]
pub struct Shift {
    /// The output.
    pub output: String,
    /// Times of the last sample before it and of the first after it, s.
    pub between: (f64, f64),
    /// How far the level moves, SI.
    pub size: f64,
}

/// A recording of several.
#[derive(Debug, Clone)]
pub struct Alone {
    /// The parameter that is 1 in it and 0 in the others.
    pub mark: String,
    /// Its name.
    pub recording: String,
}

/// The model as fitted so far, with what the recording showed.
#[derive(Clone)]
pub struct Scene<'a> {
    /// The model.
    pub model: &'a Model,
    /// Whether the recording is a table of trials.
    pub trials: bool,
    /// The signals.
    pub signals: Vec<Signal>,
    /// Pairs of inputs and channels that go together, so that their product has a mean.
    pub companions: Vec<(String, String)>,
    /// Size of the largest term of each state's sum, in the order of the states.
    pub sizes: Vec<f64>,
    /// What parameters multiply, where that is no plain signal, and its root mean square.
    pub arguments: Vec<(Expr, f64)>,
    /// Median step of the outputs' samples, s.
    pub step: f64,
    /// First fitted time, s.
    pub from: f64,
    /// Last fitted time, s.
    pub to: f64,
    /// First and last time of all that was recorded, held out or not, s.
    pub whole: (f64, f64),
    /// Names of the channels of each clock: a table, or an instrument of a log.
    pub tables: Vec<Vec<String>>,
    /// Least and largest measured value of each output, SI.
    pub measured: BTreeMap<String, (f64, f64)>,
    /// Angular frequencies at which the residual has lines, rad/s.
    pub peaks: Vec<f64>,
    /// Angular frequencies in space at which something is left, per unit of the position, by the state of a motion.
    pub lines: BTreeMap<String, Vec<f64>>,
    /// Steps of the level of the residual, one an output at most.
    pub shifts: Vec<Shift>,
    /// The recordings, where there are several.
    pub alone: Vec<Alone>,
    /// How many of the parameters are the given model's own; mechanisms added theirs behind.
    pub own_parameters: usize,
    /// The same of states.
    pub own_states: usize,
}

impl Scene<'_> {
    /// Where a constant may act: in all recordings, or in one of several alone.
    pub fn all_or_one(&self) -> impl Iterator<Item = Option<&Alone>> {
        std::iter::once(None).chain(self.alone.iter().map(Some))
    }

    /// The signal of a name.
    pub fn signal(&self, name: &str) -> Option<&Signal> {
        self.signals.iter().find(|s| s.name == name)
    }

    /// Signals of some kinds that move.
    pub fn moving<'s>(&'s self, kinds: &'s [SignalKind]) -> impl Iterator<Item = &'s Signal> + 's {
        self.signals.iter().filter(|s| kinds.contains(&s.kind) && s.varies())
    }

    /// What acts on the states as a command does: inputs, and definitions.
    pub fn commands(&self) -> impl Iterator<Item = &Signal> {
        let acts = |s: &&Signal| {
            let reaches = |x: &State| edit::reaches(self.model, &x.rate, &s.name);
            s.kind == SignalKind::Input || self.model.states.iter().any(reaches)
        };
        self.moving(&[SignalKind::Input, SignalKind::Definition]).filter(acts)
    }

    /// Inputs, and definitions that are made of an input and a state, as what a controller gives is.
    pub fn loops(&self) -> impl Iterator<Item = &Signal> {
        let made = |s: &&Signal| {
            let own = |n: &str| edit::reaches(self.model, &Expr::name(&s.name), n);
            let model = self.model;
            s.kind == SignalKind::Input
                || model.states.iter().any(|x| own(&x.name)) && model.inputs.iter().any(|u| own(&u.name))
        };
        self.commands().filter(made)
    }

    /// Whether the product of two signals may have a mean.
    pub fn keep_company(&self, a: &str, b: &str) -> bool {
        let is = |p: &(String, String)| p.0 == a && p.1 == b || p.0 == b && p.1 == a;
        a == b || self.companions.iter().any(is)
    }

    /// Inputs that are headings.
    pub fn headings(&self) -> Vec<&Signal> {
        let input = |s: &&Signal| s.kind == SignalKind::Input && s.is_heading();
        self.signals.iter().filter(input).collect()
    }

    /// Length of the fitted part, s.
    pub fn length(&self) -> f64 {
        (self.to - self.from).max(f64::MIN_POSITIVE)
    }

    /// The unit of an expression, spelled in the units of the model file.
    pub fn unit_of(&self, expression: &Expr) -> Unit {
        edit::unit_of(expression, &|name| {
            edit::unit_of_name(self.model, name).or_else(|| self.signal(name).map(|s| s.unit.clone()))
        })
    }

    /// The states at which forces act, with their speed and position.
    pub fn motions(&self) -> Vec<Motion> {
        if self.trials {
            return Vec::new();
        }
        let states = &self.model.states;
        let mut motions = Vec::new();
        for (state, size) in states.iter().zip(&self.sizes) {
            if edit::is_kinematic(self.model, &state.rate) {
                continue;
            }
            let above = states.iter().find(|s| edit::is_multiple_of(&s.rate, &state.name));
            let is_rate = edit::is_rate(&state.unit);
            let (speed, position) = match above {
                Some(q) => (Some(state.name.clone()), Some(q.name.clone())),
                None if is_rate => (Some(state.name.clone()), None),
                None => (None, Some(state.name.clone())),
            };
            let sum = self.unit_of(edit::sum_of(self.model, &state.rate));
            let force = edit::unit_of_force(sum, &state.unit);
            motions.push(Motion { state: state.name.clone(), speed, position, force, size: *size });
        }
        motions
    }

    /// Words for a signal: its meaning where the model gives one, else its name.
    pub fn words(&self, name: &str) -> String {
        crate::diagnose::words::signal(self.model, name)
    }

    /// Root mean square of a signal, 1 where it is not known.
    pub fn size(&self, name: &str) -> f64 {
        self.signal(name).map(Signal::size).filter(|s| *s > 0.0 && s.is_finite()).unwrap_or(1.0)
    }

    /// An expression at the sizes of its signals, without its sign; 1 where that is not known.
    pub fn size_of(&self, e: &Expr) -> f64 {
        let parameter = |n: &str| self.model.parameters.iter().find(|p| p.name == n).map(|p| p.value);
        let value = e.value(&|n| self.signal(n).map(Signal::size).or_else(|| parameter(n)));
        value.map(f64::abs).filter(|x| *x > 0.0 && x.is_finite()).unwrap_or(1.0)
    }

    /// Unit of a signal.
    pub fn unit(&self, name: &str) -> Unit {
        self.signal(name).map_or_else(Unit::one, |s| s.unit.of_differences())
    }

    /// Whether a signal is an angle by its unit.
    pub fn is_angle(&self, name: &str) -> bool {
        self.signal(name).is_some_and(Signal::is_angle)
    }

    /// Moments to start from, s: between equal parts of the recording.
    pub fn moments(&self) -> impl Iterator<Item = f64> {
        let part = |i| self.from + self.length() * f64::from(i) / f64::from(PARTS);
        (1..PARTS).map(part)
    }

    /// The times at which something may set in, s, that is a law of its own where it is there always.
    pub fn within(&self) -> (f64, f64) {
        let end = ENDS * self.length();
        (self.from + end, self.to - end)
    }

    /// Time constants to start from, s: over the decades between a step and the recording.
    pub fn times(&self) -> Vec<f64> {
        let last = 0.1 * self.length();
        let first = 2.0 * self.step;
        let count = 6;
        let ratio = (last / first).max(1.0).powf(1.0 / f64::from(count - 1));
        (0..count).map(|i| first * ratio.powi(i)).collect()
    }

    /// Delays to start from, s.
    pub fn delays(&self) -> Vec<f64> {
        let starts = [0.6, 1.5, 3.0, 6.0, 12.0, 25.0, 50.0, 100.0].map(|k| k * self.step);
        starts.into_iter().filter(|d| *d < 0.05 * self.length()).collect()
    }

    /// Angular frequencies to start a resonance from, rad/s.
    pub fn frequencies(&self) -> Vec<f64> {
        let last = 1.0 / self.step;
        let first = 20.0 / self.length();
        let ratio = (last / first).max(1.0).powf(0.2);
        self.peaks.iter().take(2).copied().chain((0..6).map(|i| first * ratio.powi(i))).collect()
    }

    /// What may stand behind a signal in a coupling: nothing, or the sine or cosine of a heading.
    pub fn factors(&self, signal: &Signal) -> Vec<String> {
        let mut factors = vec![String::new()];
        if signal.is_heading() {
            return factors;
        }
        let enough = if self.trials { 0.0 } else { 0.1 };
        for h in self.headings().iter().filter(|h| h.spread > enough) {
            factors.push(format!("*sin({})", h.name));
            factors.push(format!("*cos({})", h.name));
            if self.trials {
                factors.push(format!("*sin(2*{})", h.name));
                factors.push(format!("*cos(2*{})", h.name));
            }
        }
        factors
    }

    /// Parameters that may vary: the fitted ones, and the others where they are few.
    pub fn acting_parameters(&self) -> Vec<String> {
        let all = &self.model.parameters[..self.own_parameters];
        let few = all.len() <= 8;
        all.iter().filter(|p| p.fit || few).map(|p| p.name.clone()).collect()
    }

    /// The inputs of each table that holds inputs and no outputs, where there are several tables.
    pub fn clocks(&self) -> Vec<Vec<String>> {
        let model = self.model;
        if self.tables.len() < 2 {
            return Vec::new();
        }
        let own = |table: &&Vec<String>| !model.outputs.iter().any(|o| table.contains(&o.name));
        let inputs = |table: &Vec<String>| -> Vec<String> {
            model.inputs.iter().map(|i| i.name.clone()).filter(|n| table.contains(n)).collect()
        };
        self.tables.iter().filter(own).map(inputs).filter(|names: &Vec<String>| !names.is_empty()).collect()
    }

    /// The inputs that stand in the rows of an output, if there are any.
    pub fn rows(&self) -> Option<Vec<String>> {
        let (inputs, outputs) = (&self.model.inputs, &self.model.outputs);
        let has_output = |t: &&Vec<String>| outputs.iter().any(|o| t.contains(&o.name));
        let tables: Vec<&Vec<String>> = self.tables.iter().filter(has_output).collect();
        let names = inputs.iter().map(|i| i.name.clone()).filter(|n| tables.iter().any(|t| t.contains(n)));
        Some(names.collect()).filter(|names: &Vec<String>| !names.is_empty())
    }

    /// The inputs and the outputs of each table that holds outputs, where several do.
    pub fn sensor_clocks(&self) -> Vec<(Vec<String>, Vec<String>)> {
        let held = |table: &Vec<String>| {
            let inputs = self.model.inputs.iter().map(|i| i.name.clone());
            let outputs = self.model.outputs.iter().map(|o| o.name.clone());
            (
                inputs.filter(|n| table.contains(n)).collect::<Vec<_>>(),
                outputs.filter(|n| table.contains(n)).collect::<Vec<_>>(),
            )
        };
        let all: Vec<_> = self.tables.iter().map(held).filter(|(_, outputs)| !outputs.is_empty()).collect();
        if all.len() > 1 { all } else { Vec::new() }
    }

    /// A draft in a table of trials whose model has a lag factor 1 + w²T², with what it consists of.
    pub fn richer_lag(&self, code: &'static str) -> Option<(Draft<'_>, MasslessLag)> {
        let output = self.model.outputs.first().filter(|_| self.trials)?;
        let is_frequency = |name: &str| {
            let input = self.model.inputs.iter().find(|i| i.name == name);
            input.is_some_and(|i| edit::is_frequency(&i.unit))
        };
        let square = edit::find(&output.equals, &|e| {
            lag_square(e).is_some_and(|x| {
                self.model.inputs.iter().any(|i| is_frequency(&i.name) && x.mentions(&i.name))
            })
        })?;
        let square = lag_square(square)?.clone();
        let frequency =
            self.model.inputs.iter().find(|i| is_frequency(&i.name) && square.mentions(&i.name))?;
        let squared =
            |e: &Expr, n: &str| matches!(e, Expr::Binary(BinaryOp::Pow, a, _) if **a == Expr::Name(n.into()));
        let amplitude = self.model.inputs.iter().find(|i| {
            i.name != frequency.name && edit::find(&output.equals, &|e| squared(e, &i.name)).is_some()
        });
        let lag = MasslessLag {
            square: format!("({square})"),
            frequency: frequency.name.clone(),
            amplitude: amplitude.map(|a| a.name.clone()),
        };
        Some((Draft::new(self, code, SiteKind::Output, &output.name), lag))
    }
}

/// The factor 1 + w²T² of a massless lag in a formula for steady trials.
#[derive(Debug, Clone)]
pub struct MasslessLag {
    /// w²T² as it stands, in parentheses.
    pub square: String,
    /// The input w.
    pub frequency: String,
    /// The input that is an amplitude, if the formula has its square.
    pub amplitude: Option<String>,
}

impl MasslessLag {
    /// The unit of amplitude times w².
    pub fn acceleration_unit(&self, scene: &Scene) -> Unit {
        let w = scene.unit(&self.frequency).power(2.0);
        self.amplitude.as_ref().map_or_else(Unit::one, |a| scene.unit(a).times(&w))
    }
}

/// Whether values in a unit are temperatures, or differences of them.
pub(super) fn is_temperature(unit: &Unit) -> bool {
    Unit::parse("K").is_ok_and(|k| k.dimension() == unit.dimension())
}

/// X of 1 + X or X + 1, for a product or power X.
pub(super) fn lag_square(e: &Expr) -> Option<&Expr> {
    let Expr::Binary(BinaryOp::Add, a, b) = e else { return None };
    let product = |x: &Expr| matches!(x, Expr::Binary(BinaryOp::Mul | BinaryOp::Pow, _, _));
    match (&**a, &**b) {
        (Expr::Number(1.0), x) | (x, Expr::Number(1.0)) if product(x) => Some(x),
        _ => None,
    }
}
