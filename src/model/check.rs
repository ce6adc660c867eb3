//! Checks a model: names, cycles of definitions, dimensions through every expression.

use super::places::Places;
use super::{Definition, Model};
use crate::expression::{Expr, Scope};
use crate::units::Dimension;
use crate::{Error, Result};
use std::collections::BTreeMap;

impl Model {
    /// Checks the model as a whole: distinct names, no cycles, dimensions of every expression.
    ///
    /// # Errors
    /// The first thing wrong; a dimension error shows the expression and points at the term.
    pub fn check(&self) -> Result<()> {
        self.check_at(&Places::default())
    }

    /// The dimensions of all names that expressions may use.
    pub fn scope(&self) -> Scope {
        self.names().into_iter().map(|(name, _, d)| (name.to_string(), d)).collect()
    }

    /// Every name that expressions may use, with its section and dimension, in the model's order.
    fn names(&self) -> Vec<(&str, &'static str, Dimension)> {
        let inputs = self.inputs.iter().map(|x| (x.name.as_str(), "inputs", x.unit.dimension()));
        let parameters = self.parameters.iter().map(|x| (x.name.as_str(), "parameters", x.unit.dimension()));
        let definitions =
            self.definitions.iter().map(|x| (x.name.as_str(), "definitions", x.unit.dimension()));
        let states = self.states.iter().map(|x| (x.name.as_str(), "states", x.unit.dimension()));
        inputs.chain(parameters).chain(definitions).chain(states).collect()
    }

    /// As [`Model::check`], with the places of a file.
    pub(super) fn check_at(&self, places: &Places) -> Result<()> {
        self.distinct_names()?;
        let scope = self.scope();
        let check = |path: String, e: &Expr, wanted: Dimension| -> Result<()> {
            let printed = e.to_string();
            let text = places.text(&path).unwrap_or(&printed);
            e.expect_dimension(wanted, &scope, text).map_err(|e| places.put(&path, e))
        };
        for d in &self.definitions {
            check(format!("definitions.{}.equals", d.name), &d.equals, d.unit.dimension())?;
        }
        for s in &self.states {
            check(format!("states.{}.rate", s.name), &s.rate, s.unit.dimension().over(Dimension::TIME))?;
        }
        for o in &self.outputs {
            check(format!("outputs.{}.equals", o.name), &o.equals, o.unit.dimension())?;
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
    pub(super) fn definition_order(&self) -> Result<Vec<&Definition>, (String, Error)> {
        let mut walk = Walk { model: self, done: Vec::new(), trail: Vec::new() };
        for d in &self.definitions {
            walk.visit(d)?;
        }
        Ok(walk.done)
    }
}

struct Walk<'a> {
    model: &'a Model,
    done: Vec<&'a Definition>,
    trail: Vec<&'a str>,
}

impl<'a> Walk<'a> {
    fn visit(&mut self, d: &'a Definition) -> Result<(), (String, Error)> {
        if self.done.iter().any(|x| x.name == d.name) {
            return Ok(());
        }
        if let Some(from) = self.trail.iter().position(|n| *n == d.name) {
            let around: Vec<&str> = self.trail[from..].iter().copied().chain([d.name.as_str()]).collect();
            let message = format!("the definitions go in a circle: {}", around.join(" -> "));
            let e = Error::bad_input(message).with_hint("make one of them a state, or break the circle");
            return Err((d.name.clone(), e));
        }
        self.trail.push(&d.name);
        let used = d.equals.names();
        for other in self.model.definitions.iter().filter(|x| used.contains(x.name.as_str())) {
            self.visit(other)?;
        }
        self.trail.pop();
        self.done.push(d);
        Ok(())
    }
}
