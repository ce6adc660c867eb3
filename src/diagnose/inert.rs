//! A model in which one of its findings does nothing.

use super::catalogue::{Proposal, edit, free_law, is_mark};
use super::search::Taken;
use crate::estimate::Fit;
use crate::expression::{BinaryOp, Expr, Function};
use crate::model::{Model, Parameter};
use std::collections::{BTreeSet, HashMap};

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
        let mut changes = false;
        for state in &p.states {
            changes |= followed(&mut model, state);
        }
        model.states.retain(|s| !p.states.contains(&s.name));
        let mut acts = false;
        edit::for_each(&mut model, |_, e| {
            let without = self.expression(e, &|_| None);
            changes |= without != *e;
            acts |= without.names().into_iter().any(|n| is_own(n) || p.states.iter().any(|s| s == n));
            *e = without;
        });
        (changes && !acts).then_some(model)
    }
}

/// Puts what a state follows, s' = (X - s)/T, in its place, however X was changed since; a law of s itself has nothing left.
fn followed(model: &mut Model, state: &str) -> bool {
    let rate = model.states.iter().find(|s| s.name == state).map(|s| s.rate.clone());
    let Some(Expr::Binary(BinaryOp::Div, gap, _)) = rate else { return false };
    let Expr::Binary(BinaryOp::Sub, followed, own) = *gap else { return false };
    if *own != Expr::name(state) {
        return false;
    }
    let alone = followed.substitute(state, &Expr::Number(0.0));
    let alone = edit::rebuilt(&alone, &|part| folded(part, &[]));
    edit::for_each(model, |_, e| *e = e.substitute(state, &alone));
    let mut used = BTreeSet::new();
    edit::for_each(model, |_, e| used.extend(e.names().into_iter().map(str::to_owned)));
    model.parameters.iter_mut().filter(|q| !used.contains(&q.name)).for_each(|q| q.fit = false);
    true
}

/// A model without the terms that parameters fixed at 0 have left of what was tried and dropped, nor these parameters; those of
/// the given model, which stand first, stay.
pub fn tidied(mut model: Model, own: usize) -> Model {
    let given: BTreeSet<String> = model.parameters.iter().take(own).map(|p| p.name.clone()).collect();
    let is_idle = |p: &Parameter| !p.fit && p.value == 0.0 && !given.contains(&p.name) && !is_mark(p);
    let idle: Vec<String> = model.parameters.iter().filter(|p| is_idle(p)).map(|p| p.name.clone()).collect();
    let mut used = BTreeSet::new();
    edit::for_each(&mut model, |_, e| {
        if idle.iter().any(|name| e.mentions(name)) {
            let without = edit::rebuilt(e, &|part| folded(part, &idle));
            // where a 0 stands that is no term, as in a lag, it stays
            if !idle.iter().any(|name| without.mentions(name)) {
                *e = without;
            }
        }
        used.extend(e.names().into_iter().map(str::to_owned));
    });
    model.parameters.retain(|p| given.contains(&p.name) || p.fit || used.contains(&p.name));
    model
}

/// A fit whose model has nothing left of a finding that does nothing in it.
pub fn bare(with: &Fit, own: usize) -> Fit {
    let model = tidied(with.model.clone(), own);
    let stays = |name: &String| model.parameters.iter().any(|p| p.name == *name);
    let parameters = with.parameters.iter().filter(|p| stays(&p.name)).cloned().collect();
    Fit { model, parameters, ..with.clone() }
}

/// A sum, product or quotient with one of some names, which are 0, as a part of it; anything else as it is.
fn folded(e: Expr, idle: &[String]) -> Expr {
    let is_nothing = |e: &Expr| match e {
        Expr::Number(x) => *x == 0.0,
        Expr::Name(n) => idle.contains(n),
        _ => false,
    };
    let is_one = |e: &Expr| *e == Expr::Number(1.0);
    match e {
        Expr::Neg(a) if is_nothing(&a) => Expr::Number(0.0),
        Expr::Binary(BinaryOp::Mul, a, b) if is_nothing(&a) || is_nothing(&b) => Expr::Number(0.0),
        Expr::Binary(BinaryOp::Div, a, _) if is_nothing(&a) => Expr::Number(0.0),
        Expr::Binary(BinaryOp::Add, a, b) if is_nothing(&a) => *b,
        Expr::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) if is_nothing(&b) => *a,
        Expr::Binary(BinaryOp::Sub, a, b) if is_nothing(&a) => Expr::Neg(b),
        Expr::Binary(BinaryOp::Mul, a, b) if is_one(&a) => *b,
        Expr::Binary(BinaryOp::Mul | BinaryOp::Div, a, b) if is_one(&b) => *a,
        Expr::Call(Function::Exp, a) if is_nothing(&a[0]) => Expr::Number(1.0),
        other => other,
    }
}

/// What each state of a model has, from a list of those of a model that may have more.
pub fn kept<T: Copy>(model: &Model, larger: &Model, values: &[T]) -> Vec<T> {
    let has = |name: &String| model.states.iter().any(|s| s.name == *name);
    larger.states.iter().zip(values).filter(|(s, _)| has(&s.name)).map(|(_, v)| *v).collect()
}

/// A model with the heights of its laws known: they trade with parameters beside them, which a further fit then tells.
pub fn settled(mut model: Model, taken: &[Taken]) -> Model {
    let laws = taken.iter().filter(|t| t.proposal.code == free_law::CODE).flat_map(|t| &t.proposal.added);
    let heights: Vec<&String> = laws.map(|a| &a.name).collect();
    model.parameters.iter_mut().filter(|p| heights.contains(&&p.name)).for_each(|p| p.fit = false);
    model
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_dropped_leaves_no_terms() {
        let of = |parameters: &str, rate: &str| {
            let text = format!(
                "name = 'm'\n[inputs]\nu = {{ unit = '1/s' }}\n[parameters]\n{parameters}\n[states]\nx = {{ rate = '{rate}', unit = '1', initial = 0 }}\n[outputs]\ny = {{ equals = 'x', unit = '1' }}"
            );
            Model::parse(&text).unwrap()
        };
        let own = "b = { value = 0, unit = '1/s' }\nc = { value = 1, unit = '1/s', fit = true }";
        let more = "\nF = { value = 0, unit = '1/s' }\na = { value = 0, unit = '1' }\nT = { value = 0, unit = 's' }\nd = { value = 2, unit = '1' }";
        let tidy = tidied(of(&format!("{own}{more}"), "u - b*x - c*(1 + a*(x - d)) - F*sign(x)"), 2);
        assert_eq!(tidy.states[0].rate.to_string(), "u - b*x - c");
        assert_eq!(tidy.parameters.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), ["b", "c"]);
        let late = of(&format!("{own}{more}"), "u - c*delay(x, T) - exp(a*x)*c");
        let tidy = tidied(late.clone(), 2);
        assert_eq!(tidy.states[0].rate, late.states[0].rate);
    }
}
