//! What goes wrong at the first step, said so that it can be mended.

use super::machine::Machine;
use super::mesh::Mesh;
use super::simulator::Simulator;
use super::start::start;
use crate::expression::{BinaryOp, Expr, Function};
use crate::{Error, Result};

/// Refuses a model whose rates are no numbers at the first step, and names the term.
pub(super) fn first_step(simulator: &Simulator, mesh: &Mesh, parameters: &[f64]) -> Result<()> {
    let mut m = Machine::<f64>::new(&simulator.program, mesh, parameters);
    let t = mesh.time[0];
    let (given, steady) = simulator.starts(&simulator.initials());
    let x = start(&mut m, t, &given, &steady)?;
    let mut rates = vec![0.0; x.len()];
    m.rates(t, &x, &mut rates);
    let Some(bad) = rates.iter().position(|r| !r.is_finite()) else { return Ok(()) };
    let model = simulator.model();
    let Some(state) = model.states.get(bad) else {
        return Err(Error::not_computed("a lag or a rate limit has no finite rate at the first step")
            .with_hint("its time must not be 0"));
    };
    let lookup = |name: &str| value(simulator, &m, name);
    let message = format!("states.{}.rate is no number at the first step (t = {t} s)", state.name);
    let fault = find(&state.rate, &lookup).map(|e| (&state.rate, e));
    let fault = fault.or_else(|| {
        let mut definitions = model.definitions.iter();
        definitions.find_map(|d| Some((&d.equals, find(&d.equals, &lookup)?)))
    });
    Err(shown(Error::not_computed(message), fault))
}

/// The value of a name as it is loaded.
fn value(simulator: &Simulator, m: &Machine<'_, f64>, name: &str) -> Option<f64> {
    let (model, p) = (simulator.model(), &simulator.program);
    let at = |register: u16| m.r[usize::from(register)];
    if name == "t" {
        return Some(at(p.time));
    }
    if let Some(i) = model.parameters.iter().position(|x| x.name == name) {
        return Some(at(p.parameters[i]));
    }
    if let Some(i) = model.states.iter().position(|x| x.name == name) {
        return Some(at(p.states[i]));
    }
    if let Some(i) = model.inputs.iter().position(|x| x.name == name) {
        let column = p.columns.iter().find(|c| c.input == i && c.delay.is_none())?;
        return Some(at(column.value));
    }
    let d = model.definitions.iter().find(|x| x.name == name)?;
    d.equals.value(&|inner| value(simulator, m, inner))
}

/// The innermost part that is no finite number though its own parts are.
fn find<'a>(e: &'a Expr, lookup: &dyn Fn(&str) -> Option<f64>) -> Option<&'a Expr> {
    if let Some(inner) = e.children().into_iter().find_map(|c| find(c, lookup)) {
        return Some(inner);
    }
    let own = matches!(e, Expr::Binary(..) | Expr::Call(..));
    (own && e.value(lookup).is_some_and(|v| !v.is_finite())).then_some(e)
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
