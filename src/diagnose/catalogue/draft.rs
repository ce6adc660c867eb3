//! A mechanism being placed in a model.

use super::edit::{self, Place};
use super::felt;
use super::scene::{Alone, Motion, Scene, Signal, is_temperature};
use crate::expression::{Expr, Function};
use crate::model::{Initial, Model, Parameter, State};
use crate::units::Unit;

/// What a site is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SiteKind {
    /// The rate of a state.
    State,
    /// An input, as the system feels it.
    Input,
    /// An output, as the sensor gives it.
    Output,
    /// A parameter.
    Parameter,
    /// A definition.
    Definition,
}

impl SiteKind {
    /// The word in reports.
    pub fn word(self) -> &'static str {
        match self {
            Self::State => "state",
            Self::Input => "input",
            Self::Output => "output",
            Self::Parameter => "parameter",
            Self::Definition => "definition",
        }
    }
}

/// Where a mechanism sits.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Site {
    /// What it is.
    pub kind: SiteKind,
    /// Its name in the model.
    pub name: String,
}

/// A parameter that a mechanism brings; SI.
#[derive(Debug, Clone)]
pub struct Added {
    /// Name in the extended model.
    pub name: String,
    /// Unit for people.
    pub unit: Unit,
}

/// A model with one mechanism more.
#[derive(Debug, Clone)]
pub struct Proposal {
    /// Code of the mechanism.
    pub code: &'static str,
    /// Where it sits.
    pub site: Site,
    /// The extended model.
    pub model: Model,
    /// What it adds to the fitted parameters.
    pub added: Vec<Added>,
    /// Names of the states that it adds.
    pub states: Vec<String>,
    /// Names of the parameters that it adds with a fixed value.
    pub constants: Vec<String>,
    /// Values of the added parameters to start from; each has a visible effect.
    pub starts: Vec<Vec<f64>>,
    /// Which added parameters scale the effect: at 0 there is none.
    pub amplitudes: Vec<usize>,
    /// The term as it stands in the equation.
    pub term: String,
    /// A sentence with `{name}` for the values of the added parameters.
    pub says: String,
    /// The mark of the recording that it acts in alone.
    pub alone: Option<String>,
    /// Signals that it brings in.
    pub depends: Vec<String>,
    /// Values of the added parameters at which it does nothing, where there are such.
    pub neutral: Option<Vec<f64>>,
    /// Limits of the added parameters.
    pub limits: Vec<Limits>,
    /// A parameter p of the model that makes up for it: what was p is p/(1 + a·level) with the first added parameter a.
    pub makes_up: Option<(String, f64)>,
    /// Whether it is asked for only in the place of what was found, as a finer form of it.
    pub refines: bool,
    /// Whether a state of the model is no longer what it was, so that no law is added beside it.
    pub ends: bool,
    /// What it puts in the place of what: new and old.
    pub replaced: Vec<(Expr, Expr)>,
}

impl Proposal {
    /// The model with every amplitude at zero.
    pub fn at_rest(&self) -> Model {
        let mut model = self.model.clone();
        for a in self.amplitudes.iter().map(|k| &self.added[*k]) {
            for p in model.parameters.iter_mut().filter(|p| p.name == a.name) {
                p.value = 0.0;
            }
        }
        model
    }

    fn signals(&self) -> impl Iterator<Item = &String> {
        let inputs = self.model.inputs.iter().map(|i| &i.name);
        self.model.states.iter().map(|s| &s.name).chain(inputs)
    }

    /// States and inputs that its term is a law of, not only turned by them; none where it remembers.
    pub fn law_of(&self) -> Vec<String> {
        // a term with a derivative is no expression
        let Ok(term) = Expr::parse(&self.term) else { return self.depends.clone() };
        if edit::find(&term, &|e| matches!(e, Expr::Call(f, _) if f.has_memory())).is_some() {
            return Vec::new();
        }
        self.signals().filter(|s| edit::is_plainly_in(&term, s)).cloned().collect()
    }

    /// States and inputs that its term follows in any way.
    pub fn follows(&self) -> Vec<&str> {
        // a term with a derivative is no expression
        let Ok(term) = Expr::parse(&self.term) else {
            return self.depends.iter().map(String::as_str).collect();
        };
        self.signals().filter(|s| term.mentions(s)).map(String::as_str).collect()
    }

    /// Whether its term is a sine or cosine of a state or of time, which may be faster than either.
    pub fn turns(&self) -> bool {
        let Ok(term) = Expr::parse(&self.term) else { return false };
        let follows = |e: &Expr| e.mentions("t") || self.model.states.iter().any(|s| e.mentions(&s.name));
        let is_turned = |e: &Expr| matches!(e, Expr::Call(Function::Sin | Function::Cos, _)) && follows(e);
        edit::find(&term, &is_turned).is_some()
    }

    /// What its term takes sines and cosines of, but for what it fits.
    pub fn harmonics(&self) -> Vec<Expr> {
        let Ok(term) = Expr::parse(&self.term) else { return Vec::new() };
        let mut found = Vec::new();
        term.visit(&mut |e| {
            if let Expr::Call(Function::Sin | Function::Cos, arguments) = e {
                let is_known = |x: &&Expr| !self.added.iter().any(|a| x.mentions(&a.name));
                found.extend(arguments.iter().filter(is_known).cloned());
            }
        });
        found
    }

    /// Whether its term has corners: a sign, a stop, a play.
    pub fn has_corners(&self) -> bool {
        let Ok(term) = Expr::parse(&self.term) else { return false };
        let bends = |e: &Expr| matches!(e, Expr::Call(f, _) if f.has_corners());
        edit::find(&term, &bends).is_some()
    }

    /// Whether its effect is a single force that may have one sign alone.
    pub fn is_one_sided(&self) -> bool {
        match self.amplitudes.as_slice() {
            [] => true,
            [one] => self.limits[*one].0 >= 0.0,
            _ => false,
        }
    }

    /// Numbers of its amplitudes among its model's parameters.
    pub fn amplitude_numbers(&self) -> Vec<usize> {
        self.amplitude_numbers_in(&self.model)
    }

    /// The same among those of a model in which others may have come or gone since it was proposed.
    pub fn amplitude_numbers_in(&self, model: &Model) -> Vec<usize> {
        let number = |k: &usize| model.parameters.iter().position(|p| p.name == self.added[*k].name);
        self.amplitudes.iter().filter_map(number).collect()
    }

    /// A start with its amplitudes at zero.
    pub fn quiet(&self, start: &[f64]) -> Vec<f64> {
        self.with_amplitudes(start, &vec![0.0; self.amplitudes.len()])
    }

    /// A start with its amplitudes at given values.
    pub fn with_amplitudes(&self, start: &[f64], values: &[f64]) -> Vec<f64> {
        let mut all = start.to_vec();
        for (at, value) in self.amplitudes.iter().zip(values) {
            all[*at] = value.clamp(self.limits[*at].0, self.limits[*at].1);
        }
        all
    }
}

/// How the meaning of a mark begins.
const MARKS: &str = "1 in the recording ";

/// Whether a parameter is the mark of a recording, which is 0 in the others and yet not idle.
pub fn is_mark(p: &Parameter) -> bool {
    !p.fit && p.meaning.as_ref().is_some_and(|m| m.starts_with(MARKS))
}

/// Limits of an added parameter, SI.
pub type Limits = (f64, f64);

/// Any value.
pub const ANY: Limits = (f64::NEG_INFINITY, f64::INFINITY);
/// Zero and above.
pub const POSITIVE: Limits = (0.0, f64::INFINITY);

/// A proposal in the making; a step that fails makes [`Draft::done`] give nothing.
pub struct Draft<'a> {
    scene: &'a Scene<'a>,
    proposal: Proposal,
    /// The recording in which it acts alone.
    one: Option<&'a Alone>,
    failed: bool,
}

impl<'a> Draft<'a> {
    /// Begins a mechanism at a site.
    pub fn new(scene: &'a Scene<'a>, code: &'static str, kind: SiteKind, name: &str) -> Self {
        let proposal = Proposal {
            code,
            site: Site { kind, name: name.to_string() },
            model: scene.model.clone(),
            added: Vec::new(),
            states: Vec::new(),
            constants: Vec::new(),
            starts: Vec::new(),
            amplitudes: Vec::new(),
            term: String::new(),
            says: String::new(),
            alone: None,
            depends: Vec::new(),
            neutral: None,
            limits: Vec::new(),
            makes_up: None,
            ends: false,
            refines: false,
            replaced: Vec::new(),
        };
        Self { scene, proposal, one: None, failed: false }
    }

    /// Begins a mechanism in the sum of forces at a state.
    pub fn at(scene: &'a Scene<'a>, code: &'static str, motion: &Motion) -> Self {
        Self::new(scene, code, SiteKind::State, &motion.state)
    }

    fn free_name(&self, wanted: &str) -> String {
        edit::free_name(&self.proposal.model, wanted, |n| self.scene.signal(n).is_some())
    }

    /// Adds a fitted parameter; returns its name in the model.
    pub fn parameter(&mut self, wanted: &str, unit: &Unit, limits: Limits, meaning: &str) -> String {
        let name = self.free_name(wanted);
        let finite = |x: f64| x.is_finite().then_some(x);
        let unit = unit.of_differences();
        self.proposal.model.parameters.push(Parameter {
            name: name.clone(),
            value: 0.0,
            unit: unit.clone(),
            fit: true,
            min: finite(limits.0),
            max: finite(limits.1),
            meaning: Some(meaning.to_string()),
        });
        self.proposal.added.push(Added { name: name.clone(), unit });
        self.proposal.limits.push(limits);
        name
    }

    /// Holds a parameter of the model at a value.
    pub fn hold(&mut self, name: &str, value: f64) {
        for p in self.proposal.model.parameters.iter_mut().filter(|p| p.name == name) {
            (p.fit, p.value) = (false, value);
        }
    }

    /// Asks for it only in the place of what was found.
    pub fn refines(&mut self) {
        self.proposal.refines = true;
    }

    /// Adds a fitted parameter that scales the effect.
    pub fn amplitude(&mut self, wanted: &str, unit: &Unit, limits: Limits, meaning: &str) -> String {
        self.proposal.amplitudes.push(self.proposal.added.len());
        match self.one {
            None => self.parameter(wanted, unit, limits, meaning),
            Some(one) => {
                let name = self.parameter(wanted, unit, limits, &format!("{meaning} in one recording"));
                format!("{name}*{}", one.mark)
            }
        }
    }

    /// Adds a parameter that is not fitted; returns its name.
    pub fn constant(&mut self, wanted: &str, unit: &Unit, value: f64, meaning: &str) -> String {
        let name = self.free_name(wanted);
        self.proposal.model.parameters.push(Parameter {
            name: name.clone(),
            value,
            unit: unit.of_differences(),
            fit: false,
            min: None,
            max: None,
            meaning: Some(meaning.to_string()),
        });
        self.proposal.constants.push(name.clone());
        name
    }

    /// Lets it act in one recording alone, where one is given: its amplitudes are multiplied by what is 1 there and 0 elsewhere.
    #[must_use]
    pub fn alone(mut self, one: Option<&'a Alone>) -> Self {
        let Some(own) = one else { return self };
        (self.one, self.proposal.alone) = (one, Some(own.mark.clone()));
        let model = &mut self.proposal.model;
        if model.parameters.iter().all(|p| p.name != own.mark) {
            let meaning = format!("{MARKS}'{}', 0 elsewhere", own.recording);
            model.parameters.push(Parameter {
                name: own.mark.clone(),
                value: 0.0,
                unit: Unit::one(),
                fit: false,
                min: None,
                max: None,
                meaning: Some(meaning),
            });
        }
        self
    }

    /// Adds a state that starts at a number; returns its name.
    pub fn state(&mut self, wanted: &str, unit: &Unit, initial: Initial, meaning: &str) -> String {
        let name = self.free_name(wanted);
        self.proposal.model.states.push(State {
            name: name.clone(),
            rate: Expr::Number(0.0),
            unit: unit.of_differences(),
            initial,
            meaning: Some(meaning.to_string()),
        });
        self.proposal.states.push(name.clone());
        name
    }

    /// A state is no longer what it was: laws that are added later would be laws of something else.
    pub fn ends(&mut self) {
        self.proposal.ends = true;
    }

    /// Brings a recorded channel into the model as an input, if it is not there yet.
    pub fn uses(&mut self, signal: &str) {
        use super::SignalKind;
        self.proposal.depends.push(signal.to_string());
        let Some(s) = self.scene.signal(signal).filter(|s| s.kind == SignalKind::Channel) else { return };
        if self.proposal.model.inputs.iter().all(|i| i.name != s.name) {
            self.proposal.model.inputs.push(crate::model::Input {
                name: s.name.clone(),
                unit: s.unit.clone(),
                meaning: None,
            });
        }
    }

    /// A signal as a coupling feels it: about its mean where that outweighs its motion.
    pub fn centred(&mut self, signal: &Signal) -> String {
        if signal.is_off_zero() { self.about_mean(signal) } else { signal.name.clone() }
    }

    /// A signal as what turns with a heading feels it: from its own zero, as a ship without speed has no error of speed;
    /// a temperature, whose zero is far, and a signal that nothing turns as above.
    pub fn turned(&mut self, signal: &Signal, factor: &str) -> String {
        if factor.is_empty() || is_temperature(&signal.unit) {
            return self.centred(signal);
        }
        signal.name.clone()
    }

    /// A signal about its mean.
    pub fn about_mean(&mut self, signal: &Signal) -> String {
        let name = format!("{}_mean", signal.name);
        let mean = self.constant(&name, &signal.unit, signal.mean, "mean of the recording");
        format!("({} - {mean})", signal.name)
    }

    fn read(&mut self, text: &str) -> Option<Expr> {
        let read = Expr::parse(text).ok();
        self.failed |= read.is_none();
        read
    }

    /// The rate of a state as it stands, in parentheses.
    pub fn rate_of(&self, state: &str) -> String {
        let own = self.proposal.model.states.iter().find(|s| s.name == state);
        own.map_or_else(String::new, |s| format!("({})", s.rate))
    }

    /// What a term in the innermost sum of a state's rate makes of that rate.
    pub fn felt(&mut self, state: &str, text: &str) -> Option<String> {
        let e = self.read(text)?;
        let model = &self.proposal.model;
        let state = model.states.iter().find(|s| s.name == state)?;
        Some(edit::with_sum(model, edit::opened(model, &state.rate), &|_| e.clone()).to_string())
    }

    /// Sets the rate of a state.
    pub fn rate(&mut self, state: &str, text: &str) {
        let Some(e) = self.read(text) else { return };
        match self.proposal.model.states.iter_mut().find(|s| s.name == state) {
            Some(s) => {
                let old = std::mem::replace(&mut s.rate, e.clone());
                if !self.proposal.states.contains(&s.name) {
                    self.proposal.replaced.push((e, old));
                }
            }
            None => self.failed = true,
        }
    }

    /// Adds a term to the innermost sum of a state's rate, also where that is a definition of its own, and to the
    /// outputs that give that rate.
    pub fn force(&mut self, state: &str, text: &str) {
        let Some(e) = self.read(text) else { return };
        let model = &mut self.proposal.model;
        let Some(i) = model.states.iter().position(|s| s.name == state) else {
            self.failed = true;
            return;
        };
        let home = edit::home(model, &model.states[i].rate);
        let old = edit::opened(model, &model.states[i].rate);
        let new = edit::with_sum(model, old, &|sum| edit::plus(sum, &e));
        let felt = edit::with_sum(model, old, &|_| e.clone());
        if self.proposal.term.is_empty() {
            self.proposal.term = felt.to_string();
        }
        let is_told = |e: &Expr| home.is_some_and(|d| edit::reaches(model, e, &model.definitions[d].name));
        let mut outputs = felt::outputs(model, &model.states[i], &felt);
        outputs.retain(|(k, _)| !is_told(&model.outputs[*k].equals));
        for (k, equals) in outputs {
            model.outputs[k].equals = equals;
        }
        match home {
            Some(d) => model.definitions[d].equals = new,
            None => model.states[i].rate = new,
        }
    }

    /// Adds a term to a definition.
    pub fn define(&mut self, definition: &str, text: &str) {
        let Some(e) = self.read(text) else { return };
        match self.proposal.model.definitions.iter_mut().find(|d| d.name == definition) {
            Some(d) => d.equals = edit::plus(&d.equals, &e),
            None => self.failed = true,
        }
        self.term(text);
    }

    /// Replaces an output's expression; `{}` in the text stands for the old one.
    pub fn output(&mut self, output: &str, text: &str) {
        let outputs = &self.proposal.model.outputs;
        let Some(old) = outputs.iter().find(|o| o.name == output).map(|o| o.equals.clone()) else {
            self.failed = true;
            return;
        };
        let new = text.replace("{}", &format!("({old})"));
        let Some(e) = self.read(&new) else { return };
        if let Some(o) = self.proposal.model.outputs.iter_mut().find(|o| o.name == output) {
            o.equals = e.clone();
        }
        self.proposal.replaced.push((e, old));
        self.term(&text.replace("{}", output));
    }

    /// Replaces a name by an expression wherever `here` allows; fails if it stands nowhere.
    pub fn replace(&mut self, name: &str, text: &str, here: impl Fn(Place<'_>) -> bool) {
        let Some(e) = self.read(text) else { return };
        let mut found = false;
        edit::for_each(&mut self.proposal.model, |place, expression| {
            if here(place) && expression.mentions(name) {
                *expression = expression.substitute(name, &e);
                found = true;
            }
        });
        self.failed |= !found;
        self.proposal.replaced.push((e, Expr::name(name)));
        self.term(text);
    }

    /// Rewrites subtrees of every expression; fails if nothing changed.
    pub fn rewrite(&mut self, with: &dyn Fn(Expr) -> Expr) {
        let mut found = false;
        edit::for_each(&mut self.proposal.model, |_, expression| {
            let new = edit::rebuilt(expression, with);
            found |= new != *expression;
            *expression = new;
        });
        self.failed |= !found;
    }

    /// Changes every rate and definition; fails if nothing changed.
    pub fn each_rate(&mut self, with: &dyn Fn(&Expr) -> Expr) {
        self.each_where(with, &|place| !matches!(place, Place::Output(_)));
    }

    /// Changes every expression, those of the outputs too; fails if no rate and no definition changed.
    pub fn each(&mut self, with: &dyn Fn(&Expr) -> Expr) {
        self.each_where(with, &|_| true);
    }

    /// Changes every expression at some places, as [`Self::each`] does.
    pub fn each_where(&mut self, with: &dyn Fn(&Expr) -> Expr, here: &dyn Fn(Place<'_>) -> bool) {
        let mut found = false;
        edit::for_each(&mut self.proposal.model, |place, expression| {
            if here(place) {
                let new = with(expression);
                found |= new != *expression && !matches!(place, Place::Output(_));
                *expression = new;
            }
        });
        self.failed |= !found;
    }

    /// Replaces the lag factor 1 + w²T² of a formula for trials.
    pub fn lag_factor(&mut self, text: &str) {
        let Some(new) = self.read(text) else { return };
        self.rewrite(&|e| if super::scene::lag_square(&e).is_some() { new.clone() } else { e });
        self.term(text);
    }

    /// Sets the term that reports show, unless it is set already.
    pub fn term(&mut self, text: &str) {
        if self.proposal.term.is_empty() {
            self.proposal.term = text.to_string();
        }
    }

    /// Shows in reports the first expression that is no longer the model's own.
    pub fn first_change(&mut self) {
        let (old, new) = (self.scene.model, &self.proposal.model);
        let defined =
            old.definitions.iter().map(|d| &d.equals).zip(new.definitions.iter().map(|d| &d.equals));
        let moved = old.states.iter().map(|s| &s.rate).zip(new.states.iter().map(|s| &s.rate));
        let changed = defined.chain(moved).find(|(a, b)| a != b).map(|(_, b)| b.to_string());
        self.term(&changed.unwrap_or_default());
    }

    /// Says that the law divides a parameter by 1 + a·level, a being the first of the added ones.
    pub fn divides(&mut self, parameter: &str, level: f64) {
        self.proposal.makes_up = Some((parameter.to_string(), level));
    }

    /// Adds a start of the added parameters, SI.
    pub fn start(&mut self, values: &[f64]) {
        if values.iter().all(|v| v.is_finite()) {
            self.proposal.starts.push(values.to_vec());
        }
    }

    /// What is added has units that a reader of the model is not asked about.
    fn in_plain_units(&mut self) {
        let given = self.scene.model.scope();
        let model = &mut self.proposal.model;
        model.in_si_where_asked(|name| !given.contains_key(name));
        for a in &mut self.proposal.added {
            if let Some(p) = model.parameters.iter().find(|p| p.name == a.name) {
                a.unit.clone_from(&p.unit);
            }
        }
    }

    /// The proposal with its sentence, unless a step failed.
    pub fn done(mut self, says: &str) -> Option<Proposal> {
        let alone = self.one.map(|one| format!("in the recording '{}' alone ", one.recording));
        self.proposal.says = format!("{}{says}", alone.unwrap_or_default());
        self.in_plain_units();
        self.proposal.neutral = neutral(&self.proposal);
        // The simulator chooses its steps at the model's own values.
        for (i, a) in self.proposal.added.iter().enumerate() {
            let value = self.proposal.starts.first().and_then(|s| s.get(i)).copied().unwrap_or(0.0);
            for p in self.proposal.model.parameters.iter_mut().filter(|p| p.name == a.name) {
                p.value = value;
            }
        }
        let whole = self.proposal.starts.iter().all(|s| s.len() == self.proposal.added.len());
        (!self.failed && whole && !self.proposal.starts.is_empty()).then_some(self.proposal)
    }
}

/// Amplitudes at zero; else times and widths at zero, levels at the limit at which nothing is cut off. A lag divides by its time, which
/// has no rest.
fn neutral(p: &Proposal) -> Option<Vec<f64>> {
    let start = p.starts.first()?;
    if !p.amplitudes.is_empty() {
        return Some(p.quiet(start));
    }
    let lags = |(new, _): &(Expr, Expr)| matches!(new, Expr::Call(Function::Lag, _));
    if p.replaced.iter().any(lags) {
        return None;
    }
    let is_floor = p.replaced.iter().any(|(new, _)| matches!(new, Expr::Call(Function::Max, _)));
    let at_rest = |l: &Limits| match *l {
        (low, high) if is_floor && low < high => Some(low),
        (0.0, _) => Some(0.0),
        (low, high) if p.code.contains("saturation") && low < high => Some(high),
        _ => None,
    };
    if p.added.is_empty() { None } else { p.limits.iter().map(at_rest).collect() }
}
