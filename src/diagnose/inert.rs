//! A model in which one of its findings does nothing.

use super::catalogue::{Proposal, edit};
use crate::expression::Expr;
use crate::model::Model;
use std::collections::HashMap;

/// How a finding is kept from acting.
pub enum Inert<'p> {
    /// Its parameters take values at which it does nothing.
    Values(HashMap<&'p str, f64>),
    /// What passes through it passes as it is: a lag divides by its time, which has no value at which it does nothing.
    Passed(&'p Proposal),
}

impl<'p> Inert<'p> {
    /// That of a finding, if there is one.
    pub fn of(p: &'p Proposal) -> Option<Self> {
        if let Some(values) = &p.neutral {
            let names = p.added.iter().map(|a| a.name.as_str());
            return Some(Self::Values(names.zip(values.iter().copied()).collect()));
        }
        (!p.replaced.is_empty()).then_some(Self::Passed(p))
    }

    /// An expression without it; `named` stands for a value.
    pub fn expression(&self, e: &Expr, named: &dyn Fn(&str) -> Option<Expr>) -> Expr {
        let Self::Passed(p) = self else { return e.substitute_each(named) };
        let is_own = |e: &Expr| p.added.iter().any(|a| e.mentions(&a.name));
        edit::rebuilt(e, &|part| match (&part, p.replaced.iter().find(|(new, _)| *new == part)) {
            (_, Some((_, old))) => old.clone(),
            (Expr::Call(_, given), None) if given.iter().skip(1).any(is_own) => given[0].clone(),
            _ => part,
        })
    }

    /// A model without it, its parameters fixed; none where they act on elsewhere.
    pub fn model(&self, with: &Model, p: &Proposal) -> Option<Model> {
        let mut model = with.clone();
        let is_own = |name: &str| p.added.iter().any(|a| a.name == name);
        for q in model.parameters.iter_mut().filter(|q| is_own(&q.name)) {
            q.fit = false;
            if let Self::Values(values) = self {
                q.value = values.get(q.name.as_str()).copied().unwrap_or(q.value);
            }
        }
        if matches!(self, Self::Values(_)) {
            return Some(model);
        }
        model.states.retain(|s| !p.states.contains(&s.name));
        let (mut changes, mut acts) = (false, false);
        edit::for_each(&mut model, |_, e| {
            let without = self.expression(e, &|_| None);
            changes |= without != *e;
            acts |= without.names().into_iter().any(|n| is_own(n) || p.states.iter().any(|s| s == n));
            *e = without;
        });
        (changes && !acts).then_some(model)
    }
}

/// What each state of a model has, from a list of those of a model that may have more.
pub fn kept<T: Copy>(model: &Model, larger: &Model, values: &[T]) -> Vec<T> {
    let has = |name: &String| model.states.iter().any(|s| s.name == *name);
    larger.states.iter().zip(values).filter(|(s, _)| has(&s.name)).map(|(_, v)| *v).collect()
}
