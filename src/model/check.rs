//! Checks a model: names, cycles of definitions, dimensions through every expression.

use super::places::Places;
use super::{Definition, Model};
use crate::expression::{Expr, Scope, Units};
use crate::units::{Dimension, Unit};
use crate::{Error, Result};
use std::collections::{BTreeMap, HashMap, HashSet};

impl Model {
    /// Checks the model as a whole: distinct names, no cycles, dimensions of every expression, no unit that may mean
    /// turns or radians.
    ///
    /// # Errors
    /// The first thing wrong; a dimension error shows the expression and points at the term.
    pub fn check(&self) -> Result<()> {
        self.check_form()?;
        self.turns_or_radians(&Places::default())
    }

    /// As [`Model::check`] without the question of turns or radians, which is for people to answer.
    pub(crate) fn check_form(&self) -> Result<()> {
        self.check_at(&Places::default())
    }

    /// The dimensions of all names that expressions may use.
    pub fn scope(&self) -> Scope {
        self.names().into_iter().map(|(name, _, unit)| (name.to_string(), unit.dimension())).collect()
    }

    /// Every name that expressions may use, with its section and unit, in the model's order.
    pub(super) fn names(&self) -> Vec<(&str, &'static str, &Unit)> {
        let inputs = self.inputs.iter().map(|x| (x.name.as_str(), "inputs", &x.unit));
        let parameters = self.parameters.iter().map(|x| (x.name.as_str(), "parameters", &x.unit));
        let definitions = self.definitions.iter().map(|x| (x.name.as_str(), "definitions", &x.unit));
        let states = self.states.iter().map(|x| (x.name.as_str(), "states", &x.unit));
        inputs.chain(parameters).chain(definitions).chain(states).collect()
    }

    /// As [`Model::check`], with the places of a file.
    pub(super) fn check_at(&self, places: &Places) -> Result<()> {
        self.distinct_names()?;
        let scope = self.scope();
        let units: Units<'_> = self.names().into_iter().map(|(name, _, unit)| (name, unit)).collect();
        let check = |path: String, e: &Expr, wanted: &Unit| -> Result<()> {
            let printed = e.to_string();
            let text = places.text(&path).unwrap_or(&printed);
            let fits = || {
                e.expect_dimension(wanted.dimension(), &scope, text)?;
                e.expect_turning(wanted, &units, text)
            };
            let known = || e.expect_names(&scope, text);
            let checked = if self.is_free { known() } else { fits() };
            checked.and_then(|()| self.rising_knots(e)).map_err(|e| places.put(&path, e))
        };
        let second = Unit::of(Dimension::TIME);
        for d in &self.definitions {
            check(format!("definitions.{}.equals", d.name), &d.equals, &d.unit)?;
        }
        for s in &self.states {
            check(format!("states.{}.rate", s.name), &s.rate, &s.unit.over(&second))?;
        }
        for o in &self.outputs {
            check(format!("outputs.{}.equals", o.name), &o.equals, &o.unit)?;
        }
        self.definition_order().map(|_| ()).map_err(|(name, e)| {
            let path = format!("definitions.{name}.equals");
            places.put(&path, e)
        })
    }

    fn distinct_names(&self) -> Result<()> {
        let mut seen: BTreeMap<&str, &str> = BTreeMap::new();
        for (name, section, _) in self.names() {
            if let Some(other) = seen.insert(name, section) {
                let message = format!("the name {name:?} stands in [{other}] and in [{section}]");
                return Err(Error::bad_input(message).with_hint("rename one of them"));
            }
        }
        let both = self.outputs.iter().find(|o| self.inputs.iter().any(|i| i.name == o.name));
        match both {
            Some(o) => {
                let message = format!("{:?} is an input and an output", o.name);
                Err(Error::bad_input(message)
                    .with_hint("a measured signal drives the model or is predicted, not both"))
            }
            None => Ok(()),
        }
    }

    /// The definitions in an order in which each needs only earlier ones.
    ///
    /// # Errors
    /// A cycle, named from its first member around.
    pub(crate) fn definition_order(&self) -> Result<Vec<&Definition>, (String, Error)> {
        let numbers = self.definitions.iter().enumerate().map(|(i, d)| (d.name.as_str(), i)).collect();
        let mut walk = Walk {
            model: self,
            numbers,
            done: Vec::new(),
            is_begun: vec![false; self.definitions.len()],
            is_done: vec![false; self.definitions.len()],
            trail: Vec::new(),
        };
        for i in 0..self.definitions.len() {
            walk.visit(i)?;
        }
        Ok(walk.done)
    }

    /// Whether a name occurs in an expression or in a definition that it uses.
    pub(crate) fn reaches(&self, e: &Expr, name: &str) -> bool {
        e.mentions(name) || self.used_by(e).iter().any(|d| d.equals.mentions(name))
    }

    /// The definitions that an expression uses, by itself or through others, each once however often it stands.
    pub(crate) fn used_by<'a>(&'a self, e: &'a Expr) -> Vec<&'a Definition> {
        let (mut used, mut left) = (Vec::new(), vec![e]);
        let mut seen = HashSet::new();
        while let Some(e) = left.pop() {
            let fresh = e.names().into_iter().filter(|n| seen.insert(*n));
            let new: Vec<&Definition> =
                fresh.filter_map(|n| self.definitions.iter().find(|d| d.name == n)).collect();
            left.extend(new.iter().map(|d| &d.equals));
            used.extend(new);
        }
        used
    }
}

/// A walk over the definitions, what each uses first.
struct Walk<'a> {
    model: &'a Model,
    numbers: HashMap<&'a str, usize>,
    done: Vec<&'a Definition>,
    is_begun: Vec<bool>,
    is_done: Vec<bool>,
    /// The definitions begun, each with those that it uses and that are still to be looked at.
    trail: Vec<(usize, Vec<usize>)>,
}

impl Walk<'_> {
    fn visit(&mut self, first: usize) -> Result<(), (String, Error)> {
        self.begin(first)?;
        while let Some((own, uses)) = self.trail.last_mut() {
            let own = *own;
            if let Some(next) = uses.pop() {
                self.begin(next)?;
            } else {
                self.trail.pop();
                self.is_done[own] = true;
                self.done.push(&self.model.definitions[own]);
            }
        }
        Ok(())
    }

    fn begin(&mut self, own: usize) -> Result<(), (String, Error)> {
        if self.is_done[own] {
            return Ok(());
        }
        if self.is_begun[own] {
            return Err(self.circle(own));
        }
        let used = self.model.definitions[own].equals.names();
        let mut uses: Vec<usize> = used.into_iter().filter_map(|n| self.numbers.get(n).copied()).collect();
        uses.sort_unstable_by(|a, b| b.cmp(a));
        self.is_begun[own] = true;
        self.trail.push((own, uses));
        Ok(())
    }

    fn circle(&self, back_to: usize) -> (String, Error) {
        let name = |i: usize| self.model.definitions[i].name.as_str();
        let around = self.trail.iter().map(|t| t.0).skip_while(|i| *i != back_to).chain([back_to]);
        let around: Vec<&str> = around.map(name).collect();
        let message = format!("the definitions go in a circle: {}", around.join(" -> "));
        let e = Error::bad_input(message).with_hint("make one of them a state, or break the circle");
        (name(back_to).to_string(), e)
    }
}
