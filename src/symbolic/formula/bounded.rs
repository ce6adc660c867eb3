//! The value of an expression with a bound of its rounding error.
//!
//! Purpose: to tell a true difference of two formulas from what is lost where numbers cancel.
//! Method: each operation is repeated with every operand moved by its own bound.
//! References: N. Higham, Accuracy and Stability of Numerical Algorithms (2002), section 3.3 (running error analysis).
//! Numerical aspects: to first order; symbols count as rounded.

use super::calculus::value;
use super::sampler::Values;
use crate::Result;
use crate::expression::Expr;

/// A value and how far it can be off.
#[derive(Clone, Copy, Debug)]
pub struct Bounded {
    pub value: f64,
    pub bound: f64,
}

/// Names for the operands of one operation.
const OPERANDS: [&str; 4] = ["operand1", "operand2", "operand3", "operand4"];

/// The value of an expression at given values of its symbols.
///
/// # Errors
/// Bad input, where a symbol has no value.
pub fn bounded(expression: &Expr, values: &Values) -> Result<Bounded> {
    let parts = expression.children();
    if parts.is_empty() || parts.len() > OPERANDS.len() {
        let value = value(expression, &|name| values.get(name).copied())?;
        return Ok(Bounded { value, bound: f64::EPSILON * value.abs() });
    }
    let parts = parts.into_iter().map(|part| bounded(part, values)).collect::<Result<Vec<_>>>()?;
    let mut place = 0;
    let operation = expression.map_children(&mut |_| {
        place += 1;
        Expr::Name(OPERANDS[place - 1].into())
    });
    let with = |moved: usize, by: f64| {
        let operand = |name: &str| {
            let k = OPERANDS.iter().position(|operand| *operand == name)?;
            Some(parts[k].value + if k == moved { by * parts[k].bound } else { 0.0 })
        };
        value(&operation, &operand)
    };
    let own = with(0, 0.0)?;
    let mut bound = f64::EPSILON * own.abs();
    for k in 0..parts.len() {
        // |f(x + δ) − f(x)|, |f(x − δ) − f(x)|
        bound += (with(k, 1.0)? - own).abs().max((with(k, -1.0)? - own).abs());
    }
    Ok(Bounded { value: own, bound })
}
