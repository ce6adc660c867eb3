//! What goes wrong at the first step, said so that it can be mended.

use super::machine::Machine;
use super::mesh::Mesh;
use super::simulator::Simulator;
use super::start::start;
use crate::expression::{BinaryOp, Expr, Function};
use crate::{Error, Result};
use std::collections::HashMap;

impl Simulator {
    /// Refuses a model whose rates are no numbers at the first step, and names the term.
    pub(super) fn check_first_step(&self, mesh: &Mesh, parameters: &[f64]) -> Result<()> {
        let mut m = Machine::<f64>::new(&self.program, mesh, parameters);
        let t = mesh.time[0];
        let (given, steady) = self.starts(&self.initials());
        let x = start(&mut m, t, &given, &steady)?;
        let mut rates = vec![0.0; x.len()];
        m.rates(t, &x, &mut rates);
        let Some(bad) = rates.iter().position(|r| !r.is_finite()) else { return Ok(()) };
        let model = self.model();
        let Some(state) = model.states.get(bad) else {
            return Err(Error::not_computed("a lag or a rate limit has no finite rate at the first step")
                .with_hint("its time must not be 0"));
        };
        let values = values(self, &m);
        let lookup = |name: &str| values.get(name).copied();
        let message = format!("states.{}.rate is no number at the first step (t = {t} s)", state.name);
        let fault = find(&state.rate, &lookup).map(|e| (&state.rate, e));
        let fault = fault.or_else(|| {
            let mut definitions = model.definition_order().unwrap_or_default().into_iter();
            definitions.find_map(|d| Some((&d.equals, find(&d.equals, &lookup)?)))
        });
        Err(shown(Error::not_computed(message), fault))
    }
}

/// The values of all names as they are loaded; there is none of a definition that remembers.
fn values<'a>(simulator: &'a Simulator, m: &Machine<'_, f64>) -> HashMap<&'a str, f64> {
    let (model, p) = (simulator.model(), &simulator.program);
    let at = |register: &u16| m.r[usize::from(*register)];
    let mut values = HashMap::from([("t", at(&p.time))]);
    values.extend(model.parameters.iter().zip(&p.parameters).map(|(x, r)| (x.name.as_str(), at(r))));
    values.extend(model.states.iter().zip(&p.states).map(|(x, r)| (x.name.as_str(), at(r))));
    let columns = p.columns.iter().filter(|c| c.delay.is_none());
    values.extend(columns.map(|c| (model.inputs[c.input].name.as_str(), at(&c.value))));
    for d in model.definition_order().unwrap_or_default() {
        let value = d.equals.value(&|name| values.get(name).copied());
        values.extend(value.map(|v| (d.name.as_str(), v)));
    }
    values
}

/// The innermost part that is no finite number though its own parts are.
fn find<'a>(e: &'a Expr, lookup: &dyn Fn(&str) -> Option<f64>) -> Option<&'a Expr> {
    if let Some(inner) = e.children().into_iter().find_map(|c| find(c, lookup)) {
        return Some(inner);
    }
    let own = matches!(e, Expr::Binary(..) | Expr::Call(..));
    let is_bad = |e: &Expr| e.value(lookup).is_some_and(|v| !v.is_finite());
    (own && is_bad(e) && !e.children().into_iter().any(is_bad)).then_some(e)
}

fn shown(e: Error, fault: Option<(&Expr, &Expr)>) -> Error {
    let Some((whole, part)) = fault else {
        return e.with_hint("look for a division by zero, or the logarithm or root of a negative number");
    };
    let (text, term) = (whole.to_string(), part.to_string());
    let at = text.find(&term).map_or(0, |byte| text[..byte].chars().count());
    let hint = match part {
        Expr::Binary(BinaryOp::Div, _, below) => {
            format!("this divides by {below}, which is 0 there; start it elsewhere or keep it away from 0")
        }
        Expr::Call(Function::Ln | Function::Sqrt, inside) => {
            format!("{} is not positive there", inside.first().map(ToString::to_string).unwrap_or_default())
        }
        _ => "start the states elsewhere".to_string(),
    };
    e.with_excerpt(text, at, term.chars().count()).with_hint(hint)
}
