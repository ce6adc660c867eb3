//! A model without one of its findings.

use crate::diagnose::catalogue::{Proposal, edit};
use crate::expression::Expr;
use crate::model::Model;
use std::collections::HashMap;

/// How a finding is taken out of expressions.
pub enum Rest<'p> {
    /// Its parameters take values at which it does nothing.
    Values(HashMap<&'p str, f64>),
    /// What it replaced stands again: new and old.
    Replaced(&'p [(Expr, Expr)]),
}

impl<'p> Rest<'p> {
    /// That of a finding, if there is one.
    pub fn of(p: &'p Proposal) -> Option<Self> {
        if let Some(values) = &p.neutral {
            let names = p.added.iter().map(|a| a.name.as_str());
            return Some(Self::Values(names.zip(values.iter().copied()).collect()));
        }
        (!p.replaced.is_empty()).then_some(Self::Replaced(&p.replaced))
    }

    /// An expression without it; `named` stands for a value.
    pub fn without(&self, e: &Expr, named: &dyn Fn(&str) -> Option<Expr>) -> Expr {
        match self {
            Self::Values(_) => e.substitute_each(named),
            Self::Replaced(all) => edit::rebuilt(e, &|part| {
                let old = all.iter().find(|(new, _)| *new == part).map(|(_, old)| old.clone());
                old.unwrap_or(part)
            }),
        }
    }

    /// A model without it.
    pub fn model(&self, with: &Model) -> Model {
        let mut model = with.clone();
        if let Self::Values(values) = self {
            for q in &mut model.parameters {
                q.value = values.get(q.name.as_str()).copied().unwrap_or(q.value);
            }
        }
        edit::for_each(&mut model, |_, e| *e = self.without(e, &|_| None));
        model
    }
}
