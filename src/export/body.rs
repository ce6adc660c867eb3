//! The lines of a function: what it unpacks, its local values in their order.

use super::lowered::{Local, Lowered, Value};
use super::spell::Words;
use crate::expression::Expr;
use std::collections::BTreeSet;

/// How a language spells lines.
pub(super) trait Lines: Words {
    /// A new name for a value.
    fn bind(&self, name: &str, value: &str) -> String;

    /// A statement.
    fn line(&self, statement: &str) -> String;

    /// A statement for the start of a run alone.
    fn at_start(&self, statement: &str) -> String;

    /// How something in the record of memories is reached: `m.` or `m->`.
    fn kept(&self) -> &'static str;

    /// The name of a function of the runner.
    fn helper(&self, name: &str) -> String;

    /// How a parameter is reached: its name in the model, and in the language.
    fn parameter(&self, name: &str, own: &str) -> String;

    /// A local value as a step sees it.
    fn seen(&self, own: &Lowered<'_>, local: &Local) -> String {
        let (kept, with) = (self.kept(), |f: &str| self.helper(f));
        match &local.value {
            Value::Is(e) => self.spell(e),
            Value::Lag(k, ..) => format!("x[{}]", own.model.states.len() + k),
            Value::Play(k, x, gap) => {
                format!("{}({kept}play[{k}], {}, {})", with("play"), self.spell(x), self.spell(gap))
            }
            Value::Relay(k, x, gap) => {
                format!("{}({kept}relay[{k}], {}, {})", with("relay"), self.spell(x), self.spell(gap))
            }
            Value::Limit(k, x, rate) => {
                let most = self.within(rate, super::spell::Binding::Power);
                format!("{}({kept}limit[{k}], {}, {most}*(t - {kept}since))", with("limit"), self.spell(x))
            }
            Value::Past(k, x, ago) => {
                format!("{}(m, {k}, t, {}, {})", with("past"), self.spell(ago), self.spell(x))
            }
            Value::Sign(k, ..) => format!("{kept}sign[{k}]"),
        }
    }

    /// The lines in which a local value gets its memory at the end of a step.
    fn kept_lines(&self, own: &Lowered<'_>, local: &Local) -> Vec<String> {
        let kept = self.kept();
        let start = |place: &str, x: &str| self.at_start(&format!("{place} = {x}"));
        let bound = self.bind(&local.name, &self.seen(own, local));
        let (place, before) = match &local.value {
            Value::Is(_) => return vec![bound],
            Value::Lag(k, x, _) => {
                return vec![start(&format!("x[{}]", own.model.states.len() + k), &self.spell(x)), bound];
            }
            Value::Past(k, x, _) => {
                let push = format!("{}(m, {k}, {})", self.helper("keep"), self.spell(x));
                return vec![bound, self.line(&push)];
            }
            Value::Sign(k, x, at_zero) => {
                let settle = format!(
                    "{}(m, {k}, {}, {})",
                    self.helper("settle"),
                    self.spell(x),
                    self.number(*at_zero)
                );
                return vec![self.line(&settle), bound];
            }
            Value::Play(k, x, _) => (format!("{kept}play[{k}]"), self.spell(x)),
            Value::Relay(k, ..) => (format!("{kept}relay[{k}]"), self.number(0.0)),
            Value::Limit(k, x, _) => (format!("{kept}limit[{k}]"), self.spell(x)),
        };
        vec![start(&place, &before), bound, self.line(&format!("{place} = {}", local.name))]
    }

    /// The lines that bring about the names in some expressions.
    fn before(&self, own: &Lowered<'_>, wanted: &[&Expr]) -> Vec<String> {
        let names = needed(own, wanted);
        let mut lines = self.unpacked(own, &names);
        let locals = own.locals.iter().filter(|l| names.contains(&l.name));
        lines.extend(locals.map(|l| self.bind(&l.name, &self.seen(own, l))));
        lines
    }

    /// The lines of the end of a step.
    fn updated(&self, own: &Lowered<'_>) -> Vec<String> {
        let kept = |l: &&Local| !matches!(l.value, Value::Is(_));
        let wanted: Vec<&Expr> = own.locals.iter().filter(kept).flat_map(|l| l.value.remembered()).collect();
        let names = needed(own, &wanted);
        let mut lines = self.unpacked(own, &names);
        for local in own.locals.iter().filter(|l| kept(l) || names.contains(&l.name)) {
            let mut own_lines = self.kept_lines(own, local);
            if kept(&local) && !names.contains(&local.name) && !needs_name(&local.value) {
                own_lines.retain(|l| *l != self.bind(&local.name, &self.seen(own, local)));
            }
            lines.extend(own_lines);
        }
        lines
    }

    /// The lines that give parameters, states and inputs their names.
    fn unpacked(&self, own: &Lowered<'_>, names: &BTreeSet<String>) -> Vec<String> {
        let mut lines = Vec::new();
        for p in &own.model.parameters {
            let name = own.names.of(&p.name);
            if names.contains(name) {
                lines.push(self.bind(name, &self.parameter(&p.name, name)));
            }
        }
        for (i, s) in own.model.states.iter().enumerate() {
            let name = own.names.of(&s.name);
            if names.contains(name) {
                lines.push(self.bind(name, &format!("x[{i}]")));
            }
        }
        for (i, name) in columns(own).iter().enumerate().filter(|c| names.contains(*c.1)) {
            lines.push(self.bind(name, &format!("u[{i}]")));
        }
        lines
    }
}

/// Whether the lines of the end of a step use the name itself.
fn needs_name(value: &Value) -> bool {
    matches!(value, Value::Play(..) | Value::Relay(..) | Value::Limit(..))
}

/// The names of all columns: the inputs, then the delayed ones.
pub(super) fn columns<'a>(own: &'a Lowered<'_>) -> Vec<&'a str> {
    let inputs = own.model.inputs.iter().map(|i| own.names.of(&i.name));
    inputs.chain(own.columns.iter().map(|c| c.name.as_str())).collect()
}

/// The arguments of the signs, in their order.
pub(super) fn guards<'a>(own: &'a Lowered<'_>) -> Vec<&'a Expr> {
    own.locals
        .iter()
        .filter_map(|l| match &l.value {
            Value::Sign(_, x, _) => Some(x),
            _ => None,
        })
        .collect()
}

/// Every name that some expressions need, through local values. The hidden state of a lag needs nothing.
fn needed(own: &Lowered<'_>, wanted: &[&Expr]) -> BTreeSet<String> {
    let mut names: BTreeSet<String> = wanted.iter().flat_map(|e| e.names()).map(str::to_string).collect();
    for local in own.locals.iter().rev().filter(|l| !matches!(l.value, Value::Lag(..) | Value::Sign(..))) {
        if names.contains(&local.name) {
            names.extend(local.value.parts().into_iter().flat_map(Expr::names).map(str::to_string));
        }
    }
    names
}
